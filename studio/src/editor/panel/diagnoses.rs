//! The panel of diagnoses: the compiler's messages, and the repairs.

use crate::document::Message;
use crate::edit::Command;
use crate::editor::Editor;
use crate::editor::snapshot::Snapshot;
use crate::mend::Remainder;
use eframe::egui;
use std::ops::Range;

/// Shows the messages, and the repairs as buttons.
pub(in crate::editor) fn diagnoses(editor: &mut Editor, ui: &mut egui::Ui) {
    let snapshot = editor.analysis.snapshot.clone();
    let messages = snapshot.messages();
    let mut chosen = None;
    let mut shown = None;
    let mut hovered = None;
    egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        if messages.is_empty() {
            ui.label(snapshot.verdict());
            shown = unmet(editor, ui);
        }
        for Message { place, text } in messages {
            fault(text, line_of(&snapshot, place), ui);
            ui.separator();
        }
        if editor.analysis.is_mending() && !messages.is_empty() {
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
    if let Some(place) = shown {
        editor.sight.scrub_to(&place);
    }
}

/// What is wrong, and on which line.
fn fault(text: &str, line: usize, ui: &mut egui::Ui) {
    let mut lines = text.lines();
    let first = lines.next().unwrap_or_default();
    ui.horizontal_wrapped(|ui| {
        ui.colored_label(ui.visuals().error_fg_color, first);
        ui.weak(format!("line {line}"));
    });
    for line in lines.filter(|line| !line.trim().is_empty()) {
        ui.label(line.trim());
    }
}

fn line_of(snapshot: &Snapshot, place: &Range<usize>) -> usize {
    snapshot.document.source().spot(place.start).line
}

/// What is expected and was not proved. Gives a place where it does not hold that the user wants to see.
fn unmet(editor: &Editor, ui: &mut egui::Ui) -> Option<Vec<(usize, f64)>> {
    let mut wanted = None;
    for (judged, place) in editor.analysis.unmet() {
        fault(&judged.text, line_of(&editor.analysis.snapshot, &place), ui);
        for place in &judged.places {
            let text = format!("Show {}", editor.sight.playing.words_of(place));
            let button = ui.button(text).on_hover_text("moves the motors there");
            if button.clicked() {
                wanted = Some(place.clone());
            }
        }
        ui.separator();
    }
    wanted
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
