//! What makers of machines expect of them, in their texts: each `expect` is proved, and holds at a thousand positions, as it is measured there
//! from the poses of links. What is true and cannot be proved yet stands beside it as `// open`: it is not refused.

use mech_compiler::evaluate::Machine;
use mech_compiler::model::{
    AxisId, Condition, Formula, FormulaArithmetic, FormulaId, JointId, JointKind, LinkId, Measured,
    Model, Now, Quantity, Requirement, Spot, Summary,
};
use mech_compiler::structure::{Diagnosis, RequirementTrouble};
use mech_compiler::{Analysis, Compiled, analyse};
use mech_test_support::{Dice, coordinate, cross, dot, folder, with_ground};
use proc_macro2::TokenStream;
use std::f64::consts::{PI, TAU};

/// Positions that are looked at, half of them each way from the start.
const POSITIONS: u32 = 1000;
/// A motor is moved so far to see how fast something changes with it.
const STEP: f64 = 1e-5;

/// A mechanism and one of its requirements.
struct Sampled<'a> {
    model: &'a Model,
    compiled: &'a Compiled,
    requirement: &'a Requirement,
}

/// What the variables of a requirement are, at a value of its motor.
type Row = (f64, Vec<f64>);

impl Sampled<'_> {
    /// Whether it can be measured here.
    fn is_known(&self) -> bool {
        self.requirement.measured.iter().all(|measured| match measured {
            Measured::Quantity(Quantity::Transmission(None)) => {
                let start = Machine::<f64>::new(&self.compiled.program);
                self.transmission(&start).is_some()
            }
            Measured::Quantity(
                Quantity::Transmission(Some(_))
                | Quantity::Clearance(_)
                | Quantity::Pressure(_)
                | Quantity::Curvature(_),
            )
            | Measured::Rate(..) => false,
            Measured::Quantity(_) | Measured::Influence(..) => true,
            Measured::Summary(summary, _) => !matches!(summary, Summary::Mean | Summary::Rms),
        })
    }

    /// Looks at it wherever its motors may be.
    fn hold(&self, told: &str) {
        let Condition::Bounds { bounds, .. } = &self.requirement.condition else {
            return self.turn(told);
        };
        let rows = self.rows();
        assert!(rows.len() > POSITIONS as usize / 2, "{told}: {} positions", rows.len());
        let summaries: Vec<Option<f64>> = self.summaries(&rows);
        let size = self.model.size().max(1.0);
        for (by, variables) in &rows {
            let known = variables.iter().zip(&summaries);
            let all: Vec<f64> = known.map(|(own, summed)| summed.unwrap_or(*own)).collect();
            for bound in bounds {
                let margin = self.value(bound.margin, &all);
                assert!(margin > -self.rounding() * size, "{told}: {margin} at {by}, {all:?}");
            }
        }
    }

    /// How exactly it is measured here.
    fn rounding(&self) -> f64 {
        let parts = self.requirement.measured.iter().map(|measured| match measured {
            Measured::Quantity(_) => 1e-9,
            Measured::Influence(..) | Measured::Rate(..) => 1e-6,
            Measured::Summary(Summary::Dwell(_) | Summary::TimeRatio, _) => 0.02,
            Measured::Summary(..) => 1e-4,
        });
        parts.fold(0.0, f64::max)
    }

    /// The motor turns right round, both ways.
    fn turn(&self, told: &str) {
        let Condition::Turns(motor) = self.requirement.condition else {
            return;
        };
        for way in [-TAU, TAU] {
            let mut machine = Machine::<f64>::new(&self.compiled.program);
            let mut motors = machine.position().motors.clone();
            let start = motors[motor.index()];
            for step in 1..=POSITIONS / 2 {
                motors[motor.index()] = start + way * f64::from(step) / f64::from(POSITIONS / 2);
                assert_eq!(machine.move_to(&motors), Ok(()), "{told}: {motors:?}");
            }
        }
    }

    /// The values between which each motor moves, which has more than one.
    fn ends(&self) -> Vec<(usize, [f64; 2])> {
        let ends = self.model.motor_ids().map(|motor| {
            let mut cases = self.requirement.cases.iter();
            let case = cases.find(|case| case.motor == motor).map(|case| case.ends);
            let own = self.model.motor(motor);
            let range = own.range.as_ref().map(|range| [range.low, range.high]);
            let start = self.compiled.program.start.motors[motor.index()];
            let far = match self.model.joint(own.joint).kind {
                JointKind::Revolute(..) => PI,
                _ => 2.0 * self.model.size(),
            };
            let all = [start - far, start + far];
            (motor.index(), case.or(range).unwrap_or(all))
        });
        ends.collect()
    }

    /// What it measures in all positions: in the order of its motor if one moves.
    fn rows(&self) -> Vec<Row> {
        let ends = self.ends();
        let moving: Vec<_> = ends.iter().filter(|(_, [low, high])| low < high).collect();
        let mut base = self.compiled.program.start.motors.clone();
        for (motor, [low, high]) in &ends {
            base[*motor] = base[*motor].clamp(*low, *high);
        }
        if let [(motor, ends)] = moving[..] {
            let mut rows = self.walk(&base, *motor, ends[0]);
            rows.reverse();
            rows.pop();
            rows.extend(self.walk(&base, *motor, ends[1]));
            return rows;
        }
        let (mut rows, mut dice) = (Vec::new(), Dice::new(1));
        let mut machine = Machine::<f64>::new(&self.compiled.program);
        let mut before = self.variables(&machine, None);
        for _ in 0..POSITIONS {
            let from = machine.position().motors.clone();
            let to = moving.iter().map(|(motor, [low, high])| (*motor, dice.between(*low, *high)));
            let to: Vec<(usize, f64)> = to.collect();
            // Angles are followed on the way.
            for part in 1..=8 {
                let mut motors = base.clone();
                for (motor, end) in &to {
                    motors[*motor] = from[*motor] + (end - from[*motor]) * f64::from(part) / 8.0;
                }
                if machine.move_to(&motors).is_err() {
                    break;
                }
                before = self.variables(&machine, Some(&before));
                rows.push((0.0, before.clone()));
            }
        }
        rows
    }

    /// What it measures on the way of a motor from the start to an end, as far as it goes.
    fn walk(&self, base: &[f64], motor: usize, end: f64) -> Vec<Row> {
        let mut machine = Machine::<f64>::new(&self.compiled.program);
        machine.move_to(base).expect("all other motors come there");
        let mut before = self.variables(&machine, None);
        let mut rows = vec![(base[motor], before.clone())];
        if (end - base[motor]).abs() < STEP {
            return rows;
        }
        for step in 1..=POSITIONS / 2 {
            let mut motors = base.to_vec();
            motors[motor] += (end - base[motor]) * f64::from(step) / f64::from(POSITIONS / 2);
            if machine.move_to(&motors).is_err() {
                break;
            }
            before = self.variables(&machine, Some(&before));
            rows.push((motors[motor], before.clone()));
        }
        rows
    }

    /// The variables where a machine is: angles near to what they were before. What sums up the motion is not known there.
    fn variables(&self, machine: &Machine<'_, f64>, before: Option<&Vec<f64>>) -> Vec<f64> {
        let model = self.model;
        let at = machine.position();
        let poses = with_ground(model, &at.poses);
        let place = |axis: AxisId| {
            let axis = model.axis(axis);
            let [cos, sin, x, y] = poses[axis.link.index()];
            let [u, v] = axis.at;
            [x + cos * u - sin * v, y + sin * u + cos * v]
        };
        let heading = |link: LinkId| {
            let [cos, sin, ..] = poses[link.index()];
            sin.atan2(cos)
        };
        let spot = |spot: Spot| match spot {
            Spot::Axis(axis) => place(axis),
            Spot::At(at) => at,
        };
        let measured = self.requirement.measured.iter().enumerate();
        let mut all: Vec<f64> = Vec::new();
        for (number, measured) in measured {
            let near = |angle: f64| match before {
                Some(before) => angle + TAU * ((before[number] - angle) / TAU).round(),
                None => angle,
            };
            all.push(match *measured {
                Measured::Quantity(quantity) => match quantity {
                    Quantity::Coordinate(joint) => match model.motor_of(joint) {
                        Some(motor) => at.motors[motor.index()],
                        None => match coordinate(model, &poses, joint) {
                            (angle, true) => near(angle),
                            (slide, false) => slide,
                        },
                    },
                    Quantity::Angle(link) => near(heading(link)),
                    Quantity::AngleBetween([from, to]) => near(heading(to) - heading(from)),
                    Quantity::X(axis) => place(axis)[0],
                    Quantity::Y(axis) => place(axis)[1],
                    Quantity::Distance(ends) => {
                        let [from, to] = ends.map(spot);
                        (to[0] - from[0]).hypot(to[1] - from[1])
                    }
                    Quantity::Transmission(_) => {
                        self.transmission(machine).expect("it is a dyad of pins or slides")
                    }
                    other => panic!("{other:?} is not measured here"),
                },
                Measured::Rate(..) => panic!("rates are not measured here"),
                Measured::Influence(of, motor) => {
                    let ends = [STEP, -STEP].map(|step| {
                        let mut other = machine.clone();
                        let mut motors = at.motors.clone();
                        motors[motor.index()] += step;
                        other.move_to(&motors).ok()?;
                        let known = self.without_influences(&other, &all);
                        Some(self.value(of, &known))
                    });
                    let here = self.value(of, &self.without_influences(machine, &all));
                    match ends {
                        [Some(up), Some(down)] => (up - down) / (2.0 * STEP),
                        [Some(up), None] => (up - here) / STEP,
                        [_, down] => (here - down.expect("it moves one way")) / STEP,
                    }
                }
                Measured::Summary(..) => f64::NAN,
            });
        }
        all
    }

    /// The variables that stand before the first influence coefficient, where a machine is, beside others.
    fn without_influences(&self, machine: &Machine<'_, f64>, beside: &[f64]) -> Vec<f64> {
        let measured = &self.requirement.measured[..beside.len()];
        let is_influence = |measured: &Measured| matches!(measured, Measured::Influence(..));
        let first = measured.iter().position(is_influence);
        let requirement = Requirement {
            measured: measured[..first.unwrap_or(measured.len())].to_vec(),
            ..self.requirement.clone()
        };
        let alone = Sampled { requirement: &requirement, ..*self };
        alone.variables(machine, Some(&beside.to_vec()))
    }

    /// The least transmission angle of all loops, by the places of their pins and the ways of their slides. None where a loop is no dyad of
    /// two links, or its slide turns.
    fn transmission(&self, machine: &Machine<'_, f64>) -> Option<f64> {
        let model = self.model;
        let poses = with_ground(model, &machine.position().poses);
        let links = |joint: JointId| {
            let axes = model.joint(joint).kind.axes().unwrap_or_else(|| panic!("{joint:?}"));
            axes.map(|axis| model.axis(axis).link)
        };
        let meet = |a: JointId, b: JointId| links(a).iter().any(|link| links(b).contains(link));
        let place = |joint: JointId| {
            let axes = model.joint(joint).kind.axes().unwrap_or_else(|| panic!("{joint:?}"));
            let axis = model.axis(axes[0]);
            let [cos, sin, x, y] = poses[axis.link.index()];
            let turned = |[u, v]: [f64; 2]| [cos * u - sin * v, sin * u + cos * v];
            let [u, v] = turned(axis.at);
            ([x + u, y + v], turned(axis.direction))
        };
        let between = |a: JointId, b: JointId| {
            let ([from, _], [to, _]) = ([place(a).0, [0.0; 2]], [place(b).0, [0.0; 2]]);
            [to[0] - from[0], to[1] - from[1]]
        };
        let angles = self.compiled.plan.loops().map(|ring| {
            let is_pin =
                |joint: &JointId| matches!(model.joint(*joint).kind, JointKind::Revolute(..));
            let (pins, slides): (Vec<JointId>, Vec<JointId>) =
                ring.unknowns().into_iter().partition(is_pin);
            match (&pins[..], &slides[..]) {
                (&[a, b, c], []) => {
                    let dyads = [[a, b, c], [b, a, c], [c, a, b]];
                    let mut dyads = dyads.iter();
                    let &[middle, one, other] = dyads.find(|[middle, one, other]| {
                        meet(*middle, *one) && meet(*middle, *other) && !meet(*one, *other)
                    })?;
                    let [one, other] = [one, other].map(|end| between(middle, end));
                    Some(cross(one, other).abs().atan2(dot(one, other).abs()))
                }
                (&[a, b], &[slide]) if meet(a, b) && (meet(a, slide) != meet(b, slide)) => {
                    let (rod, along) = (between(a, b), place(slide).1);
                    Some(dot(rod, along).abs().atan2(cross(rod, along).abs()))
                }
                _ => None,
            }
        });
        let angles: Vec<f64> = angles.collect::<Option<_>>()?;
        angles.into_iter().reduce(f64::min)
    }

    /// What sums up all rows, for each variable that does.
    fn summaries(&self, rows: &[Row]) -> Vec<Option<f64>> {
        let measured = self.requirement.measured.iter();
        let summed = measured.map(|measured| {
            let Measured::Summary(summary, of) = *measured else {
                return None;
            };
            let values: Vec<(f64, f64)> =
                rows.iter().map(|(by, row)| (*by, self.value(of, row))).collect();
            let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
            let (least, greatest) =
                (values.iter().min_by(by_value)?, values.iter().max_by(by_value)?);
            Some(match summary {
                Summary::Min => least.1,
                Summary::Max => greatest.1,
                Summary::Swing => greatest.1 - least.1,
                Summary::TimeRatio => {
                    let one = (greatest.0 - least.0).rem_euclid(TAU);
                    one.max(TAU - one) / one.min(TAU - one)
                }
                Summary::Dwell(width) => longest(&values, width),
                other => panic!("{other:?} is not sampled"),
            })
        });
        summed.collect()
    }

    /// A formula of the requirement, for these variables.
    fn value(&self, id: FormulaId, variables: &[f64]) -> f64 {
        let of = |id: FormulaId| self.value(id, variables);
        let mut now = Now { variables: &[], params: &[] };
        match self.requirement.formulas.all()[id.index()] {
            Formula::Constant(number) => number.get(),
            Formula::Variable(number) => variables[number],
            Formula::Param(_) => f64::NAN,
            Formula::Neg(a) => -of(a),
            Formula::Add(a, b) => of(a) + of(b),
            Formula::Sub(a, b) => of(a) - of(b),
            Formula::Mul(a, b) => of(a) * of(b),
            Formula::Div(a, b) => of(a) / of(b),
            Formula::Of(function, a) => now.of(function, of(a)),
            Formula::OfBoth(function, a, b) => now.of_both(function, of(a), of(b)),
            Formula::Stairs(stairs, a, share) => now.stairs(stairs, of(a), share),
        }
    }
}

