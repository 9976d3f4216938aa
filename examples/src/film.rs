//! A motion, scene by scene, free of the type of its mechanism.

use mech_runtime::{Blocked, Canvas, Mechanism, Outline, Pose, Shape};
use std::fmt;

/// All that is seen at one moment, from back to front.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    shapes: Vec<(Shape<f64>, Pose<f64>)>,
}

impl Scene {
    /// Paints it.
    pub fn draw(&self, canvas: &mut impl Canvas<f64>) {
        for &(shape, pose) in &self.shapes {
            canvas.fill(shape.outline, pose, shape.color);
        }
    }
}

impl Canvas<f64> for Scene {
    fn fill(&mut self, outline: Outline<f64>, pose: Pose<f64>, color: u8) {
        let link = 0; // the pose says where it is
        self.shapes.push((
            Shape {
                link,
                outline,
                color,
            },
            pose,
        ));
    }
}

/// One full motion of a mechanism.
#[derive(Clone, Debug, Default)]
pub struct Film {
    scenes: Vec<Scene>,
}

impl Film {
    /// Adds the mechanism as it stands now.
    pub fn take<M: Mechanism<Scalar = f64>>(&mut self, mechanism: &M) {
        let mut scene = Scene::default();
        mechanism.draw(&mut scene);
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
        let all = self.scenes.iter().flat_map(|scene| &scene.shapes);
        all.map(|(shape, pose)| shape.bounds(*pose))
            .filter(|(low, high)| low.iter().chain(high).all(|c| c.is_finite()))
            .map(|(low, high)| [low, high])
            .reduce(|[low, high], [other_low, other_high]| {
                [
                    [low[0].min(other_low[0]), low[1].min(other_low[1])],
                    [high[0].max(other_high[0]), high[1].max(other_high[1])],
                ]
            })
    }
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
