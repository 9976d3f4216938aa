//! The window: winit's events become commands, pictures go to softbuffer.

use super::{Control, Key, SIZE, Stage};
use crate::failure::Failure;
use softbuffer::{Context, Surface};
use std::fmt;
use std::num::NonZeroU32;
use std::ops::ControlFlow;
use std::rc::Rc;
use std::time::{Duration, Instant};
use winit::application::ApplicationHandler;
use winit::dpi::{LogicalSize, PhysicalPosition};
use winit::error::{EventLoopError, OsError};
use winit::event::{ElementState, KeyEvent, MouseButton, MouseScrollDelta, WindowEvent};
use winit::event_loop::{self, ActiveEventLoop, EventLoop};
use winit::keyboard::{Key as Pressed, NamedKey};
use winit::window::{Window as Native, WindowId};

/// How much larger a notch of the wheel makes everything.
const NOTCH: f64 = 1.15;
/// How many pixels of a smooth wheel are a notch.
const SMOOTH: f64 = 40.0;
/// The time from one picture to the next.
const FRAME: Duration = Duration::from_micros(16_667);

/// Why there is no window.
#[derive(Debug)]
#[non_exhaustive]
pub enum Error {
    /// There is no display, or none that can be reached.
    NoDisplay(EventLoopError),
    /// The event loop failed.
    EventLoop(EventLoopError),
    /// The window could not be made.
    Window(OsError),
    /// There can be no pictures in it.
    Surface(softbuffer::SoftBufferError),
    /// There is no memory for a picture.
    Picture(Failure),
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDisplay(_) => match display() {
                Some(display) => write!(f, "the display `{display}` cannot be reached"),
                None => {
                    f.write_str("there is no display: neither DISPLAY nor WAYLAND_DISPLAY is set")
                }
            },
            Self::EventLoop(error) => write!(f, "the window failed: {error}"),
            Self::Window(error) => write!(f, "cannot open a window: {error}"),
            Self::Surface(error) => write!(f, "cannot paint into the window: {error}"),
            Self::Picture(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for Error {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::NoDisplay(error) | Self::EventLoop(error) => Some(error),
            Self::Window(error) => Some(error),
            Self::Surface(error) => Some(error),
            Self::Picture(error) => Some(error),
        }
    }
}

/// The display that the environment names.
fn display() -> Option<String> {
    let named = |name| std::env::var(name).ok().filter(|value| !value.is_empty());
    ["WAYLAND_DISPLAY", "WAYLAND_SOCKET", "DISPLAY"]
        .into_iter()
        .find_map(named)
}

/// A display that can be reached.
pub struct Display {
    events: EventLoop<()>,
}

impl Display {
    /// Looks for it.
    ///
    /// # Errors
    /// [`Error::NoDisplay`] if there is none.
    pub fn open() -> Result<Self, Error> {
        let events = EventLoop::new().map_err(Error::NoDisplay)?;
        Ok(Self { events })
    }

    /// Plays in a window until it is closed.
    ///
    /// # Errors
    /// Whatever keeps the window from being there.
    pub fn play(self, stage: Stage) -> Result<(), Error> {
        let mut application = Application {
            stage,
            window: None,
            pointer: [0.0, 0.0],
            last: Instant::now(),
            title: String::new(),
            error: None,
        };
        let result = self.events.run_app(&mut application);
        match application.error {
            Some(error) => Err(error),
            None => result.map_err(Error::EventLoop),
        }
    }
}

/// A window and the surface in it.
struct Window {
    native: Rc<Native>,
    surface: Surface<Rc<Native>, Rc<Native>>,
}

impl Window {
    fn open(event_loop: &ActiveEventLoop, title: &str) -> Result<Self, Error> {
        let [width, height] = SIZE.map(|side| u32::try_from(side).unwrap_or(u32::MAX));
        let attributes = Native::default_attributes()
            .with_title(title)
            .with_inner_size(LogicalSize::new(width, height));
        let native = event_loop
            .create_window(attributes)
            .map_err(Error::Window)?;
        let native = Rc::new(native);
        let context = Context::new(Rc::clone(&native)).map_err(Error::Surface)?;
        let surface = Surface::new(&context, Rc::clone(&native)).map_err(Error::Surface)?;
        Ok(Self { native, surface })
    }

    /// The size of the picture; `None` while the window is folded up.
    fn size(&self) -> Option<[NonZeroU32; 2]> {
        let size = self.native.inner_size();
        Some([NonZeroU32::new(size.width)?, NonZeroU32::new(size.height)?])
    }

    /// Shows a picture of what is on stage now.
    fn paint(&mut self, stage: &mut Stage) -> Result<(), Error> {
        let Some([width, height]) = self.size() else {
            return Ok(());
        };
        let size = [width, height].map(|side| usize::try_from(side.get()).unwrap_or(usize::MAX));
        if stage.player.camera().size() != size {
            stage.player.obey(Control::Resize(size));
        }
        self.surface.resize(width, height).map_err(Error::Surface)?;
        let picture = stage.caption().map_err(Error::Picture)?;
        let mut buffer = self.surface.buffer_mut().map_err(Error::Surface)?;
        for (pixel, &[red, green, blue, _]) in buffer.iter_mut().zip(picture.pixels()) {
            *pixel = u32::from_be_bytes([0, red, green, blue]);
        }
        self.native.pre_present_notify();
        buffer.present().map_err(Error::Surface)
    }
}

