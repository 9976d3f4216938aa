//! Anything a hand can declare: never a panic, and whatever is accepted closes.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::{
    Allowances, AxisKind, Formula, Formulas, Joint, JointId, JointKind, Law, LawId, Link, LinkId,
    Model, Motor, Origin, Ratio,
};
use mech_compiler::{Compiled, compile, reporter};
use mech_test_support::{
    Dice, add_axis, dice, for_all, law, reach, slip, text, with_ground, worst_gap,
};
use proptest::collection::vec;
use proptest::prelude::Strategy;
use std::fmt;

/// Coordinates on a coarse grid, so that axes coincide, lie in line and run parallel.
fn spot(dice: &mut Dice) -> [f64; 2] {
    let n = |dice: &mut Dice| f64::from(u32::try_from(dice.below(4)).unwrap_or(0));
    [n(dice), n(dice)]
}

/// Whatever a hand declares.
struct Declared {
    model: Model,
    dice: Dice,
}

impl fmt::Debug for Declared {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}with {:?}", text(&self.model), self.dice)
    }
}

/// Up to six links and thirteen joints, which are left out where a test fails without them.
fn declarations() -> impl Strategy<Value = Declared> {
    (dice(), vec(dice(), 1..=13))
        .prop_map(|(mut dice, joints)| Declared { model: anything(&mut dice, &joints), dice })
}

