//! A part is what its statements are where they are typed out: mirrored, scaled, turned and moved as its use says.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointKind, Model};
use mech_compiler::{Compiled, compile};
use mech_runtime::Pose;
use mech_test_support::{Dice, Sample, for_all, model, part_of, samples, text};

/// What the use of a part does to its drawing.
#[derive(Clone, Copy, Debug)]
struct Placement {
    is_mirrored: bool,
    scale: f64,
    angle: f64,
    at: [f64; 2],
}

impl Placement {
    fn random(dice: &mut Dice) -> Self {
        Self {
            is_mirrored: dice.once_in(2),
            scale: dice.between(0.3, 3.0),
            angle: dice.between(-3.0, 3.0),
            at: [dice.between(-5.0, 5.0), dice.between(-5.0, 5.0)],
        }
    }

    /// Where a place of the drawing is.
    fn apply(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let x = if self.is_mirrored { -x } else { x };
        let (sin, cos) = self.angle.sin_cos();
        [
            self.at[0] + self.scale * (cos * x - sin * y),
            self.at[1] + self.scale * (sin * x + cos * y),
        ]
    }

    fn written(&self) -> (String, String) {
        let mirrored = if self.is_mirrored { " mirrored" } else { "" };
        let [x, y] = self.at;
        (
            format!("{mirrored} scaled {:?}", self.scale),
            format!(" at ({x:?}, {y:?}) turned {:?}", self.angle),
        )
    }
}

/// The mechanism as a part that is used, once or several times; motors and what is allowed stay outside.
fn as_part(typed_out: &str, how: &str, at: &str, count: usize) -> String {
    let (body, motors, allowed) = part_of(typed_out);
    let motors = motors.iter().flat_map(|joint| {
        (0..count).map(move |instance| format!("motor used[{instance}].{joint}\n"))
    });
    let motors: String = motors.collect();
    format!(
        "struct Grown;\npart Whole {{\n{body}}}\nuse used[{count}]: Whole{how} {{ frame = ground{at} }};\n{motors}{allowed}"
    )
}

fn compiled(model: &Model) -> Option<Compiled> {
    compile(model).ok()
}

#[test]
fn a_part_is_what_is_typed_out_to_the_bit() {
    for_all(150, &samples(1..=8), |Sample { grown, mut dice }| {
        // A text gives no links frames of their own.
        let written = text(&grown.model);
        let typed_out = model(&written);
        let used = model(&as_part(&written, "", "", 1));
        let (Some(one), Some(other)) = (compiled(&typed_out), compiled(&used)) else {
            panic!("a part of what is coherent is coherent");
        };
        let mut machines = [&one, &other].map(|compiled| Machine::<f64>::new(&compiled.program));
        let mut motors = vec![0.0; typed_out.motors.len()];
        for _ in 0..5 {
            for motor in &mut motors {
                *motor += dice.between(-0.05, 0.05);
            }
            let [first, second] = &mut machines;
            assert_eq!(first.move_to(&motors).is_ok(), second.move_to(&motors).is_ok());
            assert_eq!(first.position().poses, second.position().poses);
        }
    });
}

#[test]
fn a_use_mirrors_scales_turns_and_moves_every_motion() {
    for_all(150, &samples(1..=6), |Sample { grown, mut dice }| {
        let written = text(&grown.model);
        let typed_out = model(&written);
        let placement = Placement::random(&mut dice);
        let (how, at) = placement.written();
        let used = model(&as_part(&written, &how, &at, 1));
        let one = compiled(&typed_out).expect("it grew coherent");
        let other = compiled(&used).unwrap_or_else(|| panic!("{placement:?}"));
        let mut plain = Machine::<f64>::new(&one.program);
        let mut placed = Machine::<f64>::new(&other.program);
        let mut motors = vec![0.0; typed_out.motors.len()];
        for _ in 0..5 {
            for motor in &mut motors {
                *motor += dice.between(-0.02, 0.02);
            }
            let theirs = typed_out.motors.iter().zip(&motors).map(|(motor, value)| match typed_out
                .joint(motor.joint)
                .kind
            {
                JointKind::Revolute(..) if placement.is_mirrored => -value,
                JointKind::Revolute(..) => *value,
                _ => placement.scale * value,
            });
            let theirs: Vec<f64> = theirs.collect();
            if plain.move_to(&motors).is_err() {
                break;
            }
            placed.move_to(&theirs).expect("the image moves as it does");
            let size = placement.scale * (1.0 + mech_test_support::size(&typed_out));
            let poses = plain.position().poses.iter();
            for (pose, image) in poses.zip(&placed.position().poses) {
                let [pose, image] = [*pose, *image].map(Pose::from);
                for point in [[0.0, 0.0], [1.0, 0.5]] {
                    let expected = placement.apply(pose.apply(point));
                    let found = image.apply(placement.apply(point));
                    let gap = (found[0] - expected[0]).hypot(found[1] - expected[1]);
                    assert!(gap < 1e-7 * size, "{gap:e} {placement:?}");
                }
            }
        }
    });
}

#[test]
fn instances_do_not_disturb_each_other() {
    for_all(60, &samples(1..=5), |Sample { grown, mut dice }| {
        let written = text(&grown.model);
        let typed_out = model(&written);
        let used = model(&as_part(&written, "", "", 3));
        let one = compiled(&typed_out).expect("it grew coherent");
        let other = compiled(&used).expect("three of it are coherent");
        let (links, count) = (one.program.poses.len(), typed_out.motors.len());
        let mut machine = Machine::<f64>::new(&other.program);
        let mut alone: Vec<_> = (0..3).map(|_| Machine::<f64>::new(&one.program)).collect();
        let motors: Vec<f64> = (0..3 * count).map(|_| dice.between(-0.03, 0.03)).collect();
        // Motors stand by joints, instances within.
        let of = |instance: usize| -> Vec<f64> {
            (0..count).map(|motor| motors[3 * motor + instance]).collect()
        };
        let reached =
            alone.iter_mut().enumerate().all(|(k, machine)| machine.move_to(&of(k)).is_ok());
        if !reached || machine.move_to(&motors).is_err() {
            return;
        }
        // Dies of slots have poses nobody asks for; declared links come first, instance by instance.
        let declared = typed_out.declared_links().count();
        for (k, alone) in alone.iter().enumerate() {
            let poses = &machine.position().poses[k * declared..(k + 1) * declared];
            for (a, b) in alone.position().poses[..declared.min(links)]
                .iter()
                .flatten()
                .zip(poses.iter().flatten())
            {
                assert!((a - b).abs() < 1e-9, "{a} {b}");
            }
        }
    });
}
