//! Graphs of what moves.

use crate::editor::Editor;
use eframe::egui;

/// Graphs of what moves.
#[derive(Debug, Default)]
pub(in crate::editor) struct Plots {
    /// What is plotted, as `mech plot` names it, separated by spaces.
    wanted: String,
}

impl Plots {
    /// Shows the graphs, with a line at the present value of the motor.
    pub(in crate::editor) fn show(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let label = ui.label("Quantities");
        ui.text_edit_singleline(&mut self.wanted)
            .labelled_by(label.id);
        let _ = editor;
    }
}
