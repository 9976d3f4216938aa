//! Random journeys of symmetrical, fast and overconstrained mechanisms, shuffled, driven anywhere: the judge has the last word.

use mech_test_support::journeys::{Family, Fault, Kind, tally};
use mech_test_support::{cases, seeds};

/// So many mechanisms of each family. Once in a thousand moves a stop may come early. In single precision positions beside change points may be off by more
/// than the judge takes for rounding, as long as they are not elsewhere. What the judge does not know is nothing. Loops that wait for each
/// other may stop a little before a change point to which a move goes, and in single precision earlier.
#[track_caller]
fn clean(kind: Kind, single: bool, usual: u64) {
    for family in Family::ALL {
        if family == Family::Coupled && (single || kind == Kind::Stops) {
            continue;
        }
        let found = tally(kind, &family, seeds(cases(usual)), single, 1);
        let count = |fault: &Fault| found.faults.get(fault).map_or(0, |count| count[0]);
        let early = count(&Fault::StopsEarly);
        let off = |fault: &Fault| single && *fault == Fault::Off;
        let known =
            |fault: &&Fault| !matches!(fault, Fault::StopsEarly | Fault::Unknown) && !off(fault);
        let wrong: usize = found.faults.keys().filter(known).map(count).sum();
        assert!(wrong == 0 && 1000 * early <= found.moves, "{family:?}: {found:#?}");
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

/// Steps of 1e-5 and 1e-3 over change points of which rounding may hide on which side of them a loop stands, and a stop at a dead point
/// beside directions that are used reversed, too: there the loop was taken for thirty times as large as it is. From dead points they go back.
#[test]
fn single_precision_passes_change_points_in_small_steps_and_no_dead_point() {
    for seed in [810_116, 201_245, 201_317, 7_102, 7_193, 7_348] {
        let found = tally(Kind::Stops, &Family::Symmetric, seed..seed + 1, true, 1);
        assert!(found.faults.is_empty() && found.moves > 20, "{found:#?}");
    }
}
