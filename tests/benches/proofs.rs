//! How long a requirement takes to be proved or refused, by what it measures: of what stands in `tests/cases`, of the gallery, and of a
//! mechanism of ten loops. `cargo bench -p mech-tests --bench proofs --profile user` measures the compiler as users have it. A word after
//! `--` is looked for in what is measured.

use mech_compiler::model::Model;
use mech_compiler::requirement::{Proof, judge};
use mech_compiler::structure::{Diagnosis, RequirementTrouble};
use mech_compiler::{Compiled, analyse};
use mech_test_support::{GALLERY, bodies, folder, median, worked};
use proc_macro2::TokenStream;

/// What one requirement may take, in milliseconds.
const MOST: f64 = 100.0;

/// It is measured for so long, in milliseconds.
const LONG: f64 = 40.0;

/// What is measured, by words in it: the first that fits.
const KINDS: [(&str, &[&str]); 15] = [
    ("turns", &["turns("]),
    ("mean, rms", &["mean(", "rms("]),
    ("dwell, time ratio", &["dwell(", "time ratio("]),
    ("what the ground gets", &["reaction:ground", "shaking:"]),
    ("advantage, centre", &["advantage(", "centre("]),
    ("reaction", &["reaction:"]),
    ("torque, power", &["torque:", "power:"]),
    ("acceleration", &["acceleration:"]),
    ("velocity", &["velocity:"]),
    ("clear", &["clear("]),
    ("pressure, curvature", &["pressure(", "curvature("]),
    ("d", &["d("]),
    ("min, max, swing, stroke", &["min(", "max(", "swing(", "stroke("]),
    ("transmission", &["transmission"]),
    ("coordinates, places", &[""]),
];

/// What became of those that were not proved.
const REFUSED: &str = "refused";
const OPEN: &str = "left open";

/// The mechanism of ten loops.
const LARGE: &str = "ten_loops";

/// What is asked of the gallery.
const OF_GALLERY: [(&str, &[&str]); 6] = [
    (
        "andrews",
        &[
            "gamma in 0.2 ..= 0.6",
            "transmission > 20 deg",
            "distance(k3.d, ground.c) > 0.02",
            "abs(velocity:gamma) < 0.5",
            "acceleration:k3.d < 0.05",
        ],
    ),
    (
        "four_bar",
        &[
            "turns(a)",
            "swing(d) < 60 deg",
            "coupler.tip.y > 0",
            "distance(coupler.tip, ground.crank_shaft) < 5",
            "transmission > 30 deg",
            "velocity:coupler.tip < 2",
            "acceleration:d in -3 ..= 3",
        ],
    ),
    (
        "geared_piston",
        &[
            "turns(d)",
            "stroke(h) in 2 ..= 2",
            "rod in -15 deg ..= 15 deg",
            "velocity:h in -0.6 ..= 0.6",
            "mean(h) in 3 ..= 5",
        ],
    ),
    (
        "jansen",
        &[
            "lower_plate.foot.y > -93",
            "transmission > 20 deg",
            "stroke(lower_plate.foot.x) < 100",
            "dwell(lower_plate.foot.y, 4) > 90 deg",
            "velocity:lower_plate.foot < 54",
            "acceleration:lower_plate.foot < 240",
        ],
    ),
    (
        "rocker_arm",
        &[
            "transmission > 20 deg",
            "hand.grip.y > -4",
            "distance(hand.grip, ground.rocker_shaft) < 8",
            "d(hand.grip.x, wrist) < 1.4",
        ],
    ),
    (
        "watt",
        &[
            "turns(a)",
            "swing(g) < 120 deg",
            "transmission > 10 deg",
            "time ratio(g) < 3",
            "velocity:g in -3 ..= 3",
            "acceleration:g in -9 ..= 9",
        ],
    ),
];

/// A requirement, and how it was judged.
struct Judged {
    of: String,
    requirement: String,
    kind: &'static str,
    ms: f64,
    intervals: usize,
}

fn main() {
    let word = std::env::args().skip(1).find(|word| !word.starts_with("--"));
    let is_wanted =
        |subject: &(String, TokenStream)| word.as_ref().is_none_or(|word| subject.0.contains(word));
    let all = subjects().into_iter().filter(is_wanted);
    print(&all.flat_map(judged).collect::<Vec<_>>());
}

