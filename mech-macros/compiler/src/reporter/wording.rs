//! Lists and numbers, as a reader wants them.

use crate::digits::round_to;

/// An enumeration. Of very many, the last are only counted.
pub(super) fn and(names: &[String]) -> String {
    const MOST: usize = 40;
    const SHOWN: usize = 30;
    if names.len() > MOST {
        let others = names.len() - SHOWN;
        return format!("{} and {others} others", names[..SHOWN].join(", "));
    }
    names.join(", ")
}

/// Alternatives: `a`, `b` or `c`. Of many, the last are only counted.
pub(super) fn one_of(names: &[String]) -> String {
    const MOST: usize = 10;
    const SHOWN: usize = 7;
    match names {
        many if many.len() > MOST => {
            let shown = many[..SHOWN].join(", ");
            format!("{shown} or one of {} others", many.len() - SHOWN)
        }
        [first @ .., last] if !first.is_empty() => format!("{} or {last}", first.join(", ")),
        names => names.concat(),
    }
}

/// After how many decimal places, in degrees, the assemblies can still be told apart.
pub(super) fn places_enough(links: usize, angles: &[Vec<f64>]) -> usize {
    const MOST: u8 = 4;
    let apart = |places: &u8| {
        let least = 4.0 * 0.1_f64.powi(i32::from(*places));
        (0..links).all(|link| {
            let angles: Vec<f64> = angles.iter().map(|angles| angles[link].to_degrees()).collect();
            let pairs = angles
                .iter()
                .enumerate()
                .flat_map(|(i, a)| angles[..i].iter().map(move |b| (a - b).abs()));
            let mut turns = pairs.map(|turn| turn.min(360.0 - turn));
            turns.all(|turn| turn < 1e-3 || turn > least)
        })
    };
    usize::from((0..MOST).find(apart).unwrap_or(MOST))
}

/// A number with as many digits as a reader wants.
pub(super) fn brief(value: f64) -> String {
    let rounded = round_to(value, 4);
    if value != 0.0 && (rounded == 0.0 || value.abs() >= 1e9) {
        format!("{value:.1e}")
    } else {
        format!("{rounded}")
    }
}
