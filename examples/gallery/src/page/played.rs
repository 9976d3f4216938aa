//! Playing with a mechanism of any type.

use crate::{Effects, Landmarks, Layer, Look, Playable, Rates, Scene, Showcase, Spot};
use mech_runtime::overlay::Arrows;
use mech_runtime::{Blocked, Mechanism, Outline, Overlay, Palette, Pose, Reached};

/// The mechanism of a showcase.
pub(crate) struct Played<M: Mechanism<Scalar = f64>> {
    mechanism: M,
    motion: fn(f64) -> M::Motors,
    effects: Option<Effects<M>>,
    landmarks: Landmarks,
}

impl<M: Mechanism<Scalar = f64>> Played<M> {
    /// The mechanism at its start.
    pub(crate) fn new(showcase: &Showcase<M>) -> Self {
        Self {
            mechanism: M::new(),
            motion: showcase.motion,
            effects: showcase.effects.clone(),
            landmarks: Landmarks::of::<M>(),
        }
    }

    /// The present values of the motors, with these in place of the first ones.
    fn motors_with(&self, values: &[f64]) -> M::Motors {
        with_values::<M>(self.mechanism.motors(), values)
    }

    /// The pose of a link; the ground too.
    fn pose(&self, link: usize) -> Option<Pose<f64>> {
        pose(&self.mechanism, link)
    }

    /// The distance of a place from the bars of a link.
    fn distance(&self, link: usize, at: [f64; 2]) -> f64 {
        let joints = self.landmarks.on_link(link);
        let bars = joints
            .clone()
            .flat_map(|from| joints.clone().map(move |to| [from, to]));
        nearest(at, bars)
    }
}

/// Motor values with these in place of the first ones.
fn with_values<M: Mechanism<Scalar = f64>>(mut motors: M::Motors, values: &[f64]) -> M::Motors {
    for (motor, &value) in motors.as_mut().iter_mut().zip(values) {
        *motor = value;
    }
    motors
}

/// The pose of a link; the ground too.
fn pose<M: Mechanism<Scalar = f64>>(mechanism: &M, link: usize) -> Option<Pose<f64>> {
    match link.checked_sub(1) {
        None => Some(Pose::identity()),
        Some(moving) => mechanism.poses().get(moving).copied(),
    }
}

impl<M: Mechanism<Scalar = f64>> Playable for Played<M> {
    fn motor_names(&self) -> &'static [&'static str] {
        M::MOTORS
    }

    fn slides(&self, motor: &str) -> bool {
        self.landmarks.slides(motor)
    }

    fn motors(&self) -> Vec<f64> {
        self.mechanism.motors().as_ref().to_vec()
    }

    fn reset(&mut self) {
        self.mechanism = M::new();
    }

    fn motion(&self, phase: f64) -> Vec<f64> {
        (self.motion)(phase).as_ref().to_vec()
    }

    fn move_toward(
        &mut self,
        motors: &[f64],
        rates: &Rates,
    ) -> Result<Reached<Vec<f64>>, Blocked<Vec<f64>>> {
        let target = self.motors_with(motors);
        if let Some(effects) = &self.effects {
            let still = with_values::<M>(target, &vec![0.0; M::MOTORS.len()]);
            let first = with_values::<M>(still, &rates.first);
            let second = with_values::<M>(still, &rates.second);
            if (effects.move_with)(&mut self.mechanism, target, first, second).is_ok() {
                return Ok(Reached::Target);
            }
        }
        let values = |motors: M::Motors| motors.as_ref().to_vec();
        match self.mechanism.move_toward(target) {
            Ok(Reached::Target) => Ok(Reached::Target),
            Ok(Reached::Limit(blocked)) => Ok(Reached::Limit(blocked.map(values))),
            Err(blocked) => Err(blocked.map(values)),
        }
    }

    fn place(&self, spot: Spot) -> Option<[f64; 2]> {
        Some(self.pose(spot.link)?.apply(spot.at))
    }

    fn place_toward(&self, spot: Spot, motors: &[f64]) -> Option<[f64; 2]> {
        let mut trial = self.mechanism.clone();
        // Wherever it comes to, it is somewhere.
        let _ = trial.move_toward(self.motors_with(motors)).ok()?;
        Some(pose(&trial, spot.link)?.apply(spot.at))
    }

    fn spot_at(&self, place: [f64; 2], reach: f64) -> Option<Spot> {
        let mut nearest = None;
        let mut least = reach;
        let mut offer = |link: usize, at: [f64; 2], distance: f64| {
            if distance <= least {
                least = distance;
                nearest = Some(Spot { link, at });
            }
        };
        for link in 1..=M::LINKS.len() {
            let at = self.pose(link)?.relative(place);
            offer(link, at, self.distance(link, at));
        }
        // From the back to the front: of several that lie one upon the other the last is seen.
        for shape in M::SHAPES.iter().filter(|shape| shape.link > 0) {
            let at = self.pose(shape.link)?.relative(place);
            offer(shape.link, at, distance_to_shape(at, &shape.outline));
        }
        nearest
    }

    fn joint(&self, name: &str) -> Option<[f64; 2]> {
        self.place(self.landmarks.joint(name)?)
    }

    fn offers(&self, layer: Layer) -> bool {
        match layer {
            Layer::Shapes => !M::SHAPES.is_empty(),
            _ => self.effects.is_some(),
        }
    }

    fn draw(&self, scene: &mut Scene, look: &Look) {
        let has = |layer| look.layers.has(layer);
        if has(Layer::Shapes) {
            self.mechanism.draw(scene);
        }
        let Some(effects) = &self.effects else {
            return;
        };
        let overlay = Overlay::new()
            .joints(has(Layer::Joints))
            .links(has(Layer::Links))
            .axes(has(Layer::Axes))
            .motors(has(Layer::Motors))
            .size(look.size);
        (effects.draw_overlay)(&self.mechanism, scene, &overlay);
        let arrows = |length, color| Arrows::new(length, color).size(look.size);
        if has(Layer::Accelerations) {
            let red = arrows(look.acceleration, Palette::RED);
            (effects.draw_accelerations)(&self.mechanism, scene, &red);
        }
        if has(Layer::Velocities) {
            let blue = arrows(look.velocity, Palette::BLUE);
            (effects.draw_velocities)(&self.mechanism, scene, &blue);
        }
    }
}

