//! Mechanisms that were broken by one known change: they are rejected for the right reason, and whatever is offered to mend
//! them does.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{JointId, JointKind, Model};
use mech_compiler::repair::{Offers, Repair, Search, edits, offers};
use mech_compiler::reporter;
use mech_compiler::structure::Diagnosis;
use mech_compiler::syntax::{Parsed, Places};
use mech_test_support::{
    Dice, Sample, cases, chain_text, for_all, model, parsed, samples, seeds, shuffle, text,
    with_ground, worst_gap,
};

/// Tries a test on random mechanisms, which are coherent, and their texts.
fn for_coherent(test: impl Fn(Model, String, Dice)) {
    for_all(60, &samples(1..=6), |Sample { grown, dice }| {
        let text = text(&grown.model);
        test(grown.model, text, dice);
    });
}

fn diagnose(model: &Model) -> Vec<Diagnosis> {
    match compile(model) {
        Ok(_) => panic!("accepted"),
        Err(diagnoses) => {
            assert!(!diagnoses.is_empty(), "no reason");
            diagnoses
        }
    }
}

/// What happens to a mechanism with these changes, in one word.
enum Outcome {
    Accepted,
    OpenAtStart,
    Other(Vec<Diagnosis>),
}

fn outcome(repairs: &[Repair], parsed: &Parsed) -> Outcome {
    let edits = edits(repairs, &parsed.model, parsed.source.tokens());
    let Some(mended) = edits.and_then(|edits| parsed.source.model_with(&edits)) else {
        panic!("{repairs:?} cannot be made")
    };
    let Err(wrong) = compile(&mended) else {
        return Outcome::Accepted;
    };
    match wrong[..] {
        [Diagnosis::SeveralAssemblies { .. }] => Outcome::Accepted,
        [Diagnosis::CannotClose { .. } | Diagnosis::DeadStart { .. }] => Outcome::OpenAtStart,
        _ => Outcome::Other(wrong),
    }
}

/// Every repair that is offered does what it is offered for.
fn assert_mended(parsed: &Parsed, diagnoses: &[Diagnosis]) -> Vec<Offers> {
    let found = offers(&parsed.model, &parsed.source, diagnoses);
    assert_eq!(found.len(), diagnoses.len(), "an offer each");
    for offers in &found {
        for repair in &offers.single {
            let mended = outcome(std::slice::from_ref(repair), parsed);
            assert!(matches!(mended, Outcome::Accepted), "{repair:?}");
        }
        for pair in &offers.pairs {
            let mended = outcome(pair, parsed);
            assert!(matches!(mended, Outcome::Accepted), "{pair:?}");
        }
        for repair in &offers.elsewhere {
            let mended = outcome(std::slice::from_ref(repair), parsed);
            assert!(matches!(mended, Outcome::OpenAtStart), "{repair:?}");
        }
        for repair in &offers.coupled {
            let repairs = [repair.clone(), Repair::AllowCoupled];
            let mended = outcome(&repairs, parsed);
            assert!(!matches!(mended, Outcome::Other(_)), "{repair:?}");
        }
        for repair in &offers.partial {
            match outcome(std::slice::from_ref(repair), parsed) {
                Outcome::Other(left) => assert!(left.len() < diagnoses.len(), "{repair:?}"),
                _ => panic!("{repair:?} is enough"),
            }
        }
    }
    for message in reporter::messages(diagnoses, &found, &parsed.model, &Places::default()) {
        let lines = message.text.lines().count();
        assert!(lines <= 8, "{}", message.text);
        assert!(!repeats_itself(&message.text), "{}", message.text);
    }
    found
}

/// Whether something is offered twice, or a list of what could be replaced names something twice.
fn repeats_itself(text: &str) -> bool {
    let helps = text.lines().filter_map(|line| line.strip_prefix("help: "));
    let phrases = helps.flat_map(|line| line.strip_prefix("or ").unwrap_or(line).split(", or "));
    let phrases: Vec<&str> = phrases.collect();
    if (1..phrases.len()).any(|number| phrases[..number].contains(&phrases[number])) {
        return true;
    }
    let lists = text.split("replace ").skip(1);
    lists.filter_map(|list| list.split_once(" by ")).any(|(list, _)| {
        let names: Vec<&str> = list.split(", ").flat_map(|names| names.split(" or ")).collect();
        (1..names.len()).any(|number| names[..number].contains(&names[number]))
    })
}

