//! Which solver is chosen.

use crate::evaluate::Machine;
use crate::model::{Model, Precision, Target};
use crate::program::{BlockKind, Program, Rounds};
use crate::structure::Diagnosis;
use crate::syntax::parse;
use crate::{Compiled, compile};

const FOUR_BAR: &str = "struct FourBar;
    link crank; link coupler; link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a by 1 deg;";

/// Stephenson's third six-bar, driven from its far side: two rings that wait for each other.
const COUPLED: &str = "struct SixBar;
    link crank; link coupler; link rocker; link rod; link driver;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.7, 1.2);
    joint c = revolute(coupler, rocker) at (3.6, 2.4);
    joint d = revolute(ground, rocker) at (4, 0);
    joint e = revolute(coupler, rod) at (2.2, 3.6);
    joint f = revolute(rod, driver) at (5.6, 4.6);
    joint g = revolute(ground, driver) at (6.4, 1.6);
    motor g;
    allow coupled;";

/// The same with a short crank, which turns all the way round.
fn cranked() -> String {
    COUPLED.replace("(5.6, 4.6)", "(6.44, 1.68)").replace("motor g;", "motor g by 1 deg;")
}

/// Gears tie two of the unknown directions of a five-bar.
const TIED: &str = "struct TiedFiveBar;
    link left; link right; link rod; link arm;
    joint a = revolute(ground, left) at (0, 0);
    joint b = revolute(left, rod) at (0, 1);
    joint c = revolute(rod, arm) at (2, 3);
    joint d = revolute(arm, right) at (4, 1.2);
    joint e = revolute(ground, right) at (4, 0);
    joint mesh = gear(left, right, -30 : 20);
    motor c;";

fn model(text: &str, accuracy: f64) -> Model {
    let parsed = parse(text.parse().expect("tokens"));
    assert_eq!(parsed.errors.len(), 0);
    Model { accuracy: Some(accuracy), ..parsed.model }
}

fn accepted(model: &Model) -> Compiled {
    let compiled = compile(model).expect("it is accurate enough");
    let error = compiled.prediction.as_ref().expect("a prediction").error;
    assert!(Some(error) <= model.accuracy);
    compiled
}

fn rounds(program: &Program) -> Option<Rounds> {
    program.ssa.blocks.iter().find_map(|block| match &block.kind {
        BlockKind::Newton(newton) => Some(newton.rounds),
        BlockKind::Straight | BlockKind::ClosedForm(_) => None,
    })
}

#[test]
fn a_dyad_is_solved_exactly() {
    for accuracy in [1e-1, 1e-6, 1e-12] {
        let compiled = accepted(&model(FOUR_BAR, accuracy));
        assert!(compiled.program.is_closed(), "{accuracy:e}");
        assert_eq!(compiled.loops[0].method, "exact");
        assert_eq!(compiled.loops[0].error, None);
        // Exact to rounding: it does not depend on what was asked for.
        assert!(compiled.prediction.expect("a prediction").error < 1e-13);
    }
}

#[test]
fn without_a_step_nobody_knows_how_far_it_goes() {
    for text in [COUPLED, TIED] {
        let compiled = accepted(&model(text, 1e-1));
        let rounds = rounds(&compiled.program);
        assert!(matches!(rounds, Some(Rounds::UntilClosed(_))), "{rounds:?}");
        assert_eq!(compiled.loops[0].error, None);
    }
}

#[test]
fn more_accuracy_takes_more_rounds() {
    let mut model = model(&cranked(), 1.0);
    let mut taken = Vec::new();
    for accuracy in [1.0, 1e-2, 1e-4, 1e-7, 1e-10, 2e-12] {
        model.accuracy = Some(accuracy);
        let compiled = accepted(&model);
        let rounds = match rounds(&compiled.program) {
            Some(Rounds::Exactly(rounds)) => rounds,
            _ => u32::MAX,
        };
        taken.push(rounds);
    }
    assert!(taken.is_sorted(), "{taken:?}");
    assert_eq!(taken[0], 1);
    taken.dedup();
    assert!(taken.len() > 2, "{taken:?}");
}

#[test]
fn in_single_precision_it_is_less_exact() {
    let mut model = model(FOUR_BAR, 1e-12);
    model.precision = Precision::F32;
    let Err(diagnoses) = compile(&model) else {
        panic!("single precision has not that many digits");
    };
    let [Diagnosis::TooAccurate { accuracy, best }] = diagnoses[..] else {
        panic!("{diagnoses:?}");
    };
    assert_eq!(accuracy, 1e-12);
    assert!((1e-7..1e-4).contains(&best), "{best:e}");
    model.accuracy = Some(best);
    accepted(&model);
    model.accuracy = Some(0.99 * best);
    assert!(compile(&model).is_err());
}

