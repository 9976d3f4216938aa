//! Numbers to the base 64, as links of PMKS+ write them, and the letters that end a link and show that it is whole.

use super::query::Field;
use crate::document::Message;

const DIGITS: &str = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";
/// The most digits of a number: more than 53 bits are not exact.
const MOST: usize = 8;
/// Numbers with decimals are written as thousandths.
const THOUSANDTHS: f64 = 1000.0;

pub(super) fn digit(letter: char) -> Option<u32> {
    let value = DIGITS.chars().position(|digit| digit == letter)?;
    u32::try_from(value).ok()
}

/// A whole number. One that begins with `0` is below zero.
pub(super) fn whole(field: &Field<'_>) -> Result<f64, Message> {
    let text = field.text();
    if text.is_empty() {
        return Err(field.wrong("a number is missing here"));
    }
    let (sign, digits) = match text.strip_prefix('0') {
        Some(digits) => (-1.0, digits),
        None => (1.0, text),
    };
    if digits.len() > MOST {
        return Err(field.wrong(format!("`{text}` is a number that is too large")));
    }
    let mut value = 0.0;
    for letter in digits.chars() {
        let digit = digit(letter);
        let digit = digit.ok_or_else(|| {
            field.wrong(format!("`{letter}` in `{text}` is no digit to the base 64"))
        })?;
        value = value * 64.0 + f64::from(digit);
    }
    // Zero has no sign.
    Ok(if value == 0.0 { value } else { sign * value })
}

pub(super) fn decimal(field: &Field<'_>) -> Result<f64, Message> {
    Ok(whole(field)? / THOUSANDTHS)
}

/// The flags in a digit, from the lowest bit on.
pub(super) fn flags(field: &Field<'_>) -> Result<[bool; 6], Message> {
    let mut letters = field.text().chars();
    let value = letters.next().and_then(digit);
    let value = value.filter(|_| letters.next().is_none());
    let value = value.ok_or_else(|| {
        let text = field.text();
        field.wrong(format!("`{text}` is no digit to the base 64"))
    })?;
    Ok(std::array::from_fn(|bit| value >> bit & 1 == 1))
}

/// The letters of both.
const LETTERS: &[u8; 62] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz";
/// The letter before the digest.
const MARK: char = '*';
/// The number of letters of the digest.
const DIGEST: usize = 6;

/// The query without what checks it.
pub(super) fn checked(query: Field<'_>) -> Result<Field<'_>, Message> {
    let (query, digest) = match query.before_last(MARK) {
        Some((before, after)) => (before, Some(after)),
        None => (query, None),
    };
    if let Some(found) = digest {
        let right = digest_of(query.text());
        if found.text() != right {
            return Err(found.wrong(format!(
                "the last letters check all letters of the link: they are `{}`, but should be `{right}`; a part may be missing or another",
                found.text()
            )));
        }
    }
    let ends = query.last();
    let (body, check) = ends.ok_or_else(|| query.wrong("the link is empty"))?;
    // As the program counts.
    let length = body.text().encode_utf16().count();
    let right = char::from(LETTERS[length % LETTERS.len()]);
    if check.text().chars().eq([right]) {
        return Ok(body);
    }
    Err(check.wrong(format!(
        "the last letter checks the length of the link: it is `{}`, but should be `{right}`; a part of the link may be missing",
        check.text()
    )))
}

/// The hash of a text, FNV-1a of 32 bits, to the base 62.
fn digest_of(text: &str) -> String {
    let mix = |hash: u32, unit: u16| (hash ^ u32::from(unit)).wrapping_mul(0x0100_0193);
    let hash = text.encode_utf16().fold(0x811C_9DC5, mix);
    let mut rest = u64::from(hash);
    let mut letters = [0; DIGEST];
    for letter in letters.iter_mut().rev() {
        *letter = LETTERS[(rest % 62) as usize];
        rest /= 62;
    }
    letters.iter().map(|letter| char::from(*letter)).collect()
}

#[cfg(test)]
mod tests {
    use super::digest_of;

    #[test]
    fn the_digest_is_the_published_hash() {
        // FNV-1a of 32 bits: of nothing its offset basis, of `foobar` 0xBF9CF968.
        assert_eq!(digest_of(""), "2Maszd");
        assert_eq!(digest_of("foobar"), "3VYhc8");
    }
}
