//! One slip of a hand in a correct text: how well the compiler answers it.
//!
//! `SLIPS=all` makes many more, in long texts too, and shows the worst answers to each kind. `SLIPS_SEED` makes others,
//! and `SLIPS_KIND` only those of the kinds in whose names this stands, with all answers.

mod around;
mod corpus;
#[path = "../../../../tests/support/src/dice.rs"]
#[expect(dead_code, unreachable_pub, reason = "what all tests share")]
mod dice;
mod judge;
mod left_out;
mod marks;
mod pair;
mod statements;
mod table;
mod text;
mod words;

use dice::Dice;
use judge::judge;
use text::{Slip, Text};

/// Floors over all kinds, in percent of the slips that are refused. The goals are 98, 97 and 70. No repair may promise too much.
const PLACED: usize = 98;
const SINGLE: usize = 98;
const MENDED: usize = 77;
/// The same over long texts, too.
const MENDED_OF_ALL: usize = 70;

/// Makes one slip in a text, if there is a place for it.
type Make = fn(&Text<'_>, &mut Dice) -> Option<Slip>;

#[test]
fn slips_of_a_hand_are_answered() {
    let is_all = std::env::var("SLIPS").is_ok_and(|asked| asked == "all");
    let seed = std::env::var("SLIPS_SEED").ok();
    let mut dice = Dice::new(seed.and_then(|seed| seed.parse().ok()).unwrap_or(1));
    let mut corpus = corpus::read();
    // Repairs of long texts take seconds.
    corpus.retain(|one| is_all || one.text.len() < 450);
    println!("{} correct texts", corpus.len());
    let mut kinds = [words::KINDS, marks::KINDS, statements::KINDS].concat();
    let only = std::env::var("SLIPS_KIND").ok();
    kinds.retain(|(name, _)| only.as_ref().is_none_or(|only| name.contains(only.as_str())));
    let mut rows = Vec::new();
    for (name, make) in kinds {
        let mut answers = Vec::new();
        // Not all texts have a place for each slip, and some slips change nothing.
        for _ in 0..if is_all { 2000 } else { 400 } {
            if answers.len() == if is_all { 60 } else { 5 } {
                break;
            }
            let correct = dice.pick(&corpus);
            let slip = make(&Text::of(&correct.text), &mut dice);
            answers.extend(slip.and_then(|slip| judge(correct, &slip)));
        }
        assert!(!is_all || !answers.is_empty(), "no text has a place for: {name}");
        rows.push((name, answers));
    }
    let total = table::print(&rows);
    if is_all {
        table::print_worst(&rows, if only.is_some() { 60 } else { 3 });
    }
    if only.is_some() {
        return;
    }
    assert!(
        total.placed >= PLACED
            && total.single >= SINGLE
            && total.mended >= if is_all { MENDED_OF_ALL } else { MENDED }
            && total.dishonest == 0,
        "{total:?}"
    );
}
