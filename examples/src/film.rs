//! A motion, scene by scene, free of the type of its mechanism.

use mech_runtime::{Blocked, Canvas, Outline, Pose, Shape};
use std::fmt;

/// All that is seen at one moment, from back to front.
#[derive(Clone, Debug)]
pub struct Scene {
    spots: Vec<Spot>,
    /// Pixels to a scene unit.
    scale: f64,
}

/// Something that is seen.
#[derive(Clone, Debug)]
enum Spot {
    /// A shape, and where it is.
    Shape(Shape<f64>, Pose<f64>),
    /// A polygon in the scene.
    Polygon(Vec<[f64; 2]>, u8),
}

impl Spot {
    /// The smallest upright box around it.
    fn bounds(&self) -> [[f64; 2]; 2] {
        match self {
            Self::Shape(shape, pose) => {
                let (low, high) = shape.bounds(*pose);
                [low, high]
            }
            Self::Polygon(corners, _) => {
                let corners = corners.iter().map(|&corner| [corner; 2]);
                corners.reduce(around).unwrap_or([[f64::NAN; 2]; 2])
            }
        }
    }
}

impl Scene {
    /// An empty scene that is to be seen with so many pixels to a scene unit.
    #[must_use]
    pub const fn new(scale: f64) -> Self {
        let spots = Vec::new();
        Self { spots, scale }
    }

    /// Paints it.
    pub fn draw(&self, canvas: &mut impl Canvas<f64>) {
        for spot in &self.spots {
            match spot {
                Spot::Shape(shape, pose) => canvas.fill(shape.outline, *pose, shape.color),
                Spot::Polygon(corners, color) => canvas.fill_polygon(corners, *color),
            }
        }
    }
}

impl Canvas<f64> for Scene {
    fn fill(&mut self, outline: Outline<f64>, pose: Pose<f64>, color: u8) {
        let link = 0; // the pose says where it is
        let shape = Shape {
            link,
            outline,
            color,
        };
        self.spots.push(Spot::Shape(shape, pose));
    }

    fn fill_polygon(&mut self, corners: &[[f64; 2]], color: u8) {
        self.spots.push(Spot::Polygon(corners.to_vec(), color));
    }

    fn scale(&self) -> f64 {
        self.scale
    }
}

/// One full motion of a mechanism.
#[derive(Clone, Debug)]
pub struct Film {
    scenes: Vec<Scene>,
    /// Pixels to a scene unit.
    scale: f64,
}

impl Film {
    /// An empty film that is to be seen with so many pixels to a scene unit. Infinitely many will do to find out how much there is
    /// to be seen: then what has a size in pixels takes no room.
    #[must_use]
    pub const fn new(scale: f64) -> Self {
        let scenes = Vec::new();
        Self { scenes, scale }
    }

    /// Adds a scene that is painted now.
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

    /// The smallest upright box around everything that is ever seen; `None` if nothing is.
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

/// A mechanism that could not go on with its motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Stuck {
    /// The frame it had last reached, from 0.
    pub frame: usize,
    /// The number of frames there should have been.
    pub frames: usize,
    /// What its motors were to be.
    pub motors: Vec<(&'static str, f64)>,
    /// What it had to say.
    pub blocked: Blocked<Vec<f64>>,
}

impl fmt::Display for Stuck {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            frame,
            frames,
            motors,
            blocked,
        } = self;
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
