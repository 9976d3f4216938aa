//! The text of a drawing, part by part.

use super::drawing::{Addition, Kind};
use mech_test_support::{cross, dot};
use std::fmt::Write as _;

/// Ratios of what rolls.
const RATIOS: [&str; 16] = [
    "20 : 20", "20 : 40", "40 : 20", "17 : 40", "10 : 30", "70 : 10", "1 : 40", "40 : 1",
    "1 : 100", "100 : 1", "31 : 12", "1 : 7", "60 : 17", "3 : 2", "20 : -60", "9 : 11",
];
/// Radii of pinions.
const RADII: [f64; 8] = [1.0, 0.378, 0.1, 0.5, 3.0, 8.0, 20.0, 80.0];
/// Laws of cams.
const LAWS: [&str; 8] = [
    "0.1 * q",
    "sin(q)",
    "0.8 * (1 - cos(q))",
    "-0.5 * sin(2 * q)",
    "0.025 * q",
    "-2 * q",
    "0.4 * q + 0.2 * sin(q)",
    "q / sqrt(1 + q * q)",
];
/// Directions on a lattice.
const DIRECTIONS: [[f64; 2]; 6] = [
    [1.0, 0.0],
    [0.0, 1.0],
    [1.0, 1.0],
    [1.0, -1.0],
    [2.0, 1.0],
    [0.0, -1.0],
];

/// The text so far.
pub(crate) struct Page {
    pub(crate) lattice: f64,
    pub(crate) links: usize,
    pub(crate) joints: usize,
    pub(crate) lines: String,
    pub(crate) motors: Vec<(String, bool)>,
    /// Revolute joints: name and the two links.
    pub(crate) pivots: Vec<(usize, usize, usize)>,
    /// Where they are.
    pub(crate) places: Vec<[f64; 2]>,
    pub(crate) slides: Vec<(usize, usize, usize)>,
    pub(crate) coupled: bool,
}

