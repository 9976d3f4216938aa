//! Wheels that roll on each other.

use super::Pick;
use super::attachment::{Builder, End};
use crate::edit::{Assembly, Command, JointForm, Pair};
use crate::editor::drawing::distance;

/// The fewest teeth of a wheel.
const TEETH: u32 = 20;
/// No ratio of two wheels has larger terms.
const MOST: u32 = 12;

/// Two wheels that mesh where it was picked.
pub(super) fn gear(builder: &mut Builder<'_>, picks: &[Pick]) -> Result<(), String> {
    let [first, second, touch] = picks else {
        return Err("pick two wheels, and where they touch".to_owned());
    };
    let [(a, center), (b, other)] = [builder.wheel_at(first)?, builder.wheel_at(second)?];
    let radii = [distance(center, touch.place), distance(other, touch.place)];
    let sizes = teeth(radii)?;
    join(
        builder,
        [End::Link(a), End::Link(b)],
        JointForm::Gear { sizes, on: None },
    )
}

/// A belt over two wheels of the same size.
pub(super) fn belt(builder: &mut Builder<'_>, picks: &[Pick]) -> Result<(), String> {
    let [first, second] = picks else {
        return Err("pick two wheels".to_owned());
    };
    let [(a, _), (b, _)] = [builder.wheel_at(first)?, builder.wheel_at(second)?];
    let sizes = [TEETH, TEETH].map(|teeth| teeth.to_string());
    join(
        builder,
        [End::Link(a), End::Link(b)],
        JointForm::Belt { sizes, on: None },
    )
}

fn join(builder: &mut Builder<'_>, ends: [End; 2], kind: JointForm) -> Result<(), String> {
    let name = builder.names().numbered("mesh");
    let ends = ends.map(|end| builder.name(&end));
    if ends[0] == ends[1] {
        return Err("both places are on the same wheel; pick another".to_owned());
    }
    builder.add(Command::Join(Assembly {
        name,
        kind,
        ends,
        at: None,
        along: None,
    }));
    Ok(())
}

/// Numbers of teeth whose ratio comes nearest to that of two radii.
fn teeth([first, second]: [f64; 2]) -> Result<Pair, String> {
    let wanted = first / second;
    if !(wanted.is_finite() && wanted > 0.0) {
        return Err("wheels touch between their centres; pick a place there".to_owned());
    }
    let mut best = [1, 1];
    let error = |[a, b]: [u32; 2]| (f64::from(a) / f64::from(b) / wanted).ln().abs();
    for a in 1..=MOST {
        for b in 1..=MOST {
            if error([a, b]) < error(best) - 1e-12 {
                best = [a, b];
            }
        }
    }
    let unit = TEETH.div_ceil(best[0].min(best[1]));
    Ok(best.map(|size| (unit * size).to_string()))
}
