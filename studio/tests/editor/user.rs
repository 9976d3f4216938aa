//! Somebody who uses the studio, and counts the gestures.

use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use mech_studio::Workspace;
use mech_studio::editor::{Editor, Studio};

/// Somebody who uses the studio, and counts the gestures.
pub(crate) struct User {
    harness: Harness<'static, Studio>,
    gestures: usize,
}

impl User {
    /// Before a window of usual size, with an empty text.
    pub(crate) fn new() -> Self {
        Self::with_text("")
    }

    /// Before this text.
    pub(crate) fn with_text(text: &str) -> Self {
        let editor = Editor::immediate(Workspace::unsaved("test.mech", text));
        let mut harness = Harness::builder()
            .with_size([1280.0, 800.0])
            .with_step_dt(1.0 / 60.0)
            .build_ui_state(|ui, studio: &mut Studio| studio.show(ui), Studio::new(editor));
        harness.run_steps(2);
        Self { harness, gestures: 0 }
    }

    /// How many gestures were made: clicks, drags and keys.
    pub(crate) fn gestures(&self) -> usize {
        self.gestures
    }

    pub(crate) fn editor(&self) -> &Editor {
        self.harness.state().editor()
    }

    pub(crate) fn text(&self) -> &str {
        self.editor().workspace().text()
    }

    /// Where a place of the scene is seen in the window.
    pub(crate) fn pixel(&self, place: [f64; 2]) -> Pos2 {
        let canvas = self.harness.get_by_label("drawing").rect();
        let [x, y] = self.editor().camera().pixel(place);
        #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
        let from = Vec2::new(x as f32, y as f32);
        canvas.min + from
    }

    /// Clicks what has this name: a button, a handle.
    #[track_caller]
    pub(crate) fn click_on(&mut self, label: &str) {
        self.harness.get_by_label(label).click();
        self.harness.run_steps(3);
        self.gestures += 1;
    }

    /// Whether something of this name is in the window.
    pub(crate) fn sees(&self, label: &str) -> bool {
        self.harness.query_all_by_label_contains(label).next().is_some()
    }

    /// Clicks a place of the scene.
    pub(crate) fn click(&mut self, place: [f64; 2]) {
        let at = self.pixel(place);
        self.press(at);
        self.release(at);
        self.gestures += 1;
    }

    /// Presses at one place of the scene, and releases at another.
    pub(crate) fn drag(&mut self, from: [f64; 2], to: [f64; 2]) {
        let [from, to] = [from, to].map(|place| self.pixel(place));
        self.press(from);
        for part in [0.3, 0.7, 1.0] {
            self.harness.event(Event::PointerMoved(from + part * (to - from)));
            self.harness.run_steps(1);
        }
        self.release(to);
        self.gestures += 1;
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
            modifiers: Modifiers::NONE,
        });
        self.harness.run_steps(1);
    }

    /// Presses a key.
    pub(crate) fn key(&mut self, key: Key) {
        self.harness.key_press(key);
        self.harness.run_steps(2);
        self.gestures += 1;
    }

    /// Waits for so many pictures.
    pub(crate) fn wait(&mut self, pictures: usize) {
        self.harness.run_steps(pictures);
    }
}
