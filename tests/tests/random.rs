//! Random mechanisms whose truth is known by construction.

use mech_compiler::evaluate::Machine;
use mech_compiler::structure::Diagnosis;
use mech_compiler::{compile, reporter};
use mech_tests::{Dice, Grown, grow, in_own_frames, size, with_ground, worst_gap, worst_stretch};

/// How many mechanisms a test tries.
fn cases() -> u64 {
    mech_tests::cases(2_000)
}

fn grown(seed: u64) -> (Dice, Grown) {
    let mut dice = Dice::new(seed);
    let additions = 1 + dice.below(8);
    let grown = grow(&mut dice, additions);
    (dice, grown)
}

fn told(
    diagnoses: &[mech_compiler::structure::Diagnosis],
    model: &mech_compiler::model::Model,
) -> String {
    diagnoses
        .iter()
        .map(|diagnosis| reporter::text(diagnosis, model))
        .collect::<Vec<_>>()
        .join("; ")
}

#[test]
fn what_is_coherent_by_construction_is_accepted_and_understood() {
    for seed in mech_tests::seeds(cases()) {
        let (_, grown) = grown(seed);
        let compiled = compile(&grown.model)
            .unwrap_or_else(|wrong| panic!("seed {seed}: {}", told(&wrong, &grown.model)));
        assert_eq!(
            compiled.plan.loops().count(),
            grown.loops,
            "loops, seed {seed}"
        );
        assert_eq!(
            compiled.structure.rollings.len(),
            grown.gears,
            "gears, seed {seed}"
        );
        assert_eq!(
            compiled.structure.arms.len(),
            grown.arms,
            "arms, seed {seed}"
        );
        assert_eq!(
            usize::try_from(compiled.structure.mobility),
            Ok(grown.model.motors.len()),
            "mobility, seed {seed}"
        );
    }
}

#[test]
fn it_starts_as_it_was_drawn() {
    for seed in mech_tests::seeds(cases()) {
        let (_, grown) = grown(seed);
        let compiled = compile(&grown.model).expect("coherent");
        for pose in &compiled.program.start.poses {
            let off = pose
                .iter()
                .zip([1.0, 0.0, 0.0, 0.0])
                .map(|(is, should)| (is - should).abs())
                .fold(0.0, f64::max);
            assert!(off < 1e-9, "seed {seed}: {pose:?}");
        }
    }
}

#[test]
fn in_own_frames_it_is_assembled_the_same_way() {
    let mut others = 0;
    for seed in mech_tests::seeds(cases()) {
        let (mut dice, grown) = grown(seed);
        let (model, poses) = in_own_frames(&grown.model, &mut dice);
        let compiled = match compile(&model) {
            Ok(compiled) => compiled,
            // Of several joints that one wheel could be said to move, only one is free to start anywhere: not always the one
            // that was grown with it.
            Err(wrong) if matches!(wrong[..], [Diagnosis::StartNotFree { .. }]) => {
                others += 1;
                continue;
            }
            Err(wrong) => panic!("seed {seed}: {}", told(&wrong, &model)),
        };
        let start = with_ground(&model, &compiled.program.start.poses);
        let declared = 1 + model.declared_links().count();
        for (link, (is, should)) in start.iter().zip(&poses).enumerate().take(declared) {
            let off = is
                .iter()
                .zip(should)
                .map(|(is, should)| (is - should).abs())
                .fold(0.0, f64::max);
            assert!(
                off < 1e-8,
                "seed {seed}, link {link}: {is:?} instead of {should:?}"
            );
        }
    }
    assert!(1_000 * others <= cases(), "{others} of {}", cases());
}

#[test]
fn it_moves_and_closes_or_stays_where_it_was() {
    for seed in mech_tests::seeds(cases()) {
        let (mut dice, grown) = grown(seed);
        let compiled = compile(&grown.model).expect("coherent");
        let mut machine = Machine::<f64>::new(&compiled.program);
        let nudge: Vec<f64> = grown.model.motors.iter().map(|_| 1e-6).collect();
        assert_eq!(
            machine.move_to(&nudge),
            Ok(()),
            "seed {seed}: away from dead points a small motion is possible"
        );
        for _ in 0..20 {
            let before = machine.position().clone();
            let motors: Vec<f64> = before
                .motors
                .iter()
                .map(|motor| motor + dice.between(-0.3, 0.4))
                .collect();
            if machine.move_to(&motors).is_err() {
                assert_eq!(
                    machine.position(),
                    &before,
                    "seed {seed}: a failed move changes nothing"
                );
                continue;
            }
            let poses = with_ground(&grown.model, &machine.position().poses);
            let reach = poses
                .iter()
                .map(|pose| pose[2].hypot(pose[3]))
                .fold(size(&grown.model), f64::max);
            let gap = worst_gap(&grown.model, &poses);
            assert!(
                gap < 1e-13 * reach,
                "seed {seed}: gap {gap:e} at reach {reach}"
            );
            assert!(
                worst_stretch(&poses) < 1e-14,
                "seed {seed}: a link is stretched"
            );
        }
    }
}
