//! By mouse and by finger.

use super::User;
use eframe::egui::{
    Event, Modifiers, PointerButton, Pos2, TouchDeviceId, TouchId, TouchPhase, Vec2,
};
use egui_kittest::kittest::Queryable;

impl User {
    /// Taps with a finger.
    pub(crate) fn tap(&mut self, at: Pos2) {
        self.touch(TouchPhase::Start, at);
        self.press(at);
        self.touch(TouchPhase::End, at);
        self.release(at);
        self.harness.event(Event::PointerGone);
        self.harness.run_steps(2);
        self.gestures += 1;
    }

    /// Taps what has this name.
    #[track_caller]
    pub(crate) fn tap_on(&mut self, label: &str) {
        let at = self.place_of(label).center();
        assert!(
            self.harness.ctx.content_rect().contains(at),
            "{label} is not in the window: {at:?}"
        );
        self.tap(at);
    }

    /// Moves a finger over the screen.
    pub(crate) fn swipe(&mut self, from: Pos2, to: Pos2) {
        self.touch(TouchPhase::Start, from);
        self.press(from);
        for part in [0.3, 0.7, 1.0] {
            let at = from + part * (to - from);
            self.touch(TouchPhase::Move, at);
            self.harness.event(Event::PointerMoved(at));
            self.harness.run_steps(1);
        }
        self.touch(TouchPhase::End, to);
        self.release(to);
        self.harness.event(Event::PointerGone);
        self.harness.run_steps(2);
        self.gestures += 1;
    }

    fn touch(&mut self, phase: TouchPhase, pos: Pos2) {
        self.harness.event(Event::Touch {
            device_id: TouchDeviceId(0),
            id: TouchId(0),
            phase,
            pos,
            force: None,
        });
    }

    pub(crate) fn click(&mut self, place: [f64; 2]) {
        self.mean(&[place]);
        self.click_at(self.pixel(place));
    }

    /// Clicks a place of the scene with Shift held.
    pub(crate) fn click_with_shift(&mut self, place: [f64; 2]) {
        self.modifiers = Modifiers::SHIFT;
        self.harness.event(Event::ModifiersChanged(self.modifiers));
        self.click_at(self.pixel(place));
        self.modifiers = Modifiers::NONE;
        self.harness.event(Event::ModifiersChanged(self.modifiers));
    }

    /// Drags what is at a place of the scene to another.
    pub(crate) fn move_handle(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.mean(&[to]);
        self.press_and_release(from, to);
    }

    /// Presses at one place of the scene, and releases at another.
    pub(crate) fn drag(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.mean(&[from, to]);
        self.press_and_release(from, to);
    }

    /// Presses at one place of the scene and goes to another, with the button still down.
    pub(crate) fn hold(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.mean(&[from, to]);
        let [from, to] = [from, to].map(|place| self.pixel(place));
        self.press_and_move(from, to);
    }

    /// Lets the button go at a place of the scene.
    pub(crate) fn let_go(&mut self, at: [f64; 2]) {
        let at = self.pixel(at);
        self.release(at);
    }

    fn press_and_release(&mut self, from: [f64; 2], to: [f64; 2]) {
        let [from, to] = [from, to].map(|place| self.pixel(place));
        self.press_and_move(from, to);
        self.release(to);
        self.gestures += 1;
    }

    /// Clicks near a place of the scene, without Alt.
    pub(crate) fn click_near(&mut self, place: [f64; 2]) {
        self.mean(&[]);
        self.click_at(self.pixel(place));
    }

    /// Presses as soon as the pointer arrives, and is far away before the next picture.
    pub(crate) fn rush(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.mean(&[from, to]);
        let [from, to] = [from, to].map(|place| self.pixel(place));
        let press = Event::PointerButton {
            pos: from,
            button: PointerButton::Primary,
            pressed: true,
            modifiers: self.modifiers,
        };
        // Events that are told one by one come in pictures of their own.
        let events = &mut self.harness.input_mut().events;
        events.extend([Event::PointerMoved(from), press, Event::PointerMoved(to)]);
        self.harness.run_steps(2);
        self.release(to);
        self.gestures += 1;
    }

    /// Presses and releases with these keys held: with Alt nothing snaps.
    pub(crate) fn drag_with(&mut self, held: Modifiers, from: [f64; 2], to: [f64; 2]) {
        self.harness.event(Event::ModifiersChanged(held));
        self.modifiers = held;
        self.press_and_release(from, to);
    }

    /// Places that are not on the grid are meant exactly: Alt is held.
    fn mean(&mut self, places: &[[f64; 2]]) {
        let is_on_grid = |part: &f64| (part * 5.0 - (part * 5.0).round()).abs() < 1e-9;
        let alt = !places.as_flattened().iter().all(is_on_grid);
        self.modifiers = if alt { Modifiers::ALT } else { Modifiers::NONE };
        self.harness.event(Event::ModifiersChanged(self.modifiers));
        self.harness.run_steps(1);
    }

    fn click_at(&mut self, at: Pos2) {
        self.press(at);
        self.release(at);
        self.gestures += 1;
    }

    fn press_and_move(&mut self, from: Pos2, to: Pos2) {
        self.press(from);
        for part in [0.3, 0.7, 1.0] {
            let at = from + part * (to - from);
            self.harness.event(Event::PointerMoved(at));
            self.harness.run_steps(1);
        }
    }

    fn press(&mut self, at: Pos2) {
        self.harness.event(Event::PointerMoved(at));
        self.harness.run_steps(1);
        self.button(at, true);
    }

    fn release(&mut self, at: Pos2) {
        self.button(at, false);
        self.harness.run_steps(2);
    }

    fn button(&mut self, pos: Pos2, pressed: bool) {
        self.harness.event(Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: self.modifiers,
        });
        self.harness.run_steps(1);
    }

    /// Clicks what has this name, at a part of its width and height.
    #[track_caller]
    pub(crate) fn click_within(&mut self, label: &str, parts: [f64; 2]) {
        let rect = self.harness.get_by_label(label).rect();
        #[expect(clippy::cast_possible_truncation, reason = "parts of a window")]
        let parts = parts.map(|part| part as f32);
        self.click_at(rect.min + Vec2::from(parts) * rect.size());
    }
}
