//! Random mechanisms with equal lengths, as people draw them, and fast ones.

use crate::sketch::{Bond, Sketch};
use crate::{Dice, grow};
use mech_compiler::model::Motor;
use mech_compiler::model::Ratio;

type Point = [f64; 2];

/// A length: whole quarters.
fn length(dice: &mut Dice) -> f64 {
    0.25 * f64::from(u32::try_from(2 + dice.below(12)).unwrap_or(2))
}

/// A number either way.
fn signed(dice: &mut Dice) -> f64 {
    let size = length(dice);
    if dice.once_in(2) { -size } else { size }
}

/// Four bonds of a ring of four links that has equal pairs.
fn ring(dice: &mut Dice, kinds: &[&str]) -> [Bond; 4] {
    let (a, b, c) = (length(dice), length(dice), length(dice));
    let pins = |all: [Point; 4]| all.map(Bond::Pin);
    let mut bonds = match *dice.pick(kinds) {
        "rhombus" => pins([[-a, 0.0], [0.0, b], [a, 0.0], [0.0, -b]]),
        "kite" => pins([[-a, 0.0], [0.0, b], [a + c, 0.0], [0.0, -b]]),
        "parallelogram" => {
            let (u, v) = ([signed(dice), signed(dice)], [signed(dice), length(dice)]);
            pins([[0.0, 0.0], u, [u[0] + v[0], u[1] + v[1]], v])
        }
        "antiparallelogram" => pins([[-a, 0.0], [a + c, b], [a, 0.0], [-a - c, b]]),
        // Crank and rod are equal; the slide passes the crank's pivot.
        "slider" => [
            Bond::Pin([0.0, 0.0]),
            Bond::Pin([a, b]),
            Bond::Pin([2.0 * a, 0.0]),
            Bond::Slide([2.0 * a, 0.0], [1.0, 0.0]),
        ],
        // A pin goes round a pivot as far from it as the pivot of the guide is.
        "guide" => [
            Bond::Pin([0.0, 0.0]),
            Bond::Slide([2.0 * a, 0.0], [1.0, 0.0]),
            Bond::Pin([2.0 * a, 0.0]),
            Bond::Pin([a, b]),
        ],
        // Two slides, square to each other or not.
        "yoke" => [
            Bond::Pin([0.0, 0.0]),
            Bond::Pin([a, b]),
            Bond::Slide([a, b], [0.0, 1.0]),
            Bond::Slide([a + c, 0.0], [1.0, 0.0]),
        ],
        _ => [
            Bond::Pin([0.0, b]),
            Bond::Pin([a, 0.0]),
            Bond::Slide([a, 0.0], [1.0, 0.0]),
            Bond::Slide([0.0, b], [0.0, 1.0]),
        ],
    };
    bonds.rotate_left(dice.below(4));
    bonds
}

const RINGS: [&str; 8] =
    ["rhombus", "kite", "parallelogram", "antiparallelogram", "slider", "guide", "yoke", "trammel"];

/// Moves a ring.
fn moved(bonds: [Bond; 4], [dx, dy]: Point) -> [Bond; 4] {
    bonds.map(|bond| match bond {
        Bond::Pin([x, y]) => Bond::Pin([x + dx, y + dy]),
        Bond::Slide([x, y], along) => Bond::Slide([x + dx, y + dy], along),
        other => other,
    })
}

/// A ring of links, two of which are there already.
fn add_ring(
    sketch: &mut Sketch,
    bonds: [Bond; 4],
    [first, second]: [Option<usize>; 2],
) -> [usize; 4] {
    let first = first.unwrap_or_else(|| sketch.link());
    let second = second.unwrap_or_else(|| sketch.link());
    let links = [first, second, sketch.link(), sketch.link()];
    // With two links that are joined already, their joint is not there twice.
    for (number, bond) in bonds.into_iter().enumerate() {
        sketch.join(links[number], links[(number + 1) % 4], bond);
    }
    links
}

/// A dyad of pins behind two links.
fn add_dyad(sketch: &mut Sketch, dice: &mut Dice, ends: [usize; 2]) {
    let mut point = || [signed(dice) + 2.0, signed(dice) - 1.0];
    let (p, q, r) = (point(), point(), point());
    let (a, b) = (sketch.link(), sketch.link());
    sketch.join(ends[0], a, Bond::Pin(p));
    sketch.join(a, b, Bond::Pin(q));
    sketch.join(
        b,
        ends[1],
        if dice.once_in(4) { Bond::Slide(r, [1.0, 0.0]) } else { Bond::Pin(r) },
    );
}

