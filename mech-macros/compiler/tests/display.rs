//! What a plan and a program look like when they are printed. Renew with
//! `INSTA_UPDATE=always cargo test -p mech-compiler --test display`, and read it.

use mech_compiler::compile;
use mech_compiler::syntax::parse;

/// A crank, a coupler and a rocker on the ground.
const FOUR_BAR: &str = "struct FourBar;
    link crank; link coupler; link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a;";

/// Small mechanisms: together they have every kind of step and block.
const MECHANISMS: &[(&str, &str)] = &[
    (
        "crank",
        "struct Crank;
        link crank; joint a = revolute(ground, crank) at (0, 0);
        motor a;",
    ),
    (
        "slider_crank",
        "struct SliderCrank;
        link crank; link rod; link piston;
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, rod) at (0.6, 0.8);
        joint c = revolute(rod, piston) at (4, 0);
        joint s = prismatic(ground, piston) at (4, 0) along (1, 0);
        motor a;",
    ),
    (
        "gears",
        "struct Gears;
        link pinion; link wheel;
        joint a = revolute(ground, pinion) at (0, 0);
        joint b = revolute(ground, wheel) at (3, 0);
        joint mesh = gear(pinion, wheel, 20 : 40);
        motor a;",
    ),
    (
        "cam",
        "struct Tappet;
        link disk; link tappet;
        joint s = revolute(ground, disk) at (0, 0);
        joint f = prismatic(ground, tappet) at (0, 1) along (0, 1);
        joint c = cam(s, f, 0.1 * sin(q));
        motor s;",
    ),
    (
        "slot",
        "struct Shaper;
        link crank; link arm;
        joint a = revolute(ground, crank) at (0, 2);
        joint k = slot(crank, arm) at (1, 2) along (1, 2);
        joint d = revolute(ground, arm) at (0, 0);
        motor a;",
    ),
    (
        "coupled_loops",
        "struct SixBar;
        link crank; link coupler; link rocker; link rod; link driver;
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, coupler) at (0.7, 1.2);
        joint c = revolute(coupler, rocker) at (3.6, 2.4);
        joint d = revolute(ground, rocker) at (4, 0);
        joint e = revolute(coupler, rod) at (2.2, 3.6);
        joint f = revolute(rod, driver) at (6.44, 1.68);
        joint g = revolute(ground, driver) at (6.4, 1.6);
        motor g; allow coupled;",
    ),
    (
        "tied_loop",
        "struct GearedFiveBar;
        link left; link lower; link upper; link right;
        joint a = revolute(ground, left) at (0, 0);
        joint b = revolute(left, lower) at (-0.4, 1.5);
        joint c = revolute(lower, upper) at (1.5, 3);
        joint d = revolute(upper, right) at (3.4, 1.2);
        joint e = revolute(ground, right) at (3, 0);
        joint mesh = gear(left, right, 20 : 40);
        motor b;",
    ),
    (
        "param_and_law",
        "struct Swing; param length = 2;
        ground { point o = (0, 0); }
        link arm { point o = (0, 0); point tip = (length, 0); }
        link plate { point tip = (0, 0); }
        joint a = revolute(ground.o, arm.o);
        joint b = revolute(arm.tip, plate.tip);
        motor a = 90 deg * t; motor b;",
    ),
];

/// The plan and the program of a mechanism, and that of its laws, if it has any.
fn printed(text: &str) -> String {
    let parsed = parse(text.parse().expect("tokens"));
    assert!(parsed.errors.is_empty(), "{:?}", parsed.errors);
    let compiled = compile(&parsed.model).expect("a coherent mechanism");
    let plan = compiled.plan.display(&parsed.model);
    let mut all = format!("{plan}\n{}", compiled.program);
    if let Some(timing) = compiled.timing {
        all += &format!("\nlaws\n{}", timing.program);
    }
    all
}

#[test]
fn small_mechanisms() {
    for (name, text) in MECHANISMS {
        insta::assert_snapshot!(*name, printed(text));
    }
}

#[test]
fn a_four_bar_in_closed_form() {
    insta::assert_snapshot!(printed(FOUR_BAR));
}

#[test]
fn a_four_bar_by_newton_s_method() {
    insta::assert_snapshot!(printed(&format!("{FOUR_BAR} method newton(2);")));
}
