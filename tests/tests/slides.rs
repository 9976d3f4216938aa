//! What only slides moves as linear algebra says: no link turns, so every joint is one linear equation. Neither order, ground, motors, the
//! two ends of a joint nor the angle of the drawing matter.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::Model;
use mech_compiler::repair::{Repair, offers};
use mech_compiler::structure::Diagnosis;
use mech_compiler::syntax::Parsed;
use mech_test_support::{Dice, cases, model, parsed, seeds, shuffle};
use nalgebra::{DMatrix, DVector, RowDVector};
use std::fmt::Write as _;

/// A joint of two bodies that slide on each other, and its direction.
struct Slide {
    from: usize,
    to: usize,
    along: [f64; 2],
}

/// A pinion on a carrier, with the radii on which bars roll: each bar, and the slide by which the carrier guides it.
struct Pinion {
    carrier: usize,
    bars: Vec<(usize, usize, f64)>,
}

/// Bodies that slide on each other; the first is the ground.
struct Network {
    bodies: usize,
    slides: Vec<Slide>,
    pinions: Vec<Pinion>,
}

impl Network {
    fn random(dice: &mut Dice) -> Self {
        let bodies = 2 + dice.below(5);
        let turned = if dice.once_in(2) { 0.0 } else { dice.between(0.0, 6.3) };
        let directions = &[[1.0, 0.0], [0.0, 1.0], [0.6, 0.8]][..=dice.below(3)];
        let mut slides: Vec<Slide> = Vec::new();
        let mut add = |dice: &mut Dice, mut ends: [usize; 2]| {
            ends.rotate_left(dice.below(2));
            let [x, y] = *dice.pick(directions);
            let sign = *dice.pick(&[1.0, -1.0]);
            let (sin, cos) = f64::sin_cos(turned);
            slides.push(Slide {
                from: ends[0],
                to: ends[1],
                along: [sign * (cos * x - sin * y), sign * (sin * x + cos * y)],
            });
        };
        // Which body is the ground does not matter to the rest.
        let shift = dice.below(bodies);
        for body in 1..bodies {
            let on = dice.below(body);
            add(dice, [(on + shift) % bodies, (body + shift) % bodies]);
        }
        for _ in 0..dice.below(4) {
            let a = dice.below(bodies);
            let b = (a + 1 + dice.below(bodies - 1)) % bodies;
            add(dice, [a, b]);
        }
        shuffle(&mut slides, dice);
        let pinions = (0..dice.below(3)).filter_map(|_| pinion(dice, bodies, &slides));
        let pinions = pinions.collect();
        Self { bodies, slides, pinions }
    }

    fn unknowns(&self) -> usize {
        2 * self.bodies + self.pinions.len()
    }

    /// What a slide's coordinate is, along its direction or across.
    fn part(&self, slide: &Slide, [x, y]: [f64; 2]) -> RowDVector<f64> {
        let mut row = RowDVector::zeros(self.unknowns());
        for (body, sign) in [(slide.to, 1.0), (slide.from, -1.0)] {
            row[2 * body] += sign * x;
            row[2 * body + 1] += sign * y;
        }
        row
    }

    /// The coordinate of a joint that can have a motor: of a slide, or of a pinion.
    fn coordinate(&self, joint: usize) -> RowDVector<f64> {
        if let Some(slide) = self.slides.get(joint) {
            return self.part(slide, slide.along);
        }
        let mut row = RowDVector::zeros(self.unknowns());
        row[2 * self.bodies + joint - self.slides.len()] = 1.0;
        row
    }

    /// What the joints hold at zero; first that the ground does not move.
    fn rows(&self) -> Vec<RowDVector<f64>> {
        let ground = |axis: usize| {
            let mut row = RowDVector::zeros(self.unknowns());
            row[axis] = 1.0;
            row
        };
        let across = self.slides.iter().map(|slide| {
            let [x, y] = slide.along;
            self.part(slide, [-y, x])
        });
        let mut rows: Vec<_> = [ground(0), ground(1)].into_iter().chain(across).collect();
        for (number, pinion) in self.pinions.iter().enumerate() {
            for &(slide, bar, radius) in &pinion.bars {
                let slide = &self.slides[slide];
                let moved = self.part(slide, slide.along);
                // The bar's displacement on the carrier, along the slide.
                let mut row = if slide.to == bar { -moved } else { moved };
                row[2 * self.bodies + number] += radius;
                rows.push(row);
            }
        }
        rows
    }

