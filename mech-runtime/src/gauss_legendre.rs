//! Methods that integrate motion under forces.

/// Gauss–Legendre collocation of a given order, for a step of time. Each method is symmetric in time, so energy does not drift.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum GaussLegendre {
    /// The implicit midpoint rule: one stage, order 2.
    Order2,
    /// Two stages, order 4.
    #[default]
    Order4,
    /// Three stages, order 6.
    Order6,
}
