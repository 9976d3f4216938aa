//! A mechanism that is played: the compiler's interpreter moves it.

use super::distance::{distance_to_shape, nearest};
use super::landmarks::Landmarks;
use super::prepared::Prepared;
use super::{Derived, Layer, Layers, Rates, Style};
use crate::failure::Failure;
use crate::motion::{
    Mover, Paths, Ready, in_precision, joints_in_the_way, motor_name, obstacle, range_of,
};
use crate::painting::{Painting, number_of, poses_of};
use mech_compiler::evaluate::Stop;
use mech_compiler::model::{JointId, Look, Measure, Model, MotorId};
use mech_compiler::program::Position;
use mech_compiler::{Compiled, led_place, symbols};
use mech_runtime::overlay::{Arrows, Spot};
use mech_runtime::{Canvas, Overlay, Palette, Pose};

/// An obstacle to the motion of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// The end of the declared range of this motor.
    Range(MotorId),
    /// The stop that the interpreter reports.
    Stop(Stop),
}

/// A mechanism that is played. The values of its motors are in the order of their declaration, in radians or scene units.
pub struct Mechanism {
    pub(super) model: Model,
    pub(super) compiled: Compiled,
    painting: Painting,
    prepared: Prepared,
    landmarks: Landmarks,
    /// The points whose velocities are drawn.
    pub(super) points: Vec<Spot<f64>>,
    ready: Ready,
    /// The mechanism in which the point of `follow` is given, ready for motion, and its start.
    leading: Option<(Ready, Position<f64>)>,
    pub(super) position: Position<f64>,
    paths: Paths,
}

impl Mechanism {
    /// A coherent mechanism at its start.
    ///
    /// # Errors
    /// If the compiler itself fails, which is a mistake of ours.
    pub fn new(model: Model, compiled: Compiled) -> Result<Self, Failure> {
        let prepared = Prepared::of(&model, &compiled)?;
        Self::of(model, compiled, prepared)
    }

    /// A coherent mechanism that was prepared, at its start.
    pub(crate) fn of(
        model: Model,
        compiled: Compiled,
        prepared: Prepared,
    ) -> Result<Self, Failure> {
        let Prepared { looks, extent, .. } = &prepared;
        let painting = Painting::of(&model, &compiled, looks, *extent, true);
        let has_pose = |link| compiled.program.place_of(link).is_some();
        let points = symbols::moving_points(&model, &compiled.structure, has_pose);
        let number = |link| number_of(&compiled, link);
        let points = points.iter();
        let points = points.filter_map(|point| point.try_map(Measure::at_start, number));
        Ok(Self {
            points: points.collect(),
            landmarks: Landmarks::new(&model, &compiled),
            prepared,
            ready: Ready::new(&model, &compiled.program),
            leading: compiled.leading(&model).map(|program| {
                let start = Mover::of(&model, program).position();
                (Ready::new(&model, program), start)
            }),
            position: Mover::new(&model, &compiled).position(),
            paths: Paths::new(&model, &compiled)?,
            painting,
            model,
            compiled,
        })
    }

    /// What took time to find out about it.
    #[cfg(feature = "transfer")]
    pub(crate) fn into_prepared(self) -> Prepared {
        self.prepared
    }

