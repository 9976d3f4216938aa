//! Journeys of random mechanisms, held against an independent judge: `journeys KIND COUNT SEED [f32] [FAMILY] [FILE.mech] [examples=N]`.

use mech_test_support::journeys::{Family, Fault, Kind, tally};
use std::time::Instant;

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let kind = match words.first().map(String::as_str) {
        Some("steps") => Kind::Steps,
        Some("leaps") => Kind::Leaps,
        Some("stops") => Kind::Stops,
        _ => panic!(
            "steps, leaps or stops; a count; a seed; f32; symmetric, rows, fast, generic, wild or coupled; examples=3"
        ),
    };
    let number = |place: usize, usual| {
        words.get(place).map_or(usual, |word| word.parse().expect("a number"))
    };
    let (count, seed) = (number(1, 100), number(2, 0));
    let has = |word: &str| words[1..].iter().any(|one| one.eq_ignore_ascii_case(word));
    let examples = words
        .iter()
        .find_map(|word| word.strip_prefix("examples="))
        .map_or(2, |number| number.parse().expect("a number"));
    let families: Vec<Family> =
        Family::ALL.into_iter().filter(|family| has(&format!("{family:.9?}"))).collect();
    let files = words[1..].iter().filter(|word| word.contains(".mech"));
    let texts = files.map(|path| Family::Text(std::fs::read_to_string(path).expect("a file")));
    let mut families: Vec<Family> = families.into_iter().chain(texts).collect();
    if families.is_empty() {
        families = Family::ALL.to_vec();
    }
    let faults = [
        Fault::Elsewhere,
        Fault::Off,
        Fault::Torn,
        Fault::Jumped,
        Fault::StopsEarly,
        Fault::Passes,
        Fault::Unknown,
    ];
    let mut shown = Vec::new();
    println!(
        "{:>10} {:>6} {:>7} {:>8} {:>6} | faults in moves/mechanisms: {faults:?}",
        "family", "mech.", "refused", "moves", "s"
    );
    for family in families {
        let begin = Instant::now();
        let found = tally(kind, &family, seed..seed + count, has("f32"), examples);
        let name =
            if let Family::Text(_) = family { "text".to_owned() } else { format!("{family:?}") };
        let seconds = begin.elapsed().as_secs_f64();
        print!(
            "{name:>10} {:>6} {:>7} {:>8} {seconds:>6.1} |",
            found.mechanisms, found.refused, found.moves
        );
        for fault in faults {
            let [moves, mechanisms] = found.faults.get(&fault).copied().unwrap_or_default();
            print!(" {:>12}", format!("{moves}/{mechanisms}"));
        }
        println!();
        for (why, count) in found.reasons {
            println!("{count:>20} times the judge gave up: {why}");
        }
        for (fault, all) in found.examples {
            shown.extend(all.into_iter().map(|text| format!("--- {fault:?} {text}")));
        }
    }
    for text in shown {
        println!("{text}");
    }
}