#[test]
fn the_target_weighs() {
    for target in [Target::X86_64, Target::CortexM4f] {
        let mut model = model(&cranked(), 1e-3);
        model.target = target;
        accepted(&model);
    }
}

/// A wheel that a motor turns by a part of its turns.
const GEARED: &str = "struct Geared: f32;
    ground { point a = (0, 0); point d = (57, 0); }
    link pinion { point a = (0, 0); }
    link wheel { point d = (0, 0); point tip = (10, 0); }
    joint a = revolute(ground.a, pinion.a);
    joint d = revolute(ground.d, wheel.d);
    joint mesh = gear(pinion, wheel, 20 : 37);
    motor a;";

#[test]
fn an_accuracy_holds_after_any_number_of_turns() {
    for (ratio, part) in [("20 : 37", 20.0 / 37.0), ("37 : 20", 37.0 / 20.0), ("30 : 10", 3.0)] {
        let text = GEARED.replace("20 : 37", ratio);
        let mut model = model(&text, 3e-4);
        model.precision = Precision::F32;
        let program = accepted(&model).program;
        let mut machine = Machine::<f32>::new(&program);
        for power in 0_i32..72 {
            let motor = 1.37_f32.powi(power);
            for motor in [motor, -motor] {
                machine.move_to(&[motor]).expect("it turns");
                let (sin, cos) = (-part * f64::from(motor)).sin_cos();
                let [is_cos, is_sin, ..] = machine.position().poses[1].map(f64::from);
                let off = 10.0 * (is_cos - cos).hypot(is_sin - sin);
                assert!(off <= 2e-5, "{ratio} at {motor}: {off:e}");
            }
        }
    }
}

/// A rack goes as far as its pinion turns, and rounding errors with it.
const RACK: &str = "struct Rack: f32;
    link pinion; link bar;
    joint a = revolute(ground, pinion) at (0, 0);
    joint s = prismatic(ground, bar) at (0, -1) along (1, 0);
    joint mesh = rack(pinion, bar, radius 1);
    motor a;";

#[test]
fn where_errors_grow_with_turns_a_range_is_demanded() {
    let mut endless = model(RACK, 1e-3);
    endless.precision = Precision::F32;
    let Err(diagnoses) = compile(&endless) else {
        panic!("it goes anywhere");
    };
    assert!(matches!(diagnoses[..], [Diagnosis::EndlessAccuracy { .. }]), "{diagnoses:?}");
    for (range, fits) in [("in -3 * PI ..= 3 * PI", true), ("in -9e4 * PI ..= 9e4 * PI", false)] {
        let text = RACK.replace("motor a;", &format!("motor a {range};"));
        let mut ranged = model(&text, 1e-3);
        ranged.precision = Precision::F32;
        assert_eq!(compile(&ranged).is_ok(), fits, "{range}");
    }
}

#[test]
fn a_motion_that_is_shorter_than_a_step_has_errors_too() {
    // The driver of this one only rocks.
    let text = COUPLED.replace("motor g;", "motor g by 300 deg; method newton(1);");
    let parsed = parse(text.parse().expect("tokens"));
    assert_eq!(parsed.errors.len(), 0);
    let compiled = compile(&parsed.model).expect("it moves");
    let predicted = compiled.prediction.as_ref().map(|prediction| prediction.error);
    let predicted = predicted.expect("its step is known");
    let exact = Model { method: None, ..parsed.model.clone() };
    let exact = compile(&exact).expect("it moves").program;
    let mut reference = Machine::<f64>::new(&exact);
    let mut ends = [4.0, -4.0].map(|far| {
        reference.put_back(Machine::new(&exact).position().clone());
        let far = reference.position().motors[0] + far;
        reference.move_toward(&[far]).expect("a number");
        reference.position().motors[0]
    });
    ends.sort_by(f64::total_cmp);
    assert!(ends[1] - ends[0] < 300_f64.to_radians(), "{ends:?}");
    let mut machine = Machine::<f64>::new(&compiled.program);
    let mut measured = 0.0_f64;
    for part in [0.3, 0.7, 0.2, 0.8, 0.5] {
        let motor = ends[0] + part * (ends[1] - ends[0]);
        if reference.move_to(&[motor]).is_err() || machine.move_to(&[motor]).is_err() {
            measured = f64::INFINITY;
            break;
        }
        let poses = machine.position().poses.iter().flatten();
        for (is, should) in poses.zip(reference.position().poses.iter().flatten()) {
            measured = measured.max((is - should).abs());
        }
    }
    assert!(measured > 1e-9, "{measured:e}");
    assert!(predicted >= measured, "{predicted:e} predicted, {measured:e} measured");
}
