//! All that is constructed over a picture, or over those of a film.

use super::body::bodies;
use super::centres::centres;
use super::mark::Mark;
use super::panel::{Inset, Panel};
use super::path::{Centrodes, inflection};
use super::polygon::polygon;
use super::{Construction, Place};
use crate::failure::Failure;
use crate::motion::{Drive, motor_name};
#[cfg(feature = "editor")]
use crate::motion::{Setting, Span};
use crate::quantity::{Load, Position, Survey, Surveyed, body_of};
#[cfg(feature = "editor")]
use mech_compiler::Compiled;
use mech_compiler::model::{LinkId, Model, MotorId, Rate};
use mech_runtime::Canvas;

/// The number of places of a centrode.
const PLACES: u32 = 720;
/// Where nothing is determined.
const NO_VELOCITIES: &str = "there are no velocities";

/// A motion, and the parts of it that are shown.
pub(crate) struct Filmed<'f> {
    pub(crate) model: &'f Model,
    pub(crate) drive: &'f Drive,
    /// The whole motion, which centrodes take.
    pub(crate) whole: &'f Drive,
    pub(crate) parts: &'f [f64],
    pub(crate) loads: &'f [Load],
}

/// Links whose centrodes are wanted, as a motor moves while others stand.
#[cfg(feature = "editor")]
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Rolling {
    pub(crate) links: Vec<String>,
    pub(crate) motor: String,
    pub(crate) others: Vec<Setting>,
    /// The box of the picture.
    pub(crate) extent: [Place; 2],
}

#[cfg(feature = "editor")]
impl Rolling {
    /// The centrodes of those links that have any.
    pub(crate) fn centrodes(&self, model: &Model, compiled: &Compiled) -> Vec<Centrodes> {
        let motor = Some(self.motor.as_str());
        let drive = Drive::new(model, compiled, motor, Span::default(), &self.others);
        let Ok(drive) = drive.map(|drive| drive.completed(model, compiled)) else {
            return Vec::new();
        };
        let of = Filmed { model, drive: &drive, whole: &drive, parts: &[], loads: &[] };
        let links = self.links.iter();
        let found = links.filter_map(|link| centrodes(&of, link, self.extent).ok());
        found.collect()
    }
}

/// All that is constructed over the pictures of a motion, and beside them.
#[derive(Default)]
pub(crate) struct Board {
    /// The marks of each picture.
    marks: Vec<Vec<Mark>>,
    insets: Vec<Inset>,
    extent: [Place; 2],
}

impl Board {
    /// Nothing, for pictures of this box.
    pub(crate) fn empty(extent: [Place; 2]) -> Self {
        Self { extent, ..Self::default() }
    }

    /// Constructs, for pictures of this box.
    pub(crate) fn new(
        constructions: &[Construction],
        of: &Filmed<'_>,
        extent: [Place; 2],
    ) -> Result<Self, Failure> {
        let Some(rate) = constructions.iter().map(Construction::rate).max() else {
            return Ok(Self::empty(extent));
        };
        let forces = constructions.contains(&Construction::Forces);
        let forces = forces.then_some(of.loads);
        let survey = Survey::new(of.model, of.drive, of.parts, rate, forces)?;
        let subject = survey.subject();
        let mut board = Self::empty(extent);
        for construction in constructions {
            if let Construction::Centrodes(name) = construction {
                let centrodes = centrodes(of, name, extent)?;
                let drawn =
                    drawn(&survey.positions, NO_VELOCITIES, &|at| centrodes.drawn(subject, at));
                board.add(drawn?);
            } else {
                board.construct(construction, subject, (&survey.positions, of.drive.motor()))?;
            }
        }
        board.make_room();
        Ok(board.arranged())
    }

    /// Constructs where a mechanism is, as this motor moves, for a picture of this box. What is not determined there is left out.
    #[cfg(feature = "editor")]
    pub(crate) fn known(
        constructions: &[Construction],
        subject: Surveyed<'_>,
        centrodes: &[Centrodes],
        (at, motor): (Position, MotorId),
        extent: [Place; 2],
    ) -> Self {
        let (mut board, positions) = (Self::empty(extent), [at]);
        let drawn = centrodes.iter();
        let drawn = drawn.filter_map(|one| one.drawn(subject, &positions[0]));
        board.add(vec![drawn.flatten().collect()]);
        for construction in constructions {
            // Nobody asked for an answer.
            let _ = board.construct(construction, subject, (&positions, Some(motor)));
        }
        board.arranged()
    }

