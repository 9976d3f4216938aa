//! The equations of the joints for rates, at random geometry of the declared kinds.
//!
//! Links that can only slide on each other, or are welded, keep their direction: they form an angle class and share one
//! angular rate.
//! The unknowns are one angular rate for each class but the ground's, and the two rates of the origin of each moving
//! link. A revolute joint or a weld then says two things about them, a prismatic joint and
//! whatever rolls one each.

use super::Structure;
use super::elimination::Sparse;
use super::field::{Dice, Element};
use super::rolling::{Factor, Rolling, RollingEnd};
use crate::bug::bug;
use crate::model::{JointId, JointKind, LinkId, Model};
use petgraph::unionfind::UnionFind;
use std::collections::BTreeMap;

/// The unknowns, and the random geometry.
pub(crate) struct Constraints<'m> {
    model: &'m Model,
    rollings: &'m [Rolling],
    /// For each link the columns of its angular rate and of its origin's rates; none for what is fixed.
    columns: Vec<Columns>,
    count: usize,
    /// For each joint a random point (revolute) or direction (prismatic); joints on one pin share theirs, and slides that stay
    /// parallel.
    spots: Vec<(Element, Element)>,
}

#[derive(Clone, Copy)]
struct Columns {
    turn: Option<usize>,
    x: Option<usize>,
    y: Option<usize>,
}

impl<'m> Constraints<'m> {
    pub(crate) fn new(model: &'m Model, structure: &'m Structure, dice: &mut Dice) -> Self {
        let (columns, count) = columns(model);
        Self {
            model,
            rollings: &structure.rollings,
            columns,
            count,
            spots: spots(model, structure, dice),
        }
    }

    /// The number of unknowns.
    pub(crate) fn unknowns(&self) -> usize {
        self.count
    }

    /// The rows that a joint adds.
    pub(crate) fn of_joint(&self, id: JointId) -> Vec<Sparse> {
        let (a, b) = self.model.ends(id);
        let (p, q) = self.spots[id.index()];
        match self.model.joint(id).kind {
            // The rate of the point (p, q) of a link is (x − turn · q, y + turn · p).
            JointKind::Revolute(..) | JointKind::Weld(..) => {
                let horizontal = self.difference(a, b, [-q, Element::ONE, Element::ZERO]);
                let vertical = self.difference(a, b, [p, Element::ZERO, Element::ONE]);
                vec![horizontal, vertical]
            }
            JointKind::Prismatic(..) => vec![self.difference(a, b, [Element::ZERO, -q, p])],
            JointKind::Gear { .. } | JointKind::Belt { .. } | JointKind::Rack { .. } => {
                let here = self.rollings.iter().filter(|rolling| rolling.joint == id);
                here.map(|rolling| self.of_rolling(rolling)).collect()
            }
            JointKind::Cam { shaft, follower, law } => {
                // At a random place a law has a random slope, unless it has none.
                let slope = if self.model.law(law).varies() { p } else { Element::ZERO };
                let mut row = self.rate_of_coordinate(follower);
                let turning = self.rate_of_coordinate(shaft).into_iter();
                row.extend(turning.map(|(column, value)| (column, -(slope * value))));
                vec![row]
            }
        }
    }

    /// The row whose value is the rate of this joint's coordinate; none for what has no coordinate.
    pub(crate) fn rate(&self, id: JointId) -> Option<Sparse> {
        let (a, b) = self.model.ends(id);
        match self.model.joint(id).kind {
            JointKind::Revolute(..) => {
                Some(self.difference(a, b, [Element::ONE, Element::ZERO, Element::ZERO]))
            }
            JointKind::Prismatic(..) => {
                let (p, q) = self.spots[id.index()];
                Some(self.difference(a, b, [Element::ZERO, p, q]))
            }
            _ => None,
        }
    }

