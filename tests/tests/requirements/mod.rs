//! What is expected of a mechanism, against what is measured of its poses: a limit a little beyond the true extreme is proved, one a little
//! within is refused with a place where the mechanism breaks it. Four-bars have closed forms.

mod question;
mod subject;
mod sweep;

use mech_compiler::model::{Model, Precision};
use mech_compiler::requirement::judge;
use mech_compiler::structure::{Diagnosis, RequirementTrouble};
use mech_compiler::{Analysis, Compiled, analyse, compile};
use question::Question;
pub(super) use subject::Subject;
use sweep::Sweep;
pub(super) use sweep::reach;

use mech_test_support::{
    Dice, cases, folder, for_all, four_bar_text, known_texts, samples, seeds, text,
};
use proc_macro2::TokenStream;
use std::collections::BTreeMap;

/// A limit is so far from the true extreme, as a part of what the quantity makes.
const MARGIN: f64 = 1e-3;

pub(super) fn judged(body: &TokenStream, requirement: &str) -> Analysis {
    analyse(with(body, requirement)).prove()
}

/// A text with more statements.
fn with(body: &TokenStream, statements: &str) -> TokenStream {
    let mut all = body.clone();
    all.extend(statements.parse::<TokenStream>().expect("tokens"));
    all
}

/// The troubles with the requirements of a mechanism.
pub(super) fn troubles(analysis: &Analysis) -> Vec<RequirementTrouble> {
    let Err(faults) = &analysis.result else {
        return Vec::new();
    };
    let unmet = faults.diagnoses.iter().map(|diagnosis| match diagnosis {
        Diagnosis::Unmet { trouble, .. } => trouble.clone(),
        other => panic!("{other:?}: {:?}", faults.messages),
    });
    let unmet: Vec<RequirementTrouble> = unmet.collect();
    assert!(!unmet.is_empty(), "{:?}", faults.messages);
    unmet
}

/// How many requirements were proved, how many refused with a place that breaks them, and how many were left open: by what was bounded.
#[derive(Debug, Default)]
struct Count {
    proved: usize,
    refused: usize,
    iterated: usize,
    open: BTreeMap<String, usize>,
}

impl Count {
    /// Asks so many questions about the motion of one motor of a mechanism, in a single analysis.
    fn judge(&mut self, body: &TokenStream, dice: &mut Dice, most: usize) {
        let model = analyse(body.clone()).parsed.model;
        if model.motors.is_empty() || !model.params.is_empty() {
            return;
        }
        let whole =
            Model { show: None, method: None, accuracy: None, precision: Precision::F64, ..model };
        let Ok(compiled) = compile(&whole) else {
            return;
        };
        let subjects = Subject::of_all_kinds(&whole, &compiled.plan, dice);
        let Some(sweep) = Sweep::any(&whole, &compiled.program, &subjects, dice) else {
            return;
        };
        let spans = [0; 2].map(|_| Sweep::span(dice));
        let questions = (0..most)
            .filter_map(|number| Question::any(&sweep, &subjects, spans[number % 2], dice));
        let questions: Vec<Question<'_, '_>> = questions.collect();
        let statements: String = questions.iter().map(|one| one.text.as_str()).collect();
        let analysis = analyse(with(body, &statements));
        let asked = &analysis.parsed.model;
        let compiled: &Compiled = match &analysis.result {
            Ok(compiled) => compiled,
            Err(faults) => panic!("{statements}: {:?}", faults.messages),
        };
        let answers = judge(asked, compiled);
        let own = answers.len() - questions.len();
        for (question, answer) in questions.iter().zip(&answers[own..]) {
            let trouble = match answer {
                Ok(_) => None,
                Err(Diagnosis::Unmet { trouble, .. }) => Some(trouble),
                Err(other) => panic!("{other:?}"),
            };
            if let Err(wrong) = self.note(question, trouble) {
                panic!("{}: {} {wrong}", whole.name, question.text);
            }
        }
    }

    /// Notes an answer; tells what is wrong with it.
    fn note(
        &mut self,
        question: &Question<'_, '_>,
        trouble: Option<&RequirementTrouble>,
    ) -> Result<(), String> {
        match trouble {
            None => {
                self.proved += 1;
                question.refute_proof()
            }
            Some(RequirementTrouble::Fails(witness)) => {
                self.refused += 1;
                question.refute(witness)
            }
            Some(RequirementTrouble::Iterated { .. }) => {
                self.iterated += 1;
                Ok(())
            }
            Some(RequirementTrouble::Undecided { .. } | RequirementTrouble::TooHard) => {
                *self.open.entry(question.kind()).or_default() += 1;
                Ok(())
            }
            Some(other) => Err(format!("{other:?}")),
        }
    }

    fn decided(&self) -> usize {
        self.proved + self.refused
    }

