//! The equations of loops: the vectors round each ring add to zero.
//!
//! Of the unknown coordinates, those of sliding joints remain, and those of turning ones are replaced by the directions of
//! the clusters between them. For a loop of three unknowns the angle row of the 3×3 system (its entries are 0 and 1) is thereby
//! already eliminated: two unknowns and two equations remain.

use super::algebra::Algebra;
use super::placement::Placement;
use super::step::{Connection, ConnectionKind, Loop};
use super::unknown::{Solution, Unknown};
use crate::bug::bug;
use crate::model::LinkId;

/// The equations of a loop: the vectors round each of its rings must add to zero.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Equation<S> {
    /// One for each ring.
    pub(crate) rings: Vec<Ring<S>>,
    /// The unknowns, directions first.
    pub(crate) unknowns: Vec<Unknown>,
    /// The direction of each cluster relative to the first, by its base.
    classes: Vec<(LinkId, Class<S>)>,
}

/// The vectors round a ring: what is known, arms turned by unknown directions, and unknown displacements.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Ring<S> {
    /// The sum of what is known, in the frame of the first cluster.
    pub(crate) offset: [S; 2],
    /// A vector at right angles to it, if it is a [chord](super::placement::Chord).
    pub(crate) across: Option<[S; 2]>,
    /// For each unknown that is a direction, the sum of everything that turns with it, in its own frame.
    pub(crate) arms: Vec<Option<[S; 2]>>,
    /// The slides in the ring.
    pub(crate) slides: Vec<Slide<S>>,
}

impl<S: Copy> Ring<S> {
    /// Whether a dyad closes where the ends of what is known meet: its arms are equal, or its line goes through its pin.
    fn may_meet(&self, algebra: &impl Algebra<S>) -> bool {
        const EQUAL: f64 = 1e-9;
        let at_start = |[x, y]: [S; 2]| [x, y].map(|part| algebra.number_at_start(part));
        let arms: Vec<[f64; 2]> = self.arms.iter().flatten().copied().map(at_start).collect();
        match (&arms[..], &self.slides[..]) {
            ([[a, b], [c, d]], []) => {
                let lengths = [a.hypot(*b), c.hypot(*d)];
                (lengths[0] - lengths[1]).abs() <= EQUAL * (lengths[0] + lengths[1])
            }
            ([], [slide]) => slide.turned_by.is_some(),
            ([[a, b]], [slide]) if slide.turned_by.is_some() => {
                let [cos, sin] = at_start(slide.along);
                (cos * b - sin * a).abs() <= EQUAL * a.hypot(*b)
            }
            _ => false,
        }
    }
}

/// A slide in a ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Slide<S> {
    /// The number of the unknown that its coordinate is.
    pub(crate) unknown: usize,
    /// The direction in which one goes when the coordinate grows: in the first cluster's frame, or in the frame of the
    /// cluster that turns it.
    pub(crate) along: [S; 2],
    /// The unknown direction that turns it, if one does.
    pub(crate) turned_by: Option<usize>,
}

/// The direction of a cluster relative to the first.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Class<S> {
    /// The unknown that turns it; none if its direction is known.
    unknown: Option<usize>,
    /// The constant part of its direction.
    turn: [S; 2],
}

/// The residuals of all rings.
#[derive(Clone, Debug)]
pub(crate) struct Residuals<S> {
    /// One for each ring.
    pub(crate) rings: Vec<RingResidual<S>>,
}

impl<S: Copy> Residuals<S> {
    /// The gaps of all rings, in scene units.
    pub(crate) fn gap(&self) -> Vec<S> {
        self.rings.iter().flat_map(|ring| ring.gap).collect()
    }

    /// The vectors that all gaps are made of.
    pub(crate) fn sides(&self) -> Vec<[S; 2]> {
        let sides = self.rings.iter().flat_map(|ring| &ring.sides);
        sides.map(|(_, side)| *side).collect()
    }
}

