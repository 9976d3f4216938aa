//! The language of [`mechanism!`](crate::mechanism), in chapters.
//!
//! | chapter | what it describes |
//! |---|---|
//! | [`links`] | links, the two ways to declare them, and `show` |
//! | [`joints`] | joints, their coordinates, gears, belts, racks and cams |
//! | [`moves`] | methods, accuracy, moves, and ranges that are proved |
//! | [`inverse`] | a point that is led, and motors that follow it |
//! | [`laws`] | numbers, functions, and motors that follow a law of time |
//! | [`looks`] | bodies without drawing, diagrams, and declared shapes |
//! | [`pictures`] | pictures, traces and diagrams |
//! | [`forces`] | velocities, masses, springs, loads, and motion under forces |
//! | [`parts`] | a mechanism used in another, once or many times |
//! | [`params`] | numbers that can be changed at run time, and sensitivities |
//! | [`requirements`] | what a mechanism is for: conditions that are proved |
//! | [`tests`] | tests that a mechanism stays refused |
//!
//! These modules hold documentation only.

#[doc = include_str!("language/forces.md")]
pub mod forces {}

#[doc = include_str!("language/inverse.md")]
pub mod inverse {}

#[doc = include_str!("language/joints.md")]
pub mod joints {}

#[doc = include_str!("language/laws.md")]
pub mod laws {}

#[doc = include_str!("language/links.md")]
pub mod links {}

#[doc = include_str!("language/looks.md")]
pub mod looks {}

#[doc = include_str!("language/moves.md")]
pub mod moves {}

#[doc = include_str!("language/params.md")]
pub mod params {}

#[doc = include_str!("language/parts.md")]
pub mod parts {}

#[doc = include_str!("language/pictures.md")]
pub mod pictures {}

#[doc = include_str!("language/requirements.md")]
pub mod requirements {}

#[doc = include_str!("language/tests.md")]
pub mod tests {}
