//! A bar at the top of the window, with a question.

use eframe::egui;

/// Shows a question with its answers, and gives the number of the one that is clicked.
pub(super) fn bar(
    name: &str,
    question: &str,
    answers: [&str; 2],
    ui: &mut egui::Ui,
) -> Option<usize> {
    let mut given = None;
    egui::Panel::top(name.to_owned()).show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            ui.strong(question);
            for (number, answer) in answers.into_iter().enumerate() {
                if ui.button(answer).clicked() {
                    given = Some(number);
                }
            }
        });
    });
    given
}
