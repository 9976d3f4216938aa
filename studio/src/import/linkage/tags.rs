//! Tags, before a parser reads them.

use std::ops::Range;

/// The most attributes of a tag. No element of a drawing comes near it; noise does.
pub(super) const MOST: usize = 200;

/// What is skipped: its beginning and its end.
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

#[cfg(test)]
mod tests {
    use super::*;

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
