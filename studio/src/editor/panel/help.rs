//! What can be done.

use crate::editor::action;
use eframe::egui;

/// How to begin, all actions and tools with their keys, and all lines of the dialogue.
pub(in crate::editor) fn help(ui: &mut egui::Ui) {
    egui::ScrollArea::vertical()
        .auto_shrink(false)
        .show(ui, |ui| {
            ui.heading("First mechanism");
            for line in BEGINNING {
                ui.label(*line);
            }
            ui.separator();
            action::help(ui);
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
