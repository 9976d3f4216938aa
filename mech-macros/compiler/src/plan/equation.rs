//! The closure of a loop: the way round is zero.
//!
//! Of the three unknown coordinates, those of sliding joints are kept, and of the turning ones all but one are replaced
//! by the directions of the clusters between them. The angle row of the 3×3 system (its entries are 0 and 1) is thereby
//! already eliminated: two unknowns and two equations remain.

use super::algebra::Algebra;
use super::placement::{Coordinate, Placement};
use super::step::{Connection, ConnectionKind, Loop};

/// What is unknown in a loop.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Unknown<S> {
    /// The direction of the base of the second (1) or third (2) cluster of the ring, seen from the first.
    Direction {
        /// Which cluster.
        cluster: usize,
        /// The way across everything that turns with it, in the cluster's own frame.
        arm: [S; 2],
    },
    /// The coordinate of a sliding connection.
    Slide {
        /// Which connection of the ring.
        connection: usize,
        /// The direction in which the joint's own coordinate grows, for one who walks the ring: in the first cluster's
        /// frame, or in the frame of the turning cluster.
        along: [S; 2],
        /// The unknown, if any, whose direction turns it.
        turned_by: Option<usize>,
    },
}

/// The way round a loop: `offset` and what the unknowns add to it must come to zero.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Equation<S> {
    /// What is known of the way round, in the frame of the first cluster.
    pub(crate) offset: [S; 2],
    /// The two unknowns, directions first.
    pub(crate) unknowns: [Unknown<S>; 2],
    /// For the second and the third cluster what its direction is: `turn` times that of an unknown, or `turn` itself.
    classes: [Class<S>; 3],
}

/// How a cluster is turned relative to the first.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Class<S> {
    /// The unknown that turns it; none if its direction is known.
    unknown: Option<usize>,
    /// The constant part of its direction.
    turn: [S; 2],
}

impl<S: Copy + PartialEq> Equation<S> {
    /// Sets up the equation of a loop. Gives none if the ring has no two unknowns, which a ring of three joints of which
    /// at least one turns always has.
    pub(crate) fn new<A: Algebra<Scalar = S>>(
        algebra: &mut A,
        placement: &Placement<'_, S>,
        ring: &Loop,
    ) -> Option<Self> {
        let [first, second, third] = ring.ring;
        let (classes, turning) = classes(algebra, placement, [first, second, third]);
        let spans = [
            placement.span(algebra, third.to, first.from),
            placement.span(algebra, first.to, second.from),
            placement.span(algebra, second.to, third.from),
        ];
        let mut offset = spans[0];
        let mut arms = vec![None; turning.len()];
        for (span, class) in spans.into_iter().zip(classes).skip(1) {
            let part = algebra.turned(class.turn, span);
            match class.unknown {
                None => offset = algebra.plus(offset, part),
                Some(index) => {
                    arms[index] = Some(match arms[index] {
                        None => part,
                        Some(arm) => algebra.plus(arm, part),
                    });
                }
            }
        }
        let mut unknowns = Vec::new();
        for (cluster, arm) in turning.into_iter().zip(arms) {
            unknowns.push(Unknown::Direction { cluster, arm: arm? });
        }
        for (index, connection) in [first, second, third].into_iter().enumerate() {
            if connection.kind == ConnectionKind::Prismatic {
                let class = classes[index];
                let heading = placement.heading(algebra, connection.from);
                let [x, y] = algebra.turned(class.turn, heading);
                let along = if placement.as_declared(connection) {
                    [x, y]
                } else {
                    [algebra.neg(x), algebra.neg(y)]
                };
                unknowns.push(Unknown::Slide {
                    connection: index,
                    along,
                    turned_by: class.unknown,
                });
            }
        }
        let unknowns = <[Unknown<S>; 2]>::try_from(unknowns).ok()?;
        Some(Self {
            offset,
            unknowns,
            classes,
        })
    }

