//! What the motion of a link relative to the ground is made of: its centrodes, and its inflection circle.

use super::Place;
use super::mark::Mark;
use super::spot::is_near;
use crate::motion::PlaneMotion;
use crate::quantity::{Position, Survey, Surveyed};
use mech_compiler::model::{LinkId, Rate};
use mech_runtime::{Palette, Pose};

/// What is farther from the box of the picture than so many times its size is not shown of a centrode.
const FAR: f64 = 2.0;
/// Places of a centrode that are farther apart than this part of the size are not joined: it comes back from infinity between them.
const GAP: f64 = 0.5;

/// The centrodes of a link, through a whole motion.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Centrodes {
    link: LinkId,
    /// The pieces of the curve on which the instant centre runs in the scene, and of that in the link.
    fixed: Vec<Vec<Place>>,
    moving: Vec<Vec<Place>>,
    name: String,
}

impl Centrodes {
    /// Of a motion in a box. None if the link never turns, so that its centre is always at infinity.
    pub(super) fn new(whole: &Survey, link: LinkId, [low, high]: [Place; 2]) -> Option<Self> {
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        let is_near = |place: &Place| {
            (0..2).all(|part| {
                (low[part] - FAR * size..=high[part] + FAR * size).contains(&place[part])
            })
        };
        let survey = whole.subject();
        let centre = |at: &Position| {
            let centre = centre(survey, at, link)?;
            Some((centre, at.pose(survey.compiled, link)?.relative(centre)))
        };
        let (mut fixed, mut moving): (Vec<Vec<Place>>, Vec<Vec<Place>>) = (Vec::new(), Vec::new());
        let mut last: Option<Place> = None;
        for at in &whole.positions {
            let found = centre(at).filter(|(centre, _)| is_near(centre));
            if let Some((here, there)) = found {
                let goes_on =
                    last.is_some_and(|[x, y]| (here[0] - x).hypot(here[1] - y) <= GAP * size);
                match (fixed.last_mut(), moving.last_mut()) {
                    (Some(in_scene), Some(in_link)) if goes_on => {
                        in_scene.push(here);
                        in_link.push(there);
                    }
                    _ => {
                        fixed.push(vec![here]);
                        moving.push(vec![there]);
                    }
                }
            }
            last = found.map(|(centre, _)| centre);
        }
        let name = survey.model.link(link).name.clone();
        (!fixed.is_empty()).then_some(Self { link, fixed, moving, name })
    }

    /// Both curves where a mechanism is, and the instant centre, at which the one rolls on the other.
    pub(super) fn drawn(&self, survey: Surveyed<'_>, at: &Position) -> Option<Vec<Mark>> {
        let pose = at.pose(survey.compiled, self.link)?;
        let both = [
            ("fixed", &self.fixed, Pose::identity(), Palette::TEAL),
            ("moving", &self.moving, pose, Palette::PURPLE),
        ];
        let mut marks = Vec::new();
        for (kind, pieces, pose, color) in both {
            let curves =
                pieces.iter().map(|places| Mark::Curve { places: places.clone(), pose, color });
            marks.extend(curves);
            let longest = pieces.iter().max_by_key(|places| places.len());
            let middle = longest.and_then(|places| places.get(places.len() / 2));
            marks.extend(middle.map(|place| {
                let place = pose.apply(*place);
                Mark::name(place, place, format!("{kind} centrode of {}", self.name))
            }));
        }
        marks.extend(centre(survey, at, self.link).map(Mark::Dot));
        Some(marks)
    }
}

/// The inflection circle of a link, with the instant centre and the inflection pole, which is opposite. None where the link does not turn.
pub(super) fn inflection(survey: Surveyed<'_>, at: &Position, link: LinkId) -> Option<Vec<Mark>> {
    let centre = centre(survey, at, link)?;
    let [turning, ..] = at.rate(survey.compiled, link, Rate::Velocity)?;
    // The acceleration of the point of the link that is in the instant centre points to the inflection pole.
    let acceleration = at.vector(survey.compiled, link, centre, Rate::Acceleration)?;
    let diameter = acceleration.map(|part| part / turning.powi(2));
    let pole = [0, 1].map(|part| centre[part] + diameter[part]);
    let is_finite = pole.iter().all(|part| part.is_finite());
    let name = format!("inflection circle of {}", survey.model.link(link).name);
    is_finite.then(|| {
        vec![
            Mark::Circle { ends: [centre, pole], color: Palette::GREEN },
            Mark::Dot(centre),
            Mark::Dot(pole),
            Mark::name(pole, diameter, name),
        ]
    })
}

/// The instant centre of a link and the ground; none if the link turns by rounding alone.
fn centre(survey: Surveyed<'_>, at: &Position, link: LinkId) -> Option<Place> {
    let found = at.motion(survey.compiled, link)?.centre(PlaneMotion::default())?;
    is_near(survey.model, found).then_some(found)
}
