//! `mech table` and `mech plot`.

use crate::run::{FOUR_BAR, Folder};

/// The cells of a table without its head, as numbers.
fn numbers(table: &str) -> Vec<Vec<f64>> {
    let rows = table.lines().skip(1);
    let cell = |cell: &str| cell.parse().unwrap_or(f64::NAN);
    rows.map(|row| row.split(',').map(cell).collect()).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

#[test]
fn without_a_quantity_all_coordinates() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let table = folder.mech("table a.mech --steps 4").done();
    assert_eq!(
        table.lines().next(),
        Some("motor a [deg],a [deg],b [deg],c [deg],d [deg]")
    );
    let rows = numbers(&table);
    assert_eq!(rows.len(), 5);
    // The angles of a quadrangle add up, and a whole turn leads back; the crank has turned against the coupler.
    for row in &rows {
        assert!(close(row[1] + row[2] + row[3], row[4]), "{row:?}");
        assert!(close(row[0], row[1]), "{row:?}");
    }
    assert!(
        close(rows[4][2], -360.0) && close(rows[4][4], 0.0),
        "{rows:?}"
    );
}

/// A crank of length 2, whose pin and coordinate are known.
const CRANK: &str = "struct Crank;
link crank { point pin = (2, 0); mass 3 at (2, 0); }
joint a = revolute(ground, crank) at (0, 0);
motor a;
gravity (0, -10);
";

#[test]
fn rates_and_forces_of_a_crank() {
    let folder = Folder::new().with("a.mech", CRANK);
    let words = "table a.mech crank.pin velocity:crank.pin acceleration:crank.pin.norm torque:a \
        reaction:a velocity:crank --from 30 --to 60 --steps 1 --rate 0.5 --length m --force N";
    let table = folder.mech(words).done();
    assert_eq!(
        table.lines().next(),
        Some(
            "motor a [deg],crank.pin.x [m],crank.pin.y [m],velocity:crank.pin.x [m/s],velocity:crank.pin.y [m/s],\
             acceleration:crank.pin.norm [m/s²],torque:a [N·m],reaction:a.x [N],reaction:a.y [N],velocity:crank [rad/s]"
        )
    );
    for row in numbers(&table) {
        let (sin, cos) = row[0].to_radians().sin_cos();
        // A mass of 3 at distance 2 turns at half a radian per second.
        let expected = [
            2.0 * cos,
            2.0 * sin,
            -sin,
            cos,
            0.5,
            3.0 * 10.0 * 2.0 * cos,
            -3.0 * 0.5 * cos,
            3.0 * (10.0 - 0.5 * sin),
            0.5,
        ];
        for (found, expected) in row[1..].iter().zip(expected) {
            assert!(close(*found, expected), "{row:?}");
        }
    }
}

#[test]
fn a_slide_is_measured_along_its_guide() {
    let text = "struct SliderCrank; link crank; link rod; link block;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (1, 0);
joint c = revolute(rod, block) at (4, 0);
joint x = prismatic(ground, block) at (4, 0) along (1, 0);
motor a;";
    let folder = Folder::new().with("a.mech", text);
    let table = folder
        .mech("table a.mech x velocity:x acceleration:x --from 90 --to 90 --steps 1")
        .done();
    let row = &numbers(&table)[0];
    // A crank of 1 and a rod of 3, upright.
    let root = 8.0_f64.sqrt();
    assert!(close(row[1], root - 4.0) && close(row[2], -1.0), "{row:?}");
    assert!(close(row[3], 1.0 / root), "{row:?}");
}

#[test]
fn a_slide_on_a_link_that_turns() {
    // The coordinate of the slot changes as if the arm stood still: compared with differences.
    let text = "struct Whitworth;
ground { point o = (0, 0); point q = (0, -1); }
link crank { point o = (0, 0); point pin = (2, 0); }
link arm { point q = (0, 0); line way = (0, 0) -> (1, 0); }
joint a = revolute(ground.o, crank.o);
joint e = revolute(ground.q, arm.q);
joint s = slot(crank.pin, arm.way);
motor a;
start { a = 20 deg; arm near 40 deg; }";
    let folder = Folder::new().with("a.mech", text);
    let words = "table a.mech s velocity:s acceleration:s --from 50 --to 50.002 --steps 2";
    let rows = numbers(&folder.mech(words).done());
    let step = 0.001_f64.to_radians();
    let rate = (rows[2][1] - rows[0][1]) / (2.0 * step);
    let second = (rows[2][2] - rows[0][2]) / (2.0 * step);
    assert!((rate - rows[1][2]).abs() < 1e-6, "{rows:?}");
    assert!((second - rows[1][3]).abs() < 1e-6, "{rows:?}");
}

