//! Films: motions, scene by scene, without the type of the mechanism.

use mech_runtime::{Blocked, Canvas, Outline, OwnedOutline, Pose};
use std::fmt;

/// All figures of one moment, from back to front.
#[derive(Clone, Debug)]
pub struct Scene {
    spots: Vec<Spot>,
    /// The number of pixels per scene unit.
    scale: f64,
}

/// A figure.
#[derive(Clone, Debug)]
enum Spot {
    /// A shape, and its pose.
    Shape(OwnedOutline<f64>, Pose<f64>, u8),
    /// A text, and its lower left corner.
    Text([f64; 2], String, u8),
    /// A part of a trace, and its width.
    Trace(Vec<[f64; 2]>, f64, u8),
}

impl Spot {
    /// The smallest upright box around it.
    fn bounds(&self) -> [[f64; 2]; 2] {
        match self {
            Self::Shape(outline, pose, _) => outline.bounds(*pose).into(),
            Self::Text(place, ..) => [*place; 2],
            Self::Trace(points, width, _) => {
                Outline::Line { points, width: *width }.bounds(Pose::identity()).into()
            }
        }
    }
}

impl Scene {
    /// An empty scene for so many pixels per scene unit.
    #[must_use]
    pub const fn new(scale: f64) -> Self {
        let spots = Vec::new();
        Self { spots, scale }
    }

    /// Paints the scene.
    pub fn draw(&self, canvas: &mut impl Canvas<f64>) {
        for spot in &self.spots {
            match spot {
                Spot::Shape(outline, pose, color) => canvas.fill(outline.borrowed(), *pose, *color),
                Spot::Text(place, text, color) => canvas.text(*place, text, *color),
                Spot::Trace(places, width, color) => canvas.trace(places, *width, *color),
            }
        }
    }
}

impl Canvas<f64> for Scene {
    fn fill(&mut self, outline: Outline<'_, f64>, pose: Pose<f64>, color: u8) {
        let outline = outline.map(|number| number, |points| points.to_vec());
        self.spots.push(Spot::Shape(outline, pose, color));
    }

    fn text(&mut self, place: [f64; 2], text: &str, color: u8) {
        self.spots.push(Spot::Text(place, text.to_owned(), color));
    }

    fn trace(&mut self, places: &[[f64; 2]], width: f64, color: u8) {
        self.spots.push(Spot::Trace(places.to_vec(), width, color));
    }

    fn scale(&self) -> f64 {
        self.scale
    }
}

/// One full motion of a mechanism.
#[derive(Clone, Debug)]
pub struct Film {
    scenes: Vec<Scene>,
    /// The number of pixels per scene unit.
    scale: f64,
}

impl Film {
    /// An empty film for so many pixels per scene unit. At infinite scale, figures whose size is in pixels have none, so the film gives the
    /// bounds of the motion.
    #[must_use]
    pub const fn new(scale: f64) -> Self {
        let scenes = Vec::new();
        Self { scenes, scale }
    }

    /// Adds a scene, which `paint` paints.
    pub fn add(&mut self, paint: impl FnOnce(&mut Scene)) {
        let mut scene = Scene::new(self.scale);
        paint(&mut scene);
        self.scenes.push(scene);
    }

    /// The scenes, in the order in which they were taken.
    #[must_use]
    pub fn scenes(&self) -> &[Scene] {
        &self.scenes
    }

    /// The smallest upright box around all scenes. `None` if nothing is visible.
    #[must_use]
    pub fn bounds(&self) -> Option<[[f64; 2]; 2]> {
        let all = self.scenes.iter().flat_map(|scene| &scene.spots);
        all.map(Spot::bounds)
            .filter(|bounds| bounds.as_flattened().iter().all(|c| c.is_finite()))
            .reduce(around)
    }
}

/// The smallest box around two others, each given by its lower left and upper right corner.
fn around([low, high]: [[f64; 2]; 2], [other_low, other_high]: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
    [
        [low[0].min(other_low[0]), low[1].min(other_low[1])],
        [high[0].max(other_high[0]), high[1].max(other_high[1])],
    ]
}

/// The error of a mechanism that could not make its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Stuck {
    /// The last frame that it reached, from 0.
    pub frame: usize,
    /// The number of frames of the film.
    pub frames: usize,
    /// The target of its motors.
    pub motors: Vec<(&'static str, f64)>,
    /// The error of the move.
    pub blocked: Blocked<Vec<f64>>,
}

impl fmt::Display for Stuck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { frame, frames, motors, blocked } = self;
        write!(f, "stuck at frame {frame} of {frames}, with ")?;
        for (motor, value) in motors {
            write!(f, "`{motor}` = {value:.4}, ")?;
        }
        write!(f, "because {blocked}")
    }
}

impl std::error::Error for Stuck {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        Some(&self.blocked)
    }
}
