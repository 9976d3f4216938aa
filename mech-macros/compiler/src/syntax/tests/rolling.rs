//! Gears, belts and racks.

use super::joint::{LINKS, joint};
use super::model;
use super::{assert_messages, good};
use crate::model::{JointKind, LinkId, Ratio};

/// The joint of this text, between `crank` and `rod`.
fn rolling(text: &str) -> JointKind {
    let parsed = good(&format!("struct M; const A = 2; joint d = {text}; {LINKS}"));
    model::joint(&parsed.model, "d")
}

const CRANK: usize = 1;
const ROD: usize = 2;

#[test]
fn a_gear_has_teeth_or_radii() {
    let ratio = |text: &str| match rolling(&format!("gear(crank, rod, {text})")) {
        JointKind::Gear { a, b, ratio, on } => {
            assert_eq!((a.index(), b.index(), on), (CRANK, ROD, None));
            ratio
        }
        _ => panic!("a gear"),
    };
    assert_eq!(ratio("20 : 40"), Ratio::Teeth(20, 40));
    assert_eq!(ratio("20 : -60"), Ratio::Teeth(20, -60));
    assert_eq!(ratio("-1_000:0x10"), Ratio::Teeth(-1000, 16));
    assert_eq!(ratio("1.5 : 3.0"), Ratio::Radii(1.5, 3.0));
    assert_eq!(ratio("1 : A * 2"), Ratio::Teeth(1, 4));
    assert_eq!(ratio("1.0 : A / 2"), Ratio::Radii(1.0, 1.0));
}

#[test]
fn a_belt_has_teeth_or_radii() {
    let ratio = |text: &str| match rolling(&format!("belt(crank, rod, {text})")) {
        JointKind::Belt { a, b, ratio, on } => {
            assert_eq!((a.index(), b.index(), on), (CRANK, ROD, None));
            ratio
        }
        _ => panic!("a belt"),
    };
    assert_eq!(ratio("20 : 40"), Ratio::Teeth(20, 40));
    assert_eq!(ratio("1.0 : 3.0"), Ratio::Radii(1.0, 3.0));
    assert_eq!(ratio("1 : A,"), Ratio::Teeth(1, 2));
    assert_eq!(ratio("A - 1 : --3"), Ratio::Teeth(1, 3));
}

#[test]
fn a_rack_has_a_radius() {
    let rack = |text: &str| match rolling(&format!("rack(crank, rod, radius {text})")) {
        JointKind::Rack {
            pinion,
            bar,
            radius,
            on,
        } => {
            assert_eq!((pinion.index(), bar.index(), on), (CRANK, ROD, None));
            radius
        }
        _ => panic!("a rack"),
    };
    assert_eq!(rack("0.5"), 0.5);
    assert_eq!(rack("-A / 4"), -0.5);
    assert_eq!(rack("2,"), 2.0);
}

#[test]
fn the_carrier_may_be_named() {
    let carrier = |text: &str| match rolling(text) {
        JointKind::Gear { on, .. } | JointKind::Belt { on, .. } | JointKind::Rack { on, .. } => on,
        _ => panic!("something that rolls"),
    };
    let bare = Some(LinkId::new(3));
    assert_eq!(carrier("gear(crank, rod, 20 : 40 on bare)"), bare);
    assert_eq!(carrier("belt(crank, rod, 1.0 : 1.0 * A on bare,)"), bare);
    assert_eq!(carrier("rack(crank, rod, radius 2 * A on bare)"), bare);
    let ground = Some(LinkId::GROUND);
    assert_eq!(carrier("rack(crank, rod, radius A on ground,)"), ground);
}

#[test]
fn a_carrier_is_another_link() {
    let gear = "name the link that carries both wheels, or leave";
    joint(
        "gear(crank, rod, 20 : 40 on «crank»)",
        &[&format!(
            "`crank` cannot carry itself; {gear} `on crank` out"
        )],
    );
    joint(
        "belt(crank, rod, 20 : 40 on «rod»)",
        &[&format!("`rod` cannot carry itself; {gear} `on rod` out")],
    );
    joint(
        "rack(crank, rod, radius 1 on «rod»)",
        &[
            "`rod` cannot carry itself; name the link that carries the pinion and the bar, or leave `on rod` out",
        ],
    );
    joint(
        "gear(crank, rod, 20 : 40 on «bara»)",
        &["unknown link `bara`; did you mean `bare`?"],
    );
    joint(
        "rack(crank, rod, radius 1 on «d»)",
        &["`d` is a joint; this must be a link, one of `ground`, `crank`, `rod`, `bare`"],
    );
    joint(
        "belt(crank, rod, 1 : 2 on «bare».p)",
        &["`bare` is a link, not a use of a part"],
    );
    joint(
        "gear(crank, rod, 1 : 2 on«)»",
        &["expected the name of a link"],
    );
    joint(
        "revolute(crank.pin, rod.eye «on» bare)",
        &["expected `)`, found `on`"],
    );
    joint(
        "gear(crank, rod, 1 : 2) «on bare»",
        &["the carrier is named within the brackets; write `on bare)` for `) on bare`"],
    );
}

