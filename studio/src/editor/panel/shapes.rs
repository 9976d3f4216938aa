//! The shapes of a link: what they are, their colours and planes.

use super::field::field;
use crate::edit::Command;
use crate::editor::drawing::Drawing;
use eframe::egui;
use mech_compiler::model::{Shape, ShapeKind};
use mech_core::colors::{EYE, NAMED, PAPER};
use mech_runtime::Palette;

/// The proposed text of a new shape.
const FIRST: &str = "circle (0, 0) radius 0.2 color teal";

/// The shapes of a link, each with what can be done to it, and a field for another.
pub(super) fn shapes(
    drawing: Option<&Drawing>,
    link: &str,
    ui: &mut egui::Ui,
    commands: &mut Vec<Command>,
) {
    let found = drawing.and_then(|drawing| Some((drawing, drawing.link(link)?)));
    let Some((drawing, id)) = found else {
        return;
    };
    ui.strong("Shapes");
    for (number, shape) in (1..).zip(&drawing.model.link(id).shapes) {
        row(link, number, shape, ui, commands);
    }
    field(ui, &format!("new shape of {link}"), "new", "", |typed| {
        commands.push(Command::Shape { link: link.to_owned(), shape: typed });
    });
    ui.weak(format!("for example: {FIRST}"));
}

fn row(link: &str, number: usize, shape: &Shape, ui: &mut egui::Ui, commands: &mut Vec<Command>) {
    let owner = || link.to_owned();
    ui.horizontal_wrapped(|ui| {
        ui.label(format!("{number} {}", word(&shape.kind)));
        let name = NAMED.iter().find(|(_, entry)| *entry == shape.color);
        let shown = name.map_or("another", |(name, _)| name);
        egui::ComboBox::from_id_salt(("color", link, number))
            .width(90.0)
            .selected_text(egui::RichText::new(shown).color(ui.visuals().text_color()))
            .show_ui(ui, |ui| {
                for (name, entry) in NAMED.iter().filter(|(_, entry)| ![PAPER, EYE].contains(entry))
                {
                    let [red, green, blue] = Palette::TEXTBOOK.rgb(*entry);
                    let text =
                        egui::RichText::new(*name).color(egui::Color32::from_rgb(red, green, blue));
                    if ui.selectable_label(*entry == shape.color, text).clicked() {
                        let color = (*name).to_owned();
                        commands.push(Command::Recolor { link: owner(), shape: number, color });
                    }
                }
            });
        for (text, help, plane) in [
            ("Nearer", "puts it on the next plane nearer to the eye", shape.plane + 1),
            ("Farther", "puts it on the next plane farther from the eye", shape.plane - 1),
        ] {
            let label = format!("{text} ({link} {number})");
            let response = ui.button(text).on_hover_text(help);
            response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, true, &label));
            if response.clicked() {
                let plane = plane.to_string();
                commands.push(Command::Layer { link: owner(), shape: number, plane });
            }
        }
        if ui.button("Remove").clicked() {
            commands.push(Command::RemoveShape { link: owner(), shape: number });
        }
        ui.weak(format!("plane {}", shape.plane));
    });
}

const fn word(kind: &ShapeKind) -> &'static str {
    match kind {
        ShapeKind::Circle { .. } => "circle",
        ShapeKind::Ring { .. } => "ring",
        ShapeKind::Bar { .. } => "bar",
        ShapeKind::Polygon(_) => "polygon",
        ShapeKind::Figure(_) => "figure",
    }
}