    /// Puts the solution into effect: the three clusters become one.
    pub(crate) fn place<A: Algebra<Scalar = S>>(
        &self,
        algebra: &mut A,
        placement: &mut Placement<'_, S>,
        ring: &Loop,
        solution: [Solution<S>; 2],
    ) {
        let [first, _, third] = ring.ring;
        // Both are connected to the first cluster, whose base has the lowest number of the three and so stays.
        self.place_one(algebra, placement, (first, 0), 1, solution);
        self.place_one(algebra, placement, (third.reversed(), 2), 2, solution);
    }

    fn place_one<A: Algebra<Scalar = S>>(
        &self,
        algebra: &mut A,
        placement: &mut Placement<'_, S>,
        (connection, index): (Connection, usize),
        cluster: usize,
        solution: [Solution<S>; 2],
    ) {
        match connection.kind {
            ConnectionKind::Revolute => {
                let class = self.classes[cluster];
                let direction = match class.unknown.map(|unknown| solution[unknown]) {
                    Some(Solution::Direction(direction)) => algebra.turned(direction, class.turn),
                    _ => class.turn,
                };
                placement.pivot(algebra, connection, direction);
            }
            ConnectionKind::Prismatic => {
                let is_this = |unknown: &Unknown<S>| matches!(unknown, Unknown::Slide { connection, .. } if *connection == index);
                let found = self
                    .unknowns
                    .iter()
                    .position(is_this)
                    .map(|unknown| solution[unknown]);
                if let Some(Solution::Slide(way)) = found {
                    let way = if placement.as_declared(connection) {
                        way
                    } else {
                        algebra.neg(way)
                    };
                    placement.connect(algebra, connection, Coordinate::Slide(way));
                }
            }
        }
    }
}

/// The value of an unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Solution<S> {
    /// A unit vector.
    Direction([S; 2]),
    /// A length.
    Slide(S),
}

/// How the clusters of a ring are turned relative to the first, and which of them turn by themselves.
fn classes<A: Algebra<Scalar = S>, S: Copy>(
    algebra: &mut A,
    placement: &Placement<'_, S>,
    [first, second, third]: [Connection; 3],
) -> ([Class<S>; 3], Vec<usize>) {
    let one = algebra.vector([1.0, 0.0]);
    let mut known: [Option<Class<S>>; 3] = [
        Some(Class {
            unknown: None,
            turn: one,
        }),
        None,
        None,
    ];
    let mut turning = Vec::new();
    let slides = [(0, first, 1), (1, second, 2), (2, third, 0)];
    for start in 0..3 {
        if known[start].is_none() {
            known[start] = Some(Class {
                unknown: Some(turning.len()),
                turn: one,
            });
            turning.push(start);
        }
        // Twice, because the way from the first to the second may lead over the third.
        for (from, connection, to) in slides.into_iter().chain(slides) {
            if connection.kind == ConnectionKind::Prismatic {
                for (from, connection, to) in
                    [(from, connection, to), (to, connection.reversed(), from)]
                {
                    if let (Some(class), None) = (known[from], known[to]) {
                        let turn = across_slide(algebra, placement, connection);
                        known[to] = Some(Class {
                            turn: algebra.turned(class.turn, turn),
                            ..class
                        });
                    }
                }
            }
        }
    }
    (
        known.map(|class| {
            class.unwrap_or(Class {
                unknown: None,
                turn: one,
            })
        }),
        turning,
    )
}

/// The direction of the base of the second cluster relative to that of the first: sliding keeps it.
fn across_slide<A: Algebra<Scalar = S>, S: Copy>(
    algebra: &mut A,
    placement: &Placement<'_, S>,
    connection: Connection,
) -> [S; 2] {
    let from = placement.heading(algebra, connection.from);
    let to = placement.heading(algebra, connection.to);
    let back = algebra.conjugate(to);
    algebra.turned(from, back)
}