    /// Constructs one thing at some positions, in the motion of one motor or by laws.
    fn construct(
        &mut self,
        construction: &Construction,
        subject: Surveyed<'_>,
        (positions, motor): (&[Position], Option<MotorId>),
    ) -> Result<(), Failure> {
        let polygons = |title: &str, unit, rate| {
            let drawings = drawn(positions, NO_VELOCITIES, &|at| polygon(subject, at, rate));
            let title = format!("{title}{}", pace(subject.model, motor));
            drawings.map(|drawings| Inset::filling(title, unit, &drawings))
        };
        match construction {
            Construction::Centres => {
                self.add(drawn(positions, NO_VELOCITIES, &|at| centres(subject, at))?);
            }
            Construction::Velocities => {
                let inset = polygons("velocities", "unit/s", Rate::Velocity)?;
                self.insets.push(inset);
            }
            Construction::Accelerations => {
                let inset = polygons("accelerations", "unit/s²", Rate::Acceleration)?;
                self.insets.push(inset);
            }
            Construction::Forces => {
                let all = bodies(subject, positions, motor.is_some())?;
                self.insets.extend(all);
            }
            Construction::Inflection(name) => {
                let link = moving_link(subject.model, name)?;
                let why = format!("link `{name}` does not turn");
                self.add(drawn(positions, &why, &|at| inflection(subject, at, link))?);
            }
            Construction::Centrodes(_) => {}
        }
        Ok(())
    }

    fn add(&mut self, marks: Vec<Vec<Mark>>) {
        self.marks.resize_with(self.marks.len().max(marks.len()), Vec::new);
        for (all, more) in self.marks.iter_mut().zip(marks) {
            all.extend(more);
        }
    }

    /// Has room for all that is not farther away than the pictures are large.
    fn make_room(&mut self) {
        let [low, high] = self.extent;
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        let places = self.marks.iter().flatten().flat_map(Mark::places);
        let is_near = |place: &&Place| {
            (0..2).all(|part| (low[part] - size..=high[part] + size).contains(&place[part]))
        };
        for place in places.filter(is_near) {
            for (part, at) in place.iter().copied().enumerate() {
                self.extent[0][part] = self.extent[0][part].min(at);
                self.extent[1][part] = self.extent[1][part].max(at);
            }
        }
    }

    /// The same with its insets in place.
    fn arranged(mut self) -> Self {
        let insets = std::mem::take(&mut self.insets);
        let (panels, extent) = Panel::beside(self.extent, insets.len());
        self.extent = extent;
        for (inset, panel) in insets.into_iter().zip(panels) {
            self.add(inset.placed(panel));
        }
        self
    }

    /// The box around the pictures and all that is beside them.
    pub(crate) fn extent(&self) -> [Place; 2] {
        self.extent
    }

    /// All texts on the first picture.
    #[cfg(feature = "editor")]
    pub(crate) fn texts(&self) -> Vec<String> {
        let marks = self.marks.first().into_iter().flatten();
        marks.filter_map(Mark::text).map(str::to_owned).collect()
    }

    /// Paints what belongs to the picture of this number.
    pub(crate) fn paint(&self, number: usize, canvas: &mut impl Canvas<f64>) {
        for mark in self.marks.get(number).into_iter().flatten() {
            mark.paint(canvas);
        }
    }
}

impl Construction {
    /// Up to where rates are needed for it.
    fn rate(&self) -> Rate {
        match self {
            Self::Accelerations | Self::Inflection(_) => Rate::Acceleration,
            Self::Centres | Self::Velocities | Self::Forces | Self::Centrodes(_) => Rate::Velocity,
        }
    }
}

/// The centrodes of the link of this name in the whole motion.
fn centrodes(of: &Filmed<'_>, name: &str, extent: [Place; 2]) -> Result<Centrodes, Failure> {
    let link = moving_link(of.model, name)?;
    let parts = (0..=PLACES).map(|number| f64::from(number) / f64::from(PLACES));
    let parts: Vec<f64> = parts.collect();
    let whole = Survey::new(of.model, of.whole, &parts, Rate::Velocity, None)?;
    Centrodes::new(&whole, link, extent).ok_or_else(|| {
        Failure::mechanism(format!(
            "link `{name}` never turns, so its instant centre is always at infinity"
        ))
    })
}

/// What is drawn in each position. Somewhere it has to be determined; else the failure begins with these words.
fn drawn(
    positions: &[Position],
    why: &str,
    draw: &dyn Fn(&Position) -> Option<Vec<Mark>>,
) -> Result<Vec<Vec<Mark>>, Failure> {
    let all: Vec<Option<Vec<Mark>>> = positions.iter().map(draw).collect();
    if all.iter().all(Option::is_none) {
        return Err(Failure::mechanism(format!(
            "{why} here, as at a dead point or a change point; put a motor elsewhere with `--at`"
        )));
    }
    Ok(all.into_iter().map(Option::unwrap_or_default).collect())
}

/// A link that is not the ground.
fn moving_link(model: &Model, name: &str) -> Result<LinkId, Failure> {
    match body_of(model, name)? {
        LinkId::GROUND => Err(Failure::usage("the ground rests; name a link that moves")),
        link => Ok(link),
    }
}

/// How fast a motor moves, as words of a title.
fn pace(model: &Model, motor: Option<MotorId>) -> String {
    motor.map_or_else(String::new, |motor| {
        let is_angle = model.turns(model.motor(motor).joint);
        let unit = if is_angle { "rad" } else { "unit" };
        format!(", {} at 1 {unit}/s", motor_name(model, motor))
    })
}
