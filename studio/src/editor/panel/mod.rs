//! The panels beside the drawing.

mod busy;
mod diagnoses;
mod field;
mod line;
mod play;
mod plots;
mod properties;
mod report;
mod shapes;
mod text;

pub(super) use busy::Busy;
pub(super) use line::Line;
pub(super) use play::play;

use super::action::{help, key_of_tool};
use super::settings::Panel;
use super::{Editor, Tool};
use diagnoses::diagnoses;
use eframe::egui;
use plots::Plots;
use properties::properties;
use report::report;
use text::TextPanel;

/// All panels beside the drawing, one of which is seen.
#[derive(Default)]
pub(super) struct Panels {
    text: TextPanel,
    plots: Plots,
}

impl Panels {
    pub(super) fn show(&mut self, editor: &mut Editor, is_narrow: bool, ui: &mut egui::Ui) {
        tabs(editor, is_narrow, ui);
        ui.separator();
        match editor.settings.panel {
            Some(Panel::Text) => self.text.show(editor, ui),
            Some(Panel::Properties) => properties(editor, ui),
            Some(Panel::Diagnoses) => diagnoses(editor, ui),
            Some(Panel::Plots) => self.plots.show(editor, ui),
            Some(Panel::Report) => report(&editor.analysis, ui),
            Some(Panel::Steps) => steps(editor, ui),
            Some(Panel::Help) => help(ui),
            None => {}
        }
    }
}

/// The names of all panels, to choose one.
fn tabs(editor: &mut Editor, is_narrow: bool, ui: &mut egui::Ui) {
    let analysis = &editor.analysis;
    let count = analysis.snapshot.messages().len() + analysis.unmet().count();
    ui.horizontal_wrapped(|ui| {
        for panel in Panel::ALL {
            let name = match panel {
                Panel::Diagnoses if count > 0 => format!("{} ({count})", panel.name()),
                _ => panel.name().to_owned(),
            };
            let is_chosen = editor.settings.panel == Some(panel);
            if ui.selectable_label(is_chosen, name).clicked() {
                // Where there is little room, the one that is seen is closed.
                editor.settings.panel = (!is_chosen || !is_narrow).then_some(panel);
            }
        }
    });
}

/// The palette of tools: a column, or a row.
pub(in crate::editor) fn tools(editor: &mut Editor, ui: &mut egui::Ui, is_row: bool) {
    if is_row {
        egui::ScrollArea::horizontal().show(ui, |ui| {
            ui.horizontal(|ui| buttons(editor, ui));
        });
    } else {
        egui::ScrollArea::vertical().show(ui, |ui| {
            ui.vertical_centered_justified(|ui| buttons(editor, ui));
        });
    }
}

fn buttons(editor: &mut Editor, ui: &mut egui::Ui) {
    for tool in Tool::all() {
        let key = ui.ctx().format_shortcut(&key_of_tool(tool));
        let response = ui.selectable_label(editor.picking.tool == tool, tool.name());
        let response = response.on_hover_text(format!("{} ({key})", tool.help()));
        if response.clicked() {
            editor.choose(tool);
        }
    }
}

/// The steps from the first to the last.
pub(in crate::editor) fn steps(editor: &mut Editor, ui: &mut egui::Ui) {
    let titles: Vec<String> =
        editor.workspace().history().made().iter().map(|step| step.title.clone()).collect();
    if titles.is_empty() {
        ui.weak("Nothing was changed yet.");
    }
    let count = titles.len();
    let mut back = 0;
    egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for (number, title) in titles.iter().enumerate() {
            let response =
                ui.selectable_label(number + 1 == count, format!("{}. {title}", number + 1));
            if response.on_hover_text("goes back to this step").clicked() {
                back = count - 1 - number;
            }
        }
    });
    if back > 0 {
        editor.sight.playing.settle();
    }
    for _ in 0..back {
        editor.undo();
    }
}