    fn text(&self, motors: &[usize], dice: &mut Dice) -> String {
        let name = |body: usize| match body {
            0 => "ground".to_owned(),
            body => format!("body{body}"),
        };
        let mut lines: Vec<String> =
            (1..self.bodies).map(|body| format!("link body{body};")).collect();
        for (number, Slide { from, to, along: [x, y] }) in self.slides.iter().enumerate() {
            let (from, to) = (name(*from), name(*to));
            let [u, v, long] = [0, 1, 2].map(|_| dice.between(0.1, 3.0));
            let (x, y) = (x * long, y * long);
            lines.push(format!(
                "joint j{number} = prismatic({from}, {to}) at ({u}, {v}) along ({x:?}, {y:?});"
            ));
        }
        for (number, Pinion { carrier, bars }) in self.pinions.iter().enumerate() {
            let carrier = name(*carrier);
            let joint = self.slides.len() + number;
            lines.push(format!("link pinion{number};"));
            lines.push(format!("joint j{joint} = revolute({carrier}, pinion{number}) at (1, 2);"));
            for (slide, bar, radius) in bars {
                let bar = name(*bar);
                lines.push(format!(
                    "joint r{number}_{slide} = rack(pinion{number}, {bar}, radius {radius:?} on {carrier});"
                ));
            }
        }
        lines.extend(motors.iter().map(|joint| format!("motor j{joint};")));
        shuffle(&mut lines, dice);
        format!("struct Slides; allow coupled; {}", lines.concat())
    }
}

/// A pinion between two bars that one body guides.
fn pinion(dice: &mut Dice, bodies: usize, slides: &[Slide]) -> Option<Pinion> {
    let carrier = dice.below(bodies);
    let beyond = |slide: &Slide| match (slide.from == carrier, slide.to == carrier) {
        (true, _) => Some(slide.to),
        (_, true) => Some(slide.from),
        _ => None,
    };
    let guided = (0..slides.len()).filter_map(|slide| Some((slide, beyond(&slides[slide])?)));
    let guided: Vec<(usize, usize)> = guided.collect();
    // Of a bar on two guides of one carrier it is not said which counts.
    let once = |&&(_, bar): &&(usize, usize)| {
        guided.iter().filter(|(_, other)| *other == bar).count() == 1
    };
    let bars = guided.iter().filter(once).take(2);
    let bars: Vec<_> =
        bars.map(|&(slide, bar)| (slide, bar, *dice.pick(&[1.0, -1.0, 0.5, -2.0]))).collect();
    (bars.len() == 2).then_some(Pinion { carrier, bars })
}

fn matrix(rows: &[RowDVector<f64>]) -> DMatrix<f64> {
    DMatrix::from_rows(rows)
}

fn rank(rows: &[RowDVector<f64>]) -> usize {
    matrix(rows).rank(1e-9)
}

fn allowing_redundant(model: &Model) -> Model {
    let mut model = model.clone();
    model.allow.redundant = true;
    model
}