fn can_take_a_motor(model: &Model, id: JointId) -> bool {
    let joint = model.joint(id);
    let moves = matches!(joint.kind, JointKind::Revolute(..) | JointKind::Prismatic(..));
    moves && !joint.hidden && model.motor_of(id).is_none()
}

fn is_held(diagnosis: &Diagnosis) -> bool {
    matches!(
        diagnosis,
        Diagnosis::Blocked { .. }
            | Diagnosis::TooManyMotors { .. }
            | Diagnosis::Overdetermined { .. }
    )
}

/// Whether a brace happened to tie the two wheels of a gear: then it could carry them.
fn ties_wheels(diagnoses: &[Diagnosis]) -> bool {
    let carriers = |diagnosis: &Diagnosis| matches!(diagnosis, Diagnosis::SeveralCarriers { .. });
    diagnoses.iter().all(carriers)
}

/// Ties any two links of a text together by another, where they are; returns its name.
fn brace(model: &Model, text: &mut String, dice: &mut Dice) -> String {
    let mut ends: Vec<&str> =
        model.declared_links().map(|link| &model.link(link).name[..]).collect();
    ends.push("ground");
    let first = ends.swap_remove(dice.below(ends.len()));
    let second = *dice.pick(&ends);
    let number = text.matches("link brace").count();
    let mut place = || [(); 2].map(|()| dice.between(-5.0, 5.0));
    let ([x, y], [u, v]) = (place(), place());
    *text += &format!(
        "link brace{number};
        joint foot{number} = revolute({first}, brace{number}) at ({x:?}, {y:?});
        joint head{number} = revolute({second}, brace{number}) at ({u:?}, {v:?});\n"
    );
    format!("brace{number}")
}

