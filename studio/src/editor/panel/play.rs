//! The bar with which a mechanism is played.

use crate::editor::Editor;
use crate::editor::range::{Basis, MotorRange};
use crate::play::{Control, Layer, Selection};
use eframe::egui;

/// The bar with which a mechanism is played.
pub(in crate::editor) fn play(editor: &mut Editor, ui: &mut egui::Ui) {
    let Some(player) = editor.player() else {
        ui.horizontal_wrapped(|ui| {
            let line = editor.analysis.snapshot.verdict();
            ui.weak(line);
        });
        return;
    };
    let (plays, limit) = (
        player.plays(),
        player
            .limit()
            .map(|limit| limit.sentence(player.mechanism())),
    );
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
        motors(editor, ui);
        layers(editor, ui);
    });
    if let Some(limit) = limit {
        ui.colored_label(ui.visuals().error_fg_color, limit);
    }
    if let Some(control) = control {
        editor.scene.obey(control);
    }
}

/// A slider for each motor, from one end of its range to the other.
fn motors(editor: &mut Editor, ui: &mut egui::Ui) {
    let Some(player) = editor.player() else {
        return;
    };
    let values = player.motors().to_vec();
    let driven = player.selection();
    let mut moved = None;
    let mut next = false;
    for (motor, (range, value)) in editor.scene.playing.ranges.iter().zip(values).enumerate() {
        if driven == Selection::Motor(motor) {
            ui.strong(">");
        }
        let shown = |value: f64| {
            if range.turns {
                value.to_degrees()
            } else {
                value
            }
        };
        let mut at = shown(value);
        let [low, high] = range.ends.map(shown);
        // What goes on and on is shown within its range.
        if range.basis == Basis::Round {
            at = low + (at - low).rem_euclid(360.0);
        }
        let suffix = if range.turns { "°" } else { "" };
        let slider = egui::Slider::new(&mut at, low..=high)
            .suffix(suffix)
            // Values that nobody has changed stay as they are.
            .clamping(egui::SliderClamping::Edits)
            .custom_formatter(|value, _| format!("{value:.1}"))
            .text(format!("motor {}", range.name));
        let response = ui.add(slider).on_hover_text(told(range));
        if response.changed() {
            let turns = shown(value) - (low + (shown(value) - low).rem_euclid(360.0));
            let whole = if range.basis == Basis::Round {
                turns
            } else {
                0.0
            };
            let value = at + whole;
            moved = Some((
                motor,
                if range.turns {
                    value.to_radians()
                } else {
                    value
                },
            ));
        }
    }
    if editor.scene.playing.ranges.len() > 1
        && ui
            .button("Next motor")
            .on_hover_text("plays the next motor alone; after the last, all")
            .clicked()
    {
        next = true;
    }
    if let Some((motor, value)) = moved {
        editor.scene.scrub(motor, value);
    }
    if next {
        editor.scene.obey(Control::NextMotor);
    }
}

fn told(range: &MotorRange) -> &'static str {
    match range.basis {
        Basis::Proved => "the declared range, proved to be free",
        Basis::Walked => "as far as the mechanism goes from the start",
        Basis::Round => "it goes round and round",
    }
}

/// What is seen besides the bodies.
fn layers(editor: &mut Editor, ui: &mut egui::Ui) {
    let Some(player) = editor.player() else {
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
        editor.scene.obey(Control::Toggle(layer));
    }
}
