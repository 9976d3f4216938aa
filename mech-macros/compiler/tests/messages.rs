//! Messages about mechanisms that newcomers wrote: they name the cause, and what they offer compiles.

use mech_compiler::syntax::{Parsed, parse};
use mech_compiler::{compile, repair, reporter};

fn parsed(text: &str) -> Parsed {
    let parsed = parse(text.parse().expect("tokens"));
    let errors: Vec<_> = parsed.errors.iter().map(|error| &error.text).collect();
    assert!(errors.is_empty(), "{text}: {errors:#?}");
    parsed
}

/// The only message about a mechanism, and the place that it tells about, as line and column.
fn message(text: &str) -> (String, (usize, usize)) {
    let Parsed {
        model,
        places,
        source,
        ..
    } = parsed(text);
    let diagnoses = compile(&model).expect_err(text);
    let offers = repair::offers(&model, &source, &diagnoses);
    let mut messages = reporter::messages(&diagnoses, &offers, &model, &places);
    let first = messages.remove(0);
    let spot = first.place.start.start();
    (first.text, (spot.line, spot.column + 1))
}

#[track_caller]
fn assert_message(text: &str, expected: &str, spot: (usize, usize)) {
    assert_eq!(message(text), (expected.to_owned(), spot), "{text}");
}

#[track_caller]
fn compiles(text: &str) {
    let model = parsed(text).model;
    if let Err(diagnoses) = compile(&model) {
        let texts: Vec<_> = diagnoses
            .iter()
            .map(|one| reporter::text(one, &model))
            .collect();
        panic!("{text}: {texts:#?}");
    }
}

/// What stands between these two in a message.
fn between<'t>(text: &'t str, before: &str, after: &str) -> &'t str {
    let (_, rest) = text.split_once(before).expect(before);
    rest.split_once(after).expect(after).0
}

const TAPPET: &str = "struct Valve;
link disk; link tappet;
joint s = revolute(ground, disk) at (0, 0);
joint f = prismatic(ground, tappet) at (0, 2) along (0, 1);
joint c = cam(s, f, LAW);
motor s;";

#[test]
fn a_cam_whose_law_is_not_zero_where_its_follower_is_drawn() {
    for (law, value, offer) in [
        ("1 + 0.2 * sin(q)", "1", "1 + 0.2 * sin(q) - 1"),
        ("0.3 * cos(q) - 1", "-0.7", "0.3 * cos(q) - 1 + 0.7"),
        ("0.1 + 0.2", "0.3", "0.1 + 0.2 - 0.30000000000000004"),
    ] {
        let text = TAPPET.replace("LAW", law);
        assert_message(
            &text,
            &format!(
                "cam `c` gives its follower {value} at the start, but the coordinate of `f` is 0 where it is drawn\n\nhelp: draw `tappet` as it \
                 is at the start, and write `{offer}`"
            ),
            (5, 21),
        );
        compiles(&TAPPET.replace("LAW", offer));
    }
    // Where the shaft starts elsewhere, the law counts there.
    let turned = "struct Valve;
ground { point o = (0, 0); } link disk { point o = (0, 0); } link tappet;
joint s = revolute(ground.o, disk.o);
joint f = prismatic(ground, tappet) at (0, 2) along (0, 1);
joint c = cam(s, f, LAW);
motor s; start { s = 90 deg; }";
    let (text, _) = message(&turned.replace("LAW", "3 * sin(q)"));
    assert!(
        text.starts_with("cam `c` gives its follower 3 at the start"),
        "{text}"
    );
    compiles(&turned.replace("LAW", between(&text, "write `", "`")));
}

const SLIDER: &str = "struct SliderCrank;
ground { line bore = (0, 0.5) -> (1, 0); }
link crank; link rod;
link block { line way = (0, 0) -> (1, 0); }
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (1, 0.5);
joint c = revolute(rod, block) at (4, 0.5);
joint x = prismatic(ground.bore, block.way);
motor a;";

#[test]
fn a_line_of_a_link_that_is_placed_by_at() {
    assert_message(
        SLIDER,
        "link `block` cannot stay where it is drawn: joint `c` is placed by `at`, so the frame of `block` is the scene's\n\nnote: joint \
         `x` joins `block.way` to `ground.bore`, but in the scene they are apart\nhelp: write `line way = (0, 0.5) -> (1, 0);` in \
         `block`, or place `x` by `at`, too",
        (4, 19),
    );
    compiles(&SLIDER.replace(
        "line way = (0, 0) -> (1, 0);",
        "line way = (0, 0.5) -> (1, 0);",
    ));
    let drawn = "prismatic(ground, block) at (4, 0.5) along (1, 0)";
    compiles(&SLIDER.replace("prismatic(ground.bore, block.way)", drawn));
}

#[test]
fn a_point_of_a_link_that_is_placed_by_at() {
    let drawn = "struct FourBar;
ground { point p = (4, 0); } link crank; link rod; link rocker { point foot = (0, 0); }
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (1, 1);
joint c = revolute(rod, rocker) at (4, 2);
joint d = revolute(ground.p, rocker.foot);
motor a;";
    let (text, spot) = message(drawn);
    assert_eq!(spot, (2, 72), "{text}");
    assert!(text.contains("joint `c` is placed by `at`"), "{text}");
    let offer = between(&text, "write `", "`");
    assert_eq!(offer, "point foot = (4, 0);");
    compiles(&drawn.replace("point foot = (0, 0);", offer));
}

