//! The canvas: what is drawn, and what the pointer does to it.

mod keys;
mod paint;
mod picture;
mod witness;

use super::drawing::{Drawing, Handle, Hit};
use super::index::HandleKind;
use super::snap::{REACH, Snapped, Snapping};
use super::tool::Pick;
use super::{Editor, Item, Tool};
use crate::play::{Camera, Control};
use eframe::egui::{self, PointerButton, Pos2, Rect, Response, Role, Sense, Vec2, WidgetInfo};
use keys::step_by_keys;
use paint::Paint;
use picture::Picture;
use witness::on_witnesses;

#[derive(Default)]
pub(super) struct Canvas {
    picture: Picture,
    /// Where the pointer means, while a tool is used or something is dragged.
    snapped: Option<Snapped>,
    holds: Holds,
    /// Where the keyboard points, in the scene.
    cross: [f64; 2],
    /// Whether the drawing, or something in it, has the focus of keys.
    pub(super) is_focused: bool,
    /// The tool with which the pointer was pressed last: what it is released with may be another.
    pressed_with: Tool,
}

/// The thing that the pointer has taken hold of.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
enum Holds {
    #[default]
    Nothing,
    Link,
    Paper,
    /// A corner of a frame around what is to be selected.
    Frame(Pos2),
    /// A joint or a point, which is so far from the pointer.
    Thing([f64; 2]),
}

/// Where something happens: on the paper, or on a handle of it.
#[derive(Clone, Copy)]
struct Spot<'s> {
    response: &'s Response,
    handle: Option<Handle<'s>>,
    shown: &'s Shown,
    ui: &'s egui::Ui,
}

