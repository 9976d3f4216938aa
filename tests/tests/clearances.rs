//! Clearances of bodies, against the distances of many places on both boundaries.

use mech_compiler::analyse;
use mech_test_support::{Dice, cases, seeds};
use std::f64::consts::TAU;

type Vector = [f64; 2];

/// So many angles of the crank, and places on a boundary, are looked at.
const ANGLES: u32 = 144;
const PLACES: u32 = 240;

/// A shape, and where it was put by hand.
enum Shape {
    Circle(Vector, f64),
    Ring(Vector, [f64; 2]),
    Bar([Vector; 2], f64),
    Polygon(Vec<Vector>),
}

impl Shape {
    fn random(dice: &mut Dice, [x, y]: Vector) -> Self {
        let size = dice.between(0.3, 1.0);
        match dice.below(4) {
            0 => Self::Circle([x, y], size),
            1 => Self::Ring([x, y], [size, size * dice.between(0.3, 0.9)]),
            2 => {
                let (sin, cos) = dice.between(0.0, TAU).sin_cos();
                let end = [x + 2.0 * size * cos, y + 2.0 * size * sin];
                Self::Bar([[x, y], end], size * dice.between(0.2, 0.8))
            }
            _ => {
                // A star about its middle.
                let count = 3 + dice.below(4);
                #[expect(clippy::cast_precision_loss, reason = "a few corners")]
                let part = |number: usize| TAU * number as f64 / count as f64;
                let corners = (0..count).map(|number| {
                    let far = size * dice.between(0.4, 1.0);
                    let (sin, cos) = part(number).sin_cos();
                    [x + far * cos, y + far * sin]
                });
                Self::Polygon(corners.collect())
            }
        }
    }

    fn text(&self) -> String {
        let place = |[x, y]: &Vector| format!("({x}, {y})");
        let list = |places: &[Vector]| {
            let places: Vec<String> = places.iter().map(place).collect();
            places.join(", ")
        };
        match self {
            Self::Circle(center, radius) => format!("circle {} radius {radius};", place(center)),
            Self::Ring(center, [radius, hole]) => {
                format!("ring {} radius {radius} hole {hole};", place(center))
            }
            Self::Bar(pins, width) => format!("bar [{}] width {width};", list(pins)),
            Self::Polygon(corners) => format!("polygon [{}];", list(corners)),
        }
    }

    /// Places all along its boundary.
    fn places(&self) -> Vec<Vector> {
        let round = |[x, y]: Vector, radius: f64| {
            let places = (0..PLACES).map(move |place| {
                let (sin, cos) = (TAU * f64::from(place) / f64::from(PLACES)).sin_cos();
                [x + radius * cos, y + radius * sin]
            });
            places.collect::<Vec<Vector>>()
        };
        let line = |[from, to]: [Vector; 2]| {
            let places = (0..PLACES).map(move |place| {
                let part = f64::from(place) / f64::from(PLACES);
                [0, 1].map(|axis| from[axis] + part * (to[axis] - from[axis]))
            });
            places.collect::<Vec<Vector>>()
        };
        match self {
            Self::Circle(center, radius) => round(*center, *radius),
            Self::Ring(center, radii) => {
                radii.iter().flat_map(|one| round(*center, *one)).collect()
            }
            Self::Bar([from, to], width) => {
                let way = [to[0] - from[0], to[1] - from[1]];
                let share = 0.5 * width / way[0].hypot(way[1]);
                let across = [-share * way[1], share * way[0]];
                let side = |sign: f64| {
                    [*from, *to].map(|end| [end[0] + sign * across[0], end[1] + sign * across[1]])
                };
                let sides = [line(side(1.0)), line(side(-1.0))].concat();
                // Half of each circle is inside.
                let is_outside = |[x, y]: &Vector| {
                    let along = (x - from[0]) * way[0] + (y - from[1]) * way[1];
                    !(0.0..=way[0] * way[0] + way[1] * way[1]).contains(&along)
                };
                let ends = [round(*from, 0.5 * width), round(*to, 0.5 * width)].concat();
                sides.into_iter().chain(ends.into_iter().filter(is_outside)).collect()
            }
            Self::Polygon(corners) => {
                let next = corners.iter().cycle().skip(1);
                let sides = corners.iter().zip(next);
                sides.flat_map(|(from, to)| line([*from, *to])).collect()
            }
        }
    }

