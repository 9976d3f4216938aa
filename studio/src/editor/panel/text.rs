//! The text, beside the drawing, both ways: what is under the mouse lights up in both.

use crate::document::Listing;
use crate::editor::drag::Drag;
use crate::editor::drawing::Drawing;
use crate::editor::selection::Selection;
use crate::editor::{Editor, Item};
use crate::text::keyword::is_keyword;
use crate::text::{Kind, Lexer, masked, written};
use eframe::egui;
use eframe::egui::text::{LayoutJob, TextFormat};
use mech_compiler::syntax::ListedNumber;
use std::ops::Range;

/// Ranges of the text that are marked.
#[derive(Clone, Debug, Default, PartialEq)]
struct Marks {
    wrong: Vec<Range<usize>>,
    selected: Vec<Range<usize>>,
    /// The places of the item under the mouse.
    hovered: Vec<Range<usize>>,
}

/// The text, to be read and typed in.
#[derive(Default)]
pub(in crate::editor) struct TextPanel {
    /// The text as it was coloured last.
    colored: Option<Colored>,
    /// The text as it was seen or typed last.
    seen: String,
}

struct Colored {
    marks: Marks,
    is_dark: bool,
    job: LayoutJob,
}

impl TextPanel {
    /// Shows the text, and takes what is typed.
    pub(in crate::editor) fn show(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let marks = marks(editor);
        let text = editor.workspace().text();
        // While something is dragged, with the numbers as they are there.
        let shown = match editor.sight.drag.stay() {
            Some(stay) => written(text, &stay.edits),
            None => text.to_owned(),
        };
        let mut typed = shown.clone();
        let field = egui::Id::unique("text of the mechanism");
        if shown != self.seen {
            forget_typing(field, ui.ctx());
        }
        let is_dragged = editor.sight.drag.held().is_some();
        let mut layouter = |ui: &egui::Ui, buffer: &dyn egui::TextBuffer, _: f32| {
            let job = self.color(buffer.as_str(), &marks, ui.visuals());
            ui.fonts_mut(|fonts| fonts.layout_job(job))
        };
        let mut under = None;
        egui::ScrollArea::both().auto_shrink(false).show(ui, |ui| {
            let label = ui.label(masked(&editor.workspace().path().to_string_lossy()));
            let output = egui::TextEdit::multiline(&mut typed)
                .id(field)
                .code_editor()
                .desired_width(f32::INFINITY)
                .desired_rows(24)
                .interactive(!is_dragged)
                .layouter(&mut layouter)
                .show(ui);
            let response = &output.response.response;
            let response = response.clone().labelled_by(label.id);
            response.widget_info(|| {
                let mut info = egui::WidgetInfo::labeled(
                    egui::Role::MultilineTextInput,
                    true,
                    "text of the mechanism",
                );
                info.current_text_value = Some(shown.clone());
                info
            });
            if let Some(pointer) = response.hover_pos() {
                let cursor = output.galley.cursor_from_pos(pointer - output.galley_pos);
                under = Some(byte_of(&typed, cursor.index.0));
            } else if let Some(range) = output.cursor_range.filter(|_| response.has_focus()) {
                under = Some(byte_of(&typed, range.primary.index.0));
            }
        });
        if typed != shown {
            editor.type_text(&typed);
        }
        self.seen = typed;
        let listing = &editor.analysis.snapshot.listing;
        let item = |byte| item_at(byte, listing, editor.sight.drawing()?);
        editor.selection.under_text = under.and_then(item);
    }

    /// The text in colours: as it was before, if it is the same.
    fn color(&mut self, text: &str, marks: &Marks, visuals: &egui::Visuals) -> LayoutJob {
        let is_dark = visuals.dark_mode;
        let known = self.colored.take();
        let known = known.filter(|known| {
            known.job.text == text && known.marks == *marks && known.is_dark == is_dark
        });
        let known = known.unwrap_or_else(|| Colored {
            marks: marks.clone(),
            is_dark,
            job: colored(text, marks, visuals),
        });
        self.colored.insert(known).job.clone()
    }
}

/// Forgets what was typed before the text became another one otherwise: undoing it would bring back all of the earlier text.
fn forget_typing(field: egui::Id, context: &egui::Context) {
    if let Some(mut state) = egui::TextEdit::load_state(context, field) {
        state.clear_undoer();
        state.store(context, field);
    }
}

/// Where a character begins, in bytes.
fn byte_of(text: &str, index: usize) -> usize {
    text.char_indices().nth(index).map_or(text.len(), |(byte, _)| byte)
}

const LONGEST_COLORED: usize = 1 << 17;
/// The width of the longest row, in pixels.
const LONGEST_ROW: f32 = 4096.0;