    /// Its name.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.model.name
    }

    /// The layers that are visible at first. Where nothing but declared shapes is wanted, the diagram shows the rest.
    #[must_use]
    pub fn layers(&self) -> Layers {
        if self.model.look == Some(Look::Shapes) || self.painting.is_empty() {
            Layers::of(&[Layer::Shapes, Layer::Joints, Layer::Links, Layer::Motors])
        } else {
            Layers::of(&[Layer::Shapes])
        }
    }

    /// The box around its whole motion: lower left and upper right corner.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        self.painting.extent()
    }

    /// The duration of 1 of the phase of its own motion, in seconds.
    #[must_use]
    pub fn seconds(&self) -> f64 {
        self.prepared.motion.seconds()
    }

    /// After how much of the phase of its own motion every motor has moved.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.prepared.motion.length()
    }

    /// The values of the motors at a phase of its own motion.
    #[must_use]
    pub fn motion(&self, phase: f64) -> Vec<f64> {
        self.prepared.motion.at(&self.model, &self.compiled, phase).values
    }

    /// The rates of the motors at a phase of its own motion; zero where they are not [prepared](Self::prepare).
    #[must_use]
    pub fn rates(&self, phase: f64) -> Rates {
        let compiled = self.with(Derived::Rates).unwrap_or(&self.compiled);
        let [first, second] = self.prepared.motion.at(&self.model, compiled, phase).rates;
        Rates { first, second }
    }

    /// The present values of the motors.
    #[must_use]
    pub fn motors(&self) -> &[f64] {
        &self.position.motors[..self.model.motors.len()]
    }

    /// Whether its motors stand as at the start.
    #[must_use]
    pub fn is_at_start(&self) -> bool {
        let start = Mover::new(&self.model, &self.compiled).position();
        self.motors() == &start.motors[..self.model.motors.len()]
    }

    /// The present value of the motor of this name.
    pub(super) fn value_of(&self, name: &str) -> Option<f64> {
        let motor = (0..self.motors().len()).find(|motor| self.motor_name(*motor) == Some(name))?;
        self.motors().get(motor).copied()
    }

    /// The present value of each motor, with its name, in degrees or scene units.
    #[must_use]
    pub fn shown_motors(&self) -> Vec<(String, f64)> {
        let values = self.motors().iter().enumerate();
        let shown = values.filter_map(|(motor, &value)| {
            let name = self.motor_name(motor)?.to_owned();
            Some((name, if self.slides(motor) { value } else { value.to_degrees() }))
        });
        shown.collect()
    }

    /// The present pose of each link of the model; none of a link that is not shown.
    #[must_use]
    pub fn poses(&self) -> Vec<Option<Pose<f64>>> {
        let links = self.model.link_ids();
        let pose = |link| {
            let place = self.compiled.program.place_of(link)?;
            self.position.poses.get(place).copied().map(Pose::from)
        };
        links.map(pose).collect()
    }

    pub(crate) fn motor_name(&self, motor: usize) -> Option<&str> {
        Some(motor_name(&self.model, self.motor(motor)?))
    }

    /// Whether a motor slides: then its values are lengths.
    #[must_use]
    pub fn slides(&self, motor: usize) -> bool {
        self.joint_of_motor(motor).is_some_and(|joint| !self.model.turns(joint))
    }

    /// A value of a motor as text: an angle in degrees, or a length.
    #[must_use]
    pub fn shown(&self, motor: usize, value: f64) -> Option<String> {
        self.motor(motor)?;
        Some(if self.slides(motor) {
            format!("{value:.3}")
        } else {
            format!("{:.1}°", value.to_degrees())
        })
    }

    pub(super) fn joint_of_motor(&self, motor: usize) -> Option<JointId> {
        Some(self.model.motor(self.motor(motor)?).joint)
    }

    fn motor(&self, motor: usize) -> Option<MotorId> {
        self.model.motor_ids().nth(motor)
    }

    /// Returns to the start.
    pub(crate) fn reset(&mut self) {
        self.position = Mover::new(&self.model, &self.compiled).position();
        self.paths.clear();
    }

    /// Moves the motors straight towards these values, as far as possible: what is in the way, if it does not arrive. Motors without a
    /// value keep theirs.
    pub fn move_toward(&mut self, motors: &[f64]) -> Option<Obstacle> {
        let (position, obstacle) = self.moved(motors);
        if position.motors != self.position.motors {
            self.paths.record(&position.poses);
        }
        self.position = position;
        obstacle
    }

    /// The position after a move towards these values of the motors, and what is in the way, if it does not arrive.
    fn moved(&self, motors: &[f64]) -> (Position<f64>, Option<Obstacle>) {
        let mut goal = self.motors().to_vec();
        for (value, motor) in goal.iter_mut().zip(motors) {
            *value = *motor;
        }
        let range = self.keep_in_ranges(&mut goal).map(Obstacle::Range);
        let mut machine = Mover::at(&self.compiled.program, &self.ready, &self.position);
        let stop = machine.move_toward(&goal);
        (machine.position(), stop.map(Obstacle::Stop).or(range))
    }

    /// The point that `follow` leads, as a place on its link.
    pub(super) fn led_spot(&self) -> Option<Spot<f64>> {
        let inverse = self.model.inverse.as_ref()?;
        let point = inverse.point.map(|point| self.model.axis(point).at);
        Some(Spot { link: number_of(&self.compiled, inverse.link)?, at: point.unwrap_or_default() })
    }

    /// Leads a place on a link straight to `aim`, as generated code does it, if `follow` leads it and only these motors move: the point itself, or
    /// with its angle any place of its link, which keeps its angle. Returns whether it comes there; if not, nothing moves.
    pub(super) fn lead(&mut self, spot: Spot<f64>, aim: [f64; 2], may_move: &[usize]) -> bool {
        let Some(position) = self.led(spot, aim, may_move) else {
            return false;
        };
        self.paths.record(&position.poses);
        self.position = position;
        true
    }

    fn led(&self, spot: Spot<f64>, aim: [f64; 2], may_move: &[usize]) -> Option<Position<f64>> {
        let inverse = self.model.inverse.as_ref()?;
        let (ready, start) = self.leading.as_ref()?;
        let (point, here) = (self.led_spot()?, self.place(spot)?);
        let is_led = point == spot || inverse.gives_angle() && point.link == spot.link;
        let mut motors = inverse.motors.iter();
        if !is_led || !motors.all(|motor| may_move.contains(&motor.index())) {
            return None;
        }
        let program = &self.compiled.program;
        let mut place = led_place(&self.model, program, &self.position.poses)?;
        for (value, (aim, here)) in place.iter_mut().zip(aim.into_iter().zip(here)) {
            *value += aim - here;
        }
        let mut machine = Mover::at(program, &self.ready, &self.position);
        let mut other = Mover::at(self.compiled.leading(&self.model)?, ready, start);
        let led = machine.lead(&self.model, &self.compiled, &mut other, &place);
        led.ok().map(|()| machine.position())
    }

    /// Ends a straight move where the first motor comes to an end of its declared range: that motor. Its value is that end, exactly.
    fn keep_in_ranges(&self, goal: &mut [f64]) -> Option<MotorId> {
        let mut first: Option<(MotorId, f64, f64)> = None;
        for motor in self.model.motor_ids() {
            let Some(ends) = range_of(&self.model, motor) else {
                continue;
            };
            let [low, high] = ends.map(|end| in_precision(self.model.precision, end));
            let (from, to) = (self.position.motors[motor.index()], goal[motor.index()]);
            if to.is_finite() && !(low..=high).contains(&to) {
                let end = to.clamp(low, high);
                let part = (end - from) / (to - from);
                if first.is_none_or(|(_, least, _)| part < least) {
                    first = Some((motor, part, end));
                }
            }
        }
        let (stopped, part, end) = first?;
        for (value, from) in goal.iter_mut().zip(&self.position.motors) {
            *value = from + (*value - from) * part;
        }
        goal[stopped.index()] = end;
        Some(stopped)
    }

    /// Describes an obstacle, as a phrase.
    pub(super) fn cause(&self, of: Obstacle) -> String {
        match of {
            Obstacle::Range(motor) => {
                let name = motor_name(&self.model, motor);
                format!("end of the declared range of `{name}`")
            }
            Obstacle::Stop(stop) => obstacle(&self.model, &self.compiled, stop),
        }
    }

    /// The joints of the loop that is in the way, if one is.
    pub(super) fn joints_in_the_way(&self, of: Obstacle) -> Vec<JointId> {
        match of {
            Obstacle::Range(_) => Vec::new(),
            Obstacle::Stop(stop) => joints_in_the_way(&self.model, &self.compiled, stop),
        }
    }

    /// The place in the scene of a place on a link. `None` if the link does not exist.
    #[must_use]
    pub fn place(&self, spot: Spot<f64>) -> Option<[f64; 2]> {
        place_in(&self.position, spot)
    }

    /// The place after a move towards these values of the motors, as far as possible. `None` if a value is not finite.
    #[must_use]
    pub fn place_toward(&self, spot: Spot<f64>, motors: &[f64]) -> Option<[f64; 2]> {
        match self.moved(motors) {
            (_, Some(Obstacle::Stop(Stop::NotFinite(_)))) => None,
            (position, _) => place_in(&position, spot),
        }
    }

    /// The place of a joint in the scene, if it turns, slides or welds.
    pub(super) fn joint(&self, joint: JointId) -> Option<[f64; 2]> {
        self.place(self.landmarks.joint(joint)?)
    }

    /// The place on the visible moving link, or else on the nearest one. `None` if that is farther away than `reach`.
    pub(crate) fn spot_at(&self, place: [f64; 2], reach: f64) -> Option<Spot<f64>> {
        let mut found = None;
        let mut least = reach;
        let mut offer = |link: usize, at: [f64; 2], distance: f64| {
            if distance <= least {
                least = distance;
                found = Some(Spot { link, at });
            }
        };
        for link in 1..=self.position.poses.len() {
            let at = pose_in(&self.position, link)?.relative(place);
            offer(link, at, self.distance(link, at));
        }
        // From the back to the front: of several that lie one upon the other the last is seen.
        for (link, outline) in self.painting.outlines().filter(|(link, _)| *link > 0) {
            let at = pose_in(&self.position, link)?.relative(place);
            offer(link, at, distance_to_shape(at, &outline));
        }
        found
    }

    /// The distance of a place from the bars of a link.
    fn distance(&self, link: usize, at: [f64; 2]) -> f64 {
        let joints = self.landmarks.on_link(link);
        let bars = joints.clone().flat_map(|from| joints.clone().map(move |to| [from, to]));
        nearest(at, bars)
    }

    /// Whether it can show a layer, as far as that is known.
    #[must_use]
    pub fn offers(&self, layer: Layer) -> bool {
        match layer {
            Layer::Shapes => !self.painting.is_empty(),
            Layer::Joints | Layer::Links | Layer::Axes | Layer::Motors => true,
            Layer::Velocities | Layer::Accelerations => {
                !self.knows(Derived::Rates) || self.with(Derived::Rates).is_some()
            }
        }
    }

    /// Compiles it once more, to compute something besides positions.
    pub fn prepare(&mut self, what: Derived) {
        if !self.knows(what) {
            self.take(what, what.compile(&self.model, &self.compiled));
        }
    }

    /// Takes over what it was compiled to once more.
    pub(super) fn take(&mut self, what: Derived, found: Option<Box<Compiled>>) {
        self.prepared.derived.push((what, found));
    }

    /// Whether it was compiled once more for something.
    pub(crate) fn knows(&self, what: Derived) -> bool {
        let mut known = self.prepared.derived.iter();
        known.any(|(known, _)| *known == what)
    }

    /// The mechanism with something besides positions.
    pub(super) fn with(&self, what: Derived) -> Option<&Compiled> {
        let mut known = self.prepared.derived.iter();
        known.find(|(known, _)| *known == what)?.1.as_deref()
    }

    pub(super) fn draw(&self, canvas: &mut impl Canvas<f64>, style: &Style, rates: &Rates) {
        let has = |layer| style.layers.has(layer);
        let poses = poses_of(&self.position.poses);
        if has(Layer::Shapes) {
            self.painting.paint_look(&poses, &self.paths, canvas);
        }
        let overlay = Overlay::new()
            .joints(has(Layer::Joints))
            .links(has(Layer::Links))
            .axes(has(Layer::Axes))
            .motors(has(Layer::Motors))
            .size(style.size);
        self.painting.paint_diagram(&poses, &overlay, canvas);
        if has(Layer::Velocities) || has(Layer::Accelerations) {
            self.draw_arrows(canvas, style, rates);
        }
    }

    /// Draws velocities and accelerations, where they are determined.
    fn draw_arrows(&self, canvas: &mut impl Canvas<f64>, style: &Style, rates: &Rates) {
        let arrows = |length, color| Arrows::new(length, color).size(style.size);
        let red = arrows(style.acceleration, Palette::RED);
        let blue = arrows(style.velocity, Palette::BLUE);
        let points = self.point_rates(rates);
        if style.layers.has(Layer::Accelerations) {
            for point in &points {
                if let Some(vector) = point.acceleration {
                    red.draw(canvas, point.place, vector);
                }
            }
        }
        if style.layers.has(Layer::Velocities) {
            for point in &points {
                blue.draw(canvas, point.place, point.velocity);
            }
        }
    }
}

