//! Random commands: what they promise for every text.

use crate::run::repository;
use mech_studio::{
    Applied, Assembly, Command, Document, Drag, History, JointForm, Kind, Listing, NumberText,
    Replacement, Source, apply, mendings,
};
use proptest::prelude::*;
use proptest::sample::Index;
use std::fs;
use std::sync::LazyLock;

/// Returns the number of commands to try: `MECH_CASES`, or enough for a few seconds.
fn cases() -> u32 {
    let asked = std::env::var("MECH_CASES").ok();
    asked.and_then(|asked| asked.parse().ok()).unwrap_or(600)
}

/// The smaller mechanisms of the gallery, and some that are wrong.
static TEXTS: LazyLock<Vec<(String, String)>> = LazyLock::new(|| {
    const NAMES: [&str; 5] = ["four_bar", "geared_piston", "crane", "watt", "jansen"];
    let gallery = NAMES.iter().map(|name| {
        let path = format!("examples/gallery/src/mechanisms/{name}.rs");
        let text = fs::read_to_string(repository(&path)).expect("an exhibit");
        (format!("{name}.rs"), text)
    });
    let page = fs::read_to_string(repository("docs/diagnoses.md")).expect("the page");
    let wrong = page.split("```text\nstruct ").skip(1).filter_map(|block| {
        let (text, _) = block.split_once("```")?;
        Some(("wrong.mech".to_owned(), format!("struct {text}")))
    });
    gallery.chain(wrong).collect()
});

/// The random numbers from which a command is made.
#[derive(Clone, Debug)]
struct Dice {
    kind: u8,
    first: Index,
    second: Index,
    third: Index,
    number: f64,
    other: f64,
}

fn dice() -> impl Strategy<Value = Dice> {
    let place = prop_oneof![-5.0..5.0, Just(0.0), -1e6..1e6];
    let index = any::<Index>;
    (0..22_u8, index(), index(), index(), place.clone(), place).prop_map(
        |(kind, first, second, third, number, other)| Dice {
            kind,
            first,
            second,
            third,
            number,
            other,
        },
    )
}

/// A small mechanism: a chain of links with points, some of which are joined.
fn small_text() -> impl Strategy<Value = String> {
    let joint = (any::<Index>(), any::<Index>());
    let places = prop::collection::vec((-3..4_i32, -3..4_i32), 2..5);
    (places, prop::collection::vec(joint, 0..5), any::<bool>()).prop_map(|(places, joints, has_lines)| {
        let mut text = "struct Small; /* kept */\nconst SIZE = 2;\nground { point o = (0, 0); }\n".to_owned();
        for (number, (x, y)) in places.iter().enumerate() {
            let (start, end) = if has_lines { ("\n    ", "\n") } else { (" ", " ") };
            text += &format!("link l{number} {{{start}point o = (0, 0);{start}point e = ({x} + SIZE, {y}); // é\n{end}}}\n");
        }
        for (number, (a, b)) in joints.iter().enumerate() {
            let [a, b] = [a, b].map(|index| index.index(places.len()));
            if a != b {
                text += &format!("joint j{number} = revolute(l{a}.e, l{b}.o); // kept\n");
            }
        }
        text + "joint base = revolute(ground.o, l0.o);\nmotor base;\n"
    })
}

/// A command that fits a text, more or less.
fn command(dice: &Dice, listing: &Listing) -> Command {
    let names: Vec<&str> = listing
        .names
        .iter()
        .filter(|one| one.is_declared && one.part.is_none())
        .map(|one| one.path.as_str())
        .chain(["ground", "nothing"])
        .collect();
    let name = |index: &Index| names[index.index(names.len())].to_owned();
    let numbers: Vec<&NumberText> =
        listing.numbers.iter().filter(|one| one.part.is_none()).collect();
    let value = || format!("{}", dice.number);
    let pair = || [format!("{}", dice.number), format!("{} * 2", dice.other)];
    let (first, second) = (name(&dice.first), name(&dice.second));
    let new = || format!("new{}", dice.third.index(5));
    match dice.kind {
        0..4 => Command::Move { path: first, to: [dice.number, dice.other], pose: None },
        4 => Command::Rename { path: first, name: new() },
        5 | 6 => {
            const KINDS: [Kind; 6] =
                [Kind::Link, Kind::Joint, Kind::Motor, Kind::Axis, Kind::Constant, Kind::Start];
            Command::Remove { kind: KINDS[dice.third.index(KINDS.len())], name: first }
        }
        7 | 8 => match numbers.get(dice.first.index(numbers.len().max(1))) {
            Some(number) => Command::Set {
                owner: number.owner.clone(),
                role: number.role.clone(),
                value: value(),
            },
            None => Command::Link { name: new() },
        },
        9 => Command::Link { name: new() },
        10 => Command::Axis {
            path: format!("{first}.{}", new()),
            at: pair(),
            along: dice.number.is_sign_positive().then(|| "30 deg".to_owned()),
        },
        11 => {
            Command::Shape { link: first, shape: format!("circle (0, 0) radius {}", dice.number) }
        }
        12..15 => Command::Join(Assembly {
            name: new(),
            kind: if dice.kind == 12 { JointForm::Weld } else { JointForm::Revolute },
            ends: [first, second],
            at: (dice.kind == 13).then(pair),
            along: None,
        }),
        15 => Command::Motor {
            joint: first,
            law: None,
            range: Some([value(), format!("{}", dice.number + 1.0)]),
            step: None,
        },
        16 => Command::Start { name: first, is_near: dice.number > 0.0, value: value() },
        17 => Command::Mirror { name: first },
        18 => Command::Duplicate { name: first, copy: new() },
        19 => Command::Constant { name: new(), value: value(), is_param: dice.number > 0.0 },
        20 => Command::Layer { link: first, shape: 1, plane: "3".to_owned() },
        _ => Command::Repair { number: 1 + dice.third.index(3) },
    }
}