/// Gears or a belt.
fn rolling(dice: &mut Dice, [a, b]: [i64; 2], carrier: usize) -> Bond {
    let ratio = Ratio::Teeth(a, b);
    if dice.once_in(2) {
        Bond::Gear(ratio, Some(carrier))
    } else {
        Bond::Belt(ratio, Some(carrier))
    }
}

/// Gears or a belt from a new wheel on the ground to a link that turns on it at this pin. Gives the joint of the wheel.
fn add_wheel(
    sketch: &mut Sketch,
    dice: &mut Dice,
    [carrier, link]: [usize; 2],
    [a, b]: [i64; 2],
) -> usize {
    let wheel = sketch.link();
    let joint = sketch.join(carrier, wheel, Bond::Pin([signed(dice) + 6.0, signed(dice)]));
    let bond = rolling(dice, [a, b], carrier);
    sketch.join(wheel, link, bond);
    joint
}

/// A mechanism with equal lengths, ground and motor anywhere: alone, with a dyad, in series with another or behind wheels.
pub fn symmetric(dice: &mut Dice) -> Sketch {
    let mut sketch = Sketch::default();
    let bonds = ring(dice, &RINGS);
    let links = add_ring(&mut sketch, bonds, [None, None]);
    sketch.ground = dice.below(4);
    let mut motor = dice.below(4);
    match dice.below(6) {
        0 | 1 => {}
        2 => {
            let first = dice.below(4);
            let second = (first + 1 + dice.below(3)) % 4;
            add_dyad(&mut sketch, dice, [links[first], links[second]]);
        }
        3 => in_series(&mut sketch, dice, links),
        4 => {
            if let Some(wheel) =
                wheeled(&mut sketch, dice, motor, &[[1, 1], [2, 1], [1, 2], [3, 2]])
            {
                motor = wheel;
            }
        }
        _ => {
            let other = dice.below(4);
            wheeled(&mut sketch, dice, other, &[[1, 1], [2, 1], [1, 2], [5, 2]]);
        }
    }
    sketch.motors = vec![motor];
    let exact = dice.once_in(2);
    sketch.place(dice, exact);
    sketch
}

/// A second ring that one joint of the first drives.
fn in_series(sketch: &mut Sketch, dice: &mut Dice, links: [usize; 4]) {
    let joint = dice.below(4);
    let (a, b, bond) = sketch.joints[joint];
    let Bond::Pin(at) = bond else {
        return add_dyad(sketch, dice, [links[0], links[2]]);
    };
    // Its first joint is the one that is there.
    let mut bonds = ring(dice, &RINGS);
    let Some(first) = bonds.iter().position(|bond| matches!(bond, Bond::Pin(_))) else {
        return;
    };
    bonds.rotate_left(first);
    let Bond::Pin([x, y]) = bonds[0] else {
        return;
    };
    let bonds = moved(bonds, [at[0] - x, at[1] - y]);
    let ends = if dice.once_in(2) { [a, b] } else { [b, a] };
    let (c, d) = (sketch.link(), sketch.link());
    sketch.join(ends[1], c, bonds[1]);
    sketch.join(c, d, bonds[2]);
    sketch.join(d, ends[0], bonds[3]);
}

/// A wheel on one of the two links of a pin, tied to the other.
fn wheeled(
    sketch: &mut Sketch,
    dice: &mut Dice,
    joint: usize,
    ratios: &[[i64; 2]],
) -> Option<usize> {
    let (a, b, bond) = sketch.joints[joint];
    matches!(bond, Bond::Pin(_)).then(|| {
        let ends = if dice.once_in(2) { [a, b] } else { [b, a] };
        let teeth = *dice.pick(ratios);
        add_wheel(sketch, dice, ends, teeth)
    })
}

/// Equal cranks under a rail, one more than needed or two, any link as ground and any pin driven.
pub fn row(dice: &mut Dice) -> Sketch {
    let mut sketch = Sketch::default();
    let (rail, table) = (sketch.link(), sketch.link());
    let (u, v) = (signed(dice), signed(dice));
    let straight = dice.once_in(2);
    for number in 0..3 + dice.below(2) {
        let x = 2.0 * f64::from(u32::try_from(number).unwrap_or(0))
            + if straight { 0.0 } else { 0.25 * length(dice) };
        let y = if straight { 0.0 } else { signed(dice) };
        let crank = sketch.link();
        sketch.join(table, crank, Bond::Pin([x, y]));
        sketch.join(crank, rail, Bond::Pin([x + u, y + v]));
    }
    sketch.ground = dice.below(sketch.links);
    sketch.motors = vec![dice.below(sketch.joints.len())];
    sketch.allow = vec!["redundant"];
    let exact = dice.once_in(2);
    sketch.place(dice, exact);
    sketch
}

