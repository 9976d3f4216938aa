//! Shapes that stand for a part of a machine.

/// A part of a machine, or a text, in the frame of a link. Angles are in radians, counter-clockwise.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Figure {
    /// A toothed wheel.
    Gear {
        /// Its centre.
        center: [f64; 2],
        /// Its pitch radius; if none is given, the one with which the wheel meshes.
        radius: Option<f64>,
        /// The number of teeth.
        teeth: u32,
        /// The direction of its first tooth; if none is given, one in which the wheel meshes at the start.
        turned: Option<f64>,
    },
    /// The stand of a fixed pivot.
    Stand {
        /// The pivot.
        at: [f64; 2],
        /// The distance of the base below it; without, as on every other stand.
        height: Option<f64>,
        /// By how much it is turned about the pivot.
        turned: f64,
    },
    /// A straight rail, hatched on the right.
    Rail {
        /// Where it begins and ends.
        ends: [[f64; 2]; 2],
        /// Its width with its hatching; without, as every other rail.
        width: Option<f64>,
    },
    /// A zigzag from end to end.
    Spring {
        /// Where it begins and ends.
        ends: [[f64; 2]; 2],
        /// Its width.
        width: f64,
    },
    /// A text.
    Text {
        /// The lower left corner of its first letter.
        at: [f64; 2],
        /// The height of a capital letter.
        height: f64,
        /// The direction in which it is read.
        turned: f64,
        /// Its letters.
        text: String,
    },
}

impl Figure {
    /// Some of its points, and how far it reaches around them, as far as that is declared.
    pub(super) fn reach(&self) -> (&[[f64; 2]], f64) {
        match self {
            Self::Gear { center, radius, .. } => {
                (std::slice::from_ref(center), radius.unwrap_or(0.0))
            }
            Self::Stand { at, height, .. } => (std::slice::from_ref(at), height.unwrap_or(0.0)),
            Self::Rail { ends, width } => (ends, width.unwrap_or(0.0)),
            Self::Spring { ends, width } => (ends, 0.5 * width),
            Self::Text { at, height, .. } => (std::slice::from_ref(at), *height),
        }
    }
}
