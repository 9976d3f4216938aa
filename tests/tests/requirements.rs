//! What is expected of a mechanism, against what is measured of its poses: a limit a little beyond the true extreme is proved, one a little
//! within is refused with a place where the mechanism breaks it. Four-bars have closed forms.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::{AxisId, AxisKind, JointId, JointKind, LinkId, Model, Precision};
use mech_compiler::program::Program;
use mech_compiler::structure::{Diagnosis, RequirementTrouble};
use mech_compiler::{Analysis, analyse, compile};

use mech_test_support::{
    Dice, cases, coordinate, folder, for_all, four_bar_text, known_texts, samples, seeds, text,
    with_ground,
};
use proc_macro2::TokenStream;
use std::f64::consts::{PI, TAU};

/// A limit is so far from the true extreme, as a part of what the quantity makes.
const MARGIN: f64 = 1e-3;
/// Places that are looked at, each way from the start.
const PLACES: u32 = 2000;

/// Something that can be measured from poses.
#[derive(Clone, Copy)]
pub(super) enum Subject {
    Place(AxisId, usize),
    Coordinate(JointId),
}

impl Subject {
    pub(super) fn all(model: &Model) -> Vec<(String, Self)> {
        let axes = (0..model.axes.len()).map(AxisId::new);
        let points = axes.filter_map(|id| {
            let axis = model.axis(id);
            let is_moving = axis.kind == AxisKind::Point && axis.link != LinkId::GROUND;
            let name = axis.name.as_ref().filter(|_| is_moving)?;
            Some((id, format!("{}.{name}", model.owner_of(axis))))
        });
        let places = points.flat_map(|(id, name)| {
            [(0, "x"), (1, "y")]
                .map(|(part, word)| (format!("{name}.{word}"), Self::Place(id, part)))
        });
        let has_coordinate = |joint: &JointId| {
            let kind = model.joint(*joint).kind;
            matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..))
        };
        let joints = model.declared_joints().filter(has_coordinate);
        let joints = joints.filter(|joint| model.motor_of(*joint).is_none());
        let coordinates = joints.map(|joint| {
            let name = model.joint(joint).name.clone();
            (name, Self::Coordinate(joint))
        });
        places.chain(coordinates).collect()
    }

    /// Its value, near to what it was before if it is an angle.
    pub(super) fn of(self, model: &Model, declared: &[[f64; 4]], before: Option<f64>) -> f64 {
        let poses = with_ground(model, declared);
        match self {
            Self::Place(axis, part) => {
                let axis = model.axis(axis);
                let [cos, sin, x, y] = poses[axis.link.index()];
                let [u, v] = axis.at;
                [x + cos * u - sin * v, y + sin * u + cos * v][part]
            }
            Self::Coordinate(joint) => match (coordinate(model, &poses, joint), before) {
                ((angle, true), Some(before)) => angle + TAU * ((before - angle) / TAU).round(),
                ((value, _), _) => value,
            },
        }
    }
}

/// The machine at a place to which the motors go together, or one after the other; none if they do not come there.
fn at<'p>(program: &'p Program, place: &[f64]) -> Option<Machine<'p, f64>> {
    let mut machine = Machine::new(program);
    if machine.move_to(place).is_err() {
        let mut values = program.start.motors.clone();
        for (motor, goal) in place.iter().enumerate() {
            values[motor] = *goal;
            machine.move_to(&values).ok()?;
        }
    }
    Some(machine)
}

/// The values of a motor between which it certainly goes, from a place where it is at its start.
pub(super) fn reach(model: &Model, program: &Program, from: &[f64], motor: usize) -> [f64; 2] {
    let start = from[motor];
    if let Some(range) = model.motors[motor].range {
        return [range.low, range.high];
    }
    let far = match model.joint(model.motors[motor].joint).kind {
        JointKind::Revolute(..) => PI,
        _ => 0.5 * model.size(),
    };
    [-far, far].map(|far| {
        let mut machine = at(program, from).expect("it was there");
        let mut goal = from.to_vec();
        goal[motor] = start + far;
        machine.move_toward(&goal).expect("finite values");
        // Beside a dead point everything is fast.
        start + 0.9 * (machine.position().motors[motor] - start)
    })
}