/// The text in colours, if it is not too long for them.
fn colored(text: &str, marks: &Marks, visuals: &egui::Visuals) -> LayoutJob {
    let dark = visuals.dark_mode;
    let pick = |by_day: [u8; 3], by_night: [u8; 3]| {
        let [red, green, blue] = if dark { by_night } else { by_day };
        egui::Color32::from_rgb(red, green, blue)
    };
    let mut job = LayoutJob::default();
    // Lines stay as they are written, but for those that nobody writes: a row that is not seen is not painted.
    job.wrap.max_width = LONGEST_ROW;
    let mut at = 0;
    let mut add = |range: Range<usize>, color: egui::Color32| {
        for piece in pieces(text, range, marks) {
            let within = |all: &[Range<usize>]| {
                all.iter().any(|one| one.start <= piece.start && piece.end <= one.end)
            };
            let mut format = TextFormat {
                font_id: egui::FontId::monospace(13.0),
                color,
                ..TextFormat::default()
            };
            if within(&marks.hovered) {
                format.background = pick([255, 225, 130], [110, 85, 10]);
            } else if within(&marks.selected) {
                format.background = pick([205, 228, 250], [30, 66, 100]);
            }
            if within(&marks.wrong) {
                format.underline = egui::Stroke::new(2.0, visuals.error_fg_color);
            }
            match job.sections.last_mut() {
                // Fewer sections are laid out sooner.
                Some(last) if last.format == format => {
                    job.text.push_str(&text[piece]);
                    last.byte_range.end = job.text.len().into();
                }
                _ => job.append(&text[piece], 0.0, format),
            }
        }
    };
    let plain = visuals.text_color();
    if text.len() > LONGEST_COLORED {
        add(0..text.len(), plain);
        return job;
    }
    let mut last = plain;
    for lexeme in Lexer::new(text, 0) {
        let range = lexeme.start..lexeme.end;
        if range.start > at {
            // Comments; spaces have no colour, and take that of what is before them.
            let is_space = text[at..range.start].trim().is_empty();
            add(at..range.start, if is_space { last } else { visuals.weak_text_color() });
        }
        let color = match lexeme.kind {
            Kind::Word if text[range.clone()].starts_with(|first: char| first.is_ascii_digit()) => {
                pick([150, 60, 0], [240, 170, 110])
            }
            Kind::Word if is_keyword(&text[range.clone()]) => pick([20, 70, 150], [130, 180, 250]),
            _ => plain,
        };
        add(range.clone(), color);
        last = color;
        at = range.end;
    }
    add(at..text.len(), visuals.weak_text_color());
    job
}

/// A range of a text, cut where marks begin and end. Marks may be of the text before, which was another.
fn pieces(text: &str, range: Range<usize>, marks: &Marks) -> Vec<Range<usize>> {
    let all = marks.wrong.iter().chain(&marks.selected).chain(&marks.hovered);
    let mut cuts: Vec<usize> = all.flat_map(|mark| [mark.start, mark.end]).collect();
    cuts.retain(|cut| range.start < *cut && *cut < range.end && text.is_char_boundary(*cut));
    cuts.extend([range.start, range.end]);
    cuts.sort_unstable();
    cuts.dedup();
    cuts.windows(2).map(|ends| ends[0]..ends[1]).collect()
}

fn marks(editor: &Editor) -> Marks {
    let snapshot = &editor.analysis.snapshot;
    let messages = snapshot.messages().iter();
    let messages = messages.map(|message| message.place.clone());
    let unmet = editor.analysis.unmet().map(|(_, place)| place);
    let places = |item| match editor.sight.drag {
        Drag::Nothing => places_of(item, &snapshot.listing),
        _ => Vec::new(),
    };
    let Selection { items, hovered, .. } = &editor.selection;
    Marks {
        wrong: messages.chain(unmet).collect(),
        selected: items.iter().flat_map(places).collect(),
        hovered: hovered.iter().flat_map(places).collect(),
    }
}

/// Where something is named in the text, or where a number of it stands.
fn places_of(item: &Item, listing: &Listing) -> Vec<Range<usize>> {
    let name = item.name();
    let names = listing.names.iter().filter(|one| one.part.is_none() && one.path == name);
    let names = names.map(|one| one.place.clone());
    let numbers = listing.numbers_of(name).map(|one| one.place.clone());
    names.chain(numbers).collect()
}

/// Finds the item at a place in the text.
fn item_at(byte: usize, listing: &Listing, drawing: &Drawing) -> Option<Item> {
    let within = |place: &Range<usize>| place.start <= byte && byte <= place.end;
    let number = listing.numbers.iter().find(|one| !one.is_pair && within(&one.place));
    let name = listing.names.iter().find(|one| within(&one.place));
    let path = number.map(ListedNumber::path).or_else(|| name.map(|one| one.path.clone()))?;
    let kinds = [Item::Joint, Item::Axis, Item::Link, Item::Action];
    kinds.into_iter().map(|kind| kind(path.clone())).find(|item| drawing.has(item))
}
