//! The keys, in the window and in the terminal alike.

use super::{Control, Layer};

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
    /// Returns its control.
    #[must_use]
    pub fn control(self) -> Option<Control> {
        let key = match self {
            Self::Char(letter) => Self::Char(letter.to_ascii_lowercase()),
            other => other,
        };
        let binding = BINDINGS.iter().find(|binding| binding.keys.contains(&key))?;
        let place = binding.keys.iter().position(|&one| one == key)?;
        binding.controls.get(place).copied()
    }
}

struct Binding {
    keys: &'static [Key],
    controls: &'static [Control],
    label: &'static str,
    meaning: &'static str,
}

const fn binding(
    label: &'static str,
    meaning: &'static str,
    keys: &'static [Key],
    controls: &'static [Control],
) -> Binding {
    Binding { keys, controls, label, meaning }
}

const BINDINGS: [Binding; 13] = [
    binding("space", "play or pause", &[Key::Char(' ')], &[Control::PlayOrPause]),
    binding("← →", "step", &[Key::Left, Key::Right], &[Control::Step(-1.0), Control::Step(1.0)]),
    binding(
        "↑ ↓",
        "speed",
        &[Key::Up, Key::Down, Key::Char('+'), Key::Char('-')],
        &[Control::Faster, Control::Slower, Control::Faster, Control::Slower],
    ),
    binding("b", "backwards", &[Key::Char('b')], &[Control::Reverse]),
    binding(
        "tab",
        "motor",
        &[Key::Tab, Key::BackTab],
        &[Control::NextMotor, Control::PreviousMotor],
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
            Control::Toggle(Layer::Shapes),
            Control::Toggle(Layer::Joints),
            Control::Toggle(Layer::Links),
            Control::Toggle(Layer::Axes),
            Control::Toggle(Layer::Motors),
            Control::Toggle(Layer::Velocities),
            Control::Toggle(Layer::Accelerations),
        ],
    ),
    binding("d", "day or night", &[Key::Char('d')], &[Control::DayOrNight]),
    binding(
        "n p",
        "next, previous mechanism",
        &[Key::Char('n'), Key::Char('p'), Key::PageDown, Key::PageUp],
        &[
            Control::NextMechanism,
            Control::PreviousMechanism,
            Control::NextMechanism,
            Control::PreviousMechanism,
        ],
    ),
    binding("r", "reset", &[Key::Char('r'), Key::Home], &[Control::Reset, Control::Reset]),
    binding("f", "fit", &[Key::Char('f')], &[Control::Fit]),
    binding("s", "save", &[Key::Char('s')], &[Control::Save]),
    binding("h", "help", &[Key::Char('h'), Key::Char('?')], &[Control::Help, Control::Help]),
    binding("q", "quit", &[Key::Char('q'), Key::Escape], &[Control::Quit, Control::Quit]),
];

/// Describes all keys, and the mouse, each in a few words.
#[must_use]
pub fn help() -> Vec<String> {
    let keys = BINDINGS.iter().map(|binding| format!("{} {}", binding.label, binding.meaning));
    let mouse = ["drag a link", "drag the paper", "wheel zoom"].map(str::to_owned);
    keys.chain(mouse).collect()
}
