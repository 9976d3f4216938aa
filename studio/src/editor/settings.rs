//! What the user has chosen of the window.

use super::action::Dialog;
use super::panel::Panel;

/// What the user has chosen of the window.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Settings {
    /// Whether places snap to the grid and to what is near.
    pub(crate) snaps: bool,
    /// Whether the grid is seen.
    pub(crate) shows_grid: bool,
    /// Whether the names of joints are seen.
    pub(crate) shows_names: bool,
    /// Whether the bodies of links are seen.
    pub(crate) shows_bodies: bool,
    /// Whether the whole paths of traced points are seen.
    pub(crate) shows_paths: bool,
    /// Whether the velocities of points are seen, as arrows.
    pub(crate) shows_velocities: bool,
    /// Whether their accelerations are seen.
    pub(crate) shows_accelerations: bool,
    /// Whether the forces in joints are seen.
    pub(crate) shows_forces: bool,
    /// The panel beside the drawing; none if all are closed.
    pub(crate) panel: Option<Panel>,
    /// Whether something was drawn: then the view is the user's.
    pub(crate) has_begun: bool,
    /// Whether the window is dark.
    pub(crate) is_dark: bool,
    /// What is asked in a window of its own.
    pub(crate) dialog: Option<Dialog>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            snaps: true,
            shows_grid: true,
            shows_names: true,
            shows_bodies: true,
            shows_paths: true,
            shows_velocities: false,
            shows_accelerations: false,
            shows_forces: false,
            panel: Some(Panel::Text),
            has_begun: false,
            is_dark: false,
            dialog: None,
        }
    }
}