/// The residual of a ring.
#[derive(Clone, Debug)]
pub(crate) struct RingResidual<S> {
    /// The gap of the ring, in scene units.
    pub(crate) gap: [S; 2],
    /// The rate of the gap with each unknown: with the angle of a direction, or with a displacement.
    pub(crate) columns: Vec<[S; 2]>,
    /// The vectors that add to the gap, each with the unknown direction that turns it, if one does.
    pub(crate) sides: Vec<(Option<usize>, [S; 2])>,
}

impl<S: Copy + PartialEq> Equation<S> {
    /// Sets up the equations of a loop.
    pub(crate) fn new(
        algebra: &mut impl Algebra<S>,
        placement: &Placement<'_, S>,
        closing: &Loop,
    ) -> Self {
        let (classes, mut unknowns) = classes(algebra, placement, closing);
        for connection in closing.rings.iter().flatten() {
            let unknown = Unknown::Slide(connection.joint);
            if connection.slides() && !unknowns.contains(&unknown) {
                unknowns.push(unknown);
            }
        }
        let mut equation = Self { rings: Vec::new(), unknowns, classes };
        for ring in &closing.rings {
            let ring = equation.ring(algebra, placement, ring);
            equation.rings.push(ring);
        }
        equation
    }

    fn ring(
        &self,
        algebra: &mut impl Algebra<S>,
        placement: &Placement<'_, S>,
        ring: &[Connection],
    ) -> Ring<S> {
        let mut offset = algebra.vector([0.0, 0.0]);
        let mut arms: Vec<Option<[S; 2]>> = vec![None; self.unknowns.len()];
        let mut slides = Vec::new();
        let mut known = Vec::new();
        for (index, connection) in ring.iter().enumerate() {
            let before = ring[(index + ring.len() - 1) % ring.len()];
            let Some(class) = class_of(&self.classes, placement.base(connection.from)) else {
                continue;
            };
            let span = placement.span(algebra, before.to, connection.from);
            let part = algebra.rotate(class.turn, span);
            match class.unknown {
                None => {
                    offset = algebra.plus(offset, part);
                    known.push((class.turn, before.to, connection.from));
                }
                Some(unknown) => extend(algebra, &mut arms[unknown], part),
            }
            let slide = Unknown::Slide(connection.joint);
            if let (ConnectionKind::Prismatic, Some(unknown)) =
                (connection.kind, self.unknowns.iter().position(|unknown| *unknown == slide))
            {
                let heading = placement.heading(algebra, connection.from);
                let [x, y] = algebra.rotate(class.turn, heading);
                let along = if placement.as_declared(*connection) {
                    [x, y]
                } else {
                    [algebra.neg(x), algebra.neg(y)]
                };
                slides.push(Slide { unknown, along, turned_by: class.unknown });
            }
        }
        let mut ring = Ring { offset, across: None, arms, slides };
        if let [(turn, from, to)] = known[..]
            && ring.may_meet(algebra)
            && let Some(chord) = placement.chord(algebra, from, to)
        {
            ring.offset = algebra.rotate(turn, chord.vector);
            ring.across = Some(algebra.rotate(turn, chord.across));
        }
        ring
    }

    /// The same equation with other quantities in place of its own, such as their rates.
    pub(crate) fn map(&self, mut other: impl FnMut(S) -> S) -> Self {
        let mut both = |v: [S; 2]| v.map(&mut other);
        let rings = self.rings.iter().map(|ring| Ring {
            offset: both(ring.offset),
            across: ring.across.map(&mut both),
            arms: ring.arms.iter().map(|arm| arm.map(&mut both)).collect(),
            slides: ring
                .slides
                .iter()
                .map(|slide| Slide { along: both(slide.along), ..*slide })
                .collect(),
        });
        Self {
            rings: rings.collect(),
            unknowns: self.unknowns.clone(),
            classes: self.classes.clone(),
        }
    }

