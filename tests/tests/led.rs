//! Points of random mechanisms are led: where the inverse has the motors' joints, the mechanism moved by its motors had them. What is
//! refused is seen in how the motors move the point, by differences.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::{
    AxisKind, Inverse, JointId, JointKind, LinkId, Model, MotorId, Origin, Range,
};
use mech_compiler::structure::{Diagnosis, InverseTrouble};
use mech_compiler::{Compiled, compile, lead};
use mech_test_support::{Dice, Sample, add_axis, for_all, samples, with_ground};
use nalgebra::DMatrix;
use std::f64::consts::TAU;

/// A point at random, and motors at random that should follow it; none of a mechanism with one motor.
fn led(model: &Model, dice: &mut Dice) -> Option<(Model, [f64; 2])> {
    let mut motors: Vec<MotorId> = model.motor_ids().collect();
    let count = 2 + dice.below(2);
    if motors.len() < count {
        return None;
    }
    while motors.len() > count {
        motors.remove(dice.below(motors.len()));
    }
    let links: Vec<LinkId> = model.declared_links().collect();
    let link = *dice.pick(&links);
    let at = [dice.between(-2.0, 2.0), dice.between(-2.0, 2.0)];
    let mut model = model.clone();
    let point = add_axis(&mut model, link, AxisKind::Point, at, [1.0, 0.0]);
    model.axes[point.index()].name = Some("tip".to_owned());
    model.inverse = Some(Inverse {
        link,
        point: Some(point),
        named: vec![Origin::default(); motors.len()],
        motors,
        region: Vec::new(),
        trajectory: Vec::new(),
        is_least: false,
        origin: Origin::default(),
    });
    Some((model, at))
}

/// The place of the point and the angle of its link.
fn place(model: &Model, at: [f64; 2], machine: &Machine<'_, f64>) -> [f64; 3] {
    let link = model.inverse.as_ref().expect("a point is led").link;
    let [cos, sin, x, y] = with_ground(model, &machine.position().poses)[link.index()];
    let place = [x + cos * at[0] - sin * at[1], y + sin * at[0] + cos * at[1]];
    [place[0], place[1], sin.atan2(cos)]
}

/// The coordinate of a joint, by where its axes are: an angle between −π and π.
fn coordinate(model: &Model, joint: JointId, machine: &Machine<'_, f64>) -> f64 {
    let poses = with_ground(model, &machine.position().poses);
    let kind = model.joint(joint).kind;
    let (JointKind::Revolute(a, b) | JointKind::Prismatic(a, b)) = kind else {
        panic!("{kind:?} has a motor");
    };
    let [(place, along), (other, along_other)] = [a, b].map(|axis| {
        let axis = model.axis(axis);
        let [cos, sin, x, y] = poses[axis.link.index()];
        let turn = |[a, b]: [f64; 2]| [cos * a - sin * b, sin * a + cos * b];
        let [px, py] = turn(axis.at);
        ([x + px, y + py], turn(axis.direction))
    });
    match kind {
        JointKind::Revolute(..) => {
            let sine = along[0] * along_other[1] - along[1] * along_other[0];
            sine.atan2(along[0] * along_other[0] + along[1] * along_other[1])
        }
        _ => (other[0] - place[0]) * along[0] + (other[1] - place[1]) * along[1],
    }
}

/// How the motors that follow move what is given from where a machine is, by differences: a column for each. None beside a dead point.
fn influence(model: &Model, at: [f64; 2], from: &Machine<'_, f64>) -> Option<DMatrix<f64>> {
    const STEP: f64 = 1e-5;
    let inverse = model.inverse.as_ref().expect("a point is led");
    let count = inverse.motors.len();
    let mut matrix = DMatrix::zeros(count, count);
    for (column, motor) in inverse.motors.iter().enumerate() {
        let end = |step: f64| {
            let mut machine = from.clone();
            let mut motors = machine.position().motors.clone();
            motors[motor.index()] += step;
            machine.move_to(&motors).ok()?;
            Some(place(model, at, &machine))
        };
        let ends = [end(STEP)?, end(-STEP)?];
        for row in 0..count {
            matrix[(row, column)] = (ends[0][row] - ends[1][row]) / (2.0 * STEP);
        }
    }
    Some(matrix)
}