/// The least and the greatest value of a subject on the way of one motor, from a place.
fn extremes(
    model: &Model,
    program: &Program,
    subject: Subject,
    (from, motor): (&[f64], usize),
    ends: [f64; 2],
) -> [f64; 2] {
    let start = from[motor];
    let mut found = [f64::INFINITY, f64::NEG_INFINITY];
    for end in ends {
        let mut machine = at(program, from).expect("it was there");
        let mut value = None;
        for place in 0..=PLACES {
            let mut goal = from.to_vec();
            goal[motor] = start + (end - start) * f64::from(place) / f64::from(PLACES);
            machine.move_to(&goal).expect("it goes there");
            let now = subject.of(model, &machine.position().poses, value);
            value = Some(now);
            found = [found[0].min(now), found[1].max(now)];
        }
    }
    found
}

pub(super) fn judged(body: &TokenStream, requirement: &str) -> Analysis {
    let mut all = body.clone();
    all.extend(requirement.parse::<TokenStream>().expect("tokens"));
    analyse(all).prove()
}

/// The troubles with the requirements of a mechanism.
pub(super) fn troubles(analysis: &Analysis) -> Vec<RequirementTrouble> {
    let Err(faults) = &analysis.result else {
        return Vec::new();
    };
    let unmet = faults.diagnoses.iter().map(|diagnosis| match diagnosis {
        Diagnosis::Unmet { trouble, .. } => trouble.clone(),
        other => panic!("{other:?}: {:?}", faults.messages),
    });
    let unmet: Vec<RequirementTrouble> = unmet.collect();
    assert!(!unmet.is_empty(), "{:?}", faults.messages);
    unmet
}

/// How many limits were proved or refused, and how many were left open.
#[derive(Debug, Default)]
struct Count {
    decided: usize,
    iterated: usize,
    open: usize,
}

impl Count {
    /// Asks for limits of everything in a mechanism beside its extremes, for one motor.
    #[expect(clippy::too_many_lines, reason = "one question after the other")]
    fn judge(&mut self, body: &TokenStream, dice: &mut Dice, most: usize) {
        let analysis = analyse(body.clone());
        let whole = Model {
            show: None,
            method: None,
            accuracy: None,
            precision: Precision::F64,
            ..analysis.parsed.model
        };
        let Ok(compiled) = compile(&whole) else {
            return;
        };
        let program = &compiled.program;
        if whole.motors.is_empty() || !whole.params.is_empty() {
            return;
        }
        let motor = dice.below(whole.motors.len());
        let name = |motor: usize| &whole.joint(whole.motors[motor].joint).name;
        let others = (0..whole.motors.len()).filter(|other| *other != motor);
        // Half of the others stand elsewhere than at their start.
        let mut from = program.start.motors.clone();
        for other in others.clone() {
            if dice.once_in(2) {
                continue;
            }
            let ends = reach(&whole, program, &from, other);
            let mut place = from.clone();
            place[other] = dice.between(ends[0], ends[1]);
            if at(program, &place).is_some() {
                from = place;
            }
        }
        let others: Vec<String> = others
            .map(|other| format!("{} = {}", name(other), from[other]))
            .collect();
        let [low, high] = reach(&whole, program, &from, motor);
        let others = if others.is_empty() {
            String::new()
        } else {
            format!(" at {}", others.join(", "))
        };
        let when = format!("for {} in {low} ..= {high}{others};", name(motor));
        let mut subjects = Subject::all(&whole);
        while subjects.len() > most {
            subjects.swap_remove(dice.below(subjects.len()));
        }
        for (subject, measured) in subjects {
            let [least, greatest] =
                extremes(&whole, program, measured, (&from, motor), [low, high]);
            let wide = greatest - least;
            if wide <= 1e-6 * whole.size() || wide > 6.0 * whole.size().max(1.0) {
                continue;
            }
            let slack = MARGIN * wide;
            let limit = |value: f64| match measured {
                Subject::Coordinate(joint)
                    if matches!(whole.joint(joint).kind, JointKind::Revolute(..)) =>
                {
                    format!("{} deg", value.to_degrees())
                }
                _ => format!("{value}"),
            };
            let ways = [
                ("<=", greatest + slack, greatest - slack),
                (">=", least - slack, least + slack),
            ];
            for (sign, beyond, within) in ways {
                let right = judged(
                    body,
                    &format!("expect {subject} {sign} {} {when}", limit(beyond)),
                );
                let wrong = judged(
                    body,
                    &format!("expect {subject} {sign} {} {when}", limit(within)),
                );
                let told = || format!("{} {subject} {sign} {beyond} {when}", whole.name);
                match &troubles(&right)[..] {
                    [] => self.decided += 1,
                    [RequirementTrouble::Iterated { .. }] => self.iterated += 1,
                    [RequirementTrouble::Undecided { .. } | RequirementTrouble::TooHard] => {
                        self.open += 1;
                    }
                    other => panic!("{}: {other:?}", told()),
                }
                match &troubles(&wrong)[..] {
                    [RequirementTrouble::Fails(witness)] => {
                        let [place] = &witness.places[..] else {
                            panic!("{}: {witness:?}", told());
                        };
                        let mut goal = program.start.motors.clone();
                        for (motor, value) in &place.motors {
                            goal[motor.index()] = *value;
                        }
                        let machine = at(program, &goal).expect("a witness is reached");
                        let poses = &machine.position().poses;
                        let value = measured.of(&whole, poses, Some(witness.value));
                        let breaks = if sign == "<=" {
                            value > within
                        } else {
                            value < within
                        };
                        assert!(breaks, "{}: {value} at {goal:?}", told());
                        assert!(
                            (value - witness.value).abs() < 1e-7 * whole.size().max(1.0),
                            "{}",
                            told()
                        );
                        self.decided += 1;
                    }
                    [RequirementTrouble::Iterated { .. }] => self.iterated += 1,
                    [RequirementTrouble::Undecided { .. } | RequirementTrouble::TooHard] => {
                        self.open += 1;
                    }
                    other => panic!("{}, less {slack}: {other:?}", told()),
                }
            }
        }
    }
}