fn listing_of(document: &Document) -> Listing {
    let listing = document.listing(&document.declarations()[0]);
    listing.expect("the compiler works").unwrap_or_default()
}

/// A text with these replacements; what is between them is that of the text.
fn replaced(text: &str, edits: &[Replacement]) -> String {
    let mut changed = String::new();
    let mut at = 0;
    for edit in edits {
        assert!(at <= edit.range.start && edit.range.start <= edit.range.end, "{edits:?}");
        changed += &text[at..edit.range.start];
        changed += &edit.text;
        at = edit.range.end;
    }
    changed + &text[at..]
}

/// Applies one command after the other, and looks at what each of them does.
fn play(path: &str, text: &str, all: &[Dice]) -> (usize, usize) {
    let mut history = History::new(text);
    let mut texts = vec![text.to_owned()];
    for dice in all {
        let before = history.text().to_owned();
        let document = Document::of(Source::new(path, before.as_str()));
        let command = command(dice, &listing_of(&document));
        let applied = apply(&document, 0, &command);
        assert_eq!(document.source().text(), before);
        if let Command::Move { path, to, .. } = &command {
            follow(&document, (path, *to), applied.as_ref().ok());
        }
        match applied {
            Ok(applied) => {
                examine(&document, &command, &applied);
                let after = applied.document.source().text();
                history.push(applied.title, after);
                texts.push(after.to_owned());
            }
            Err(refusal) => {
                assert!(!refusal.is_internal(), "{command:?}: {refusal}\n{before}");
                assert_eq!(history.text(), before);
            }
        }
    }
    let made = history.made().len();
    // Back to the very bytes, and forth again.
    for text in texts.iter().rev().skip(1) {
        history.undo().expect("a step");
        assert_eq!(history.text(), text);
    }
    assert!(history.undo().is_none());
    for text in &texts[1..] {
        history.redo().expect("a step");
        assert_eq!(history.text(), text);
    }
    assert!(history.redo().is_none());
    (made, all.len())
}

/// Checks that an accepted command has done what it says.
fn examine(before: &Document, command: &Command, applied: &Applied) {
    let (old, new) = (before.source().text(), applied.document.source().text());
    let said = format!("{command:?}\n{old}\n-----\n{new}");
    assert_eq!(replaced(old, &applied.edits), new, "{said}");
    let outside = |document: &Document| {
        let whole = document.declarations()[0].whole.clone();
        let text = document.source().text();
        [text[..whole.start].to_owned(), text[whole.end..].to_owned()]
    };
    assert_eq!(outside(before), outside(&applied.document), "{said}");
    // The text, read again, gives the model of the answer.
    let declaration = &applied.document.declarations()[0];
    let model = applied.document.model(declaration).expect("the compiler works");
    let faults = applied.reading.result.as_ref().err();
    if faults.is_none_or(|faults| !faults.diagnoses.is_empty()) {
        assert_eq!(model.as_ref(), Some(&applied.reading.model), "{said}");
    }
    match command {
        Command::Move { path, to, .. } => moved(applied, path, *to, &said),
        Command::Rename { path, name } => {
            let name =
                path.rsplit_once('.').map_or(name.clone(), |(owner, _)| format!("{owner}.{name}"));
            let back = Command::Rename {
                path: name,
                name: path.rsplit('.').next().unwrap_or(path).to_owned(),
            };
            let back = apply(&applied.document, 0, &back).expect(&said);
            assert_eq!(back.document.source().text(), old, "{said}");
        }
        Command::Set { owner, role, value } => {
            let listing = listing_of(&applied.document);
            let number = listing.number(owner, role).expect(&said);
            assert_eq!(&new[number.place.clone()], value, "{said}");
        }
        Command::Repair { number } => {
            let declaration = &before.declarations()[0];
            let reading = before.analyse(declaration).expect("the compiler works");
            let all = mendings(before, declaration, &reading).expect("the compiler works");
            assert_eq!(all[number - 1].text, new, "{said}");
        }
        Command::Link { name } => {
            let model = &applied.reading.model;
            assert!(model.links.iter().any(|link| link.name == *name), "{said}");
        }
        Command::Join(assembly) => {
            let model = &applied.reading.model;
            assert!(model.joints.iter().any(|joint| joint.name == assembly.name), "{said}");
        }
        _ => {}
    }
}

