//! The words of a line of the dialogue.

use crate::failure::Failure;
use crate::text::is_of_word;
use std::ops::Range;

/// A word of a line: a name or path, a number, a mark, or all that stands in brackets or in quotes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Word {
    /// Where it stands in the line, in bytes.
    pub(super) range: Range<usize>,
}

impl Word {
    pub(super) fn of<'l>(&self, line: &'l str) -> &'l str {
        &line[self.range.clone()]
    }
}

/// Marks of several characters.
const MARKS: [&str; 2] = ["..=", "->"];

/// The words of a line. After a bracket or quote that is not closed nothing is left.
pub(super) fn words(line: &str) -> Result<Vec<Word>, Failure> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(first) = line[at..].chars().next() {
        if first.is_whitespace() {
            at += first.len_utf8();
            continue;
        }
        let remaining = &line[at..];
        let mark = MARKS.iter().find(|mark| remaining.starts_with(**mark));
        let length = match first {
            '(' | '[' | '{' => group(remaining),
            '"' => remaining[1..].find('"').map(|end| end + 2),
            _ if is_of_word(first) => Some(word(remaining)),
            _ => Some(mark.map_or(first.len_utf8(), |mark| mark.len())),
        };
        let length = length.ok_or_else(|| {
            Failure::usage(format!("`{first}` is not closed in `{}`", remaining.trim_end()))
        })?;
        found.push(Word { range: at..at + length });
        at += length;
    }
    Ok(found)
}

/// The length of a path or a number: words with dots, and with numbers in brackets.
fn word(text: &str) -> usize {
    let mut letters = text.char_indices().peekable();
    let mut end = 0;
    while let Some((at, letter)) = letters.next() {
        let next = letters.peek().map(|(_, next)| *next);
        let goes_on = is_of_word(letter)
            || letter == '.' && next.is_some_and(is_of_word)
            || letter == ']'
            || letter == '*' && next == Some(']');
        let is_index = letter == '[' && text[at..].find(']').is_some_and(|close| close < 8);
        if !goes_on && !is_index {
            break;
        }
        end = at + letter.len_utf8();
    }
    end
}

/// The length of what stands in brackets, these included.
fn group(text: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, letter) in text.char_indices() {
        match letter {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => {
                depth = depth.checked_sub(1)?;
                if depth == 0 {
                    return Some(at + 1);
                }
            }
            _ => {}
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::words;

    fn split(line: &str) -> Vec<&str> {
        let found = words(line).expect("brackets match");
        let shown: Vec<_> = found.iter().map(|word| word.of(line)).collect();
        shown
    }

    #[test]
    fn paths_brackets_and_marks_are_words() {
        assert_eq!(
            split("motor a in 0..=30 deg by 1.5"),
            ["motor", "a", "in", "0", "..=", "30", "deg", "by", "1.5"]
        );
        assert_eq!(
            split("join x = gear left[2].foot.tip b 20:40"),
            ["join", "x", "=", "gear", "left[2].foot.tip", "b", "20", ":", "40"]
        );
        assert_eq!(
            split("point a.b at (1, (2 - 1)) \"a b\" -> -3"),
            ["point", "a.b", "at", "(1, (2 - 1))", "\"a b\"", "->", "-", "3"]
        );
        assert!(words("point a at (1, 2").is_err());
        assert!(words("text \"a").is_err());
    }
}