impl Canvas {
    /// Shows what is drawn, and takes what the pointer does.
    pub(super) fn show(&mut self, editor: &mut Editor, ui: &mut egui::Ui) {
        let rect = ui.available_rect_before_wrap();
        let background = ui.allocate_rect(rect, Sense::click_and_drag());
        background.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "drawing"));
        editor.sight.camera.resize(size_of(rect));
        zoom(&mut editor.sight.camera, &background, ui);
        if ui.input(|input| input.pointer.any_pressed()) {
            self.pressed_with = editor.picking.tool;
        }
        let shown = Shown { rect, camera: editor.sight.camera.clone() };
        self.picture.show(editor, &shown, ui);
        let drawing = editor.sight.seen_drawing().cloned();
        let handles = drawing.iter().flat_map(Drawing::handles);
        Paint { editor, shown: &shown, snapped: self.snapped.as_ref() }.behind(ui);
        let paper = Spot { response: &background, handle: None, shown: &shown, ui };
        self.on_paper(editor, paper);
        self.is_focused = background.has_focus();
        if background.has_focus() {
            self.by_keys(editor, paper);
        }
        let mut hovered = None;
        for handle in handles.clone() {
            self.on_handle(editor, handle, &shown, ui, &mut hovered);
        }
        on_witnesses(editor, &shown, ui);
        let under_text = editor.selection.under_text.clone();
        editor.selection.hovered = hovered.or(under_text);
        Paint { editor, shown: &shown, snapped: self.snapped.as_ref() }.front(ui, handles);
        if let Holds::Frame(corner) = self.holds
            && let Some(pointer) = background.interact_pointer_pos()
        {
            let frame = Rect::from_two_pos(corner, pointer);
            let color = ui.visuals().selection.stroke.color;
            ui.painter().rect_stroke(
                frame,
                0.0,
                egui::Stroke::new(1.0, color),
                egui::StrokeKind::Middle,
            );
        }
    }

    /// Handles the pointer beside the handles.
    fn on_paper(&mut self, editor: &mut Editor, paper: Spot<'_>) {
        let modifiers = paper.ui.input(|input| input.modifiers);
        if editor.picking.tool != Tool::Select {
            self.holds = Holds::Nothing;
            self.use_tool(editor, paper);
            return;
        }
        self.snapped = None;
        self.drag(editor, paper);
        if paper.response.clicked()
            && let Some(pointer) = paper.response.interact_pointer_pos()
        {
            let place = paper.shown.place(pointer);
            let reach = REACH / paper.shown.scale();
            let drawing = editor.sight.seen_drawing();
            let item = drawing.and_then(|drawing| drawing.item_at(place, reach));
            editor.select(item, modifiers.shift || modifiers.command);
        }
    }

    /// Drags what was under the pointer when it was pressed. Since then it may have gone far, so that it began on something else.
    fn drag(&mut self, editor: &mut Editor, spot: Spot<'_>) {
        let (response, shown) = (spot.response, spot.shown);
        if let Some(origin) = spot.drag_origin() {
            self.holds = take_hold(editor, spot, origin);
        }
        let Some(pointer) = response.interact_pointer_pos() else {
            return;
        };
        match self.holds {
            Holds::Link => {
                let control = Control::Point(within(shown.rect, pointer));
                editor.sight.obey(control);
            }
            Holds::Paper => {
                let moved = response.drag_delta();
                editor.sight.camera.pan([moved.x, moved.y].map(f64::from));
            }
            Holds::Thing(away) => self.lead(editor, pointer, away, spot),
            Holds::Frame(_) | Holds::Nothing => {}
        }
        if !response.drag_stopped() {
            return;
        }
        match std::mem::take(&mut self.holds) {
            Holds::Link => editor.sight.obey(Control::Release),
            Holds::Frame(corner) => {
                let ends = [corner, pointer].map(|end| shown.place(end));
                if let Some(drawing) = editor.sight.seen_drawing() {
                    editor.selection.add_within(ends, drawing);
                }
            }
            Holds::Thing(_) => {
                self.snapped = None;
                editor.end_drag();
            }
            Holds::Paper | Holds::Nothing => {}
        }
    }

    /// Leads what is dragged to where the pointer means.
    fn lead(&mut self, editor: &mut Editor, pointer: Pos2, away: [f64; 2], spot: Spot<'_>) {
        let Some(moved) = editor.sight.drag.held().map(<[Item]>::to_vec) else {
            return;
        };
        let is_alt = spot.ui.input(|input| input.modifiers.alt);
        let snapping = Snapping {
            drawing: editor.sight.drawing(),
            scale: spot.shown.scale(),
            is_on: editor.settings.snaps != is_alt,
            angles_from: None,
            snaps_to_bars: false,
            without: &moved,
        };
        let [x, y] = spot.shown.place(pointer);
        let snapped = snapping.snap([x + away[0], y + away[1]]);
        let place = snapped.pick.place;
        self.snapped = Some(snapped);
        editor.drag_to(place);
    }

    /// Handles the pointer, the keyboard or a screen reader at a handle.
    fn on_handle(
        &mut self,
        editor: &mut Editor,
        handle: Handle,
        shown: &Shown,
        ui: &mut egui::Ui,
        hovered: &mut Option<Item>,
    ) {
        let center = shown.pixel(handle.place);
        let area = area(center, ui);
        let id = ui.scope_id().with(("handle", handle.item));
        let dragged = [ui.ctx().dragged_id(), ui.ctx().drag_stopped_id()];
        // A handle that is dragged out of the window must still learn that it is let go.
        if !shown.rect.intersects(area) && !dragged.contains(&Some(id)) {
            return;
        }
        let response = ui.interact(area, id, Sense::click_and_drag());
        let is_selected = editor.selection.items.contains(handle.item);
        response.widget_info(|| {
            WidgetInfo::selected(Role::Button, true, is_selected, handle.item.to_string())
        });
        if response.hovered() || response.has_focus() {
            *hovered = Some(handle.item.clone());
        }
        let spot = Spot { response: &response, handle: Some(handle), shown, ui };
        if editor.picking.tool == Tool::Select {
            self.select_or_drag(editor, handle, spot);
        } else {
            self.use_tool(editor, spot);
        }
        let is_locked = editor.desk.is_locked(handle.item);
        let response = response.on_hover_ui(|ui| {
            ui.label(describe(handle));
            if is_locked {
                ui.label("locked");
            }
        });
        response.context_menu(|ui| menu(editor, handle, ui));
    }

    fn select_or_drag(&mut self, editor: &mut Editor, handle: Handle, spot: Spot<'_>) {
        let response = spot.response;
        let modifiers = spot.ui.input(|input| input.modifiers);
        self.drag(editor, spot);
        if response.clicked() {
            editor.select(Some(handle.item.clone()), modifiers.shift || modifiers.command);
            response.request_focus();
        }
        if response.has_focus() {
            self.is_focused = true;
            step_by_keys(editor, handle, spot);
        }
    }

    /// Picks places with a tool: by clicks, or from where the pointer is pressed to where it is released.
    fn use_tool(&mut self, editor: &mut Editor, spot: Spot<'_>) {
        let Spot { response, handle, shown, ui } = spot;
        let modifiers = ui.input(|input| input.modifiers);
        let meant = |editor: &Editor, place: [f64; 2]| {
            let before = editor.picking.picks.last().filter(|_| modifiers.shift);
            let snapping = Snapping {
                drawing: editor.sight.drawing(),
                scale: shown.scale(),
                is_on: editor.settings.snaps != modifiers.alt,
                angles_from: before.map(|pick| pick.place),
                snaps_to_bars: true,
                without: &[],
            };
            snapping.snap(place)
        };
        if let Some(origin) = spot.drag_origin() {
            let pick = meant(editor, shown.place(origin)).pick;
            // A tool that picks one place takes the one where the pointer is released.
            if editor.picking.tool.picks().len() > 1 {
                editor.pick(pick);
            }
        }
        let pointer = response.hover_pos().or(response.interact_pointer_pos());
        if let Some(pointer) = pointer {
            self.snapped = Some(meant(editor, shown.place(pointer)));
        }
        let is_by_pointer = response.drag_stopped() || response.clicked_by(PointerButton::Primary);
        if is_by_pointer && self.pressed_with != editor.picking.tool {
            return;
        }
        if is_by_pointer || response.clicked() {
            let pick = match (response.interact_pointer_pos().or(pointer), handle) {
                (Some(pointer), _) if is_by_pointer => {
                    Some(meant(editor, shown.place(pointer)).pick)
                }
                // By the keyboard, or by a reader.
                (_, Some(handle)) => Some(meant(editor, handle.place).pick),
                // By the keyboard on the paper: it picks at its cross.
                (_, None) => None,
            };
            if let Some(pick) = pick {
                editor.pick(pick);
            }
        }
    }
}

