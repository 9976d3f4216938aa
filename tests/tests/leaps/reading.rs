//! From the text of a mechanism to what can be moved.

use mech_compiler::model::{LinkId, Model};
use mech_compiler::program::Position;
use mech_compiler::structure::RollingEnd;
use mech_compiler::syntax::parse;
use mech_compiler::{Compiled, compile, reporter};
use mech_tests::with_ground;
use proc_macro2::TokenStream;

/// A mechanism that compiles.
pub(crate) struct Subject {
    pub(crate) text: String,
    pub(crate) model: Model,
    pub(crate) compiled: Compiled,
}

impl Subject {
    /// Reads and compiles a text.
    pub(crate) fn read(text: &str) -> Result<Self, String> {
        let tokens: TokenStream = text.parse().map_err(|error| format!("{error}"))?;
        let parsed = parse(tokens);
        if !parsed.errors.is_empty() {
            let errors: Vec<&str> = parsed
                .errors
                .iter()
                .map(|error| error.text.as_str())
                .collect();
            return Err(format!("no text of a mechanism: {}", errors.join("; ")));
        }
        let model = parsed.model;
        let compiled = compile(&model).map_err(|wrong| {
            let messages: Vec<String> = wrong
                .iter()
                .map(|one| reporter::text(one, &model))
                .collect();
            messages.join("; ")
        })?;
        Ok(Self {
            text: text.to_owned(),
            model,
            compiled,
        })
    }

    /// The mechanism of a text that is right.
    pub(crate) fn of(text: &str) -> Self {
        Self::read(text).unwrap_or_else(|why| panic!("{why}\n{text}"))
    }

    /// The mechanism of a text in which a word stands for a number or a ratio.
    pub(crate) fn with(text: &str, word: &str, value: &str) -> Self {
        Self::of(&text.replace(word, value))
    }

    /// The poses of all links, the ground first.
    pub(crate) fn poses(&self, at: &Position<f64>) -> Vec<[f64; 4]> {
        with_ground(&self.model, &at.poses)
    }

    /// A length that poses are measured by.
    pub(crate) fn extent(&self, poses: &[[f64; 4]]) -> f64 {
        let far = poses.iter().map(|[_, _, x, y]| x.hypot(*y));
        far.fold(mech_tests::size(&self.model), f64::max).max(1e-9)
    }

    /// Whether it only turns and slides as something that rolls has it.
    pub(crate) fn is_rolling(&self, link: usize) -> bool {
        let ends = self
            .compiled
            .structure
            .rollings
            .iter()
            .flat_map(|rolling| rolling.ends);
        ends.into_iter().any(|(end, _)| match end {
            RollingEnd::Wheel(wheel) | RollingEnd::Bar { link: wheel, .. } => {
                wheel == LinkId::new(link)
            }
        })
    }
}

/// Every bit of a position.
pub(crate) fn bits(position: &Position<f64>) -> Vec<u64> {
    let numbers = position.poses.iter().flatten();
    let numbers = numbers.chain(&position.motors).chain(&position.state);
    let turns = position
        .turns
        .iter()
        .map(|turns| u64::from(turns.cast_unsigned()));
    numbers
        .map(|number| number.to_bits())
        .chain(turns)
        .collect()
}
