//! The query of a link, and where its letters stand in the link.

use crate::document::Message;

/// The decoded text behind the question mark of a link.
pub(super) struct Query {
    text: String,
    /// Where each byte stands in the link, and where the link ends.
    places: Vec<usize>,
}

#[derive(Clone, Copy)]
pub(super) struct Field<'q> {
    query: &'q Query,
    start: usize,
    end: usize,
}

impl Query {
    /// The query of a link. Without a question mark the text is the query.
    pub(super) fn of(link: &str) -> Result<Self, Message> {
        let end = link.trim_end().len();
        let start = link.len() - link.trim_start().len();
        let start = link[..end].find('?').map_or(start.min(end), |mark| mark + 1);
        let mut bytes = Vec::with_capacity(end - start);
        let mut places = Vec::with_capacity(end - start + 1);
        let mut at = start;
        while at < end {
            places.push(at);
            if link.as_bytes()[at] == b'%' {
                let code = link.get(at + 1..at + 3).filter(|_| at + 3 <= end);
                let code = code.filter(|code| code.bytes().all(|digit| digit.is_ascii_hexdigit()));
                let code = code.and_then(|code| u8::from_str_radix(code, 16).ok());
                bytes.push(code.ok_or_else(|| Message {
                    place: at..at + 1,
                    text: "`%` has to be followed by two hexadecimal digits".to_owned(),
                })?);
                at += 3;
            } else {
                bytes.push(link.as_bytes()[at]);
                at += 1;
            }
        }
        places.push(end);
        let text = String::from_utf8(bytes).map_err(|error| {
            let place = places[error.utf8_error().valid_up_to()];
            Message {
                place: place..(place + 1).min(end),
                text: "what is encoded from here on is not UTF-8".to_owned(),
            }
        })?;
        Ok(Self { text, places })
    }

    pub(super) fn whole(&self) -> Field<'_> {
        Field { query: self, start: 0, end: self.text.len() }
    }
}

impl<'q> Field<'q> {
    pub(super) fn text(&self) -> &'q str {
        &self.query.text[self.start..self.end]
    }

    pub(super) fn wrong(&self, text: impl Into<String>) -> Message {
        let places = &self.query.places;
        Message { place: places[self.start]..places[self.end], text: text.into() }
    }

    pub(super) fn split(self, separator: char) -> impl Iterator<Item = Self> {
        let query = self.query;
        let mut start = self.start;
        self.text().split(separator).map(move |part| {
            let end = start + part.len();
            let field = Self { query, start, end };
            start = end + separator.len_utf8();
            field
        })
    }

    /// Its first letter, and what follows.
    pub(super) fn first(&self) -> Option<(Self, Self)> {
        let length = self.text().chars().next()?.len_utf8();
        let middle = self.start + length;
        let first = Self { end: middle, ..*self };
        Some((first, Self { start: middle, ..*self }))
    }

    /// Splits off its last letter.
    pub(super) fn last(&self) -> Option<(Self, Self)> {
        let length = self.text().chars().next_back()?.len_utf8();
        let middle = self.end - length;
        let before = Self { end: middle, ..*self };
        Some((before, Self { start: middle, ..*self }))
    }

    /// Splits it at the last letter of a kind, which is left out.
    pub(super) fn before_last(&self, letter: char) -> Option<(Self, Self)> {
        let middle = self.start + self.text().rfind(letter)?;
        let before = Self { end: middle, ..*self };
        let start = middle + letter.len_utf8();
        Some((before, Self { start, ..*self }))
    }

    /// From its beginning to the end of a later one.
    pub(super) fn through(self, last: Self) -> Self {
        Self { end: last.end, ..self }
    }

    /// Finds the stretch behind a mark, as `&l=`, up to the next `&` or to the end.
    pub(super) fn behind(&self, mark: &str) -> Option<Self> {
        let start = self.start + self.text().find(mark)? + mark.len();
        let after = &self.query.text[start..self.end];
        let end = after.find('&').map_or(self.end, |length| start + length);
        Some(Self { query: self.query, start, end })
    }
}
