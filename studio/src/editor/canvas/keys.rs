//! The arrow keys in the drawing.

use super::{Canvas, Spot};
use crate::editor::drawing::Handle;
use crate::editor::snap::{REACH, Snapping, grid};
use crate::editor::{Editor, Tool};
use eframe::egui;

impl Canvas {
    /// Points by the keys with arrows, and picks or selects by Enter.
    pub(super) fn by_keys(&mut self, editor: &mut Editor, paper: Spot<'_>) {
        let (shown, ui) = (paper.shown, paper.ui);
        let unit = grid(shown.scale());
        let ([x, y], is_far) = arrows(ui);
        let unit = if is_far { 10.0 * unit } else { unit };
        self.cross[0] += x * unit;
        self.cross[1] += y * unit;
        keep_arrows(paper);
        let pick = Snapping {
            drawing: editor.sight.drawing(),
            scale: shown.scale(),
            is_on: true,
            angles_from: None,
            snaps_to_bars: true,
            without: &[],
        }
        .snap(self.cross);
        self.snapped = Some(pick.clone());
        if ui.input(|input| input.key_pressed(egui::Key::Enter)) {
            if editor.picking.tool == Tool::Select {
                let found = editor.sight.seen_drawing();
                let item =
                    found.and_then(|drawing| drawing.item_at(self.cross, REACH / shown.scale()));
                editor.select(item, false);
            } else {
                editor.pick(pick.pick);
            }
        }
    }
}

/// Moves a handle by the keys with arrows: by a line of the grid, with Shift by ten.
pub(super) fn step_by_keys(editor: &mut Editor, handle: Handle, spot: Spot<'_>) {
    let unit = grid(spot.shown.scale());
    let (steps, is_far) = arrows(spot.ui);
    if steps != [0.0, 0.0] {
        let unit = if is_far { 10.0 * unit } else { unit };
        let to =
            [0, 1].map(|part| ((handle.place[part] + steps[part] * unit) / unit).round() * unit);
        let to = [0, 1].map(|part| if steps[part] == 0.0 { handle.place[part] } else { to[part] });
        editor.begin_drag(handle.item, false);
        editor.drag_to(to);
        editor.end_drag();
    }
    keep_arrows(spot);
}

/// The steps that keys with arrows ask for, to the right and up; and whether these are long.
fn arrows(ui: &egui::Ui) -> ([f64; 2], bool) {
    ui.input(|input| {
        let count = |key| f64::from(u32::from(input.key_pressed(key)));
        let x = count(egui::Key::ArrowRight) - count(egui::Key::ArrowLeft);
        let y = count(egui::Key::ArrowUp) - count(egui::Key::ArrowDown);
        ([x, y], input.modifiers.shift)
    })
}

/// Lets keys with arrows not move the focus.
fn keep_arrows(Spot { response, ui, .. }: Spot<'_>) {
    let filter = egui::EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..egui::EventFilter::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
}
