//! The check of the mechanisms of a document, and its messages.

mod json;
mod verdict;

pub(crate) use json::to_json;
pub(crate) use verdict::{Verdict, Witness, verdict_line, verdicts};

use crate::document::{Message, Source};
use crate::text::masked;
use annotate_snippets::renderer::{DEFAULT_TERM_WIDTH, DecorStyle};
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use std::ops::Range;

/// The width of the text that is shown of a line, as in the tests of the macro.
const WIDTH: usize = DEFAULT_TERM_WIDTH;

/// Messages with the lines they are about, each followed by an empty line. Nothing but our colours commands a terminal.
pub(crate) fn render(source: &Source, messages: &[Message], has_colors: bool) -> String {
    let renderer = if has_colors { Renderer::styled() } else { Renderer::plain() };
    let renderer = renderer.decor_style(DecorStyle::Ascii).term_width(WIDTH);
    let path = source.path().to_string_lossy();
    let path = masked(&path);
    let shown = messages.iter().map(|message| {
        let words = masked(&message.text);
        let title = Level::ERROR.primary_title(&*words);
        let (shown, line) = around(source, &message.place);
        let text = &source.text()[shown.clone()];
        // Each character is masked by one, so that the columns stay; the bytes do not.
        let [start, end] = [message.place.start, message.place.end].map(|byte| {
            let before = text.get(..byte - shown.start);
            before.map_or(byte - shown.start, |before| masked(before).len())
        });
        let annotation = AnnotationKind::Primary.span(start..end);
        let text = masked(text);
        let snippet =
            Snippet::source(&*text).line_start(line).path(path.as_ref()).annotation(annotation);
        let group: Group<'_> = title.element(snippet);
        renderer.render(&[group]) + "\n\n"
    });
    shown.collect()
}

/// The lines of a place, with one before and one after them, and the number of the first: the renderer reads all that it is given. Of
/// a long line, what is far behind the place is left out.
fn around(source: &Source, place: &Range<usize>) -> (Range<usize>, usize) {
    const BEHIND: usize = 1000;
    let text = source.text();
    let line_before = |end: usize| text[..end].rfind('\n').unwrap_or(0);
    let start = match line_before(line_before(place.start)) {
        0 => 0,
        newline => newline + 1,
    };
    let mut newlines = text[place.end..].match_indices('\n').skip(1);
    let end = newlines.next().map_or(text.len(), |(at, _)| place.end + at);
    let far = (place.end + BEHIND..end).find(|at| text.is_char_boundary(*at));
    (start..far.unwrap_or(end), source.spot(start).line)
}
