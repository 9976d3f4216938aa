//! The picture behind the drawing: where it is, and how much of it is seen.

use crate::editor::Editor;
use crate::text::masked;
use eframe::egui;

/// The picture behind the drawing, if there is one.
pub(super) fn behind(editor: &mut Editor, ui: &mut egui::Ui) {
    let places = editor.selection.places(editor.sight.drawing());
    let Some(backdrop) = &mut editor.desk.backdrop else {
        return;
    };
    let name = backdrop.path.file_name().unwrap_or_default();
    ui.separator();
    ui.heading(masked(&format!("picture {}", name.display())));
    let before = backdrop.place;
    let place = &mut backdrop.place;
    let step = 0.005 * place.width;
    egui::Grid::new("picture behind")
        .num_columns(2)
        .show(ui, |ui| {
            let [x, y] = &mut place.center;
            for (name, value) in [("x", x), ("y", y), ("width", &mut place.width)] {
                let least = if name == "width" {
                    f64::MIN_POSITIVE
                } else {
                    f64::MIN
                };
                let field = egui::DragValue::new(value)
                    .speed(step)
                    .range(least..=f64::MAX);
                number(name, field, ui);
            }
            let angle = egui::DragValue::new(&mut place.angle)
                .suffix("°")
                .speed(0.2);
            number("angle", angle, ui);
            let opacity = egui::DragValue::new(&mut place.opacity);
            number("opacity", opacity.range(0.0..=1.0).speed(0.01), ui);
        });
    if !backdrop.place.is_sound() {
        backdrop.place = before;
    }
    if let Some([from, to]) = places
        && let Some(factor) = factor_of(from, to, ui)
    {
        backdrop.place.scale_about(from, factor);
    }
    if ui.button("Remove the picture").clicked() {
        editor.desk.backdrop = None;
    }
}

fn number(name: &str, field: egui::DragValue<'_>, ui: &mut egui::Ui) {
    let label = ui.label(name);
    ui.add(field).labelled_by(label.id);
    ui.end_row();
}

/// Asks how far apart two places are in truth. Returns by which factor they are farther apart.
fn factor_of([x, y]: [f64; 2], [u, v]: [f64; 2], ui: &mut egui::Ui) -> Option<f64> {
    let drawn = (u - x).hypot(v - y);
    let mut value = drawn;
    ui.horizontal(|ui| {
        let label = ui.label("distance in it");
        let field = egui::DragValue::new(&mut value)
            .range(f64::MIN_POSITIVE..=f64::MAX)
            .update_while_editing(false)
            .max_decimals(6)
            .speed(0.0);
        ui.add(field)
            .labelled_by(label.id)
            .on_hover_text("how far apart the two selected places of the picture are in truth");
    });
    let factor = value / drawn;
    let is_changed = (value - drawn).abs() > 1e-6 * drawn;
    (is_changed && factor.is_finite() && factor > 0.0).then_some(factor)
}
