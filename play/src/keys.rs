//! What the keys do, in the window and in the terminal alike.

use crate::Command;
use mech_gallery::Layer;

/// A key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    /// One that writes something.
    Char(char),
    /// An arrow.
    Left,
    /// An arrow.
    Right,
    /// An arrow.
    Up,
    /// An arrow.
    Down,
    /// The tabulator.
    Tab,
    /// The same with shift.
    BackTab,
    /// A page on.
    PageDown,
    /// A page back.
    PageUp,
    /// The first place.
    Home,
    /// Escape.
    Escape,
}

impl Key {
    /// What it does.
    #[must_use]
    pub fn command(self) -> Option<Command> {
        let key = match self {
            Self::Char(letter) => Self::Char(letter.to_ascii_lowercase()),
            other => other,
        };
        let binding = BINDINGS
            .iter()
            .find(|binding| binding.keys.contains(&key))?;
        let place = binding.keys.iter().position(|&one| one == key)?;
        binding.commands.get(place).copied()
    }
}

/// Keys that do something together.
struct Binding {
    keys: &'static [Key],
    /// What each of them does.
    commands: &'static [Command],
    label: &'static str,
    meaning: &'static str,
}

const fn binding(
    label: &'static str,
    meaning: &'static str,
    keys: &'static [Key],
    commands: &'static [Command],
) -> Binding {
    Binding {
        keys,
        commands,
        label,
        meaning,
    }
}

const BINDINGS: [Binding; 13] = [
    binding(
        "space",
        "play or pause",
        &[Key::Char(' ')],
        &[Command::PlayOrPause],
    ),
    binding(
        "← →",
        "step",
        &[Key::Left, Key::Right],
        &[Command::Step(-1.0), Command::Step(1.0)],
    ),
    binding(
        "↑ ↓",
        "speed",
        &[Key::Up, Key::Down, Key::Char('+'), Key::Char('-')],
        &[
            Command::Faster,
            Command::Slower,
            Command::Faster,
            Command::Slower,
        ],
    ),
    binding("b", "backwards", &[Key::Char('b')], &[Command::Reverse]),
    binding(
        "tab",
        "motor",
        &[Key::Tab, Key::BackTab],
        &[Command::NextMotor, Command::PreviousMotor],
    ),
    binding(
        "1…7",
        "shapes, joints, bars, axes, motors, velocities, accelerations",
        &[
            Key::Char('1'),
            Key::Char('2'),
            Key::Char('3'),
            Key::Char('4'),
            Key::Char('5'),
            Key::Char('6'),
            Key::Char('7'),
        ],
        &[
            Command::Toggle(Layer::Shapes),
            Command::Toggle(Layer::Joints),
            Command::Toggle(Layer::Links),
            Command::Toggle(Layer::Axes),
            Command::Toggle(Layer::Motors),
            Command::Toggle(Layer::Velocities),
            Command::Toggle(Layer::Accelerations),
        ],
    ),
    binding(
        "d",
        "day or night",
        &[Key::Char('d')],
        &[Command::DayOrNight],
    ),
    binding(
        "n p",
        "next, previous exhibit",
        &[Key::Char('n'), Key::Char('p'), Key::PageDown, Key::PageUp],
        &[
            Command::NextExhibit,
            Command::PreviousExhibit,
            Command::NextExhibit,
            Command::PreviousExhibit,
        ],
    ),
    binding(
        "r",
        "reset",
        &[Key::Char('r'), Key::Home],
        &[Command::Reset, Command::Reset],
    ),
    binding("f", "fit", &[Key::Char('f')], &[Command::Fit]),
    binding("s", "save", &[Key::Char('s')], &[Command::Save]),
    binding(
        "h",
        "help",
        &[Key::Char('h'), Key::Char('?')],
        &[Command::Help, Command::Help],
    ),
    binding(
        "q",
        "quit",
        &[Key::Char('q'), Key::Escape],
        &[Command::Quit, Command::Quit],
    ),
];

/// What all keys do, and the mouse, each in a few words.
#[must_use]
pub fn help() -> Vec<String> {
    let keys = BINDINGS
        .iter()
        .map(|binding| format!("{} {}", binding.label, binding.meaning));
    let mouse = ["drag a link", "drag the paper", "wheel zoom"].map(str::to_owned);
    keys.chain(mouse).collect()
}
