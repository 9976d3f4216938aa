//! All tools and actions, with their keys.

use super::key_of_tool;
use super::table::ACTIONS;
use crate::editor::Tool;
use eframe::egui;

/// Shows them.
pub(in crate::editor) fn help(ui: &mut egui::Ui) {
    ui.heading("Tools");
    egui::Grid::new("tools")
        .num_columns(3)
        .striped(true)
        .show(ui, |ui| {
            for tool in Tool::all() {
                ui.strong(tool.name());
                ui.monospace(ui.ctx().format_shortcut(&key_of_tool(tool)));
                ui.label(tool.help());
                ui.end_row();
            }
        });
    ui.heading("Actions");
    egui::Grid::new("actions")
        .num_columns(3)
        .striped(true)
        .show(ui, |ui| {
            for action in ACTIONS {
                ui.strong(action.name);
                ui.monospace(
                    action
                        .key
                        .map(|key| ui.ctx().format_shortcut(&key))
                        .unwrap_or_default(),
                );
                ui.label(action.help);
                ui.end_row();
            }
        });
}
