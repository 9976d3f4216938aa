//! Guides that may have been forgotten: slots where one motor seems to be missing, slides on the ground where two do.

use super::declaration::{Declaration, Ends, NewJoint, NewNames, Purpose};
use super::sketch::{FEW, NEAR, Sketch, distance, leaves};
use super::tie::{Joined, both, gaps};
use super::tie::{Tie, ties};
use super::union::between;
use super::{NewKind, Repair};
use crate::model::{JointId, JointKind, LinkId, Model};
use std::collections::BTreeSet;

/// A line is through a place that is no farther away than this part of the size.
const IN_LINE: f64 = 0.01;
/// Names of links that slide.
const SLIDERS: [&str; 12] = [
    "block",
    "slider",
    "slide",
    "piston",
    "ram",
    "crosshead",
    "valve",
    "plunger",
    "needle",
    "carriage",
    "cart",
    "table",
];

/// Whether the name of a link says that it slides.
pub(super) fn is_slider(model: &Model, link: LinkId) -> bool {
    let name = &model.link(link).name;
    SLIDERS.iter().any(|word| name.contains(word))
}

/// A drawing, as far as it tells where guides are.
pub(super) struct Guides<'m> {
    model: &'m Model,
    sketch: &'m Sketch,
    ties: Vec<Tie>,
    joined: Joined,
    /// The links of the joints that are free.
    loose: BTreeSet<LinkId>,
    /// The links that hang on one joint, each with that.
    leaves: Vec<(LinkId, JointId)>,
}

/// A guide, and how likely it is.
type Guess = (f64, NewKind, [LinkId; 2], [f64; 2]);

const X: [f64; 2] = [1.0, 0.0];
const Y: [f64; 2] = [0.0, 1.0];

fn across([x, y]: [f64; 2]) -> [f64; 2] {
    // To the right, or upwards.
    if y > 0.0 || y == 0.0 && x < 0.0 { [y, 0.0 - x] } else { [0.0 - y, x] }
}

impl<'m> Guides<'m> {
    pub(super) fn new(model: &'m Model, sketch: &'m Sketch, free: &[JointId]) -> Self {
        Self {
            ties: ties(model),
            joined: Joined::of(model),
            loose: free.iter().flat_map(|&joint| both(model, joint)).collect(),
            leaves: leaves(model),
            model,
            sketch,
        }
    }

    /// The slots that hold what one motor more would drive, the likeliest first. What has no motor lacks that.
    pub(super) fn slots(&self) -> Vec<Repair> {
        if self.model.motors.is_empty() {
            return Vec::new();
        }
        let guesses = [
            self.slots_of_leaves(),
            self.slots_of_ends(),
            self.slots_in_gaps(),
            self.slots_of_pins(),
        ];
        self.declared(Purpose::Guess, guesses.concat())
    }

    /// The slides on the ground of what has no joint to it, the likeliest first.
    pub(super) fn slides(&self) -> Vec<Repair> {
        let mut guesses = Vec::new();
        for tie in &self.ties {
            for link in tie.links {
                let moves = link != LinkId::GROUND && self.loose.contains(&link);
                let is_leaf = self.is_leaf(link);
                let mut held = self.leaves.iter().filter(|leaf| leaf.0 == link);
                let is_driven = held.any(|leaf| self.model.motor_of(leaf.1).is_some());
                let others = self.leaves.iter().any(|&leaf| self.is_idle(leaf));
                if !moves || !is_leaf && others || self.joined.are_joined([LinkId::GROUND, link]) {
                    continue;
                }
                let named = is_slider(self.model, link);
                let known = f64::from(u8::from(is_leaf)) + 2.0 * f64::from(u8::from(named));
                let mut add = |purpose: Purpose, more: f64, along: [f64; 2]| {
                    let kind = NewKind::Prismatic(along);
                    guesses.push((purpose, (known + more, kind, [LinkId::GROUND, link], tie.at)));
                };
                if let Some(along) = tie.along() {
                    // A cylinder is held by pins.
                    if !is_driven {
                        add(Purpose::Slide, 1.0, across(along));
                    }
                    continue;
                }
                for along in [X, Y] {
                    if self.pivots().any(|pivot| self.is_in_line(tie.at, pivot, along)) {
                        add(Purpose::Slide, 1.0, along);
                    }
                }
                for along in self.ground_guides() {
                    add(Purpose::Guess, 0.5, along);
                }
                if named {
                    let off = |pivot: [f64; 2]| (pivot[0] - tie.at[0]).abs();
                    let above = |pivot| off(pivot) <= NEAR * self.sketch.size;
                    let is_above = self.pivots().next().is_some_and(above);
                    add(Purpose::Guess, 0.0, if is_above { Y } else { X });
                }
            }
        }
        guesses.retain(|(_, guess)| guess.0 >= 1.5);
        let of = |wanted: Purpose| {
            let some = guesses.iter().filter(move |(purpose, _)| *purpose == wanted);
            some.map(|(_, guess)| *guess).collect()
        };
        let slides = self.declared(Purpose::Slide, of(Purpose::Slide));
        [slides, self.declared(Purpose::Guess, of(Purpose::Guess))].concat()
    }