fn name(link: usize) -> String {
    if link == 0 {
        "ground".to_owned()
    } else {
        format!("l{link}")
    }
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

impl Page {
    pub(crate) fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        // `+ 0.0` makes no difference but to minus zero.
        [x, y].map(|part| (part / self.lattice).round() * self.lattice + 0.0)
    }

    pub(crate) fn direction(&self, angle: f64, choice: usize) -> [f64; 2] {
        if self.lattice >= 1.0 {
            return DIRECTIONS[choice % DIRECTIONS.len()];
        }
        let (sin, cos) = angle.sin_cos();
        [cos, sin].map(|part| (part / self.lattice).round() * self.lattice + 0.0)
    }

    fn link(&mut self) -> usize {
        self.links += 1;
        let _ = writeln!(self.lines, "link l{};", self.links);
        self.links
    }

    fn next(&mut self) -> usize {
        self.joints += 1;
        self.joints - 1
    }

    fn pivot(&mut self, a: usize, b: usize, [x, y]: [f64; 2]) -> usize {
        let joint = self.next();
        let (first, second) = (name(a), name(b));
        let _ = writeln!(
            self.lines,
            "joint j{joint} = revolute({first}, {second}) at ({x:?}, {y:?});"
        );
        self.pivots.push((joint, a, b));
        self.places.push([x, y]);
        joint
    }

    fn slide(&mut self, a: usize, b: usize, [x, y]: [f64; 2], [u, v]: [f64; 2]) -> usize {
        let joint = self.next();
        let (first, second) = (name(a), name(b));
        let _ = writeln!(
            self.lines,
            "joint j{joint} = prismatic({first}, {second}) at ({x:?}, {y:?}) along ({u:?}, {v:?});"
        );
        self.slides.push((joint, a, b));
        joint
    }

    /// A link on a motor, which slides if it has a direction.
    pub(crate) fn driven(&mut self, base: usize, at: [f64; 2], along: Option<[f64; 2]>) {
        let link = self.link();
        let joint = match along {
            Some(along) => self.slide(base, link, at, along),
            None => self.pivot(base, link, at),
        };
        self.motors.push((format!("j{joint}"), along.is_some()));
    }

    /// Some link, and another one.
    fn two(&self, picks: [usize; 3]) -> (usize, usize) {
        let first = picks[0] % (self.links + 1);
        let other = picks[1] % self.links;
        (first, if other >= first { other + 1 } else { other })
    }

    pub(crate) fn add(&mut self, addition: &Addition, motors: usize) {
        let points = addition.points.map(|point| self.point(point));
        let [d, e, _] = addition
            .angles
            .map(|angle| self.direction(angle, addition.choice));
        let e = if self.lattice >= 1.0 {
            DIRECTIONS[addition.picks[2] % 6]
        } else {
            e
        };
        match addition.kind {
            Kind::Crank | Kind::Slider => {
                if self.motors.len() < motors {
                    let along = (addition.kind == Kind::Slider).then_some(d);
                    self.driven(addition.picks[0] % (self.links + 1), points[0], along);
                }
            }
            Kind::Gear | Kind::Belt => self.wheel(addition, points[0]),
            Kind::Rack => self.rack(addition, points[0], d),
            Kind::Cam => self.cam(addition, points[0], d),
            Kind::Parallelogram => self.parallelogram(addition, points),
            Kind::Triad => self.triad(addition, points, [d, e]),
            Kind::Ring => self.ring(addition, points),
            Kind::Tied => self.tied(addition, points),
            Kind::TiedRack => self.tied_rack(addition, points, d),
            _ => self.dyad(addition, points, [d, e]),
        }
    }

    /// A wheel that some turning link drives.
    fn wheel(&mut self, addition: &Addition, at: [f64; 2]) {
        let Some((carrier, wheel)) = self.turning(addition) else {
            return;
        };
        let link = self.link();
        self.pivot(carrier, link, at);
        let joint = self.next();
        let ratio = RATIOS[addition.choice % RATIOS.len()];
        let is_belt = addition.kind == Kind::Belt && !ratio.contains('-');
        let word = if is_belt { "belt" } else { "gear" };
        let (wheel, own, carrier) = (name(wheel), name(link), name(carrier));
        let _ = writeln!(
            self.lines,
            "joint j{joint} = {word}({wheel}, {own}, {ratio} on {carrier});"
        );
    }

    /// A pivot, as carrier and wheel; the wheel is not the ground.
    fn turning(&self, addition: &Addition) -> Option<(usize, usize)> {
        if self.pivots.is_empty() {
            return None;
        }
        let (_, a, b) = self.pivots[addition.picks[0] % self.pivots.len()];
        let (carrier, wheel) = if addition.flips[0] && a != 0 {
            (b, a)
        } else {
            (a, b)
        };
        Some((carrier, wheel))
    }

    /// A bar that some turning link drives, or a pinion that some sliding link does.
    fn rack(&mut self, addition: &Addition, at: [f64; 2], along: [f64; 2]) {
        let radius = RADII[addition.choice % RADII.len()];
        let from_slide = addition.flips[1] && !self.slides.is_empty();
        let (carrier, pinion, bar) = if from_slide {
            let (_, carrier, bar) = self.slides[addition.picks[0] % self.slides.len()];
            let link = self.link();
            self.pivot(carrier, link, at);
            (carrier, link, bar)
        } else {
            let Some((carrier, wheel)) = self.turning(addition) else {
                return;
            };
            let link = self.link();
            self.slide(carrier, link, at, along);
            (carrier, wheel, link)
        };
        let joint = self.next();
        let (pinion, bar, carrier) = (name(pinion), name(bar), name(carrier));
        let _ = writeln!(
            self.lines,
            "joint j{joint} = rack({pinion}, {bar}, radius {radius} on {carrier});"
        );
    }

    /// A follower of some joint.
    fn cam(&mut self, addition: &Addition, at: [f64; 2], along: [f64; 2]) {
        let all: Vec<(usize, usize, usize)> =
            self.pivots.iter().chain(&self.slides).copied().collect();
        let (shaft, a, b) = all[addition.picks[0] % all.len()];
        let carrier = if addition.flips[0] { a } else { b };
        let link = self.link();
        let follower = if addition.flips[1] {
            self.slide(carrier, link, at, along)
        } else {
            self.pivot(carrier, link, at)
        };
        let joint = self.next();
        let law = LAWS[addition.choice % LAWS.len()];
        let _ = writeln!(
            self.lines,
            "joint j{joint} = cam(j{shaft}, j{follower}, {law});"
        );
    }

    /// Two links, joined to each other and to two that are there; nothing if it is drawn near a dead point.
    fn dyad(&mut self, addition: &Addition, [p, q, r, ..]: [[f64; 2]; 6], [d, e]: [[f64; 2]; 2]) {
        let (first, second) = self.two(addition.picks);
        let kind = addition.kind;
        let good = match kind {
            Kind::Rrr => cross(minus(q, p), minus(r, q)).abs() > 0.3,
            Kind::Prp | Kind::Rpp => cross(d, e).abs() > 0.3,
            _ => dot(minus(q, p), d).abs() > 0.3,
        };
        if !good {
            return;
        }
        let a = self.link();
        if kind == Kind::Slot {
            self.pivot(first, a, p);
            let joint = self.next();
            let (a, second) = (name(a), name(second));
            let _ = writeln!(
                self.lines,
                "joint j{joint} = slot({a}, {second}) at ({:?}, {:?}) along ({:?}, {:?});",
                q[0], q[1], d[0], d[1]
            );
            return;
        }
        let b = self.link();
        match kind {
            Kind::Rrp => {
                self.pivot(first, a, p);
                self.pivot(a, b, q);
                self.slide(second, b, r, d);
            }
            Kind::Rpr => {
                self.pivot(first, a, p);
                self.slide(a, b, r, d);
                self.pivot(b, second, q);
            }
            Kind::Prr => {
                self.slide(a, first, r, d);
                self.pivot(a, b, p);
                self.pivot(second, b, q);
            }
            Kind::Prp => {
                self.slide(first, a, p, d);
                self.pivot(a, b, q);
                self.slide(second, b, r, e);
            }
            Kind::Rpp => {
                self.pivot(first, a, p);
                self.slide(b, a, q, d);
                self.slide(second, b, r, e);
            }
            _ => {
                self.pivot(first, a, p);
                self.pivot(b, a, q);
                self.pivot(second, b, r);
            }
        }
    }

    /// A link that turns as another does, which turns on the same: by how much it is none is a small part of its size.
    fn parallelogram(&mut self, addition: &Addition, [q, shift, ..]: [[f64; 2]; 6]) {
        if self.pivots.is_empty() {
            return;
        }
        let number = addition.picks[0] % self.pivots.len();
        let (_, a, b) = self.pivots[number];
        let (base, crank) = if addition.flips[0] { (b, a) } else { (a, b) };
        let p = self.places[number];
        if cross(minus(q, p), shift).abs() < 0.3 {
            return;
        }
        let off = [0.0, 0.0, 0.0, 1e-2, -1e-3, 1e-4, -1e-5][addition.choice % 7];
        let [c, d] = [(); 2].map(|()| self.link());
        self.pivot(base, c, [p[0] + shift[0], p[1] + shift[1]]);
        self.pivot(crank, d, q);
        self.pivot(
            d,
            c,
            [q[0] + shift[0] * (1.0 + off), q[1] + shift[1] * (1.0 + off)],
        );
    }

    fn triad(&mut self, addition: &Addition, points: [[f64; 2]; 6], directions: [[f64; 2]; 2]) {
        self.coupled = true;
        let there = self.links + 1;
        let mut bases = addition.picks.map(|pick| pick % there);
        if bases[0] == bases[1] && bases[1] == bases[2] {
            bases[0] = (bases[0] + 1) % there;
        }
        let platform = self.link();
        for (leg, base) in bases.into_iter().enumerate() {
            let link = self.link();
            let [from, to] = [points[2 * leg], points[2 * leg + 1]];
            match (addition.choice >> (2 * leg)) % 8 {
                0 => {
                    self.pivot(base, link, from);
                    self.slide(link, platform, to, directions[leg % 2]);
                }
                1 => {
                    self.slide(base, link, from, directions[leg % 2]);
                    self.pivot(link, platform, to);
                }
                _ => {
                    self.pivot(base, link, from);
                    self.pivot(link, platform, to);
                }
            }
        }
    }

    fn ring(&mut self, addition: &Addition, points: [[f64; 2]; 6]) {
        self.coupled = true;
        let (first, second) = self.two(addition.picks);
        let ring = [(); 4].map(|()| self.link());
        for corner in 0..4 {
            self.pivot(ring[corner], ring[(corner + 1) % 4], points[corner]);
        }
        self.pivot(first, ring[0], points[4]);
        self.pivot(second, ring[2], points[5]);
    }

    fn tied(&mut self, addition: &Addition, [p, q, r, s, ..]: [[f64; 2]; 6]) {
        let (first, second) = self.two(addition.picks);
        let [a, b, c] = [(); 3].map(|()| self.link());
        self.pivot(first, a, p);
        self.pivot(a, b, q);
        self.pivot(b, c, r);
        self.pivot(c, second, s);
        let joint = self.next();
        let ratio = RATIOS[addition.choice % RATIOS.len()];
        // Two links that both turn on the one between them.
        let (wheel, other, carrier) = if addition.flips[0] {
            (first, b, a)
        } else {
            (a, c, b)
        };
        let (wheel, other, carrier) = (name(wheel), name(other), name(carrier));
        let _ = writeln!(
            self.lines,
            "joint j{joint} = gear({wheel}, {other}, {ratio} on {carrier});"
        );
    }

    fn tied_rack(&mut self, addition: &Addition, [p, q, r, s, ..]: [[f64; 2]; 6], d: [f64; 2]) {
        let (first, second) = self.two(addition.picks);
        let [a, b, c] = [(); 3].map(|()| self.link());
        self.pivot(first, a, p);
        self.pivot(a, b, q);
        self.slide(b, c, r, d);
        self.pivot(c, second, s);
        let joint = self.next();
        let radius = RADII[addition.choice % RADII.len()];
        let (pinion, bar, carrier) = if addition.flips[0] {
            (a, c, b)
        } else {
            (second, b, c)
        };
        let (pinion, bar, carrier) = (name(pinion), name(bar), name(carrier));
        let _ = writeln!(
            self.lines,
            "joint j{joint} = rack({pinion}, {bar}, radius {radius} on {carrier});"
        );
    }
}
