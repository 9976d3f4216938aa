//! Links of PMKS+: where what they hold goes. Their texts are in `tests/cases/commands/import_pmks.txt`.

use super::encoder::{Encoder, GROUNDED, INPUT, PRISMATIC, SEALED, TRACED, WELDED, number};
use super::moving::{Moving, distance, turn};
use crate::run::{Answer, Folder, mech_in, repository};
use std::f64::consts::TAU;
use std::fs;

fn import(word: &str) -> Answer {
    let folder = Folder::new();
    mech_in(&folder.path("."), &["import", word])
}

#[track_caller]
fn imported(link: &str) -> (String, String) {
    let answer = import(link);
    assert_eq!(answer.code, Some(0), "{}\n{}", answer.err, answer.out);
    (answer.out, answer.err)
}

fn four_bar() -> Encoder {
    Encoder::default()
        .joint(INPUT | GROUNDED, "A", [-1.5, -2.25], 0.0)
        .joint(0, "B", [-0.125, 1.5], 0.0)
        .joint(0, "C", [4.5, 2.0], 0.0)
        .joint(GROUNDED, "D", [3.0, -1.0], 0.0)
        .joint(TRACED, "P", [1.0, 3.75], 0.0)
}

/// The rows of a table of an imported link, as numbers.
#[track_caller]
fn table(link: &str, words: &str) -> Vec<Vec<f64>> {
    let (text, _) = imported(link);
    let folder = Folder::new().with("a.mech", text);
    folder.rows(&format!("table a.mech {words}"))
}

/// Writes a link twice, with its joints and links in two orders. Both mean the same.
fn shuffled(link: &Encoder) -> [String; 2] {
    let mut other = link.clone();
    other.joints.reverse();
    other.links.reverse();
    [link.url(), other.url()]
}

/// Where lengths are kept as links go, and how far the last end comes at least.
#[test]
fn imported_links_keep_their_lengths() {
    let sample = |name: &str| {
        let path = repository("studio/tests/samples").join(name);
        imported(&fs::read_to_string(path).expect("a link")).0
    };
    let rocked = (0..=10).map(|step| f64::from(step) * 0.02);
    let bar = [("ab", [-0.125, 1.5]), ("cd", [4.5, 2.0])];
    let far = Moving::of(&sample("four_bar.pmks")).keeps(rocked, &[bar]);
    assert!(far > 0.1, "{far}");
    let bars =
        [[("ab", [0.0, 1.0]), ("cd", [3.0, 2.0])], [("cd", [3.0, 2.0]), ("bce", [1.5, 3.0])]];
    let far = Moving::of(&sample("welded.pmks")).keeps(turn(24), &bars);
    assert!(far > 1.0, "{far}");
}

/// A crank and a rod, and a block on a guide; the crank or the block is driven.
fn slider_crank(shaft: usize, guide: usize) -> Moving {
    let link = Encoder::default()
        .joint(GROUNDED | shaft, "A", [0.0, 0.0], 0.0)
        .joint(0, "B", [0.75, 1.0], 0.0)
        .joint(0, "C", [4.0, 0.5], 0.0)
        .joint(PRISMATIC | GROUNDED | guide, "D", [4.0, 0.5], 0.0)
        .link("AB", &["A", "B"])
        .link("BC", &["B", "C"])
        .block("CD", ["C", "D"]);
    Moving::of(&imported(&link.url()).0)
}

#[test]
fn a_slider_is_driven_or_drives() {
    let bar = [("ab", [0.75, 1.0]), ("cd", [4.0, 0.5])];
    let far = slider_crank(INPUT, 0).keeps(turn(24), &[bar]);
    assert!(far > 1.0, "{far}");
    let far = slider_crank(0, INPUT).keeps([0.0, -0.1, -0.2, -0.3], &[bar]);
    assert!((far - 0.3).abs() < 1e-9, "{far}");
}