#[test]
fn limits_beside_true_extremes_are_decided_in_the_gallery() {
    let (mut count, mut dice) = (Count::default(), Dice::new(3));
    for body in known_texts() {
        count.judge(&body, &mut dice, 3);
    }
    println!("{count:?}");
    assert!(
        count.decided > 100 && 20 * count.open <= count.decided,
        "{count:?}"
    );
}

/// `MECH_TEXTS=DIRECTORY` asks of all texts there.
#[test]
fn limits_beside_true_extremes_are_decided_in_other_texts() {
    let Ok(texts) = std::env::var("MECH_TEXTS") else {
        return;
    };
    let (mut count, mut dice) = (Count::default(), Dice::new(4));
    let files = std::fs::read_dir(texts).expect("a directory");
    let paths = files.map(|file| file.expect("a file").path());
    for path in paths.filter(|path| path.extension().is_some_and(|ending| ending == "mech")) {
        let body = std::fs::read_to_string(&path).expect("a text");
        let Ok(body) = body.parse::<TokenStream>() else {
            continue;
        };
        let before = count.open;
        count.judge(&body, &mut dice, 4);
        if count.open > before {
            println!("{}: {} open", path.display(), count.open - before);
        }
    }
    println!("{count:?}");
}

#[test]
fn limits_beside_true_extremes_are_decided_in_random_mechanisms() {
    let (mut count, mut dice) = (Count::default(), Dice::new(5));
    for_all(25, &samples(1..4), |sample| {
        let body = text(&sample.grown.model).parse().expect("tokens");
        count.judge(&body, &mut dice, 2);
    });
    println!("{count:?}");
    assert!(
        count.decided > 20 && 10 * count.open <= count.decided,
        "{count:?}"
    );
}

/// The lengths of a crank and rocker: the crank is shortest, and with the longest link shorter than the two others.
fn crank_rocker(dice: &mut Dice) -> [f64; 4] {
    loop {
        let crank = dice.between(0.2, 1.0);
        let [ground, coupler, rocker] = [0; 3].map(|_| dice.between(1.1, 4.0));
        let longest = ground.max(coupler).max(rocker);
        let others = ground + coupler + rocker - longest;
        if crank + longest < 0.98 * others {
            return [ground, crank, coupler, rocker];
        }
    }
}

/// A four-bar that starts with its crank at this angle in degrees, and its rocker above.
fn four_bar(lengths: [f64; 4], start: f64) -> TokenStream {
    let start = format!("start {{ ja = {start} deg; rocker near 90 deg; }}");
    let text = four_bar_text(lengths) + &start;
    text.parse().expect("tokens")
}

/// The angle between two sides of a triangle, less than a right one, opposite to a third.
fn between([a, b]: [f64; 2], opposite: f64) -> f64 {
    let cos = (a * a + b * b - opposite * opposite) / (2.0 * a * b);
    cos.abs().min(1.0).acos()
}