#[test]
fn what_is_not_determined_is_empty() {
    let text = "struct SliderCrank; link crank; link rod; link block;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (1, 0.5);
joint c = revolute(rod, block) at (4, 0);
joint x = prismatic(ground, block) at (4, 0) along (1, 0);
motor x; ";
    let folder = Folder::new().with("a.mech", text);
    let table = folder
        .mech("table a.mech velocity:a --motor x --from 0 --to 0.1 --steps 1")
        .done();
    assert!(numbers(&table)[0][1].is_finite(), "{table}");
    let refusal = folder.mech("table a.mech").refused(2);
    assert!(
        refusal.contains("say where with `--from` and `--to`"),
        "{refusal}"
    );
}

#[test]
fn quantities_that_are_none() {
    let folder = Folder::new().with("a.mech", FOUR_BAR).with("b.mech", CRANK);
    let refusals = [
        (
            "table a.mech tip",
            "has no joint, link or point `tip`; it has joints `a`, `b`, `c`, `d`; links",
        ),
        ("table a.mech speed:a", "`speed` cannot be measured"),
        ("table a.mech torque:b", "has no motor `b`"),
        ("table a.mech reaction:x", "has no joint `x`"),
        ("table b.mech transmission", "has no loop"),
        ("table a.mech --steps 0", "0 is not in 1.."),
        (
            "plot a.mech -o a.pdf",
            "its name has to end in `.svg`, `.png`",
        ),
    ];
    for (words, text) in refusals {
        let refusal = folder.mech(words).refused(2);
        assert!(refusal.contains(text), "{words}: {refusal}");
    }
    assert_eq!(folder.names(), ["a.mech", "b.mech"]);
}

#[test]
fn a_plot_has_a_graph_for_each_unit() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    folder
        .mech("plot a.mech b c velocity:coupler.tip -o a.svg --title Rocking --length mm")
        .done();
    let text = folder.text("a.svg");
    for words in [
        "Rocking",
        "motor a [deg]",
        "[deg]",
        "[mm/s]",
        "velocity:coupler.tip.x",
        "180",
        "360",
    ] {
        assert!(text.contains(words), "{words}");
    }
    assert_eq!(text.matches("motor a [deg]").count(), 2);
    folder.mech("plot a.mech transmission -o a.png").done();
    let bytes = std::fs::read(folder.path("a.png")).expect("a picture");
    assert!(bytes.starts_with(b"\x89PNG"));
}

#[test]
fn one_quantity_over_another() {
    let folder = Folder::new().with("a.mech", CRANK);
    let table = folder
        .mech("table a.mech crank.pin.y --over crank.pin.x --steps 12")
        .done();
    assert_eq!(
        table.lines().next(),
        Some("crank.pin.x [unit],crank.pin.y [unit]")
    );
    for row in numbers(&table) {
        assert!(close(row[0].hypot(row[1]), 2.0), "{row:?}");
    }
    // Time is counted from where the motion begins.
    let table = folder
        .mech("table a.mech crank.pin.y --over t --from 30 --to 60 --steps 3 --rate 0.5")
        .done();
    assert_eq!(table.lines().next(), Some("t [s],crank.pin.y [unit]"));
    let rows = numbers(&table);
    assert!(close(rows[3][0], 30_f64.to_radians() / 0.5), "{rows:?}");
    for row in rows {
        let angle = 30_f64.to_radians() + 0.5 * row[0];
        assert!(close(row[1], 2.0 * angle.sin()), "{row:?}");
    }
    folder
        .mech("plot a.mech crank.pin.y velocity:crank.pin.y --over crank.pin.x -o a.svg")
        .done();
    let text = folder.text("a.svg");
    assert_eq!(text.matches("crank.pin.x [unit]").count(), 2, "{text}");
    for (over, why) in [
        (
            "crank.pin",
            "is several numbers, `crank.pin.x`, `crank.pin.y`; name one of them",
        ),
        ("crank.top", "has no joint, link or point `crank.top`"),
    ] {
        let refusal = folder
            .mech(&format!("table a.mech --over {over}"))
            .refused(2);
        assert!(refusal.contains(why), "{refusal}");
    }
}

#[test]
fn time_at_rest_is_not_determined() {
    let folder = Folder::new().with("a.mech", CRANK);
    let table = folder.mech("table a.mech t a --steps 1 --rate 0").done();
    assert!(numbers(&table).iter().all(|row| row[1].is_nan()), "{table}");
}