/// A text without the line that begins so.
fn without(text: &str, beginning: &str) -> String {
    let lines = text.lines().filter(|line| !line.starts_with(beginning));
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn a_brace_too_many_is_found_and_can_be_removed() {
    for_coherent(|whole, mut text, mut dice| {
        let brace = brace(&whole, &mut text, &mut dice);
        let parsed = parsed(&text);
        let model = &parsed.model;
        let wrong = diagnose(model);
        if ties_wheels(&wrong) {
            return;
        }
        assert!(wrong.iter().all(is_held), "{wrong:?}");
        let found = assert_mended(&parsed, &wrong);
        let link = model.declared_links().find(|&link| model.link(link).name == brace);
        let removed = Repair::RemoveLink(link.expect("the brace"));
        let is_offered = found.iter().any(|offers| offers.single.contains(&removed));
        assert!(is_offered, "remove the brace: {wrong:?} {found:?}");
    });
}

#[test]
fn a_missing_motor_is_found_and_can_be_put_back() {
    for_coherent(|whole, text, mut dice| {
        let name = &whole.joint(dice.pick(&whole.motors).joint).name;
        let parsed = parsed(&without(&text, &format!("motor {name};")));
        let model = &parsed.model;
        let wrong = diagnose(model);
        let is_right = match &wrong[..] {
            [Diagnosis::NoMotor { freedom: 1, .. }] => model.motors.is_empty(),
            [Diagnosis::Undetermined { freedom: 1, .. }] => !model.motors.is_empty(),
            _ => false,
        };
        assert!(is_right, "{wrong:?}");
        let found = assert_mended(&parsed, &wrong);
        let joint = model.declared_joints().find(|&id| model.joint(id).name == *name);
        let added = Repair::AddMotors(vec![joint.expect("the joint").into()]);
        assert!(found[0].single.contains(&added), "{found:?}");
    });
}

#[test]
fn a_motor_too_many_is_found_and_can_be_removed() {
    for_coherent(|whole, text, mut dice| {
        let free: Vec<JointId> =
            whole.joint_ids().filter(|&id| can_take_a_motor(&whole, id)).collect();
        if free.is_empty() {
            return;
        }
        let name = &whole.joint(*dice.pick(&free)).name;
        let parsed = parsed(&format!("{text} motor {name};"));
        let wrong = diagnose(&parsed.model);
        let right = |diagnosis: &Diagnosis| {
            matches!(diagnosis, Diagnosis::TooManyMotors { .. } | Diagnosis::Blocked { .. })
        };
        assert!(wrong.len() == 1 && wrong.iter().all(right), "{wrong:?}");
        let found = assert_mended(&parsed, &wrong);
        let motor = parsed.model.motor_ids().last().expect("it was added");
        let removed = Repair::RemoveMotor(motor);
        assert!(found[0].single.contains(&removed), "{found:?}");
    });
}

#[test]
fn a_missing_joint_is_found() {
    for_coherent(|whole, text, mut dice| {
        let name = &dice.pick(&whole.joints).name;
        // Cams cannot be without their joints.
        if text.contains(&format!("cam({name},")) || text.contains(&format!(", {name}, ")) {
            return;
        }
        let text = without(&text, &format!("joint {name} = "));
        let parsed = parsed(&without(&text, &format!("motor {name};")));
        let model = &parsed.model;
        let wrong = diagnose(model);
        let right = |diagnosis: &Diagnosis| {
            matches!(
                diagnosis,
                Diagnosis::NoMotor { .. }
                    | Diagnosis::Undetermined { .. }
                    | Diagnosis::Loose { .. }
                    | Diagnosis::Disconnected { .. }
                    | Diagnosis::NoCarrier { .. }
            )
        };
        assert!(wrong.iter().all(right), "{wrong:?}");
        let found = assert_mended(&parsed, &wrong);
        for (diagnosis, offers) in wrong.iter().zip(&found) {
            if let Diagnosis::Undetermined { candidates, .. }
            | Diagnosis::NoMotor { candidates, .. } = diagnosis
            {
                // No motor sits on the pin of a slot.
                let sits = candidates.iter().all(|&id| !model.joint(id).hidden);
                assert!(!offers.is_empty() || !sits, "{wrong:?}");
            }
        }
    });
}

#[test]
fn two_braces_too_many_are_found_and_can_be_removed() {
    for_coherent(|whole, mut text, mut dice| {
        // Pairs of repairs take long.
        if !dice.once_in(10) {
            return;
        }
        for _ in 0..2 {
            brace(&whole, &mut text, &mut dice);
        }
        let parsed = parsed(&text);
        let wrong = diagnose(&parsed.model);
        if ties_wheels(&wrong) {
            return;
        }
        assert!(wrong.iter().all(is_held), "{wrong:?}");
        let found = assert_mended(&parsed, &wrong);
        assert!(found.iter().any(|offers| !offers.is_empty()), "{wrong:?} {found:?}");
    });
}

/// The work for one message is bounded, by a count that is the same on every machine; where it ends, the message says so.
#[test]
fn of_a_large_mechanism_not_all_repairs_are_tried() {
    let text = chain_text(150);
    let whole = model(&text);
    let joint = whole.joint_ids().nth(6).expect("a long chain");
    let parsed = parsed(&format!("{text} motor {};", whole.joint(joint).name));
    let wrong = diagnose(&parsed.model);
    let found = assert_mended(&parsed, &wrong);
    assert_eq!(found[0].search, Search::Bounded);
    assert!(!found[0].single.is_empty());
    let messages = reporter::messages(&wrong, &found, &parsed.model, &Places::default());
    assert!(messages[0].text.ends_with("note: not all possible changes were tried"));
    assert_eq!(found, offers(&parsed.model, &parsed.source, &wrong));
}

/// A repair is tried without its proofs, which would take most of the time: this range is too wide whatever is repaired.
#[test]
fn repairs_are_tried_without_proofs_of_ranges() {
    let with_range = |range: &str| {
        let text = format!(
            "struct M; link crank; link coupler; link rocker; link stay;
            joint a = revolute(ground, crank) at (0, 0); joint b = revolute(crank, coupler) at (0.5, 1);
            joint c = revolute(coupler, rocker) at (4, 3); joint d = revolute(ground, rocker) at (8, 0);
            joint s = revolute(ground, stay) at (0, 9); joint t = revolute(stay, coupler) at (1, 8);
            motor a {range};"
        );
        parsed(&text)
    };
    let [free, ranged] = ["", "in -170 deg ..= 170 deg"].map(with_range);
    let [free, ranged] = [free, ranged].map(|Parsed { model, source, .. }| {
        let wrong = diagnose(&model);
        offers(&model, &source, &wrong)
    });
    assert_eq!(free, ranged);
}

#[test]
fn one_choice_of_several_motors_is_offered_beside_something_else() {
    let parsed = parsed(include_str!("repairs/two-freedoms.mech"));
    let diagnoses = diagnose(&parsed.model);
    let found = assert_mended(&parsed, &diagnoses);
    let adds = |repair: &&Repair| matches!(repair, Repair::AddMotors(_));
    let added: Vec<usize> =
        found.iter().map(|offers| offers.partial.iter().filter(adds).count()).collect();
    assert_eq!(added, [0, 1]);
}

#[test]
fn wheels_on_one_shaft_may_go() {
    for beside in [
        "",
        "link c; joint r = revolute(ground, c) at (3, 0); joint next = gear(b, c, 20 : 40);",
        "link c; joint r = revolute(ground, c) at (3, 0); joint up = gear(a, c, 20 : 40); joint down = gear(c, b, 30 : 30);",
    ] {
        let text = format!(
            "struct Shaft; link a; link b; joint p = revolute(ground, a) at (0, 0); joint q = revolute(ground, b) at (0, 0);
            joint mesh = gear(a, b, 20 : 40); {beside} motor p;"
        );
        let parsed = parsed(&text);
        let diagnoses = diagnose(&parsed.model);
        let found = assert_mended(&parsed, &diagnoses);
        assert!(found.iter().all(|offers| !offers.is_empty()), "{text}");
    }
}

/// They move, but only because their lengths match.
const MATCHED: [&str; 4] = [
    include_str!("repairs/ring-element.mech"),
    include_str!("repairs/gripper.mech"),
    include_str!("repairs/gripper-of-slots.mech"),
    include_str!("repairs/straps.mech"),
];

/// What such a mechanism lacks is offered, whatever is allowed already, and then it moves with all its pins closed.
#[test]
fn what_moves_by_its_lengths_is_offered_what_it_lacks() {
    let mut lacked_both = 0;
    for text in MATCHED {
        let still = model(text);
        // The straps hold each other still.
        let moves = |joint: &JointId| {
            !matches!(&still.joint(*joint).name[..], "e" | "f") || text.contains("push")
        };
        let drivable = still.joint_ids().filter(|joint| can_take_a_motor(&still, *joint));
        // More would only take longer.
        for joint in drivable.filter(moves).take(6) {
            for allowed in 0..4 {
                let name = &still.joint(joint).name;
                let allows = ["allow redundant;", "allow coupled;"].into_iter();
                let allows = allows.zip([1, 2]).filter(|(_, bit)| allowed & bit > 0);
                let allows: String = allows.map(|(statement, _)| statement).collect();
                let parsed = parsed(&format!("{text} motor {name}; {allows}"));
                let mut model = parsed.model.clone();
                let before = model.allow;
                if let Err(wrong) = compile(&model) {
                    let found = assert_mended(&parsed, &wrong);
                    let lacks = |offered: &[Repair], repair| offered.contains(&repair);
                    if lacks(&found[0].coupled, Repair::AllowRedundant) {
                        (model.allow.redundant, model.allow.coupled) = (true, true);
                        lacked_both += 1;
                    } else if lacks(&found[0].single, Repair::AllowRedundant) {
                        model.allow.redundant = true;
                    } else if lacks(&found[0].single, Repair::AllowCoupled) {
                        model.allow.coupled = true;
                    }
                    assert_ne!(model.allow, before, "{name}: nothing is offered for {wrong:?}");
                }
                assert!(model.allow.redundant, "{name}: it is held twice");
                let compiled = compile(&model).unwrap_or_else(|found| panic!("{name}: {found:?}"));
                let mut machine = Machine::<f64>::new(&compiled.program);
                let mut closed = 0;
                for step in (0..=10).chain(-10..0) {
                    // One way it may come to its limit.
                    closed += i32::from(machine.move_to(&[0.01 * f64::from(step)]).is_ok());
                    let gap = worst_gap(&model, &with_ground(&model, &machine.position().poses));
                    assert!(gap < 1e-11, "{name}: a gap of {gap:e}");
                }
                assert!(closed > 10, "{name}: it moves {closed} times");
            }
        }
    }
    assert!(lacked_both >= 3, "{lacked_both} lacked both");
}

/// Dixon's mechanism: three pins on a line, three on another at right angles to it, and a bar from each to each. No two pins nearly meet:
/// bars that nearly cover each other leave dead points within the least displacement that is tried.
fn dixon(dice: &mut Dice) -> String {
    let pin = |dice: &mut Dice| dice.between(0.5, 4.0) * *dice.pick(&[1.0, -1.0]);
    let mut pins = || loop {
        let [a, b, c] = [(); 3].map(|()| pin(dice));
        if (a - b).abs().min((b - c).abs()).min((c - a).abs()) > 0.05 {
            break [a, b, c];
        }
    };
    let (along, across, turned) = (pins(), pins(), dice.between(0.0, 6.3));
    let bar = |a: usize, b: usize| match (a, b) {
        (0, 0) => "ground".to_owned(),
        _ => format!("bar{a}{b}"),
    };
    let (sin, cos) = turned.sin_cos();
    let mut statements: Vec<String> =
        (1..9).map(|number| format!("link {};", bar(number / 3, number % 3))).collect();
    for pin in 0..3 {
        let mut order = [0, 1, 2];
        shuffle(&mut order, dice);
        for pair in order.windows(2) {
            let [u, v] = [along[pin], across[pin]];
            let (x, y) = (u * cos, u * sin);
            let [a, b] = [bar(pin, pair[0]), bar(pin, pair[1])];
            statements
                .push(format!("joint a{pin}{} = revolute({a}, {b}) at ({x:?}, {y:?});", pair[1]));
            let (x, y) = (-v * sin, v * cos);
            let [a, b] = [bar(pair[0], pin), bar(pair[1], pin)];
            statements
                .push(format!("joint b{pin}{} = revolute({a}, {b}) at ({x:?}, {y:?});", pair[1]));
        }
    }
    shuffle(&mut statements, dice);
    format!("struct Dixon; {} allow redundant; allow coupled;", statements.concat())
}

#[test]
fn dixons_mechanism_moves_whichever_joint_is_driven() {
    for seed in seeds(cases(8)) {
        let dice = &mut Dice::new(seed);
        let text = dixon(dice);
        let still = model(&text);
        for joint in still.joint_ids() {
            let name = &still.joint(joint).name;
            let model = model(&format!("{text} motor {name};"));
            let compiled =
                compile(&model).unwrap_or_else(|found| panic!("{name}: {found:?}: {text}"));
            let mut machine = Machine::<f64>::new(&compiled.program);
            // Some dead points lie within a thousandth.
            let closed = [1.0, -1.0].map(|sense| {
                let mut steps = 1..=20;
                steps.all(|step| {
                    let moves = machine.move_to(&[sense * 1e-5 * f64::from(step)]).is_ok();
                    let gap = worst_gap(&model, &with_ground(&model, &machine.position().poses));
                    assert!(gap < 1e-11, "{name}: a gap of {gap:e}: {text}");
                    moves
                })
            });
            assert!(closed.contains(&true), "{name} does not move: {text}");
        }
    }
}