/// Mechanisms by their names, with what they expect.
fn subjects() -> Vec<(String, TokenStream)> {
    let folders = ["expected", "required", "../tests/subjects/machines"];
    let texts = folders.into_iter().flat_map(folder).map(|case| {
        let marks = ["holds", "fails", "open", "unproved"].into_iter();
        let marks = marks.flat_map(|mark| case.marks(mark));
        let asked = marks.map(|mark| mark.trim_start_matches("expect ").trim_end_matches(';'));
        let text = case.text.parse().expect("tokens");
        (case.name.clone(), with(text, asked))
    });
    let gallery = OF_GALLERY.into_iter().map(|(name, asked)| {
        let (_, source) = GALLERY.iter().find(|(other, _)| *other == name).expect("it is there");
        (name.to_owned(), with(bodies(source).remove(0), asked.iter().copied()))
    });
    texts.chain(gallery).collect()
}

/// A mechanism of which more is expected.
fn with<'a>(mut text: TokenStream, asked: impl Iterator<Item = &'a str>) -> TokenStream {
    let asked: String = asked.map(|one| format!("expect {one};")).collect();
    text.extend(asked.parse::<TokenStream>().expect("tokens"));
    text
}

/// Each requirement of a mechanism, judged alone.
fn judged((of, text): (String, TokenStream)) -> Vec<Judged> {
    let analysis = analyse(text);
    let compiled = match &analysis.result {
        Ok(compiled) => compiled,
        Err(faults) => panic!("{of}: {:?}", faults.messages),
    };
    let requirements = analysis.parsed.model.requirements.iter();
    let judged = requirements.map(|requirement| {
        let model =
            Model { requirements: vec![requirement.clone()], ..analysis.parsed.model.clone() };
        let (ms, verdict) = timed(&model, compiled);
        let written = &requirement.written;
        let (kind, intervals) = match verdict {
            Ok(Proof { effort }) => (kind(written), effort),
            Err(Diagnosis::Unmet {
                trouble: RequirementTrouble::Undecided { .. } | RequirementTrouble::TooHard,
                ..
            }) => (OPEN, 0),
            Err(_) => (REFUSED, 0),
        };
        Judged { of: of.clone(), requirement: written.clone(), kind, ms, intervals }
    });
    judged.collect()
}

fn kind(written: &str) -> &'static str {
    let mut kinds = KINDS.iter();
    let found = kinds.find(|(_, words)| words.iter().any(|word| written.contains(word)));
    found.map_or("", |(kind, _)| kind)
}

/// The only requirement, judged as often as there is time for; with milliseconds of the processor.
fn timed(model: &Model, compiled: &Compiled) -> (f64, Result<Proof, Diagnosis>) {
    let (start, mut rounds) = (worked(), 0);
    loop {
        let verdict = judge(model, compiled).remove(0);
        rounds += 1;
        let taken = worked() - start;
        if taken > LONG {
            return (taken / f64::from(rounds), verdict);
        }
    }
}

/// A table, and all that take too long.
fn print(all: &[Judged]) {
    println!(
        "| measured | requirements | ms, median | ms, most | intervals | which | of ten loops, ms |"
    );
    println!("|---|---|---|---|---|---|---|");
    let kinds = KINDS.map(|(kind, _)| kind).into_iter();
    for kind in kinds.chain([REFUSED, OPEN]) {
        let own = all.iter().filter(|one| one.kind == kind);
        let (large, own): (Vec<&Judged>, Vec<&Judged>) = own.partition(|one| one.of == LARGE);
        let slowest = |all: &[&Judged]| all.iter().map(|one| one.ms).fold(0.0, f64::max);
        let most = slowest(&own);
        let Some(worst) = own.iter().find(|one| one.ms == most) else {
            continue;
        };
        let Judged { of, requirement, intervals, .. } = worst;
        let of_large = large.first().map(|_| format!("{:.0}", slowest(&large)));
        println!(
            "| {kind} | {} | {:.1} | {most:.0} | {intervals} | `{requirement}` of `{of}` | {} |",
            own.len(),
            median(own.iter().map(|one| one.ms)),
            of_large.unwrap_or_default(),
        );
    }
    let mut slow: Vec<&Judged> = all.iter().filter(|one| one.ms > MOST).collect();
    slow.sort_by(|a, b| b.ms.total_cmp(&a.ms));
    println!("{} of {} take more than {MOST} ms:", slow.len(), all.len());
    for Judged { of, requirement, kind, ms, .. } in slow {
        println!("{ms:6.0} ms, {kind}: `{requirement}` of `{of}`");
    }
}
