//! Gears, belts and racks.

use mech_runtime::mechanism;

mechanism! {
    /// Sun 5, planet 1, ring 7 on the ground: the arm turns 5/12 of the sun.
    pub struct Planetary;
    ground { point shaft = (0, 0); }
    link sun { point shaft = (0, 0); }
    link arm { point shaft = (0, 0); point pin = (6, 0); }
    link planet { point pin = (0, 0); point mark = (1, 0); }
    joint s = revolute(ground.shaft, sun.shaft);
    joint a = revolute(ground.shaft, arm.shaft);
    joint p = revolute(arm.pin, planet.pin);
    joint inner = gear(sun, planet, 5 : 1);
    joint outer = gear(planet, ground, 1 : -7);
    motor s;
}

mechanism! {
    /// The same with ring and sun both driven: a differential.
    pub struct Differential;
    ground { point shaft = (0, 0); }
    link sun { point shaft = (0, 0); }
    link ring { point shaft = (0, 0); }
    link arm { point shaft = (0, 0); point pin = (6, 0); }
    link planet { point pin = (0, 0); }
    joint s = revolute(ground.shaft, sun.shaft);
    joint r = revolute(ground.shaft, ring.shaft);
    joint a = revolute(ground.shaft, arm.shaft);
    joint p = revolute(arm.pin, planet.pin);
    joint inner = gear(sun, planet, 5 : 1);
    joint outer = gear(planet, ring, 1 : -7);
    motor s;
    motor r;
}

mechanism! {
    /// A compound train: wheels in pairs on common shafts, 8 : 60, 10 : 64, 12 : 75 and a belt 2 : 3.
    pub struct Clock;
    link first;
    link second;
    link third;
    link fourth;
    link fifth;
    joint a = revolute(ground, first) at (0, 0);
    joint b = revolute(ground, second) at (3, 0);
    joint c = revolute(ground, third) at (6, 0);
    joint d = revolute(ground, fourth) at (9, 0);
    joint e = revolute(ground, fifth) at (12, 0);
    joint ab = gear(first, second, 8 : 60);
    joint bc = gear(second, third, 10 : 64);
    joint cd = gear(third, fourth, 12 : 75);
    joint de = belt(fourth, fifth, 2 : 3);
    motor a;
}

mechanism! {
    /// A pinion between two racks, the upper one on the other side; the lower one is driven.
    pub struct TwoRacks;
    link pinion;
    link lower { point mark = (1, -0.5); }
    link upper { point mark = (1, 0.5); }
    joint a = revolute(ground, pinion) at (0, 0);
    joint low = prismatic(ground, lower) at (0, -0.5) along (1, 0);
    joint up = prismatic(upper, ground) at (0, 0.5) along (1, 0);
    joint mesh = rack(pinion, lower, radius 0.5);
    joint across = rack(pinion, upper, radius -0.5);
    motor low;
}

mechanism! {
    /// A wheel that rolls along a rack on the ground, below it: it is carried by a slide.
    pub struct Rolling;
    ground { line rail = (0, 0) -> (1, 0); }
    link carriage { line rail = (0, 0) -> (1, 0); point axle = (0, 1); }
    link wheel { point axle = (0, 0); point rim = (0, -1); }
    joint x = prismatic(ground.rail, carriage.rail);
    joint a = revolute(carriage.axle, wheel.axle);
    joint mesh = rack(wheel, ground, radius 1);
    motor x;
}

mechanism! {
    /// A five-bar whose two cranks are geared to each other: one motor.
    pub struct GearedFiveBar;
    link left;
    link right;
    link rod;
    link arm { point pen = (2.2, 4); }
    joint a = revolute(ground, left) at (0, 0);
    joint b = revolute(left, rod) at (0, 1);
    joint c = revolute(rod, arm) at (2, 3);
    joint d = revolute(arm, right) at (4, 1.2);
    joint e = revolute(ground, right) at (4, 0);
    joint mesh = gear(left, right, -30 : 20);
    motor a;
}

mechanism! {
    /// The geared five-bar, driven between its two rods: the cranks are unknown, and tied to each other.
    pub struct TiedFiveBar;
    link left;
    link right;
    link rod;
    link arm { point pen = (2.2, 4); }
    joint a = revolute(ground, left) at (0, 0);
    joint b = revolute(left, rod) at (0, 1);
    joint c = revolute(rod, arm) at (2, 3);
    joint d = revolute(arm, right) at (4, 1.2);
    joint e = revolute(ground, right) at (4, 0);
    joint mesh = gear(left, right, -30 : 20);
    motor c;
}
