//! The smallest mechanism for each diagnosis, and what mends it.

/// A mechanism that is wrong, and the edit that makes it right.
pub(crate) struct Entry {
    /// The variant of `Diagnosis`.
    pub(crate) variant: &'static str,
    /// The text.
    pub(crate) example: &'static str,
    /// What to do about it.
    pub(crate) remedy: &'static str,
    /// What to write instead of what.
    pub(crate) edit: (&'static str, &'static str),
}

/// In the order of the enum.
pub(crate) const ENTRIES: &[Entry] = &[
    Entry {
        variant: "Loose",
        example: "
struct Arm;
link arm;
link spare;
joint a = revolute(ground, arm) at (0, 0);
motor a;",
        remedy: "Join it to something, or remove it.",
        edit: ("link spare;", ""),
    },
    Entry {
        variant: "Disconnected",
        example: "
struct Arm;
link arm;
link bow;
link arrow;
joint a = revolute(ground, arm) at (0, 0);
joint b = revolute(bow, arrow) at (3, 0);
motor a;
motor b;",
        remedy: "Join one of the links to the ground, or to something that is connected to it.",
        edit: ("motor a;", "joint c = weld(arm, bow) at (2, 0);\nmotor a;"),
    },
    Entry {
        variant: "NoCarrier",
        example: "
struct Gears;
link pinion;
link arm;
link wheel;
joint a = revolute(ground, pinion) at (0, 0);
joint b = revolute(ground, arm) at (3, 0);
joint c = revolute(arm, wheel) at (4, 0);
joint mesh = gear(pinion, wheel, 20 : 40);
motor a;
motor b;",
        remedy: "Let both parts turn on one link, or slide on it what slides; a wheel on the shaft of that link will do.",
        edit: ("at (3, 0);", "at (0, 0);"),
    },
    Entry {
        variant: "NotCarrier",
        example: "
struct Gears;
link pinion;
link wheel;
link arm;
joint a = revolute(ground, pinion) at (0, 0);
joint b = revolute(ground, wheel) at (3, 0);
joint c = revolute(ground, arm) at (6, 0);
joint mesh = gear(pinion, wheel, 20 : 40 on arm);
motor a;
motor c;",
        remedy: "Name the link on which both parts turn, or leave the clause out: where there is one, it is found.",
        edit: (" on arm);", ");"),
    },
    Entry {
        variant: "SeveralCarriers",
        example: "
struct Gears;
ground { point shaft = (0, 0); }
link sun { point shaft = (0, 0); }
link arm { point shaft = (0, 0); }
link ring { point shaft = (0, 0); }
joint a = revolute(ground.shaft, sun.shaft);
joint b = revolute(ground.shaft, arm.shaft);
joint c = revolute(arm.shaft, ring.shaft);
joint mesh = gear(sun, ring, 20 : -60);
motor a;
motor b;",
        remedy: "Say which link carries it.",
        edit: ("20 : -60", "20 : -60 on arm"),
    },
    Entry {
        variant: "NoMesh",
        example: "
struct Gears;
link pinion;
link wheel;
joint a = revolute(ground, pinion) at (0, 0);
joint b = revolute(ground, wheel) at (3, 0);
joint mesh = gear(pinion, wheel, 1.0 : 5.0);
motor a;",
        remedy: "Pitch radii add up to the distance of the axes; of a ring and the wheel in it they differ by that. Teeth fit at any \
                 distance except zero.",
        edit: ("1.0 : 5.0", "0.5 : 2.5"),
    },
    Entry {
        variant: "Blocked",
        example: "
struct Truss;
link left;
link right;
joint a = revolute(ground, left) at (0, 0);
joint b = revolute(ground, right) at (2, 0);
joint c = revolute(left, right) at (1, 1);
motor a;",
        remedy: "Give the part a freedom: remove a joint or a link of it, or let a pin slide in a slot. The message lists \
                 what was tried and found to do.",
        edit: (
            "revolute(left, right) at (1, 1)",
            "slot(left, right) at (1, 1) along (1, -1)",
        ),
    },
    Entry {
        variant: "TooManyMotors",
        example: "
struct SliderCrank;
link crank;
link rod;
link block;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (1, 0.5);
joint c = revolute(rod, block) at (4, 0);
joint x = prismatic(ground, block) at (4, 0) along (1, 0);
motor a;
motor x;",
        remedy: "Remove one of the motors that are named.",
        edit: ("motor x;", ""),
    },
    Entry {
        variant: "Overdetermined",
        example: "
struct Arm;
ground { point base = (0, 0); }
link arm { point shoulder = (0, 0); point left = (1, 0); point right = (2, 0); }
link plate { point left = (0, 0); point right = (1.1, 0); }
joint a = revolute(ground.base, arm.shoulder);
joint bolt = revolute(arm.left, plate.left);
joint screw = revolute(arm.right, plate.right);
motor a;",
        remedy: "Remove what holds the part a second time; two links that are held to each other are one, or have one weld.",
        edit: (
            "joint screw = revolute(arm.right, plate.right);\nmotor a;",
            "motor a;\nmotor bolt;",
        ),
    },
    Entry {
        variant: "Overdetermined",
        example: "
struct ThreeCranks;
link first;
link second;
link third;
link rail;
joint a = revolute(ground, first) at (0, 0);
joint b = revolute(ground, second) at (2, 0);
joint c = revolute(ground, third) at (4, 0);
joint d = revolute(first, rail) at (0.5, 1);
joint e = revolute(second, rail) at (2.5, 1);
joint f = revolute(third, rail) at (4.5, 1);
motor a;",
        remedy: "Where the lengths match on purpose, as here, say so; otherwise remove what is too many.",
        edit: ("motor a;", "motor a;\nallow redundant;"),
    },
    Entry {
        variant: "OverconstrainedWithParam",
        example: "
struct Rails;
param third_foot = 2;
link first;
link second;
link third;
link rail;
joint a = revolute(ground, first) at (0, 0);
joint b = revolute(ground, second) at (4, 0);
joint c = revolute(ground, third) at (third_foot, 0);
joint d = revolute(first, rail) at (0.5, 1);
joint e = revolute(second, rail) at (4.5, 1);
joint f = revolute(third, rail) at (2.5, 1);
motor a;
allow redundant;",
        remedy: "Let the lengths be constants, or take away what is too many.",
        edit: ("param third_foot = 2;", "const third_foot = 2;"),
    },
    Entry {
        variant: "NoMotor",
        example: "
struct Arm;
link arm;
joint a = revolute(ground, arm) at (0, 0);",
        remedy: "Add the motor that is offered.",
        edit: ("at (0, 0);", "at (0, 0);\nmotor a;"),
    },
    Entry {
        variant: "Undetermined",
        example: "
struct Arm;
link upper;
link fore;
joint shoulder = revolute(ground, upper) at (0, 0);
joint elbow = revolute(upper, fore) at (2, 0);
motor shoulder;",
        remedy: "Add one of the motors that are offered, or take the freedom away by a joint.",
        edit: ("motor shoulder;", "motor shoulder;\nmotor elbow;"),
    },
    Entry {
        variant: "Rigid",
        example: "
struct Truss;
link left;
link right;
joint a = revolute(ground, left) at (0, 0);
joint b = revolute(ground, right) at (2, 0);
joint c = revolute(left, right) at (1, 1);",
        remedy: "Remove a joint, or let a pin slide in a slot; then add a motor.",
        edit: (
            "revolute(left, right) at (1, 1);",
            "slot(left, right) at (1, 1) along (1, -1);\nmotor a;",
        ),
    },
    Entry {
        variant: "NotSequential",
        example: "
struct SixBar;
link crank;
link coupler;
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
motor g;",
        remedy: "Move the motor to where the loops can be solved one after the other, or let them be solved together.",
        edit: ("motor g;", "motor g;\nallow coupled;"),
    },
    Entry {
        variant: "CamNotDriven",
        example: "
struct Lever;
link disk;
link lever;
joint s = revolute(ground, disk) at (0, 0);
joint f = revolute(ground, lever) at (3, 0);
joint c = cam(s, f, 0.2 * sin(q));
motor f;",
        remedy: "Drive the shaft, or exchange shaft and follower.",
        edit: ("motor f;", "motor s;"),
    },
    Entry {
        variant: "CamWithoutValue",
        example: "
struct Lever;
link disk;
link lever;
joint s = revolute(ground, disk) at (0, 0);
joint f = revolute(ground, lever) at (3, 0);
joint c = cam(s, f, sqrt(q - 1));
motor s;",
        remedy: "Write a law that has a value there.",
        edit: ("sqrt(q - 1)", "sqrt(1 - q) - 1"),
    },
    Entry {
        variant: "CannotClose",
        example: "
struct FourBar;
ground { point o = (0, 0); point p = (4, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link coupler { point left = (0, 0); point right = (0.5, 0); }
link rocker { point shaft = (0, 0); point pin = (2, 0); }
joint a = revolute(ground.o, crank.shaft);
joint b = revolute(crank.pin, coupler.left);
joint c = revolute(coupler.right, rocker.pin);
joint d = revolute(ground.p, rocker.shaft);
motor a;
start { a = 60 deg; coupler near 30 deg; }",
        remedy: "Change a length by as much as the message says is missing, or start the motor elsewhere.",
        edit: ("point right = (0.5, 0);", "point right = (3, 0);"),
    },
    Entry {
        variant: "DeadStart",
        example: "
struct FourBar;
link crank;
link coupler;
link rocker;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, coupler) at (1, 0);
joint c = revolute(coupler, rocker) at (4, 0);
joint d = revolute(ground, rocker) at (4, -2);
motor d;",
        remedy: "Start it elsewhere, or drive what can pass the point.",
        edit: ("at (1, 0);", "at (0.8, 0.6);"),
    },
    Entry {
        variant: "SeveralAssemblies",
        example: "
struct FourBar;
ground { point o = (0, 0); point p = (4, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link coupler { point left = (0, 0); point right = (3, 0); }
link rocker { point shaft = (0, 0); point pin = (2, 0); }
joint a = revolute(ground.o, crank.shaft);
joint b = revolute(crank.pin, coupler.left);
joint c = revolute(coupler.right, rocker.pin);
joint d = revolute(ground.p, rocker.shaft);
motor a;
start { a = 60 deg; }",
        remedy: "Add the `near` of the assembly that is meant.",
        edit: ("a = 60 deg;", "a = 60 deg; coupler near 20 deg;"),
    },
    Entry {
        variant: "NotAsDrawn",
        example: "
struct FourBar;
link crank { point pin = (1, 0.5); }
link rocker { point pin = (4, 2); }
link rod { point left = (0, 0); point right = (3, 0); }
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank.pin, rod.left);
joint c = revolute(rocker.pin, rod.right);
joint d = revolute(ground, rocker) at (4, 0);
motor a;",
        remedy: "Give the link with lengths of its own those of the drawing, or draw it too.",
        edit: (
            "point right = (3, 0);",
            "point right = (sqrt(3 * 3 + 1.5 * 1.5), 0);",
        ),
    },
    Entry {
        variant: "StartNotFree",
        example: "
struct FourBar;
ground { point o = (0, 0); point p = (4, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link coupler { point left = (0, 0); point right = (3, 0); }
link rocker { point shaft = (0, 0); point pin = (2, 0); }
joint a = revolute(ground.o, crank.shaft);
joint b = revolute(crank.pin, coupler.left);
joint c = revolute(coupler.right, rocker.pin);
joint d = revolute(ground.p, rocker.shaft);
motor a;
start { a = 60 deg; d = 110 deg; }",
        remedy: "Leave the value out; if there are several assemblies, pick one by `near`.",
        edit: ("d = 110 deg;", "rocker near 110 deg;"),
    },
    Entry {
        variant: "Range",
        example: "
struct Rocking;
ground { point a = (0, 0); point d = (4, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link coupler { point a = (0, 0); point b = (2, 0); }
link rocker { point shaft = (0, 0); point b = (1.5, 0); }
joint a = revolute(ground.a, crank.shaft);
joint b = revolute(crank.pin, coupler.a);
joint c = revolute(coupler.b, rocker.b);
joint d = revolute(ground.d, rocker.shaft);
motor a in -50 deg ..= 90 deg;
start { coupler near 40 deg; }",
        remedy: "Let the range end before the dead point, or change a length so that the crank turns farther.",
        edit: ("90 deg", "53 deg"),
    },
    Entry {
        variant: "Range",
        example: "
struct Stopping;
ground { point a = (0, 0); point d = (4, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link coupler { point a = (0, 0); point b = (4, 0); }
link rocker { point shaft = (0, 0); point b = (1, 0); }
joint a = revolute(ground.a, crank.shaft);
joint b = revolute(crank.pin, coupler.a);
joint c = revolute(coupler.b, rocker.b);
joint d = revolute(ground.d, rocker.shaft);
motor a in 10 deg ..= 270 deg;
start { a = 90 deg; rocker near 90 deg; }
at change points stop;",
        remedy: "Narrow the range, or let the mechanism go on.",
        edit: ("at change points stop;", "at change points go on;"),
    },
    Entry {
        variant: "Range",
        example: "
struct Grazing;
ground { point a = (0, 0); point d = (4, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link coupler { point a = (0, 0); point b = (2.5, 0); }
link rocker { point shaft = (0, 0); point b = (2.49999999999995, 0); }
joint a = revolute(ground.a, crank.shaft);
joint b = revolute(crank.pin, coupler.a);
joint c = revolute(coupler.b, rocker.b);
joint d = revolute(ground.d, rocker.shaft);
motor a in 0 deg ..= 360 deg;
start { coupler near 50 deg; }",
        remedy: "Lengths that nearly, but not quite, let it fold are seldom meant: change one.",
        edit: ("2.49999999999995", "2.6"),
    },
    Entry {
        variant: "Range",
        example: "
struct Iterated;
ground { point a = (0, 0); point d = (4, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link coupler { point a = (0, 0); point b = (3.5, 0); }
link rocker { point shaft = (0, 0); point b = (3, 0); }
joint a = revolute(ground.a, crank.shaft);
joint b = revolute(crank.pin, coupler.a);
joint c = revolute(coupler.b, rocker.b);
joint d = revolute(ground.d, rocker.shaft);
motor a in 0 deg ..= 360 deg;
start { coupler near 50 deg; }
method newton;",
        remedy: "Solve it exactly, or leave the range out.",
        edit: ("method newton;", "method exact;"),
    },
    Entry {
        variant: "Range",
        example: "
struct Arm;
param length = 2;
ground { point shaft = (0, 0); }
link arm { point shaft = (0, 0); point tip = (length, 0); }
joint a = revolute(ground.shaft, arm.shaft);
motor a in 0 deg ..= 90 deg;",
        remedy: "Let the length be a constant, or have moves tested when they are made.",
        edit: ("motor a in 0 deg ..= 90 deg;", "motor a;"),
    },
    Entry {
        variant: "Range",
        example: "
struct Sliding;
ground { point a = (0, 0); line rail = (4, 0) -> (1, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link coupler { point a = (0, 0); point b = (3.5, 0); }
link rocker { point shaft = (0, 0); point b = (3, 0); }
link base { line foot = (0, 0) -> (1, 0); point d = (0, 0); }
joint a = revolute(ground.a, crank.shaft);
joint b = revolute(crank.pin, coupler.a);
joint c = revolute(coupler.b, rocker.b);
joint d = revolute(base.d, rocker.shaft);
joint x = prismatic(ground.rail, base.foot);
motor a in 0 deg ..= 360 deg;
motor x;
start { coupler near 50 deg; }",
        remedy: "Declare a range for the other motor too.",
        edit: ("motor x;", "motor x in -0.2 ..= 0.2;"),
    },
    Entry {
        variant: "Range",
        example: "
struct Lever;
link disk;
link lever;
joint s = revolute(ground, disk) at (0, 0);
joint f = revolute(ground, lever) at (3, 0);
joint c = cam(s, f, 0.2 * sin(q));
motor s in 0 deg ..= 90 deg;",
        remedy: "Leave the range out.",
        edit: (" in 0 deg ..= 90 deg", ""),
    },
    Entry {
        variant: "Massless",
        example: "
struct Arm;
ground { point o = (0, 0); }
link upper { point shoulder = (0, 0); point elbow = (1, 0); mass 2 at (0.5, 0); }
link fore { point elbow = (0, 0); }
joint a = revolute(ground.o, upper.shoulder);
joint b = revolute(upper.elbow, fore.elbow);
motor a;
motor b;
effects { dynamics; }",
        remedy: "Give a link that the motor moves a mass.",
        edit: (
            "link fore { point elbow = (0, 0); }",
            "link fore { point elbow = (0, 0); mass 1 at (0.5, 0); }",
        ),
    },
    Entry {
        variant: "Overflow",
        example: "
struct Arm: f32;
gravity (0, -1e10);
link arm { mass 1e30 at (1, 0); }
joint a = revolute(ground, arm) at (0, 0);
motor a;
effects { force; }",
        remedy: "Choose units in which the numbers are nearer to one, or compute in `f64`.",
        edit: (": f32", ": f64"),
    },
    Entry {
        variant: "TooLarge",
        example: "
struct Arm: f32;
ground { point base = (0, 0); }
link arm { point shoulder = (0, 0); point hand = (1e39, 0); }
joint a = revolute(ground.base, arm.shoulder);
motor a;",
        remedy: "Choose a unit in which the numbers are small, or compute in `f64`.",
        edit: (": f32", ": f64"),
    },
    Entry {
        variant: "TooSmall",
        example: "
struct FourBar;
const U = 1e-100;
ground { point a = (0, 0); point d = (4 * U, 0); }
link crank { point a = (0, 0); point b = (U, 0); }
link coupler { point b = (0, 0); point c = (3.5 * U, 0); }
link rocker { point d = (0, 0); point c = (3 * U, 0); }
joint ja = revolute(ground.a, crank.a);
joint jb = revolute(crank.b, coupler.b);
joint jc = revolute(coupler.c, rocker.c);
joint jd = revolute(ground.d, rocker.d);
motor ja;
start { coupler near 50 deg; }",
        remedy: "Choose a unit in which the numbers are larger.",
        edit: ("1e-100", "1e-3"),
    },
    Entry {
        variant: "EndlessAccuracy",
        example: "
struct Rack;
link pinion;
link bar;
joint turn = revolute(ground, pinion) at (0, 0);
joint slide = prismatic(ground, bar) at (0, -1) along (1, 0);
joint mesh = rack(pinion, bar, radius 1);
motor turn;
accuracy 1e-9;",
        remedy: "Say how far the motor turns.",
        edit: ("motor turn;", "motor turn in -3600 deg ..= 3600 deg;"),
    },
    Entry {
        variant: "TooAccurate",
        example: "
struct Arm: f32;
ground { point base = (0, 0); }
link arm { point shoulder = (0, 0); point hand = (1, 0); }
joint a = revolute(ground.base, arm.shoulder);
motor a;
accuracy 1e-9;",
        remedy: "Ask for no more than the message says there is, or compute in `f64`.",
        edit: (": f32", ""),
    },
];
