//! The panel of diagnoses: the compiler's messages, and the repairs.

use crate::edit::Command;
use crate::editor::Editor;
use crate::mend::Remainder;
use eframe::egui;

/// Shows the messages, and the repairs as buttons.
pub(in crate::editor) fn diagnoses(editor: &mut Editor, ui: &mut egui::Ui) {
    let snapshot = editor.analysis.snapshot.clone();
    let (messages, source) = (snapshot.messages(), snapshot.document.source());
    let mut chosen = None;
    let mut hovered = None;
    egui::ScrollArea::vertical()
        .auto_shrink(false)
        .show(ui, |ui| {
            if messages.is_empty() {
                ui.label(snapshot.verdict());
                return;
            }
            for message in messages {
                let mut lines = message.text.lines();
                let first = lines.next().unwrap_or_default();
                let spot = source.spot(message.place.start);
                ui.horizontal_wrapped(|ui| {
                    ui.colored_label(ui.visuals().error_fg_color, first);
                    ui.weak(format!("line {}", spot.line));
                });
                for line in lines.filter(|line| !line.trim().is_empty()) {
                    ui.label(line.trim());
                }
                ui.separator();
            }
            if editor.analysis.is_mending() {
                ui.weak("Looking for repairs");
            }
            for (number, mending) in (1..).zip(editor.mendings()) {
                let note = match mending.remainder {
                    Remainder::Nothing => "",
                    Remainder::OtherStart => " (needs another start)",
                    Remainder::OtherFaults => " (other things stay wrong)",
                };
                let button =
                    egui::Button::new(format!("Repair {number}: {}{note}", mending.words)).wrap();
                let response = ui.add(button);
                if response.hovered() || response.has_focus() {
                    hovered = Some(number);
                }
                if response.clicked() {
                    chosen = Some(number);
                }
            }
        });
    if let Some(task) = editor.analysis.preview_mending(hovered) {
        editor.give(task);
    }
    if let Some(number) = chosen {
        mend(editor, number);
    }
}

/// Makes a repair, by its number from 1.
fn mend(editor: &mut Editor, number: usize) {
    if editor.analysis.is_present(editor.workspace()) {
        editor.perform(Command::Repair { number });
    } else {
        let why = "the text has changed since this repair was offered";
        editor.talk.refuse(why);
    }
}
