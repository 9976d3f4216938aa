//! The palette of tools.

use crate::editor::action::key_of_tool;
use crate::editor::{Editor, Tool};
use eframe::egui;

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
