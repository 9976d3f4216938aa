//! The panels beside the drawing.

mod behind;
mod busy;
mod diagnoses;
mod field;
mod graph;
mod line;
mod motor;
mod play;
mod plots;
mod properties;
mod report;
mod shapes;
mod steps;
mod text;
mod tools;

pub(super) use busy::Busy;
use diagnoses::diagnoses;
pub(super) use line::Line;
pub(super) use play::play;
use plots::Plots;
use properties::properties;
use report::report;
use steps::steps;
use text::TextPanel;
pub(super) use tools::tools;

use super::Editor;
use super::action::help;
use super::settings::Panel;
use eframe::egui;

/// All panels beside the drawing, one of which is seen.
#[derive(Default)]
pub(super) struct Panels {
    text: TextPanel,
    plots: Plots,
}

impl Panels {
    pub(super) fn show(&mut self, editor: &mut Editor, is_narrow: bool, ui: &mut egui::Ui) {
        tabs(editor, is_narrow, ui);
        ui.separator();
        match editor.settings.panel {
            Some(Panel::Text) => self.text.show(editor, ui),
            Some(Panel::Properties) => properties(editor, ui),
            Some(Panel::Diagnoses) => diagnoses(editor, ui),
            Some(Panel::Plots) => self.plots.show(editor, ui),
            Some(Panel::Report) => report(&editor.analysis, ui),
            Some(Panel::Steps) => steps(editor, ui),
            Some(Panel::Help) => help(ui),
            None => {}
        }
    }
}

/// The names of all panels, to choose one.
fn tabs(editor: &mut Editor, is_narrow: bool, ui: &mut egui::Ui) {
    let count = editor.analysis.snapshot.messages().len();
    ui.horizontal_wrapped(|ui| {
        for panel in Panel::ALL {
            let name = match panel {
                Panel::Diagnoses if count > 0 => format!("{} ({count})", panel.name()),
                _ => panel.name().to_owned(),
            };
            let is_chosen = editor.settings.panel == Some(panel);
            if ui.selectable_label(is_chosen, name).clicked() {
                // Where there is little room, the one that is seen is closed.
                editor.settings.panel = (!is_chosen || !is_narrow).then_some(panel);
            }
        }
    });
}
