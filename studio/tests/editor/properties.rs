//! Random gestures, by mouse and by keys: what they promise for every drawing.

use super::user::User;
use eframe::egui::Key;
use mech_compiler::model::{AxisId, LinkId};
use mech_studio::editor::Item;
use mech_studio::{Document, Reading, Source};
use proptest::prelude::*;
use proptest::sample::Index;

/// Returns the number of random sessions to try: `MECH_CASES`, or enough for a few seconds.
fn cases() -> u32 {
    let asked = std::env::var("MECH_CASES").ok();
    asked.and_then(|asked| asked.parse().ok()).unwrap_or(24)
}

/// Texts to begin with, with comments and with spaces where nobody expects them.
const TEXTS: [&str; 4] = [
    "",
    "struct  FourBar ; // kept
const SIZE = 1;   /* kept too */
link crank;
link coupler { point tip = (0, 2 * SIZE); // é
}
link rocker;

joint a = revolute(ground, crank) at (-2, 0); // the first
joint b = revolute(crank, coupler) at ( -2,1 );
joint c = revolute(coupler, rocker) at (1, 3);
joint d = revolute(rocker, ground) at (2, 0);
motor a;
",
    "struct Press;
link crank; link rod; link ram;
joint shaft = revolute(ground, crank) at (0, 0);
joint big = revolute(crank, rod) at (0.6, 0.8); joint small = revolute(rod, ram) at (3, 0);
joint guide = prismatic(ground, ram) at (3, 0) along (1, 0);
motor shaft;
",
    "struct Loose;
// nothing drives it, and one bar is too many
link one; link two;
joint a = revolute(ground, one) at (0, 0);
joint b = revolute(one, two) at (1, 2);
joint c = revolute(two, ground) at (3, 0);
",
];

#[derive(Clone, Debug)]
enum Act {
    Tool(Index, [[i8; 2]; 2]),
    Drag(Index, [i8; 2]),
    /// Moves a handle by a key.
    Nudge(Index, Index),
    Delete(Index),
    Mend(Index),
    Undo,
    Redo,
    Play,
    Copy,
}

/// A place on the grid of the drawing.
fn spot() -> impl Strategy<Value = [i8; 2]> {
    [-8..9_i8, -6..7_i8]
}

fn act() -> impl Strategy<Value = Act> {
    let index = any::<Index>;
    prop_oneof![
        4 => (index(), [spot(), spot()]).prop_map(|(tool, spots)| Act::Tool(tool, spots)),
        3 => (index(), spot()).prop_map(|(handle, to)| Act::Drag(handle, to)),
        1 => (index(), index()).prop_map(|(handle, key)| Act::Nudge(handle, key)),
        2 => index().prop_map(Act::Delete),
        2 => index().prop_map(Act::Mend),
        2 => Just(Act::Undo),
        1 => Just(Act::Redo),
        1 => Just(Act::Play),
        1 => Just(Act::Copy),
    ]
}

const TOOLS: [&str; 16] = [
    "Bar", "Ground", "Pin", "Slider", "Slot", "Wheel", "Gears", "Belt", "Weld", "Motor", "Point",
    "Trace", "Spring", "Damper", "Force", "Disc",
];

fn place([x, y]: [i8; 2]) -> [f64; 2] {
    [x, y].map(|part| 0.4 * f64::from(part))
}

/// Does it, as far as there is something to do it with.
fn perform(user: &mut User, act: &Act) {
    let handles = user.handles();
    let handle =
        |index: &Index| (!handles.is_empty()).then(|| handles[index.index(handles.len())].clone());
    match act {
        Act::Tool(tool, spots) => {
            user.click_on(TOOLS[tool.index(TOOLS.len())]);
            for spot in spots {
                user.click(place(*spot));
            }
            user.click_on("Select");
        }
        Act::Drag(index, to) => {
            if let Some(from) = handle(index).and_then(|label| user.scene_place_of(&label)) {
                user.drag(from, place(*to));
            }
        }
        Act::Nudge(index, key) => {
            if let Some(label) = handle(index) {
                user.focus(&label);
                let keys = [Key::ArrowLeft, Key::ArrowRight, Key::ArrowUp, Key::ArrowDown];
                user.key(keys[key.index(keys.len())]);
            }
        }
        Act::Delete(index) => {
            if let Some(from) = handle(index).and_then(|label| user.scene_place_of(&label)) {
                user.click(from);
                user.key(Key::Delete);
            }
        }
        Act::Mend(index) => {
            let count = user.editor().mendings().len();
            if count > 0 {
                user.mend(1 + index.index(count));
            }
        }
        Act::Undo => user.shortcut(Key::Z, false),
        Act::Redo => user.shortcut(Key::Z, true),
        Act::Play => {
            user.key(Key::Space);
            user.wait(5);
            user.key(Key::Space);
        }
        Act::Copy => {
            user.shortcut(Key::A, false);
            user.copy_and_paste();
        }
    }
}

/// The texts that undoing would bring back, the first one first.
fn texts_of(user: &User) -> Vec<String> {
    let steps = user.editor().workspace().history().made();
    steps.iter().map(|step| step.text.clone()).collect()
}

/// The words and signs of a text, without numbers.
fn words(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
        let end = if is_part(first) {
            rest.find(|c| !is_part(c)).unwrap_or(rest.len())
        } else {
            first.len_utf8()
        };
        let (word, after) = rest.split_at(end);
        if !first.is_ascii_digit() && first != '-' {
            found.push(word);
        }
        rest = after;
    }
    found
}