    /// Whether it covers a place.
    fn covers(&self, [x, y]: Vector) -> bool {
        let far = |[u, v]: Vector| (x - u).hypot(y - v);
        match self {
            Self::Circle(center, radius) => far(*center) < *radius,
            Self::Ring(center, [radius, hole]) => (*hole..*radius).contains(&far(*center)),
            Self::Bar([from, to], width) => {
                let way = [to[0] - from[0], to[1] - from[1]];
                let square = way[0] * way[0] + way[1] * way[1];
                let part = ((x - from[0]) * way[0] + (y - from[1]) * way[1]) / square;
                let part = part.clamp(0.0, 1.0);
                far([from[0] + part * way[0], from[1] + part * way[1]]) < 0.5 * width
            }
            Self::Polygon(corners) => {
                // The angles under which its sides are seen make a turn, or none.
                let seen = |[u, v]: Vector| (v - y).atan2(u - x);
                let next = corners.iter().cycle().skip(1);
                let turns = corners.iter().zip(next).map(|(from, to)| {
                    let turn = seen(*to) - seen(*from);
                    turn - TAU * (turn / TAU).round()
                });
                turns.sum::<f64>().abs() > 1.0
            }
        }
    }
}

/// A crank that carries shapes past others that stand.
struct Passing {
    carried: Shape,
    standing: Shape,
    start: f64,
}

impl Passing {
    fn new(dice: &mut Dice) -> Self {
        let own = [dice.between(0.0, 2.0), dice.between(-0.5, 0.5)];
        let place = [dice.between(-3.5, 3.5), dice.between(-3.5, 3.5)];
        Self {
            carried: Shape::random(dice, own),
            standing: Shape::random(dice, place),
            start: dice.between(-3.0, 3.0),
        }
    }

    fn meets(&self, expect: &str) -> bool {
        let text = format!(
            "struct M; ground {{ point o = (0, 0); {} }} link crank {{ point o = (0, 0); {} }}
            joint a = revolute(ground.o, crank.o);
            motor a; start {{ a = {}; }} expect {expect};",
            self.standing.text(),
            self.carried.text(),
            self.start
        );
        let result = analyse(text.parse().expect("tokens")).prove().result;
        if let Err(faults) = &result {
            let texts = faults.messages.iter().map(|one| &one.text[..]);
            let texts: Vec<&str> = texts.collect();
            assert!(texts.iter().all(|text| text.contains("does not hold")), "{text}: {texts:?}");
        }
        result.is_ok()
    }

    /// The least distance of places on both boundaries while the crank turns right round; zero if one shape covers such a place.
    fn least(&self) -> f64 {
        let (own, other) = (self.carried.places(), self.standing.places());
        let mut least = f64::INFINITY;
        for angle in 0..ANGLES {
            let (sin, cos) = (TAU * f64::from(angle) / f64::from(ANGLES)).sin_cos();
            let turned: Vec<Vector> =
                own.iter().map(|[x, y]| [cos * x - sin * y, sin * x + cos * y]).collect();
            if turned.iter().any(|at| self.standing.covers(*at))
                || other
                    .iter()
                    .any(|[x, y]| self.carried.covers([cos * x + sin * y, cos * y - sin * x]))
            {
                return 0.0;
            }
            for [x, y] in &turned {
                for [u, v] in other.iter().step_by(4) {
                    least = least.min((x - u).hypot(y - v));
                }
            }
        }
        least
    }
}

#[test]
fn bodies_keep_as_clear_as_places_on_their_boundaries() {
    let (mut clear, mut overlapping) = (0, 0);
    for seed in seeds(cases(16)) {
        let passing = Passing::new(&mut Dice::new(seed));
        let least = passing.least();
        if least == 0.0 {
            overlapping += 1;
            assert!(!passing.meets("clear(ground, crank) > 0"), "seed {seed}");
        } else if least > 0.15 {
            clear += 1;
            // Places between those that were looked at are a little nearer.
            let within = format!("clear(crank, ground) > {}", least - 0.05);
            assert!(passing.meets(&within), "seed {seed}: {least}");
            let beyond = format!("clear(ground, crank) > {}", least * (1.0 + 1e-6));
            assert!(!passing.meets(&beyond), "seed {seed}: {least}");
        }
    }
    assert!(clear > 2 && overlapping > 2, "{clear} clear, {overlapping} overlapping");
}
