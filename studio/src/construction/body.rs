//! Free bodies: each link alone, with all that pushes it.

use super::Place;
use super::mark::Mark;
use super::panel::{Inset, usual};
use super::push::{Push, cam, pushes};
use super::spot::Spot;
use crate::failure::Failure;
use crate::quantity::{Position, Surveyed, four_digits, tick};
use mech_compiler::model::LinkId;
use mech_core::colors::INK;
use mech_runtime::Palette;

/// The parts of a field's side that the longest arrow has, and the distance of a spot from the middle of its link.
const ARROW: f64 = 0.22;
const REACH: f64 = 0.18;
/// A force or torque that is smaller than this part of the greatest is none.
const NONE: f64 = 1e-9;
/// A force whose part upwards is smaller than this part of it is level.
const LEVEL: f64 = 0.1;
/// Where the number of a torque begins, in pixels from its arrow's middle.
const BESIDE: Place = [16.0, -16.0];

/// The free bodies of all links that something pushes, each in all positions. Forces have one scale.
pub(super) fn bodies(
    survey: Surveyed<'_>,
    positions: &[Position],
    rests: bool,
) -> Result<Vec<Inset>, Failure> {
    if let Some(name) = cam(survey) {
        return Err(Failure::mechanism(format!(
            "free bodies do not show cams, as `{name}`; `mech table` measures `reaction:{name}`"
        )));
    }
    let pushed = positions.iter().map(|at| pushes(survey, at, rests));
    let pushed: Vec<Option<Vec<Push>>> = pushed.collect();
    if pushed.iter().all(Option::is_none) {
        return Err(Failure::mechanism(
            "forces are not determined here: it is at a dead point or a change point; put a motor elsewhere with `--at`",
        ));
    }
    let all = || pushed.iter().map(|pushes| pushes.as_deref().unwrap_or_default());
    let most = |size: fn(&Push) -> f64| {
        let greatest = |pushes: &[Push]| pushes.iter().map(size).fold(0.0, f64::max);
        usual(all().map(greatest))
    };
    let [force, torque] =
        [most(|push| push.force[0].hypot(push.force[1])), most(|push| push.torque.abs())];
    if force == 0.0 && torque == 0.0 {
        return Err(Failure::mechanism(
            "nothing pushes its links: give a load by `--load`, or declare `gravity` and masses, or springs",
        ));
    }
    let links: Vec<LinkId> = survey.model.declared_links().collect();
    let positions = || positions.iter().zip(all());
    let reach = usual(positions().map(|(at, pushes)| {
        let far = links.iter().map(|&link| {
            let own = pushes.iter().filter(|push| push.link == link);
            let places = own.filter_map(|push| push.at);
            Outline::of(survey, at, link).reach(places)
        });
        far.fold(0.0, f64::max)
    }));
    let reach = if reach > 0.0 { reach } else { 1.0 };
    let scale = Scale {
        length: REACH / reach,
        force: ARROW / if force > 0.0 { force } else { 1.0 },
        least: NONE * force.max(torque / reach),
        reach,
    };
    let is_pushed = |link: &LinkId| {
        let mut all = all().flatten();
        all.any(|push| push.link == *link && scale.seen(push) != [false; 2])
    };
    let inset = |link: LinkId| {
        let drawings = positions().map(|(at, pushes)| {
            let own = pushes.iter().filter(|push| push.link == link);
            Outline::of(survey, at, link).drawn(own, &scale)
        });
        Inset {
            title: survey.model.link(link).name.clone(),
            unit: "force",
            scale: scale.force,
            drawings: drawings.collect(),
        }
    };
    Ok(links.iter().copied().filter(is_pushed).map(inset).collect())
}

/// How links and forces are drawn.
struct Scale {
    /// The parts of a field's side that stand for one unit.
    length: f64,
    force: f64,
    /// The least force that is shown, and the arm on which it is the least torque.
    least: f64,
    reach: f64,
}

impl Scale {
    /// Whether the force of a push is seen, and whether its torque is.
    fn seen(&self, push: &Push) -> [bool; 2] {
        [
            push.force[0].hypot(push.force[1]) > self.least,
            push.torque.abs() > self.least * self.reach,
        ]
    }
}

/// A link as its spots tell of it.
struct Outline {
    spots: Vec<Place>,
    middle: Place,
}

impl Outline {
    fn of(survey: Surveyed<'_>, at: &Position, link: LinkId) -> Self {
        let spots: Vec<Place> = Spot::of(survey, at, link).iter().map(|spot| spot.at).collect();
        let ends = |part: usize| {
            let low = spots.iter().map(|at| at[part]).fold(f64::INFINITY, f64::min);
            let high = spots.iter().map(|at| at[part]).fold(f64::NEG_INFINITY, f64::max);
            f64::midpoint(low, high)
        };
        let middle = if spots.is_empty() { [0.0; 2] } else { [ends(0), ends(1)] };
        Self { spots, middle }
    }

    /// How far the farthest of its spots and of these places is from its middle.
    fn reach(&self, places: impl Iterator<Item = Place>) -> f64 {
        let all = self.spots.iter().copied().chain(places);
        let far = all.map(|[x, y]| (x - self.middle[0]).hypot(y - self.middle[1]));
        far.fold(0.0, f64::max)
    }

    /// The link with what pushes it.
    fn drawn<'p>(&self, pushes: impl Iterator<Item = &'p Push>, scale: &Scale) -> Vec<Mark> {
        let to = |place: Place| [0, 1].map(|part| scale.length * (place[part] - self.middle[part]));
        let color = INK;
        let line = |from: Place, to: Place| Mark::Line { ends: [from, to], color };
        let spots: Vec<Place> = self.spots.iter().copied().map(to).collect();
        let mut marks: Vec<Mark> = spots.windows(2).map(|pair| line(pair[0], pair[1])).collect();
        if let [first, _, .., last] = spots[..] {
            marks.push(line(last, first));
        }
        marks.extend(spots.into_iter().map(Mark::Dot));
        for (number, push) in pushes.enumerate() {
            let at = to(push.at.unwrap_or(self.middle));
            let size = push.force[0].hypot(push.force[1]);
            let [is_force_seen, is_torque_seen] = scale.seen(push);
            if is_force_seen {
                // What pushes inwards ends at its place, what pulls begins there.
                let inwards = push.force[0] * at[0] + push.force[1] * at[1] < -NONE * size;
                let side = if inwards { -1.0 } else { 1.0 };
                let outer = push.force.map(|part| side * part);
                let far = [0, 1].map(|part| at[part] + scale.force * outer[part]);
                marks.push(Mark::Arrow {
                    ends: if inwards { [far, at] } else { [at, far] },
                    color: Palette::RED,
                });
                let text = format!("{} {}", push.name, tick(four_digits(size)));
                // Names of arrows that lie in each other stand above and below these.
                let is_level = outer[1].abs() < LEVEL * size;
                let up = match number % 2 {
                    0 if is_level => 1.0,
                    _ if is_level => -1.0,
                    _ => outer[1],
                };
                marks.push(Mark::name(far, [outer[0], up], text));
            }
            if is_torque_seen {
                marks.push(Mark::Turn {
                    at,
                    to_the_left: push.torque > 0.0,
                    color: Palette::PURPLE,
                });
                marks.push(Mark::Text {
                    at,
                    away: BESIDE,
                    text: format!("{} torque {}", push.name, tick(four_digits(push.torque.abs()))),
                });
            }
        }
        marks
    }
}
