//! Tags, before a parser reads them.

use std::ops::Range;

/// The most attributes of a tag. No element of a drawing comes near it; noise does.
pub(super) const MOST: usize = 200;

/// The beginnings and ends of passages that are skipped.
const SKIPPED: [(&str, &str); 3] = [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>")];

/// The first tag that has more attributes than a parser can read in a short time.
pub(super) fn overfull(text: &str) -> Option<Range<usize>> {
    let mut at = 0;
    while let Some(open) = text[at..].find('<') {
        let start = at + open;
        let rest = &text[start..];
        let skipped = SKIPPED.iter().find(|(begin, _)| rest.starts_with(begin));
        let length = if let Some((_, end)) = skipped {
            rest.find(end)? + end.len()
        } else {
            let (length, attributes) = tag(rest);
            if attributes > MOST {
                return Some(start..start + 1);
            }
            length
        };
        at = start + length;
    }
    None
}

/// The length of a tag, and how many attributes it has.
fn tag(text: &str) -> (usize, usize) {
    let mut attributes = 0;
    let mut quote = None;
    for (at, byte) in text.bytes().enumerate() {
        match (quote, byte) {
            (Some(open), _) if open == byte => quote = None,
            (None, b'"' | b'\'') => quote = Some(byte),
            (None, b'=') => attributes += 1,
            (None, b'>') => return (at + 1, attributes),
            (Some(_) | None, _) => {}
        }
    }
    (text.len(), attributes)
}

/// A document as XML wants it, and where it was changed.
///
/// Linkage reads attributes without a space between them, and writes `&` in names as it is.
pub(super) struct Mended {
    pub(super) text: String,
    /// Where something was put in, in the new text, and how long it is.
    inserted: Vec<(usize, usize)>,
    pub(super) has_spaces: bool,
}

impl Mended {
    /// Puts a space between attributes, and makes each `&` of a value a reference.
    pub(super) fn of(text: &str) -> Self {
        let mut mended = Self {
            text: String::with_capacity(text.len()),
            inserted: Vec::new(),
            has_spaces: false,
        };
        let mut at = 0;
        while let Some(open) = text[at..].find('<') {
            let start = at + open;
            let rest = &text[start..];
            let skipped = SKIPPED.iter().find(|(begin, _)| rest.starts_with(begin));
            let length = match skipped {
                Some((_, end)) => rest.find(end).map_or(rest.len(), |found| found + end.len()),
                None => tag(rest).0,
            };
            mended.text += &text[at..start];
            at = start + length;
            if skipped.is_some() {
                mended.text += &text[start..at];
            } else {
                mended.push_tag(&text[start..at]);
            }
        }
        mended.text += &text[at..];
        mended
    }

    fn push_tag(&mut self, tag: &str) {
        let mut quote = None;
        let mut was_closed = false;
        for (at, letter) in tag.char_indices() {
            if was_closed && !letter.is_whitespace() && !"/>?".contains(letter) {
                self.insert(" ");
                self.has_spaces = true;
            }
            was_closed = quote == Some(letter);
            self.text.push(letter);
            quote = match (quote, letter) {
                (Some(open), _) if open == letter => None,
                (None, '"' | '\'') => Some(letter),
                (open, _) => open,
            };
            if quote.is_some() && letter == '&' && !is_reference(&tag[at..]) {
                self.insert("amp;");
            }
        }
    }

    fn insert(&mut self, text: &str) {
        self.inserted.push((self.text.len(), text.len()));
        self.text += text;
    }

    /// Where a place of the new text was in the old one.
    pub(super) fn old(&self, place: &Range<usize>) -> Range<usize> {
        let old = |byte: usize| {
            let before = self.inserted.iter().take_while(|(at, _)| *at < byte);
            byte - before.map(|(at, length)| (byte - at).min(*length)).sum::<usize>()
        };
        old(place.start)..old(place.end)
    }
}

/// Whether a text begins with a reference to a letter: `&amp;`, `&#38;`.
fn is_reference(text: &str) -> bool {
    let inside = text[1..].split_once(';').map(|(inside, _)| inside);
    inside.is_some_and(|inside| {
        let number = inside.strip_prefix('#');
        let is_number = number.is_some_and(|number| {
            let digits = number.strip_prefix('x').unwrap_or(number);
            !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
        });
        is_number || ["amp", "lt", "gt", "quot", "apos"].contains(&inside)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_linkage_reads_becomes_xml() {
        let mended = Mended::of("<a b=\"1\"c='2&3'/><!--x=\"\"y--><d e=\"&amp;\"\n/>f&g");
        assert_eq!(mended.text, "<a b=\"1\" c='2&amp;3'/><!--x=\"\"y--><d e=\"&amp;\"\n/>f&g");
        assert!(mended.has_spaces);
        // The `d` of the second tag.
        let place = mended.text.find("<d").expect("a tag");
        assert_eq!(mended.old(&(place..place + 2)), place - 5..place - 3);
        assert_eq!(mended.old(&(9..10)), 8..9);
    }

    #[test]
    fn attributes_are_counted_in_tags_alone() {
        let many: String = (0..=MOST).map(|number| format!(" a{number}='>'")).collect();
        assert_eq!(overfull(&format!("<a><b{many}/></a>")), Some(3..4));
        for harmless in [
            format!("<!--<b{many}/>--><a/>"),
            format!("<![CDATA[<b{many}/>]]>"),
            format!("<a b=\"{}\"/>", many.replace('>', "=")),
            "<a b='".to_owned(),
            "<!--".to_owned(),
        ] {
            assert_eq!(overfull(&harmless), None, "{harmless:.40}");
        }
    }
}
