//! Messages as the Rust compiler shows them.

use crate::document::{Message, Source};
use crate::text::masked;
use annotate_snippets::renderer::{DEFAULT_TERM_WIDTH, DecorStyle};
use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};

/// The width of the text that is shown of a line, as in the tests of the macro.
const WIDTH: usize = DEFAULT_TERM_WIDTH;

/// Messages with the lines they are about, each followed by an empty line. Nothing but our colours commands a terminal.
pub(crate) fn render(source: &Source, messages: &[Message], has_colors: bool) -> String {
    let renderer = if has_colors {
        Renderer::styled()
    } else {
        Renderer::plain()
    };
    let renderer = renderer.decor_style(DecorStyle::Ascii).term_width(WIDTH);
    let path = source.path().to_string_lossy();
    let (path, text) = (masked(&path), masked(source.text()));
    // Each character is masked by one, so that the columns stay; the bytes do not.
    let place = |byte: usize| match source.text().get(..byte) {
        Some(before) if matches!(text, std::borrow::Cow::Owned(_)) => masked(before).len(),
        _ => byte,
    };
    let shown = messages.iter().map(|message| {
        let words = masked(&message.text);
        let title = Level::ERROR.primary_title(&*words);
        let place = place(message.place.start)..place(message.place.end);
        let annotation = AnnotationKind::Primary.span(place);
        let snippet = Snippet::source(&*text)
            .path(path.as_ref())
            .annotation(annotation);
        let group: Group<'_> = title.element(snippet);
        renderer.render(&[group]) + "\n\n"
    });
    shown.collect()
}
