//! Random mechanisms of which some numbers are params.

use crate::Dice;
use mech_compiler::model::{
    Axis, AxisId, AxisKind, BinaryFunction, Formula, FormulaId, Function, LinkId, Model, Now,
    Origin, Param, ParamId,
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
            let axes: Vec<usize> =
                (0..model.axes.len()).filter(|&axis| declared(&model.axes[axis])).collect();
            let (axis, part) = (*dice.pick(&axes), dice.below(2));
            if model.axes[axis].formulas[part].is_none() {
                let at = model.axes[axis].at[part];
                let formula = depending(model, dice, param, at);
                model.axes[axis].formulas[part] = Some(formula);
                let values: Vec<f64> = model.params.values().collect();
                model.axes[axis].at = place(model, &model.axes[axis], &values);
            }
        }
        if dice.below(2) == 0 {
            turn_line(model, dice, param);
        }
    }
    for (number, axis) in model.axes.iter_mut().enumerate() {
        let is_exposed = axis.kind == AxisKind::Point && axis.link != LinkId::GROUND;
        if is_exposed && model.links[axis.link.index()].die.is_none() {
            axis.name = Some(format!("a{number}"));
        }
    }
}

/// Lets a param turn a line, if there is one that none turns.
fn turn_line(model: &mut Model, dice: &mut Dice, param: ParamId) {
    let is_free = |axis: &Axis| {
        let is_declared = model.link(axis.link).die.is_none();
        axis.kind == AxisKind::Line && is_declared && !axis.turns()
    };
    let lines: Vec<usize> =
        (0..model.axes.len()).filter(|&axis| is_free(&model.axes[axis])).collect();
    if lines.is_empty() {
        return;
    }
    let line = *dice.pick(&lines);
    let [x, y] = model.axes[line].direction;
    let angle = depending(model, dice, param, y.atan2(x));
    let parts = [Function::Cos, Function::Sin]
        .map(|function| Some(model.params.formula(Formula::Of(function, angle))));
    model.axes[line].direction_formulas = parts;
    let values: Vec<f64> = model.params.values().collect();
    model.axes[line].direction = direction(model, &model.axes[line], &values);
}

/// Makes every length of a mechanism so many times as great as a param says, which is one at the start.
pub fn scale(model: &mut Model) {
    let param =
        model.params.add(Param { name: "scale".to_owned(), origin: Origin::default(), value: 1.0 });
    let scale = model.params.formula(Formula::Param(param));
    for axis in &mut model.axes {
        for part in 0..2 {
            let at = model.params.formula(Formula::constant(axis.at[part]));
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
    let one = formula(Formula::constant(1.0));
    let (made, part) = match dice.below(8) {
        0 => (symbol, value),
        1 => {
            let factor_id = formula(Formula::constant(factor));
            (formula(Formula::Mul(symbol, factor_id)), factor * value)
        }
        2 => (formula(Formula::Of(Function::Sin, symbol)), libm::sin(value)),
        3 => {
            let root = formula(Formula::Of(Function::Sqrt, symbol));
            (formula(Formula::Neg(root)), -value.sqrt())
        }
        4 => {
            let sine = formula(Formula::Of(Function::Sin, symbol));
            let part = formula(Formula::Of(Function::Atan, sine));
            let angle = formula(Formula::Of(Function::Asin, part));
            (angle, value.sin().atan().asin())
        }
        5 => {
            let angle = formula(Formula::OfBoth(BinaryFunction::Atan2, one, symbol));
            (angle, 1.0_f64.atan2(value))
        }
        6 => {
            let length = formula(Formula::OfBoth(BinaryFunction::Hypot, symbol, one));
            let far = formula(Formula::constant(100.0));
            let same = formula(Formula::OfBoth(BinaryFunction::Mod, length, far));
            (same, value.hypot(1.0))
        }
        _ => {
            let cos = formula(Formula::Of(Function::Cos, symbol));
            let inverse = formula(Formula::Div(one, symbol));
            let sum = formula(Formula::Add(cos, inverse));
            (sum, libm::cos(value) + 1.0 / value)
        }
    };
    let offset = formula(Formula::constant(part - at));
    formula(Formula::Sub(made, offset))
}

/// Where an axis is in its link with these params.
#[must_use]
pub fn place(model: &Model, axis: &Axis, params: &[f64]) -> [f64; 2] {
    pair(model, axis.at, axis.formulas, params)
}

/// The direction of an axis in its link with these params.
fn direction(model: &Model, axis: &Axis, params: &[f64]) -> [f64; 2] {
    pair(model, axis.direction, axis.direction_formulas, params)
}

fn pair(
    model: &Model,
    start: [f64; 2],
    formulas: [Option<FormulaId>; 2],
    params: &[f64],
) -> [f64; 2] {
    let variables = &[];
    let values = model.params.evaluate(&mut Now { variables, params });
    [0, 1].map(|part| formulas[part].map_or(start[part], |formula| values[formula.index()]))
}

/// The mechanism that this one is with these params: they are numbers in it.
#[must_use]
pub fn with_params(model: &Model, params: &[f64]) -> Model {
    let mut fixed = model.clone();
    for axis in &mut fixed.axes {
        axis.at = place(model, axis, params);
        axis.direction = direction(model, axis, params);
        axis.formulas = [None; 2];
        axis.direction_formulas = [None; 2];
    }
    fixed.params = mech_compiler::model::Params::default();
    fixed.effects.sensitivity = false;
    fixed
}

/// Adds an axis without a name to a link, at a place and along a direction of the scene.
pub fn add_axis(
    model: &mut Model,
    link: LinkId,
    kind: AxisKind,
    at: [f64; 2],
    direction: [f64; 2],
) -> AxisId {
    model.axes.push(Axis {
        link,
        name: None,
        port: None,
        origin: Origin::default(),
        kind,
        at,
        formulas: [None; 2],
        direction_formulas: [None; 2],
        direction,
    });
    AxisId::new(model.axes.len() - 1)
}
