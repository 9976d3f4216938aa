#![no_std]
#![deny(warnings, clippy::pedantic)]
//! Lengths that change while a mechanism runs.

mech_runtime::mechanism! {
    /// A crank with an adjustable throw.
    pub struct SliderCrank: f32;
    param throw = 1;
    param rod = 4;
    const MIDDLE = rod / 2;
    ground { point shaft = (0, 0); line bore = (0, 0) -> (1, 0); }
    link crank { point shaft = (0, 0); point pin = (throw, 0); }
    link conrod { point big_end = (0, 0); point middle = (MIDDLE, 0.25); point small_end = (rod, 0); }
    link piston { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }
    joint a = revolute(ground.shaft, crank.shaft);
    joint b = revolute(crank.pin, conrod.big_end);
    joint c = revolute(conrod.small_end, piston.pin);
    joint x = prismatic(ground.bore, piston.axis);
    motor a;
    start { conrod near 0 deg; }
    effects { acceleration; sensitivity; }
}

mod hidden {
    mech_runtime::mechanism! {
        /// Nothing of it is used.
        pub(super) struct Unused;
        param told = 1;
        param inputs = 2;
        param last = 3;
        ground { point o = (0, 0); }
        link motors_of { point o = (0, 0); point p = (told + inputs * last, sqrt(told) / inputs); }
        joint a = revolute(ground.o, motors_of.o);
        motor a;
    }
}

mod beside {
    mech_runtime::mechanism! {
        /// Forces and a diagram.
        pub(super) struct Loaded: f32;
        param simulated = 2;
        param names = 1;
        ground { point o = (0, 0); point hook = (0, names); }
        link arm { point o = (0, 0); point tip = (simulated, mod(names, 2)); mass 1 at (1, 0); }
        joint a = revolute(ground.o, arm.o);
        motor a;
        gravity (0, -9.81);
        spring pull = linear(ground.hook, arm.tip) stiffness 2 rest 0.1;
        load push = force(arm.tip);
        effects { force; dynamics; velocity; overlay; }
    }

    mech_runtime::mechanism! {
        /// A law.
        pub(super) struct Timed: f32;
        param laws = 2;
        param t = 1;
        ground { point o = (0, 0); line way = (0, 0) -> 30 deg; }
        link arm { point o = (0, 0); }
        link block { line way = (0, 0) -> 30 deg; }
        joint a = revolute(ground.o, arm.o);
        joint b = prismatic(ground.way, block.way);
        motor a = 0.5;
        motor b = asin(sin(laws)) - atan2(laws, 1);
    }
}

fn main() {
    let mut loaded = beside::Loaded::new();
    assert!(loaded.set_simulated(3.0).is_ok());
    assert!(loaded.simulate(0.01, [1.0]).is_ok() && loaded.hold_at([0.5]).is_ok());
    assert!(loaded.come_to_rest([true]).is_ok());
    assert!(loaded.pull() > 0.0 && loaded.push_advantage([1.0, 0.0]).is_ok());
    let mut timed = beside::Timed::new();
    assert!(timed.set_laws(0.5).is_ok() && timed.at_time(1.0).is_ok());
    assert!((timed.b() - 0.5 + f32::atan2(0.5, 1.0)).abs() < 1e-6);
    let mut crank = SliderCrank::new();
    assert_eq!(crank.params(), [1.0, 4.0]);
    assert!(crank.set_rod(5.0).is_ok() && crank.set_params([1.5, 6.0]).is_ok());
    assert!(crank.set_throw(7.0).is_ok() || crank.throw() < 2.0);
    assert!(crank.move_with([0.5], [1.0], [0.0]).is_ok());
    let _: Result<[mech_runtime::Vector2<f32>; 2], mech_runtime::Blocked<[f32; 1]>> =
        crank.conrod_middle_sensitivity();
    let _ = (crank.x_sensitivity(), crank.piston_sensitivity(), crank.sensitivities());
    let mut unused = hidden::Unused::new();
    assert!(unused.set_told(4.0).is_ok());
    assert!((unused.motors_of_p().y - 1.0).abs() < 1e-12);
}