/// The distance of a place from a shape: 0 within it.
fn distance_to_shape(at: [f64; 2], outline: &Outline<'_, f64>) -> f64 {
    let from = |[x, y]: [f64; 2]| (at[0] - x).hypot(at[1] - y);
    let beyond = match *outline {
        Outline::Circle { center, radius } => from(center) - radius,
        Outline::Ring {
            center,
            radius,
            hole,
        } => (from(center) - radius).max(hole - from(center)),
        Outline::Polygon(corners) => distance_to_polygon(at, corners, |round| round % 2 != 0),
        Outline::Winding(corners) => distance_to_polygon(at, corners, |round| round != 0),
        Outline::Line { points, width } => {
            let lines = points.windows(2).filter_map(|line| line.try_into().ok());
            let dots = points.iter().map(|&point| [point; 2]);
            nearest(at, lines.chain(dots)) - width / 2.0
        }
        // However far it leads around: who presses within its circle means it.
        Outline::Arc {
            center,
            start,
            width,
            ..
        } => {
            let radius = (start[0] - center[0]).hypot(start[1] - center[1]);
            (from(center) - radius).abs() - width / 2.0
        }
    };
    beyond.max(0.0)
}

/// The distance of a place from a polygon. `is_filled` says which winding numbers are inside.
fn distance_to_polygon(at: [f64; 2], corners: &[[f64; 2]], is_filled: impl Fn(i32) -> bool) -> f64 {
    let next = corners.iter().cycle().skip(1);
    let sides = corners.iter().zip(next).map(|(&from, &to)| [from, to]);
    if is_filled(sides.clone().map(|side| crossing(at, side)).sum()) {
        0.0
    } else {
        nearest(at, sides)
    }
}

/// Whether a ray from a place to the right crosses a side: 1 upwards, −1 downwards, 0 not at all.
fn crossing([x, y]: [f64; 2], [from, to]: [[f64; 2]; 2]) -> i32 {
    let share = (y - from[1]) / (to[1] - from[1]);
    let [is_below, is_above] = [from[1] <= y, to[1] > y];
    if is_below != is_above || x >= from[0] + share * (to[0] - from[0]) {
        0
    } else if is_above {
        1
    } else {
        -1
    }
}

/// The distance of a place from the nearest of these lines.
fn nearest(at: [f64; 2], lines: impl Iterator<Item = [[f64; 2]; 2]>) -> f64 {
    lines
        .map(|line| distance_to_line(at, line))
        .fold(f64::INFINITY, f64::min)
}

/// The distance of a place from a segment.
fn distance_to_line(at: [f64; 2], [from, to]: [[f64; 2]; 2]) -> f64 {
    let [x, y] = [to[0] - from[0], to[1] - from[1]];
    let square = x * x + y * y;
    let share = if square > 0.0 {
        (((at[0] - from[0]) * x + (at[1] - from[1]) * y) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (at[0] - from[0] - share * x).hypot(at[1] - from[1] - share * y)
}