impl Spot<'_> {
    /// Where the pointer was pressed, if it is dragged from now on.
    fn drag_origin(&self) -> Option<Pos2> {
        let origin = self.ui.input(|input| input.pointer.press_origin());
        origin.filter(|_| self.response.drag_started())
    }
}

/// Takes hold of what is at the place where the pointer was pressed.
fn take_hold(editor: &mut Editor, spot: Spot<'_>, origin: Pos2) -> Holds {
    let (shown, ui) = (spot.shown, spot.ui);
    let modifiers = ui.input(|input| input.modifiers);
    let place = shown.place(origin);
    if spot.response.drag_started_by(PointerButton::Primary) {
        let own = spot.handle.filter(|handle| area(shown.pixel(handle.place), ui).contains(origin));
        let thing = own.map(|handle| handle.item.clone());
        let near = |reach: f64| {
            let drawing = editor.sight.seen_drawing()?;
            let hit = drawing.hit(place, reach / shown.scale());
            Some((drawing.item_of(&hit), hit))
        };
        if modifiers.command && editor.player().is_some() && near(reach(ui)).is_some() {
            // It is played, and not drawn elsewhere.
            editor.sight.hold(within(shown.rect, origin));
            return Holds::Link;
        }
        let thing = thing.or_else(|| match near(reach(ui))? {
            (item, Hit::Joint(_) | Hit::Axis(_)) => item,
            _ => None,
        });
        if let Some(item) = thing {
            // An item that moves with the selection leaves the selection as it is.
            if !editor.selection.moves(&item, editor.sight.drawing()) {
                editor.select(Some(item.clone()), modifiers.shift);
            }
            editor.begin_drag(&item, modifiers.alt);
            return Holds::Thing([0.0; 2]);
        }
        if let Some((_, Hit::Link(link))) = near(REACH) {
            let drawing = editor.sight.drawing();
            let handle_of = |drawing| editor.selection.handle_of(link, drawing, &editor.desk);
            if let Some((item, at)) = drawing.and_then(handle_of) {
                editor.begin_drag(&item, false);
                return Holds::Thing([at[0] - place[0], at[1] - place[1]]);
            }
            if editor.player().is_some() {
                editor.sight.hold(within(shown.rect, origin));
                return Holds::Link;
            }
        }
    }
    if modifiers.shift { Holds::Frame(origin) } else { Holds::Paper }
}

