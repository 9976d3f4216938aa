//! A mechanism with an error is the only error: code that uses it is not red, as all methods that it would have are known.

use mech_runtime::{Blocked, Frame, Mechanism, View, mechanism};

// It cannot be read.
mechanism! {
    /// A linkage.
    #[must_use]
    pub struct FourBar;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor e;
    start { a = 60 deg; coupler near 30 deg; }
}

// It can be read but does not move.
mechanism! {
    struct Motorless;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);
}

// It has forces.
mechanism! {
    struct Massless;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); mass 1 at (1, 0); }
    link tip { point pin = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, tip.pin);
    motor a;
    motor b;
    effects { force; dynamics; }
}

// Laws and params.
mechanism! {
    struct Crank;
    ground { point o = (0, 0); }
    link crank { point shaft = (0, 0); }
    joint a = revolute(ground.o, crank.shaft);
    motor a = 0.5 + t;
    start { a = 90 deg; }
}

mechanism! {
    struct Bar;
    param length = 2;
    link bar { point end = (length, 0); circle (0, 0) radius 1 on plane length; }
    joint a = revolute(ground, bar) at (0, 0);
    motor a;
}

// Motors that follow a point.
mechanism! {
    struct Arm;
    link upper;
    link forearm { point hand = (3, 1); }
    link finger;
    joint shoulder = revolute(ground, upper) at (0, 0);
    joint elbow = revolute(upper, forearm) at (2, 0);
    joint knuckle = revolute(forearm, finger) at (3, 1);
    motor shoulder;
    motor elbow;
    motor knuckle;
    follow forearm.hand by shoulder, knuckle;
}

// It moves only as long as its lengths match.
mechanism! {
    struct ParamThatMatches;
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
    allow redundant;
    effects { sensitivity; }
}

// Ports that are not lent, or twice; paths that lead nowhere; what does not belong into a part.
mechanism! {
    struct Arms;

    part Arm(reach = 1) {
        port frame { point pivot = (0, 0); }
        link bar { point pivot = (0, 0); point tip = (raech, 0); }
        joint pivot = revolute(frame.pivot, bar.pivot);
        motor pivot;
        gravity (0, -9.81);
    }

    use left[2]: Arm(reach = k + 1) { frame = ground };
    use right: Arm { };
    use both: Arm { frame = ground, frame = left[0].bar };
    use none: Leg { frame = ground };

    motor left[2].pivot;
    motor left.pivot;
    motor right[0].pivot;
    motor left[1].elbow;
}

// Conditions that do not hold.
mechanism! {
    struct Wiper;
    ground { point shaft = (0, 0); point pivot = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1.2, 0); }
    link rod { point pin = (0, 0); point end = (4.2, 0); }
    link arm { point pivot = (0, 0); point end = (2, 0); point blade = (6, 0); }
    joint a = revolute(ground.shaft, crank.shaft);
    joint b = revolute(crank.pin, rod.pin);
    joint c = revolute(rod.end, arm.end);
    joint d = revolute(ground.pivot, arm.pivot);
    motor a;
    start { a = 60 deg; arm near 90 deg; }

    expect turns(a);
    expect transmission > 55 deg, "the bearing is worn";
    expect arm.blade.y > 5;
}

fn trace<M: Mechanism<Motors = [f64; 1]>>(mechanism: &mut M) -> Result<usize, Blocked> {
    mechanism.move_to([0.5])?;
    Ok(mechanism.poses().len() + M::LINKS.len() + M::SHAPES.len())
}

fn main() -> Result<(), Blocked> {
    let mut four_bar = FourBar::new();
    let [angle] = four_bar.motors();
    four_bar.move_to([angle + 0.1])?;
    let coupler = four_bar.coupler();
    let tip = four_bar.coupler_right();
    let turned: f64 = four_bar.b() + four_bar.crank().rotation.angle();
    println!("{coupler} {tip} {turned} {:?} {}", four_bar.poses(), FourBar::REPORT);
    let mut frame = Frame::<64, 48>::new();
    frame.look_at(View::new([0.0, 0.0], 8.0));
    four_bar.draw(&mut frame);
    let copy = four_bar;
    assert_eq!(copy, FourBar::default());
    trace(&mut four_bar)?;

    let mut motorless = Motorless::new();
    motorless.move_to([0.5]).unwrap();
    println!("{} {} {}", motorless.coupler(), motorless.rocker_pin(), motorless.c());

    let mut massless = Massless::new();
    let _ = massless.hold_at([0.0, 1.0]);
    let _ = massless.forces([0.0, 1.0], [0.0, 0.0]);
    let _ = massless.simulate(0.1, [0.0, 0.0]);
    let _: Result<[f64; 2], _> = massless.energy();
    let _: Result<[f64; 2], _> = massless.come_to_rest([true, false]);

    let _ = Crank::new().at_time(1.0);
    let mut bar = Bar::new();
    let _ = bar.set_length(4.0);
    let _ = bar.set_params([bar.length()]);
    let _ = bar.params();

    let mut arm = Arm::new();
    let _ = arm.reach([1.0, 2.0]);

    let rails = ParamThatMatches::new();
    let _ = rails.sensitivities();
    let _ = rails.b_sensitivity();
    let _ = rails.rail_sensitivity();

    let arms = Arms::new();
    println!("{}", arms.left(1).bar_tip());

    let _ = Wiper::new().arm_blade();
    Ok(())
}
