//! What the compiler tells of the mechanism.

use crate::editor::Editor;
use eframe::egui;

/// The report: how each loop is solved, what is proved, what it costs.
pub(in crate::editor) fn report(editor: &Editor, ui: &mut egui::Ui) {
    egui::ScrollArea::both()
        .auto_shrink(false)
        .show(ui, |ui| match editor.snapshot.compiled() {
            Some(compiled) => {
                ui.monospace(&compiled.report);
            }
            None => {
                ui.weak("The mechanism does not move yet; see Diagnoses.");
            }
        });
}
