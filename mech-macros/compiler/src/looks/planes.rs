//! The order of planes: no link crosses a pin that it does not carry, where an order exists.

use super::body::Body;
use super::declared::PIN;
use super::scene::Scene;
use super::survey::Frames;
use crate::model::LinkId;
use crate::structure::Pin;
use nalgebra::Point2;
use std::collections::BTreeMap;

/// So often a link and a pin are compared, at as many positions.
const CHECKS: usize = 200_000;
/// Rounds in which links look for a better plane. More links than this lie in the order of their declaration.
const ROUNDS: usize = 24;
const MOST_LINKS: usize = 128;
/// So many orders are begun from, fewer if there are many links.
const MOST_ATTEMPTS: usize = 64;
const WORK: usize = 4000;
/// A link that comes over the middle of a pin is as bad as so many that lie behind what they should be in front of; and one that only
/// touches a pin.
const WITHIN: usize = 64;
const TOUCHING: usize = 4;

/// A link comes to a pin that it does not carry: it has to be in front of both its ends, or behind both.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Crossing {
    link: usize,
    pin: usize,
}

/// Which bodies lie in front of which.
pub(super) struct Order {
    /// For each body the number of its plane, from back to front.
    pub(super) ranks: Vec<usize>,
    /// For each body, how often it crosses a pin that it does not carry.
    pub(super) conflicts: Vec<usize>,
}

/// What the order has to respect.
struct Rules {
    /// For each pin with something in its way: the bodies that it joins, and whether it is fixed to the ground.
    pins: Vec<(Vec<usize>, bool)>,
    /// Those whose middle comes within the link weigh more than those that only touch it.
    crossings: BTreeMap<Crossing, usize>,
    /// Pairs of which the first has to be in front of the second.
    before: Vec<[usize; 2]>,
}

/// Orders the bodies of links.
pub(super) fn order(
    scene: &Scene<'_>,
    links: &[LinkId],
    bodies: &[Body],
    before: &[[LinkId; 2]],
) -> Order {
    let number = |link: &LinkId| links.iter().position(|known| known == link);
    let before = before
        .iter()
        .filter_map(|[a, b]| Some([number(a)?, number(b)?]));
    let rules = if links.len() <= MOST_LINKS {
        Rules::new(scene, links, bodies, before.collect())
    } else {
        Rules::none()
    };
    // From front to back, as they are declared: what is driven first is in front.
    let mut order: Vec<usize> = (0..links.len()).rev().collect();
    order = rules.best(&order);
    let ranks = ranks_of(&order);
    let conflicts = (0..links.len())
        .map(|link| rules.crossings_of(link, &ranks))
        .collect();
    Order { ranks, conflicts }
}

/// The rank of each body in an order.
fn ranks_of(order: &[usize]) -> Vec<usize> {
    let mut ranks = vec![0; order.len()];
    for (rank, &body) in order.iter().enumerate() {
        ranks[body] = rank;
    }
    ranks
}

impl Rules {
    /// Every order is right.
    fn none() -> Self {
        Self {
            pins: Vec::new(),
            crossings: BTreeMap::new(),
            before: Vec::new(),
        }
    }

    fn new(scene: &Scene<'_>, links: &[LinkId], bodies: &[Body], before: Vec<[usize; 2]>) -> Self {
        let number = |link: LinkId| links.iter().position(|known| *known == link);
        let members = |pin: &Pin| {
            pin.members
                .iter()
                .filter_map(|member| number(member.0))
                .collect()
        };
        let is_fixed = |pin: &Pin| pin.axis_of(LinkId::GROUND).is_some();
        let pins = &scene.structure.pins;
        let reaches: Vec<f64> = bodies.iter().map(|body| body.footprint.reach()).collect();
        let mut crossings = BTreeMap::new();
        let checks = scene.survey.positions.len() * pins.len() * links.len();
        let step = checks.div_ceil(CHECKS).max(1);
        for frames in scene.survey.positions.iter().step_by(step) {
            for (pin_number, pin) in pins.iter().enumerate() {
                let Some(place) = place(scene, frames, pin) else {
                    continue;
                };
                for (link, body) in bodies.iter().enumerate() {
                    let crossing = Crossing {
                        link,
                        pin: pin_number,
                    };
                    let is_member = is_on(scene, pin, links[link]);
                    if is_member || crossings.get(&crossing) == Some(&WITHIN) {
                        continue;
                    }
                    let Some(frame) = frames.frame(links[link]) else {
                        continue;
                    };
                    let own = frame.inverse() * place;
                    let radius = PIN * scene.width;
                    if own.coords.norm() > reaches[link] + radius {
                        continue;
                    }
                    if body.footprint.touches(own, 0.0) {
                        crossings.insert(crossing, WITHIN);
                    } else if body.footprint.touches(own, radius) {
                        crossings.entry(crossing).or_insert(TOUCHING);
                    }
                }
            }
        }
        Self {
            pins: pins
                .iter()
                .map(|pin| (members(pin), is_fixed(pin)))
                .collect(),
            crossings,
            before,
        }
    }

