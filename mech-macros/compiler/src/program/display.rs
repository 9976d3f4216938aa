//! A program as text, for whoever works on the compiler: a line for each operation that something depends on.

use super::forces::Forces;
use super::newton::{Newton, Rounds};
use super::node::{BlockId, Op, Part, Slot, Value};
use super::{BlockKind, ClosedForm, Dyad, LinkRates, Program, Results, Sensitivity, Watch};
use crate::bug::bug;
use crate::model::{InputId, LinkId, Precision};
use mech_core::journey::AtZero;
use std::fmt::{self, Display, Formatter};

impl Display for Program {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let precision = match self.precision {
            Precision::F32 => "f32",
            Precision::F64 => "f64",
        };
        writeln!(f, "program {} in {precision}", self.name)?;
        self.inputs_and_state(f)?;
        for block in self.block_ids() {
            self.block(f, block)?;
        }
        self.watches(f)?;
        for (name, pose) in self.links.iter().zip(&self.poses) {
            writeln!(f, "pose {name} = {}", self.list(pose))?;
        }
        for (number, value) in self.state.iter().enumerate() {
            writeln!(f, "next s{number} = {}", self.operand(*value))?;
        }
        self.equations(f)?;
        match self.results() {
            None => Ok(()),
            Some(Results::Rates(rates)) => self.rates(f, rates),
            Some(Results::Forces { forces, .. }) => self.forces_line(f, forces),
            Some(Results::Sensitivity(sensitivity)) => self.sensitivities(f, sensitivity),
        }
    }
}

/// Writing each part.
impl Program {
    fn inputs_and_state(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (number, (name, start)) in self.input_names().zip(&self.start.motors).enumerate() {
            let kind = if number < self.motors.len() { "motor" } else { "param" };
            writeln!(f, "{kind} {name}, at the start {start:?}")?;
        }
        for (number, start) in self.start.state.iter().enumerate() {
            let meaning = self.state_meaning(number);
            writeln!(f, "state s{number}{meaning}, at the start {start:?}")?;
        }
        Ok(())
    }

    /// The meaning of a number of the state, as far as the program says it.
    fn state_meaning(&self, number: usize) -> String {
        for watch in &self.watches {
            if watch.sine == number {
                return format!(": sine of loop {}", watch.number + 1);
            }
            if watch.rounding_square == number {
                return format!(": rounding of loop {}'s sine, squared", watch.number + 1);
            }
        }
        let signs = |first: usize| (first..first + self.inputs()).contains(&number);
        if self.layout.motion_signs.is_some_and(signs) {
            return ": sign of an input's last motion".to_owned();
        }
        if let Some(angle) = self.layout.joint_angles.iter().find(|angle| angle.state == number) {
            return format!(": coordinate of joint {}", angle.joint.index());
        }
        match self.layout.places.iter().find(|place| place.state == number) {
            Some(place) => format!(": formula {} of params", place.formula.index()),
            None => String::new(),
        }
    }

    fn block(&self, f: &mut Formatter<'_>, block: BlockId) -> fmt::Result {
        let values: Vec<Value> = self
            .live_values()
            .filter(|&value| self.node(value).block == block && self.has_line(value))
            .collect();
        if values.is_empty() {
            return Ok(());
        }
        let of = &self.ssa.blocks[block.index()];
        match of.title.as_str() {
            "" => writeln!(f, "\n{}:", of.name)?,
            title => writeln!(f, "\n{}: {title}", of.name)?,
        }
        match &of.kind {
            BlockKind::Straight => self.operations(f, "  ", &values),
            BlockKind::ClosedForm(closed) => {
                self.operations(f, "  ", &values)?;
                self.closed_form_lines(f, closed)
            }
            BlockKind::Newton(newton) => self.iteration(f, newton, block, &values),
        }
    }

    fn operations(&self, f: &mut Formatter<'_>, indent: &str, values: &[Value]) -> fmt::Result {
        for &value in values {
            let node = self.node(value);
            let line = format!("{indent}v{} = {}", value.index(), self.operation(node.op));
            let says_it = matches!(node.op, Op::Input(_) | Op::Unknown(..) | Op::Solved(..));
            match &node.name {
                Some(name) if !says_it => writeln!(f, "{line:<44} // {name}")?,
                _ => writeln!(f, "{line}")?,
            }
        }
        Ok(())
    }

    fn closed_form_lines(&self, f: &mut Formatter<'_>, closed: &ClosedForm) -> fmt::Result {
        let form = match closed.dyad {
            Dyad::TwoCircles { .. } => "two circles",
            Dyad::CircleAndLine { .. } => "a circle and a line",
            Dyad::TurningLine { .. } => "a line that turns with an arm, through a point",
            Dyad::TwoLines { .. } => "two lines",
        };
        let margin = self.operand(closed.margin);
        let found = closed.found.iter().copied();
        let found: Vec<Value> = found.filter(|value| self.live[value.index()]).collect();
        writeln!(f, "  cuts {form}; found {}", self.list(&found))?;
        match self.node(closed.margin).op {
            Op::Constant(_) => writeln!(f, "  always closes"),
            _ => writeln!(f, "  closes if {margin} >= 0"),
        }
    }

