//! The window: egui's events become controls, and pictures a texture.

use super::{Control, Key, SIZE, Stage};
use crate::failure::Failure;
use eframe::egui::{
    self, Event, MouseWheelUnit, PointerButton, TextureHandle, TextureOptions, Ui, ViewportCommand,
};
use std::cell::RefCell;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::time::{Duration, Instant};

/// The factor by which a notch of the wheel enlarges everything.
const NOTCH: f64 = 1.15;
/// The number of points of a smooth wheel that make a notch.
const SMOOTH: f32 = 40.0;
/// The time from one picture to the next.
const FRAME: Duration = Duration::from_micros(16_667);

/// No window came up.
pub struct Unopened {
    /// The stage that was to be played.
    pub stage: Stage,
    /// Why.
    pub reason: String,
}

/// The display that the environment names.
fn display() -> Option<String> {
    let named = |name| std::env::var(name).ok().filter(|value| !value.is_empty());
    let mut names = ["WAYLAND_DISPLAY", "WAYLAND_SOCKET", "DISPLAY"].into_iter();
    names.find_map(named)
}

pub(crate) fn reason(error: &eframe::Error) -> String {
    let has_displays = cfg!(all(unix, not(target_os = "macos")));
    match (error, display()) {
        (eframe::Error::WinitEventLoop(_), Some(display)) => {
            format!("the display `{display}` cannot be reached")
        }
        (eframe::Error::WinitEventLoop(_), None) if has_displays => {
            "there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set".to_owned()
        }
        _ => format!("no window can be opened: {error}"),
    }
}

/// Plays in a window until it is closed. If no window comes up, that is the answer.
///
/// # Errors
/// If the window fails, or there is no memory for a picture.
pub fn play(stage: Stage) -> Result<Option<Unopened>, Failure> {
    #[expect(clippy::cast_precision_loss, reason = "a window is some hundreds of points wide")]
    let size = SIZE.map(|side| side as f32);
    let viewport =
        egui::ViewportBuilder::default().with_title(stage.player.title()).with_inner_size(size);
    let options = eframe::NativeOptions { viewport, ..eframe::NativeOptions::default() };
    let waiting = Rc::new(RefCell::new(Some(stage)));
    let failure = Rc::new(RefCell::new(None));
    let (taken, told) = (Rc::clone(&waiting), Rc::clone(&failure));
    let opened = eframe::run_native(
        "mech",
        options,
        Box::new(move |context| {
            // Plus and minus are keys of the player.
            let options = |options: &mut egui::Options| options.zoom_with_keyboard = false;
            context.egui_ctx.options_mut(options);
            let stage = taken.borrow_mut().take().ok_or("it comes up twice")?;
            Ok(Box::new(Window::new(stage, told)))
        }),
    );
    match (opened, waiting.take(), failure.take()) {
        (Err(error), Some(stage), _) => {
            let reason = reason(&error);
            Ok(Some(Unopened { stage, reason }))
        }
        (Err(error), None, _) => Err(Failure::usage(format!("the window failed: {error}"))),
        (Ok(()), _, Some(failure)) => Err(failure),
        (Ok(()), ..) => Ok(None),
    }
}

struct Window {
    stage: Stage,
    texture: Option<TextureHandle>,
    pointer: [f64; 2],
    last: Instant,
    title: String,
    failure: Rc<RefCell<Option<Failure>>>,
}

impl Window {
    fn new(stage: Stage, failure: Rc<RefCell<Option<Failure>>>) -> Self {
        Self {
            stage,
            texture: None,
            pointer: [0.0, 0.0],
            last: Instant::now(),
            title: String::new(),
            failure,
        }
    }