/// What stands between the events and the stage.
struct Application {
    stage: Stage,
    window: Option<Window>,
    pointer: [f64; 2],
    last: Instant,
    title: String,
    error: Option<Error>,
}

impl Application {
    /// Obeys a control, if there is one, and shows the result.
    fn obey(&mut self, event_loop: &ActiveEventLoop, control: Option<Control>) {
        if let Some(control) = control
            && let ControlFlow::Break(()) = self.stage.obey(control)
        {
            event_loop.exit();
        }
        self.show();
    }

    /// Has the picture and the title renewed.
    fn show(&mut self) {
        let Some(window) = &self.window else {
            return;
        };
        let player = &self.stage.player;
        let title = format!("{} — {}", player.title(), player.status());
        if title != self.title {
            window.native.set_title(&title);
            self.title = title;
        }
        window.native.request_redraw();
    }

    /// Stops, and remembers why.
    fn fail(&mut self, event_loop: &ActiveEventLoop, error: Error) {
        self.error = Some(error);
        event_loop.exit();
    }
}

impl ApplicationHandler for Application {
    fn resumed(&mut self, event_loop: &ActiveEventLoop) {
        match Window::open(event_loop, self.stage.player.title()) {
            Ok(window) => {
                self.window = Some(window);
                self.last = Instant::now();
                self.show();
            }
            Err(error) => self.fail(event_loop, error),
        }
    }

    fn suspended(&mut self, _: &ActiveEventLoop) {
        self.window = None;
    }

    fn window_event(&mut self, event_loop: &ActiveEventLoop, _: WindowId, event: WindowEvent) {
        let control = match event {
            WindowEvent::CloseRequested => Some(Control::Quit),
            WindowEvent::RedrawRequested => {
                if let Some(window) = &mut self.window
                    && let Err(error) = window.paint(&mut self.stage)
                {
                    self.fail(event_loop, error);
                }
                return;
            }
            WindowEvent::Resized(_) | WindowEvent::ScaleFactorChanged { .. } => None,
            WindowEvent::KeyboardInput { event, .. } => match key(&event).and_then(Key::control) {
                Some(control) => Some(control),
                None => return,
            },
            WindowEvent::CursorMoved { position, .. } => {
                let PhysicalPosition { x, y } = position;
                self.pointer = [x, y];
                Some(Control::Point(self.pointer))
            }
            WindowEvent::MouseInput {
                state: ElementState::Pressed,
                button: MouseButton::Left,
                ..
            } => Some(Control::Press(self.pointer)),
            WindowEvent::MouseInput {
                state: ElementState::Released,
                button: MouseButton::Left,
                ..
            } => Some(Control::Release),
            WindowEvent::MouseWheel { delta, .. } => {
                let notches = match delta {
                    MouseScrollDelta::LineDelta(_, lines) => f64::from(lines),
                    MouseScrollDelta::PixelDelta(pixels) => pixels.y / SMOOTH,
                };
                Some(Control::Zoom(self.pointer, NOTCH.powf(notches)))
            }
            _ => return,
        };
        self.obey(event_loop, control);
    }

    fn about_to_wait(&mut self, event_loop: &ActiveEventLoop) {
        let now = Instant::now();
        if !self.stage.player.plays() {
            self.last = now;
            event_loop.set_control_flow(event_loop::ControlFlow::Wait);
            return;
        }
        let passed = now.duration_since(self.last);
        if passed >= FRAME {
            self.last = now;
            self.stage.player.advance(passed.as_secs_f64());
            self.show();
        }
        event_loop.set_control_flow(event_loop::ControlFlow::WaitUntil(self.last + FRAME));
    }
}

/// The key that was pressed, if it is one that might do something.
fn key(event: &KeyEvent) -> Option<Key> {
    if event.state != ElementState::Pressed {
        return None;
    }
    Some(match &event.logical_key {
        Pressed::Character(text) => Key::Char(text.chars().next()?),
        Pressed::Named(NamedKey::Space) => Key::Char(' '),
        Pressed::Named(NamedKey::ArrowLeft) => Key::Left,
        Pressed::Named(NamedKey::ArrowRight) => Key::Right,
        Pressed::Named(NamedKey::ArrowUp) => Key::Up,
        Pressed::Named(NamedKey::ArrowDown) => Key::Down,
        Pressed::Named(NamedKey::Tab) => Key::Tab,
        Pressed::Named(NamedKey::PageDown) => Key::PageDown,
        Pressed::Named(NamedKey::PageUp) => Key::PageUp,
        Pressed::Named(NamedKey::Home) => Key::Home,
        Pressed::Named(NamedKey::Escape) => Key::Escape,
        _ => return None,
    })
}
