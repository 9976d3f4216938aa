//! Units of length, and those of masses and forces that go with them.

/// The acceleration of gravity in metres, as PMKS+ has it.
const GRAVITY: f64 = 9.806_65;
/// The same in inches: how many pounds of mass a pound of force gives an inch a second squared.
const GRAVITY_IN_INCHES: f64 = GRAVITY / 0.0254;

/// A unit of length. Masses become such that forces keep their numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unit {
    pub(super) name: &'static str,
    /// The remark in the text on masses and forces.
    pub(super) remark: &'static str,
    /// A mass of 1 of the link in the text.
    pub(super) mass: f64,
    /// A moment of inertia of 1 of the link in the text.
    pub(super) inertia: f64,
    pub(super) gravity: f64,
}

/// By their numbers in a link.
pub(super) const UNITS: [Unit; 3] = [
    // Pounds of mass and pound square inches; forces are in pounds.
    Unit {
        name: "inches",
        remark: "Forces are in pounds, torques in inch pounds, masses in units of 386.09 pounds, which fit these.",
        mass: 1.0 / GRAVITY_IN_INCHES,
        inertia: 1.0 / GRAVITY_IN_INCHES,
        gravity: GRAVITY_IN_INCHES,
    },
    // Grams and kilogram square centimetres; forces are in newtons.
    Unit {
        name: "centimetres",
        remark: "Forces are in newtons, torques in newton centimetres, masses in units of 100 kilograms, which fit these.",
        mass: 1e-5,
        inertia: 1e-2,
        gravity: 100.0 * GRAVITY,
    },
    Unit {
        name: "metres",
        remark: "Forces are in newtons, torques in newton metres, masses in kilograms.",
        mass: 1.0,
        inertia: 1.0,
        gravity: GRAVITY,
    },
];