    /// How many pins a link crosses that it does not carry.
    fn crossings_of(&self, link: usize, ranks: &[usize]) -> usize {
        let own = self
            .crossings
            .keys()
            .filter(|crossing| crossing.link == link);
        own.filter(|crossing| self.is_crossed(**crossing, ranks))
            .count()
    }

    fn is_crossed(&self, crossing: Crossing, ranks: &[usize]) -> bool {
        let (members, is_fixed) = &self.pins[crossing.pin];
        let rank = ranks[crossing.link];
        let ranks = || members.iter().map(|&member| ranks[member]);
        let front = ranks().max();
        let back = if *is_fixed { None } else { ranks().min() };
        front.is_some_and(|front| rank < front) && back.is_none_or(|back| rank > back)
    }

    /// What is wrong with an order, as far as one link has to do with it: how the others lie to each other does not depend on it.
    fn faults_of(&self, link: usize, ranks: &[usize]) -> usize {
        let concerns = |crossing: &Crossing| {
            crossing.link == link || self.pins[crossing.pin].0.contains(&link)
        };
        let crossed = self.crossed(ranks, concerns);
        let before = self.before.iter().filter(|pair| pair.contains(&link));
        let before = before.filter(|[front, back]| ranks[*front] < ranks[*back]);
        crossed + before.count()
    }

    /// What is wrong with an order.
    fn faults(&self, ranks: &[usize]) -> usize {
        let crossed = self.crossed(ranks, |_| true);
        let before = self
            .before
            .iter()
            .filter(|[front, back]| ranks[*front] < ranks[*back]);
        crossed + before.count()
    }

    /// What the crossings weigh that an order leaves, of some.
    fn crossed(&self, ranks: &[usize], some: impl Fn(&Crossing) -> bool) -> usize {
        let own = self.crossings.iter().filter(|(crossing, _)| some(crossing));
        let crossed = own.filter(|(crossing, _)| self.is_crossed(**crossing, ranks));
        crossed.map(|(_, weight)| weight).sum()
    }

    /// The best order that is found from this one, and from others in which it is mixed.
    fn best(&self, order: &[usize]) -> Vec<usize> {
        let attempts = (WORK / order.len().pow(2).max(1)).clamp(1, MOST_ATTEMPTS);
        let count = order.len();
        let mut best = (usize::MAX, order.to_vec());
        for attempt in 0..attempts {
            let mut mixed = order.to_vec();
            for place in (1..count).filter(|_| attempt > 0) {
                mixed.swap(
                    place,
                    (attempt * (place + 7) * 31 + attempt * attempt) % (place + 1),
                );
            }
            self.improve(&mut mixed);
            let faults = self.faults(&ranks_of(&mixed));
            if faults < best.0 {
                best = (faults, mixed);
            }
            if faults == 0 {
                break;
            }
        }
        best.1
    }

    /// Moves links, one at a time, to where the fewest rules are broken.
    fn improve(&self, order: &mut Vec<usize>) {
        for _ in 0..ROUNDS {
            let mut moved = false;
            for link in 0..order.len() {
                moved |= self.settle(order, link);
            }
            if !moved {
                return;
            }
        }
    }

    /// Moves a link to its best place; returns whether that is another than before.
    fn settle(&self, order: &mut Vec<usize>, link: usize) -> bool {
        let before = self.faults_of(link, &ranks_of(order));
        let Some(place) = order.iter().position(|&other| other == link) else {
            return false;
        };
        if before == 0 {
            return false;
        }
        let mut best = (before, place);
        order.remove(place);
        for rank in 0..=order.len() {
            order.insert(rank, link);
            let faults = self.faults_of(link, &ranks_of(order));
            if faults < best.0 {
                best = (faults, rank);
            }
            order.remove(rank);
        }
        order.insert(best.1, link);
        best.1 != place
    }
}

/// Whether a link is on a pin, or has the slot in which it slides.
fn is_on(scene: &Scene<'_>, pin: &Pin, link: LinkId) -> bool {
    pin.members.iter().any(|member| {
        let die = scene.model.link(member.0).die;
        let slot = die.map(|(_, line)| scene.model.axis(line).link);
        member.0 == link || slot == Some(link)
    })
}

/// Where a pin is at a position.
fn place(scene: &Scene<'_>, frames: &Frames, pin: &Pin) -> Option<Point2<f64>> {
    pin.members
        .iter()
        .find_map(|member| frames.place(scene.model, member.1))
}
