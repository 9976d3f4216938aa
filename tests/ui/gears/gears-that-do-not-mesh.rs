use mech_runtime::mechanism;

mechanism! {
    struct TooLarge;
    link pinion;
    link wheel;
    joint a = revolute(ground, pinion) at (0, 0);
    joint b = revolute(ground, wheel) at (3, 0);
    joint mesh = gear(pinion, wheel, 1.0 : 5.0);
    motor a;
}

mechanism! {
    struct RingTooNear;
    link pinion;
    link ring;
    joint a = revolute(ground, pinion) at (0, 0);
    joint b = revolute(ground, ring) at (3, 0);
    joint mesh = gear(pinion, ring, 1.0 : -1.5);
    motor a;
}

mechanism! {
    struct RingTooSmall;
    link pinion;
    link ring;
    joint a = revolute(ground, pinion) at (0, 0);
    joint b = revolute(ground, ring) at (3, 0);
    joint mesh = gear(pinion, ring, 30 : -20);
    motor a;
}

mechanism! {
    struct OneShaft;
    ground { point shaft = (0, 0); }
    link minute { point shaft = (0, 0); }
    link hour { point shaft = (0, 0); }
    joint a = revolute(ground.shaft, minute.shaft);
    joint b = revolute(ground.shaft, hour.shaft);
    joint mesh = gear(minute, hour, 1 : 12);
    motor a;
}

mechanism! {
    struct Mixed;
    link pinion;
    link wheel;
    joint a = revolute(ground, pinion) at (0, 0);
    joint b = revolute(ground, wheel) at (3, 0);
    joint mesh = gear(pinion, wheel, 20 : 1.5);
    motor a;
}

fn main() {}
