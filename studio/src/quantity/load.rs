//! Loads as they are typed.

use crate::failure::Failure;
use crate::text::quoted;
use mech_compiler::model::{LoadKind, Model};

/// A load and its numbers, as they are typed: `push=-100,0`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Load {
    name: String,
    /// The parts of a force in the directions of the scene, or a torque.
    numbers: Vec<f64>,
}

impl std::fmt::Display for Load {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let numbers: Vec<String> = self.numbers.iter().map(f64::to_string).collect();
        write!(f, "{}={}", self.name, numbers.join(","))
    }
}

impl std::str::FromStr for Load {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (name, numbers) =
            text.split_once('=').ok_or("expected a load and its numbers, as `push=-100,0`")?;
        let numbers = numbers.split(',').map(crate::motion::read_value);
        Ok(Self { name: name.trim().to_owned(), numbers: numbers.collect::<Result<_, _>>()? })
    }
}

/// The numbers of all loads, in their order; those that nobody gives are zero.
pub(crate) fn numbers(model: &Model, given: &[Load]) -> Result<Vec<f64>, Failure> {
    let loads = &model.actions.loads;
    let count = loads.iter().map(|load| load.kind.numbers()).sum();
    let mut numbers = vec![0.0; count];
    for Load { name, numbers: values } in given {
        let mut all = model.actions.numbered_loads();
        let Some((first, load)) = all.find(|(_, load)| load.name == *name) else {
            return Err(Failure::usage(format!(
                "`{}` has no load `{name}`; it has {}",
                model.name,
                quoted(loads.iter().map(|load| &load.name))
            )));
        };
        if values.len() != load.kind.numbers() {
            let how = match load.kind {
                LoadKind::Force(_) => format!("a force; write `--load {name}=X,Y`"),
                LoadKind::Torque(_) => format!("a torque; write `--load {name}=VALUE`"),
            };
            return Err(Failure::usage(format!("load `{name}` is {how}")));
        }
        numbers[first..first + values.len()].copy_from_slice(values);
    }
    Ok(numbers)
}
