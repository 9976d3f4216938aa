//! What sums up the way of a motor, and how fast something moves with it, against closed forms of slider-cranks.

use mech_compiler::analyse;
use mech_test_support::{Dice, cases, seeds};
use std::f64::consts::{PI, TAU};

/// Limits are this part of the true value away from it.
const MARGIN: f64 = 1e-3;
const PLACES: u32 = 4096;

/// A slider-crank whose rail passes its shaft at a distance.
#[derive(Clone)]
pub(super) struct Slider {
    pub(super) crank: f64,
    pub(super) rod: f64,
    pub(super) offset: f64,
    /// The direction of its rail, and whether it is mirrored: 1 or −1.
    pub(super) turn: f64,
    pub(super) mirror: f64,
    /// The angle of its crank at the start.
    pub(super) start: f64,
    pub(super) text: String,
}

impl Slider {
    /// One in any direction, mirrored or not, with its statements in any order.
    pub(super) fn new(dice: &mut Dice) -> Self {
        let crank = dice.between(0.3, 3.0);
        let rod = crank * dice.between(1.8, 4.0);
        let offset = crank * dice.between(-0.6, 0.6);
        let (turn, start) = (dice.between(-PI, PI), dice.between(-PI, PI));
        let mirror = if dice.once_in(2) { -1.0 } else { 1.0 };
        let away = offset * mirror;
        let (sin, cos) = turn.sin_cos();
        let (x, y) = (-away * sin, away * cos);
        let lean = ((offset - crank * start.sin()) / rod).asin();
        let ends = |a: &str, b: &str, dice: &mut Dice| {
            if dice.once_in(2) { format!("{a}, {b}") } else { format!("{b}, {a}") }
        };
        let mut statements = [
            format!("link crank {{ point o = (0, 0); point p = ({crank}, 0); }}"),
            format!("link rod {{ point p = (0, 0); point q = ({rod}, 0); }}"),
            "link piston { line rail = (0, 0) -> (1, 0); point q = (0, 0); }".to_owned(),
            format!("ground {{ point o = (0, 0); line rail = ({x}, {y}) -> ({cos}, {sin}); }}"),
            format!("joint b = revolute({});", ends("crank.p", "rod.p", dice)),
            format!("joint c = revolute({});", ends("rod.q", "piston.q", dice)),
        ];
        mech_test_support::shuffle(&mut statements, dice);
        let text = format!(
            "struct M; {} joint a = revolute(ground.o, crank.o); joint x = prismatic(ground.rail, piston.rail);
            motor a; start {{ a = {}; rod near {}; }}",
            statements.concat(),
            turn + mirror * start,
            turn + mirror * lean,
        );
        Self { crank, rod, offset, turn, mirror, start: turn + mirror * start, text }
    }

    /// The place of the piston, and how it changes with the crank's angle from the rail.
    pub(super) fn at(&self, angle: f64) -> (f64, f64) {
        let across = self.offset - self.crank * angle.sin();
        let along = (self.rod * self.rod - across * across).sqrt();
        let slope = across * self.crank * angle.cos() / along - self.crank * angle.sin();
        (self.crank * angle.cos() + along, slope)
    }

    /// The crank's angles at the farthest and the nearest place: it lies in one line with the rod.
    fn turning(&self) -> [f64; 2] {
        [
            (self.offset / (self.rod + self.crank)).asin(),
            PI + (self.offset / (self.rod - self.crank)).asin(),
        ]
    }

    /// How far the crank turns while the piston is within a width of where it turns round.
    fn dwell(&self, about: f64, width: f64) -> f64 {
        let there = self.at(about).0;
        let reach = |way: f64| {
            // As far as to the other end everything is one way.
            let [mut near, mut far] = [0.0, 0.6 * PI];
            for _ in 0..80 {
                let middle = f64::midpoint(near, far);
                let is_within = (self.at(about + way * middle).0 - there).abs() <= width;
                *(if is_within { &mut near } else { &mut far }) = middle;
            }
            near
        };
        reach(1.0) + reach(-1.0)
    }

    /// The mean of something over a round.
    fn mean(&self, of: impl Fn(f64) -> f64) -> f64 {
        let places = (0..PLACES).map(|place| TAU * f64::from(place) / f64::from(PLACES));
        places.map(|angle| of(self.at(angle).0)).sum::<f64>() / f64::from(PLACES)
    }

    /// Whether a requirement is met.
    pub(super) fn meets(&self, expect: &str) -> bool {
        let text = format!("{} expect {expect};", self.text);
        match analyse(text.parse().expect("tokens")).prove().result {
            Ok(_) => true,
            Err(faults) => {
                let texts: Vec<&str> = faults.messages.iter().map(|one| &one.text[..]).collect();
                assert!(
                    texts.iter().all(|text| text.contains("does not hold")),
                    "{text}: {texts:?}"
                );
                false
            }
        }
    }

    /// Asks for limits beside a value, on both sides of it.
    fn is_decided(&self, subject: &str, value: f64, size: f64) {
        let slack = MARGIN * size;
        for (sign, limit, holds) in [
            ("<=", value + slack, true),
            (">=", value - slack, true),
            ("<=", value - slack, false),
            (">=", value + slack, false),
        ] {
            let expect = format!("{subject} {sign} {limit}");
            assert_eq!(self.meets(&expect), holds, "{expect}, {value}: {}", self.text);
        }
    }
}

#[test]
fn what_sums_up_a_way_is_that_of_closed_forms() {
    for seed in seeds(cases(4)) {
        let mut dice = Dice::new(seed);
        let slider = Slider::new(&mut dice);
        let [far, near] = slider.turning();
        let way = near - far;
        let ratio = way.max(TAU - way) / way.min(TAU - way);
        slider.is_decided("time ratio(x)", ratio, ratio);

        let stroke = slider.at(far).0 - slider.at(near).0;
        let width = stroke * dice.between(0.02, 0.3);
        let dwell = [far, near].map(|about| slider.dwell(about, width));
        let dwell = dwell[0].max(dwell[1]);
        slider.is_decided(&format!("dwell(x, {width})"), dwell, dwell);

        let mean = slider.mean(|x| x);
        slider.is_decided("mean(x)", mean, stroke);
        let rms = slider.mean(|x| (x - mean) * (x - mean)).sqrt();
        slider.is_decided(&format!("rms(x - {mean})"), rms, rms);
    }
}

#[test]
fn influence_coefficients_are_those_of_closed_forms() {
    for seed in seeds(cases(5)) {
        let slider = Slider::new(&mut Dice::new(seed));
        let places = (0..PLACES).map(|place| TAU * f64::from(place) / f64::from(PLACES));
        let fastest = places.clone().map(|angle| slider.at(angle).1.abs());
        let fastest = fastest.fold(0.0, f64::max);
        let step = 1e-4;
        let second =
            |angle: f64| (slider.at(angle + step).1 - slider.at(angle - step).1) / (2.0 * step);
        let hardest = places.map(|angle| second(angle).abs()).fold(0.0, f64::max);
        for (subject, most) in [("d(x, a)", fastest), ("d(d(x, a), a)", hardest)] {
            let within = |limit: f64| format!("abs({subject}) <= {limit}");
            assert!(slider.meets(&within(most * (1.0 + MARGIN))), "{}", slider.text);
            assert!(!slider.meets(&within(most * (1.0 - MARGIN))), "{}", slider.text);
        }
        // The first of a motor is that of itself.
        assert!(slider.meets("d(a, a) in 1 ..= 1"));
    }
}
