//! The player and the macro agree on the same text, to the bit.

use crate::gallery::{from_rust, from_text};
use mech_gallery::{Exhibited, Visitor, visit_f32, visit_f64};
use mech_runtime::Real;
use mech_runtime::overlay::Spot;

/// Steps of a whole motion.
const STEPS: u32 = 240;

/// Moves both through the motion of the gallery, and looks at two points of each link.
struct Judge {
    /// The clause of precision after the name of a mechanism.
    precision: &'static str,
    names: Vec<&'static str>,
}

impl Visitor for Judge {
    fn visit<M: Exhibited>(&mut self) {
        let [plain, precise] = ["", self.precision].map(|end| format!("struct {}{end};", M::NAME));
        let mut played = from_rust(&M::SOURCE.replace(&plain, &precise));
        let mut compiled = M::new();
        assert_eq!(played.title(), M::NAME);
        for step in 0..=STEPS {
            let phase = f64::from(step) / f64::from(STEPS);
            let motors = M::motion(Real::from_f64(phase));
            compiled.move_to(motors).expect("it moves");
            let values: Vec<f64> = motors.as_ref().iter().map(|value| value.to_f64()).collect();
            assert_eq!(played.move_toward(&values), None);
            for (number, pose) in compiled.poses().iter().enumerate() {
                let pose = mech_runtime::Pose {
                    cos: pose.cos.to_f64(),
                    sin: pose.sin.to_f64(),
                    x: pose.x.to_f64(),
                    y: pose.y.to_f64(),
                };
                for at in [[0.0, 0.0], [1.0, 0.5]] {
                    let link = number + 1;
                    let place = played.place(Spot { link, at }).expect("it has that link");
                    let expected = pose.apply(at);
                    assert_eq!(
                        place.map(f64::to_bits),
                        expected.map(f64::to_bits),
                        "{} at {phase}, link {link}: {place:?}, not {expected:?}",
                        M::NAME
                    );
                }
            }
        }
        self.names.push(M::NAME);
    }
}

#[test]
fn all_of_the_gallery_is_played_as_it_is_compiled() {
    let judges = ["", ": f32"].map(|precision| {
        let mut judge = Judge { precision, names: Vec::new() };
        match precision {
            "" => visit_f64(&mut judge),
            _ => visit_f32(&mut judge),
        }
        judge.names.len()
    });
    assert_eq!(judges, [crate::gallery::FILES.len(); 2]);
}

/// An end of a range is where single precision has it: what stands there is not beyond it, and goes on.
#[test]
fn ends_of_ranges_are_rounded() {
    let mut played = from_text(
        "struct Table: f32; link cart; link tool; joint x = prismatic(ground, cart) at (0, 0) along (1, 0);
        joint y = prismatic(cart, tool) at (0, 1) along (0, 1); motor x in 0 ..= 0.1; motor y in 0 ..= 1;",
    );
    assert!(played.move_toward(&[0.5, 0.0]).is_some());
    let end = f64::from(0.1_f32);
    assert_eq!(played.motors(), [end, 0.0]);
    assert_eq!(played.move_toward(&[end, 0.5]), None);
    assert_eq!(played.motors(), [end, 0.5]);
}
