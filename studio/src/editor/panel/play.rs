//! The bar with which a mechanism is played.

use crate::editor::range::MotorRange;
use crate::editor::sight::Sight;
use crate::editor::snapshot::Snapshot;
use crate::motion::Basis;
use crate::play::{Control, Layer, Selection};
use eframe::egui;

pub(in crate::editor) fn play(sight: &mut Sight, snapshot: &Snapshot, ui: &mut egui::Ui) {
    let Some(player) = sight.player() else {
        ui.horizontal_wrapped(|ui| {
            ui.weak(snapshot.verdict());
        });
        return;
    };
    let (plays, limit) =
        (player.plays(), player.limit().map(|limit| limit.sentence(player.mechanism())));
    let mut control = None;
    ui.horizontal_wrapped(|ui| {
        let mut button = |ui: &mut egui::Ui, text: &str, help: &str, what: Control| {
            let response = ui.button(text).on_hover_text(help);
            if response.clicked() {
                control = Some(what);
            }
        };
        button(ui, "To start", "back to the start", Control::Reset);
        button(ui, "Step back", "one step back", Control::Step(-1.0));
        button(
            ui,
            if plays { "Pause" } else { "Play" },
            "plays, or pauses (Space)",
            Control::PlayOrPause,
        );
        button(ui, "Step", "one step forward", Control::Step(1.0));
        button(ui, "Reverse", "plays the other way", Control::Reverse);
        button(ui, "Slower", "half as fast", Control::Slower);
        button(ui, "Faster", "twice as fast", Control::Faster);
        motors(sight, ui);
        layers(sight, ui);
    });
    if let Some(limit) = limit {
        ui.colored_label(ui.visuals().error_fg_color, limit);
    }
    if let Some(control) = control {
        sight.obey(control);
    }
}

/// A slider for each motor, from one end of its range to the other.
fn motors(sight: &mut Sight, ui: &mut egui::Ui) {
    let Some(player) = sight.player() else {
        return;
    };
    let values = player.motors().to_vec();
    let driven = player.selection();
    let mut moved = None;
    for (motor, (range, value)) in sight.playing.ranges.iter().zip(values).enumerate() {
        if driven == Selection::Motor(motor) {
            ui.strong(">");
        }
        let value = range.shown(value);
        let mut at = value;
        let [low, high] = range.ends.map(|end| range.shown(end));
        // The value of a motor that turns without end is shown within its range.
        if range.basis == Basis::Round {
            at = low + (at - low).rem_euclid(360.0);
        }
        let slider = egui::Slider::new(&mut at, low..=high)
            .suffix(range.unit())
            // Values that nobody has changed stay as they are.
            .clamping(egui::SliderClamping::Edits)
            .custom_formatter(|value, _| format!("{value:.1}"))
            .text(format!("motor {}", range.name));
        let response = ui.add(slider).on_hover_text(told(range));
        if response.changed() {
            let whole = if range.basis == Basis::Round {
                value - (low + (value - low).rem_euclid(360.0))
            } else {
                0.0
            };
            moved = Some((motor, range.meant(at + whole)));
        }
    }
    if let Some((motor, value)) = moved {
        sight.scrub(motor, value);
    }
    if sight.playing.ranges.len() > 1 {
        let help = "plays the next motor alone; after the last, all";
        if ui.button("Next motor").on_hover_text(help).clicked() {
            sight.obey(Control::NextMotor);
        }
    }
}

fn told(range: &MotorRange) -> &'static str {
    match range.basis {
        Basis::Declared => "the declared range, proved to be free",
        Basis::Walked => "as far as the mechanism goes from the start",
        Basis::Round => "it goes round and round",
    }
}

/// Shows the switches of the layers besides the bodies.
fn layers(sight: &mut Sight, ui: &mut egui::Ui) {
    let Some(player) = sight.player() else {
        return;
    };
    let shown = player.layers();
    let mut toggled = None;
    ui.menu_button("Layers", |ui| {
        for layer in Layer::ALL {
            let mut is_shown = shown.has(layer);
            if ui.checkbox(&mut is_shown, layer.name()).changed() {
                toggled = Some(layer);
            }
        }
    });
    if let Some(layer) = toggled {
        sight.obey(Control::Toggle(layer));
    }
}
