//! The polygons of velocities and of accelerations.

use super::Place;
use super::mark::Mark;
use super::spot::{Pair, Spot, is_same};
use crate::quantity::{Position, Surveyed};
use mech_compiler::model::{LinkId, Rate};
use mech_core::colors::INK;
use mech_runtime::Palette;

/// The name of the place from which all vectors begin.
const POLE: &str = "pole";

/// The polygon where a mechanism is, its pole in the origin: an arrow to the end of each spot's vector, and the image of each link. None
/// where the rates are not determined.
///
/// Of accelerations, each image begins with what its link's turning makes of it: first along the line between two spots, then across it.
pub(super) fn polygon(survey: Surveyed<'_>, at: &Position, rate: Rate) -> Option<Vec<Mark>> {
    let Surveyed { model, compiled, .. } = survey;
    let mut ends: Vec<(Place, Vec<String>)> = vec![([0.0; 2], vec![POLE.to_owned()])];
    let mut marks = Vec::new();
    let links = [LinkId::GROUND].into_iter().chain(model.declared_links());
    for link in links {
        let spots = Spot::of(survey, at, link);
        let mut image = Vec::new();
        for spot in spots {
            let vector = at.vector(compiled, link, spot.at, rate)?;
            image.push((spot.at, vector));
            match ends.iter_mut().find(|(end, _)| is_same(*end, vector)) {
                Some((_, names)) => {
                    let new = spot.names.into_iter().filter(|name| !names.contains(name));
                    let new: Vec<String> = new.collect();
                    names.extend(new);
                }
                None => ends.push((vector, spot.names)),
            }
        }
        let mut line = |ends, color| marks.push(Mark::Line { ends, color });
        for pair in image.windows(2) {
            line([pair[0].1, pair[1].1], INK);
        }
        if let [first, _, .., last] = image[..]
            && image.len() > 2
        {
            line([last.1, first.1], INK);
        }
        if let ([(from, begin), others @ ..], Rate::Acceleration) = (&image[..], rate) {
            let [turning, ..] = at.rate(compiled, link, Rate::Velocity)?;
            for (to, end) in others {
                let corner =
                    [0, 1].map(|part| begin[part] - turning * turning * (to[part] - from[part]));
                line([*begin, corner], Palette::ORANGE);
                line([corner, *end], Palette::ORANGE);
            }
        }
    }
    // From the one link of a slide to the other.
    for joint in model.declared_joints() {
        if let Some(Pair { links, at: place, .. }) = Pair::of(survey, at, joint)
            && !links.contains(&LinkId::GROUND)
        {
            let [begin, end] = links.map(|link| at.vector(compiled, link, place, rate));
            marks.push(Mark::Line { ends: [begin?, end?], color: INK });
        }
    }
    let color = match rate {
        Rate::Acceleration => Palette::RED,
        Rate::Velocity => Palette::BLUE,
    };
    for (end, names) in ends {
        marks.push(Mark::Arrow { ends: [[0.0; 2], end], color });
        marks.push(Mark::Dot(end));
        marks.push(Mark::name(end, end, names.join(", ")));
    }
    Some(marks)
}
