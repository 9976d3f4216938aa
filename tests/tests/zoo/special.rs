//! Slots, welds, wedges, and what needs an `allow`.

use mech_runtime::mechanism;

mechanism! {
    /// A pin in a slot: the quick return without a die.
    pub struct SlottedArm;
    ground { point crank_shaft = (0, 2); point arm_shaft = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link arm { point shaft = (0, 0); line way = (0, 0) -> (1, 0); }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint x = slot(crank.pin, arm.way);
    joint d = revolute(ground.arm_shaft, arm.shaft);
    motor a;
    start { arm near 63 deg; }
}

mechanism! {
    /// A crank-rocker whose rocker carries a welded hand, in the drawing.
    pub struct Welded;
    link crank;
    link coupler;
    link rocker;
    link hand { point tip = (6, 5); }
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.6, 0.8);
    joint c = revolute(coupler, rocker) at (4, 3);
    joint d = revolute(ground, rocker) at (4, 0);
    joint w = weld(rocker, hand) at (4, 2);
    motor a;
}

mechanism! {
    /// Three slides and one freedom: a wedge lifts a follower.
    pub struct Wedge;
    link wedge;
    link follower { point tip = (2, 3); }
    joint x = prismatic(ground, wedge) at (0, 0) along (1, 0);
    joint face = prismatic(wedge, follower) at (2, 1) along (2, 1);
    joint y = prismatic(ground, follower) at (2, 2) along (0, 1);
    motor x;
}

mechanism! {
    /// A parallelogram with a third parallel crank: once more than it takes.
    pub struct ThreeCranks;
    link first;
    link second;
    link third;
    link rail { point tip = (5, 2); }
    joint a = revolute(ground, first) at (0, 0);
    joint b = revolute(ground, second) at (2, 0);
    joint c = revolute(ground, third) at (4, 0);
    joint d = revolute(first, rail) at (0.5, 1);
    joint e = revolute(second, rail) at (2.5, 1);
    joint f = revolute(third, rail) at (4.5, 1);
    motor a;
    allow redundant;
}

mechanism! {
    /// Four equal gears in a ring turn, though three would do.
    pub struct FourGears;
    link a; link b; link c; link d;
    joint pa = revolute(ground, a) at (0, 0);
    joint pb = revolute(ground, b) at (2, 0);
    joint pc = revolute(ground, c) at (2, 2);
    joint pd = revolute(ground, d) at (0, 2);
    joint ab = gear(a, b, 20 : 20);
    joint bc = gear(b, c, 20 : 20);
    joint cd = gear(c, d, 20 : 20);
    joint da = gear(d, a, 20 : 20);
    motor pa;
    allow redundant;
}

mechanism! {
    /// A planetary gear with three planets: redundant twice.
    pub struct ThreePlanets;
    ground { point shaft = (0, 0); }
    link sun { point shaft = (0, 0); }
    link arm { point shaft = (0, 0); point p = (6, 0); point q = (-3, 5.196152422706632); point r = (-3, -5.196152422706632); }
    link first { point pin = (0, 0); }
    link second { point pin = (0, 0); }
    link third { point pin = (0, 0); }
    joint s = revolute(ground.shaft, sun.shaft);
    joint a = revolute(ground.shaft, arm.shaft);
    joint p = revolute(arm.p, first.pin);
    joint q = revolute(arm.q, second.pin);
    joint r = revolute(arm.r, third.pin);
    joint sp = gear(sun, first, 5 : 1);
    joint sq = gear(sun, second, 5 : 1);
    joint sr = gear(sun, third, 5 : 1);
    joint rp = gear(first, ground, 1 : -7);
    joint rq = gear(second, ground, 1 : -7);
    joint rr = gear(third, ground, 1 : -7);
    motor s;
    allow redundant;
}

mechanism! {
    /// Stephenson III, driven at its second ground pivot: no dyad to start from.
    pub struct StephensonFar;
    link crank;
    link coupler { point tip = (2.2, 3.6); }
    link rocker;
    link rod;
    link driver;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.7, 1.2);
    joint c = revolute(coupler, rocker) at (3.6, 2.4);
    joint d = revolute(ground, rocker) at (4, 0);
    joint e = revolute(coupler, rod) at (2.2, 3.6);
    joint f = revolute(rod, driver) at (5.6, 4.6);
    joint g = revolute(ground, driver) at (6.4, 1.6);
    motor g;
    allow coupled;
}

mechanism! {
    /// A double butterfly: eight links, and no dyad anywhere.
    pub struct DoubleButterfly;
    link input;
    link left { point p = (1, 2); }
    link right { point p = (6, 2); }
    link lower;
    link upper;
    link west;
    link east;
    joint a = revolute(ground, input) at (0, 0);
    joint b = revolute(input, left) at (0.5, 1.2);
    joint c = revolute(left, lower) at (2, 1.6);
    joint d = revolute(left, upper) at (1.4, 3.0);
    joint e = revolute(ground, west) at (3, 0);
    joint f = revolute(west, lower) at (3.2, 1.9);
    joint g = revolute(lower, right) at (5.0, 1.5);
    joint h = revolute(upper, right) at (5.4, 3.3);
    joint i = revolute(right, east) at (6.6, 1.7);
    joint j = revolute(ground, east) at (7, 0);
    motor a;
    allow coupled;
}

mechanism! {
    /// A block on two parallel guides, as they are built: one would do.
    pub struct TwoGuides;
    link crank;
    link rod;
    link block;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0.5);
    joint c = revolute(rod, block) at (4, 0);
    joint low = prismatic(ground, block) at (4, -1) along (1, 0);
    joint high = prismatic(ground, block) at (4, 1) along (1, 0);
    motor a;
    allow redundant;
}
