//! All that is constructed over a picture, or over those of a film.

use super::body::bodies;
use super::mark::Mark;
use super::panel::{Inset, Panel};
use super::path::Centrodes;
use super::polygon::polygon;
use super::{Construction, Place, centres, path};
use crate::failure::Failure;
use crate::motion::{Drive, motor_name};
use crate::quantity::{Load, Order, Position, Survey, body_of};
use mech_compiler::model::{LinkId, Model};
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

/// All that is constructed over the pictures of a motion, and beside them.
pub(crate) struct Board {
    /// The marks of each picture.
    marks: Vec<Vec<Mark>>,
    extent: [Place; 2],
}

impl Board {
    /// Nothing, for pictures of this box.
    pub(crate) fn empty(extent: [Place; 2]) -> Self {
        let marks = Vec::new();
        Self { marks, extent }
    }

    /// Constructs, for pictures of this box.
    pub(crate) fn new(
        constructions: &[Construction],
        of: &Filmed<'_>,
        extent: [Place; 2],
    ) -> Result<Self, Failure> {
        let mut board = Self::empty(extent);
        if constructions.is_empty() {
            return Ok(board);
        }
        board.marks = vec![Vec::new(); of.parts.len()];
        let order = constructions.iter().map(Construction::order).max();
        let order = order.unwrap_or(Order::Velocity);
        let forces = constructions.contains(&Construction::Forces).then_some(of.loads);
        let survey = Survey::new(of.model, of.drive, of.parts, order, forces)?;
        let mut insets = Vec::new();
        let polygons = |title, unit, order| -> Result<Inset, Failure> {
            let drawings = drawn(&survey, NO_VELOCITIES, &|at| polygon(&survey, at, order))?;
            let title = format!("{title}{}", pace(of));
            Ok(Inset::filling(title, unit, &drawings))
        };
        for construction in constructions {
            match construction {
                Construction::Centres => {
                    board.add(drawn(&survey, NO_VELOCITIES, &|at| centres::centres(&survey, at))?);
                }
                Construction::Velocities => {
                    insets.push(polygons("velocities", "unit/s", Order::Velocity)?);
                }
                Construction::Accelerations => {
                    insets.push(polygons("accelerations", "unit/s²", Order::Acceleration)?);
                }
                Construction::Centrodes(name) => {
                    let link = moving_link(of.model, name)?;
                    let parts: Vec<f64> = (0..=PLACES).map(|n| f64::from(n) / f64::from(PLACES)).collect();
                    let whole = Survey::new(of.model, of.whole, &parts, Order::Velocity, None)?;
                    let Some(centrodes) = Centrodes::new(&whole, link, extent) else {
                        return Err(Failure::mechanism(format!(
                            "link `{name}` never turns, so its instant centre is always at infinity"
                        )));
                    };
                    board.add(drawn(&survey, NO_VELOCITIES, &|at| centrodes.drawn(&survey, at))?);
                }
                Construction::Inflection(name) => {
                    let link = moving_link(of.model, name)?;
                    let why = format!("link `{name}` does not turn");
                    board.add(drawn(&survey, &why, &|at| path::inflection(&survey, at, link))?);
                }
                Construction::Forces => {
                    insets.extend(bodies(&survey, of.drive.motor().is_some())?);
                }
            }
        }
        board.make_room();
        let (panels, extent) = Panel::beside(board.extent, insets.len());
        board.extent = extent;
        for (inset, panel) in insets.into_iter().zip(panels) {
            board.add(inset.placed(panel));
        }
        Ok(board)
    }

    fn add(&mut self, marks: Vec<Vec<Mark>>) {
        for (all, more) in self.marks.iter_mut().zip(marks) {
            all.extend(more);
        }
    }

    /// Has room for what is not farther away than the pictures are large.
    fn make_room(&mut self) {
        let [low, high] = self.extent;
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        let places = self.marks.iter().flatten().flat_map(Mark::places);
        let is_near = |place: &&Place| {
            (0..2).all(|part| (low[part] - size..=high[part] + size).contains(&place[part]))
        };
        for place in places.filter(is_near) {
            for part in 0..2 {
                self.extent[0][part] = self.extent[0][part].min(place[part]);
                self.extent[1][part] = self.extent[1][part].max(place[part]);
            }
        }
    }

    /// The box around the pictures and all that is beside them.
    pub(crate) fn extent(&self) -> [Place; 2] {
        self.extent
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
    fn order(&self) -> Order {
        match self {
            Self::Accelerations | Self::Inflection(_) => Order::Acceleration,
            Self::Centres | Self::Velocities | Self::Forces | Self::Centrodes(_) => Order::Velocity,
        }
    }
}

/// What is drawn in each position. Somewhere it has to be determined; `what` it is says why it may not be.
fn drawn(
    survey: &Survey,
    what: &str,
    draw: &dyn Fn(&Position) -> Option<Vec<Mark>>,
) -> Result<Vec<Vec<Mark>>, Failure> {
    let all: Vec<Option<Vec<Mark>>> = survey.positions.iter().map(draw).collect();
    if all.iter().all(Option::is_none) {
        return Err(Failure::mechanism(format!(
            "{what} here, as at a dead point or a change point; put a motor elsewhere with `--at`"
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

/// How fast the motor moves, as words of a title.
fn pace(of: &Filmed<'_>) -> String {
    let motor = of.drive.motor();
    motor.map_or_else(String::new, |motor| {
        let name = motor_name(of.model, motor);
        let joint = of.model.motor(motor).joint;
        let unit = if crate::motion::turns(of.model, joint) { "rad" } else { "unit" };
        format!(", {name} at 1 {unit}/s")
    })
}
