//! What the studio's window costs in time, frame by frame, from an event to the triangles that the graphics card is given:
//! `cargo run --release -p mech-studio --example editor_times`.

mod timing;

use eframe::egui::{self, Event, Modifiers, PointerButton, Pos2, Rect, Vec2};
use mech_studio::Workspace;
use mech_studio::editor::{Editor, Studio, Tool};
use mech_studio::play::Control;
use std::time::{Duration, Instant};
use timing::{chain, count, joint_too_many, middle, milliseconds, times};

fn main() {
    for loops in [10, 100, 333] {
        let joints = 3 * loops + 1;
        let mut window = Window::open(chain(loops));
        let still = middle(60, || drop(window.frame(vec![])));
        window.obey(Control::PlayOrPause);
        let played = middle(60, || drop(window.frame(vec![])));
        window.obey(Control::PlayOrPause);
        window.obey(Control::Reset);
        window.settle();
        // Nothing snaps, so that every place is another one.
        let (drag, known) = window.drag(loops, Modifiers::ALT);
        let (snapping, _) = window.drag(loops, Modifiers::NONE);
        window.studio.editor_mut().sight_mut().scrub(0, 0.4);
        let (posed, _) = window.drag(loops, Modifiers::ALT);
        window.obey(Control::Reset);
        window.settle();
        let (refused, longest) = window.refuse(loops);
        println!("{joints} joints");
        println!("  a frame {still:.1} ms, while it plays {played:.1} ms");
        for (name, times) in
            [("at the start", drag), ("onto other joints", snapping), ("at a pose", posed)]
        {
            let [middle, longest] = [times[times.len() / 2], times[times.len() - 1]];
            println!("  a frame of a drag {name} {middle:.1} ms, the longest {longest:.1} ms");
        }
        println!("  everything known {known:.0} ms after a drag");
        println!(
            "  a joint too many told after {refused:.0} ms, the longest frame {longest:.1} ms"
        );
    }
}

/// The studio, in a window that is not seen.
struct Window {
    context: egui::Context,
    studio: Studio,
    /// Where the drawing is.
    canvas: Rect,
    /// The keys that are held.
    modifiers: Modifiers,
}

impl Window {
    const SIZE: Vec2 = Vec2::new(1280.0, 800.0);

    fn open(text: String) -> Self {
        let editor = Editor::new(Workspace::unsaved("chain.mech", text), || {});
        let mut window = Self {
            context: egui::Context::default(),
            studio: Studio::new(editor),
            canvas: Rect::NOTHING,
            modifiers: Modifiers::NONE,
        };
        window.settle();
        window.canvas = window.find_canvas();
        window.studio.editor_mut().choose(Tool::Select);
        window.studio.editor_mut().sight_mut().fit();
        window.frame(vec![]);
        window
    }

    fn obey(&mut self, control: Control) {
        self.studio.editor_mut().sight_mut().obey(control);
    }

    /// Shows everything once.
    fn frame(&mut self, events: Vec<Event>) -> egui::FullOutput {
        let input = egui::RawInput {
            screen_rect: Some(Rect::from_min_size(Pos2::ZERO, Self::SIZE)),
            events,
            ..egui::RawInput::default()
        };
        let output = self.context.run_ui(input, |ui| self.studio.show(ui));
        let shapes = output.shapes.clone();
        std::hint::black_box(self.context.tessellate(shapes, output.pixels_per_point));
        output
    }

    /// Where the drawing is, as a screen reader is told.
    fn find_canvas(&mut self) -> Rect {
        self.context.enable_accesskit();
        let output = self.frame(vec![]);
        self.context.disable_accesskit();
        let update = output.platform_output.accesskit_update.expect("it was asked for");
        let found = update.nodes.iter().find(|(_, node)| node.label() == Some("drawing"));
        let bounds = found.and_then(|(_, node)| node.bounds()).expect("the drawing has a place");
        #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
        let [left, top, right, bottom] =
            [bounds.x0, bounds.y0, bounds.x1, bounds.y1].map(|part| part as f32);
        Rect::from_min_max(Pos2::new(left, top), Pos2::new(right, bottom))
    }

    /// Waits until everything is known, and tells how long that takes, in milliseconds.
    fn settle(&mut self) -> f64 {
        let start = Instant::now();
        self.frame(vec![]);
        while self.studio.editor().is_busy() {
            std::thread::sleep(Duration::from_millis(1));
            self.frame(vec![]);
            self.insist(start);
        }
        start.elapsed().as_secs_f64() * 1e3
    }

    /// Gives up what takes far too long.
    fn insist(&self, start: Instant) {
        let editor = self.studio.editor();
        assert!(
            start.elapsed() < Duration::from_secs(20),
            "busy: {}, moves: {}, {:?}, {:?}",
            editor.is_busy(),
            editor.player().is_some(),
            editor.notice(),
            editor.messages()
        );
    }

    /// Drags the last joint on the ground. Tells how long its frames take, the shortest first, and after how long everything is known.
    fn drag(&mut self, loops: usize, modifiers: Modifiers) -> (Vec<f64>, f64) {
        self.hold(modifiers);
        let mut at = self.pixel([4.0 * count(loops), 0.0]);
        self.press(at, true);
        let dragged = times(120, || {
            at.x += 0.5;
            self.frame(vec![Event::PointerMoved(at)]);
        });
        self.press(at, false);
        self.hold(Modifiers::NONE);
        let known = self.settle();
        self.studio.editor_mut().undo();
        self.settle();
        (dragged, known)
    }

    /// Adds a joint that is too many. Tells after how long that is told, and the longest frame until then, in milliseconds.
    fn refuse(&mut self, loops: usize) -> (f64, f64) {
        let start = Instant::now();
        self.studio.editor_mut().perform(joint_too_many(loops));
        let mut longest: f64 = 0.0;
        while !self.studio.editor().notice().is_some_and(|notice| notice.is_refusal) {
            longest = longest.max(milliseconds(|| drop(self.frame(vec![]))));
        }
        (start.elapsed().as_secs_f64() * 1e3, longest)
    }

    fn pixel(&self, place: [f64; 2]) -> Pos2 {
        let [x, y] = self.studio.editor().sight().camera().pixel(place);
        #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
        let from = Vec2::new(x as f32, y as f32);
        self.canvas.min + from
    }

    /// Holds keys, or lets them go.
    fn hold(&mut self, modifiers: Modifiers) {
        self.modifiers = modifiers;
        self.frame(vec![Event::ModifiersChanged(modifiers)]);
    }

    fn press(&mut self, pos: Pos2, pressed: bool) {
        let button = Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: self.modifiers,
        };
        self.frame(vec![Event::PointerMoved(pos), button]);
    }
}
