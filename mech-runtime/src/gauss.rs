//! Methods that follow motion under forces.

/// A method of Gauss: how exactly a step of time is followed. Each is symmetric in time, so that energy does not drift away where
/// none is put in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Gauss {
    /// The implicit midpoint rule: one stage, order 2.
    Two,
    /// Two stages, order 4.
    #[default]
    Four,
    /// Three stages, order 6.
    Six,
}
