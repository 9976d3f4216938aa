//! What moves only because its lengths match compiles when that is allowed.

use mech_runtime::{Mechanism, mechanism};

mechanism! {
    struct ThreeCranks;
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
    struct FourGears;
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
    struct ThreePlanets;
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

fn main() {
    let mut cranks = ThreeCranks::new();
    cranks.move_to([0.5]).expect("it turns");
    // The tip goes round on a circle of the cranks' length, sqrt(1.25).
    let tip = cranks.rail_tip();
    let (sin, cos) = (0.5_f64.sin(), 0.5_f64.cos());
    assert!((tip.x - (4.5 + 0.5 * cos - sin)).abs() < 1e-12);
    assert!((tip.y - (1.0 + 0.5 * sin + cos)).abs() < 1e-12);

    let mut gears = FourGears::new();
    gears.move_to([1.0]).expect("they turn");
    assert!((gears.pd() + 1.0).abs() < 1e-12);
    assert!((gears.pc() - 1.0).abs() < 1e-12);

    let mut planets = ThreePlanets::new();
    planets.move_to([1.2]).expect("they turn");
    // Sun of 5, ring of 7: the arm turns 5 / 12 as fast as the sun.
    assert!((planets.a() - 1.2 * 5.0 / 12.0).abs() < 1e-12);
}