/// Moves the motors a little, then leads the point of the inverse to where it is: its joints have to be where the motors are. None if
/// something stops one of the two, or if on its way the point turns back: then other values of the motors have it there, too.
fn follow(model: &Model, at: [f64; 2], compiled: &Compiled, dice: &mut Dice) -> Option<f64> {
    let inverse = model.inverse.as_ref().expect("a point is led");
    let inverted = compiled.inverse.as_ref().expect("motors follow");
    let mut forwards = Machine::<f64>::new(&compiled.program);
    let mut backwards = Machine::<f64>::new(&inverted.compiled.program);
    let mut motors = forwards.position().motors.clone();
    for motor in &mut motors {
        *motor += dice.between(-0.02, 0.02);
    }
    let sign = |machine: &Machine<'_, f64>| {
        let influence = influence(model, at, machine)?;
        Some(influence.determinant().signum())
    };
    let before = sign(&forwards)?;
    forwards.move_to(&motors).ok()?;
    if sign(&forwards)? * before < 0.0 {
        return None;
    }
    let mut target = motors.clone();
    for (motor, value) in inverse.motors.iter().zip(place(model, at, &forwards)) {
        target[motor.index()] = value;
    }
    backwards.move_to(&target).ok()?;
    let off = inverse.motors.iter().map(|motor| {
        let joint = model.motor(*motor).joint;
        let off = coordinate(&inverted.model, joint, &backwards) - motors[motor.index()];
        match model.joint(joint).kind {
            JointKind::Revolute(..) => off - TAU * (off / TAU).round(),
            _ => off,
        }
    });
    Some(off.fold(0.0, |worst, off| off.abs().max(worst)))
}

/// Asks that the point comes everywhere around its start: if that is proved, it has to come from any of these places to any other.
fn comes_everywhere(model: &Model, at: [f64; 2], compiled: &Compiled, dice: &mut Dice) -> bool {
    let start = place(model, at, &Machine::<f64>::new(&compiled.program));
    let mut bounded = model.clone();
    let inverse = bounded.inverse.as_mut().expect("a point is led");
    let ranges = start.iter().take(inverse.motors.len()).map(|start| {
        let reach = dice.between(0.02, 0.6);
        Range {
            low: start - reach * dice.between(0.1, 1.0),
            high: start + reach * dice.between(0.1, 1.0),
            origin: Origin::default(),
        }
    });
    inverse.region = ranges.collect();
    let (motors, region) = (inverse.motors.clone(), inverse.region.clone());
    let Ok(compiled) = compile(&bounded) else {
        return false;
    };
    let inverted = compiled.inverse.as_ref().expect("motors follow");
    let mut machine = Machine::<f64>::new(&inverted.compiled.program);
    for _ in 0..20 {
        let mut target = machine.position().motors.clone();
        for (motor, range) in motors.iter().zip(&region) {
            target[motor.index()] = match dice.below(4) {
                0 => range.low,
                1 => range.high,
                _ => dice.between(range.low, range.high),
            };
        }
        assert_eq!(machine.move_to(&target), Ok(()), "{target:?} of {region:?}");
    }
    true
}

