//! Random mechanisms in random moves.

use super::comparing::{Finding, Kind, MOST_STEPS, compare, shorten};
use super::drawing::{Drawing, Drawn, coupled, sequential};
use super::reading::Subject;
use super::tally::Tally;
use mech_compiler::evaluate::Machine;
use mech_test_support::{Dice, cases, seeds};
use proptest::strategy::{Strategy, ValueTree};
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

/// Moves that one mechanism makes.
const MOVES: u64 = 5;
/// More tries than this to make an example smaller are not made; none where nobody asked for long runs.
const SHRINKS: usize = 30;

/// Proptest's runner of a seed.
pub(crate) fn runner(seed: u64) -> TestRunner {
    let mut bytes = [0; 32];
    bytes[..8].copy_from_slice(&seed.to_le_bytes());
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &bytes);
    TestRunner::new_with_rng(Config::default(), rng)
}

/// A target: by a little, by some turns, or far away.
pub(crate) fn target(dice: &mut Dice, drawn: &Drawn, subject: &Subject, at: &[f64]) -> Vec<f64> {
    let turn = *dice.pick(&[0.3, 3.0, 7.0, 7.0, 40.0, 300.0]);
    let slide =
        *dice.pick(&[0.1, 1.0, 4.0, 20.0]) * mech_test_support::size(&subject.model).max(1.0);
    let only = dice.below(2 * at.len());
    let mut to = at.to_vec();
    for (number, value) in to.iter_mut().enumerate() {
        let most = if drawn.motors[number].1 { slide } else { turn };
        let displacement = dice.between(-most, most);
        if only >= at.len() || only == number {
            *value += displacement;
        }
    }
    to
}

/// What is found in the moves of one mechanism: the same for the same seed.
fn findings(subject: &Subject, drawn: &Drawn, seed: u64, wanted: Option<Kind>) -> Vec<Finding> {
    let mut dice = Dice::new(seed);
    let start = Machine::<f64>::new(&subject.compiled.program)
        .position()
        .clone();
    let mut at = start.clone();
    let mut all = Vec::new();
    for _ in 0..MOVES {
        let to = target(&mut dice, drawn, subject, &at.motors);
        let to = shorten(subject, &at, &to, MOST_STEPS);
        let (found, end) = compare(subject, &at, &to);
        all.extend(found);
        if wanted.is_some_and(|kind| all.iter().any(|one| one.kind == kind)) {
            break;
        }
        at = end.unwrap_or_else(|| start.clone());
    }
    all
}

/// The smallest drawing that shows the same kind, as text with what is found.
fn smallest<T: ValueTree<Value = Drawing>>(tree: &mut T, kind: Kind, seed: u64) -> String {
    let shows = |drawing: &Drawing| {
        let drawn = drawing.drawn();
        let subject = Subject::read(&drawn.text).ok()?;
        let found = findings(&subject, &drawn, seed, Some(kind))
            .into_iter()
            .find(|one| one.kind == kind)?;
        Some(format!("seed {seed}, {}\n{}", found.text, drawn.text))
    };
    let mut best = shows(&tree.current()).unwrap_or_default();
    let mut tries = 0;
    let most = if std::env::var_os("MECH_CASES").is_some() {
        SHRINKS
    } else {
        0
    };
    while tries < most && tree.simplify() {
        loop {
            tries += 1;
            if let Some(text) = shows(&tree.current()) {
                best = text;
                break;
            }
            if tries >= most || !tree.complicate() {
                return best;
            }
        }
    }
    best
}

/// Compares leaps of the mechanisms of many seeds.
fn tally(strategy: &impl Strategy<Value = Drawing>, default: u64) -> Tally {
    let mut tally = Tally::default();
    for seed in seeds(cases(default)) {
        let mut tree = strategy.new_tree(&mut runner(seed)).expect("a drawing");
        let drawn = tree.current().drawn();
        let subject = match Subject::read(&drawn.text) {
            Ok(subject) => subject,
            Err(why) => {
                assert!(
                    !why.starts_with("no text"),
                    "seed {seed}: {why}\n{}",
                    drawn.text
                );
                tally.refused.push(format!("seed {seed}: {why}"));
                continue;
            }
        };
        tally.mechanisms += 1;
        tally.moves += usize::try_from(MOVES).unwrap_or(0);
        let found = findings(&subject, &drawn, seed, None);
        let mut kinds: Vec<Kind> = found.iter().map(|one| one.kind).collect();
        kinds.sort_unstable();
        kinds.dedup();
        for one in &found {
            tally.count(one);
        }
        for kind in kinds {
            if tally.wants(kind) {
                let text = smallest(&mut tree, kind, seed);
                tally.example(kind, text);
                tree = strategy.new_tree(&mut runner(seed)).expect("a drawing");
            }
        }
    }
    tally
}

#[test]
fn leaps_of_sequential_mechanisms_are_their_small_steps() {
    tally(&sequential(6), 8).assert_clean();
}

#[test]
fn leaps_of_coupled_mechanisms_are_their_small_steps() {
    tally(&coupled(), 4).assert_clean();
}