    /// Returns the control that an event asks for. A point of the window is `scale` pixels.
    fn control(&mut self, event: &Event, scale: f32) -> Option<Control> {
        let pixel = |place: egui::Pos2| [place.x, place.y].map(|part| f64::from(part * scale));
        match *event {
            Event::Text(ref text) => Key::Char(text.chars().next()?).control(),
            Event::Key { key, pressed: true, modifiers, .. } => {
                named(key, modifiers.shift)?.control()
            }
            Event::PointerMoved(place) => {
                self.pointer = pixel(place);
                Some(Control::Point(self.pointer))
            }
            Event::PointerButton { pos, button: PointerButton::Primary, pressed, .. } => {
                self.pointer = pixel(pos);
                Some(if pressed { Control::Press(self.pointer) } else { Control::Release })
            }
            Event::MouseWheel { unit, delta, .. } => {
                let notches = match unit {
                    MouseWheelUnit::Point => delta.y / SMOOTH,
                    MouseWheelUnit::Line | MouseWheelUnit::Page => delta.y,
                };
                Some(Control::Zoom(self.pointer, NOTCH.powf(notches.into())))
            }
            _ => None,
        }
    }

    /// Obeys everything that happened since the last picture. `Break` if the window is to be closed.
    fn obey(&mut self, ui: &Ui) -> ControlFlow<()> {
        let scale = ui.pixels_per_point();
        let events = ui.input(|input| input.events.clone());
        for event in &events {
            if let Some(control) = self.control(event, scale) {
                self.stage.obey(control)?;
            }
        }
        let now = Instant::now();
        if self.stage.player.plays() {
            let passed = now.duration_since(self.last).as_secs_f64();
            self.stage.player.advance(passed);
            ui.ctx().request_repaint_after(FRAME);
        }
        self.last = now;
        ControlFlow::Continue(())
    }

    /// The picture of what is on stage, in the size of the window.
    fn picture(&mut self, ui: &Ui) -> Result<egui::ColorImage, Failure> {
        let size = ui.max_rect().size() * ui.pixels_per_point();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
        let size = [size.x, size.y].map(|side| side.round().max(1.0) as usize);
        if self.stage.player.camera().size() != size {
            self.stage.player.obey(Control::Resize(size));
        }
        let picture = self.stage.caption()?;
        let pixels = picture.pixels().iter();
        let pixels = pixels.map(|&[red, green, blue, _]| egui::Color32::from_rgb(red, green, blue));
        Ok(egui::ColorImage::new(size, pixels.collect()))
    }
}

impl eframe::App for Window {
    fn ui(&mut self, ui: &mut Ui, _: &mut eframe::Frame) {
        let context = ui.ctx().clone();
        if self.obey(ui).is_break() {
            context.send_viewport_cmd(ViewportCommand::Close);
        }
        let player = &self.stage.player;
        let title = format!("{} — {}", player.title(), player.status());
        if title != self.title {
            context.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
        match self.picture(ui) {
            Ok(picture) => {
                let options = TextureOptions::NEAREST;
                let load = || context.load_texture("stage", egui::ColorImage::default(), options);
                let texture = self.texture.get_or_insert_with(load);
                texture.set(picture, options);
                let whole = egui::Rect::from_min_max([0.0, 0.0].into(), [1.0, 1.0].into());
                let painter = ui.painter();
                painter.image(texture.id(), ui.max_rect(), whole, egui::Color32::WHITE);
            }
            Err(failure) => {
                self.failure.replace(Some(failure));
                context.send_viewport_cmd(ViewportCommand::Close);
            }
        }
    }
}

/// A key that writes nothing, if it is one that might do something.
fn named(key: egui::Key, has_shift: bool) -> Option<Key> {
    Some(match key {
        egui::Key::ArrowLeft => Key::Left,
        egui::Key::ArrowRight => Key::Right,
        egui::Key::ArrowUp => Key::Up,
        egui::Key::ArrowDown => Key::Down,
        egui::Key::Tab if has_shift => Key::BackTab,
        egui::Key::Tab => Key::Tab,
        egui::Key::PageDown => Key::PageDown,
        egui::Key::PageUp => Key::PageUp,
        egui::Key::Home => Key::Home,
        egui::Key::Escape => Key::Escape,
        _ => return None,
    })
}