    fn iteration(
        &self,
        f: &mut Formatter<'_>,
        newton: &Newton,
        block: BlockId,
        values: &[Value],
    ) -> fmt::Result {
        let is_after =
            |value: &&Value| matches!(self.node(**value).op, Op::Solved(of, _) if of == block);
        let end = values.iter().find(is_after).copied();
        let (rounds, outside): (Vec<Value>, Vec<Value>) =
            values.iter().partition(|&&value| self.node(value).iterated);
        let (after, before): (Vec<Value>, Vec<Value>) =
            outside.iter().partition(|&&value| end.is_some_and(|end| value >= end));
        self.operations(f, "  ", &before)?;
        let times = match newton.rounds {
            Rounds::UntilClosed(most) => format!("until closed, at most {most} rounds"),
            Rounds::Exactly(1) => "exactly 1 round".to_owned(),
            Rounds::Exactly(times) => format!("exactly {times} rounds"),
        };
        writeln!(f, "  newton on {}, {times}", newton.place)?;
        self.operations(f, "    ", &rounds)?;
        for (number, scalar) in newton.scalars.iter().enumerate() {
            let [first, now, next] =
                [scalar.first, scalar.now, scalar.next].map(|value| self.operand(value));
            writeln!(
                f,
                "    unknown {number} {}: first {first}, now {now}, next {next}",
                scalar.name
            )?;
        }
        writeln!(f, "    residuals {}", self.list(&newton.gap))?;
        for (number, column) in newton.columns.iter().enumerate() {
            // A system of two equations is solved by explicit formulas: its columns may be read by nothing.
            if column.iter().all(|value| self.live[value.index()]) {
                writeln!(f, "    column {number}: {}", self.list(column))?;
            }
        }
        self.limits(f, newton)?;
        self.operations(f, "  ", &after)
    }

    fn limits(&self, f: &mut Formatter<'_>, newton: &Newton) -> fmt::Result {
        let epsilon = self.precision.epsilon();
        let limits = newton.limits;
        let sign = if limits.positive { "" } else { "-" };
        writeln!(
            f,
            "    limits: size {:.3e}, residual at most {:.3e} of it",
            limits.size,
            newton.accept(epsilon)
        )?;
        writeln!(
            f,
            "    determinant {}: at the start {sign}{:.3e}, must stay beyond {sign}{:.3e}",
            self.operand(newton.det),
            limits.det,
            newton.floor(epsilon)
        )?;
        if let Some(step) = newton.contracting_step() {
            writeln!(f, "    step, squared: {}", self.operand(step))?;
        }
        match newton.extent {
            Some(extent) => writeln!(f, "    lengths that slide: {}", self.operand(extent)),
            None => Ok(()),
        }
    }

    fn watches(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f)?;
        for watch in &self.watches {
            let Watch { number, sine, rates, .. } = watch;
            let at_zero = match watch.at_zero {
                AtZero::Stay => "touches it at most",
                AtZero::ChangeBranch => "goes over to the other side",
                AtZero::Stop => "is blocked",
            };
            let bounds = if watch.guessed { "guessed" } else { "bounded" };
            let number = number + 1;
            let rates = short(rates);
            writeln!(
                f,
                "watch loop {number}: sine s{sine}; at zero it {at_zero}; rates {bounds} {rates}"
            )?;
        }
        for follow in &self.follows {
            let bounds = if follow.guessed { "guessed" } else { "bounded" };
            let rates = short(&follow.rates);
            writeln!(f, "follow an angle over whole turns: rates {bounds} {rates}")?;
        }
        Ok(())
    }

    fn equations(&self, f: &mut Formatter<'_>) -> fmt::Result {
        for (number, system) in self.systems().iter().enumerate() {
            let name = &self.ssa.blocks[system.block.index()].name;
            writeln!(f, "linear system {number} of {name}")?;
            for column in &system.columns {
                writeln!(f, "  column {}", self.list(column))?;
            }
            writeln!(f, "  right {}", self.list(&system.right))?;
        }
        for margin in self.rate_margins() {
            let value = self.operand(margin.margin);
            writeln!(f, "rates of {} are determined if {value} >= 0", margin.place)?;
        }
        Ok(())
    }

    fn rates(&self, f: &mut Formatter<'_>, rates: &LinkRates<Value>) -> fmt::Result {
        self.rows(f, "velocities", &rates.velocities)?;
        match &rates.accelerations {
            None => Ok(()),
            Some(accelerations) => self.rows(f, "accelerations", accelerations),
        }
    }

    fn forces_line(&self, f: &mut Formatter<'_>, forces: &Forces<Value>) -> fmt::Result {
        let kind = match forces {
            Forces::Holding(_) => "torques that hold it",
            Forces::InverseDynamics(_) => "inverse dynamics",
            Forces::Inertia(_) => "inertia and forces",
        };
        writeln!(f, "{kind} = {}", self.list(&forces.roots()))
    }

    /// The rates of all moving links, in the order of their declaration.
    fn rows(&self, f: &mut Formatter<'_>, what: &str, rows: &[[Value; 3]]) -> fmt::Result {
        for (number, row) in rows.iter().enumerate() {
            let stored = self.place_of(LinkId::new(number + 1));
            let name = stored
                .map_or_else(|| format!("link {}", number + 1), |place| self.links[place].clone());
            writeln!(f, "{what} {name} = {}", self.list(row))?;
        }
        Ok(())
    }

    fn sensitivities(&self, f: &mut Formatter<'_>, sensitivity: &Sensitivity) -> fmt::Result {
        for (param, rates) in self.params.iter().zip(&sensitivity.of_params) {
            for (link, row) in self.links.iter().zip(&rates.links) {
                writeln!(f, "{link} by {param} = {}", self.list(row))?;
            }
            for (point, row) in sensitivity.points.iter().zip(&rates.points) {
                writeln!(f, "axis {} by {param} = {}", point.index(), self.list(row))?;
            }
            for (joint, rate) in sensitivity.joints.iter().zip(&rates.joints) {
                let rate = self.operand(*rate);
                writeln!(f, "joint {} by {param} = {rate}", joint.index())?;
            }
        }
        Ok(())
    }
}