/// A drag does what the command does, and shows every link where the compiled mechanism has it.
fn follow(document: &Document, (path, to): (&str, [f64; 2]), applied: Option<&Applied>) {
    let dragged = Drag::begin(document, 0, path, None).and_then(|drag| drag.move_to(to));
    let said = format!("{path} {to:?}\n{}", document.source().text());
    let (Ok(dragged), Some(applied)) = (&dragged, applied) else {
        // A text with mistakes may be moved in, though not dragged in.
        let is_wrong = document.model(&document.declarations()[0]);
        let is_wrong = is_wrong.expect("the compiler works").is_none();
        assert!(is_wrong || dragged.is_err() && applied.is_none(), "{said}");
        return;
    };
    assert_eq!(dragged.edits, applied.edits, "{said}");
    assert_eq!(dragged.notes, applied.notes, "{said}");
    assert_eq!(dragged.model, applied.reading.model, "{said}");
    let Ok(compiled) = &applied.reading.result else {
        return;
    };
    let start = &compiled.program.start;
    let size = compiled.plan.start.poses.iter().flatten();
    let size = size.fold(1.0_f64, |size, number| size.max(number.abs()));
    for (link, pose) in dragged.model.link_ids().zip(&dragged.poses) {
        let (Some(place), Some(pose)) = (compiled.program.place_of(link), pose) else {
            continue;
        };
        let apart = start.poses[place].iter().zip(pose);
        let apart = apart.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-9 * size, "{} is {apart} apart: {said}", dragged.model.link(link).name);
    }
}

/// Checks that a moved point or joint is where it should be.
fn moved(applied: &Applied, path: &str, to: [f64; 2], said: &str) {
    let model = &applied.reading.model;
    let named = model.axes.iter().find(|axis| {
        let name = axis.name.as_deref().unwrap_or_default();
        format!("{}.{name}", model.link(axis.link).name) == path
    });
    let drawn = || {
        let joint = model.joints.iter().find(|joint| joint.name == path);
        let [axis, _] = joint?.kind.axes()?;
        Some(model.axis(axis))
    };
    let at = named.or_else(drawn).expect(said).at;
    for (found, asked) in at.iter().zip(to) {
        assert!((found - asked).abs() <= 1e-11 * (1.0 + asked.abs()), "{at:?} {said}");
    }
}

/// Tries commands on random texts, as often as is asked.
fn try_all(name: &'static str, test: impl Fn(&(Index, Vec<Dice>, String)) -> (usize, usize)) {
    let config = ProptestConfig {
        cases: cases().div_ceil(10).max(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    let mut runner = proptest::test_runner::TestRunner::new(config);
    let tally = std::cell::Cell::new((0, 0));
    let strategy = (any::<Index>(), prop::collection::vec(dice(), 10), small_text());
    let result = runner.run(&strategy, |case| {
        let (made, all) = test(&case);
        let (known, total) = tally.get();
        tally.set((known + made, total + all));
        Ok(())
    });
    let (made, all) = tally.get();
    println!("{name}: {made} of {all} commands were accepted");
    result.unwrap_or_else(|error| panic!("{error}"));
    // Neither all nor none: else nothing was tried.
    assert!(made * 10 > all && made < all, "{made} of {all}");
}

#[test]
fn random_commands_on_mechanisms_that_are_known() {
    try_all("known", |(which, dice, _)| {
        let (path, text) = &TEXTS[which.index(TEXTS.len())];
        play(path, text, dice)
    });
}

#[test]
fn random_commands_on_small_mechanisms() {
    try_all("small", |(_, dice, text)| play("small.mech", text, dice));
}