#[test]
fn networks_of_slides_move_as_linear_algebra_says() {
    let (mut moved, mut redundant, mut wrong) = (0, 0, 0);
    for seed in seeds(cases(400)) {
        let dice = &mut Dice::new(seed);
        let network = Network::random(dice);
        let rows = network.rows();
        let (held, unknowns) = (rank(&rows), network.unknowns());
        // Motors until nothing is free; sometimes one less or one more.
        let joints = network.slides.len() + network.pinions.len();
        let mut order: Vec<usize> = (0..joints).collect();
        shuffle(&mut order, dice);
        let mut motors: Vec<usize> = Vec::new();
        let mut driven = rows.clone();
        for &joint in &order {
            driven.push(network.coordinate(joint));
            if rank(&driven) < held + motors.len() + 1 {
                driven.pop();
            } else {
                motors.push(joint);
            }
        }
        match dice.below(8) {
            0 => {
                motors.pop();
            }
            1 => motors.extend(order.iter().find(|joint| !motors.contains(joint))),
            _ => {}
        }
        driven.truncate(rows.len());
        driven.extend(motors.iter().map(|&joint| network.coordinate(joint)));
        let all = rank(&driven);
        let text = network.text(&motors, dice);
        let Parsed { model, source, .. } = parsed(&text);
        let is_redundant = rows.len() > held;
        let compiled = compile(&allowing_redundant(&model));
        if all < unknowns || held + motors.len() > all || motors.is_empty() {
            let diagnoses = compiled.expect_err(&text);
            let names = |diagnosis: &Diagnosis| match diagnosis {
                Diagnosis::TooManyMotors { .. } | Diagnosis::Blocked { .. } => {
                    held + motors.len() > all
                }
                Diagnosis::Undetermined { freedom, .. } | Diagnosis::NoMotor { freedom, .. } => {
                    *freedom == unknowns - all
                }
                Diagnosis::Overdetermined { .. } => is_redundant,
                Diagnosis::Rigid => held == unknowns,
                _ => false,
            };
            assert!(diagnoses.iter().all(names), "{diagnoses:?}: {text}");
            wrong += 1;
            continue;
        }
        let program = compiled.unwrap_or_else(|found| panic!("{found:?}: {text}")).program;
        let mut machine = Machine::<f64>::new(&program);
        let mut values = vec![0.0; rows.len()];
        let wanted: Vec<f64> = model.motors.iter().map(|_| dice.between(-2.0, 2.0)).collect();
        // The text has its motors in another order.
        let value = |joint: &usize| {
            let mut names = model.motors.iter().map(|motor| &model.joint(motor.joint).name);
            wanted[names.position(|name| *name == format!("j{joint}")).expect("it is declared")]
        };
        values.extend(motors.iter().map(value));
        machine.move_to(&wanted).unwrap_or_else(|stop| panic!("{stop:?}: {text}"));
        let svd = matrix(&driven).svd(true, true);
        let should = svd.solve(&DVector::from_vec(values), 1e-9).expect("both bases are there");
        for (link, pose) in model.moving_links().zip(&machine.position().poses) {
            let name = &model.link(link).name;
            let (at, turn) = match (name.strip_prefix("body"), name.strip_prefix("pinion")) {
                (Some(body), _) => (body.parse().ok(), 0.0),
                (_, Some(pinion)) => {
                    let pinion: usize = pinion.parse().expect("a number");
                    (None, should[2 * network.bodies + pinion])
                }
                _ => panic!("no other link is declared"),
            };
            let mut off = f64::hypot(pose[0] - turn.cos(), pose[1] - turn.sin());
            if let Some(body) = at {
                let body: usize = body;
                off += f64::hypot(pose[2] - should[2 * body], pose[3] - should[2 * body + 1]);
            }
            assert!(off < 1e-11, "{name} is off by {off:e}: {text}");
        }
        moved += 1;
        // What is held twice asks for its allowance, and nothing else does.
        match compile(&model) {
            Ok(_) => assert!(!is_redundant, "{text}"),
            Err(diagnoses) => {
                let is_mobile =
                    matches!(diagnoses[..], [Diagnosis::Overdetermined { is_mobile: true, .. }]);
                assert!(is_redundant && is_mobile, "{diagnoses:?}: {text}");
                let found = offers(&model, &source, &diagnoses);
                assert!(found[0].single.contains(&Repair::AllowRedundant), "{text}");
                redundant += 1;
            }
        }
    }
    println!("{moved} moved, of which {redundant} are redundant; {wrong} are rightly refused");
    assert!(moved > 100 && redundant > 30 && wrong > 20, "{moved} {redundant} {wrong}");
}

/// The load of a sheave goes half as far as both strands together, however it is turned and whatever drives it.
#[test]
fn two_strands_over_a_sheave_carry_it_half_as_far() {
    for (x, y) in [(0.0, 1.0), (1.0, 0.0), (3.0, 4.0), (-0.7, 0.2)] {
        for (first, second) in
            [("s", "t"), ("t", "b"), ("b", "s"), ("s", "h"), ("h", "b"), ("u", "t")]
        {
            let mut text =
                "struct Sheave; link block; link left; link right; link sheave; allow redundant;"
                    .to_owned();
            for (name, from, to) in [
                ("b", "ground", "block"),
                ("s", "ground", "left"),
                ("t", "right", "ground"),
                ("u", "block", "left"),
                ("v", "block", "right"),
            ] {
                write!(
                    text,
                    "joint {name} = prismatic({from}, {to}) at (0, 0) along ({x:?}, {y:?});"
                )
                .expect("text");
            }
            text += "joint h = revolute(block, sheave) at (0, 0);
                joint k = rack(sheave, left, radius 2 on block); joint l = rack(sheave, right, radius -2 on block);";
            let model = model(&format!("{text} motor {first}; motor {second};"));
            let compiled =
                compile(&model).unwrap_or_else(|found| panic!("{first} {second}: {found:?}"));
            let mut machine = Machine::<f64>::new(&compiled.program);
            machine.move_to(&[0.7, -0.4]).expect("nothing stops it");
            let at = |name: &str| {
                let mut links = model.moving_links();
                let place = links.position(|link| model.link(link).name == name).expect("a link");
                let [.., u, v] = machine.position().poses[place];
                (u * x + v * y) / f64::hypot(x, y)
            };
            let off = at("block") - f64::midpoint(at("left"), at("right"));
            assert!(off.abs() < 1e-13, "{first} {second}: {off:e}");
            let value = |joint: &str| match joint {
                "b" => at("block"),
                "s" => at("left"),
                "t" => -at("right"),
                "u" => at("left") - at("block"),
                _ => (at("left") - at("block")) / 2.0,
            };
            let driven = [value(first) - 0.7, value(second) + 0.4];
            assert!(driven.iter().all(|off| off.abs() < 1e-13), "{first} {second}: {driven:?}");
        }
    }
}
