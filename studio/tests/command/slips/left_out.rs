//! Each joint of each correct text is left out once: one of the first two repairs joins the same links again.

use super::corpus::{self, analyse};
use super::text::Text;
use mech_studio::mendings;
use std::ops::Range;

/// A joint: whether it guides, and what it joins.
type Joint = (bool, [String; 2]);

/// Long texts take too much time.
const LONGEST: usize = 4000;
/// The kinds of joints, and the floors: so many of a hundred are offered.
const FLOORS: [(&str, usize); 3] = [("between points", 97), ("drawn", 83), ("guides", 75)];

/// The joint of a statement `joint NAME = KIND(END, END) ...;`, if it can be declared by a repair.
fn joint(statement: &str) -> Option<Joint> {
    let declared = statement.trim().strip_prefix("joint ")?;
    let (kind, rest) = declared.split_once('=')?.1.split_once('(')?;
    let guides = match kind.trim() {
        "revolute" => false,
        "prismatic" | "slot" => true,
        _ => return None,
    };
    let (a, b) = rest.split_once(')')?.0.split_once(',')?;
    let mut ends = [a, b].map(|end| end.trim().to_owned());
    ends.sort();
    Some((guides, ends))
}

/// What a repair joins, if it is one joint.
fn offered(words: &str) -> Option<Joint> {
    let quoted = words.split('`').flat_map(|text| text.split(';'));
    let mut joints = quoted.filter_map(joint);
    joints.next().filter(|_| joints.next().is_none())
}

fn links([a, b]: &[String; 2]) -> [&str; 2] {
    let mut links = [a, b].map(|end| end.split('.').next().unwrap_or(""));
    links.sort_unstable();
    links
}

#[test]
fn a_joint_that_is_left_out_is_offered() {
    let mut rows = FLOORS.map(|(name, floor)| (name, floor, 0, 0));
    let mut missed = Vec::new();
    let correct = corpus::read().into_iter().map(|one| one.text);
    for correct in correct.filter(|one| one.len() < LONGEST && !one.contains("part ")) {
        let text = Text::of(&correct);
        let written = |one: &Range<usize>| &correct[text.bytes(one.clone())];
        for statement in text.statements() {
            let Some((guides, ends)) = joint(written(&statement)) else {
                continue;
            };
            let left = text.instead(statement.clone(), "").text;
            let (document, reading) = analyse(&left);
            // What names the joint is told before anything else; some move without it.
            let is_told = reading.result.as_ref().err();
            if is_told.is_none_or(|faults| faults.diagnoses.is_empty()) {
                continue;
            }
            let found = mendings(&document, &document.declarations()[0], &reading);
            let found = found.unwrap_or_else(|failure| panic!("{failure:?}\n{left}"));
            let first: Vec<&str> = found.iter().take(2).map(|one| &*one.words).collect();
            let are_points = ends.iter().all(|end| end.contains('.'));
            let is_it = |(other, joined): Joint| {
                let same = if are_points { joined == ends } else { links(&joined) == links(&ends) };
                same && guides == other
            };
            let row = &mut rows[if guides { 2 } else { usize::from(!are_points) }];
            row.3 += 1;
            if first.iter().filter_map(|words| offered(words)).any(is_it) {
                row.2 += 1;
            } else {
                missed.push(format!("{}: {first:?}", written(&statement)));
            }
        }
    }
    println!("{}", missed.join("\n"));
    for (name, _, offered, all) in rows {
        println!("{name}: {offered} of {all}");
    }
    for (name, floor, offered, all) in rows {
        assert!(offered * 100 >= floor * all, "{name}: {offered} of {all}");
    }
}
