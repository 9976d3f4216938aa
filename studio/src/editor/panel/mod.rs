//! What stands beside the drawing.

mod diagnoses;
mod graph;
mod help;
mod line;
mod play;
mod plots;
mod properties;
mod report;
mod steps;
mod text;
mod tools;

pub(super) use diagnoses::diagnoses;
pub(super) use help::help;
pub(super) use line::Line;
pub(super) use play::play;
pub(super) use plots::Plots;
pub(super) use properties::properties;
pub(super) use report::report;
pub(super) use steps::steps;
pub(super) use text::text;
pub(super) use tools::tools;

use super::Editor;
use eframe::egui;

/// A panel beside the drawing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Panel {
    /// The text.
    Text,
    /// The numbers of what is selected.
    Properties,
    /// What is wrong, and what would mend it.
    Diagnoses,
    /// Graphs of what moves.
    Plots,
    /// What the compiler tells of the mechanism.
    Report,
    /// What can be undone.
    Steps,
    /// What can be done.
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

    /// Its name.
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

/// The names of all panels, to choose one.
pub(super) fn tabs(editor: &mut Editor, ui: &mut egui::Ui) {
    let count = editor.snapshot.messages().len();
    ui.horizontal_wrapped(|ui| {
        for panel in Panel::ALL {
            let name = match panel {
                Panel::Diagnoses if count > 0 => format!("{} ({count})", panel.name()),
                _ => panel.name().to_owned(),
            };
            let is_chosen = editor.settings.panel == Some(panel);
            if ui.selectable_label(is_chosen, name).clicked() {
                editor.settings.panel = Some(panel);
            }
        }
    });
}
