//! The terminal view: half-block characters in colour, the same keys and the mouse; it works wherever there is a terminal, over ssh
//! too.

use super::caption::wrap;
use super::half_blocks::{self, Depth};
use super::{Control, Key, Stage};
use crate::failure::Failure;
use crate::text::masked;
use crossterm::event::{
    self, DisableMouseCapture, EnableMouseCapture, Event, KeyCode, KeyEvent, KeyEventKind,
    KeyModifiers, MouseButton, MouseEvent, MouseEventKind,
};
use crossterm::{cursor, execute, queue, style, terminal};
use std::io::{self, Write};
use std::ops::ControlFlow;
use std::panic;
use std::time::{Duration, Instant};

/// The time from one picture to the next: a terminal is slower than a window.
const FRAME: Duration = Duration::from_millis(40);
/// The factor by which a notch of the wheel enlarges everything.
const NOTCH: f64 = 1.15;

/// A terminal that shows pictures until this is dropped: then it is as it was before.
struct Screen;

impl Screen {
    fn open() -> io::Result<Self> {
        terminal::enable_raw_mode()?;
        // From here on, whatever fails or panics leaves the terminal as it was.
        let screen = Self;
        let before = panic::take_hook();
        panic::set_hook(Box::new(move |panic| {
            Self::close();
            before(panic);
        }));
        execute!(
            io::stdout(),
            terminal::EnterAlternateScreen,
            terminal::DisableLineWrap,
            cursor::Hide,
            EnableMouseCapture
        )?;
        Ok(screen)
    }

    fn close() {
        // Nobody is there to read an error.
        let _ = execute!(
            io::stdout(),
            DisableMouseCapture,
            cursor::Show,
            terminal::EnableLineWrap,
            terminal::LeaveAlternateScreen
        );
        let _ = terminal::disable_raw_mode();
    }
}

impl Drop for Screen {
    fn drop(&mut self) {
        Self::close();
    }
}

/// Plays in the terminal until it is stopped by a key.
///
/// # Errors
/// If the terminal cannot be read or written.
pub fn play(stage: Stage) -> Result<(), Failure> {
    play_in(stage).map_err(|error| Failure::file(format!("the terminal cannot be used: {error}")))
}

fn play_in(mut stage: Stage) -> io::Result<()> {
    let depth = Depth::of_environment();
    let _screen = Screen::open()?;
    let mut last = Instant::now();
    let mut is_stale = true;
    loop {
        if is_stale {
            paint(&mut stage, depth)?;
        }
        let now = Instant::now();
        let passed = now.duration_since(last);
        last = now;
        is_stale = stage.player.plays();
        stage.player.advance(passed.as_secs_f64());
        // Whatever has come until the next picture is due is done before it is painted.
        let due = now + FRAME;
        loop {
            let left = due.saturating_duration_since(Instant::now());
            if !event::poll(left)? {
                break;
            }
            is_stale = true;
            if let Some(control) = control(&event::read()?)
                && let ControlFlow::Break(()) = stage.obey(control)
            {
                return Ok(());
            }
        }
    }
}

/// Writes the picture, and below it the status and, if it is wanted, what the keys do.
fn paint(stage: &mut Stage, depth: Depth) -> io::Result<()> {
    let (columns, rows) = terminal::size()?;
    let columns = usize::from(columns);
    let status = format!("{} · {}", stage.player.title(), stage.player.status());
    let status = masked(&status).into_owned();
    let help = stage.help().unwrap_or_else(|| vec!["h help".to_owned(), "q quit".to_owned()]);
    let mut below = wrap(&[status], columns);
    below.extend(wrap(&help, columns));
    let above = usize::from(rows).saturating_sub(below.len());
    let size = [columns, 2 * above];
    if stage.player.camera().size() != size {
        stage.player.obey(Control::Resize(size));
    }
    let mut text = half_blocks::lines(stage.picture().map_err(io::Error::other)?, depth);
    text.extend(below);
    let mut out = io::stdout().lock();
    queue!(out, terminal::BeginSynchronizedUpdate)?;
    for (row, line) in (0..rows).zip(&text) {
        queue!(
            out,
            cursor::MoveTo(0, row),
            style::Print(line),
            terminal::Clear(terminal::ClearType::UntilNewLine)
        )?;
    }
    queue!(out, terminal::EndSynchronizedUpdate)?;
    out.flush()
}

fn control(event: &Event) -> Option<Control> {
    match event {
        Event::Key(key) => key_control(key),
        Event::Mouse(mouse) => mouse_control(*mouse),
        _ => None,
    }
}

fn key_control(event: &KeyEvent) -> Option<Control> {
    if event.kind == KeyEventKind::Release {
        return None;
    }
    let key = match event.code {
        KeyCode::Char('c' | 'C') if event.modifiers.contains(KeyModifiers::CONTROL) => {
            return Some(Control::Quit);
        }
        KeyCode::Char(letter) => Key::Char(letter),
        KeyCode::Left => Key::Left,
        KeyCode::Right => Key::Right,
        KeyCode::Up => Key::Up,
        KeyCode::Down => Key::Down,
        KeyCode::Tab => Key::Tab,
        KeyCode::BackTab => Key::BackTab,
        KeyCode::PageDown => Key::PageDown,
        KeyCode::PageUp => Key::PageUp,
        KeyCode::Home => Key::Home,
        KeyCode::Esc => Key::Escape,
        _ => return None,
    };
    key.control()
}

fn mouse_control(event: MouseEvent) -> Option<Control> {
    // The middle of a character, which is one pixel wide and two high.
    let pixel = [f64::from(event.column) + 0.5, 2.0 * f64::from(event.row) + 1.0];
    Some(match event.kind {
        MouseEventKind::Down(MouseButton::Left) => Control::Press(pixel),
        MouseEventKind::Drag(MouseButton::Left) => Control::Point(pixel),
        MouseEventKind::Up(MouseButton::Left) => Control::Release,
        MouseEventKind::ScrollUp => Control::Zoom(pixel, NOTCH),
        MouseEventKind::ScrollDown => Control::Zoom(pixel, 1.0 / NOTCH),
        _ => return None,
    })
}