/// Writing values and operations.
impl Program {
    /// Whether a value has a line of its own: constants stand where they are used.
    fn has_line(&self, value: Value) -> bool {
        !matches!(self.node(value).op, Op::Constant(_))
    }

    fn list(&self, values: &[Value]) -> String {
        let values = values.iter().map(|&value| self.operand(value));
        values.collect::<Vec<_>>().join(", ")
    }

    /// A value as it is read by an operation: a constant as a number.
    fn operand(&self, value: Value) -> String {
        match self.node(value).op {
            Op::Constant(number) => format!("{:?}", number.get()),
            _ => format!("v{}", value.index()),
        }
    }

    fn input(&self, input: InputId) -> &str {
        let name = self.input_names().nth(input.index());
        name.unwrap_or_else(|| bug!("there is no input {}", input.index()))
    }

    fn slot(&self, slot: Slot) -> String {
        match slot {
            Slot::State(number) => format!("s{number}"),
            Slot::Pose(link, part) => {
                let part = match part {
                    Part::Cos => "cos",
                    Part::Sin => "sin",
                    Part::X => "x",
                    Part::Y => "y",
                };
                format!("{}.{part}", self.links[link])
            }
        }
    }

    fn unknown(&self, block: BlockId, number: usize) -> String {
        let newton = self.newton(block);
        match newton.and_then(|newton| newton.scalars.get(number)) {
            Some(scalar) => scalar.name.clone(),
            None => number.to_string(),
        }
    }

    fn operation(&self, op: Op) -> String {
        let name = match op {
            Op::Constant(number) => return format!("{:?}", number.get()),
            Op::Input(input) => return format!("input {}", self.input(input)),
            Op::Turns(input) => return format!("turns {}", self.input(input)),
            Op::PartOfTurns(input, over, under) => {
                return format!("turned {over}/{under} {}", self.input(input));
            }
            Op::Last(slot) => return format!("last {}", self.slot(slot)),
            Op::Unknown(block, number) => {
                return format!("unknown {}", self.unknown(block, number));
            }
            Op::Solved(block, number) => return format!("solved {}", self.unknown(block, number)),
            Op::Dense(_, number) => return format!("step {number} of the columns' system"),
            Op::Time => return "time".to_owned(),
            Op::Rate(motor) => {
                return format!("rate {}", self.input(InputId::of_motor(motor)));
            }
            Op::Acceleration(motor) => {
                return format!("acceleration {}", self.input(InputId::of_motor(motor)));
            }
            Op::Load(number) => return format!("load {number}"),
            Op::Linear(system, number) => {
                return format!("solution {number} of linear system {system}");
            }
            op => format!("{op:?}"),
        };
        // The name is the text before the operands.
        let name = name.split('(').next().unwrap_or(&name).to_lowercase();
        let operands: Vec<Value> = op.operands().collect();
        format!("{name} {}", self.list(&operands))
    }
}

/// Numbers to four digits.
fn short(numbers: &[f64]) -> String {
    let numbers = numbers.iter().map(|number| format!("{number:.3e}"));
    numbers.collect::<Vec<_>>().join(", ")
}