#[test]
fn the_first_letter_of_a_link_tells_what_is_computed() {
    let link = |letter: char| {
        four_bar()
            .raw_link(format!("{letter}RAB,AB,0,0,0,0,c5cae9,A,B,,"))
            .link("BC", &["B", "C"])
            .link("CD", &["C", "D"])
            .url()
    };
    let expected = imported(&link('Y')).0;
    for root in "AMG0123".chars() {
        assert_eq!(imported(&link(root)).0, expected, "{root}");
    }
    for part in "Namg4567".chars() {
        let answer = import(&link(part));
        assert!(!answer.out.contains("link ab"), "{part}: {}", answer.out);
    }
}

/// A bar of 3 units that lies to the right of its pivot, with a mass of 2 in its middle.
fn bar(bits: &'static str, units: &'static str) -> String {
    let [two, three, middle] = [2.0, 3.0, 1.5].map(number);
    let mut link = Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(0, "B", [3.0, 0.0], 0.0)
        .raw_link(format!("YRAB,AB,{two},{three},{middle},0,c5cae9,A,B,,"));
    link.settings = Some([bits, units]);
    link.url()
}

#[test]
fn gravity_acts_unless_it_is_switched_off() {
    let torque =
        |bits, units| table(&bar(bits, units), "torque:a --motor a --rate 0 --steps 1")[0][1];
    // 2 pounds, 2 grams and 2 kilograms at 1.5 inches, centimetres and metres.
    let weights = [2.0, 2e-3 * 9.806_65, 2.0 * 9.806_65];
    for (units, weight) in ["001", "101", "201"].into_iter().zip(weights) {
        // Clockwise input, and the dead switch of gravity, say nothing.
        for bits in ["00", "01", "02", "3v"] {
            let found = torque(bits, units);
            let expected = 1.5 * weight;
            assert!((found - expected).abs() < 1e-9 * expected, "{bits} {units}: {found}");
        }
        assert_eq!(torque("40", units), 0.0, "{units}");
    }
}

/// A crank of 1 and a rod of 3 on a line at an angle, with a block of 500 g that turns on the rod.
fn block(angle: f64) -> Encoder {
    let (sin, cos) = angle.sin_cos();
    let place = |x: f64, y: f64| [x * cos - y * sin, x * sin + y * cos];
    let end = 8.0_f64.sqrt();
    Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(0, "B", place(0.0, 1.0), 0.0)
        .joint(PRISMATIC | GROUNDED, "C", place(end, 0.0), angle)
        .more(&format!(",,,,,{}", number(500.0)))
        .link("AB", &["A", "B"])
        .link("BC", &["B", "C"])
}

#[test]
fn blocks_have_their_masses() {
    // The distance of the block from the shaft, by the angle of the crank from the line, and its slopes.
    let way = |crank: f64| crank.cos() + (9.0 - crank.sin().powi(2)).sqrt();
    let slope = |f: &dyn Fn(f64) -> f64, at: f64| (f(at + 1e-4) - f(at - 1e-4)) / 2e-4;
    let angle = 0.5_f64;
    for link in shuffled(&block(angle)) {
        let rest = table(&link, "torque:a --motor a --rate 0 --steps 8");
        let moving = table(&link, "torque:a --motor a --rate 3 --steps 8");
        for (rest, moving) in rest.iter().zip(&moving) {
            let crank = TAU / 4.0 + rest[0].to_radians();
            let speed = |at: f64| slope(&way, at);
            // Half a kilogram; lengths are in centimetres.
            let weight = 0.5 * 9.806_65 * angle.sin() * speed(crank);
            assert!((rest[1] - weight).abs() < 1e-2, "{rest:?}: {weight}");
            let inertia = 0.5 * speed(crank) * slope(&speed, crank) * 9.0 / 100.0;
            let found = moving[1] - rest[1];
            assert!((found - inertia).abs() < 1e-3, "{found}: {inertia}");
        }
    }
    // Without a mass the end of the rod slides itself.
    let mut plain = block(angle);
    let slide = plain.joints[2].split(",,,,").next().expect("its first fields");
    plain.joints[2] = slide.to_owned();
    let (text, _) = imported(&plain.url());
    assert!(text.contains("joint c = slot(bc, ground) at"), "{text}");
    assert_eq!(text.matches("\nlink ").count(), 2, "{text}");
}