#[test]
fn links_roll() {
    for kind in ["gear", "belt"] {
        joint(
            &format!("{kind}(«crank.pin», rod, 20 : 40)"),
            &[&format!(
                "`{kind}` joins links; write `crank` for `crank.pin`"
            )],
        );
        joint(
            &format!("{kind}(crank, rod«)»"),
            &["expected `,` and the teeth of both wheels, as `20 : 40`"],
        );
        joint(
            &format!("{kind}(crank, rod, «20»)"),
            &[
                "a ratio has two numbers; write `1 : 20` if `rod` is the larger wheel, or `20 : 1` if `crank` is",
            ],
        );
        joint(
            &format!("{kind}(crank, rod, 20 : 40) «at» (0, 0)"),
            &[&format!(
                "a `{kind}` has no place of its own; its wheels turn where their other joints hold them"
            )],
        );
        joint(
            &format!("{kind}(rod, «rod», 1 : 2)"),
            &["joint `d` is between `rod` and itself; name two links"],
        );
        for many in ["99999999999999999999", "--99999999999999999999"] {
            joint(
                &format!("{kind}(crank, rod, «{many}» : 1)"),
                &["no wheel has that many teeth; a pitch radius has a decimal point"],
            );
        }
    }
    joint(
        "rack(crank, «rod.way», radius 1)",
        &["`rack` joins links; write `rod` for `rod.way`"],
    );
    joint(
        "rack(crank, «crank», radius 1)",
        &["joint `d` is between `crank` and itself; name two links"],
    );
    joint(
        "rack(crank, rod«)»",
        &["expected `,` and the radius of the pinion, as `radius 0.5`"],
    );
    joint(
        "rack(crank, rod, «0.5»)",
        &["expected `radius` before this number; write `radius 0.5`"],
    );
    let place = "a `rack` has no place of its own; its pinion turns and its bar slides where their other joints hold them";
    joint(
        "rack(crank, rod, radius 1) «at» (0, 0) «along» (1, 0)",
        &[place, place],
    );
}

#[test]
fn sizes_are_those_of_wheels() {
    let zero = "a wheel cannot be of size zero; give its teeth or its pitch radius";
    joint("gear(crank, rod, «0» : 40)", &[zero]);
    joint("gear(crank, rod, 20 : «1 - 1»)", &[zero]);
    joint(
        "gear(crank, rod, «-20 : -40»)",
        &["only one wheel of a gear can be a ring; make one of the two positive"],
    );
    let mixed = "`20` is a number of teeth, as it is whole, but `1.5` a pitch radius; write `20.0 : 1.5` for two radii, or two whole \
                 numbers";
    joint("gear(crank, rod, «20 : 1.5»)", &[mixed]);
    let mixed = "`A` is a number of teeth, as it is whole, but `A / 4` a pitch radius; write `0.5 : 2.0` for two radii, or two whole \
                 numbers";
    assert_messages(
        &format!("const A = 2; joint d = belt(crank, rod, «A / 4 : A»); {LINKS}"),
        &[mixed],
    );
    let belt = "a belt turns both wheels in the same sense; make both sizes positive";
    joint("belt(crank, rod, «0» : 40)", &[belt]);
    joint("belt(crank, rod, 20 : «-40»)", &[belt]);
    joint("belt(crank, rod, «-1.5» : «2 - 2»)", &[belt, belt]);
    joint(
        "rack(crank, rod, radius «1 - 1»)",
        &[
            "a pinion cannot be of size zero; give its pitch radius, negative if the bar is on its other side",
        ],
    );
    joint("rack(crank, rod, radius «1 / 0»)", &["division by zero"]);
}

#[test]
fn everything_wrong_is_told_in_order() {
    joint(
        "belt(«crnk», «rod.way», «-1» : «1 / 0» on «bara») «at» (0, 0)",
        &[
            "unknown link `crnk`; did you mean `crank`?",
            "`belt` joins links; write `rod` for `rod.way`",
            "a belt turns both wheels in the same sense; make both sizes positive",
            "division by zero",
            "unknown link `bara`; did you mean `bare`?",
            "a `belt` has no place of its own; its wheels turn where their other joints hold them",
        ],
    );
}

/// The message about a motor on a rack between `crank` and `rod`, where there are these joints.
fn motor_on_rack(joints: &str, remedy: &str) {
    assert_messages(
        &format!("{LINKS}joint d = rack(crank, rod, radius 1); {joints} motor «d»;"),
        &[&format!("`d` is a rack, which carries no motor; {remedy}")],
    );
}

#[test]
fn a_rack_carries_no_motor() {
    let slide = "joint s = prismatic(bare, rod) at (0, 0) along (1, 0);";
    motor_on_rack(
        &format!("{slide} joint r = revolute(ground.o, crank.pin);"),
        "put it on `r`, the revolute of `crank`",
    );
    motor_on_rack(slide, "put it on `s`, the prismatic of `rod`");
    // The revolute of a bar does not move it along, and the pivot of a slot has no name of its own.
    motor_on_rack(
        "joint r = revolute(ground.o, rod.eye); joint s = slot(crank.pin, rod.way);",
        "put it on the revolute of its pinion or the prismatic of its bar",
    );
}
