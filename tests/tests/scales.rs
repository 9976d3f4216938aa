//! Mechanisms of any size: the same in another unit, or refused with a message that says why.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{Model, Precision};
use mech_compiler::structure::Diagnosis;
use mech_runtime::Real;
use mech_test_support::model;

/// A mechanism as a function of its unit, and whether its motor turns.
type Kind = (fn(&str) -> String, bool);

const KINDS: [Kind; 4] = [(four_bar, true), (slider_crank, true), (ram, false), (six_bar, true)];

fn four_bar(unit: &str) -> String {
    format!(
        "struct FourBar; const U = {unit};
        ground {{ point a = (0, 0); point d = (4 * U, 0); }}
        link crank {{ point a = (0, 0); point b = (U, 0); }}
        link coupler {{ point b = (0, 0); point c = (3.5 * U, 0); }}
        link rocker {{ point d = (0, 0); point c = (3 * U, 0); }}
        joint ja = revolute(ground.a, crank.a); joint jb = revolute(crank.b, coupler.b);
        joint jc = revolute(coupler.c, rocker.c); joint jd = revolute(ground.d, rocker.d);
        motor ja; start {{ coupler near 50 deg; }}"
    )
}

fn slider_crank(unit: &str) -> String {
    format!(
        "struct Slider; const U = {unit};
        ground {{ point o = (0, 0); line rail = (0, 0.2 * U) -> (1, 0); }}
        link crank {{ point o = (0, 0); point p = (U, 0); }}
        link rod {{ point p = (0, 0); point q = (3 * U, 0); }}
        link piston {{ point q = (0, 0); line rail = (0, 0) -> (1, 0); }}
        joint a = revolute(ground.o, crank.o); joint b = revolute(crank.p, rod.p);
        joint c = revolute(rod.q, piston.q); joint s = prismatic(ground.rail, piston.rail);
        motor a; start {{ rod near 0; }}"
    )
}

fn ram(unit: &str) -> String {
    format!(
        "struct Ram; const U = {unit};
        ground {{ point a = (0, 0); point d = (2 * U, 0); }}
        link barrel {{ point a = (0, 0); line displacement = (0, 0) -> (1, 0); }}
        link rod {{ line displacement = (0, 0) -> (1, 0); point c = (0, 0); }}
        link boom {{ point d = (0, 0); point c = (1.2 * U, 0); }}
        joint a = revolute(ground.a, barrel.a); joint s = prismatic(barrel.displacement, rod.displacement);
        joint c = revolute(rod.c, boom.c); joint d = revolute(ground.d, boom.d);
        motor s; start {{ s = 2 * U; barrel near 30 deg; }}"
    )
}

fn six_bar(unit: &str) -> String {
    format!(
        "struct SixBar; const U = {unit};
        link crank; link coupler; link rocker; link rod; link driver;
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, coupler) at (0.7 * U, 1.2 * U);
        joint c = revolute(coupler, rocker) at (3.6 * U, 2.4 * U);
        joint d = revolute(ground, rocker) at (4 * U, 0);
        joint e = revolute(coupler, rod) at (2.2 * U, 3.6 * U);
        joint f = revolute(rod, driver) at (6.44 * U, 1.68 * U);
        joint g = revolute(ground, driver) at (6.4 * U, 1.6 * U);
        motor g; allow coupled;"
    )
}

/// Where the links are after some ways of the motor.
fn places<T: Real>(model: &Model, displacements: &[f64]) -> Result<Vec<[f64; 4]>, Vec<Diagnosis>> {
    let compiled = compile(model)?;
    let mut machine = Machine::<T>::new(&compiled.program);
    let mut found = Vec::new();
    for displacement in displacements {
        let to = compiled.program.start.motors[0] + displacement;
        machine
            .move_to(&[T::from_f64(to)])
            .unwrap_or_else(|stop| panic!("{}: {stop:?}", model.name));
        let poses = machine.position().poses.iter();
        found.extend(poses.map(|pose| pose.map(Real::to_f64)));
    }
    Ok(found)
}

fn check<T: Real>((kind, turns): (fn(&str) -> String, bool), exponent: i32, precision: Precision) {
    let displacements = |unit: f64| {
        [0.1, 0.3, -0.2].map(|displacement| if turns { displacement } else { displacement * unit })
    };
    let whole = model(&kind("1"));
    let expected = places::<f64>(&whole, &displacements(1.0)).expect("it moves");
    let unit: f64 = format!("1e{exponent}").parse().expect("a number");
    let model = Model { precision, ..model(&kind(&format!("{unit:e}"))) };
    let what = format!("{} {precision:?} of 1e{exponent}", model.name);
    let [least, most] = precision.lengths();
    match places::<T>(&model, &displacements(unit)) {
        Err(wrong) => match wrong[..] {
            [Diagnosis::TooLarge] => assert!(10.0 * unit > most, "{what}"),
            [Diagnosis::TooSmall] => assert!(unit < least, "{what}"),
            _ => panic!("{what}: {wrong:?}"),
        },
        Ok(found) => {
            for (found, expected) in found.iter().zip(&expected) {
                for part in 0..4 {
                    let scale = if part < 2 { 1.0 } else { unit };
                    let off = (found[part] / scale - expected[part]).abs();
                    assert!(off < 2e4 * precision.epsilon(), "{what}: {off:e}");
                }
            }
        }
    }
}

#[test]
fn mechanisms_of_any_size_move_or_are_refused() {
    for kind in KINDS {
        for step in -80..=76 {
            check::<f64>(kind, 4 * step, Precision::F64);
        }
        for exponent in (-46..=39).chain([-300, -100, 100, 300]) {
            check::<f32>(kind, exponent, Precision::F32);
        }
    }
}