/// The longest way on which values stay within a width: whole turns go on from their end.
fn longest(values: &[(f64, f64)], width: f64) -> f64 {
    let way = values[values.len() - 1].0 - values[0].0;
    let is_round = (way - TAU).abs() < 1e-6;
    let again = values.iter().map(|(by, value)| (by + TAU, *value));
    let again = again.filter(|_| is_round);
    let all: Vec<(f64, f64)> = values.iter().copied().chain(again).collect();
    let ways = (0..values.len()).map(|first| {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        let within = all[first..].iter().take_while(|(_, value)| {
            (low, high) = (low.min(*value), high.max(*value));
            high - low <= width
        });
        within.last().map_or(0.0, |(by, _)| by - all[first].0)
    });
    ways.fold(0.0, f64::max).min(way)
}

fn proved(text: &str) -> Analysis {
    let tokens: TokenStream = text.parse().expect("tokens");
    analyse(tokens).prove()
}

#[test]
fn what_is_expected_of_machines_is_proved_and_holds_where_they_are_sampled() {
    let (mut texts, mut facts, mut sampled, mut open) = (0, 0, 0, 0);
    for case in folder("expected") {
        let analysis = proved(&case.text);
        let model = &analysis.parsed.model;
        let compiled = match &analysis.result {
            Ok(compiled) => compiled,
            Err(faults) => panic!("{}: {:?}", case.name, faults.messages),
        };
        texts += usize::from(!model.requirements.is_empty());
        for requirement in &model.requirements {
            facts += 1;
            let one = Sampled { model, compiled, requirement };
            if one.is_known() {
                sampled += 1;
                one.hold(&format!("{}: {}", case.name, requirement.written));
            }
        }
        for line in case.marks("open") {
            open += 1;
            let statements: String = case
                .statements()
                .filter(|line| !line.starts_with("expect "))
                .map(|line| format!("{line}\n"))
                .collect();
            let analysis = proved(&format!("{statements}expect {line};"));
            let Err(faults) = analysis.result else {
                panic!("{}: `{line}` is proved now: let it be expected", case.name);
            };
            let is_open = |found: &Diagnosis| match found {
                Diagnosis::Unmet { trouble, .. } => !matches!(
                    trouble,
                    RequirementTrouble::Fails(_) | RequirementTrouble::Stops { .. }
                ),
                _ => false,
            };
            assert!(
                !faults.diagnoses.is_empty() && faults.diagnoses.iter().all(is_open),
                "{}: {line}: {:?}",
                case.name,
                faults.messages
            );
        }
    }
    println!("{facts} facts of {texts} texts proved, {sampled} of them sampled, {open} open");
    assert!(texts >= 40 && 10 * sampled > 9 * facts);
}
