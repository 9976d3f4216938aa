//! Mechanisms with params.

use mech_runtime::mechanism;

mechanism! {
    pub struct FourBar;
    param crank = 1.0;
    param rod = 3.5;
    const HALF = rod / 2;
    ground { point a = (0, 0); point d = (4, 0); }
    link driver { point a = (0, 0); point b = (crank, 0); }
    link coupler { point b = (0, 0); point c = (rod, 0); point tip = (HALF, 1); }
    link rocker { point d = (0, 0); point c = (3, 0); }
    joint ja = revolute(ground.a, driver.a);
    joint jb = revolute(driver.b, coupler.b);
    joint jc = revolute(coupler.c, rocker.c);
    joint jd = revolute(ground.d, rocker.d);
    motor ja;
    start { ja = 40 deg; coupler near 40 deg; }
    effects { velocity; acceleration; sensitivity; }
}

mechanism! {
    /// As in a drawing: the params move joints.
    pub struct SliderCrank: f32;
    param length = 4;
    param offset = 0.25;
    link crank;
    link rod { point middle = (length / 2, 0.5); }
    link block;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0.5);
    joint c = revolute(rod, block) at (length, offset);
    joint x = prismatic(ground, block) at (length, offset) along (1, 0);
    motor a;
    effects { sensitivity; }
}

mechanism! {
    /// A pin in a slot.
    pub struct QuickReturn;
    param throw = 0.8;
    param depth = 2;
    ground { point shaft = (0, 0); point pivot = (0, -depth); }
    link crank { point shaft = (0, 0); point pin = (throw, 0); }
    link lever { point pivot = (0, 0); line slot = (0, 0) -> (0, 1); point tip = (0, 2 * depth); }
    joint a = revolute(ground.shaft, crank.shaft);
    joint b = revolute(ground.pivot, lever.pivot);
    joint s = slot(crank.pin, lever.slot);
    motor a;
    start { a = 60 deg; lever near 0 deg; }
    effects { sensitivity; }
}

mechanism! {
    /// An open chain: everything about it is known.
    pub struct Arm;
    param upper = 2.0;
    param fore = 1.5;
    ground { point shoulder = (0, 0); }
    link humerus { point shoulder = (0, 0); point elbow = (upper, 0); }
    link ulna { point elbow = (0, 0); point hand = (fore, 0); }
    joint a = revolute(ground.shoulder, humerus.shoulder);
    joint b = revolute(humerus.elbow, ulna.elbow);
    motor a;
    motor b;
    effects { sensitivity; }
}

mechanism! {
    /// Loops that wait for each other.
    pub struct Coupled;
    param bar = 4.0;
    ground { point a = (0, 0); point e = (5, 0.5); point f = (7, 3); }
    link driver { point a = (0, 0); point b = (1, 0); }
    link first { point b = (0, 0); point c = (bar, 0); }
    link second { point e = (0, 0); point d = (0, 3); }
    link third { point f = (0, 0); point g = (-1, 3); }
    link plate { point c = (0, 0); point d = (1, 0); point g = (2, 2); }
    joint ja = revolute(ground.a, driver.a);
    joint jb = revolute(driver.b, first.b);
    joint jc = revolute(first.c, plate.c);
    joint jd = revolute(second.d, plate.d);
    joint je = revolute(ground.e, second.e);
    joint jf = revolute(ground.f, third.f);
    joint jg = revolute(third.g, plate.g);
    motor ja;
    allow coupled;
    start { ja = 90 deg; plate near 20 deg; second near 0 deg; third near 0 deg; first near 30 deg; }
    effects { sensitivity; }
}

mechanism! {
    /// Of what is shown only the tip, and numbers that do not exist everywhere.
    pub struct Lifted;
    param x = 0.6;
    param angle = 30 deg;
    ground { point o = (0, 0); point p = (cos(angle), -sqrt(1 - x * x)); }
    link crank { point o = (0, 0); point pin = (0.5, 0); }
    link rod { point pin = (0, 0); point end = (2, 0); point tip = (1, x); }
    link rocker { point p = (0, 0); point end = (0, 2 + tan(angle)); }
    joint a = revolute(ground.o, crank.o);
    joint b = revolute(crank.pin, rod.pin);
    joint c = revolute(rod.end, rocker.end);
    joint d = revolute(ground.p, rocker.p);
    motor a;
    start { a = 90 deg; rod near 45 deg; }
    effects { velocity; sensitivity; }
    show rod.tip, d;
}

