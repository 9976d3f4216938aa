//! The order of planes: no link crosses a pin that it does not carry, where an order exists.

use super::body::Body;
use super::declared::PIN;
use super::footprint::Footprint;
use super::scene::Scene;
use super::survey::Frames;
use crate::cancel;
use crate::model::LinkId;
use crate::structure::Pin;
use mech_core::Pose;
use nalgebra::Point2;

/// So many comparisons of a link with a pin are made at most, over all positions.
const CHECKS: usize = 200_000;
/// So many rounds of moving single links to better planes are made at most. With more links than the second number, the order of
/// declaration stays.
const ROUNDS: usize = 24;
const MOST_LINKS: usize = 128;
/// The search begins from so many orders at most, and from fewer if there are many links.
const MOST_ATTEMPTS: usize = 64;
const WORK: usize = 4000;
/// The weights of a crossing: of a link that covers the middle of a pin, and of one that only touches it. A body that lies behind what it
/// should be in front of weighs 1.
const WITHIN: usize = 64;
const TOUCHING: usize = 4;
/// Rounding moves a place by less than this part of its coordinates.
const SPARE: f64 = 1e-9;

/// Two bodies of which one has to be in front of the other.
#[derive(Clone, Copy)]
pub(super) struct Pair<T> {
    pub(super) front: T,
    pub(super) back: T,
    /// The weight of the fault if it is behind.
    pub(super) weight: usize,
}

/// The weight where one body lies on another.
pub(super) const LAID: usize = 1;
/// The weight where one is inside the other, as a rod in its barrel: more than all other faults together.
pub(super) const INSIDE: usize = 1 << 24;

/// A link that passes over a pin that it does not carry. It has to be in front of both links of that pin, or behind both.
#[derive(Clone, Copy)]
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

/// The rules that the order has to respect.
struct Rules {
    /// For each pin with something in its way: the bodies that it joins, and whether it is fixed to the ground.
    pins: Vec<(Vec<usize>, bool)>,
    /// The crossings with their weights.
    crossings: Vec<(Crossing, usize)>,
    /// For each body the crossings that it has a part in.
    crossings_with: Vec<Vec<(Crossing, usize)>>,
    pairs: Vec<Pair<usize>>,
}

/// Orders the bodies of links.
pub(super) fn order(
    scene: &Scene<'_>,
    links: &[LinkId],
    bodies: &[Body],
    pairs: &[Pair<LinkId>],
) -> Order {
    let number = |link: &LinkId| links.iter().position(|known| known == link);
    let pairs = pairs.iter().filter_map(|pair| {
        Some(Pair { front: number(&pair.front)?, back: number(&pair.back)?, weight: pair.weight })
    });
    let rules = if links.len() <= MOST_LINKS {
        Rules::new(scene, links, bodies, pairs.collect())
    } else {
        Rules::none(links.len())
    };
    // From front to back, as they are declared: what is driven first is in front.
    let mut order: Vec<usize> = (0..links.len()).rev().collect();
    order = rules.best(&order);
    let ranks = ranks_of(&order);
    let conflicts = (0..links.len()).map(|link| rules.crossings_of(link, &ranks)).collect();
    Order { ranks, conflicts }
}

/// The rank of each body in an order, in which one may be missing.
fn ranks_of(order: &[usize]) -> Vec<usize> {
    let mut ranks = vec![0; order.len() + 1];
    for (rank, &body) in order.iter().enumerate() {
        ranks[body] = rank;
    }
    ranks
}

impl Rules {
    /// Every order is right.
    fn none(links: usize) -> Self {
        Self {
            pins: Vec::new(),
            crossings: Vec::new(),
            crossings_with: vec![Vec::new(); links],
            pairs: Vec::new(),
        }
    }

