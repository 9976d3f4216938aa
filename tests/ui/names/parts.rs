//! Ports that are not lent, or twice; paths that lead nowhere; what does not belong into a part.

use mech_runtime::mechanism;

mechanism! {
    struct Arms;

    part Arm(reach = 1) {
        port frame { point pivot = (0, 0); }
        link bar { point pivot = (0, 0); point tip = (raech, 0); }
        joint pivot = revolute(frame.pivot, bar.pivot);
        motor pivot;
        gravity (0, -9.81);
    }

    use left[2]: Arm(reach = k + 1) { frame = ground };
    use right: Arm { };
    use both: Arm { frame = ground, frame = left[0].bar };
    use none: Leg { frame = ground };

    motor left[2].pivot;
    motor left.pivot;
    motor right[0].pivot;
    motor left[1].elbow;
}

fn main() {
    // What is wrong in the mechanism is said there alone.
    let arms = Arms::new();
    println!("{}", arms.left(1).bar_tip());
}
