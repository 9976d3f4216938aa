//! The pieces of texts.

/// The statements of a text, with their ends.
pub(crate) fn statements<'t>(text: &'t str, ends: &[char]) -> Vec<&'t str> {
    text.split_inclusive(ends).collect()
}

/// The words, numbers, blanks and marks of a text.
pub(crate) fn words(text: &str) -> Vec<&str> {
    let mut words = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_in = |letter: char| letter.is_alphanumeric() || letter == '_';
        let is_digit = first.is_ascii_digit();
        let goes_on = |letter: char| is_in(letter) || is_digit && letter == '.';
        let end = if is_in(first) {
            rest.find(|letter| !goes_on(letter)).unwrap_or(rest.len())
        } else if first.is_whitespace() {
            rest.find(|letter: char| !letter.is_whitespace()).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        words.push(&rest[..end]);
        rest = &rest[end..];
    }
    words
}
