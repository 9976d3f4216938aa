//! What moves a joint, and where it starts.

use super::field::field;
use crate::edit::Command;
use crate::editor::range::Basis;
use crate::editor::{Editor, Gesture};
use eframe::egui;

/// The motor of a joint: how far it goes, by how much at once, and its law.
pub(super) fn motor(editor: &Editor, joint: &str, ui: &mut egui::Ui, gestures: &mut Vec<Gesture>) {
    let drawing = editor.drawing();
    if !drawing.is_some_and(|drawing| drawing.has_motor(joint)) {
        start(editor, joint, ui, gestures);
        return;
    }
    ui.strong("Motor");
    if editor
        .analysis
        .snapshot
        .listing
        .number(joint, "low")
        .is_none()
    {
        let range = editor
            .scene
            .playing
            .ranges
            .iter()
            .find(|range| range.name == joint);
        let walked = range.filter(|range| range.basis == Basis::Walked);
        let hint = walked.map_or_else(
            || "0 deg ..= 90 deg".to_owned(),
            |range| {
                let shown = |value: f64| {
                    let value = if range.turns {
                        value.to_degrees()
                    } else {
                        value
                    };
                    crate::text::shortest(value, 0.5)
                };
                let unit = if range.turns { " deg" } else { "" };
                let [low, high] = range.ends.map(shown);
                format!("{low}{unit} ..= {high}{unit}")
            },
        );
        field(ui, &format!("range of {joint}"), "range", "", |typed| {
            let (low, high) = typed.split_once("..=").unwrap_or((&typed, ""));
            gestures.push(
                Command::Motor {
                    joint: joint.to_owned(),
                    law: None,
                    range: Some([low.trim().to_owned(), high.trim().to_owned()]),
                    step: None,
                }
                .into(),
            );
        });
        ui.weak(format!("to be proved free, for example: {hint}"));
    }
    field(ui, &format!("law of {joint}"), "law", "", |typed| {
        gestures.push(
            Command::Motor {
                joint: joint.to_owned(),
                law: Some(typed),
                range: None,
                step: None,
            }
            .into(),
        );
    });
    ui.weak("its value by the time t, for example: 0.5 * sin(2 * PI * t)");
    start(editor, joint, ui, gestures);
}

/// Where a joint starts, if the text does not say it yet; else that is among its numbers.
fn start(editor: &Editor, joint: &str, ui: &mut egui::Ui, gestures: &mut Vec<Gesture>) {
    if editor
        .analysis
        .snapshot
        .listing
        .number(joint, "start")
        .is_some()
    {
        return;
    }
    field(ui, &format!("start of {joint}"), "start", "", |typed| {
        gestures.push(
            Command::Start {
                name: joint.to_owned(),
                is_near: false,
                value: typed,
            }
            .into(),
        );
    });
}
