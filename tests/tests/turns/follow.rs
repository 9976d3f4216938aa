//! A mechanism beside itself in small steps, in which the coordinates of joints are followed by hand.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{Between, JointId, Model};
use mech_compiler::program::{Forces, Position};
use mech_test_support::{coordinate, with_ground};
use std::f64::consts::TAU;

/// A joint's coordinate between −π and π, computed from the poses alone.
fn principal(model: &Model, joint: JointId, position: &Position<f64>) -> f64 {
    coordinate(model, &with_ground(model, &position.poses), joint).0
}

/// The value of an angle that is nearest to another one.
fn near(principal: f64, last: f64) -> f64 {
    principal + TAU * ((last - principal) / TAU).round()
}

/// The first part of a move by so much: all motors keep the proportion of their displacements.
fn part(from: &[f64], displacement: &[f64], part: f64) -> Vec<f64> {
    let both = from.iter().zip(displacement);
    both.map(|(from, displacement)| from + displacement * part).collect()
}

/// A mechanism that moves in small steps, and the coordinates of some of its joints, over any number of turns.
struct Follower<'a> {
    model: &'a Model,
    machine: Machine<'a, f64>,
    angles: Vec<(JointId, f64)>,
    step: f64,
}

impl Follower<'_> {
    /// Moves all motors by so much; whether it went all the way.
    fn move_by(&mut self, displacement: &[f64]) -> bool {
        let from = self.machine.position().motors.clone();
        let longest =
            displacement.iter().fold(0.0_f64, |most, displacement| most.max(displacement.abs()));
        let pieces = (longest / self.step).ceil().max(1.0);
        let mut piece = 0.0;
        while piece < pieces {
            piece += 1.0;
            let between = part(&from, displacement, piece / pieces);
            if self.machine.move_to(&between).is_err() {
                return false;
            }
            for (joint, angle) in &mut self.angles {
                let principal = principal(self.model, *joint, self.machine.position());
                *angle = near(principal, *angle);
            }
        }
        true
    }
}

/// Makes each of these moves at once, and by hand in steps of this length: all coordinates are the same. If it has a spring, that has the
/// energy of its coordinate, and the torques that hold it are slopes of that.
pub(super) fn follow(model: &Model, moves: &[Vec<f64>], step: f64, about: &str) {
    let compiled = compile(model).unwrap_or_else(|wrong| panic!("{wrong:?}\n{about}"));
    let program = &compiled.program;
    let mut machine = Machine::<f64>::new(program);
    let spring = model.actions.springs.first().map(|spring| {
        let Between::Joint(joint) = spring.between else {
            panic!("it turns");
        };
        (joint, spring)
    });
    let sprung = spring.map(|(joint, _)| joint);
    let joints = model.continuous_joints().into_iter().chain(sprung);
    let angle = |joint| (joint, principal(model, joint, machine.position()));
    let mut slow =
        Follower { model, angles: joints.map(angle).collect(), machine: machine.clone(), step };
    for by in moves {
        let to = part(&machine.position().motors, by, 1.0);
        let went = machine.move_to(&to).is_ok();
        assert_eq!(went, slow.move_by(by), "{about}");
        if !went {
            assert!(spring.is_none(), "it turns for ever\n{about}");
            return;
        }
        for &(joint, angle) in &slow.angles {
            let Some(state) = program.angle_state(joint) else {
                assert!(model.motor_of(joint).is_some(), "it is carried");
                continue;
            };
            let reported = machine.position().state[state];
            let exact = near(principal(model, joint, machine.position()), reported);
            let name = &model.joint(joint).name;
            assert!(
                (reported - angle).abs() < 1e-6 * (1.0 + angle.abs())
                    && (reported - exact).abs() < 1e-9 * (1.0 + reported.abs()),
                "{name} is reported to be at {reported}, by hand {angle}, but looks like {exact}\n{about}\n{moves:?}"
            );
        }
        let Some((joint, spring)) = spring else {
            continue;
        };
        let (_, angle) = slow.angles[slow.angles.len() - 1];
        let forces = |program| {
            let mut there = Machine::<f64>::new(program);
            there.put_back(machine.position().clone());
            let zero = vec![0.0; by.len()];
            there.forces(&zero, &zero, &[])
        };
        let [inertia, holding] = [&compiled.forced.inertia, &compiled.forced.holding]
            .map(|program| forces(program.as_ref().expect("asked for")));
        let (Ok(Forces::Inertia(felt)), Ok(Forces::Holding(torques))) = (inertia, holding) else {
            panic!("no forces\n{about}");
        };
        let by_hand = |angle: f64| spring.stiffness / 2.0 * (angle - spring.rest).powi(2);
        let (reported, expected) = (felt.energy[1], by_hand(angle));
        assert!(
            (reported - expected).abs() <= 1e-8 * (1.0 + expected),
            "energy {reported}, by hand {expected} at {angle}\n{about}\n{moves:?}"
        );
        for (motor, torque) in torques.iter().enumerate() {
            let h = 1e-4 * step;
            let energy = |by: f64| {
                let mut machine = slow.machine.clone();
                let mut to = machine.position().motors.clone();
                to[motor] += by;
                machine.move_to(&to).expect("so near");
                by_hand(near(principal(model, joint, machine.position()), angle))
            };
            let slope = (8.0 * (energy(h) - energy(-h)) - (energy(2.0 * h) - energy(-2.0 * h)))
                / (12.0 * h);
            let rounding = 1e-14 * expected / h + 1e-6 * (1.0 + slope.abs());
            assert!(
                (torque - slope).abs() <= rounding,
                "torque {torque}, slope {slope} at {angle}\n{about}\n{moves:?}"
            );
        }
    }
}
