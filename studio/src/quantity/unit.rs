//! The units in which measurands are shown.

use mech_compiler::model::{
    Arithmetic, BinaryFunction, FormulaArithmetic, Function, JointId, LoadKind, Measurand,
    Measured, Model, Number, ParamId, Quantity, Rate, ReactionPart,
};
use mech_core::Staircase;

/// The names of a scene unit and of a unit of force.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub(crate) struct Units {
    pub(crate) length: String,
    pub(crate) force: String,
}

impl Default for Units {
    fn default() -> Self {
        Self { length: "unit".to_owned(), force: "force".to_owned() }
    }
}

impl Units {
    /// The name of a unit: angles are in degrees, what is made from them in radians.
    pub(super) fn name(&self, unit: Unit) -> String {
        if unit == Unit::ANGLE {
            return "deg".to_owned();
        }
        let Unit { force, length, angle, time } = unit;
        let parts = [
            (self.force.as_str(), force),
            (self.length.as_str(), length),
            ("rad", angle),
            ("s", time),
        ];
        let product = |sign: i32| {
            let parts = parts.iter().filter(|(_, power)| power * sign > 0);
            let parts = parts.map(|(name, power)| match power.abs() {
                1 => (*name).to_owned(),
                2 => format!("{name}²"),
                3 => format!("{name}³"),
                more => format!("{name}^{more}"),
            });
            parts.collect::<Vec<_>>().join("·")
        };
        match (product(1), product(-1)) {
            (above, below) if below.is_empty() && above.is_empty() => "1".to_owned(),
            (above, below) if below.is_empty() => above,
            (above, below) if above.is_empty() => format!("1/{below}"),
            (above, below) => format!("{above}/{below}"),
        }
    }
}

/// A product of powers of units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Unit {
    force: i32,
    length: i32,
    angle: i32,
    time: i32,
}

impl Unit {
    const ONE: Self = Self { force: 0, length: 0, angle: 0, time: 0 };
    const ANGLE: Self = Self { angle: 1, ..Self::ONE };
    const LENGTH: Self = Self { length: 1, ..Self::ONE };
    const FORCE: Self = Self { force: 1, ..Self::ONE };
    const TORQUE: Self = Self { force: 1, length: 1, ..Self::ONE };
    pub(super) const TIME: Self = Self { time: 1, ..Self::ONE };

    /// That of a measurand.
    pub(super) fn of(model: &Model, measurand: &Measurand) -> Self {
        let mut arithmetic = OfFormulas { variables: Vec::new() };
        let formulas = measurand.formulas();
        for measured in measurand.measured() {
            let mut of = |id| formulas.evaluate_one(id, &mut arithmetic).unwrap_or_default();
            let unit = match *measured {
                Measured::Quantity(quantity) => Self::of_quantity(model, quantity),
                Measured::Summary(_, id) => of(id),
                Measured::Influence(id, motor) => {
                    let motor = Self::of_coordinate(model, model.motor(motor).joint);
                    of(id).times(motor, -1)
                }
                Measured::Rate(Rate::Velocity, id) => of(id).times(Self::TIME, -1),
                Measured::Rate(Rate::Acceleration, id) => of(id).times(Self::TIME, -2),
            };
            arithmetic.variables.push(unit);
        }
        let unit = formulas.evaluate_one(measurand.subject(), &mut arithmetic);
        unit.unwrap_or_default()
    }

    /// That of the coordinate of a joint.
    pub(super) fn of_coordinate(model: &Model, joint: JointId) -> Self {
        if model.turns(joint) { Self::ANGLE } else { Self::LENGTH }
    }

