//! Marks where a mechanism does not do what is expected of it: red, on the arcs of motors that turn.

use super::{Shown, area};
use crate::editor::Editor;
use eframe::egui::{self, Color32, Pos2, Role, Sense, Shape, Stroke, Vec2, WidgetInfo};

/// The radius of the arc that a motor's range is, in pixels.
const ARC: f32 = 20.0;

/// A mark reaches so far to both sides at least, in radians.
const HALF: f64 = 0.05;

/// A mark on the arc of a motor.
struct Mark {
    center: Pos2,
    /// The value of the motor, in radians.
    angle: f64,
    /// The values for which the same does not hold.
    intervals: Vec<[f64; 2]>,
    place: Vec<(usize, f64)>,
    /// What does not hold there.
    text: String,
}

/// Shows all marks. A click on one moves the motors there.
pub(super) fn on_witnesses(editor: &mut Editor, shown: &Shown, ui: &egui::Ui) {
    let marks = marks(editor, shown);
    let red = Color32::from_rgb(210, 40, 30);
    for (number, mark) in marks.into_iter().enumerate() {
        let place = on_arc(mark.center, mark.angle);
        let response =
            ui.interact(area(place, ui), ui.scope_id().with(("witness", number)), Sense::click());
        let playing = &editor.sight.playing;
        let way = mark.intervals.iter().map(|[low, high]| {
            let [low, high] = [low, high].map(|end| end.to_degrees());
            format!(", from {low:.1}° to {high:.1}°")
        });
        let way: String = way.collect();
        let label = format!("Fails at {}{way}", playing.words_of(&mark.place));
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &label));
        let painter = ui.painter().with_clip_rect(shown.rect);
        let around = [mark.angle - HALF, mark.angle + HALF];
        for [low, high] in mark.intervals.into_iter().chain([around]) {
            let points = arc(mark.center, [low, high]);
            painter.add(Shape::line(points, Stroke::new(4.0, red)));
        }
        painter.circle_filled(place, 4.0, red);
        if response.on_hover_text(format!("{}\n{label}", mark.text)).clicked() {
            editor.sight.scrub_to(&mark.place);
        }
    }
}

fn marks(editor: &Editor, shown: &Shown) -> Vec<Mark> {
    let mut marks = Vec::new();
    let Some(drawing) = editor.sight.seen_drawing() else {
        return marks;
    };
    for (judged, _) in editor.analysis.unmet() {
        for place in &judged.places {
            for &(motor, value) in place {
                let range = editor.sight.playing.ranges.get(motor);
                let range = range.filter(|range| range.turns);
                let center = range.and_then(|range| drawing.place_of_joint(&range.name));
                marks.extend(center.map(|center| Mark {
                    center: shown.pixel(center),
                    angle: value,
                    intervals: judged.failing(motor).collect(),
                    place: place.clone(),
                    text: judged.text.lines().next().unwrap_or_default().to_owned(),
                }));
            }
        }
    }
    marks
}

/// Places on the arc of a motor, from one angle to another.
pub(super) fn arc(center: Pos2, [low, high]: [f64; 2]) -> Vec<Pos2> {
    let parts = (0_u32..=64).map(|part| low + (high - low) * f64::from(part) / 64.0);
    parts.map(|angle| on_arc(center, angle)).collect()
}

/// A place on the arc of a motor, by its angle in radians.
fn on_arc(center: Pos2, angle: f64) -> Pos2 {
    #[expect(clippy::cast_possible_truncation, reason = "a direction")]
    let [cos, sin] = [angle.cos(), angle.sin()].map(|part| part as f32);
    center + ARC * Vec2::new(cos, -sin)
}
