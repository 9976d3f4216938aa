//! Words that the user may have meant.

/// Words of other languages and books, each with ours.
const OTHERS: [(&str, &str); 30] = [
    ("pin", "revolute"),
    ("hinge", "revolute"),
    ("pivot", "revolute"),
    ("turning", "revolute"),
    ("rotational", "revolute"),
    ("slider", "prismatic"),
    ("slide", "prismatic"),
    ("sliding", "prismatic"),
    ("linear", "prismatic"),
    ("translational", "prismatic"),
    ("fixed", "weld"),
    ("rigid", "weld"),
    ("chain", "belt"),
    ("pulley", "belt"),
    ("body", "link"),
    ("bar", "link"),
    ("beam", "link"),
    ("rod", "link"),
    ("frame", "ground"),
    ("base", "ground"),
    ("world", "ground"),
    ("drive", "motor"),
    ("actuator", "motor"),
    ("input", "motor"),
    ("driver", "motor"),
    ("pt", "point"),
    ("vertex", "point"),
    ("disk", "circle"),
    ("rectangle", "polygon"),
    ("time", "t"),
];

/// The candidate that looks most like the word, or else means the same elsewhere, if one does.
pub(super) fn nearest<'a>(word: &str, candidates: &[&'a str]) -> Option<&'a str> {
    let alike = alike(word, candidates.iter().copied()).into_iter();
    let alike = alike.min_by_key(|(distance, _)| *distance).map(|(_, near)| near);
    alike.or_else(|| {
        let (_, own) = OTHERS.iter().find(|(other, _)| *other == word)?;
        candidates.iter().copied().find(|candidate| candidate == own)
    })
}

/// The candidates that look like the word, with the number of letters in which they are others.
pub fn alike<'a>(word: &str, candidates: impl Iterator<Item = &'a str>) -> Vec<(usize, &'a str)> {
    let length = word.chars().count();
    // A third of the letters, but never all of them: one letter is like no other.
    let limit = (length / 3).max(1).min(length.saturating_sub(1));
    // Of most names length and letters tell that they are others.
    let own = letters(word);
    let near = candidates.filter(|name| {
        let other = letters(name);
        let more = |a: u64, b: u64| (a & !b).count_ones() as usize;
        let is_long = name.len().abs_diff(length) > limit;
        let is_ascii = name.is_ascii() && word.is_ascii();
        !(is_ascii && (is_long || more(own, other).max(more(other, own)) > limit))
    });
    let near = near.map(|candidate| (distance(word, candidate, limit), candidate));
    near.filter_map(|(distance, candidate)| Some((distance?, candidate))).collect()
}

/// The end of a message about an unknown word: what it may have meant, or else what there is to choose from.
pub(super) fn remedy(word: &str, candidates: &[&str]) -> String {
    match (nearest(word, candidates), candidates) {
        (Some(candidate), _) => format!("; did you mean `{candidate}`?"),
        (None, []) => String::new(),
        (None, [only]) => format!("; there is only `{only}`"),
        (None, _) => format!("; there are {}", list(candidates)),
    }
}

/// The words in back-ticks; the last of many are left out.
pub(super) fn list(words: &[&str]) -> String {
    const SHOWN: usize = 12;
    let rest = if words.len() > SHOWN { ", …" } else { "" };
    format!("{}{rest}", list_all(&words[..words.len().min(SHOWN)]))
}

/// All of the words in back-ticks.
pub(super) fn list_all(words: &[&str]) -> String {
    let quoted: Vec<_> = words.iter().map(|word| format!("`{word}`")).collect();
    quoted.join(", ")
}

/// A bit for each letter of an ASCII word: one that only one of two words has costs a change. Small and great letters have the same.
fn letters(word: &str) -> u64 {
    let bits = word.bytes().map(|letter| 1 << (letter % 32 + 32 * (letter >> 6 & 1)));
    bits.fold(0, |all, bit: u64| all | bit)
}

/// The number of letters to insert, remove, replace or swap, unless it is above the limit.
fn distance(a: &str, b: &str, limit: usize) -> Option<usize> {
    let a: Vec<char> = a.chars().flat_map(char::to_lowercase).collect();
    let b: Vec<char> = b.chars().flat_map(char::to_lowercase).collect();
    if a.len().abs_diff(b.len()) > limit {
        return None;
    }
    // Three rows of the table of optimal string alignment: the one before last is for swaps.
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for (i, &left) in a.iter().enumerate() {
        let mut row = Vec::with_capacity(b.len() + 1);
        row.push(i + 1);
        for (j, &right) in b.iter().enumerate() {
            let replaced = last[j] + usize::from(left != right);
            let mut best = replaced.min(last[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && left == b[j - 1] && a[i - 1] == right {
                best = best.min(before[j - 1] + 1);
            }
            row.push(best);
        }
        before = std::mem::replace(&mut last, row);
    }
    last.last().copied().filter(|&distance| distance <= limit)
}
