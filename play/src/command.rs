//! What a player is told.

use mech_gallery::Layer;

/// What a player is told. Pixels count from the upper left corner of the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    /// Play, or pause.
    PlayOrPause,
    /// Pause, and go one step on (1) or back (−1).
    Step(f64),
    /// Go the other way.
    Reverse,
    /// Twice as fast.
    Faster,
    /// Half as fast.
    Slower,
    /// Drive the next motor, or after the last one all in the exhibit's own motion.
    NextMotor,
    /// Drive the one before.
    PreviousMotor,
    /// Show a layer, or hide it.
    Toggle(Layer),
    /// Paint by day, or by night.
    DayOrNight,
    /// The next exhibit.
    NextExhibit,
    /// The one before.
    PreviousExhibit,
    /// Everything as at the start.
    Reset,
    /// See the whole motion.
    Fit,
    /// Take hold of what is at this pixel: a link, or the paper.
    Press([f64; 2]),
    /// Move what is held to this pixel.
    Point([f64; 2]),
    /// Let go.
    Release,
    /// Make everything so many times as large, about this pixel.
    Zoom([f64; 2], f64),
    /// Make a picture of another size.
    Resize([usize; 2]),
    /// Tell what the keys do, or no more.
    Help,
    /// Save the picture.
    Save,
    /// Stop.
    Quit,
}
