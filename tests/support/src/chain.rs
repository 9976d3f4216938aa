//! Long trunks: four-bars in a row, each driven by the rocker of the one before it.

use crate::{Dice, model};
use mech_compiler::model::Model;

/// A trunk of this many loops, one motor, as drawn. Its declaration order is that of the sequence.
#[must_use]
pub fn chain(loops: usize) -> Model {
    model(&chain_text(loops))
}

/// The same as the text of a `mechanism!`, in the form of a drawing.
#[must_use]
pub fn chain_text(loops: usize) -> String {
    written(loops, |middle, _| middle)
}

/// A trunk whose lengths are random.
#[must_use]
pub fn uneven_chain_text(loops: usize, dice: &mut Dice) -> String {
    written(loops, |middle, by| dice.between(middle - by, middle + by))
}

/// A trunk, with numbers near those in the middle by so much.
fn written(loops: usize, mut near: impl FnMut(f64, f64) -> f64) -> String {
    let (mut links, mut joints) = ("link crank;\n".to_owned(), Vec::new());
    let mut join = |a: &str, b: &str, [x, y]: [f64; 2]| {
        let number = joints.len();
        joints.push(format!("joint j{number} = revolute({a}, {b}) at ({x:?}, {y:?});\n"));
    };
    join("ground", "crank", [0.0, 0.0]);
    let (mut input, mut pin, mut along) = ("crank".to_owned(), [0.3, 1.0], 0.0);
    for number in 0..loops {
        let [coupler, rocker] = ["coupler", "rocker"].map(|name| format!("{name}_{number}"));
        links += &format!("link {coupler};\nlink {rocker};\n");
        along += near(3.0, 0.2);
        join(&input, &coupler, pin);
        join(&coupler, &rocker, [along + 0.3, near(1.6, 0.1)]);
        join("ground", &rocker, [along, 0.0]);
        // The next loop is driven from lower on the rocker, so that the swing does not grow along the chain.
        (input, pin) = (rocker, [along + 0.2, near(1.0, 0.1)]);
    }
    format!("struct Chain;\n{links}{}motor j0;\n", joints.concat())
}
