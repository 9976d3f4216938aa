//! All tools and actions, with their keys.

use super::key_of_tool;
use super::table::ACTIONS;
use crate::editor::Tool;
use eframe::egui::{self, KeyboardShortcut};

/// Shows the help: first steps, all tools and actions with their keys, and all lines of the dialogue.
pub(in crate::editor) fn help(ui: &mut egui::Ui) {
    egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        ui.heading("First mechanism");
        for line in BEGINNING {
            ui.label(*line);
        }
        ui.separator();
        ui.heading("What it is for");
        for line in PURPOSE {
            ui.label(*line);
        }
        ui.separator();
        let tools = Tool::all().map(|tool| (tool.name(), Some(key_of_tool(tool)), tool.help()));
        rows("Tools", tools, ui);
        let actions = ACTIONS.iter().map(|one| (one.name, one.key, one.help));
        rows("Actions", actions, ui);
        ui.separator();
        ui.heading("Lines");
        ui.label("The line at the foot of the window takes all of these. Tab completes.");
        if let Ok(lines) = crate::dialogue::help(None) {
            ui.monospace(lines);
        }
    });
}

const BEGINNING: &[&str] = &[
    "1. Choose Bar and draw three bars, each from the end of the one before it.",
    "2. Choose Ground and click the first and the last end.",
    "3. Choose Motor and click the first pin.",
    "4. Press Space: it moves.",
    "If it does not, Diagnoses says why. Each repair there is a button.",
];

const PURPOSE: &[&str] = &[
    "Write in Text what is expected: `expect transmission > 40 deg;` is proved for every value of the motors.",
    "Where it fails, Diagnoses says so, and the arc of the motor is red. A click on either moves the motor there.",
    "With `follow pen.tip by a, b;` the motors follow a point. Hold Ctrl and drag it.",
    "View shows what a lecture constructs: instant centres, polygons, free bodies, and centrodes of selected links.",
];

/// Shows a table of tools or actions, with their keys.
fn rows(
    title: &str,
    rows: impl Iterator<Item = (&'static str, Option<KeyboardShortcut>, &'static str)>,
    ui: &mut egui::Ui,
) {
    ui.heading(title);
    let grid = egui::Grid::new(title.to_lowercase()).num_columns(3);
    grid.striped(true).show(ui, |ui| {
        for (name, key, help) in rows {
            let key = key.map(|key| ui.ctx().format_shortcut(&key));
            ui.strong(name);
            ui.monospace(key.unwrap_or_default());
            ui.label(help);
            ui.end_row();
        }
    });
}
