//! Random mechanisms as text: the inside of a `mechanism!`, grown addition by addition, so that proptest can shrink them.

use super::page::Page;
use proptest::prelude::*;
use std::fmt::Write as _;

/// What is added to a drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Crank,
    Slider,
    Rrr,
    Rrp,
    Rpr,
    Prr,
    Prp,
    Rpp,
    Slot,
    /// A parallelogram on a crank that is there, or what nearly is one: its change points are narrow dead zones then.
    Parallelogram,
    Gear,
    Belt,
    Rack,
    Cam,
    /// A platform on three legs.
    Triad,
    /// Four links pinned in a ring, two of them also to what is there.
    Ring,
    /// A five-bar two of whose links are geared to each other.
    Tied,
    /// A ring with a slide in it whose slider a rack ties to the ground or to another link.
    TiedRack,
}

/// An addition: whatever its kind needs is taken from these numbers.
#[derive(Clone, Debug)]
pub(crate) struct Addition {
    pub(crate) kind: Kind,
    /// Which of what is there.
    pub(crate) picks: [usize; 3],
    pub(crate) points: [[f64; 2]; 6],
    pub(crate) angles: [f64; 3],
    /// Which ratio, radius or law.
    pub(crate) choice: usize,
    pub(crate) flips: [bool; 2],
}

/// A drawing.
#[derive(Clone, Debug)]
pub(crate) struct Drawing {
    pub(crate) additions: Vec<Addition>,
    /// The distance of the lattice on which all coordinates lie.
    pub(crate) lattice: f64,
    /// More motors than these are not drawn.
    pub(crate) motors: usize,
}

/// A drawn mechanism.
#[derive(Clone, Debug)]
pub(crate) struct Drawn {
    pub(crate) text: String,
    /// For each motor its joint, and whether it slides.
    pub(crate) motors: Vec<(String, bool)>,
}

fn kinds() -> impl Strategy<Value = Kind> {
    prop_oneof![
        8 => Just(Kind::Rrr),
        1 => Just(Kind::Crank),
        1 => Just(Kind::Slider),
        2 => Just(Kind::Rrp),
        2 => Just(Kind::Rpr),
        1 => Just(Kind::Prr),
        1 => Just(Kind::Prp),
        1 => Just(Kind::Rpp),
        2 => Just(Kind::Slot),
        4 => Just(Kind::Parallelogram),
        4 => Just(Kind::Gear),
        1 => Just(Kind::Belt),
        2 => Just(Kind::Rack),
        1 => Just(Kind::Cam),
    ]
}

fn waiting() -> impl Strategy<Value = Kind> {
    prop_oneof![
        4 => Just(Kind::Triad),
        2 => Just(Kind::Ring),
        3 => Just(Kind::Tied),
        2 => Just(Kind::TiedRack),
    ]
}

fn addition(kind: impl Strategy<Value = Kind>) -> impl Strategy<Value = Addition> {
    let point = || prop::array::uniform2(-4.0..4.0_f64);
    (
        kind,
        prop::array::uniform3(0..1000_usize),
        prop::array::uniform6(point()),
        prop::array::uniform3(-3.1..3.1_f64),
        0..240_usize,
        prop::array::uniform2(any::<bool>()),
    )
        .prop_map(|(kind, picks, points, angles, choice, flips)| Addition {
            kind,
            picks,
            points,
            angles,
            choice,
            flips,
        })
}

/// Where the coordinates lie: in general position, or so that special geometry is common.
fn lattices() -> impl Strategy<Value = f64> {
    prop_oneof![2 => Just(0.01), 1 => Just(1.0), 1 => Just(1e-12)]
}

/// Mechanisms whose loops are all solved one after another.
pub(crate) fn sequential(most: usize) -> impl Strategy<Value = Drawing> {
    let additions = prop::collection::vec(addition(kinds()), 1..=most);
    (additions, lattices(), 1..=3_usize).prop_map(|(additions, lattice, motors)| Drawing {
        additions,
        lattice,
        motors,
    })
}

/// Mechanisms with loops that wait for each other.
pub(crate) fn coupled() -> impl Strategy<Value = Drawing> {
    let before = prop::collection::vec(addition(kinds()), 0..=2);
    let after = prop::collection::vec(addition(kinds()), 0..=2);
    (before, addition(waiting()), after, lattices(), 1..=2_usize).prop_map(
        |(mut additions, waiting, after, lattice, motors)| {
            additions.push(waiting);
            additions.extend(after);
            Drawing {
                additions,
                lattice,
                motors,
            }
        },
    )
}

impl Drawing {
    /// Its text.
    pub(crate) fn drawn(&self) -> Drawn {
        let mut page = Page {
            lattice: self.lattice,
            links: 0,
            joints: 0,
            lines: String::new(),
            motors: Vec::new(),
            pivots: Vec::new(),
            places: Vec::new(),
            slides: Vec::new(),
            coupled: false,
        };
        let first = self.additions.first();
        let [at, along] = first.map_or([[0.0, 0.0], [1.0, 0.0]], |first| {
            [
                page.point(first.points[5]),
                page.direction(first.angles[2], first.choice),
            ]
        });
        let slides = first.is_some_and(|first| first.choice % 7 == 0);
        page.driven(0, at, slides.then_some(along));
        for addition in &self.additions {
            page.add(addition, self.motors);
        }
        let mut text = format!("struct M;\n{}", page.lines);
        for (motor, _) in &page.motors {
            let _ = writeln!(text, "motor {motor};");
        }
        if page.coupled {
            text += "allow coupled;\n";
        }
        Drawn {
            text,
            motors: page.motors,
        }
    }
}