#[test]
fn lengths_that_do_not_fit_are_told_with_the_frame_that_they_are_in() {
    let (text, _) = message(
        "struct FourBar;
link crank { point pin = (1, 0); } link rocker { point pin = (4, 2); } link rod { point left = (0, 0); point right = (3, 0); }
joint a = revolute(ground, crank) at (0, 0); joint d = revolute(ground, rocker) at (4, 0);
joint b = revolute(crank.pin, rod.left); joint c = revolute(rocker.pin, rod.right); motor a;",
    );
    assert_eq!(
        text,
        "link `rocker` cannot stay where it is drawn: link `rod`, which has lengths of its own, does not fit\n\nnote: joint `d` is placed \
         by `at`: so the frame of `rocker` is the scene's, and `rocker.pin` is given in it\nhelp: draw it where those lengths lead, or \
         change them to fit the drawing"
    );
}

const FOUR_BAR: &str = "struct FourBar;
ground { point o = (0, 0); point p = (3.5, 0); } link crank { point o = (0, 0); point b = (1, 0); }
link coupler { point b = (0, 0); point c = (3, 0); } link rocker { point p = (0, 0); point c = (2.5, 0); }
joint a = revolute(ground.o, crank.o); joint b = revolute(crank.b, coupler.b);
joint c = revolute(coupler.c, rocker.c); joint d = revolute(ground.p, rocker.p);
motor a; start { a = 60 deg; START }";

#[test]
fn the_start_of_a_joint_that_follows_is_offered_as_an_assembly() {
    let mut offers = Vec::new();
    for start in ["c = 80 deg;", "c = -80 deg;"] {
        let (text, spot) = message(&FOUR_BAR.replace("START", start));
        assert_eq!(spot, (6, 30), "{text}");
        let offer = between(&text, "write `", "` instead");
        compiles(&FOUR_BAR.replace("START", offer));
        let at = between(&text, "is at ", " deg");
        let wanted = between(start, "= ", " deg")
            .parse::<f64>()
            .expect("a number");
        let at = at.parse::<f64>().expect("a number");
        assert!(at * wanted > 0.0, "{text}");
        offers.push(offer.to_owned());
    }
    assert_ne!(offers[0], offers[1]);
    // Of several starts that follow, the first is told, and the others are no hindrance.
    let (text, _) = message(&FOUR_BAR.replace("START", "c = 80 deg; d = 10 deg;"));
    assert_eq!(between(&text, "write `", "` instead"), offers[0]);
    // Where nothing is to be chosen, it is left out.
    let drawn = "struct Drawn;
ground { point p = (4, 0); line l = (0, 0) -> (1, 0); } link crank; link rod { point tip = (4, 0); } link block { point p = (0, 0); line l = (0, 0) -> (1, 0); }
joint a = revolute(ground, crank) at (0, 0); joint b = revolute(crank, rod) at (1, 1);
joint c = revolute(rod.tip, block.p); joint x = prismatic(ground.l, block.l);
motor a; start { x = 3; }";
    let (text, _) = message(drawn);
    assert!(
        text.ends_with("help: leave this out: there is only one assembly, in which `x` is at 4"),
        "{text}"
    );
    compiles(&drawn.replace("start { x = 3; }", ""));
}

#[test]
fn a_mechanism_without_links() {
    assert_message(
        "struct S;",
        "there is no link: a mechanism has at least one, besides the ground\n\nhelp: declare one with a joint and a motor, as `link arm; \
         joint a = revolute(ground, arm) at (0, 0); motor a;`",
        (1, 8),
    );
    let (text, _) = message("struct S; ground { point p = (0, 0); }");
    compiles(&format!("struct S; {}", between(&text, "as `", "`")));
}

#[test]
fn a_motor_on_a_slot_leaves_its_pin_free_to_turn() {
    let drawn = "struct S;\nlink a;\njoint s = slot(a, ground) at (1, 0) along (1, 0);\nmotor s;";
    let (text, _) = message(drawn);
    assert!(
        text.starts_with("joint `s` stays free when all motors are held: one motor is missing\n\nnote: motor `s` drives the way of slot `s`; nothing holds the angle of its pin\nhelp: write `prismatic` for `slot`, so that `a` and `ground` only slide"),
        "{text}"
    );
    compiles(&drawn.replace("slot", "prismatic"));
    let named = "struct S; ground { line l = (0, 0) -> (1, 0); } link a { point p = (0, 0); line l = (0, 0) -> (1, 0); }
joint s = slot(a.p, ground.l); motor s;";
    let (text, _) = message(named);
    assert!(
        text.contains("\nhelp: join the same two links by a `prismatic`, so that they only slide"),
        "{text}"
    );
}

/// Cures are tried without some joint, and the spring's joint then has another number.
#[test]
fn a_motor_too_many_is_told_beside_a_torsional_spring() {
    let text = FOUR_BAR.replace("START", "coupler near 50 deg;")
        + " motor b; spring coil = torsional(d) stiffness 1 rest 6; effects { force; }";
    let (message, _) = message(&text);
    let cause = "motor `b` is one too many: motor `a` already determines what moves there\n";
    assert!(message.starts_with(cause), "{message}");
}
