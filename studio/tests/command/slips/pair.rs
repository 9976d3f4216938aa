//! Two slips in different statements of one text: both are told.

use super::corpus::{Correct, analyse};
use super::dice::Dice;
use super::judge::is_placed;
use super::text::{Slip, Text};
use super::{Make, marks, statements, words};
use mech_studio::Message;
use std::ops::Range;

/// A change of a correct text, and what is said of it alone.
struct Change {
    /// What is replaced, and by what.
    old: Range<usize>,
    new: String,
    slip: Slip,
    first: Message,
}

/// A slip that makes the text of a mechanism wrong, and leaves its brackets right.
fn change(correct: &Correct, make: Make, dice: &mut Dice) -> Option<Change> {
    let slip = make(&Text::of(&correct.text), dice)?;
    let (text, other) = (correct.text.as_bytes(), slip.text.as_bytes());
    let is_same = |(a, b): &(&u8, &u8)| a == b;
    let start = text.iter().zip(other).take_while(is_same).count();
    let backwards = text[start..].iter().rev().zip(other[start..].iter().rev());
    let after = backwards.take_while(is_same).count();
    let (_, reading) = analyse(&slip.text);
    let faults = reading.result.err()?;
    let is_lexed = !reading.model.name.is_empty();
    let new = slip.text.get(start..other.len() - after)?.to_owned();
    (is_lexed && faults.diagnoses.is_empty()).then(|| Change {
        old: start..text.len() - after,
        new,
        slip,
        first: faults.messages[0].clone(),
    })
}

impl Change {
    fn statement(&self, text: &Text<'_>) -> Option<Range<usize>> {
        let all = text.statements().into_iter().map(|one| text.bytes(one));
        let around = all.filter(|one| one.start <= self.old.start && self.old.end <= one.end);
        around.max_by_key(Range::len)
    }

    /// By how much it makes a text longer.
    fn growth(&self) -> isize {
        self.new.len().cast_signed() - self.old.len().cast_signed()
    }

    /// The slip where another change is made, too, and where its first message stands then.
    fn beside(&self, other: &Self, both: &str) -> (Slip, usize) {
        let is_after = other.old.start > self.old.start;
        let start = if is_after { self.growth() } else { 0 };
        let start = other.old.start.saturating_add_signed(start);
        let moved = |place: usize| {
            let by = if place > start { other.growth() } else { 0 };
            place.saturating_add_signed(by)
        };
        let place = &self.slip.place;
        let slip = Slip {
            text: both.to_owned(),
            place: moved(place.start)..moved(place.end),
            names: self.slip.names.clone(),
        };
        (slip, moved(self.first.place.start))
    }
}

/// Makes two slips in a text and returns what is said: whether both are told.
fn judge(correct: &Correct, mut changes: [Change; 2]) -> Option<Result<(), String>> {
    changes.sort_by_key(|one| one.old.start);
    let [first, second] = &changes;
    let text = Text::of(&correct.text);
    let statements = [first.statement(&text)?, second.statement(&text)?];
    if statements[0].end > statements[1].start {
        return None;
    }
    let all = &correct.text;
    let between = &all[first.old.end..second.old.start];
    let after = &all[second.old.end..];
    let both = [&all[..first.old.start], &first.new, between, &second.new, after].concat();
    let (_, reading) = analyse(&both);
    let messages = reading.result.err().map_or_else(Vec::new, |faults| faults.messages);
    let is_told = |(slip, start): (Slip, usize)| {
        let mut messages = messages.iter();
        messages.any(|one| one.place.start == start || is_placed(&slip, one))
    };
    let is_told = is_told(first.beside(second, &both)) && is_told(second.beside(first, &both));
    let told: Vec<&str> = messages.iter().map(|one| &*one.text).collect();
    let said = || format!("{} … {}: {told:#?}", first.new, second.new);
    let is_right = is_told && messages.len() > 1;
    Some(is_right.then_some(()).ok_or_else(said))
}

#[test]
fn two_slips_are_both_told() {
    const PAIRS: usize = 600;
    let mut dice = Dice::new(1);
    let mut corpus = super::corpus::read();
    corpus.retain(|one| one.text.len() < 900);
    let kinds = [words::KINDS, marks::KINDS, statements::KINDS].concat();
    let mut untold = Vec::new();
    let mut pairs = 0;
    while pairs < PAIRS {
        let correct = dice.pick(&corpus);
        let mut one = || {
            let (name, make) = *dice.pick(&kinds);
            Some((name, change(correct, make, &mut dice)?))
        };
        let (Some((one_name, one)), Some((other_name, other))) = (one(), one()) else {
            continue;
        };
        let Some(result) = judge(correct, [one, other]) else {
            continue;
        };
        pairs += 1;
        if let Err(said) = result {
            untold.push(format!("{one_name} + {other_name}: {said}"));
        }
    }
    println!("{} of {pairs} pairs: one untold", untold.len());
    assert!(untold.len() * 100 <= pairs * 3, "{untold:#?}");
}
