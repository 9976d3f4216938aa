//! A program is held to another geometry than it was built for: the joint that differs is named.

use super::check;
use crate::bug::catch;
use crate::model::Model;
use crate::program::Program;
use crate::structure::{Structure, analyse};
use crate::syntax::parse;
use crate::{Compiled, compile};

/// A four-bar with one of everything that a joint can be.
const TEXT: &str = "struct M;
    link crank; link rod; link rocker; link plate; link arm; link wheel; link pulley; link bar; link follower;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (0.8, 0.6);
    joint c = revolute(rod, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    joint w = weld(rod, plate) at (2, 1);
    joint e = revolute(ground, arm) at (6, 0);
    joint s = slot(rocker, arm) at (4.5, 2) along (0.6, -0.8);
    joint h = revolute(ground, wheel) at (-3, 0);
    joint g = gear(crank, wheel, 20 : 60);
    joint i = revolute(ground, pulley) at (-6, 3);
    joint t = belt(wheel, pulley, 1.5 : 1.0);
    joint x = prismatic(ground, bar) at (0, -2) along (1, 0);
    joint k = rack(crank, bar, radius 2.0);
    joint f = prismatic(ground, follower) at (0, 5) along (0, 1);
    joint z = cam(a, f, 0.3 * sin(q));
    motor a;";

fn read(text: &str) -> Model {
    let parsed = parse(text.parse().expect("tokens"));
    assert!(parsed.errors.is_empty(), "{:?}", parsed.errors);
    parsed.model
}

fn built() -> (Model, Structure, Program) {
    let model = read(TEXT);
    let Compiled { structure, program, .. } = compile(&model).expect("it moves");
    (model, structure, program)
}

#[test]
fn a_joint_that_is_not_where_it_was_declared_is_named() {
    let (_, _, program) = built();
    let changes = [
        ("b", "(0.8, 0.6)", "(0.8, 0.600001)"),
        ("d", "(4, 0)", "(4.000001, 0)"),
        ("s", "(0.6, -0.8)", "(0.6, -0.800001)"),
        ("x", "along (1, 0)", "along (1, 0.000001)"),
        ("g", "20 : 60", "20 : 61"),
        ("t", "1.5 : 1.0", "1.50001 : 1.0"),
        ("k", "radius 2.0", "radius 2.00001"),
        ("z", "0.3 * sin", "0.300001 * sin"),
    ];
    for (joint, old, new) in changes {
        let other = read(&TEXT.replace(old, new));
        let structure = analyse(&other).expect(new);
        let found = catch(|| check(&other, &structure, &program));
        let said = found.expect_err(new);
        assert!(said.starts_with(&format!("joint `{joint}` ")), "{said}");
    }
}

#[test]
fn a_link_that_is_not_where_the_program_should_put_it_is_noticed() {
    let (model, structure, program) = built();
    for link in 0..program.poses.len() {
        for part in 0..4 {
            let mut torn = program.clone();
            torn.poses[link][part] = program.poses[(link + 1) % program.poses.len()][3 - part];
            if torn.poses == program.poses {
                // Both are the same constant.
                continue;
            }
            let found = catch(|| check(&model, &structure, &torn));
            assert!(found.is_err(), "part {part} of link {link}");
        }
    }
    check(&model, &structure, &program);
}

/// In single precision, by methods that leave a gap, and where only some links are computed, what is right is let pass.
#[test]
fn what_is_inexact_by_design_is_let_pass() {
    let settings = [
        "method linear;",
        "method newton(1);",
        "method newton;",
        "method newton(4);",
        "show follower;",
    ];
    for (setting, precision) in settings.iter().flat_map(|s| [(s, "M"), (s, "M: f32")]) {
        let text = TEXT.replace("motor a;", "motor a by 1 deg;") + setting;
        let text = text.replace("struct M", &format!("struct {precision}"));
        assert!(compile(&read(&text)).is_ok(), "{setting} {precision}");
    }
}
