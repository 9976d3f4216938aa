//! Layers of a mechanism that is played.

use super::Derived;

/// A part of the picture that can be switched on and off by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// The coloured shapes of the links, and traces.
    Shapes,
    /// The symbols of joints.
    Joints,
    /// Links as bars, pitch circles.
    Links,
    /// The declared points and lines.
    Axes,
    /// Arrows at the motors.
    Motors,
    /// The velocities of points.
    Velocities,
    /// Their accelerations.
    Accelerations,
}

impl Layer {
    /// All layers, from back to front.
    pub const ALL: [Self; 7] = [
        Self::Shapes,
        Self::Joints,
        Self::Links,
        Self::Axes,
        Self::Motors,
        Self::Velocities,
        Self::Accelerations,
    ];

    /// The name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Shapes => "shapes",
            Self::Joints => "joint symbols",
            Self::Links => "bars and pitch circles",
            Self::Axes => "axes",
            Self::Motors => "motors",
            Self::Velocities => "velocities",
            Self::Accelerations => "accelerations",
        }
    }

    /// What has to be computed for it besides positions.
    pub(crate) const fn derived(self) -> Option<Derived> {
        match self {
            Self::Velocities | Self::Accelerations => Some(Derived::Rates),
            _ => None,
        }
    }
}

/// The visible layers.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Layers {
    shown: [bool; Layer::ALL.len()],
}

impl Layers {
    /// The layers that are visible.
    pub fn shown(self) -> impl Iterator<Item = Layer> {
        Layer::ALL.into_iter().filter(move |layer| self.has(*layer))
    }

    /// These layers only.
    #[must_use]
    pub const fn of(layers: &[Layer]) -> Self {
        let mut shown = [false; Layer::ALL.len()];
        let mut index = 0;
        while index < layers.len() {
            shown[layers[index] as usize] = true;
            index += 1;
        }
        Self { shown }
    }

    /// Whether a layer is visible.
    #[must_use]
    pub const fn has(self, layer: Layer) -> bool {
        self.shown[layer as usize]
    }

    /// Shows or hides a layer.
    pub const fn toggle(&mut self, layer: Layer) {
        self.shown[layer as usize] = !self.has(layer);
    }
}

/// The style in which a mechanism is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Style {
    /// The visible layers.
    pub layers: Layers,
    /// The size of symbols relative to the usual one.
    pub size: f32,
    /// The length of the arrow for a velocity of one scene unit per second, in scene units.
    pub velocity: f64,
    /// The length of the arrow for an acceleration of one.
    pub acceleration: f64,
}
