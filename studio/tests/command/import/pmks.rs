//! Links of PMKS+.

use super::encoder::{Encoder, GROUNDED, INPUT, PRISMATIC, TRACED, WELDED, checked, number};
use super::moving::{Moving, turn};
use crate::run::{Answer, Folder, mech_in};

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
/// Masses and moments of inertia are those of PMKS+.
struct Imported;
look machine;

ground { stand (-1.5, -2.25); stand (3, -1); }
link ab { bar [(-1.5, -2.25), (-0.125, 1.5)] width 0.25 on plane 2 color sky light; }
link long_rod {
    point p = (1, 3.75);
    point push = (1, 3.75);
    mass 1 at (0.5, 1) inertia 0.5;
    bar [(-0.125, 1.5), (4.5, 2), (1, 3.75), (-0.125, 1.5)] width 0.25 on plane 4 color teal;
}
link cd { bar [(4.5, 2), (3, -1)] width 0.25 on plane 6 color sky light; }

joint a = revolute(ground, ab) at (-1.5, -2.25);
joint b = revolute(ab, long_rod) at (-0.125, 1.5);
joint c = revolute(long_rod, cd) at (4.5, 2);
joint d = revolute(ground, cd) at (3, -1);
motor a;
load push = force(long_rod.push);
effects { force; trace long_rod.p 360; }
"
    );
    assert_eq!(
        omitted,
        "not carried over:
  settings: the speed of the input is 20 turns a minute, clockwise; a motor has no speed of its own
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
    assert!(text.contains("trace ab.b 360;"), "{text}");
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
    assert!(text.contains("mass 2 at (1, 2);"), "{text}");
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
            !["look", "link", "effects"]
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
/// Masses and moments of inertia are those of PMKS+.
struct Imported;

link ab { mass 1 at (0.375, 0.5) inertia 0.5; }
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
        omitted.contains("it is (0, -6) at the start\n")
            && omitted.contains("10 turns a minute, counter-clockwise"),
        "{omitted}"
    );
    let bar = [("ab", [0.75, 1.0]), ("cd", [4.0, 0.5])];
    assert!(Moving::of(&text).keeps(turn(24), &[bar]) > 1.0);
}
