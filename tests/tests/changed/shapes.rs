//! Shapes that depend on params: what is painted is what a mechanism paints in which they are numbers.

use crate::recorder::Recorder;
use mech_runtime::{Blocked, Cause, Frame, Mechanism, Outline, Pose, Smooth, View, mechanism};

/// A crank whose shapes are made of params, or of constants.
macro_rules! painted {
    ($name:ident: $scalar:ident, $word:ident $radius:tt $length:tt) => {
        mechanism! {
            struct $name: $scalar;
            $word radius = $radius;
            $word length = $length;
            ground {
                point o = (0, 0);
                polygon [(-2, -2), (2, -2), (length, -3)] on plane -1;
                circle (0, 0) radius 0.1 on plane 5;
            }
            link crank {
                point o = (0, 0);
                point tip = (length, 0);
                bar [(0, 0), (length, 0), (length, 1)] width radius / 2;
                circle (length / 2, -1) radius radius color 40;
                circle (1, 1) radius 0.25;
                ring (length, 2) radius 2 * radius hole radius on plane 3;
            }
            joint a = revolute(ground.o, crank.o);
            motor a;
            effects { trace crank.tip 8; }
        }
    };
}

painted!(Changed: f64, param 0.5 2.0);
painted!(Declared: f64, const 0.75 3.0);
painted!(AtStart: f64, const 0.5 2.0);
painted!(Small: f32, param 0.5 2.0);

/// Everything that is painted.
fn list<M: Mechanism>(mechanism: &M) -> Vec<String> {
    let mut list = Vec::new();
    mechanism.draw(&mut Recorder {
        scale: 1.0,
        fill: |outline: Outline<'_, M::Scalar>, pose: Pose<M::Scalar>, color: u8| {
            list.push(format!("{outline:?} {pose:?} {color}"));
        },
    });
    list
}

#[test]
fn shapes_follow_the_params() {
    let (mut changed, mut declared) = (Changed::new(), Declared::new());
    changed.set_params([0.75, 3.0]).expect("it closes");
    let view = View::fit([-5.0, -5.0], [5.0, 5.0], 120, 90, 2.0);
    for step in 0..20 {
        let motors = [0.3 * f64::from(step)];
        changed.move_to(motors).expect("a crank turns");
        declared.move_to(motors).expect("a crank turns");
        assert!(list(&declared).len() > 12);
        // What was traced before is elsewhere.
        changed.clear_traces();
        declared.clear_traces();
        assert_eq!(list(&changed), list(&declared));
        let (mut hard, mut expected) = (Frame::<120, 90>::new(), Frame::<120, 90>::new());
        hard.look_at(view);
        expected.look_at(view);
        changed.draw(&mut hard);
        declared.draw(&mut expected);
        assert_eq!(hard.pixels(), expected.pixels());
    }
    assert_ne!(list(&Changed::new()), list(&changed));
}

#[test]
fn tables_are_as_at_the_start() {
    assert_eq!(Changed::SHAPES, AtStart::SHAPES);
    assert_eq!(Changed::EXTENT, AtStart::EXTENT);
    assert_eq!(list(&Changed::new()), list(&AtStart::new()));
}

/// What has no size is not seen, and nothing panics.
#[test]
fn lengths_may_become_negative() {
    for radius in [-1.0_f32, 0.0, 1e30, -1e30, f32::MIN_POSITIVE] {
        let mut small = Small::new();
        small.set_params([radius, -3.0]).expect("nothing is in the way");
        let (mut hard, mut smooth) = (Small::picture::<64, 48>(), Smooth::<64, 64>::new());
        small.draw(&mut hard);
        small.draw(&mut smooth);
    }
    let mut small = Small::new();
    let before = small;
    let Blocked { cause, .. } = small.set_radius(f32::NAN).expect_err("not a number");
    assert_eq!((cause, small), (Cause::NotFinite, before));
}
