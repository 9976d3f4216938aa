//! What the studio's window costs in time, frame by frame, without what the graphics card does:
//! `cargo run --release -p mech-studio --example editor_times`.

mod chain;

use chain::{chain, count};
use eframe::egui::{Event, Modifiers, PointerButton, Pos2, Vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use mech_studio::editor::{Editor, Studio, Tool};
use mech_studio::{Assembly, Command, JointForm, Workspace};
use std::time::{Duration, Instant};

type Window = Harness<'static, Studio>;

fn main() {
    for loops in [10, 100, 333] {
        let joints = 3 * loops + 1;
        let mut window = open(chain(loops));
        window.state_mut().editor_mut().choose(Tool::Select);
        let still = milliseconds(60, || frame(&mut window));
        let from = pixel(&window, [4.0 * count(loops), 0.0]);
        press(&mut window, from, true);
        let mut at = from;
        let dragged = milliseconds(120, || {
            at.x += 0.5;
            window.event(Event::PointerMoved(at));
            frame(&mut window);
        });
        press(&mut window, at, false);
        let released = Instant::now();
        settle(&mut window);
        let known = released.elapsed().as_secs_f64() * 1e3;
        let join = Command::Join(Assembly {
            name: "extra".to_owned(),
            kind: JointForm::Revolute,
            ends: ["r1".to_owned(), format!("r{loops}")],
            at: Some(["1".to_owned(), "1".to_owned()]),
            along: None,
        });
        let asked = Instant::now();
        window.state_mut().editor_mut().perform(join);
        let mut longest: f64 = 0.0;
        while !window.state().editor().notice().is_some_and(|notice| notice.is_refusal) {
            longest = longest.max(timed(|| frame(&mut window)));
        }
        let refused = asked.elapsed().as_secs_f64() * 1e3;
        println!(
            "{joints} joints: a frame {still:.1} ms, one of a drag {dragged:.1} ms; everything known {known:.0} ms after it; a joint too many is told after {refused:.0} ms, the longest frame meanwhile {longest:.1} ms"
        );
    }
}

fn open(text: String) -> Window {
    let editor = Editor::new(Workspace::unsaved("chain.mech", text), || {});
    let mut window = Harness::builder()
        .with_size([1280.0, 800.0])
        .build_ui_state(|ui, studio: &mut Studio| studio.show(ui), Studio::new(editor));
    settle(&mut window);
    window.state_mut().editor_mut().fit();
    frame(&mut window);
    window
}

/// Waits until everything is known.
fn settle(window: &mut Window) {
    frame(window);
    while window.state().editor().is_busy() || window.state().editor().player().is_none() {
        std::thread::sleep(Duration::from_millis(1));
        frame(window);
    }
}

fn frame(window: &mut Window) {
    window.step();
}

fn pixel(window: &Window, place: [f64; 2]) -> Pos2 {
    let [x, y] = window.state().editor().camera().pixel(place);
    #[expect(clippy::cast_possible_truncation, reason = "pixels of a window")]
    let from = Vec2::new(x as f32, y as f32);
    window.get_by_label("drawing").rect().min + from
}

fn press(window: &mut Window, pos: Pos2, pressed: bool) {
    window.event(Event::PointerMoved(pos));
    window.event(Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    });
    frame(window);
}

fn timed(what: impl FnOnce()) -> f64 {
    let start = Instant::now();
    what();
    start.elapsed().as_secs_f64() * 1e3
}

/// The middle of some times of the same, in milliseconds.
fn milliseconds(times: usize, mut what: impl FnMut()) -> f64 {
    let mut all: Vec<f64> = (0..times).map(|_| timed(&mut what)).collect();
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}