    fn new(scene: &Scene<'_>, links: &[LinkId], bodies: &[Body], pairs: Vec<Pair<usize>>) -> Self {
        let number = |link: LinkId| links.iter().position(|known| *known == link);
        let members = |pin: &Pin| -> Vec<usize> {
            let members = pin.members.iter();
            members.filter_map(|member| number(member.0)).collect()
        };
        let is_fixed = |pin: &Pin| pin.axis_of(LinkId::GROUND).is_some();
        let pins = scene.structure.pins.iter();
        let pins = pins.map(|pin| (members(pin), is_fixed(pin)));
        let mut rules = Self {
            pins: pins.collect(),
            crossings: find_crossings(scene, links, bodies),
            crossings_with: vec![Vec::new(); links.len()],
            pairs,
        };
        for &(crossing, weight) in &rules.crossings {
            let carriers = rules.pins[crossing.pin].0.iter();
            for &body in carriers.filter(|&&body| body != crossing.link) {
                rules.crossings_with[body].push((crossing, weight));
            }
            rules.crossings_with[crossing.link].push((crossing, weight));
        }
        rules
    }

    /// Counts the pins that a link crosses and does not carry.
    fn crossings_of(&self, link: usize, ranks: &[usize]) -> usize {
        cancel::check();
        let crossings = self.crossings.iter().map(|(crossing, _)| *crossing);
        let own = crossings.filter(|crossing| crossing.link == link);
        own.filter(|crossing| self.is_crossed(*crossing, ranks)).count()
    }

    fn is_crossed(&self, crossing: Crossing, ranks: &[usize]) -> bool {
        let (members, is_fixed) = &self.pins[crossing.pin];
        let rank = ranks[crossing.link];
        let (mut is_behind, mut is_before) = (false, *is_fixed);
        for &member in members {
            is_behind |= rank < ranks[member];
            is_before |= rank > ranks[member];
        }
        is_behind && is_before
    }

    /// The weight of all faults in which one link has a part. The others do not change when this link moves to another plane.
    fn faults_of(&self, link: usize, ranks: &[usize]) -> usize {
        let pairs = self.pairs.iter();
        let pairs = pairs.filter(|pair| pair.front == link || pair.back == link);
        self.crossed(ranks, &self.crossings_with[link]) + behind(ranks, pairs)
    }

    /// Returns the weight of all faults of an order.
    fn faults(&self, ranks: &[usize]) -> usize {
        self.crossed(ranks, &self.crossings) + behind(ranks, self.pairs.iter())
    }

    /// Returns the total weight of these crossings, as far as an order leaves them.
    fn crossed(&self, ranks: &[usize], some: &[(Crossing, usize)]) -> usize {
        let crossed = some.iter();
        let crossed = crossed.filter(|(crossing, _)| self.is_crossed(*crossing, ranks));
        crossed.map(|(_, weight)| weight).sum()
    }