/// Leads the point a little, by the interpreter: it has to come to the place, or everything stays. Returns whether it came.
fn is_led(model: &Model, at: [f64; 2], compiled: &Compiled, dice: &mut Dice) -> bool {
    let inverted = compiled.inverse.as_ref().expect("motors follow");
    let mut mechanism = Machine::<f64>::new(&compiled.program);
    let mut came = false;
    for _ in 0..4 {
        let before = mechanism.position().clone();
        let mut motors = before.motors.clone();
        for motor in &mut motors {
            *motor += dice.between(-0.02, 0.02);
        }
        let _ = mechanism.move_to(&motors);
        let here = mechanism.position().clone();
        let goal = place(model, at, &mechanism).map(|value| value + dice.between(-0.05, 0.05));
        let count = model.inverse.as_ref().expect("a point is led").motors.len();
        let mut other = Machine::<f64>::new(&inverted.compiled.program);
        let done = lead(model, compiled, (&mut mechanism, &mut other), &goal[..count]);
        if done.is_err() {
            assert_eq!(*mechanism.position(), here);
            continue;
        }
        came = true;
        let there = place(model, at, &mechanism);
        let off = there.iter().zip(&goal).take(count);
        let off = off.map(|(there, goal)| (there - goal).abs());
        let off = off.fold(0.0, f64::max);
        assert!(off < 1e-9, "{off:e}");
        // These values of the motors have it there, to the bit.
        let found = mechanism.position().clone();
        mechanism.move_to(&found.motors).expect("it stays");
        assert_eq!(mechanism.position().poses, found.poses);
    }
    came
}

#[test]
fn motors_of_random_mechanisms_follow_or_it_is_said_why_not() {
    let (mut followed, mut proved, mut stopped, mut led_there) = (0, 0, 0, 0);
    let (mut idle, mut bound, mut dead, mut coupled) = (0, 0, 0, 0);
    for_all(500, &samples(2..=8), |Sample { grown, mut dice }| {
        let plain = compile(&grown.model).expect("it is coherent by construction");
        let start = Machine::<f64>::new(&plain.program);
        let mut tried = (0..12).filter_map(|_| led(&grown.model, &mut dice));
        let Some(first) = tried.next() else {
            return;
        };
        // Motors that move the point every way are rare.
        let moves = |(model, at): &(Model, [f64; 2])| {
            let influence = influence(model, *at, &start).expect("it starts away from dead points");
            let sizes = influence.svd(false, false).singular_values;
            sizes.min() > 0.05 * sizes.max()
        };
        let (mut model, at) = tried.find(moves).unwrap_or(first);
        model.allow.coupled = dice.once_in(2);
        let inverse = model.inverse.as_ref().expect("a point is led");
        let influence = influence(&model, at, &start).expect("it starts away from dead points");
        let sizes = influence.clone().svd(false, false).singular_values;
        match compile(&model) {
            Ok(compiled) => match follow(&model, at, &compiled, &mut dice) {
                Some(off) => {
                    followed += 1;
                    let least = sizes.min();
                    assert!(off * least.min(1.0) < 1e-9, "{off:e}, of {sizes}");
                    led_there += usize::from(is_led(&model, at, &compiled, &mut dice));
                    proved += usize::from(comes_everywhere(&model, at, &compiled, &mut dice));
                }
                None => stopped += 1,
            },
            Err(diagnoses) => match &diagnoses[..] {
                [Diagnosis::Inverse { trouble }] => match trouble {
                    InverseTrouble::Idle { motors } => {
                        idle += 1;
                        for motor in motors {
                            let column = inverse.motors.iter().position(|one| one == motor);
                            let column = influence.column(column.expect("it was named"));
                            assert!(column.norm() < 1e-6, "{motor:?} moves it: {influence}");
                        }
                    }
                    InverseTrouble::Bound => {
                        bound += 1;
                        assert!(sizes.min() < 1e-5 * sizes.max(), "{influence}");
                    }
                    InverseTrouble::DeadStart { .. } => {
                        dead += 1;
                        assert!(sizes.min() < 1e-4 * sizes.max(), "{influence}");
                    }
                    InverseTrouble::Coupled { .. } => coupled += 1,
                    other => panic!("no region was asked for: {other:?}"),
                },
                other => panic!("{other:?}"),
            },
        }
    });
    println!(
        "{followed} followed, {led_there} of them led, {proved} everywhere in a region, {stopped} stopped or turned back; refused: {idle} idle, {bound} bound, {dead} at a dead point, {coupled} coupled"
    );
    assert!(followed > 30 && idle > 30 && proved > 8 && 2 * led_there > followed);
}