    fn open(&self) -> usize {
        self.open.values().sum()
    }
}

#[test]
fn limits_beside_true_extremes_are_decided_in_the_gallery() {
    let (mut count, mut dice) = (Count::default(), Dice::new(3));
    for body in known_texts() {
        count.judge(&body, &mut dice, 12);
    }
    println!("{count:?}");
    assert!(count.decided() > 100 && 20 * count.open() <= count.decided(), "{count:?}");
}

/// `MECH_TEXTS=DIRECTORY` asks of all texts there.
#[test]
fn limits_beside_true_extremes_are_decided_in_other_texts() {
    let Ok(texts) = std::env::var("MECH_TEXTS") else {
        return;
    };
    let (mut count, mut dice) = (Count::default(), Dice::new(4));
    let files = std::fs::read_dir(texts).expect("a directory");
    let paths = files.map(|file| file.expect("a file").path());
    for path in paths.filter(|path| path.extension().is_some_and(|ending| ending == "mech")) {
        let body = std::fs::read_to_string(&path).expect("a text");
        let Ok(body) = body.parse::<TokenStream>() else {
            continue;
        };
        let before = count.open();
        count.judge(&body, &mut dice, 16);
        if count.open() > before {
            println!("{}: {} open", path.display(), count.open() - before);
        }
    }
    println!("{count:?}");
}

/// A drawing with a point anywhere on each link.
fn with_points(text: &str, dice: &mut Dice) -> TokenStream {
    let line = |line: &str| match (line.strip_prefix("link "), line.strip_suffix(';')) {
        (Some(_), Some(link)) => {
            let [x, y] = [0; 2].map(|_| dice.between(-4.0, 4.0));
            format!("{link} {{ point p = ({x}, {y}); }}")
        }
        _ => line.to_owned(),
    };
    let lines: Vec<String> = text.lines().map(line).collect();
    lines.join("\n").parse().expect("tokens")
}

#[test]
fn limits_beside_true_extremes_are_decided_in_random_mechanisms() {
    let mut count = Count::default();
    for_all(4, &samples(1..4), |mut sample| {
        let body = with_points(&text(&sample.grown.model), &mut sample.dice);
        count.judge(&body, &mut sample.dice, 60);
    });
    println!("{count:?}");
    assert!(count.decided() > 20 && 10 * count.open() <= count.decided(), "{count:?}");
}

/// The lengths of a crank and rocker: the crank is shortest, and with the longest link shorter than the two others.
fn crank_rocker(dice: &mut Dice) -> [f64; 4] {
    loop {
        let crank = dice.between(0.2, 1.0);
        let [ground, coupler, rocker] = [0; 3].map(|_| dice.between(1.1, 4.0));
        let longest = ground.max(coupler).max(rocker);
        let others = ground + coupler + rocker - longest;
        if crank + longest < 0.98 * others {
            return [ground, crank, coupler, rocker];
        }
    }
}

/// A four-bar that starts with its crank at this angle in degrees, and its rocker above.
fn four_bar(lengths: [f64; 4], start: f64) -> TokenStream {
    let start = format!("start {{ ja = {start} deg; rocker near 90 deg; }}");
    let text = four_bar_text(lengths) + &start;
    text.parse().expect("tokens")
}

/// The angle between two sides of a triangle, less than a right one, opposite to a third.
fn between([a, b]: [f64; 2], opposite: f64) -> f64 {
    let cos = (a * a + b * b - opposite * opposite) / (2.0 * a * b);
    cos.abs().min(1.0).acos()
}

#[test]
fn transmission_and_swing_of_four_bars_are_those_of_their_triangles() {
    for seed in seeds(cases(8)) {
        let mut dice = Dice::new(seed);
        let lengths @ [ground, crank, coupler, rocker] = crank_rocker(&mut dice);
        let body = four_bar(lengths, 60.0);
        let ends = [ground - crank, ground + crank];
        let least = ends.map(|distance| between([coupler, rocker], distance));
        let least = least[0].min(least[1]);
        // At the ends of the swing crank and coupler lie in one line.
        let at = |reach: f64| {
            let cos = (ground * ground + rocker * rocker - reach * reach) / (2.0 * ground * rocker);
            cos.acos()
        };
        let swing = at(coupler + crank) - at((coupler - crank).abs());
        for (subject, sign, extreme) in [
            ("transmission", ">=", least),
            ("swing(jd)", ">=", swing),
            ("swing(jd)", "<=", swing),
            ("max(jd) - min(jd)", "<=", swing),
        ] {
            let way = if sign == "<=" { 1.0 } else { -1.0 };
            let [beyond, within] = [MARGIN, -MARGIN].map(|part| extreme * (1.0 + way * part));
            let ask = |limit: f64| judged(&body, &format!("expect {subject} {sign} {limit};"));
            let right = troubles(&ask(beyond));
            assert!(right.is_empty(), "{lengths:?} {subject} {sign} {beyond}: {right:?}");
            let wrong = troubles(&ask(within));
            let [RequirementTrouble::Fails(witness)] = &wrong[..] else {
                panic!("{lengths:?} {subject} {sign} {within}: {wrong:?}");
            };
            assert!(
                (witness.value - extreme).abs() < 1e-3 * extreme,
                "{lengths:?} {subject}: {witness:?}, {extreme}"
            );
        }
        let round = judged(&body, "expect turns(ja);");
        assert!(troubles(&round).is_empty(), "{lengths:?}");
    }
}