#[test]
fn transmission_and_swing_of_four_bars_are_those_of_their_triangles() {
    for seed in seeds(cases(8)) {
        let mut dice = Dice::new(seed);
        let lengths @ [ground, crank, coupler, rocker] = crank_rocker(&mut dice);
        let body = four_bar(lengths, 60.0);
        let ends = [ground - crank, ground + crank];
        let least = ends.map(|distance| between([coupler, rocker], distance));
        let least = least[0].min(least[1]);
        // At the ends of the swing crank and coupler lie in one line.
        let at = |reach: f64| {
            let cos = (ground * ground + rocker * rocker - reach * reach) / (2.0 * ground * rocker);
            cos.acos()
        };
        let swing = at(coupler + crank) - at((coupler - crank).abs());
        for (subject, sign, extreme) in [
            ("transmission", ">=", least),
            ("swing(jd)", ">=", swing),
            ("swing(jd)", "<=", swing),
            ("max(jd) - min(jd)", "<=", swing),
        ] {
            let way = if sign == "<=" { 1.0 } else { -1.0 };
            let [beyond, within] = [MARGIN, -MARGIN].map(|part| extreme * (1.0 + way * part));
            let ask = |limit: f64| judged(&body, &format!("expect {subject} {sign} {limit};"));
            let right = troubles(&ask(beyond));
            assert!(
                right.is_empty(),
                "{lengths:?} {subject} {sign} {beyond}: {right:?}"
            );
            let wrong = troubles(&ask(within));
            let [RequirementTrouble::Fails(witness)] = &wrong[..] else {
                panic!("{lengths:?} {subject} {sign} {within}: {wrong:?}");
            };
            assert!(
                (witness.value - extreme).abs() < 1e-3 * extreme,
                "{lengths:?} {subject}: {witness:?}, {extreme}"
            );
        }
        let round = judged(&body, "expect turns(ja);");
        assert!(troubles(&round).is_empty(), "{lengths:?}");
    }
}

#[test]
fn a_motor_that_is_stopped_does_not_turn() {
    for seed in seeds(cases(8)) {
        let mut dice = Dice::new(seed);
        let [ground, crank, coupler, rocker] = crank_rocker(&mut dice);
        // The rocker drives.
        let lengths = [ground, rocker, coupler, crank];
        let cos = |reach: f64| {
            (ground * ground + rocker * rocker - reach * reach) / (2.0 * ground * rocker)
        };
        let ends = [coupler + crank, (coupler - crank).abs()].map(|reach| cos(reach).acos());
        let body = four_bar(lengths, f64::midpoint(ends[0], ends[1]).to_degrees());
        let found = troubles(&judged(&body, "expect turns(ja);"));
        let [RequirementTrouble::Stops { limit, .. }] = &found[..] else {
            panic!("{lengths:?}: {found:?}");
        };
        let off = ends.map(|end| (limit - end).abs());
        assert!(
            off[0].min(off[1]) < 1e-6,
            "{lengths:?}: {limit} is not at {ends:?}"
        );
    }
}

/// Texts beside which it stands what is proved of them: cases, and machines of others with what is known of these.
#[test]
fn texts_are_judged_as_it_stands_beside_them() {
    let machines = folder("../tests/subjects/machines");
    for case in folder("required").into_iter().chain(machines) {
        let body: TokenStream = case.text.parse().expect("tokens");
        for line in case.marks("holds") {
            let found = troubles(&judged(&body, &format!("expect {line};")));
            assert!(found.is_empty(), "{}: {line}: {found:?}", case.name);
        }
        for line in case.marks("open") {
            let found = troubles(&judged(&body, &format!("expect {line};")));
            let is_open = matches!(found[..], [RequirementTrouble::NoRange { .. }]);
            assert!(is_open, "{}: {line}: {found:?}", case.name);
        }
        for line in case.marks("unproved") {
            let found = troubles(&judged(&body, &format!("expect {line};")));
            assert!(!found.is_empty(), "{}: {line}", case.name);
        }
        for line in case.marks("fails") {
            let found = troubles(&judged(&body, &format!("expect {line};")));
            let is_refused = matches!(
                found[..],
                [RequirementTrouble::Fails(_) | RequirementTrouble::Stops { .. }]
            );
            assert!(is_refused, "{}: {line}: {found:?}", case.name);
        }
    }
}