fn anything(dice: &mut Dice, joints: &[Dice]) -> Model {
    let mut model = Model::new("Anything", Origin::default());
    let drawn = !dice.once_in(4);
    // A joint for each link, up to one more than two.
    let (fewest, most) = ((joints.len() - 1).div_ceil(2).max(1), joints.len().min(6));
    let links = fewest + dice.below(most - fewest + 1);
    for number in 0..links {
        let mut link = Link::new(&format!("l{number}"), Origin::default());
        link.drawn = drawn;
        model.links.push(link);
    }
    let mut slots = Vec::new();
    for (number, mut dice) in joints.iter().cloned().enumerate() {
        let dice = &mut dice;
        let [a, b] = [dice.below(links + 1), 1 + dice.below(links)].map(LinkId::new);
        if a == b {
            continue;
        }
        let (p, q) = (spot(dice), spot(dice));
        let q = if drawn { p } else { q };
        let d = *dice.pick(&[[1.0, 0.0], [0.0, 1.0], [0.6, 0.8]]);
        let points = |model: &mut Model| {
            [(a, p), (b, q)]
                .map(|(link, at)| add_axis(model, link, AxisKind::Point, at, [1.0, 0.0]))
        };
        let kind = match dice.below(12) {
            0..=5 => {
                let [a, b] = points(&mut model);
                JointKind::Revolute(a, b)
            }
            6 | 7 => JointKind::Prismatic(
                add_axis(&mut model, a, AxisKind::Line, p, d),
                add_axis(&mut model, b, AxisKind::Line, q, d),
            ),
            8 => {
                let [a, b] = points(&mut model);
                JointKind::Weld(a, b)
            }
            9 => JointKind::Gear {
                a,
                b,
                ratio: Ratio::Teeth(20, *dice.pick(&[20, -40, 17])),
                on: None,
            },
            10 => JointKind::Rack { pinion: a, bar: b, radius: 0.5, on: None },
            _ => {
                slots.push((
                    add_axis(&mut model, a, AxisKind::Point, p, [1.0, 0.0]),
                    add_axis(&mut model, b, AxisKind::Line, q, d),
                ));
                continue;
            }
        };
        model.joints.push(Joint {
            name: format!("j{number}"),
            origin: Origin::default(),
            kind,
            hidden: false,
        });
    }
    for (index, (point, line)) in slots.into_iter().enumerate() {
        model.add_slot(&format!("s{index}"), Origin::default(), point, line);
    }
    for joint in model.joint_ids().collect::<Vec<_>>() {
        let drives =
            matches!(model.joint(joint).kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
        if drives && !model.joint(joint).hidden && dice.once_in(3) && model.motors.len() < 3 {
            model.motors.push(Motor::new(JointId::new(joint.index()), Origin::default()));
        }
    }
    model.allow = Allowances { redundant: dice.once_in(2), coupled: dice.once_in(2) };
    model
}

/// Cams between joints that have a coordinate and a link in common.
fn put_cams(model: &mut Model, dice: &mut Dice) {
    let moves = |id: &JointId| {
        let joint = model.joint(*id);
        let kinds = matches!(joint.kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
        kinds && !joint.hidden
    };
    let joints: Vec<JointId> = model.joint_ids().filter(moves).collect();
    if joints.is_empty() {
        return;
    }
    for number in 0..=dice.below(2) {
        let (shaft, follower) = (*dice.pick(&joints), *dice.pick(&joints));
        if shaft == follower || model.carrier_of_cam(shaft, follower).is_none() {
            continue;
        }
        let text = *dice.pick(&[
            "0.3 * sin(t)",
            "0.2 * (1 - cos(2 * t))",
            "t",
            "0.5",
            "1 / t",
            "sqrt(0.2 - t) - sqrt(0.2)",
            "max(0, 0.4 * sin(t))",
            "exp(t) - 1",
        ]);
        let law = if text == "1 / t" { reciprocal() } else { law(text) };
        model.laws.push(law);
        model.joints.push(Joint {
            name: format!("c{number}"),
            origin: Origin::default(),
            kind: JointKind::Cam { shaft, follower, law: LawId::new(model.laws.len() - 1) },
            hidden: false,
        });
    }
}

/// The law 1 / t, which a motor cannot start with.
fn reciprocal() -> Law {
    let mut formulas = Formulas::default();
    let (variable, one) =
        (formulas.add(Formula::Variable(0)), formulas.add(Formula::constant(1.0)));
    let quotient = formulas.add(Formula::Div(one, variable));
    Law::new(formulas, quotient, "1 / t".to_owned(), Origin::default())
}

/// After a small motion what rolls has moved by its ratio.
fn no_slip(model: &Model, compiled: &Compiled) {
    let mut machine = Machine::<f64>::new(&compiled.program);
    let start = with_ground(model, &machine.position().poses);
    let start_motors = machine.position().motors.iter();
    let motors: Vec<f64> = start_motors.map(|motor| motor + 1e-3).collect();
    if machine.move_to(&motors).is_err() {
        return;
    }
    let poses = with_ground(model, &machine.position().poses);
    for rolling in &compiled.structure.rollings {
        let slip = slip(model, rolling, [&start, &poses]);
        assert!(slip.abs() < 1e-10, "it slips by {slip:e}");
    }
}

#[test]
fn anything_at_all() {
    try_all(&declarations());
}

#[test]
fn anything_with_cams() {
    try_all(&declarations().prop_map(|Declared { mut model, mut dice }| {
        put_cams(&mut model, &mut dice);
        Declared { model, dice }
    }));
}

fn try_all(declared: &impl Strategy<Value = Declared>) {
    let [mut all, mut accepted, mut moved] = [0, 0, 0];
    for_all(500, declared, |Declared { model, mut dice }| {
        all += 1;
        let compiled = match compile(&model) {
            Ok(compiled) => compiled,
            Err(diagnoses) => {
                assert!(!diagnoses.is_empty());
                for diagnosis in &diagnoses {
                    assert!(!reporter::text(diagnosis, &model).is_empty());
                }
                return;
            }
        };
        accepted += 1;
        no_slip(&model, &compiled);
        let mut machine = Machine::<f64>::new(&compiled.program);
        for _ in 0..10 {
            let motors: Vec<f64> = machine
                .position()
                .motors
                .iter()
                .map(|motor| motor + dice.between(-0.5, 0.5))
                .collect();
            let before = machine.position().clone();
            if machine.move_to(&motors).is_err() {
                assert_eq!(machine.position(), &before);
                continue;
            }
            moved += 1;
            let poses = with_ground(&model, &machine.position().poses);
            assert!(poses.iter().flatten().all(|number| number.is_finite()));
            let reach = reach(&poses).max(10.0);
            let gap = worst_gap(&model, &poses);
            assert!(gap < 1e-11 * reach, "gap {gap:e}");
        }
    });
    println!("{accepted} of {all} accepted, {moved} moves");
    assert!(accepted > all / 100 && moved > accepted, "{accepted} of {all}, {moved} moves");
}
