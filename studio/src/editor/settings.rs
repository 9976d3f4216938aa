//! The user's settings of the window.

use crate::play::Derived;
use std::collections::BTreeSet;

/// Something in the drawing that can be hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Visible {
    Grid,
    Names,
    /// The bodies of links; without, the schematic.
    Bodies,
    Paths,
    Velocities,
    Accelerations,
    Forces,
    Centres,
    VelocityPolygon,
    AccelerationPolygon,
    FreeBodies,
    /// Of the links that are selected.
    InflectionCircles,
    /// Of the links that are selected.
    Centrodes,
}

impl Visible {
    /// What has to be computed for it besides positions.
    pub(crate) const fn derived(self) -> Option<Derived> {
        match self {
            Self::Velocities
            | Self::Accelerations
            | Self::Centres
            | Self::VelocityPolygon
            | Self::AccelerationPolygon
            | Self::InflectionCircles
            | Self::Centrodes => Some(Derived::Rates),
            Self::Forces | Self::FreeBodies => Some(Derived::Forces),
            Self::Grid | Self::Names | Self::Bodies | Self::Paths => None,
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Settings {
    /// Whether places snap to the grid and to what is near.
    pub(crate) snaps: bool,
    /// The kinds of marks that are visible beside the handles.
    pub(crate) visible: BTreeSet<Visible>,
    /// The panel beside the drawing; none if all are closed.
    pub(crate) panel: Option<Panel>,
    pub(crate) is_dark: bool,
}

impl Settings {
    pub(crate) fn shows(&self, what: Visible) -> bool {
        self.visible.contains(&what)
    }

    /// Shows something, or hides it if it is seen.
    pub(crate) fn toggle(&mut self, what: Visible) {
        if !self.visible.remove(&what) {
            self.visible.insert(what);
        }
    }
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            snaps: true,
            visible: [Visible::Grid, Visible::Names, Visible::Bodies, Visible::Paths].into(),
            panel: Some(Panel::Text),
            is_dark: false,
        }
    }
}

/// A panel beside the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Panel {
    Text,
    Properties,
    Diagnoses,
    Plots,
    Report,
    Steps,
    Help,
}

impl Panel {
    /// All panels, from left to right.
    pub(crate) const ALL: [Self; 7] = [
        Self::Text,
        Self::Properties,
        Self::Diagnoses,
        Self::Plots,
        Self::Report,
        Self::Steps,
        Self::Help,
    ];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Text => "Text",
            Self::Properties => "Properties",
            Self::Diagnoses => "Diagnoses",
            Self::Plots => "Plots",
            Self::Report => "Report",
            Self::Steps => "Steps",
            Self::Help => "Help",
        }
    }
}
