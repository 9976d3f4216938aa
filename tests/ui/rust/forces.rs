//! What a mechanism with forces would have is known, though the mechanism is refused.

use mech_runtime::mechanism;

mechanism! {
    struct Massless;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); mass 1 at (1, 0); }
    link tip { point pin = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, tip.pin);
    motor a;
    motor b;
    effects { force; dynamics; }
}

fn main() {
    let mut massless = Massless::new();
    let _ = massless.hold_at([0.0, 1.0]);
    let _ = massless.forces([0.0, 1.0], [0.0, 0.0]);
    let _ = massless.simulate(0.1, [0.0, 0.0]);
    let _: Result<[f64; 2], _> = massless.energy();
    let _: Result<[f64; 2], _> = massless.come_to_rest([true, false]);
}
