//! Controls of a player.

use super::Layer;

/// A control of a player: what somebody who plays asks for. Pixels count from the upper left corner of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Control {
    /// Play, or pause.
    PlayOrPause,
    /// Pause, and move one step forward (1) or back (−1).
    Step(f64),
    /// Reverse the direction.
    Reverse,
    /// Twice as fast.
    Faster,
    /// Half as fast.
    Slower,
    /// Drive the next motor, or after the last one all in the mechanism's own motion.
    NextMotor,
    /// Drive the previous motor.
    PreviousMotor,
    /// Show a layer, or hide it.
    Toggle(Layer),
    /// Paint by day, or by night.
    DayOrNight,
    /// The next mechanism.
    NextMechanism,
    /// The previous mechanism.
    PreviousMechanism,
    /// Everything as at the start.
    Reset,
    /// See the whole motion.
    Fit,
    /// Take hold of the link or the paper at this pixel.
    Press([f64; 2]),
    /// Move the held link or paper to this pixel.
    Point([f64; 2]),
    /// Let go.
    Release,
    /// Magnify by a factor, about this pixel.
    Zoom([f64; 2], f64),
    /// Make a picture of another size.
    Resize([usize; 2]),
    /// Show or hide what the keys do.
    Help,
    /// Save the picture.
    Save,
    /// Stop.
    Quit,
}
