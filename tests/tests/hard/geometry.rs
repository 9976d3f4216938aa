//! Plain geometry in double precision: circles and lines, with no help from the product.

use mech_compiler::model::Law;
use mech_test_support::law;

/// Where a point of a link should be, as the motor has it.
pub(crate) struct Expected {
    pub(crate) link: String,
    pub(crate) on_link: [f64; 2],
    place: Place,
    pub(crate) tolerance: Tolerance,
    /// Whether it is held only where rounding does not hide the side.
    pub(crate) only_seen: bool,
}

enum Place {
    Formulas([Law; 2]),
    Closed(ClosedForm, [f64; 2]),
}

/// How far it may be off.
pub(crate) enum Tolerance {
    /// As the sine of a transmission angle says.
    Sine(Law),
    /// The same, of a closed form.
    Closed(ClosedForm),
    /// So many times.
    Within(f64),
}

/// What has a closed form.
#[derive(Clone, Copy)]
pub(crate) enum ClosedForm {
    /// The joint of coupler and rocker, by the lengths of ground, crank, coupler and rocker, on the left of the way from the crank's pin to
    /// the rocker's shaft.
    FourBar([f64; 4]),
    /// The block of a slider-crank, by the lengths of crank and rod, and how far its guide lies above the shaft.
    SliderCrank([f64; 3]),
}

fn numbers<const N: usize>(text: &str) -> [f64; N] {
    let numbers: Vec<f64> = text.split(' ').map(constant).collect();
    numbers.try_into().expect("as many numbers")
}

/// The value of a formula without a variable.
pub(crate) fn constant(text: &str) -> f64 {
    law(text).at(0.0, &[])
}

impl ClosedForm {
    fn read(text: &str) -> Option<Self> {
        let (word, lengths) = text.split_once(' ')?;
        match word {
            "four_bar" => Some(Self::FourBar(numbers(lengths))),
            "slider_crank" => Some(Self::SliderCrank(numbers(lengths))),
            _ => None,
        }
    }

    /// The point, and the sine of its transmission angle with the sign of its side. A discriminant below zero is zero.
    fn at(self, angle: f64) -> ([f64; 2], f64) {
        match self {
            Self::FourBar([g, a, b, c]) => {
                let pin = [a * angle.cos(), a * angle.sin()];
                let half = (angle / 2.0).sin();
                let square = (g - a).powi(2) + 4.0 * g * a * half * half;
                let distance = square.sqrt();
                let outer = (b + c - distance) * (b + c + distance);
                let inner = (distance - (b - c).abs()) * (distance + (b - c).abs());
                let root = (outer * inner).max(0.0).sqrt();
                let along = (square + (b - c) * (b + c)) / (2.0 * square);
                let across = root / (2.0 * square);
                let [u, v] = [g - pin[0], -pin[1]];
                let at = [pin[0] + along * u - across * v, pin[1] + along * v + across * u];
                (at, root / (2.0 * b * c))
            }
            Self::SliderCrank([r, l, offset]) => {
                let height = offset - r * angle.sin();
                let root = ((l - height) * (l + height)).max(0.0).sqrt();
                ([r * angle.cos() + root, offset], root / l)
            }
        }
    }
}

impl Expected {
    /// Reads `LINK X Y = …`.
    pub(crate) fn new(fact: &str) -> Self {
        let (point, should) = fact.split_once(" = ").expect("a point and a place");
        let (link, on_link) = point.split_once(' ').expect("a link and a place on it");
        let formulas = |text: &str| {
            let (x, y) = text.split_once(", ").expect("two formulas");
            Place::Formulas([law(x), law(y)])
        };
        let (place, tolerance) = if let Some((at, sine)) = should.split_once(" sine ") {
            let sine = ClosedForm::read(sine)
                .map_or_else(|| Tolerance::Sine(law(sine)), Tolerance::Closed);
            (formulas(at), sine)
        } else if let Some((at, within)) = should.split_once(" within ") {
            (formulas(at), Tolerance::Within(constant(within)))
        } else {
            let (closed, origin) = should.split_once(" from ").unwrap_or((should, "0, 0"));
            let (x, y) = origin.split_once(", ").expect("two numbers");
            match ClosedForm::read(closed) {
                Some(form) => (Place::Closed(form, [x, y].map(constant)), Tolerance::Closed(form)),
                None => (formulas(should), Tolerance::Sine(law("1"))),
            }
        };
        Self {
            link: link.to_owned(),
            on_link: numbers(on_link),
            place,
            tolerance,
            only_seen: false,
        }
    }

    /// The same, held only where rounding does not hide the side.
    pub(crate) fn where_seen(self) -> Self {
        Self { only_seen: true, ..self }
    }

    /// Where it should be.
    pub(crate) fn at(&self, motor: f64) -> [f64; 2] {
        match &self.place {
            Place::Formulas(formulas) => formulas.each_ref().map(|law| law.at(motor, &[])),
            Place::Closed(form, [x, y]) => {
                let ([u, v], _) = form.at(motor);
                [x + u, y + v]
            }
        }
    }

    /// The sine of the transmission angle.
    pub(crate) fn sine(&self, motor: f64) -> f64 {
        match &self.tolerance {
            Tolerance::Sine(law) => law.at(motor, &[]),
            Tolerance::Closed(form) => form.at(motor).1,
            Tolerance::Within(_) => 1.0,
        }
    }
}