    fn declared(&self, purpose: Purpose, mut guesses: Vec<Guess>) -> Vec<Repair> {
        guesses.sort_by(|a, b| b.0.total_cmp(&a.0));
        let word = |kind: NewKind| match kind {
            NewKind::Prismatic(_) => "guide",
            _ => "slot",
        };
        let declared = guesses.into_iter().map(|(_, kind, links, at)| {
            let joint = NewJoint {
                name: NewNames::new(self.model).like(None, word(kind)),
                kind,
                ends: Ends::Drawn { links, at },
            };
            Declaration::joint(purpose, joint).into()
        });
        declared.take(FEW).collect()
    }

    fn is_leaf(&self, link: LinkId) -> bool {
        self.leaves.iter().any(|leaf| leaf.0 == link)
    }

    /// Whether no motor drives what hangs on one joint.
    fn is_idle(&self, leaf: (LinkId, JointId)) -> bool {
        self.loose.contains(&leaf.0) && self.model.motor_of(leaf.1).is_none()
    }

    fn of(&self, link: LinkId) -> impl Iterator<Item = &Tie> {
        self.ties.iter().filter(move |tie| tie.has(link))
    }

    fn pivots(&self) -> impl Iterator<Item = [f64; 2]> {
        let turns = |tie: &&Tie| tie.kind == NewKind::Revolute;
        self.of(LinkId::GROUND).filter(turns).map(|tie| tie.at)
    }

    fn ground_guides(&self) -> impl Iterator<Item = [f64; 2]> {
        self.of(LinkId::GROUND).filter_map(Tie::along)
    }

    /// Whether a line through a place goes through another.
    fn is_in_line(&self, at: [f64; 2], other: [f64; 2], [x, y]: [f64; 2]) -> bool {
        let [u, v] = [other[0] - at[0], other[1] - at[1]];
        let off = IN_LINE * self.sketch.size;
        (u * y - v * x).abs() <= off && u.hypot(v) > off
    }

    /// How likely two links are a pair: they are declared one after the other, or the joints before and after theirs are.
    fn nearness(&self, a: LinkId, b: LinkId) -> f64 {
        let places = |link: LinkId| self.of(link).map(|tie| tie.at).collect::<Vec<_>>();
        let (some, others) = (places(a), places(b));
        let apart = some
            .iter()
            .flat_map(|&p| others.iter().map(move |&q| distance(p, q)))
            .fold(self.sketch.size, f64::min);
        let next = u8::from(a.index().abs_diff(b.index()) == 1);
        let gap = u8::from(gaps(self.model).contains(&[a.min(b), a.max(b)]));
        f64::from(next) + f64::from(gap) - apart / self.sketch.size
    }

    /// A pin of one link in a slot of another, and the same slot across.
    fn slot(&self, likely: f64, pin: LinkId, rail: LinkId) -> Vec<Guess> {
        let places = |link: LinkId| self.of(link).map(|tie| tie.at).collect::<Vec<_>>();
        let (own, rails) = (places(pin), places(rail));
        let ends = self.sketch.ends.iter().filter(|end| end.link == pin);
        let end = ends.map(|end| end.at).min_by(|a, b| {
            let far = |at: &[f64; 2]| {
                rails.iter().map(|&other| distance(*at, other)).fold(f64::MAX, f64::min)
            };
            far(a).total_cmp(&far(b))
        });
        let Some(at) = end.or_else(|| between([&own, &rails], self.sketch)) else {
            return Vec::new();
        };
        let away = |&&place: &&[f64; 2]| distance(place, at) > NEAR * self.sketch.size;
        let along = rails.iter().find(away).map_or(X, |[x, y]| {
            let [u, v] = [at[0] - x, at[1] - y];
            [u / u.hypot(v), v / u.hypot(v)]
        });
        [along, across(along)].map(|along| (likely, NewKind::Slot(along), [pin, rail], at)).into()
    }