    /// The best order found by improving this one, and shuffled copies of it.
    fn best(&self, order: &[usize]) -> Vec<usize> {
        let attempts = (WORK / order.len().pow(2).max(1)).clamp(1, MOST_ATTEMPTS);
        let count = order.len();
        let mut best = (usize::MAX, order.to_vec());
        for attempt in 0..attempts {
            let mut mixed = order.to_vec();
            for place in (1..count).filter(|_| attempt > 0) {
                mixed.swap(place, (attempt * (place + 7) * 31 + attempt * attempt) % (place + 1));
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
        cancel::check();
        let before = self.faults_of(link, &ranks_of(order));
        let Some(place) = order.iter().position(|&other| other == link) else {
            return false;
        };
        if before == 0 {
            return false;
        }
        let mut best = (before, place);
        order.remove(place);
        // It begins behind all others, and changes places with the next one each time.
        let mut ranks: Vec<usize> = ranks_of(order).iter().map(|rank| rank + 1).collect();
        for rank in 0..=order.len() {
            ranks[link] = rank;
            let faults = self.faults_of(link, &ranks);
            if faults < best.0 {
                best = (faults, rank);
            }
            if let Some(&next) = order.get(rank) {
                ranks[next] = rank;
            }
        }
        order.insert(best.1, link);
        best.1 != place
    }
}

/// The weight of the pairs that an order has the wrong way round.
fn behind<'p>(ranks: &[usize], pairs: impl Iterator<Item = &'p Pair<usize>>) -> usize {
    let wrong = pairs.filter(|pair| ranks[pair.front] < ranks[pair.back]);
    wrong.map(|pair| pair.weight).sum()
}

/// Which links pass over which pins that they do not carry, at some positions.
fn find_crossings(scene: &Scene<'_>, links: &[LinkId], bodies: &[Body]) -> Vec<(Crossing, usize)> {
    let pins = &scene.structure.pins;
    let radius = PIN * scene.width;
    let reaches = bodies.iter().map(|body| body.footprint.reach() + radius);
    let reaches: Vec<f64> = reaches.collect();
    let bounds = bodies.iter().map(|body| body.footprint.bounds());
    let bounds: Vec<[[f64; 2]; 2]> = bounds.collect();
    let carried = pins.iter().map(|pin| {
        let on = links.iter().map(|&link| is_on(scene, pin, link));
        on.collect::<Vec<bool>>()
    });
    let carried: Vec<Vec<bool>> = carried.collect();
    // Of each pin and each link: nothing, until something is found.
    let mut weights = vec![vec![0; links.len()]; pins.len()];
    let checks = scene.survey.positions.len() * pins.len() * links.len();
    let step = checks.div_ceil(CHECKS).max(1);
    for frames in scene.survey.positions.iter().step_by(step) {
        let poses = links.iter().map(|&link| frames.frame(link).map(Pose::from));
        let poses: Vec<Option<Pose<f64>>> = poses.collect();
        for (number, pin) in pins.iter().enumerate() {
            let Some(place) = place(scene, frames, pin) else {
                continue;
            };
            let weights = weights[number].iter_mut();
            for (link, weight) in weights.enumerate() {
                if carried[number][link] || *weight == WITHIN {
                    continue;
                }
                if let Some(pose) = poses[link]
                    && let Some(own) = near(pose, place, reaches[link])
                    && is_near_box(own, bounds[link], radius)
                {
                    *weight = weight_of(&bodies[link].footprint, own, radius).max(*weight);
                }
            }
        }
    }
    let found = weights.into_iter().enumerate().flat_map(|(pin, weights)| {
        let weights = weights.into_iter().enumerate();
        weights.map(move |(link, weight)| (Crossing { link, pin }, weight))
    });
    found.filter(|(_, weight)| *weight > 0).collect()
}

/// Whether a place is in a box, or no farther from it than `around`. Most places that a link can reach are beside its body.
fn is_near_box(place: Point2<f64>, [low, high]: [[f64; 2]; 2], around: f64) -> bool {
    let [x, y] = [place.x, place.y];
    let around = around + SPARE * (x.abs() + y.abs() + around);
    x >= low[0] - around && x <= high[0] + around && y >= low[1] - around && y <= high[1] + around
}

/// The weight of a crossing: whether the link covers the middle of the pin, only touches it, or neither.
fn weight_of(footprint: &Footprint, own: Point2<f64>, radius: f64) -> usize {
    // Most pins do not even touch it.
    if !footprint.touches(own, radius) {
        0
    } else if footprint.touches(own, 0.0) {
        WITHIN
    } else {
        TOUCHING
    }
}

/// A place of the scene in the frame of a link; none if it is farther from the link's origin than `reach`. By numbers, as macros are mostly built without optimisation.
fn near(link: Pose<f64>, place: Point2<f64>, reach: f64) -> Option<Point2<f64>> {
    // Most are far away, which is seen sooner than how far in the link. Rounding is less than what is left between.
    let spare = SPARE * (place.x.abs() + place.y.abs() + link.x.abs() + link.y.abs());
    let [x, y] = [place.x - link.x, place.y - link.y];
    if x.abs() > reach + spare || y.abs() > reach + spare || x * x + y * y > reach * reach {
        return None;
    }
    Some(link.relative(place.into()).into())
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
    pin.members.iter().find_map(|member| frames.place(scene.model, member.1))
}
