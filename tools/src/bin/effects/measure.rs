//! Measured times, and sizes of functions, from the symbols of this program.

use mech_runtime::Cost;
use object::{Object, ObjectSymbol};
use std::time::Instant;
use std::{env, fs};

/// Moves in one measurement.
const MOVES: u32 = 3600;

/// A mechanism with some effects.
pub(crate) struct Subject {
    pub(crate) name: &'static str,
    /// The module of its moving function.
    pub(crate) module: &'static str,
    pub(crate) cost: Cost,
    /// The cost of rates, if there are any.
    pub(crate) more: Option<Cost>,
    pub(crate) state: usize,
    /// Moves it so many times. Returns a number that depends on all moves.
    pub(crate) run: fn(u32) -> f64,
}

/// A result.
pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) operations: String,
    pub(crate) nanoseconds: f64,
    pub(crate) state: usize,
    pub(crate) code: Option<u64>,
}

/// Measures all subjects in turn.
///
/// # Errors
/// If a subject does not move.
pub(crate) fn measure_all(subjects: &[Subject], rounds: usize) -> Result<Vec<Row>, String> {
    let mut times = vec![Vec::new(); subjects.len()];
    for _ in 0..rounds {
        for (subject, times) in subjects.iter().zip(&mut times) {
            let start = Instant::now();
            if !(subject.run)(MOVES).is_finite() {
                return Err(format!("{} did not move", subject.name));
            }
            times.push(start.elapsed().as_secs_f64() * 1e9 / f64::from(MOVES));
        }
    }
    let row = |(subject, mut times): (&Subject, Vec<f64>)| {
        times.sort_by(f64::total_cmp);
        let more = subject.more.map(|more| format!(" plus {more}"));
        Row {
            name: subject.name,
            operations: format!("{}{}", subject.cost, more.unwrap_or_default()),
            nanoseconds: times[times.len() / 2],
            state: subject.state,
            code: size_of_code(subject.module),
        }
    };
    Ok(subjects.iter().zip(times).map(row).collect())
}

/// The size in bytes of all functions of a module except those that measure, if this system's object files contain it.
fn size_of_code(module: &str) -> Option<u64> {
    let data = fs::read(env::current_exe().ok()?).ok()?;
    let file = object::File::parse(&*data).ok()?;
    // In symbols every name comes after its length.
    let path = format!("{}{module}", module.len());
    let sizes = file.symbols().filter_map(|symbol| {
        let name = symbol.name().ok()?;
        let measures =
            ["3run", "7subject"].iter().any(|own| name.contains(&format!("{path}{own}")));
        (name.contains(&path) && !measures).then_some(symbol.size())
    });
    Some(sizes.sum()).filter(|size| *size > 0)
}
