//! Words below or above a picture.

/// Phrases side by side with a dot between them, in lines that are not longer than so many characters; a phrase that is too long for a
/// line is broken between its words.
#[must_use]
pub(super) fn wrap(phrases: &[String], columns: usize) -> Vec<String> {
    let mut lines = Lines { lines: Vec::new(), columns };
    for phrase in phrases {
        if lines.fits(" · ", phrase) || length(phrase) <= columns {
            lines.add(" · ", phrase);
        } else {
            for word in phrase.split_whitespace() {
                lines.add(" ", word);
            }
        }
    }
    lines.lines
}

/// Lines that are being filled.
struct Lines {
    lines: Vec<String>,
    columns: usize,
}

impl Lines {
    /// Whether the last line has room for a phrase and its separator.
    fn fits(&self, between: &str, text: &str) -> bool {
        let last = self.lines.last();
        last.is_some_and(|line| length(line) + length(between) + length(text) <= self.columns)
    }

    /// Adds something to the last line, or else on a line of its own.
    fn add(&mut self, between: &str, text: &str) {
        let fits = self.fits(between, text);
        match self.lines.last_mut() {
            Some(line) if fits => {
                line.push_str(between);
                line.push_str(text);
            }
            _ => self.lines.push(text.chars().take(self.columns).collect()),
        }
    }
}

fn length(text: &str) -> usize {
    text.chars().count()
}

/// The text in letters that the rasteriser has.
#[must_use]
pub(super) fn plain(text: &str) -> String {
    let pairs = [("← →", "left/right"), ("↑ ↓", "up/down"), ("…", "..."), ("’", "'"), ("—", "-")];
    pairs.iter().fold(text.to_owned(), |text, (from, to)| text.replace(from, to))
}
