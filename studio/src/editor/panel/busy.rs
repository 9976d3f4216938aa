//! The bar that tells what is being done beside the window, and lets the user end it.

use crate::editor::Editor;
use eframe::egui;
use std::time::Duration;

/// Work is told when it has taken so many seconds.
const TOLD: f64 = 0.5;
/// When it has taken so many seconds, the user is asked whether it is to go on.
const BUDGET: f64 = 10.0;
/// The time after which the window is painted again, so that the seconds count.
const REPAINT: Duration = Duration::from_millis(250);

#[derive(Default)]
pub(in crate::editor) struct Busy {
    /// When the work began, in the window's seconds.
    since: Option<f64>,
    /// How often the user has let it go on: each time for twice as long.
    allowed: i32,
}

impl Busy {
    /// Shows the bar, if something takes its time, or was stopped.
    pub(in crate::editor) fn show(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let Some(work) = editor.analysis.works.last() else {
            *self = Self::default();
            if editor.analysis.is_stopped() {
                offer_analysis(editor, ui);
            }
            return;
        };
        ui.ctx().request_repaint_after(REPAINT);
        let now = ui.input(|input| input.time);
        let seconds = now - *self.since.get_or_insert(now);
        if seconds < TOLD {
            return;
        }
        let budget = BUDGET * 2.0_f64.powi(self.allowed);
        let (mut stops, mut goes_on) = (false, false);
        egui::Panel::bottom("busy").show(ui, |ui| {
            ui.horizontal_wrapped(|ui| {
                ui.spinner();
                if seconds < budget {
                    ui.label(format!("{work}: {seconds:.0} s"));
                } else {
                    ui.strong(format!("{work} takes longer than {budget:.0} s."));
                    goes_on = ui.button("Go on").clicked();
                }
                stops = ui.button("Stop").on_hover_text("ends it; what is seen stays").clicked();
            });
        });
        if stops {
            editor.stop();
        } else if goes_on {
            self.allowed += 1;
        }
    }
}

/// Offers to analyse a text whose analysis was stopped.
fn offer_analysis(editor: &mut Editor, ui: &mut egui::Ui) {
    let mut is_wanted = false;
    egui::Panel::bottom("busy").show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.label("The analysis was stopped; what is seen may be of an earlier text.");
            is_wanted = ui.button("Analyse").clicked();
        });
    });
    if is_wanted {
        editor.read();
    }
}