    /// The same of a joint that turns or slides.
    pub(crate) fn rate_of_coordinate(&self, id: JointId) -> Sparse {
        let Some(rate) = self.rate(id) else {
            let name = &self.model.joint(id).name;
            bug!("joint `{name}` has no coordinate and is asked for its rate");
        };
        rate
    }

    /// The rates of a link in a motion: of its angle and of its origin.
    pub(crate) fn of_link(&self, link: LinkId, motion: &[Element]) -> [Element; 3] {
        let columns = self.columns[link.index()];
        [columns.turn, columns.x, columns.y]
            .map(|column| column.map_or(Element::ZERO, |column| motion[column]))
    }

    /// `factors · (rates of b − rates of a)`.
    fn difference(&self, a: LinkId, b: LinkId, factors: [Element; 3]) -> Sparse {
        let mut row = self.weighted_row(b, factors);
        row.extend(self.weighted_row(a, factors.map(|factor| -factor)));
        row
    }

    fn weighted_row(&self, link: LinkId, factors: [Element; 3]) -> Sparse {
        let columns = self.columns[link.index()];
        let columns = [columns.turn, columns.x, columns.y];
        columns
            .into_iter()
            .zip(factors)
            .filter_map(|(column, factor)| Some((column?, factor)))
            .collect()
    }

    /// Rolling: the coordinates of both parts, seen from the carrier, times their factors, sum to a constant.
    fn of_rolling(&self, rolling: &Rolling) -> Sparse {
        let mut row = Sparse::new();
        for (end, factor) in rolling.ends {
            let factor = Element::from(factor);
            match end {
                RollingEnd::Wheel(wheel) => {
                    let turn = [factor, Element::ZERO, Element::ZERO];
                    row.extend(self.difference(rolling.carrier, wheel, turn));
                }
                RollingEnd::Bar { slide, forwards, .. } => {
                    let factor = if forwards { factor } else { -factor };
                    let rate = self.rate_of_coordinate(slide);
                    row.extend(rate.into_iter().map(|(column, value)| (column, factor * value)));
                }
            }
        }
        row
    }
}

impl From<Factor> for Element {
    fn from(factor: Factor) -> Self {
        match factor {
            Factor::Whole(value) => Self::from(value),
            Factor::Float(value) => Self::from(value),
        }
    }
}

fn columns(model: &Model) -> (Vec<Columns>, usize) {
    let mut classes = UnionFind::<usize>::new(model.links.len());
    for id in model.joint_ids() {
        if let JointKind::Prismatic(..) | JointKind::Weld(..) = model.joint(id).kind {
            let (a, b) = model.ends(id);
            classes.union(a.index(), b.index());
        }
    }
    let mut count = 0;
    let mut next = || {
        count += 1;
        Some(count - 1)
    };
    let ground = classes.find(0);
    let mut turns: Vec<Option<usize>> = vec![None; model.links.len()];
    let mut columns = vec![Columns { turn: None, x: None, y: None }];
    for link in model.moving_links() {
        let class = classes.find(link.index());
        if class != ground && turns[class].is_none() {
            turns[class] = next();
        }
        columns.push(Columns { turn: turns[class], x: next(), y: next() });
    }
    (columns, count)
}

fn spots(model: &Model, structure: &Structure, dice: &mut Dice) -> Vec<(Element, Element)> {
    let mut spots: Vec<_> = model.joints.iter().map(|_| (dice.roll(), dice.roll())).collect();
    for pin in &structure.pins {
        for pair in pin.joints.windows(2) {
            spots[pair[1].index()] = spots[pair[0].index()];
        }
    }
    let mut directions: BTreeMap<usize, (Element, Element)> = BTreeMap::new();
    for joint in model.joint_ids() {
        if let Some(heading) = structure.parallels.of(joint) {
            let spot = &mut spots[joint.index()];
            let (p, q) = *directions.entry(heading.number).or_insert(*spot);
            *spot = if heading.forwards { (p, q) } else { (-p, -q) };
        }
    }
    spots
}
