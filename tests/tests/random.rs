//! Random mechanisms whose truth is known by construction.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::Model;
use mech_compiler::structure::Diagnosis;
use mech_compiler::{compile, reporter};
use mech_test_support::{
    Sample, apart, for_all, in_own_frames, model, reach, samples, size, text, with_ground,
    worst_gap, worst_stretch,
};

/// How many mechanisms a test tries.
const CASES: u64 = 100;

/// Every joint is closed as it is declared.
fn is_closed(model: &Model, poses: &[[f64; 4]]) {
    let reach = reach(poses).max(size(model));
    let gap = worst_gap(model, poses);
    assert!(gap < 1e-13 * reach, "gap {gap:e} at reach {reach}");
}

fn messages(diagnoses: &[Diagnosis], model: &Model) -> String {
    let texts = diagnoses.iter().map(|diagnosis| reporter::text(diagnosis, model));
    texts.collect::<Vec<_>>().join("; ")
}

/// It is understood, starts as it was drawn, and moves and closes or stays where it was.
#[test]
fn what_is_coherent_by_construction_compiles_and_moves() {
    for_all(CASES, &samples(1..=8), |Sample { grown, mut dice }| {
        let model = &grown.model;
        let compiled = compile(model).unwrap_or_else(|wrong| panic!("{}", messages(&wrong, model)));
        let structure = &compiled.structure;
        assert_eq!(compiled.plan.loops().count(), grown.loops, "loops");
        assert_eq!(structure.rollings.len(), grown.gears, "gears");
        assert_eq!(structure.arms.len(), grown.arms, "arms");
        let motors = model.motors.len();
        assert_eq!(usize::try_from(structure.mobility), Ok(motors), "mobility");
        for pose in &compiled.program.start.poses {
            assert!(apart(&[*pose], &[[1.0, 0.0, 0.0, 0.0]]) < 1e-9, "{pose:?}");
        }
        let mut machine = Machine::<f64>::new(&compiled.program);
        let nudge: Vec<f64> = model.motors.iter().map(|_| 1e-6).collect();
        assert_eq!(
            machine.move_to(&nudge),
            Ok(()),
            "away from dead points a small motion is possible"
        );
        for _ in 0..20 {
            let before = machine.position().clone();
            let motors: Vec<f64> =
                before.motors.iter().map(|motor| motor + dice.between(-0.3, 0.4)).collect();
            if machine.move_to(&motors).is_err() {
                assert_eq!(machine.position(), &before, "a failed move changes nothing");
                continue;
            }
            let poses = with_ground(model, &machine.position().poses);
            is_closed(model, &poses);
            assert!(worst_stretch(&poses) < 1e-14, "a link is stretched");
        }
    });
}

/// A failure is shown as text.
#[test]
fn its_text_declares_it() {
    for_all(50, &samples(1..=8), |Sample { grown, .. }| {
        let model = model(&text(&grown.model));
        let compiled =
            compile(&model).unwrap_or_else(|wrong| panic!("{}", messages(&wrong, &model)));
        assert_eq!(compiled.plan.loops().count(), grown.loops);
        assert_eq!(compiled.structure.arms.len(), grown.arms);
    });
}

#[test]
fn in_own_frames_it_has_the_same_assembly() {
    for_all(CASES, &samples(1..=8), |Sample { grown, mut dice }| {
        let (model, poses) = in_own_frames(&grown.model, &mut dice);
        let compiled =
            compile(&model).unwrap_or_else(|wrong| panic!("{}", messages(&wrong, &model)));
        let start = with_ground(&model, &compiled.program.start.poses);
        let declared = 1 + model.declared_links().count();
        for (link, (is, should)) in start.iter().zip(&poses).enumerate().take(declared) {
            assert!(apart(&[*is], &[*should]) < 1e-8, "link {link}: {is:?} instead of {should:?}");
        }
        is_closed(&model, &start);
    });
}
