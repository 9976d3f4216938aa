//! Gears, racks and cams that cannot be.

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

// No link carries both wheels of a gear.
mechanism! {
    struct GearWithoutCarrier;

    ground { point o = (0.0, 0.0); point p = (3.0, 0.0); }
    link pinion { point shaft = (0.0, 0.0); }
    link arm { point pivot = (0.0, 0.0); point shaft = (1.0, 0.0); }
    link wheel { point shaft = (0.0, 0.0); }

    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, arm.pivot);
    joint c = revolute(arm.shaft, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);

    motor a;
    motor b;
}

// Both wheels of a gear turn on the ground as well as on a bracket.
mechanism! {
    struct GearWithSeveralCarriers;

    ground { point o = (0.0, 0.0); point p = (3.0, 0.0); }
    link bracket { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link pinion { point shaft = (0.0, 0.0); }
    link wheel { point shaft = (0.0, 0.0); }

    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, wheel.shaft);
    joint c = revolute(bracket.left, pinion.shaft);
    joint d = revolute(bracket.right, wheel.shaft);
    joint mesh = gear(pinion, wheel, 20 : 40);

    motor a;
}

// Nothing guides the bar of a rack.
mechanism! {
    struct RackAlongNoLine;

    ground { point o = (0.0, 0.0); point p = (0.0, 0.5); }
    link pinion { point shaft = (0.0, 0.0); }
    link bar { point end = (0.0, 0.0); }

    joint a = revolute(ground.o, pinion.shaft);
    joint b = revolute(ground.p, bar.end);
    joint teeth = rack(pinion, bar, radius 0.5);

    motor a;
}

mechanism! {
    struct CamDrivenBackwards;
    link disk;
    link lever;
    link rod;
    joint s = revolute(ground, disk) at (0, 0);
    joint f = revolute(ground, lever) at (3, 0);
    joint r = revolute(lever, rod) at (3, 1);
    joint c = cam(s, f, 0.2 * sin(q));
    motor f;
    motor r;
}

fn main() {}
