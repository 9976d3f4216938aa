//! Random journeys of symmetrical, fast and overconstrained mechanisms, shuffled, driven anywhere: the judge has the last word.

use mech_test_support::journeys::{Family, Fault, Kind, tally};
use mech_test_support::{cases, seeds};

/// So many mechanisms of each family. Once in a thousand moves a stop may come early. In single precision positions beside change points may be off by more
/// than the judge takes for rounding, as long as they are not elsewhere. What the judge does not know is nothing.
#[track_caller]
fn clean(kind: Kind, single: bool, usual: u64) {
    for family in Family::ALL {
        let found = tally(kind, &family, seeds(cases(usual)), single, 1);
        let count = |fault: &Fault| found.faults.get(fault).map_or(0, |count| count[0]);
        let early = count(&Fault::StopsEarly);
        let off = |fault: &Fault| single && *fault == Fault::Off;
        let known =
            |fault: &&Fault| !matches!(fault, Fault::StopsEarly | Fault::Unknown) && !off(fault);
        let wrong: usize = found.faults.keys().filter(known).map(count).sum();
        assert!(
            wrong == 0 && 1000 * early <= found.moves,
            "{family:?}: {found:#?}"
        );
        println!(
            "{family:?}: {} mechanisms, {} moves, {wrong} astray, {early} stop early",
            found.mechanisms, found.moves
        );
    }
}

#[test]
fn small_steps_never_jump() {
    clean(Kind::Steps, false, 4);
}

#[test]
fn small_steps_in_single_precision_never_jump() {
    clean(Kind::Steps, true, 4);
}

#[test]
fn leaps_end_where_the_judge_does() {
    clean(Kind::Leaps, false, 12);
}

#[test]
fn leaps_in_single_precision_end_where_the_judge_does() {
    clean(Kind::Leaps, true, 12);
}

#[test]
fn stops_at_change_points_change_nothing() {
    clean(Kind::Stops, false, 12);
}

#[test]
fn stops_in_single_precision_change_nothing() {
    clean(Kind::Stops, true, 12);
}

/// What jumped, leapt past its stop or lost turns once, in all kinds of journeys.
#[test]
fn what_went_astray_once_does_so_no_more() {
    let texts = [
        include_str!("texts/rhombus-between-links.txt"),
        include_str!("texts/isosceles-by-its-rod.txt"),
        include_str!("texts/kite-at-its-tip.txt"),
        include_str!("texts/isosceles-by-its-slide.txt"),
        include_str!("texts/pivot-passes-the-slide.txt"),
        include_str!("texts/kite-with-a-dyad.txt"),
        include_str!("texts/count-behind-slots.txt"),
        include_str!("texts/past-the-stop.txt"),
        include_str!("texts/parallelogram-behind-gears.txt"),
        include_str!("texts/nearly-rhombic-cranks.txt"),
        include_str!("texts/parallelogram-behind-a-rocker.txt"),
    ];
    for text in texts {
        let family = Family::Text(text.to_owned());
        let single = text.contains(": f32;");
        // Small steps are the same for any seed.
        for (kind, seeds) in [
            (Kind::Steps, 0..1),
            (Kind::Leaps, 0..3),
            (Kind::Stops, 0..3),
        ] {
            let found = tally(kind, &family, seeds, single, 1);
            assert!(found.faults.is_empty(), "{kind:?} of {text}: {found:#?}");
        }
    }
}

/// What stopped at a dead point goes back the way it came, on its side, also behind loops that are iterated.
#[test]
fn from_a_dead_point_it_goes_back() {
    let texts = [
        include_str!("texts/back-from-a-dead-point.txt"),
        include_str!("texts/coupled-back-from-a-dead-point.txt"),
    ];
    for text in texts {
        let family = Family::Text(text.to_owned());
        for kind in [Kind::Leaps, Kind::Stops] {
            let found = tally(kind, &family, 0..10, false, 1);
            assert!(found.faults.is_empty(), "{kind:?} of {text}: {found:#?}");
        }
    }
}

/// Steps of 1e-5 and 1e-3 over change points of which rounding may hide on which side of them a loop stands, and a stop at a dead point
/// beside directions that are used reversed, too: there the loop was taken for thirty times as large as it is. From dead points they go back.
#[test]
fn single_precision_passes_change_points_in_small_steps_and_no_dead_point() {
    for seed in [810_116, 201_245, 201_317, 7_102, 7_193, 7_348] {
        let found = tally(Kind::Stops, &Family::Symmetric, seed..seed + 1, true, 1);
        assert!(found.faults.is_empty() && found.moves > 20, "{found:#?}");
    }
}
