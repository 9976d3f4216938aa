use mech_runtime::mechanism;

mechanism! {
    struct Arm;
    link upper;
    link forearm { point hand = (3, 1); }
    link finger;
    joint shoulder = revolute(ground, upper) at (0, 0);
    joint elbow = revolute(upper, forearm) at (2, 0);
    joint knuckle = revolute(forearm, finger) at (3, 1);
    motor shoulder;
    motor elbow;
    motor knuckle;
    follow forearm.hand by shoulder, knuckle;
}

mechanism! {
    struct Misread;
    link upper;
    link forearm { point hand = (3, 1); line edge = (3, 1) -> (1, 0); }
    joint shoulder = revolute(ground, upper) at (0, 0);
    joint elbow = revolute(upper, forearm) at (2, 0);
    motor shoulder;
    motor elbow;
    follow forearm by shoulder, elbow;
}

mechanism! {
    struct Wiped;
    link upper;
    link forearm { point hand = (3, 1); line edge = (3, 1) -> (1, 0); }
    joint shoulder = revolute(ground, upper) at (0, 0);
    joint elbow = revolute(upper, forearm) at (2, 0);
    motor shoulder = 2 * t;
    motor elbow;
    follow forearm.edge by shoulder, elbow, elbow, wrist;
}

mechanism! {
    struct Plotter;
    link left; link right; link rod;
    link pen { point tip = (0, 4); }
    joint l = revolute(ground, left) at (-1, 0);
    joint r = revolute(ground, right) at (1, 0);
    joint lk = revolute(left, pen) at (-2.4, 1.8);
    joint rk = revolute(right, rod) at (2.4, 1.8);
    joint tip = revolute(pen, rod) at (0, 4);
    motor l;
    motor r;
    follow pen.tip in (-1.5 ..= 1.5, 2.5 ..= 6) by l, r;
}

fn main() {
    let mut arm = Arm::new();
    let _ = arm.reach([1.0, 2.0]);
}
