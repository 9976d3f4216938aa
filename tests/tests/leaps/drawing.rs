//! Random mechanisms as text: the inside of a `mechanism!`, grown addition by addition, so that proptest can shrink them.

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
    kind: Kind,
    /// Which of what is there.
    picks: [usize; 3],
    points: [[f64; 2]; 6],
    angles: [f64; 3],
    /// Which ratio, radius or law.
    choice: usize,
    flips: [bool; 2],
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

/// The text under way.
struct Page {
    lattice: f64,
    links: usize,
    joints: usize,
    lines: String,
    motors: Vec<(String, bool)>,
    /// Revolute joints: name and the two links.
    pivots: Vec<(usize, usize, usize)>,
    slides: Vec<(usize, usize, usize)>,
    coupled: bool,
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

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
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

impl Page {
    fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        // `+ 0.0` makes no difference but to minus zero.
        [x, y].map(|part| (part / self.lattice).round() * self.lattice + 0.0)
    }

    fn direction(&self, angle: f64, choice: usize) -> [f64; 2] {
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
    fn driven(&mut self, base: usize, at: [f64; 2], along: Option<[f64; 2]>) {
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

    fn add(&mut self, addition: &Addition, motors: usize) {
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