/// Returns the distance in pixels within which the pointer takes hold of a handle: for a finger twice as much.
fn reach(ui: &egui::Ui) -> f64 {
    if ui.input(egui::InputState::any_touches) { 2.0 * REACH } else { REACH }
}

/// Where a handle can be taken hold of.
fn area(center: Pos2, ui: &egui::Ui) -> Rect {
    #[expect(clippy::cast_possible_truncation, reason = "a few pixels")]
    let side = 2.0 * reach(ui) as f32;
    Rect::from_center_size(center, Vec2::splat(side))
}

/// Magnifies by the wheel or by two fingers, and moves the paper by two fingers.
fn zoom(camera: &mut Camera, background: &Response, ui: &egui::Ui) {
    let Some(pointer) = ui.input(|input| input.pointer.hover_pos()) else {
        return;
    };
    if !background.rect.contains(pointer)
        || ui.ctx().layer_id_at(pointer).is_some_and(|layer| layer != ui.layer_id())
    {
        return;
    }
    let (factor, scrolled) = ui.input(|input| (input.zoom_delta(), input.smooth_scroll_delta()));
    let factor = f64::from(factor) * f64::from(scrolled.y / 200.0).exp();
    if factor != 1.0 {
        let [x, y] = within(background.rect, pointer);
        camera.zoom([x, y], factor);
    }
    if let Some(touch) = ui.input(egui::InputState::multi_touch) {
        let [x, y] = <[f32; 2]>::from(touch.translation_delta).map(f64::from);
        camera.pan([x, y]);
    }
}

fn menu(editor: &mut Editor, handle: Handle, ui: &mut egui::Ui) {
    ui.strong(handle.item.to_string());
    for tool in [Tool::Motor, Tool::Pivot, Tool::Trace, Tool::Force] {
        if ui.button(tool.name()).on_hover_text(tool.help()).clicked() {
            let place = handle.place;
            let drawing = editor.sight.drawing();
            let hit = drawing.and_then(|drawing| drawing.hit_of(handle.item));
            let hit = hit.unwrap_or(Hit::Paper);
            editor.choose(tool);
            editor.pick(Pick { place, hit });
            editor.picking.tool = Tool::Select;
            ui.close();
        }
    }
    if ui.button("Properties").clicked() {
        editor.select(Some(handle.item.clone()), false);
        editor.settings.panel = Some(super::settings::Panel::Properties);
        ui.close();
    }
    if ui.button("Delete").clicked() {
        editor.select(Some(handle.item.clone()), false);
        editor.remove_selected();
        ui.close();
    }
}

fn describe(handle: Handle) -> String {
    let what = match handle.kind {
        HandleKind::Pin => "turns",
        HandleKind::Slide => "slides",
        HandleKind::Weld => "is welded",
        HandleKind::Point => "no joint is here",
        HandleKind::Line => "no joint is on this line",
    };
    let [x, y] = handle.place.map(|part| crate::text::shortest(part, 1e-3));
    format!("{}: {what}; ({x}, {y})", handle.item)
}

/// Where the scene is seen.
pub(super) struct Shown {
    rect: Rect,
    camera: Camera,
}

impl Shown {
    /// Pixels in a scene unit.
    fn scale(&self) -> f64 {
        self.camera.view().scale()
    }

    /// The place of the scene under a pixel of the window.
    fn place(&self, pixel: Pos2) -> [f64; 2] {
        self.camera.place(within(self.rect, pixel))
    }

    /// Where a place of the scene is seen in the window.
    #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
    fn pixel(&self, place: [f64; 2]) -> Pos2 {
        let [x, y] = self.camera.pixel(place);
        self.rect.min + Vec2::new(x as f32, y as f32)
    }
}

/// A pixel of the window, counted from the corner of the canvas.
fn within(rect: Rect, pixel: Pos2) -> [f64; 2] {
    let from = pixel - rect.min;
    [f64::from(from.x), f64::from(from.y)]
}

/// The size of the canvas, in points of the window.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a size in pixels, not below 1"
)]
fn size_of(rect: Rect) -> [usize; 2] {
    [rect.width(), rect.height()].map(|side| side.round().max(1.0) as usize)
}
