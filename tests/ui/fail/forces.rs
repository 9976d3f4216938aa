//! Masses and what acts on them: what cannot be meant is told where it stands.

use mech_runtime::mechanism;

mechanism! {
    struct Masses;
    ground { point o = (0, 0); mass 3; }
    link crank { point shaft = (0, 0); point pin = (1, 0); mass -2 at (0.5, 0); }
    link coupler { point left = (0, 0); point right = (3, 0); mass 1 inertia -0.1; mass 2; }
    link rocker { point pin = (2, 0); point shaft = (0, 0); density 7.8; }
    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    motor a;
    motor b;
    gravity (0, -9.81);
    gravity (0, 9.81);
}

mechanism! {
    struct Springs;
    ground { point o = (0, 0); line way = (0, 0) -> (1, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); mass 1; }
    link slide { line way = (0, 0) -> (1, 0); mass 1; }
    joint a = revolute(ground.o, crank.shaft);
    joint h = prismatic(ground.way, slide.way);
    motor a;
    motor h;
    spring one = linear(crank.pin, crank.shaft) stiffness 3;
    spring two = linear(crank.pin, ground.way) stiffness 3;
    spring three = linear(crank.pinn, ground.o) stiffness 3;
    spring four = linear(crank.shaft, ground.o) stiffness 3;
    spring five = linear(crank.pin, ground.o) stiffness -3 rest 1;
    spring six = torsional(h) stiffness 3;
    spring seven = angular(a) stiffness 3;
    spring eight = linear(crank.pin, ground.o);
    damper nine = torsional(b) damping 1;
    damper a = torsional(a) damping 1;
    load push = force(ground.o);
    load pull = force(crank);
    load twist = torque(cranc);
    effects { force; }
}

mechanism! {
    struct Nothing;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    motor a;
    effects { force; }
}

mechanism! {
    struct Weightless;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    motor a;
    gravity (0, -9.81);
}

mechanism! {
    struct Massless;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); mass 1 at (1, 0); }
    link tip { point pin = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, tip.pin);
    motor a;
    motor b;
    effects { dynamics; }
}

mechanism! {
    struct Unasked;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    joint a = revolute(ground.o, crank.shaft);
    motor a;
    load push = force(crank.pin);
}

mechanism! {
    struct Hidden;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); mass 1; }
    joint a = revolute(ground.o, crank.shaft);
    motor a;
    show crank;
    effects { dynamics; }
}

fn main() {
    // What these would have is known all the same.
    let mut springs = Springs::new();
    let _ = springs.hold_at([0.0, 1.0]);
    let _ = springs.forces([0.0, 1.0], [0.0, 0.0]);
    let mut massless = Massless::new();
    let _ = massless.simulate(0.1, [0.0, 0.0]);
    let _: Result<[f64; 2], _> = massless.energy();
}