/// A joint that has the name of time is meant, where it is there.
#[test]
fn a_joint_may_be_called_t() {
    let text = CRANK
        .replace("joint a", "joint t")
        .replace("motor a", "motor t");
    let folder = Folder::new().with("a.mech", text);
    let table = folder
        .mech("table a.mech t --from 30 --to 60 --steps 1")
        .done();
    assert!(table.starts_with("motor t [deg],t [deg]\n"), "{table}");
    for row in numbers(&table) {
        assert!(close(row[0], row[1]), "{row:?}");
    }
}

#[test]
fn tables_go_to_files_whole() {
    let folder = Folder::new().with("a.mech", FOUR_BAR).with("a.csv", "old");
    folder.mech("table a.mech -o a.csv --steps 3").done();
    assert_eq!(folder.text("a.csv").lines().count(), 5);
    assert_eq!(folder.names(), ["a.csv", "a.mech"]);
}

#[test]
fn a_load_is_carried_by_the_motor() {
    let text = CRANK.to_owned()
        + "load push = force(crank.pin);\nload brake = torque(crank);\neffects { force; }\n";
    let folder = Folder::new().with("a.mech", text);
    let motion = "--from 30 --to 60 --steps 1 --rate 0";
    let words =
        format!("table a.mech torque:a reaction:a {motion} --load push=-7,4 --load brake=-1.5");
    for row in numbers(&folder.mech(&words).done()) {
        let (sin, cos) = row[0].to_radians().sin_cos();
        let expected = [
            3.0 * 10.0 * 2.0 * cos - 2.0 * (cos * 4.0 - sin * -7.0) + 1.5,
            7.0,
            3.0 * 10.0 - 4.0,
        ];
        for (found, expected) in row[1..].iter().zip(expected) {
            assert!(close(*found, expected), "{row:?}");
        }
    }
    let refused = |given: &str, code| {
        folder
            .mech(&format!("table a.mech torque:a {given}"))
            .refused(code)
    };
    assert_eq!(
        refused("--load pull=1", 2),
        "error: `Crank` has no load `pull`; it has `push`, `brake`\n"
    );
    assert_eq!(
        refused("--load push=1", 2),
        "error: load `push` is a force; write `--load push=X,Y`\n"
    );
    assert_eq!(
        refused("--load brake=1,2", 2),
        "error: load `brake` is a torque; write `--load brake=VALUE`\n"
    );
    assert!(refused("--load brake=inf", 2).contains("`inf` is not finite"));
}

#[test]
fn a_number_has_another_value_for_once() {
    let text = CRANK
        .replace("link crank", "const ARM = 2;\nparam lift = 0;\nlink crank")
        .replace("pin = (2, 0)", "pin = (ARM, lift)");
    let folder = Folder::new().with("a.mech", &text);
    let words = "table a.mech crank.pin --from 0 --to 90 --steps 1 --set ARM=5 --set";
    let rows = numbers(&folder.mech(&format!("{words} lift=0.5")).done());
    assert!(close(rows[0][1], 5.0) && close(rows[0][2], 0.5), "{rows:?}");
    assert!(
        close(rows[1][1], -0.5) && close(rows[1][2], 5.0),
        "{rows:?}"
    );
    assert_eq!(folder.text("a.mech"), text);
    assert_eq!(
        folder.mech(&format!("{words} size=3")).refused(2),
        "error: `Crank` has no constant or param `size`; it has `ARM`, `lift`\n"
    );
    let wrong = folder.mech(&format!("{words} lift=1/0")).refused(1);
    assert!(
        wrong.contains("the text could not be read any more"),
        "{wrong}"
    );
    // What cannot move with it is told as `check` tells it.
    let far = FOUR_BAR
        .replace(
            "struct FourBar;",
            "struct FourBar;\nconst REACH = 4;\nground { point d = (REACH, 0); }",
        )
        .replace(
            "rocker;",
            "rocker { point d = (4, 0); point c = (3.3, 2.9); }",
        )
        .replace("coupler, rocker) at (3.3, 2.9)", "coupler.c, rocker.c)")
        .replace("coupler {", "coupler { point c = (3.3, 2.9);")
        .replace("ground, rocker) at (4, 0)", "ground.d, rocker.d)");
    let folder = Folder::new().with("far.mech", far);
    folder.mech("draw far.mech -o far.svg").done();
    let told = folder
        .mech("draw far.mech -o far.svg --set REACH=40")
        .refused(1);
    assert!(
        told.contains("cannot be closed") || told.contains("close"),
        "{told}"
    );
}
