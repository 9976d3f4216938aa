//! Mechanisms that cannot move.

use mech_runtime::mechanism;

// A brace holds a four-bar rigid.
mechanism! {
    struct BlockedByABrace;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }
    link brace { point foot = (0.0, 0.0); point head = (2.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);
    joint e = revolute(crank.pin, brace.foot);
    joint f = revolute(rocker.shaft, brace.head);

    motor a;
    start { a = 60 deg; coupler near 30 deg; }
}

// Two links of a robot's hand are braced.
mechanism! {
    struct BlockedInAnArm;

    ground { point base = (0.0, 0.0); }
    link arm { point shoulder = (0.0, 0.0); point hip = (1.0, 0.0); point knee = (2.0, 0.0); }
    link thigh { point foot = (0.0, 0.0); point head = (1.0, 0.0); }
    link shin { point foot = (0.0, 0.0); point head = (1.0, 0.0); }

    joint shoulder = revolute(ground.base, arm.shoulder);
    joint hip = revolute(arm.hip, thigh.foot);
    joint knee = revolute(arm.knee, shin.foot);
    joint head = revolute(thigh.head, shin.head);

    motor shoulder;
    motor hip;
}

// A second pin in the same slot holds the arm still.
mechanism! {
    struct BlockedSlot;

    ground { point o = (0.0, 0.0); point p = (0.0, -2.0); point stop = (1.5, -0.5); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link arm { point shaft = (0.0, 0.0); line way = (0.0, 0.0) -> (1.0, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint s = slot(crank.pin, arm.way);
    joint t = slot(ground.stop, arm.way);
    joint d = revolute(ground.p, arm.shaft);

    motor a;
}

// The joints hold all links, and there is no motor to be blocked.
mechanism! {
    struct NothingCanMove;

    ground { point o = (0.0, 0.0); point p = (2.0, 0.0); }
    link left { point foot = (0.0, 0.0); point head = (1.5, 0.0); }
    link right { point foot = (0.0, 0.0); point head = (1.5, 0.0); }

    joint a = revolute(ground.o, left.foot);
    joint b = revolute(ground.p, right.foot);
    joint c = revolute(left.head, right.head);
}

// The place of a joint was copied from the line above.
mechanism! {
    struct JointsAtOnePlace;

    link crank;
    link rod;
    link slider;

    joint a = revolute(ground, crank) at (0.0, 0.0);
    joint b = revolute(crank, rod) at (0.8, 0.6);
    joint c = revolute(rod, slider) at (0.8, 0.6);
    joint d = prismatic(ground, slider) at (4.0, 0.0) along (1.0, 0.0);

    motor a;
}

// A plate is bolted on twice.
mechanism! {
    struct Overdetermined;

    ground { point base = (0.0, 0.0); }
    link arm { point shoulder = (0.0, 0.0); point hole = (1.0, 0.0); point slot = (2.0, 0.0); }
    link plate { point hole = (0.0, 0.0); point slot = (1.0, 0.0); }

    joint shoulder = revolute(ground.base, arm.shoulder);
    joint bolt = revolute(arm.hole, plate.hole);
    joint screw = revolute(arm.slot, plate.slot);

    motor shoulder;
}

// Three external gears in a ring lock each other.
mechanism! {
    struct ThreeGearsInATriangle;

    ground { point a = (0.0, 0.0); point b = (2.0, 0.0); point c = (1.0, 1.7); }
    link first { point shaft = (0.0, 0.0); }
    link second { point shaft = (0.0, 0.0); }
    link third { point shaft = (0.0, 0.0); }

    joint x = revolute(ground.a, first.shaft);
    joint y = revolute(ground.b, second.shaft);
    joint z = revolute(ground.c, third.shaft);
    joint mesh = gear(first, second, 20 : 20);
    joint bite = gear(second, third, 20 : 20);
    joint lock = gear(third, first, 20 : 20);

    motor x;
}

fn main() {}
