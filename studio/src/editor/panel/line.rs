//! The line in which commands are typed, and what is told.

use crate::dialogue::complete;
use crate::document::Listing;
use crate::editor::Editor;
use crate::editor::talk::Journal;
use eframe::egui;

#[derive(Debug, Default)]
pub(in crate::editor) struct Line {
    text: String,
    /// The number of lines from the present one back to the one that is shown.
    back: usize,
    shows_journal: bool,
}

impl Line {
    /// The line, what is told, and everything that was said so far, if that is wanted.
    pub(in crate::editor) fn show(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let proposed = editor.talk.proposed.take();
        let is_proposed = proposed.is_some();
        if let Some(proposed) = proposed {
            self.text = proposed;
        }
        if self.shows_journal {
            egui::ScrollArea::vertical()
                .max_height(180.0)
                .stick_to_bottom(true)
                .auto_shrink([false, true])
                .show(ui, |ui| ui.monospace(&editor.talk.journal.text));
        }
        ui.horizontal(|ui| {
            ui.toggle_value(&mut self.shows_journal, "Journal")
                .on_hover_text("shows what was said so far");
            let label = ui.label("Line");
            let edit = egui::TextEdit::singleline(&mut self.text)
                .hint_text("motor a, undo, help")
                .desired_width(220.0)
                .lock_focus(true)
                .font(egui::TextStyle::Monospace);
            let response = ui.add(edit).labelled_by(label.id);
            if is_proposed {
                response.request_focus();
            }
            let has_key = |key| response.has_focus() && ui.input(|input| input.key_pressed(key));
            if has_key(egui::Key::ArrowUp) {
                self.recall(&editor.talk.journal, self.back + 1);
            } else if has_key(egui::Key::ArrowDown) {
                self.recall(&editor.talk.journal, self.back.saturating_sub(1));
            } else if has_key(egui::Key::Tab) {
                self.complete(&editor.analysis.snapshot.listing);
            }
            if response.lost_focus() && ui.input(|input| input.key_pressed(egui::Key::Enter)) {
                let line = std::mem::take(&mut self.text);
                self.back = 0;
                if !line.trim().is_empty() {
                    editor.say(&line);
                }
                response.request_focus();
            }
            told(editor, ui);
        });
    }

    fn recall(&mut self, journal: &Journal, back: usize) {
        let lines = &journal.lines;
        self.back = back.min(lines.len());
        self.text = match self.back {
            0 => String::new(),
            back => lines[lines.len() - back].clone(),
        };
    }

    /// Completes the last word as far as all that fits agrees.
    fn complete(&mut self, listing: &Listing) {
        let (start, words) = complete(&self.text, listing);
        let Some(first) = words.first() else {
            return;
        };
        let shared = words.iter().fold(first.as_str(), |shared, word| {
            let same = shared.char_indices().zip(word.chars());
            let end = same.into_iter().find(|((_, a), b)| a != b);
            match end {
                Some(((at, _), _)) => &shared[..at],
                None if word.len() < shared.len() => &shared[..word.len()],
                None => shared,
            }
        });
        self.text.truncate(start);
        self.text.push_str(shared);
        if words.len() == 1 {
            self.text.push(' ');
        }
    }
}

/// Shows the notice, the next thing to pick, or the status of the player.
fn told(editor: &Editor, ui: &mut egui::Ui) {
    if let Some(notice) = &editor.talk.notice {
        let first = notice.text.lines().next().unwrap_or_default();
        let text = if notice.is_refusal {
            egui::RichText::new(first).color(ui.visuals().error_fg_color)
        } else {
            egui::RichText::new(first)
        };
        ui.add(egui::Label::new(text).truncate());
    } else if let Some(wanted) = editor.picking.wanted() {
        ui.add(
            egui::Label::new(format!("{}: pick {wanted}", editor.picking.tool.name())).truncate(),
        );
    } else if let Some(player) = editor.player() {
        ui.add(egui::Label::new(player.status()).truncate());
    }
}
