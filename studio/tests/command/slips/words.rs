//! Slips in names and keywords.

use super::Make;
use super::text::Text;

#[rustfmt::skip]
pub(super) const KINDS: &[(&str, Make)] = &[
    ("name misspelt where used", |text, dice| text.misspell(dice, |one| text.is_used(one))),
    ("name misspelt where declared", |text, dice| {
        let times = |index| {
            let all = 0..text.lexemes.len();
            all.filter(|&one| text.word(one) == text.word(index)).count()
        };
        text.misspell(dice, |one| text.is_declared(one) && times(one) > 2)
    }),
    ("letter case of a name", |text, dice| {
        let index = text.find(dice, |one| text.is_used(one))?;
        let word = text.word(index);
        let (first, others) = word.split_at(1);
        let title = first.to_uppercase() + others;
        let other = match dice.once_in(3) {
            true => word.to_uppercase(),
            false if title == word => word.to_lowercase(),
            false => title,
        };
        let is_known = (0..text.lexemes.len()).any(|one| text.word(one) == other);
        (!is_known).then(|| text.instead(index..index + 1, &other))
    }),
    ("name in quotes", |text, dice| {
        let index = text.find(dice, |one| text.is_declared(one) || text.is_used(one))?;
        Some(text.instead(index..index + 1, &format!("\"{}\"", text.word(index))))
    }),
    ("point in brackets", |text, dice| {
        let is_path = |one| text.is_name(one - 1) && text.is_name(one + 1);
        let index = text.find(dice, |one| text.is(one, ".") && is_path(one))?;
        Some(text.instead(index..index + 2, &format!("[{}]", text.word(index + 1))))
    }),
    ("keyword misspelt", |text, dice| text.misspell(dice, |one| is_keyword(text, one))),
    ("kind of a joint misspelt", |text, dice| text.misspell(dice, |one| is_kind(text, one))),
    ("effect misspelt", |text, dice| text.misspell(dice, |one| is_of(text, one, EFFECTS) && text.is_head(one))),
    ("word within a statement misspelt", |text, dice| text.misspell(dice, |one| is_of(text, one, WITHIN) && !text.is_declared(one) && !text.is_used(one))),
    ("function misspelt", |text, dice| text.misspell(dice, |one| is_of(text, one, FUNCTIONS))),
    ("keyword left out", |text, dice| {
        let index = text.find(dice, |one| is_keyword(text, one) || is_kind(text, one))?;
        let names = vec![text.word(index).to_owned()];
        Some(text.instead(index..index + 1, "").told_by(names))
    }),
    ("keyword doubled", |text, dice| {
        let index = text.find(dice, |one| is_keyword(text, one) || is_kind(text, one))?;
        let word = text.word(index);
        Some(text.instead(index..index + 1, &format!("{word} {word}")))
    }),
    ("`at`, `along`, `near`, `in` misspelt", |text, dice| {
        let index = text.find(dice, |one| is_preposition(text, one))?;
        let others: &[&str] = match text.word(index) {
            "at" => &["a", "att", "ar", "on", "in"],
            "along" => &["alogn", "allong", "alng", "on"],
            "near" => &["naer", "nera", "neear", "at"],
            _ => &["i", "on", "inn", "from"],
        };
        Some(text.instead(index..index + 1, dice.pick::<&str>(others)))
    }),
    ("`at`, `along`, `near`, `in` left out", |text, dice| {
        let index = text.find(dice, |one| is_preposition(text, one))?;
        Some(text.instead(index..index + 1, ""))
    }),
    ("colour misspelt", |text, dice| text.misspell(dice, |one| one > 0 && text.is(one - 1, "color") && text.is_name(one))),
    ("port misspelt", |text, dice| text.misspell(dice, |one| is_argument(text, one, "{"))),
    ("number of a part misspelt", |text, dice| {
        let index = text.find(dice, |one| is_argument(text, one, "("))?;
        let word = text.word(index);
        let other = text.misspelt(index, dice).unwrap_or_else(|| [word, word].concat());
        Some(text.instead(index..index + 1, &other))
    }),
];

const KEYWORDS: &str =
    "struct const param ground link point line part port use joint motor start effects";
const EFFECTS: &str =
    "velocity acceleration force dynamics overlay trace sensitivity redundant coupled";
const JOINTS: &str = "revolute prismatic slot weld gear belt rack cam";
const WITHIN: &str = "radius width height color plane turned hole teeth scaled mirrored inertia";
const FUNCTIONS: &str = "sin cos sqrt asin exp";

fn is_of(text: &Text<'_>, index: usize, words: &str) -> bool {
    words.split(' ').any(|word| word == text.word(index))
}

fn is_keyword(text: &Text<'_>, index: usize) -> bool {
    text.is_head(index) && is_of(text, index, KEYWORDS)
}

fn is_kind(text: &Text<'_>, index: usize) -> bool {
    index > 0 && is_of(text, index, JOINTS) && text.is(index - 1, "=")
}

fn is_preposition(text: &Text<'_>, index: usize) -> bool {
    is_of(text, index, "at along near in") && !text.is_head(index)
}

/// Whether a port or a number of a part gets something there.
pub(super) fn is_argument(text: &Text<'_>, index: usize, bracket: &str) -> bool {
    let is_in = |open: usize| {
        let head = (0..open).rev().find(|&one| text.is_head(one));
        text.is(open, bracket) && head.is_some_and(|head| text.is(head, "use"))
    };
    text.is_name(index) && text.is(index + 1, "=") && text.bracket(index).is_some_and(is_in)
}