    /// The residuals at these values of the unknowns.
    pub(crate) fn residuals(
        &self,
        algebra: &mut impl Algebra<S>,
        now: &[Solution<S>],
    ) -> Residuals<S> {
        let rings = self.rings.iter().map(|ring| self.ring_residual(algebra, ring, now)).collect();
        Residuals { rings }
    }

    fn ring_residual(
        &self,
        algebra: &mut impl Algebra<S>,
        ring: &Ring<S>,
        now: &[Solution<S>],
    ) -> RingResidual<S> {
        let zero = algebra.vector([0.0, 0.0]);
        let mut gap = ring.offset;
        let mut sides = vec![(None, ring.offset)];
        let mut columns = vec![zero; self.unknowns.len()];
        let mut arms = ring.arms.clone();
        for slide in &ring.slides {
            let Solution::Slide(displacement) = now[slide.unknown] else {
                continue;
            };
            let part = algebra.scale(displacement, slide.along);
            let turning = slide.turned_by.map(|turning| (turning, &now[turning]));
            if let Some((turning, Solution::Direction(direction))) = turning {
                extend(algebra, &mut arms[turning], part);
                let rate = algebra.rotate(*direction, slide.along);
                columns[slide.unknown] = algebra.plus(columns[slide.unknown], rate);
            } else {
                gap = algebra.plus(gap, part);
                sides.push((None, part));
                columns[slide.unknown] = algebra.plus(columns[slide.unknown], slide.along);
            }
        }
        for (unknown, arm) in arms.into_iter().enumerate() {
            if let (Some(arm), Solution::Direction(direction)) = (arm, now[unknown]) {
                let side = algebra.rotate(direction, arm);
                gap = algebra.plus(gap, side);
                sides.push((Some(unknown), side));
                columns[unknown] = [algebra.neg(side[1]), side[0]];
            }
        }
        RingResidual { gap, columns, sides }
    }

    /// Places the clusters by the solution: they become one.
    pub(crate) fn place(
        &self,
        algebra: &mut impl Algebra<S>,
        placement: &mut Placement<'_, S>,
        closing: &Loop,
        solution: &[Solution<S>],
    ) {
        for connection in &closing.tree {
            match connection.kind {
                ConnectionKind::Revolute => {
                    let Some(class) = class_of(&self.classes, placement.base(connection.to)) else {
                        continue;
                    };
                    let direction = match class.unknown.map(|unknown| solution[unknown]) {
                        Some(Solution::Direction(direction)) => {
                            algebra.rotate(direction, class.turn)
                        }
                        _ => class.turn,
                    };
                    let direction = self.seen_from_cluster(algebra, placement, direction);
                    placement.pivot(algebra, *connection, direction);
                }
                ConnectionKind::Prismatic => {
                    let slide = Unknown::Slide(connection.joint);
                    let found = self.unknowns.iter().position(|unknown| *unknown == slide);
                    if let Some(Solution::Slide(displacement)) =
                        found.map(|unknown| solution[unknown])
                    {
                        let displacement = if placement.as_declared(*connection) {
                            displacement
                        } else {
                            algebra.neg(displacement)
                        };
                        placement.connect(algebra, *connection, Solution::Slide(displacement));
                    }
                }
            }
        }
    }
}

impl<S: Copy> Equation<S> {
    /// A direction given relative to the first cluster of the loop, as seen from the base that this cluster has by now. Merging may have
    /// given it a lower one.
    fn seen_from_cluster(
        &self,
        algebra: &mut impl Algebra<S>,
        placement: &Placement<'_, S>,
        direction: [S; 2],
    ) -> [S; 2] {
        let Some((first, _)) = self.classes.first() else {
            bug!("a loop without clusters is placed");
        };
        if placement.clusters.base(*first) == *first {
            return direction;
        }
        algebra.rotate(placement.pose(*first).direction, direction)
    }
}

