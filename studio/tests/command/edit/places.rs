//! Points that are moved, by their numbers and at poses; numbers that are set.

use super::{NAMED, done_to, refused, replaces, shift};
use mech_studio::Command;

#[test]
fn a_literal_is_written_over() {
    let applied = replaces(
        &shift("rocker.c", [2.75, 0.0], None),
        "c = (3, 0)",
        "c = (2.75, 0)",
    );
    assert!(applied.notes.is_empty());
    replaces(
        &shift("ground.p", [4.5, -0.25], None),
        "(4, 0)",
        "(4.5, -0.25)",
    );
}

#[test]
fn a_constant_is_solved_for_and_named() {
    let applied = replaces(
        &shift("coupler.c", [3.75, 0.0], None),
        "ROD = 3.5",
        "ROD = 3.75",
    );
    assert_eq!(applied.notes, ["ROD = 3.75"]);
    assert!(applied.reading.result.is_ok());
}

#[test]
fn several_numbers_that_could_be_solved_for_are_named() {
    let refusal = refused(NAMED, &shift("coupler.tip", [2.4, 1.0], None));
    assert_eq!(
        refusal.to_string(),
        "x of `coupler.tip` is `2 * THROW`, in which each of `2`, `THROW` could give 2.4; set one of them"
    );
}

#[test]
fn a_number_that_no_literal_gives_is_locked() {
    let text = NAMED.replace("2 * THROW", "PI");
    let refusal = refused(&text, &shift("coupler.tip", [2.4, 1.0], None));
    assert!(
        refusal
            .to_string()
            .contains("in which no number of this text stands"),
        "{refusal}"
    );
    // `0` can: 2.4 * THROW. `THROW` cannot.
    let text = NAMED.replace("2 * THROW", "0 * THROW");
    let applied = done_to(&text, &shift("coupler.tip", [2.4, 1.0], None));
    assert_eq!(
        applied.document.source().text(),
        text.replace("0 * THROW", "2.4 * THROW")
    );
    assert_eq!(applied.notes, ["2.4 in place of 0 in `0 * THROW`"]);
}

#[test]
fn one_number_in_both_coordinates_gives_only_what_it_can() {
    let text = NAMED.replace("(2 * THROW, 1)", "(ROD, ROD)");
    let applied = done_to(&text, &shift("coupler.tip", [3.25, 3.25], None));
    assert_eq!(
        applied.document.source().text(),
        text.replace("ROD = 3.5", "ROD = 3.25")
    );
    refused(&text, &shift("coupler.tip", [3.25, 3.0], None));
}

#[test]
fn numbers_that_are_not_finite_are_refused() {
    for bad in [f64::NAN, f64::INFINITY] {
        refused(NAMED, &shift("rocker.c", [bad, 0.0], None));
        refused(NAMED, &shift("rocker.c", [0.0, 1.0], Some(&[("a", bad)])));
    }
}

#[test]
fn an_edit_at_a_pose_is_carried_back_to_the_declaration() {
    // The ground does not move.
    replaces(
        &shift("ground.p", [4.25, 0.0], Some(&[("a", 90.0)])),
        "(4, 0)",
        "(4.25, 0)",
    );
    // The crank has turned by a right angle.
    let text = NAMED.replace("(THROW, 0)", "(1.0, 0.0)");
    let applied = done_to(&text, &shift("crank.b", [0.0, 1.25], Some(&[("a", 90.0)])));
    let after = applied.document.source().text();
    let (_, place) = after
        .split_once("link crank { point o = (0, 0); point b = (")
        .expect("the crank");
    let (place, _) = place.split_once(')').expect("a place");
    let numbers: Vec<f64> = place
        .split(", ")
        .map(|part| part.parse().expect("a number"))
        .collect();
    assert!(
        (numbers[0] - 1.25).abs() < 1e-12 && numbers[1].abs() < 1e-12,
        "{place}"
    );
    assert!(after.contains("start { a = 10 deg; coupler near 50 deg; }"));
}

#[test]
fn an_edit_after_which_the_pose_cannot_be_reached_is_refused() {
    let refusal = refused(NAMED, &shift("ground.p", [7.4, 0.0], Some(&[("a", 180.0)])));
    assert!(
        refusal.to_string().contains("cannot come to these values"),
        "{refusal}"
    );
}

#[test]
fn numbers_are_set_by_their_roles() {
    let set = |owner: &str, role: &str, value: &str| Command::Set {
        owner: owner.to_owned(),
        role: role.to_owned(),
        value: value.to_owned(),
    };
    replaces(
        &set("rocker", "shape 1 radius", "THROW / 4"),
        "radius 0.2",
        "radius THROW / 4",
    );
    replaces(
        &set("rocker", "shape 1 color", "red dark"),
        "color teal",
        "color red dark",
    );
    replaces(&set("a", "start", "12 deg"), "10 deg", "12 deg");
    replaces(&set("coupler", "near", "45 deg"), "50 deg", "45 deg");
    replaces(&set("coupler.tip", "trace length", "128"), "64", "128");
    replaces(&set("THROW", "value", "1.1"), "THROW = 1.0", "THROW = 1.1");
    let refusal = refused(NAMED, &set("rocker", "shape 1 width", "1"));
    assert_eq!(
        refusal.to_string(),
        "`rocker` has no number `shape 1 width`; it has `shape 1 at`, `shape 1 x`, `shape 1 y`, `shape 1 radius`, `shape 1 color`"
    );
    refused(NAMED, &set("rocker", "shape 1 radius", "-1"));
    refused(NAMED, &set("nobody", "x", "1"));
}

#[test]
fn numbers_of_a_part_are_set_by_the_name_of_the_part() {
    let text = "struct Legs;
part Leg(size = 1) {
    port frame { point hip = (0, 0); }
    link shank { point hip = (0, 0); point foot = (2 * size, 0); }
    joint hip = revolute(frame.hip, shank.hip);
}
use left: Leg { frame = ground at (0, 0) };
use right: Leg(size = 2) { frame = ground at (5, 0) };
motor left.hip;
motor right.hip;
";
    let set = |owner: &str, role: &str, value: &str| {
        let command = Command::Set {
            owner: owner.to_owned(),
            role: role.to_owned(),
            value: value.to_owned(),
        };
        done_to(text, &command).document.source().text().to_owned()
    };
    assert_eq!(
        set("Leg.shank.foot", "x", "3 * size"),
        text.replace("2 * size", "3 * size")
    );
    assert_eq!(
        set("Leg.size", "value", "1.5"),
        text.replace("size = 1)", "size = 1.5)")
    );
    assert_eq!(
        set("right", "size", "4"),
        text.replace("size = 2)", "size = 4)")
    );
    let why = |path: &str| refused(text, &shift(path, [1.0, 0.0], None)).to_string();
    assert_eq!(
        why("left.shank.foot"),
        "`shank.foot` is fixed by part `Leg`, for all that use it; set `x` and `y` of `Leg.shank.foot`"
    );
    assert_eq!(
        why("Leg.shank.foot"),
        "`Leg.shank.foot` is in the frame of its part; set its `x` and `y`"
    );
}
