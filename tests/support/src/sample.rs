//! Random mechanisms that proptest makes: where a test fails, it leaves out additions as long as the test still fails, and shows what
//! remains as text.

use crate::{Dice, Grown, cases, grow_coupled_from, grow_from, text};
use proptest::collection::{SizeRange, vec};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngSeed, TestRunner};
use std::cell::RefCell;
use std::fmt;

/// A random mechanism.
pub struct Sample {
    /// What has grown.
    pub grown: Grown,
    /// For whatever else is random in a test.
    pub dice: Dice,
}

impl fmt::Debug for Sample {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}with {:?}", text(&self.grown.model), self.dice)
    }
}

/// Dice that stay as they are when a failure is made smaller.
pub fn dice() -> impl Strategy<Value = Dice> {
    any::<u64>().no_shrink().prop_map(Dice::new)
}

/// Mechanisms that are solved loop by loop, of so many additions.
pub fn samples(additions: impl Into<SizeRange>) -> impl Strategy<Value = Sample> {
    (dice(), vec(dice(), additions))
        .prop_map(|(mut dice, additions)| Sample { grown: grow_from(&mut dice, &additions), dice })
}

/// Mechanisms in which loops wait for each other, of so many additions.
pub fn coupled_samples(additions: impl Into<SizeRange>) -> impl Strategy<Value = Sample> {
    (dice(), vec(dice(), additions)).prop_map(|(mut dice, additions)| Sample {
        grown: grow_coupled_from(&mut dice, &additions),
        dice,
    })
}

/// Tries a test on as many values as [`cases`] says: the same ones every time, from the seed in `MECH_SEED` on.
///
/// # Panics
/// If the test fails: with the smallest value that was found for which it does.
pub fn for_all<S: Strategy>(usual: u64, strategy: &S, test: impl FnMut(S::Value)) {
    let config = Config {
        cases: u32::try_from(cases(usual)).expect("not so many"),
        failure_persistence: None,
        rng_seed: RngSeed::Fixed(crate::seeds(0).start),
        ..Config::default()
    };
    let test = RefCell::new(test);
    let result = TestRunner::new(config).run(strategy, |value| {
        test.borrow_mut()(value);
        Ok(())
    });
    if let Err(failure) = result {
        panic!("{failure}");
    }
}
