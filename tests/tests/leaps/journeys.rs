//! Random journeys of symmetrical, fast and overconstrained mechanisms, shuffled, driven anywhere: the judge has the last word.

use mech_tests::journeys::{Family, Fault, Kind, tally};
use mech_tests::{cases, seeds};

/// So many mechanisms of each family. Stops that come early are allowed once in a thousand moves; what the judge does not know is nothing.
#[track_caller]
fn clean(kind: Kind, single: bool, usual: u64) {
    for family in Family::ALL {
        let found = tally(kind, &family, seeds(cases(usual)), single, 1);
        let early = found
            .faults
            .get(&Fault::StopsEarly)
            .map_or(0, |count| count[0]);
        let wrong = found
            .faults
            .keys()
            .any(|fault| !matches!(fault, Fault::StopsEarly | Fault::Unknown));
        assert!(
            !wrong && 1000 * early <= found.moves,
            "{family:?}: {found:#?}"
        );
        println!(
            "{family:?}: {} mechanisms, {} moves, {early} stop early",
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
