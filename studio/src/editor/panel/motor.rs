//! The motor of a joint, and its start.

use super::field::field;
use crate::document::Listing;
use crate::edit::Command;
use crate::editor::sight::Sight;
use crate::motion::Basis;
use eframe::egui;

/// The motor of a joint: how far it goes, by how much at once, and its law.
pub(super) fn motor(
    sight: &Sight,
    listing: &Listing,
    joint: &str,
    ui: &mut egui::Ui,
    commands: &mut Vec<Command>,
) {
    if !sight.has_motor(joint) {
        start(listing, joint, ui, commands);
        return;
    }
    ui.strong("Motor");
    if listing.number(joint, "low").is_none() {
        let mut ranges = sight.playing.ranges.iter();
        let range = ranges.find(|range| range.name == joint);
        let walked = range.filter(|range| range.basis == Basis::Walked);
        let hint = walked.map_or_else(
            || "0 deg ..= 90 deg".to_owned(),
            |range| {
                let shown = |end| crate::text::shortest(range.shown(end), 0.5);
                let unit = if range.turns { " deg" } else { "" };
                let [low, high] = range.ends.map(shown);
                format!("{low}{unit} ..= {high}{unit}")
            },
        );
        field(ui, &format!("range of {joint}"), "range", "", |typed| {
            let (low, high) = typed.split_once("..=").unwrap_or((&typed, ""));
            commands.push(Command::Motor {
                joint: joint.to_owned(),
                law: None,
                range: Some([low.trim().to_owned(), high.trim().to_owned()]),
                step: None,
            });
        });
        ui.weak(format!("to be proved free, for example: {hint}"));
    }
    field(ui, &format!("law of {joint}"), "law", "", |typed| {
        commands.push(Command::Motor {
            joint: joint.to_owned(),
            law: Some(typed),
            range: None,
            step: None,
        });
    });
    ui.weak("its value by the time t, for example: 0.5 * sin(2 * PI * t)");
    start(listing, joint, ui, commands);
}

/// Where a joint starts, if the text does not say it yet; else that is among its numbers.
fn start(listing: &Listing, joint: &str, ui: &mut egui::Ui, commands: &mut Vec<Command>) {
    if listing.number(joint, "start").is_some() {
        return;
    }
    field(ui, &format!("start of {joint}"), "start", "", |typed| {
        commands.push(Command::Start {
            name: joint.to_owned(),
            is_near: false,
            value: typed,
        });
    });
}