    /// What hangs on one joint, and slides in another link or lets that slide: a crank that drives nothing, and what nothing drives where
    /// other slots are.
    fn slots_of_leaves(&self) -> Vec<Guess> {
        let is_slot = |tie: &Tie| matches!(tie.kind, NewKind::Slot(_));
        let has_slots = self.ties.iter().any(is_slot);
        let mut guesses = Vec::new();
        for &(leaf, joint) in &self.leaves {
            let is_driven = self.model.motor_of(joint).is_some();
            let slides = matches!(self.model.joint(joint).kind, JointKind::Prismatic(..));
            for other in self.model.declared_links() {
                let loose = self.loose.contains(&other) || self.loose.contains(&leaf);
                if other == leaf || !loose || self.joined.are_joined([leaf, other]) {
                    continue;
                }
                let near = self.nearness(leaf, other);
                let ends = self.sketch.ends.iter().filter(|end| end.link == other);
                let end = ends.min_by(|a, b| {
                    let far = |at: [f64; 2]| {
                        self.of(leaf).map(|tie| distance(tie.at, at)).fold(f64::MAX, f64::min)
                    };
                    far(a.at).total_cmp(&far(b.at))
                });
                match end {
                    Some(end) if slides && !is_driven => {
                        let along = self.of(leaf).find_map(Tie::along).map_or(X, across);
                        guesses.push((2.0 + near, NewKind::Slot(along), [other, leaf], end.at));
                    }
                    _ if is_driven && self.loose.contains(&other) => {
                        guesses.extend(self.slot(3.0 + near, leaf, other));
                    }
                    _ if has_slots && !is_driven => {
                        guesses.extend(self.slot(2.0 + near, leaf, other));
                    }
                    _ => {}
                }
            }
        }
        guesses
    }

    /// The ends of what has no joint to the ground, which slide along a guide that is there, or through a pivot.
    fn slots_of_ends(&self) -> Vec<Guess> {
        let mut guesses = Vec::new();
        for end in &self.sketch.ends {
            let moves = end.link != LinkId::GROUND && self.loose.contains(&end.link);
            if !moves || self.joined.are_joined([LinkId::GROUND, end.link]) {
                continue;
            }
            let mut add = |likely: f64, along: [f64; 2]| {
                guesses.push((likely, NewKind::Slot(along), [end.link, LinkId::GROUND], end.at));
            };
            let guides = self.of(LinkId::GROUND);
            for (at, along) in guides.filter_map(|tie| Some((tie.at, tie.along()?))) {
                if self.is_in_line(end.at, at, along) {
                    add(2.5, along);
                }
            }
            for along in [X, Y] {
                if self.pivots().any(|pivot| self.is_in_line(end.at, pivot, along)) {
                    add(1.5, along);
                }
            }
        }
        guesses
    }

    /// Two links between which the list of joints reads as a chain that comes apart, and which are declared one after the other.
    fn slots_in_gaps(&self) -> Vec<Guess> {
        let gaps = gaps(self.model).into_iter();
        let pairs = gaps.filter(|&[a, b]| {
            let moves = a != LinkId::GROUND && b.index() == a.index() + 1;
            let loose = self.loose.contains(&a) || self.loose.contains(&b);
            moves && loose && !self.is_leaf(a) && !self.is_leaf(b) && !self.joined.are_held([a, b])
        });
        pairs.flat_map(|[a, b]| self.slot(1.0 + self.nearness(a, b), b, a)).collect()
    }

    /// The pins in line with a pivot on the ground, which may keep to that line.
    fn slots_of_pins(&self) -> Vec<Guess> {
        let mut guesses = Vec::new();
        for tie in self.ties.iter().filter(|tie| tie.kind == NewKind::Revolute) {
            let is_inside = tie.links.iter().all(|&link| {
                let moves = link != LinkId::GROUND && !self.is_leaf(link);
                moves
                    && self.loose.contains(&link)
                    && !self.joined.are_joined([LinkId::GROUND, link])
            });
            for along in [X, Y] {
                if is_inside && self.pivots().any(|pivot| self.is_in_line(tie.at, pivot, along)) {
                    guesses.push((
                        1.0,
                        NewKind::Slot(along),
                        [tie.links[0], LinkId::GROUND],
                        tie.at,
                    ));
                }
            }
        }
        guesses
    }
}