impl Equation<f64> {
    /// For each unknown direction the one that it has where clusters have these angles. Any cluster that slides with it may give it.
    pub(super) fn directions(
        &self,
        angle: impl Fn(LinkId) -> Option<f64>,
    ) -> Vec<Option<[f64; 2]>> {
        let of_class = |unknown: Option<usize>| {
            let mut alike = self.classes.iter().filter(|(_, class)| class.unknown == unknown);
            alike.find_map(|(base, class)| {
                let [cos, sin] = class.turn;
                Some(angle(*base)? - sin.atan2(cos))
            })
        };
        let direction = |unknown| {
            let (sin, cos) = (of_class(Some(unknown))? - of_class(None)?).sin_cos();
            Some([cos, sin])
        };
        (0..self.unknowns.len()).map(direction).collect()
    }
}

/// Adds a part to an arm.
fn extend<S: Copy>(algebra: &mut impl Algebra<S>, arm: &mut Option<[S; 2]>, part: [S; 2]) {
    *arm = Some(arm.map_or(part, |arm| algebra.plus(arm, part)));
}

/// The directions of a loop's clusters relative to the first, and the unknowns among them.
fn classes<S: Copy>(
    algebra: &mut impl Algebra<S>,
    placement: &Placement<'_, S>,
    closing: &Loop,
) -> (Vec<(LinkId, Class<S>)>, Vec<Unknown>) {
    let one = algebra.vector([1.0, 0.0]);
    let mut unknowns = Vec::new();
    let Some(first) = closing.tree.first().map(|connection| placement.base(connection.from)) else {
        return (Vec::new(), unknowns);
    };
    let mut classes = vec![(first, Class { unknown: None, turn: one })];
    let slides: Vec<Connection> = closing
        .rings
        .iter()
        .flatten()
        .filter(|connection| connection.slides())
        .flat_map(|&connection| [connection, connection.reverse()])
        .collect();
    spread(algebra, placement, &slides, &mut classes);
    for connection in &closing.tree {
        let base = placement.base(connection.to);
        if class_of(&classes, base).is_none() {
            classes.push((base, Class { unknown: Some(unknowns.len()), turn: one }));
            unknowns.push(Unknown::Direction(base));
            spread(algebra, placement, &slides, &mut classes);
        }
    }
    (classes, unknowns)
}

/// The direction of the cluster with this base, if it is known.
fn class_of<S: Copy>(classes: &[(LinkId, Class<S>)], base: LinkId) -> Option<Class<S>> {
    let mut known = classes.iter().filter(|(known, _)| *known == base);
    known.next().map(|(_, class)| *class)
}

/// Spreads classes over slides: a cluster that slides on one of known class is of that class too.
fn spread<S: Copy>(
    algebra: &mut impl Algebra<S>,
    placement: &Placement<'_, S>,
    slides: &[Connection],
    classes: &mut Vec<(LinkId, Class<S>)>,
) {
    let mut grown = true;
    while std::mem::take(&mut grown) {
        for &connection in slides {
            let (from, to) = (placement.base(connection.from), placement.base(connection.to));
            if let (Some(class), None) = (class_of(classes, from), class_of(classes, to)) {
                let turn = across_slide(algebra, placement, connection);
                let turn = algebra.rotate(class.turn, turn);
                classes.push((to, Class { turn, ..class }));
                grown = true;
            }
        }
    }
}

/// The direction of the base of the second cluster relative to that of the first: sliding keeps it.
fn across_slide<S: Copy>(
    algebra: &mut impl Algebra<S>,
    placement: &Placement<'_, S>,
    connection: Connection,
) -> [S; 2] {
    let from = placement.heading(algebra, connection.from);
    let to = placement.heading(algebra, connection.to);
    let back = algebra.conjugate(to);
    algebra.rotate(from, back)
}