/// Gears of up to 25 : 1 before or behind four-bars and guides, equal or not.
pub fn fast(dice: &mut Dice) -> Sketch {
    let mut sketch = Sketch::default();
    let table = sketch.link();
    let first = sketch.link();
    let mut driver = first;
    let mut x = 0.0;
    sketch.join(table, first, Bond::Pin([0.0, 0.0]));
    for _ in 0..=dice.below(4) {
        x += 6.0;
        driver = match dice.below(4) {
            0 | 1 => {
                let wheel = sketch.link();
                sketch.join(table, wheel, Bond::Pin([x, 0.0]));
                let teeth = *dice.pick(&[[2, 1], [5, 2], [1, 2], [5, 1], [3, 1], [2, 5]]);
                let bond = rolling(dice, teeth, table);
                sketch.join(driver, wheel, bond);
                wheel
            }
            2 => guided(&mut sketch, dice, [table, driver], x - 6.0),
            _ => four_bar(&mut sketch, dice, [table, driver], x - 6.0),
        };
    }
    if dice.once_in(2) {
        four_bar(&mut sketch, dice, [table, driver], x);
    }
    sketch.motors = vec![0];
    let exact = dice.once_in(2);
    sketch.place(dice, exact);
    sketch
}

/// A guide that a crank's pin turns.
fn guided(sketch: &mut Sketch, dice: &mut Dice, [table, driver]: [usize; 2], x: f64) -> usize {
    let [u, v] = [signed(dice), signed(dice)];
    let guide = sketch.link();
    let pivot = [x + 0.7 * u * dice.between(-1.0, 1.0), 0.7 * v * dice.between(-1.0, 1.0)];
    let pin = [x + u, v];
    sketch.join(table, guide, Bond::Pin(pivot));
    sketch.join(driver, guide, Bond::Slot(pin, [pin[0] - pivot[0], pin[1] - pivot[1]]));
    guide
}

/// A four-bar: a parallelogram, one whose crank just goes round, or any.
fn four_bar(sketch: &mut Sketch, dice: &mut Dice, [table, driver]: [usize; 2], x: f64) -> usize {
    let [u, v] = [0.25 * signed(dice), 0.25 * signed(dice)];
    let (coupler, rocker) = (sketch.link(), sketch.link());
    let pin = [x + u, v];
    let (top, pivot) = match dice.below(3) {
        0 => {
            let apart = [length(dice), signed(dice)];
            ([pin[0] + apart[0], pin[1] + apart[1]], [x + apart[0], apart[1]])
        }
        1 => ([x + 3.0 + dice.between(-0.5, 0.5), 2.0 + dice.between(-0.5, 0.5)], [x + 3.0, -0.5]),
        _ => ([x + signed(dice), signed(dice)], [x + 2.0 + length(dice), signed(dice)]),
    };
    sketch.join(driver, coupler, Bond::Pin(pin));
    sketch.join(coupler, rocker, Bond::Pin(top));
    sketch.join(table, rocker, Bond::Pin(pivot));
    rocker
}

/// Anything that grows, as it has grown or with any other joints driven and any link as ground.
pub fn generic(dice: &mut Dice) -> Sketch {
    let additions = 1 + dice.below(6);
    let model = grow(dice, additions).model;
    let mut sketch = Sketch::of(&model);
    // Hidden joints, those of dies, are no joints of a sketch.
    let shown = |motor: &Motor| {
        let before = model.joints[..motor.joint.index()].iter();
        before.filter(|joint| !joint.hidden).count()
    };
    sketch.motors = model.motors.iter().map(shown).collect();
    if dice.once_in(2) {
        sketch.ground = dice.below(sketch.links);
    }
    if dice.once_in(2) {
        let number = dice.below(sketch.motors.len());
        let motor = sketch.any_motor(dice);
        if !sketch.motors.contains(&motor) {
            sketch.motors[number] = motor;
        }
    }
    sketch
}
