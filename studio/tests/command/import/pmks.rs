//! Links of PMKS+.

use super::encoder::{
    Encoder, GROUNDED, INPUT, PRISMATIC, SEALED, TRACED, WELDED, checked, digested, number,
};
use super::moving::{Moving, distance, turn};
use crate::run::{Answer, Folder, mech_in};
use std::f64::consts::TAU;

fn import(word: &str) -> Answer {
    let folder = Folder::new();
    mech_in(&folder.path("."), &["import", word])
}

/// What becomes of a link: a text, and what is not carried over.
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

#[test]
fn a_four_bar_with_masses_names_and_a_force() {
    let [one, half] = [number(1.0), number(0.5)];
    let mut link = four_bar().link("AB", &["A", "B"]).raw_link(format!(
        "YRBCP,Long rod,{one},{half},{half},{one},26A69A,B,C,P,,"
    ));
    link = link.link("CD", &["C", "D"]);
    let [x, y, end] = [number(1.0), number(3.75), number(5.75)];
    let ten = number(10.0);
    // It turns with its link, and points outwards.
    link.forces
        .push(format!("3F1,BCP,push,{x},{y},{x},{end},{ten}"));
    let (text, omitted) = imported(&link.url());
    assert_eq!(
        text,
        "/// From a link of PMKS+.
/// Lengths are in centimetres.
/// Forces are in newtons, torques in newton centimetres, masses in units of 100 kilograms, which fit these.
/// Input `a` turns 20 times a minute, clockwise; as a law in seconds `= -2 * PI * 20 / 60 * t`.
struct Imported;
look machine;

ground { stand (-1.5, -2.25); stand (3, -1); }
link ab { bar [(-1.5, -2.25), (-0.125, 1.5)] width 0.25 on plane 2 color sky light; }
link long_rod {
    point p = (1, 3.75);
    point push = (1, 3.75);
    mass 0.00001 at (0.5, 1) inertia 0.005;
    bar [(-0.125, 1.5), (4.5, 2), (1, 3.75), (-0.125, 1.5)] width 0.25 on plane 4 color teal;
}
link cd { bar [(4.5, 2), (3, -1)] width 0.25 on plane 6 color sky light; }

joint a = revolute(ground, ab) at (-1.5, -2.25);
joint b = revolute(ab, long_rod) at (-0.125, 1.5);
joint c = revolute(long_rod, cd) at (4.5, 2);
joint d = revolute(ground, cd) at (3, -1);
motor a;
gravity (0, -980.665);
load push = force(long_rod.push);
effects { force; trace long_rod.p 720; }
"
    );
    assert_eq!(
        omitted,
        "not carried over:
  force push: a load gets its force at run time; it is (0, 10) at the start; it turns with its link there
"
    );
    let moving = Moving::of(&text);
    let rocked = (0..=10).map(|step| f64::from(step) * 0.02);
    let bar = [("ab", [-0.125, 1.5]), ("cd", [4.5, 2.0])];
    assert!(moving.keeps(rocked, &[bar]) > 0.1);
}

fn slider_crank(angle: f64) -> Encoder {
    Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(TRACED, "B", [0.75, 1.0], 0.0)
        .joint(0, "C", [4.0, 0.5], 0.0)
        .joint(PRISMATIC | GROUNDED, "D", [4.0, 0.5], angle)
        .link("AB", &["A", "B"])
        .link("BC", &["B", "C"])
        .block("CD", ["C", "D"])
}

#[test]
fn a_slider_is_a_block_on_a_guide() {
    // A query alone is a link, too.
    let (text, _) = imported(&slider_crank(0.0).query());
    assert!(
        text.contains("joint d = prismatic(ground, cd) at (4, 0.5) along (1, 0);"),
        "{text}"
    );
    assert!(text.contains("trace ab.b 720;"), "{text}");
    let moving = Moving::of(&text);
    let bar = [("ab", [0.75, 1.0]), ("cd", [4.0, 0.5])];
    assert!(moving.keeps(turn(24), &[bar]) > 1.0);
}

#[test]
fn angles_are_what_they_were_before_they_were_rounded() {
    let (text, omitted) = imported(&slider_crank(-std::f64::consts::FRAC_PI_4).url());
    assert!(text.contains("along -45 deg;"), "{text}");
    assert!(
        omitted.contains("joint D: its angle of -0.785 radians is read as -45 degrees"),
        "{omitted}"
    );
    let (text, omitted) = imported(&slider_crank(0.7).url());
    assert!(text.contains("along 0.7;"), "{text}");
    assert!(!omitted.contains("joint D"), "{omitted}");
}

