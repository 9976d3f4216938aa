//! The emitted four-bar beside a hand-written Newton iteration: same geometry, same rounds, same guard, one process,
//! interleaved rounds, medians.

use mech_test_support::side_by_side;
use std::hint::black_box;

macro_rules! emitted {
    ($name:ident, $rounds:literal) => {
        mech_test_support::four_bar!(struct $name: f64; motor a; method newton($rounds););
    };
}

emitted!(Emitted2, 2);
emitted!(Emitted3, 3);

/// The same four-bar as a programmer would write it who knows the subject.
#[derive(Clone, Copy)]
struct ByHand {
    coupler: (f64, f64),
    rocker: (f64, f64),
    /// Cosine, sine, x and y of the crank, the coupler and the rocker.
    poses: [[f64; 4]; 3],
}

impl ByHand {
    const GROUND: f64 = 4.0;
    const COUPLER: f64 = 3.5;
    const ROCKER: f64 = 3.0;

    fn new(start: [[f64; 4]; 3]) -> Self {
        Self {
            coupler: (start[1][0], start[1][1]),
            rocker: (start[2][0], start[2][1]),
            poses: start,
        }
    }

    fn move_to<const ROUNDS: usize>(&mut self, crank: f64) -> bool {
        if !crank.is_finite() {
            return false;
        }
        let (sin, cos) = libm::sincos(crank);
        let ((mut uc, mut us), (mut vc, mut vs)) = (self.coupler, self.rocker);
        for _ in 0..ROUNDS {
            let (ax, ay) = (Self::COUPLER * uc, Self::COUPLER * us);
            let (bx, by) = (Self::ROCKER * vc, Self::ROCKER * vs);
            let (gx, gy) = (cos - Self::GROUND + ax - bx, sin + ay - by);
            let inverse = 1.0 / (ax * by - ay * bx);
            let turn_coupler = -(bx * gx + by * gy) * inverse;
            let turn_rocker = -(ax * gx + ay * gy) * inverse;
            (uc, us) = turned(uc, us, turn_coupler);
            (vc, vs) = turned(vc, vs, turn_rocker);
        }
        let gx = cos - Self::GROUND + Self::COUPLER * uc - Self::ROCKER * vc;
        let gy = sin + Self::COUPLER * us - Self::ROCKER * vs;
        let sine = us * vc - uc * vs;
        if !(gx.abs() <= 1e-5 && gy.abs() <= 1e-5 && sine.abs() >= 1e-14) {
            return false;
        }
        self.coupler = (uc, us);
        self.rocker = (vc, vs);
        self.poses = [[cos, sin, 0.0, 0.0], [uc, us, cos, sin], [vc, vs, Self::GROUND, 0.0]];
        true
    }
}

/// Turned by a small angle without trigonometry: its length stays.
fn turned(c: f64, s: f64, angle: f64) -> (f64, f64) {
    let t = 0.5 * angle;
    let factor = 2.0 / (1.0 + t * t);
    let (cos, sin) = (factor - 1.0, t * factor);
    (c * cos - s * sin, s * cos + c * sin)
}

/// One turn, a degree a step.
fn turn(mut step: impl FnMut(f64)) {
    for degree in 1..=360 {
        step(f64::from(degree).to_radians());
    }
}

macro_rules! compare {
    ($emitted:ident, $rounds:literal) => {{
        let mut emitted = $emitted::new();
        let mut by_hand = ByHand::new(emitted.poses().map(|pose| [pose.cos, pose.sin, pose.x, pose.y]));
        turn(|angle| {
            emitted.move_to([angle]).expect("the crank turns");
            assert!(by_hand.move_to::<$rounds>(angle), "the crank turns");
            for (a, b) in emitted.poses().iter().zip(by_hand.poses) {
                let off = (a.cos - b[0]).abs().max((a.sin - b[1]).abs()).max((a.x - b[2]).abs()).max((a.y - b[3]).abs());
                assert!(off < 1e-12, "both compute the same: {off}");
            }
        });
        let times = side_by_side(
            || turn(|angle| assert!(black_box(&mut emitted).move_to([black_box(angle)]).is_ok())),
            || turn(|angle| assert!(black_box(&mut by_hand).move_to::<$rounds>(black_box(angle)))),
        );
        println!(
            "four-bar, {} rounds, f64, 1° a step: emitted {:.1} ns, by hand {:.1} ns, ratio {:.2} (at most 1.30)",
            $rounds,
            times.first / 360.0,
            times.second / 360.0,
            times.ratio
        );
    }};
}

fn main() {
    compare!(Emitted2, 2);
    compare!(Emitted3, 3);
}