/// Whether all lines of one text stand in another, in the same order.
fn stands_in(text: &str, other: &str) -> bool {
    let mut lines = other.lines();
    text.lines().all(|line| lines.any(|other| other == line))
}

/// Comments stay, wherever they stand, in this order.
fn comments(text: &str) -> Vec<&str> {
    text.match_indices("//").map(|(at, _)| text[at..].lines().next().unwrap_or_default()).collect()
}

/// Checks that the drawing equals the compiler's result, to the bit.
fn is_drawn_as_compiled(user: &User) {
    let player = user.editor().player();
    let is_whole = user.editor().is_readable() && user.editor().messages().is_empty();
    if !is_whole || !player.is_some_and(|player| player.mechanism().is_at_start()) {
        return;
    }
    let document = Document::of(Source::new("again.mech", user.text()));
    let reading = document.analyse(&document.declarations()[0]);
    let Reading { model, result, .. } = reading.expect("the compiler works");
    let program = result.expect("what moves compiles").program;
    let place = |axis: AxisId| {
        let axis = model.axis(axis);
        if axis.link == LinkId::GROUND {
            return Some(axis.at.map(f64::to_bits));
        }
        let [cos, sin, left, up] = program.start.poses[program.place_of(axis.link)?];
        let [x, y] = axis.at;
        Some([left + cos * x - sin * y, up + sin * x + cos * y].map(f64::to_bits))
    };
    let drawing = user.editor().drawing().expect("it is drawn");
    for handle in drawing.handles() {
        let Item::Joint(name) = handle.item else {
            continue;
        };
        let joint = model.joints.iter().find(|joint| joint.name == *name);
        let axes = joint.and_then(|joint| joint.kind.axes()).expect("it has two axes");
        let expected: Vec<_> = axes.into_iter().filter_map(place).collect();
        let seen = handle.place.map(f64::to_bits);
        assert!(
            expected.is_empty() || expected.contains(&seen),
            "{name}: {:?}\n{}",
            handle.place,
            user.said()
        );
    }
}

/// Holds what every gesture promises.
fn does_as_promised(user: &mut User, act: &Act) {
    let (before, steps) = (user.text().to_owned(), texts_of(user).len());
    perform(user, act);
    let after = user.text().to_owned();
    let made = texts_of(user);
    // An accepted text can be read.
    assert!(after.trim().is_empty() || user.editor().is_readable(), "{act:?}\n{}", user.said());
    if matches!(act, Act::Drag(..) | Act::Nudge(..)) {
        assert_eq!(words(&before), words(&after), "{act:?} changes more than numbers");
    }
    if matches!(act, Act::Tool(..)) && made.len() <= steps + 1 && !after.is_empty() {
        // Something is added, at most within a line, which then has all that it had.
        assert_eq!(comments(&before), comments(&after), "{act:?}\n{before}\n{after}");
    }
    if matches!(act, Act::Play) {
        assert_eq!(before, after);
    }
    // All that was done is undone, byte for byte, and done again.
    if made.len() > steps {
        for _ in steps..made.len() {
            user.shortcut(Key::Z, false);
        }
        assert_eq!(user.text(), before, "{act:?} is not undone");
        for _ in steps..made.len() {
            user.shortcut(Key::Z, true);
        }
        assert_eq!(user.text(), after, "{act:?} is not done again");
    }
    is_drawn_as_compiled(user);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(), failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_gestures_keep_their_promises(
        first in any::<Index>(),
        acts in prop::collection::vec(act(), 1..10),
    ) {
        let text = TEXTS[first.index(TEXTS.len())];
        let mut user = User::with_text(text);
        for act in &acts {
            does_as_promised(&mut user, act);
        }
        // From the last text back to the first.
        for _ in texts_of(&user) {
            user.shortcut(Key::Z, false);
        }
        prop_assert_eq!(user.text(), text);
    }

    /// In a browser the next gesture often comes while the last one is still being tried; at a computer, sometimes.
    #[test]
    fn gestures_that_come_faster_than_the_analysis_lose_nothing(
        first in any::<Index>(),
        acts in prop::collection::vec(act(), 1..10),
        has_threads in any::<bool>(),
    ) {
        let text = TEXTS[first.index(TEXTS.len())];
        let mut user = if has_threads { User::with_threads() } else { User::in_browser() };
        user.at_once(|editor| editor.type_text(text));
        user.settle();
        for act in &acts {
            // Repairs, and handles that are named, are there when they were found.
            if matches!(act, Act::Mend(_) | Act::Nudge(..)) {
                user.settle();
            }
            perform(&mut user, act);
        }
        user.settle();
        let last = user.text().to_owned();
        prop_assert!(last.trim().is_empty() || user.editor().is_readable(), "{}", user.said());
        is_drawn_as_compiled(&user);
        let made = texts_of(&user).len();
        for _ in 0..made {
            user.shortcut(Key::Z, false);
            user.settle();
        }
        prop_assert_eq!(user.text(), "");
        for _ in 0..made {
            user.shortcut(Key::Z, true);
            user.settle();
        }
        prop_assert_eq!(user.text(), last);
    }

    #[test]
    fn bars_that_are_drawn_only_add_lines(ends in prop::collection::vec([spot(), spot()], 1..6)) {
        let mut user = User::new();
        user.key(Key::B);
        for [from, to] in ends {
            let before = user.text().to_owned();
            user.drag(place(from), place(to));
            let after = user.text();
            prop_assert!(
                after.lines().count() >= before.lines().count() && stands_in(&without_points(&before), after),
                "{before}\n{after}"
            );
        }
    }
}

/// A text without the lines of links, which may get points.
fn without_points(text: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with("link"));
    lines.map(|line| format!("{line}\n")).collect()
}