mechanism! {
    /// Gears that follow a loop: teeth stay in mesh whatever changes.
    pub struct Geared;
    param rod = 3.5;
    ground { point a = (0, 0); point d = (4, 0); point w = (4, -3); }
    link driver { point a = (0, 0); point b = (1, 0); }
    link coupler { point b = (0, 0); point c = (rod, 0); }
    link rocker { point d = (0, 0); point c = (3, 0); }
    link wheel { point w = (0, 0); point mark = (1, 0); }
    joint ja = revolute(ground.a, driver.a);
    joint jb = revolute(driver.b, coupler.b);
    joint jc = revolute(coupler.c, rocker.c);
    joint jd = revolute(ground.d, rocker.d);
    joint jw = revolute(ground.w, wheel.w);
    joint mesh = gear(rocker, wheel, 20 : 10);
    motor ja;
    start { ja = 40 deg; coupler near 40 deg; }
    effects { sensitivity; }
}

mechanism! {
    /// A rail that a param tilts.
    pub struct Tilted;
    param tilt = 20 deg;
    link crank;
    link rod { point middle = (2, 0.5); }
    link block;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (0, 1);
    joint c = revolute(rod, block) at (4, 0);
    joint x = prismatic(ground, block) at (4, 0) along tilt;
    motor a;
    effects { velocity; acceleration; sensitivity; }
}

mechanism! {
    /// The same, tilted otherwise: what is set in one is declared in the other.
    pub struct Tilted30;
    link crank { point o = (0, 0); point b = (0, 1); }
    link rod { point b = (0, 1); point c = (4, 0); point middle = (2, 0.5); }
    link block { point c = (4, 0); line x = (4, 0) -> 30 deg; }
    ground { point o = (0, 0); line x = (4, 0) -> 30 deg; }
    joint a = revolute(ground.o, crank.o);
    joint b = revolute(crank.b, rod.b);
    joint c = revolute(rod.c, block.c);
    joint x = prismatic(ground.x, block.x);
    motor a;
    start { rod near 0 deg; }
    effects { velocity; acceleration; }
}

mechanism! {
    /// A slot that a param turns in its lever.
    pub struct Leaning;
    param lean = 0.25;
    ground { point shaft = (0, 0); point pivot = (0, -2); }
    link crank { point shaft = (0, 0); point pin = (0.8, 0); }
    link lever { point pivot = (0, 0); line slot = (0.1, 0) -> (lean, 1); point tip = (0, 4); }
    joint a = revolute(ground.shaft, crank.shaft);
    joint b = revolute(ground.pivot, lever.pivot);
    joint s = slot(crank.pin, lever.slot);
    motor a;
    start { a = 60 deg; lever near 0 deg; }
    effects { sensitivity; overlay; }
}

mechanism! {
    /// A wheel that rolls on what a param turns: teeth stay in mesh.
    pub struct Rolling;
    param tilt = 30 deg;
    ground { line rail = (0, 0) -> tilt; }
    link block { line guide = (0, 0) -> 30 deg; }
    link arm;
    link wheel { point mark = (2.5, 0.5); }
    link carriage;
    joint s = prismatic(ground.rail, block.guide);
    joint p = revolute(block, arm) at (0, 0);
    joint w = revolute(arm, wheel) at (2, 0);
    joint u = prismatic(arm, carriage) at (0, 2) along (1, 0);
    joint v = prismatic(ground, carriage) at (0, 2) along (0, 1);
    joint mesh = gear(block, wheel, 20 : 10 on arm);
    motor s;
    effects { sensitivity; }
}

mechanism! {
    /// Points that no joint holds.
    pub struct Loose: f64;
    param x = 0.6;
    param scale = 1;
    ground { point o = (0, 0); }
    link crank { point o = (0, 0); point lone = (sqrt(1 - x * x), 0); point far = (scale, 3 * scale / 2); }
    joint a = revolute(ground.o, crank.o);
    motor a;
}
