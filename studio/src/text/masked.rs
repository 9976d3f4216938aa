//! Texts of strangers, as a terminal or a window may show them.

use std::borrow::Cow;

/// The text without what would command a terminal, or turn the direction of what is read: `?` stands for each such character. Ends of lines
/// and tabs stay.
pub(crate) fn masked(text: &str) -> Cow<'_, str> {
    let mut letters = text.char_indices().peekable();
    let mut found = String::new();
    let mut from = 0;
    while let Some((at, letter)) = letters.next() {
        let is_end_of_line = letter == '\r' && letters.peek().is_some_and(|next| next.1 == '\n');
        if commands(letter) && !is_end_of_line {
            found += &text[from..at];
            found.push('?');
            from = at + letter.len_utf8();
        }
    }
    if from == 0 {
        return Cow::Borrowed(text);
    }
    found += &text[from..];
    Cow::Owned(found)
}

/// Whether a character commands a terminal, or turns the direction of what is read.
fn commands(letter: char) -> bool {
    match letter {
        '\n' | '\t' => false,
        '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' => {
            true
        }
        _ => letter.is_control(),
    }
}

#[cfg(test)]
mod tests {
    use super::masked;

    #[test]
    fn what_commands_a_terminal_is_masked() {
        for (text, shown) in [
            ("a\tb\nc\r\nd ç →", "a\tb\nc\r\nd ç →"),
            ("\x1b]0;pwn\x07", "?]0;pwn?"),
            ("a\rb", "a?b"),
            ("\0\x7f", "??"),
            ("\u{9b}31m", "?31m"),
            ("\u{202e}hcem.a\u{2066}", "?hcem.a?"),
            ("\u{200e}\u{200f}\u{61c}", "???"),
        ] {
            assert_eq!(masked(text), shown);
        }
    }
}
