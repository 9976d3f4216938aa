//! One mechanism for each kind of loop, and some that use what the gallery does not.

pub(crate) mod rolling;
pub(crate) mod special;

use mech_runtime::mechanism;

mechanism! {
    /// RRP: a slider-crank whose guide is slanted, and declared from the block to the ground.
    pub struct SlantedGuide;
    link crank;
    link rod;
    link block;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0.2);
    joint c = revolute(rod, block) at (4, 1);
    joint x = prismatic(block, ground) at (4, 1) along (1, 0.3);
    motor a;
}

mechanism! {
    /// RPR: a swinging sleeve, as in a shaper's quick return.
    pub struct QuickReturn;
    const CRANK = 1.0;
    ground { point crank_shaft = (0, 2); point arm_shaft = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (CRANK, 0); }
    link die { point pin = (0, 0); line way = (0, 0) -> (1, 0); }
    link arm { point shaft = (0, 0); line way = (0, 0) -> (1, 0); point tip = (5, 0); }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, die.pin);
    joint x = prismatic(arm.way, die.way);
    joint d = revolute(ground.arm_shaft, arm.shaft);
    motor a;
    start { arm near 63 deg; }
    method newton(4);
}

mechanism! {
    /// PRP: an elliptic trammel driven along one of its guides.
    pub struct Trammel;
    link across;
    link up;
    link beam { point pen = (5, -1); }
    joint x = prismatic(ground, across) at (3, 0) along (1, 0);
    joint y = prismatic(ground, up) at (0, 2) along (0, 1);
    joint a = revolute(across, beam) at (3, 0);
    joint b = revolute(up, beam) at (0, 2);
    motor x;
}

mechanism! {
    /// RPP: a scotch yoke. The block keeps its direction: its two slides are solved by one linear step.
    pub struct ScotchYoke;
    link crank;
    link block;
    link yoke;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, block) at (1, 0.5);
    joint s = prismatic(block, yoke) at (1, 0.5) along (0.2, 1);
    joint x = prismatic(ground, yoke) at (2, 0) along (1, 0);
    motor a;
}

mechanism! {
    /// A four-bar that rides on a crank, and is driven there: its loop is closed before it is placed.
    pub struct Rider;
    link carrier;
    link crank;
    link coupler { point tip = (5, 4); }
    link rocker;
    joint a = revolute(carrier, crank) at (1, 0);
    joint b = revolute(crank, coupler) at (1.5, 0.8);
    joint c = revolute(coupler, rocker) at (4, 2.5);
    joint d = revolute(carrier, rocker) at (4.5, 0);
    joint base = revolute(ground, carrier) at (0, 0);
    motor a;
    motor base;
}

mechanism! {
    /// A gear on the rocker of a four-bar: its angle is followed over any number of turns of the crank.
    pub struct GearOnRocker;
    link crank;
    link coupler;
    link rocker;
    link wheel { point mark = (7, 0); }
    link pointer { point mark = (9, 1); }
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.6, 0.8);
    joint c = revolute(coupler, rocker) at (4, 3);
    joint d = revolute(ground, rocker) at (4, 0);
    joint e = revolute(ground, wheel) at (6, 0);
    joint f = revolute(ground, pointer) at (9, 0);
    joint inner = gear(rocker, wheel, -60 : 13);
    joint outer = gear(wheel, pointer, 1.8 : 1.2);
    motor a;
}

mechanism! {
    /// In single precision.
    pub struct Single: f32;
    ground { point crank_shaft = (0, 0); point rocker_shaft = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point a = (0, 0); point b = (3.5, 0); }
    link rocker { point shaft = (0, 0); point b = (3, 0); }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.a);
    joint c = revolute(coupler.b, rocker.b);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);
    motor a;
    start { coupler near 50 deg; a = 30 deg; }
}
