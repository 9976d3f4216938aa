//! The compiler's report on the mechanism.

use super::graph::graph;
use crate::editor::analysis::Analysis;
use eframe::egui;
use mech_compiler::graphs;

/// The report: what the mechanism does; how each loop is solved, what is proved, what it costs; with the graphs of links and of loops.
pub(in crate::editor) fn report(analysis: &Analysis, ui: &mut egui::Ui) {
    let snapshot = &analysis.snapshot;
    let (Some(compiled), Some(reading)) = (snapshot.compiled(), &snapshot.reading) else {
        ui.weak("The mechanism does not move yet; see Diagnoses.");
        return;
    };
    egui::ScrollArea::vertical()
        .auto_shrink(false)
        .show(ui, |ui| {
            let part = |ui: &mut egui::Ui, title: &str, show: &mut dyn FnMut(&mut egui::Ui)| {
                egui::CollapsingHeader::new(title)
                    .default_open(true)
                    .show(ui, |ui| show(ui));
            };
            part(ui, "What it does", &mut |ui| match &analysis.motion {
                Some(lines) => lines.lines().for_each(|line| motion_line(line, ui)),
                None => {
                    ui.weak("It is measured.");
                }
            });
            part(
                ui,
                "Links and joints, which turn where nothing else is said",
                &mut |ui| {
                    graph(&graphs::kinematic(&reading.model, &compiled.structure), ui);
                },
            );
            let loops = graphs::loops(&reading.model, &compiled.plan);
            if !loops.edges.is_empty() {
                part(ui, "Loops, after what determines them", &mut |ui| {
                    graph(&loops, ui);
                });
            }
            let shared = graphs::common_joints(&reading.model, &compiled.plan);
            if !shared.edges.is_empty() {
                part(ui, "Loops with joints in common", &mut |ui| {
                    graph(&shared, ui);
                });
            }
            part(ui, "Methods, errors and operations", &mut |ui| {
                egui::ScrollArea::horizontal()
                    .id_salt("report")
                    .show(ui, |ui| {
                        let text = egui::RichText::new(&compiled.report).monospace();
                        ui.add(egui::Label::new(text).extend());
                    });
            });
        });
}

/// A line of what it does. What a motor drives stands under the motor.
fn motion_line(line: &str, ui: &mut egui::Ui) {
    let words: Vec<&str> = line.split_whitespace().collect();
    let text = words.join(" ");
    if line.starts_with("    ") {
        ui.indent(line, |ui| ui.label(text));
    } else {
        ui.label(text);
    }
}