#[test]
fn a_pin_slides_on_a_link_that_moves() {
    // A crank of 1 about (0, 0); a lever about (2, 0), on whose line the pin slides.
    let link = Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(PRISMATIC, "B", [0.0, 1.0], 0.0)
        .more(",CD,C,D")
        .joint(GROUNDED, "C", [2.0, 0.0], 0.0)
        .joint(0, "D", [-2.0, 2.0], 0.0)
        .link("AB", &["A", "B"])
        .link("CD", &["C", "D"]);
    for link in shuffled(&link) {
        let rows = table(&link, "cd --motor a --steps 12");
        let lever = |crank: f64| crank.sin().atan2(crank.cos() - 2.0);
        for row in rows {
            let turned = lever(TAU / 4.0 + row[0].to_radians()) - lever(TAU / 4.0);
            let off = (row[1].to_radians() - turned).rem_euclid(TAU);
            assert!(off.min(TAU - off) < 1e-9, "{row:?}: {turned}");
        }
    }
    for (slot, fault) in [
        (",CD,C", "one of which is missing"),
        (",CD,C,C", "to another"),
        (",AB,C,D", "link `AB` has no joint `C`"),
        (",XY,C,D", "there is no link `XY`"),
    ] {
        let mut broken = link.clone();
        broken.joints[1] = broken.joints[1].replace(",CD,C,D", slot);
        let complaint = import(&broken.url()).refused(2);
        assert!(complaint.contains(fault), "{complaint}");
    }
}

#[test]
fn what_is_welded_slides_without_turning() {
    // A Scotch yoke: the pin of the crank slides in the yoke, which slides on the ground.
    let link = Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(PRISMATIC, "B", [1.0, 0.0], 0.0)
        .more(",CD,C,D")
        .joint(PRISMATIC | GROUNDED | WELDED, "C", [1.0, -2.0], 0.0)
        .joint(TRACED, "D", [1.0, 3.0], 0.0)
        .link("AB", &["A", "B"])
        .link("CD", &["C", "D"]);
    for link in shuffled(&link) {
        for row in table(&link, "cd.d cd --motor a --steps 12") {
            let expected = [row[0].to_radians().cos(), 3.0];
            assert!(distance([row[1], row[2]], expected) < 1e-9, "{row:?}");
            assert_eq!(row[3], 0.0);
        }
    }
}

#[test]
fn cylinders_drive() {
    // A boom of 3 about (0, 0); a barrel about (4, 0), whose rod pushes the end of the boom.
    let along = [-4.0_f64, 3.0];
    let at = |part: f64| [4.0 + along[0] * part, along[1] * part];
    let link = Encoder::default()
        .joint(GROUNDED, "O", [0.0, 0.0], 0.0)
        .joint(0, "C", [0.0, 3.0], 0.0)
        .joint(GROUNDED, "G", [4.0, 0.0], 0.0)
        .joint(0, "N", at(0.6), 0.0)
        .joint(PRISMATIC | INPUT | WELDED | SEALED, "P", at(0.4), 0.0)
        .more(&format!(",GN,G,N,{}", number(-0.25)))
        .link("OC", &["O", "C"])
        .link("GN", &["G", "N"])
        .link("PC", &["P", "C"]);
    for link in shuffled(&link) {
        let (text, _) = imported(&link);
        assert!(text.contains("/// Input `p` slides -0.25 units a second.\n"), "{text}");
        for row in table(&link, "oc p --motor p --from -1.5 --to 1.5 --steps 6") {
            // By the law of cosines; the boom stands upright where the cylinder is 5 long.
            let cylinder = 5.0 + row[0];
            let angle = ((9.0 + 16.0 - cylinder * cylinder) / 24.0).acos();
            let turned = row[1].to_radians() + TAU / 4.0;
            assert!((turned - angle).abs() < 1e-9, "{row:?}: {angle}");
        }
    }
    // One that is a part of a link on both sides moves nothing.
    let frozen = Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(0, "N", [1.0, 0.0], 0.0)
        .joint(PRISMATIC | WELDED | SEALED, "B", [0.5, 0.0], 0.0)
        .more(",ANB,A,N")
        .link("ANB", &["A", "N", "B"]);
    let (text, omitted) = imported(&frozen.url());
    assert!(omitted.contains("what slides there and what it slides on are one"), "{omitted}");
    assert_eq!(text.matches("joint ").count(), 1, "{text}");
}

