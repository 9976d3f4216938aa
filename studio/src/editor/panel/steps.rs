//! The steps that were made, to undo or redo.

use crate::editor::Editor;
use eframe::egui;

/// The steps from the first to the last.
pub(in crate::editor) fn steps(editor: &mut Editor, ui: &mut egui::Ui) {
    let titles: Vec<String> = editor
        .workspace()
        .history()
        .made()
        .iter()
        .map(|step| step.title.clone())
        .collect();
    if titles.is_empty() {
        ui.weak("Nothing was changed yet.");
    }
    let count = titles.len();
    let mut back = 0;
    egui::ScrollArea::vertical()
        .auto_shrink(false)
        .show(ui, |ui| {
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