#[test]
fn a_slider_may_have_the_motor() {
    let link = Encoder::default()
        .joint(GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(0, "B", [0.75, 1.0], 0.0)
        .joint(0, "C", [4.0, 0.5], 0.0)
        .joint(PRISMATIC | GROUNDED | INPUT, "D", [4.0, 0.5], 0.0)
        .link("AB", &["A", "B"])
        .link("BC", &["B", "C"])
        .block("CD", ["C", "D"]);
    let (text, _) = imported(&link.url());
    assert!(text.contains("motor d;"), "{text}");
    // Older links have it, and the ground, at the pin of the block.
    let mut older = link;
    older.joints[2] = older.joints[2].replacen('0', "6", 1);
    older.joints[3] = older.joints[3].replacen('7', "1", 1);
    assert_eq!(imported(&older.url()).0, text);
    let moving = Moving::of(&text);
    let bar = [("ab", [0.75, 1.0]), ("cd", [4.0, 0.5])];
    let far = moving.keeps([0.0, -0.1, -0.2, -0.3], &[bar]);
    assert!((far - 0.3).abs() < 1e-9, "{far}");
}

#[test]
fn links_that_are_welded_together_are_one() {
    let [one, two] = [number(1.0), number(2.0)];
    let link = Encoder::default()
        .joint(INPUT | GROUNDED, "A", [0.0, 0.0], 0.0)
        .joint(0, "B", [0.0, 1.0], 0.0)
        .joint(0, "C", [3.0, 2.0], 0.0)
        .joint(GROUNDED, "D", [3.5, 0.0], 0.0)
        .joint(WELDED, "E", [1.5, 3.0], 0.0)
        .link("AB", &["A", "B"])
        .link("CD", &["C", "D"])
        // The whole, and what is welded into it.
        .raw_link(format!("YRBCE,BCE,{two},0,{one},{two},0d125a,B,E,C,,BE,EC"))
        .raw_link(format!("NRBE,BE,{one},0,0,0,0d125a,B,E,,"))
        .raw_link("NREC,EC,0,0,0,0,0d125a,E,C,,");
    let (text, omitted) = imported(&link.url());
    assert_eq!(text.matches("\nlink ").count(), 3, "{text}");
    assert!(text.contains("mass 0.00002 at (1, 2);"), "{text}");
    assert!(
        omitted.contains("link BE: it is welded into another link"),
        "{omitted}"
    );
    let bars = [
        [("ab", [0.0, 1.0]), ("cd", [3.0, 2.0])],
        [("cd", [3.0, 2.0]), ("bce", [1.5, 3.0])],
    ];
    assert!(Moving::of(&text).keeps(turn(24), &bars) > 1.0);
}

#[test]
fn links_of_summer_2023_end_sooner() {
    let link = slider_crank(0.0);
    let (text, _) = imported(&link.query());
    let now = link.query();
    let without = now.rsplit_once(".N_").expect("what is selected").0;
    // The section of forces is there, empty; what is selected is not.
    let (older, _) = imported(&checked(without));
    assert_eq!(older, text);
}

#[test]
fn links_of_spring_2023_have_no_names_and_no_check() {
    let [x, y, four, half] = [0.75, 1.0, 4.0, 0.5].map(number);
    let joints = format!("6A,0,0,0.0B,{x},{y},0.0C,{four},{half},0.5D,{four},{half},0.");
    let expected = imported(&slider_crank(0.0).url()).0;
    let plain = |text: &str| {
        let lines = text.lines();
        let seen = |line: &&str| {
            !["look", "link", "effects", "/// Forces"]
                .iter()
                .any(|word| line.starts_with(word))
        };
        lines
            .filter(seen)
            .map(ToOwned::to_owned)
            .collect::<Vec<_>>()
    };
    // First without colours and marks, then with both, last with an empty list of names.
    for (names, links, colors) in [
        ("", "RAB,0,0,0,0,A,B.RBC,0,0,0,0,B,C.PCD,0,0,0,0,C,D..", 0),
        (
            "",
            "YRAB,0,0,0,0,c5cae9,A,B,,.YRBC,0,0,0,0,c5cae9,B,C,,.YPCD,0,0,0,0,,C,D,,..",
            2,
        ),
        (
            ".",
            "YRAB,0,0,0,0,c5cae9,A,B,,.YRBC,0,0,0,0,c5cae9,B,C,,.YPCD,0,0,0,0,,C,D,,..",
            2,
        ),
    ] {
        let link = format!("?0P.SS.K,0.101.{names}{joints}.{links}");
        let (text, _) = imported(&link);
        assert_eq!(plain(&text), plain(&expected), "{link}");
        assert_eq!(text.matches("color sky light").count(), colors, "{text}");
        let bar = [("ab", [0.75, 1.0]), ("cd", [4.0, 0.5])];
        assert!(Moving::of(&text).keeps(turn(24), &[bar]) > 1.0);
    }
}

#[test]
fn links_are_percent_decoded() {
    let link = slider_crank(0.0);
    let encoded = link.url().replace(',', "%2C").replace('_', "%5f");
    assert_eq!(imported(&encoded), imported(&link.url()));
    // And may come from the standard input, as a file.
    let folder = Folder::new().with("link.txt", format!("\u{feff}{}\n", link.url()));
    let answer = folder.mech("import link.txt");
    assert_eq!(answer.code, Some(0), "{}", answer.err);
    assert!(answer.out.contains("struct Link;"), "{}", answer.out);
}

#[test]
fn links_before_april_2023_are_plain() {
    let link = "https://app.pmksplus.com/?j=a,0,0,ab,R,t,Null,t%0Ab,0.75,1,ab%7Cbc,R,f,Null,f%0Ac,4,0.5,bc%7Ccd,R,f,Null,f%0A\
        d,4,0.5,cd,P,t,0,f%0A&l=ab,R,1,0.5,0.375,0.5,a%7Cb,,line,0,0,0,0,0,0,0,0%0Abc,R,0,0,0,0,b%7Cc,F1,line%0A\
        cd,P,Null,Null,Null,Null,c%7Cd,,Null%0A&f=F1,bc,1,2,1,5,t,false,6%0A&s=10,false,false,cm";
    let (text, omitted) = imported(link);
    assert_eq!(
        text,
        "/// From a link of PMKS+.
/// Lengths are in centimetres.
/// Forces are in newtons, torques in newton centimetres, masses in units of 100 kilograms, which fit these.
/// Input `a` turns 10 times a minute, counter-clockwise; as a law in seconds `= 2 * PI * 10 / 60 * t`.
struct Imported;

link ab { mass 0.00001 at (0.375, 0.5) inertia 0.005; }
link bc { point f1 = (1, 2); }
link cd;

joint a = revolute(ground, ab) at (0, 0);
joint b = revolute(ab, bc) at (0.75, 1);
joint c = revolute(bc, cd) at (4, 0.5);
joint d = prismatic(ground, cd) at (4, 0.5) along (1, 0);
motor a;
load f1 = force(bc.f1);
effects { force; }
"
    );
    assert!(
        omitted.contains("it is (0, -6) at the start\n"),
        "{omitted}"
    );
    let bar = [("ab", [0.75, 1.0]), ("cd", [4.0, 0.5])];
    assert!(Moving::of(&text).keeps(turn(24), &[bar]) > 1.0);
}

/// The rows of a table of an imported link, as numbers.
#[track_caller]
fn table(link: &str, words: &str) -> Vec<Vec<f64>> {
    let (text, _) = imported(link);
    let folder = Folder::new().with("a.mech", text);
    let table = folder.mech(&format!("table a.mech {words}")).done();
    let cell = |cell: &str| cell.parse().expect("a number");
    let rows = table.lines().skip(1);
    rows.map(|row| row.split(',').map(cell).collect()).collect()
}

/// What is the same for links whose parts stand in another order.
fn shuffled(link: &Encoder) -> [String; 2] {
    let mut other = link.clone();
    other.joints.reverse();
    other.links.reverse();
    [link.url(), other.url()]
}

#[test]
fn links_of_today_end_in_a_digest() {
    let link = slider_crank(0.0);
    let today = format!("https://app.pmksplus.com/?{}", digested(&link.query()));
    assert_eq!(imported(&today), imported(&link.url()));
    // One letter is another, and the length is the same.
    let broken = today.replacen("B,Im", "B,In", 1);
    let broken = if broken == today {
        today.replacen(",C,", ",D,", 1)
    } else {
        broken
    };
    let complaint = import(&broken).refused(2);
    assert!(complaint.contains("check all letters"), "{complaint}");
    let mut marked = link.clone();
    // Locks, an anchor, a synthesis and a length that is held are no parts of a mechanism; what is not known is told.
    marked.extras = ".JA,LAB,CGAB,S1,HlAB,PFpush~0~0.0004,Q7";
    let (text, omitted) = imported(&digested(&marked.query()));
    assert_eq!(text, imported(&link.url()).0);
    assert_eq!(
        omitted,
        "not carried over:
  `Q7`: this entry of the last section is not known
  `PFpush~0~0.0004`: a number with more than three decimals is read with three
"
    );
}

#[test]
fn numbers_have_more_than_three_decimals() {
    let mut link = block(0.0);
    link.extras = ".PJB~1~1.00025,PJC~0~2.8284271247461903,PLAB~0~0.0125,PLAB~2~0.00015,PI~0~7.25";
    let (text, omitted) = imported(&digested(&link.query()));
    assert_eq!(omitted, "");
    for line in [
        "/// Input `a` turns 7.25 times a minute, clockwise;",
        "mass 1.25e-7 at (0.00015, 0);",
        "joint b = revolute(ab, bc) at (0, 1.00025);",
        "prismatic(ground, c_block) at (2.82842712",
    ] {
        assert!(text.contains(line), "{line}: {text}");
    }
    for (extras, fault) in [
        (".PJB~1", "has a kind, an id, a field and a value"),
        (".PJZ~1~2", "there is no joint `Z`"),
        (".PJB~1~inf", "no number, or too large"),
    ] {
        link.extras = extras;
        let complaint = import(&digested(&link.query())).refused(2);
        assert!(complaint.contains(fault), "{complaint}");
    }
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
            assert!(
                (found - expected).abs() < 1e-9 * expected,
                "{bits} {units}: {found}"
            );
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
    // How far the block is from the shaft, by the angle of the crank from the line, and its slopes.
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
    let slide = plain.joints[2]
        .split(",,,,")
        .next()
        .expect("its first fields");
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
        assert!(
            text.contains("/// Input `p` slides -0.25 units a second.\n"),
            "{text}"
        );
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
    assert!(
        omitted.contains("what slides there and what it slides on are one"),
        "{omitted}"
    );
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
    assert!(
        text.contains("joint d = revolute(dx, cde) at (3, 1);"),
        "{text}"
    );
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
    assert!(
        text.contains("/// Input `c` turns 7.5 times a minute, counter-clockwise;"),
        "{text}"
    );
    assert!(
        omitted.contains("inputs: they cannot go on together"),
        "{omitted}"
    );
}

#[test]
fn directions_are_within_a_turn() {
    let text = imported(&slider_crank(6.597).url()).0;
    assert!(text.contains("along 0.313815;"), "{text}");
}

#[test]
fn plain_links_of_every_year_are_read() {
    let plain = |joints: &str, links: &str, forces: &str, settings: &str| {
        let sections = [joints, links, forces].map(|lines| lines.replace(' ', "%0A"));
        let [joints, links, forces] = sections;
        format!("https://example.org/?j={joints}&l={links}&f={forces}&pp=&tp=&s={settings}")
    };
    let [joints, links] = [
        "a,0,0,ab,R,t,0,0,t, b,0.75,1,ab|bc,R,f,0,0,f, c,4,0.5,bc|cd,R,f,0,0,f, d,4,0.5,cd,P,t,0,0,f,",
        "ab,1,0.5,0.375,0.5,a|b,,l,0 bc,0,0,0,0,b|c,F1,l,0",
    ];
    // The block is named by joints alone; a force has its parts.
    let first = plain(
        joints,
        links,
        "F1,bc,1,2,4,6,t,true,30,40",
        "10,false,false,cm",
    );
    let (text, omitted) = imported(&first);
    let later = plain(
        "a,0,0,ab,R,t,Null,t b,0.75,1,ab|bc,R,f,Null,f c,4,0.5,bc|cd,R,f,Null,f d,4,0.5,cd,P,t,0,f",
        "ab,R,1,0.5,0.375,0.5,a|b,,l bc,R,0,0,0,0,b|c,F1,l cd,P,Null,Null,Null,Null,c|d,,l",
        "F1,bc,1,2,4,6,t,true,50",
        "10,false,false,cm",
    );
    assert_eq!(imported(&later).0, text);
    assert!(omitted.contains("it is (30, 40) at the start"), "{omitted}");
    let bar = [("ab", [0.75, 1.0]), ("cd", [4.0, 0.5])];
    assert!(Moving::of(&text).keeps(turn(24), &[bar]) > 1.0);
    assert!(!text.contains("gravity"), "{text}");
    // Friction is told, and gravity is a switch of its own.
    let rough = joints.replace(",0,0,f,", ",0,0.1,f,");
    let (text, omitted) = imported(&plain(&rough, links, "", "10,true,true,m"));
    assert!(
        omitted.contains("the language has no friction"),
        "{omitted}"
    );
    assert!(text.contains("gravity (0, -9.80665);"), "{text}");
    assert!(
        text.contains("turns 10 times a minute, clockwise"),
        "{text}"
    );
}