/// The pose of a link; the ground too.
fn pose_in(position: &Position<f64>, link: usize) -> Option<Pose<f64>> {
    match link.checked_sub(1) {
        None => Some(Pose::identity()),
        Some(moving) => position.poses.get(moving).copied().map(Pose::from),
    }
}

fn place_in(position: &Position<f64>, spot: Spot<f64>) -> Option<[f64; 2]> {
    Some(pose_in(position, spot.link)?.apply(spot.at))
}

#[cfg(feature = "transfer")]
impl serde::Serialize for Mechanism {
    fn serialize<S: serde::Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        (&self.model, &self.compiled, &self.prepared).serialize(to)
    }
}

#[cfg(feature = "transfer")]
impl<'de> serde::Deserialize<'de> for Mechanism {
    fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let (model, compiled, prepared) = <(Model, Compiled, Prepared)>::deserialize(from)?;
        Self::of(model, compiled, prepared).map_err(serde::de::Error::custom)
    }
}

/// A limit at which a mechanism is.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// The obstacle in the way.
    pub obstacle: Obstacle,
    /// The motors that could not move on.
    pub motors: Vec<usize>,
}

impl Limit {
    /// The joints that stop it and those whose motor cannot move on: the place of each in the scene, and whether it has such a motor.
    #[must_use]
    pub fn places(&self, mechanism: &Mechanism) -> Vec<([f64; 2], bool)> {
        let motors: Vec<_> =
            self.motors.iter().filter_map(|&motor| mechanism.joint_of_motor(motor)).collect();
        let others = mechanism.joints_in_the_way(self.obstacle);
        let others = others.into_iter().filter(|joint| !motors.contains(joint));
        let others: Vec<_> = others.map(|joint| (joint, false)).collect();
        let all = motors.iter().map(|&joint| (joint, true)).chain(others);
        all.filter_map(|(joint, is_motor)| Some((mechanism.joint(joint)?, is_motor))).collect()
    }

    /// The place and the cause, as a sentence.
    #[must_use]
    pub fn sentence(&self, mechanism: &Mechanism) -> String {
        let values = mechanism.motors();
        let stopped = self.motors.iter().filter_map(|&motor| {
            let name = mechanism.motor_name(motor)?;
            let value = mechanism.shown(motor, *values.get(motor)?)?;
            Some(format!("motor `{name}` stopped at {value}"))
        });
        let stopped: Vec<String> = stopped.collect();
        let cause = mechanism.cause(self.obstacle);
        format!("{}: {cause}", stopped.join(", "))
    }
}
