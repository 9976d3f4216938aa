//! The outlines and symbols of a mechanism: declared shapes, and bodies for links that declare none.
//!
//! `machine` gives every link a body that is made from what it carries. All outlines are constants of the generated code; only springs
//! and dampers are painted anew in each position.

mod body;
mod cam;
mod cylinder;
mod declared;
mod figure;
mod footprint;
mod ground;
mod hull;
mod machine;
mod outline;
mod planes;
mod rolling;
mod scene;
mod survey;
mod tooth;
mod wheel;

use crate::compiled::Compiled;
use crate::model::{LinkId, Look, Measure, Model, Shape, ShapeKind};
use crate::motion::extent::extent;
use crate::symbols::{Symbol, spots};
pub use outline::{Outline, Painted, Points, Toothed};
use scene::Scene;
use wheel::Wheels;

/// A spring or damper may reach so many pixels beyond its ends.
const BESIDE_PIXELS: f64 = 18.0;

/// The outlines and symbols that are painted of a mechanism.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Looks {
    /// The outlines of the ground and of all links whose poses are known, from the plane farthest from the eye to the nearest. Within
    /// a plane the ground's come first, then those of each link, in the order of declaration.
    pub painted: Vec<Painted>,
    /// The symbols that are painted over them anew in each position, of a size in scene units.
    pub symbols: Option<Symbols>,
}

/// Symbols that are painted over all outlines.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Symbols {
    /// The whole diagram, with lines and symbols of a size in pixels.
    Diagram,
    /// Springs and dampers.
    Elastic {
        /// The symbols.
        symbols: Vec<Symbol>,
        /// The size of one of their pixels, in scene units.
        unit: f64,
    },
}

impl Looks {
    /// The smallest upright box around all that is seen, wherever the motors move it: lower left and upper right corner, in scene units.
    #[must_use]
    pub fn extent(&self, model: &Model, compiled: &Compiled) -> [[f64; 2]; 2] {
        let reaches = self.reaches(model);
        extent(model, &compiled.plan, &compiled.program, &reaches)
    }

    /// The number of outlines that are painted before a trace: those of planes farther from the eye, and the ground's of its own; without
    /// a plane, those before the first of a moving link.
    #[must_use]
    pub fn behind(&self, plane: Option<i32>) -> usize {
        let is_behind = |painted: &&Painted| {
            let is_ground = painted.link == LinkId::GROUND;
            plane.map_or(is_ground, |plane| {
                painted.plane < plane || (painted.plane == plane && is_ground)
            })
        };
        self.painted.iter().take_while(is_behind).count()
    }

    /// For each link some points of what is seen of it at the start, each with how far that reaches around it.
    fn reaches(&self, model: &Model) -> Vec<Vec<([f64; 2], f64)>> {
        let mut all = vec![Vec::new(); model.links.len()];
        for painted in &self.painted {
            all[painted.link.index()].extend(painted.points());
        }
        for trace in &model.traces {
            let point = model.axis(trace.point);
            all[point.link.index()].push((point.at, 0.0));
        }
        if let Some(Symbols::Elastic { symbols, unit }) = &self.symbols {
            for spot in symbols.iter().flat_map(spots) {
                all[spot.link.index()].push((spot.at.map(Measure::at_start), BESIDE_PIXELS * unit));
            }
        }
        all
    }
}

/// Finds the outlines and symbols of a coherent mechanism.
#[must_use]
pub fn looks(model: &Model, compiled: &Compiled) -> Looks {
    let look = model.look();
    let links = std::iter::once(LinkId::GROUND).chain(compiled.program.stored.iter().copied());
    let shapes = links.flat_map(|link| {
        let shapes = model.link(link).shapes.iter();
        shapes.map(move |shape| (link, shape))
    });
    let shapes: Vec<(LinkId, &Shape)> = shapes.collect();
    let has_figures = shapes.iter().any(|(_, shape)| matches!(shape.kind, ShapeKind::Figure(_)));
    // The scene depends on how the mechanism moves.
    let scene = (look == Look::Machine || has_figures).then(|| Scene::new(model, compiled));
    let scene = scene.as_ref().map(|scene| (scene, Wheels::new(scene)));
    let outlines = shapes.into_iter().flat_map(|(link, shape)| match (&shape.kind, &scene) {
        (ShapeKind::Figure(figure), Some((scene, wheels))) => {
            figure::outlines(scene, wheels, link, shape, figure)
        }
        _ => declared::outlines(link, shape),
    });
    let mut painted: Vec<Painted> = outlines.collect();
    let mut symbols = None;
    if look == Look::Diagram {
        symbols = Some(Symbols::Diagram);
    }
    if let (Look::Machine, Some((scene, wheels))) = (look, &scene) {
        let (bodies, springs) = machine::machine(scene, wheels);
        painted.extend(bodies);
        symbols = springs;
    }
    // Stable: within a plane the order of links and of their declarations stays.
    painted.sort_by_key(|painted| (painted.plane, painted.link));
    Looks { painted, symbols }
}