#[test]
fn a_motor_that_is_stopped_does_not_turn() {
    for seed in seeds(cases(8)) {
        let mut dice = Dice::new(seed);
        let [ground, crank, coupler, rocker] = crank_rocker(&mut dice);
        // The rocker drives.
        let lengths = [ground, rocker, coupler, crank];
        let cos = |reach: f64| {
            (ground * ground + rocker * rocker - reach * reach) / (2.0 * ground * rocker)
        };
        let ends = [coupler + crank, (coupler - crank).abs()].map(|reach| cos(reach).acos());
        let body = four_bar(lengths, f64::midpoint(ends[0], ends[1]).to_degrees());
        let found = troubles(&judged(&body, "expect turns(ja);"));
        let [RequirementTrouble::Stops { limit, .. }] = &found[..] else {
            panic!("{lengths:?}: {found:?}");
        };
        let off = ends.map(|end| (limit - end).abs());
        assert!(off[0].min(off[1]) < 1e-6, "{lengths:?}: {limit} is not at {ends:?}");
    }
}

/// A parallelogram, whose loop goes over to its other side where its links lie in one line.
#[test]
fn a_limit_that_is_told_is_kept_on_all_sides_of_loops() {
    let text = "struct Parallelogram;
        link l1; link l2; link l3; link l4;
        joint j0 = revolute(ground, l1) at (-2.886503056529637, 3.5399609318324092);
        joint j1 = revolute(ground, l2) at (-4.398919833166824, -1.3685165624476783);
        joint j2 = gear(l1, l2, 60 : 60);
        joint j3 = revolute(l2, l3) at (-0.22152134071994922, 0.6405988847252608);
        joint j4 = revolute(l3, l4) at (2.0480426467637782, 5.318407584837712);
        joint j5 = revolute(l4, ground) at (-2.1293558456830963, 3.309292137664773);
        motor j0;";
    let body: TokenStream = text.parse().expect("tokens");
    let expect = "expect angle(l4, l3) <= 132 deg for j0 in -2.8 ..= 2.8;";
    let found = troubles(&judged(&body, expect));
    let [RequirementTrouble::Fails(witness)] = &found[..] else {
        panic!("{found:?}");
    };
    let model = analyse(body).parsed.model;
    let compiled = compile(&model).expect("it moves");
    let end = sweep::at(&compiled.program, &[2.8]).expect("it comes there");
    let links = ["l4", "l3"].map(|name| {
        let mut links = model.declared_links();
        let link = links.find(|link| model.link(*link).name == name);
        link.expect("it is there")
    });
    let angle = Subject::AngleBetween(links).of(&model, &end.position().poses, Some(2.8));
    assert!(witness.proved.is_none_or(|proved| proved > angle - 1e-9), "{witness:?}, {angle}");
}

/// Texts beside which it stands what is proved of them: cases, and machines of others with what is known of these.
#[test]
fn texts_are_judged_as_it_stands_beside_them() {
    let machines = folder("../tests/subjects/machines");
    for case in folder("required").into_iter().chain(machines) {
        let body: TokenStream = case.text.parse().expect("tokens");
        for line in case.marks("holds") {
            let found = troubles(&judged(&body, &format!("expect {line};")));
            assert!(found.is_empty(), "{}: {line}: {found:?}", case.name);
        }
        for line in case.marks("open") {
            let found = troubles(&judged(&body, &format!("expect {line};")));
            let is_open = matches!(found[..], [RequirementTrouble::NoRange { .. }]);
            assert!(is_open, "{}: {line}: {found:?}", case.name);
        }
        for line in case.marks("unproved") {
            let found = troubles(&judged(&body, &format!("expect {line};")));
            assert!(!found.is_empty(), "{}: {line}", case.name);
        }
        for line in case.marks("fails") {
            let found = troubles(&judged(&body, &format!("expect {line};")));
            let is_refused = matches!(
                found[..],
                [RequirementTrouble::Fails(_) | RequirementTrouble::Stops { .. }]
            );
            assert!(is_refused, "{}: {line}: {found:?}", case.name);
        }
    }
}
