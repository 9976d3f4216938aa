//! Random mechanisms of which some numbers are params.

use crate::Dice;
use mech_compiler::model::{
    Arithmetic, Axis, AxisKind, Formula, FormulaId, LinkId, Model, Origin, Param, ParamId,
};

/// Adds params, each with a part in the place of some axis, and names points. What is given as it is drawn stays as it is drawn
/// at the start.
pub fn vary(model: &mut Model, dice: &mut Dice, params: usize) {
    for number in 0..params {
        let value = dice.between(0.5, 3.0);
        let param = model.params.add(Param {
            name: format!("p{number}"),
            origin: Origin::default(),
            value,
        });
        for _ in 0..=dice.below(2) {
            let declared = |axis: &Axis| model.link(axis.link).die.is_none();
            let axes: Vec<usize> = (0..model.axes.len())
                .filter(|&axis| declared(&model.axes[axis]))
                .collect();
            let (axis, part) = (*dice.pick(&axes), dice.below(2));
            if model.axes[axis].formulas[part].is_none() {
                let at = model.axes[axis].at[part];
                let formula = depending(model, dice, param, at);
                model.axes[axis].formulas[part] = Some(formula);
                let values: Vec<f64> = model.params.values().collect();
                model.axes[axis].at = place(model, &model.axes[axis], &values);
            }
        }
    }
    for (number, axis) in model.axes.iter_mut().enumerate() {
        let told = axis.kind == AxisKind::Point && axis.link != LinkId::GROUND;
        if told && model.links[axis.link.index()].die.is_none() {
            axis.name = Some(format!("a{number}"));
        }
    }
}

/// Makes every length of a mechanism so many times as great as a param says, which is one at the start.
pub fn scale(model: &mut Model) {
    let param = model.params.add(Param {
        name: "scale".to_owned(),
        origin: Origin::default(),
        value: 1.0,
    });
    let scale = model.params.formula(Formula::Param(param));
    for axis in &mut model.axes {
        for part in 0..2 {
            let at = model.params.formula(Formula::Constant(axis.at[part]));
            axis.formulas[part] = Some(model.params.formula(Formula::Mul(scale, at)));
        }
    }
}

/// A formula that gives this number at the start, up to rounding.
fn depending(model: &mut Model, dice: &mut Dice, param: ParamId, at: f64) -> FormulaId {
    let value = model.params.all()[param.index()].value;
    let mut formula = |formula| model.params.formula(formula);
    let symbol = formula(Formula::Param(param));
    let factor = dice.between(-1.5, 1.5);
    let (made, part) = match dice.below(5) {
        0 => (symbol, value),
        1 => {
            let factor_id = formula(Formula::Constant(factor));
            (formula(Formula::Mul(symbol, factor_id)), factor * value)
        }
        2 => (formula(Formula::Sin(symbol)), libm::sin(value)),
        3 => {
            let root = formula(Formula::Sqrt(symbol));
            (formula(Formula::Neg(root)), -value.sqrt())
        }
        _ => {
            let one = formula(Formula::Constant(1.0));
            let cos = formula(Formula::Cos(symbol));
            let inverse = formula(Formula::Div(one, symbol));
            let sum = formula(Formula::Add(cos, inverse));
            (sum, libm::cos(value) + 1.0 / value)
        }
    };
    let rest = formula(Formula::Constant(part - at));
    formula(Formula::Sub(made, rest))
}

/// Where an axis is in its link with these params.
#[must_use]
pub fn place(model: &Model, axis: &Axis, params: &[f64]) -> [f64; 2] {
    let formulas = model.params.evaluate(&mut Now(params));
    [0, 1].map(|part| match axis.formulas[part] {
        None => axis.at[part],
        Some(formula) => formulas[formula.index()],
    })
}

/// The mechanism that this one is with these params: they are numbers in it.
#[must_use]
pub fn with_params(model: &Model, params: &[f64]) -> Model {
    let mut fixed = model.clone();
    for axis in &mut fixed.axes {
        axis.at = place(model, axis, params);
        axis.formulas = [None; 2];
    }
    fixed.params = mech_compiler::model::Params::default();
    fixed.effects.sensitivity = false;
    fixed
}

/// Numbers now.
struct Now<'p>(&'p [f64]);

impl Arithmetic for Now<'_> {
    type Scalar = f64;

    fn constant(&mut self, value: f64) -> f64 {
        value
    }

    fn param(&mut self, param: ParamId) -> f64 {
        self.0[param.index()]
    }

    fn neg(&mut self, a: f64) -> f64 {
        -a
    }

    fn add(&mut self, a: f64, b: f64) -> f64 {
        a + b
    }

    fn sub(&mut self, a: f64, b: f64) -> f64 {
        a - b
    }

    fn mul(&mut self, a: f64, b: f64) -> f64 {
        a * b
    }

    fn div(&mut self, a: f64, b: f64) -> f64 {
        a / b
    }

    fn sqrt(&mut self, a: f64) -> f64 {
        a.sqrt()
    }

    fn sin(&mut self, a: f64) -> f64 {
        libm::sin(a)
    }

    fn cos(&mut self, a: f64) -> f64 {
        libm::cos(a)
    }
}