#[test]
fn what_is_pinned_to_a_weld_turns() {
    // The bell crank CDE is welded at D, where the bar DX is pinned.
    let link = Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(0, "C", [0.0, 1.0], 0.0)
        .joint(WELDED, "D", [3.0, 1.0], 0.0)
        .joint(0, "E", [3.0, 2.0], 0.0)
        .joint(GROUNDED, "X", [4.0, 0.0], 0.0)
        .link("AC", &["A", "C"])
        .link("DX", &["D", "X"])
        .raw_link("YRCDE,CDE,0,0,0,0,c5cae9,C,D,E,,CD,DE")
        .raw_link("NRCD,CD,0,0,0,0,c5cae9,C,D,,")
        .raw_link("NRDE,DE,0,0,0,0,c5cae9,D,E,,");
    let (text, _) = imported(&link.url());
    assert!(text.contains("joint d = revolute(dx, cde) at (3, 1);"), "{text}");
    let rocked = (0..=10).map(|step| f64::from(step) * 0.02);
    assert!(Moving::of(&text).keeps(rocked, &[[("ac", [0.0, 1.0]), ("dx", [3.0, 1.0])]]) > 0.1);
}

#[test]
fn several_inputs_go_at_their_speeds() {
    let crank = |link: Encoder, [a, b]: [&str; 2], x: f64, speed: &str| {
        let at = [[x, 0.0], [x + 1.0, 0.0]];
        link.joint(INPUT | GROUNDED, a, at[0], 0.0)
            .more(speed)
            .joint(TRACED, b, at[1], 0.0)
            .link(&[a, b].concat(), &[a, b])
    };
    // The first at the speed of the settings, 20 clockwise; the second at its own, 7.5 counter-clockwise.
    let link = crank(Encoder::default(), ["A", "B"], 0.0, "");
    let link = crank(link, ["C", "D"], 5.0, &format!(",,,,{}", number(7.5)));
    let (text, _) = imported(&link.url());
    assert!(text.contains("After 24 seconds all are back"), "{text}");
    let rows = table(&link.url(), "ab.b cd.d --from 0 --to 24 --steps 48");
    for row in &rows {
        let at = |x: f64, rate: f64| {
            let (sin, cos) = (rate / 60.0 * TAU * row[0]).sin_cos();
            [x + cos, sin]
        };
        assert!(distance([row[1], row[2]], at(0.0, -20.0)) < 1e-9, "{row:?}");
        assert!(distance([row[3], row[4]], at(5.0, 7.5)) < 1e-9, "{row:?}");
    }
    // Where one cannot go round, none has a law: its crank and the ground are longer than the other two.
    let rocker = link
        .joint(0, "E", [6.5, 1.0], 0.0)
        .joint(GROUNDED, "F", [6.2, 0.0], 0.0)
        .link("DE", &["D", "E"])
        .link("EF", &["E", "F"]);
    let (text, omitted) = imported(&rocker.url());
    assert!(text.contains("\nmotor a;\nmotor c;\n"), "{text}");
    assert!(text.contains("/// Input `c` turns 7.5 times a minute, counter-clockwise;"), "{text}");
    assert!(omitted.contains("inputs: they cannot go on together"), "{omitted}");
}
