//! Mechanisms with one error each, small and large.

use mech_test_support::chain_text;
use std::fmt::Write as _;

/// A mechanism with an error.
pub(crate) struct Case {
    /// What is wrong.
    pub(crate) name: &'static str,
    pub(crate) links: usize,
    pub(crate) text: String,
    /// How many milliseconds its diagnosis may take in a build without optimisation.
    pub(crate) most: f64,
}

/// What 20 links may take, and what 300 may.
const MOST: [(usize, f64); 3] = [(10, 300.0), (60, 1000.0), (150, 1000.0)];

/// Every case in every size.
pub(crate) fn cases() -> Vec<Case> {
    let mut cases = vec![ranges(), range()];
    for (loops, most) in MOST {
        let links = 2 * loops + 1;
        let wrong: [(&str, String); 9] = [
            ("motor too many", with(loops, "motor j6;")),
            ("brace too many", with(loops, &brace("coupler_1", "rocker_4"))),
            (
                "two braces",
                with(loops, &(brace("coupler_1", "rocker_4") + &brace("coupler_5", "ground"))),
            ),
            ("no motor", without(loops, "motor j0;")),
            ("joint missing", without(loops, "joint j6 ")),
            (
                "two joints missing",
                without(loops, "joint j6 ").replace("joint j9 ", "link spare; joint j9 ").replace(
                    "link spare; joint j9 = revolute(ground",
                    "link spare; joint j9 = revolute(spare",
                ),
            ),
            (
                "wrong carrier",
                with(
                    loops,
                    "link wheel; joint w = revolute(ground, wheel) at (-1, 0); joint g = gear(crank, wheel, 20 : 30 on rocker_2);",
                ),
            ),
            ("loops that wait", with(loops, PLATFORM)),
            ("a weld too many", with(loops, "joint w = weld(coupler_3, rocker_3) at (1, 1);")),
        ];
        cases.extend(wrong.map(|(name, text)| Case { name, links, text, most }));
    }
    cases
}

/// A link on three legs, whose loops wait for each other.
const PLATFORM: &str = "link platform; link left; link middle; link right;
    joint left_foot = revolute(rocker_1, left) at (5, 5); joint left_knee = revolute(left, platform) at (6, 8);
    joint middle_foot = revolute(rocker_3, middle) at (11, 5); joint middle_knee = revolute(middle, platform) at (10, 9);
    joint right_foot = revolute(ground, right) at (16, 5); joint right_knee = revolute(right, platform) at (14, 8);";

fn with(loops: usize, more: &str) -> String {
    chain_text(loops) + more
}

fn without(loops: usize, statement: &str) -> String {
    let text = chain_text(loops);
    let lines = text.lines().filter(|line| !line.starts_with(statement));
    lines.collect::<Vec<_>>().join("\n")
}

/// A link that holds two links which move.
fn brace(a: &str, b: &str) -> String {
    format!(
        "link brace_{b}; joint foot_{b} = revolute({a}, brace_{b}) at (1, 7); joint head_{b} = revolute({b}, brace_{b}) at (5, 8);"
    )
}

/// Three cranks with ranges, and a joint where it should not be.
fn ranges() -> Case {
    let mut text = "struct Ranges; link stay; joint s = revolute(ground, stay) at (0, 9); joint t = revolute(stay, coupler0) at (1, 8);".to_owned();
    for bar in 0..3 {
        let x = 10.0 * f64::from(bar);
        let _ = write!(
            text,
            "link crank{bar}; link coupler{bar}; link rocker{bar};
            joint a{bar} = revolute(ground, crank{bar}) at ({x}, 0);
            joint b{bar} = revolute(crank{bar}, coupler{bar}) at ({}, 1);
            joint c{bar} = revolute(coupler{bar}, rocker{bar}) at ({}, 3);
            joint d{bar} = revolute(ground, rocker{bar}) at ({}, 0);
            motor a{bar} in -10 deg ..= 40 deg;",
            x + 0.5,
            x + 4.0,
            x + 5.0,
        );
    }
    Case { name: "wrong joint, ranges", links: 10, text, most: 300.0 }
}

/// A turret with six cylinders one upon the other, the last with a range to beyond its dead point.
fn range() -> Case {
    Case {
        name: "range too long",
        links: 20,
        text: include_str!("digger.txt").to_owned(),
        most: 300.0,
    }
}
