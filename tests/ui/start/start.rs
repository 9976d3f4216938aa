//! Mechanisms that cannot be put together where they start.

use mech_runtime::mechanism;

// The lengths do not reach.
mechanism! {
    struct CannotClose;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (0.5, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
}

// The rod does not reach the bore.
mechanism! {
    struct CannotCloseSlider;

    ground { point o = (0.0, 5.0); line bore = (0.0, 0.0) -> (1.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link rod { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
    link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, rod.big_end);
    joint c = revolute(rod.small_end, piston.pin);
    joint d = prismatic(ground.bore, piston.axis);

    motor a;
}

// A slider-crank driven at its piston, and started where crank and rod are in line.
mechanism! {
    struct DeadStart;

    ground { point o = (0.0, 0.0); line bore = (0.0, 0.0) -> (1.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link rod { point big_end = (0.0, 0.0); point small_end = (3.0, 0.0); }
    link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, rod.big_end);
    joint c = revolute(rod.small_end, piston.pin);
    joint d = prismatic(ground.bore, piston.axis);

    motor d;
    start { d = 4.0; }
}

// A four-bar driven at its rocker, and drawn where crank and coupler are in line.
mechanism! {
    struct DeadStartAsDrawn;

    link crank;
    link coupler;
    link rocker;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, coupler) at (1.0, 0.0);
    joint c = revolute(coupler, rocker) at (4.0, 0.0);
    joint d = revolute(ground, rocker) at (4.0, -2.0);

    motor d;
}

// A link has a line of its own, but another joint of it is placed by `at`.
mechanism! {
    struct LineOfADrawnLink;

    ground { line bore = (0, 0.5) -> (1, 0); }
    link crank;
    link rod;
    link block { line way = (0, 0) -> (1, 0); }

    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0.5);
    joint c = revolute(rod, block) at (4, 0.5);
    joint x = prismatic(ground.bore, block.way);

    motor a;
}

// A rod of a given length does not fit between two links of the drawing.
mechanism! {
    struct NotAsDrawn;

    link crank { point pin = (1.0, 0.0); }
    link rocker { point pin = (4.0, 2.0); }
    link rod { point left = (0.0, 0.0); point right = (3.0, 0.0); }

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint d = revolute(ground, rocker) at (4.0, 0.0);
    joint b = revolute(crank.pin, rod.left);
    joint c = revolute(rocker.pin, rod.right);

    motor a;
}

// The lengths leave a choice that no `near` makes.
mechanism! {
    struct SeveralAssemblies;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor a;
    start { a = 60 deg; }
}

fn main() {}