    fn of_quantity(model: &Model, quantity: Quantity) -> Self {
        match quantity {
            Quantity::Coordinate(joint) => Self::of_coordinate(model, joint),
            Quantity::Angle(_)
            | Quantity::AngleBetween(_)
            | Quantity::Transmission(_)
            | Quantity::Pressure(_) => Self::ANGLE,
            Quantity::X(_)
            | Quantity::Y(_)
            | Quantity::Distance(_)
            | Quantity::Clearance(_)
            | Quantity::CentreX(_)
            | Quantity::CentreY(_) => Self::LENGTH,
            Quantity::Curvature(_) => Self::ONE.times(Self::LENGTH, -1),
            Quantity::Torque(motor) => Self::of_effort(model.turns(model.motor(motor).joint)),
            Quantity::Power(_) => Self::TORQUE.times(Self::TIME, -1),
            Quantity::Reaction(_, part) | Quantity::Ground(part) | Quantity::Shaking(part) => {
                Self::of_effort(part == ReactionPart::Torque)
            }
            Quantity::Advantage(load, motor) => {
                let is_torque = matches!(model.actions.loads[load].kind, LoadKind::Torque(_));
                let motor = Self::of_effort(model.turns(model.motor(motor).joint));
                Self::of_effort(is_torque).times(motor, -1)
            }
            Quantity::Time => Self::TIME,
        }
    }

    fn of_effort(is_torque: bool) -> Self {
        if is_torque { Self::TORQUE } else { Self::FORCE }
    }

    /// This unit times a power of another. A radian beside a length or a force is none.
    fn times(self, other: Self, power: i32) -> Self {
        Self {
            force: self.force + power * other.force,
            length: self.length + power * other.length,
            angle: self.angle + power * other.angle,
            time: self.time + power * other.time,
        }
    }

    /// The root, if it has one.
    fn root(self) -> Self {
        Self {
            force: self.force / 2,
            length: self.length / 2,
            angle: self.angle / 2,
            time: self.time / 2,
        }
    }

    /// A value that is measured in radians if it is an angle, in this unit.
    pub(super) fn shown(self, value: f64) -> f64 {
        if self == Self::ANGLE { value.to_degrees() } else { value }
    }
}

/// The units of formulas. A number alone has that of what it is added to.
struct OfFormulas {
    variables: Vec<Unit>,
}

impl Arithmetic for OfFormulas {
    type Scalar = Option<Unit>;

    fn constant(&mut self, _: f64) -> Option<Unit> {
        None
    }

    fn neg(&mut self, a: Option<Unit>) -> Option<Unit> {
        a
    }

    fn add(&mut self, a: Option<Unit>, b: Option<Unit>) -> Option<Unit> {
        a.or(b)
    }

    fn sub(&mut self, a: Option<Unit>, b: Option<Unit>) -> Option<Unit> {
        a.or(b)
    }

    fn mul(&mut self, a: Option<Unit>, b: Option<Unit>) -> Option<Unit> {
        let mut product = match (a, b) {
            (Some(a), Some(b)) => a.times(b, 1),
            (one, other) => return one.or(other),
        };
        // An arc is an angle times a length.
        if product.force != 0 || product.length != 0 {
            product.angle = 0;
        }
        Some(product)
    }

    fn div(&mut self, a: Option<Unit>, b: Option<Unit>) -> Option<Unit> {
        match (a, b) {
            (a, None) => a,
            (a, Some(b)) => Some(a.unwrap_or_default().times(b, -1)),
        }
    }
}

impl FormulaArithmetic for OfFormulas {
    fn variable(&mut self, number: usize) -> Option<Unit> {
        self.variables.get(number).copied()
    }

    fn param(&mut self, _: ParamId) -> Option<Unit> {
        None
    }

    fn of(&mut self, function: Function, a: Option<Unit>) -> Option<Unit> {
        match function {
            Function::Abs | Function::Floor => a,
            Function::Sqrt => a.map(Unit::root),
            Function::Asin | Function::Acos | Function::Atan => Some(Unit::ANGLE),
            _ => Some(Unit::ONE),
        }
    }

    fn of_both(
        &mut self,
        function: BinaryFunction,
        a: Option<Unit>,
        b: Option<Unit>,
    ) -> Option<Unit> {
        match function {
            BinaryFunction::Atan2 => Some(Unit::ANGLE),
            _ => a.or(b),
        }
    }

    fn stairs(&mut self, _: Staircase, _: Option<Unit>, _: Number) -> Option<Unit> {
        Some(Unit::ONE)
    }
}
