//! What is measured: quantities of the position, and summaries of the motion.

use super::angle::{is_degrees_perhaps, is_in_degrees};
use super::constant::TIME;
use super::draft::Draft;
use super::kind::{Kind, kinds};
use super::name::Referent;
use super::quantity::Quantity;
use super::reader::{Measuring, Reader};
use super::value::format_number;
use super::vector::{Subject, Vector};
use super::{coordinate, find, path};
use crate::model::{
    self, AxisId, AxisKind, Formula, JointId, JointKind, LinkId, LoadKind, Measured, ShapeKind,
    Summary,
};
use crate::syntax::Place;
use crate::syntax::ast::{End, Expr, MeasuredExpr, MovingExpr, Name, Pair, SpotExpr};
use crate::syntax::spelling;

/// The name of the transmission angles of all dyads.
const TRANSMISSION: &str = "transmission";

/// The mechanism that a requirement measures, under loads.
pub(super) struct Required<'d> {
    pub(super) draft: &'d Draft,
    /// The numbers of all loads.
    pub(super) loads: &'d [f64],
}

impl Measuring for Required<'_> {
    fn measure(&self, reader: &mut Reader, expr: &MeasuredExpr, place: Place) -> Option<Quantity> {
        let measured = reader.measured(self.draft, expr, place)?;
        let model = &self.draft.model;
        let trouble = match expr {
            MeasuredExpr::Power(name)
                if model.motor(find::motor(reader, self.draft, name)?).law.is_none() =>
            {
                let text = format!(
                    "a power needs the rate at which a motor moves; give it a law, as `motor {name} = 60 rpm * t;`"
                );
                Some((name.place(), text))
            }
            MeasuredExpr::Shaking(_) if model.lawful_motors().next().is_none() => {
                let text = "what shakes the ground needs the rate at which motors move; give one a law, as `motor MOTOR = 60 rpm * t;`";
                Some((place, text.to_owned()))
            }
            MeasuredExpr::Advantage(name, _) if !self.has_direction(reader, name)? => {
                let text = format!(
                    "an advantage is that over a load in its direction; say which, as `for {name} = (1, 0)`"
                );
                Some((place, text))
            }
            _ => None,
        };
        match trouble {
            Some((place, text)) => reader.report.refuse(place, text),
            None => Some(measured),
        }
    }
}

impl Required<'_> {
    /// Whether a load acts in some direction.
    fn has_direction(&self, reader: &mut Reader, name: &Name) -> Option<bool> {
        let number = reader.load(self.draft, name)?;
        let mut loads = self.draft.model.actions.loads_with(self.loads);
        let (load, numbers) = loads.nth(number)?;
        let is_torque = matches!(load.kind, LoadKind::Torque(_));
        Some(is_torque || numbers != [0.0; 2])
    }
}

/// The mechanism that a table measures: whoever asks for it gives rates and loads.
pub(super) struct Tabulated<'d>(pub(super) &'d Draft);

impl Measuring for Tabulated<'_> {
    fn measure(&self, reader: &mut Reader, expr: &MeasuredExpr, place: Place) -> Option<Quantity> {
        let subject = self.subject(reader, expr, place)?;
        reader.number(subject, expr, place)
    }
}

impl Tabulated<'_> {
    /// Finds out what is measured: `t` is the time, if nothing else is called so.
    pub(super) fn subject(
        &self,
        reader: &mut Reader,
        expr: &MeasuredExpr,
        place: Place,
    ) -> Option<Subject> {
        if let MeasuredExpr::Moving(None, MovingExpr { named: Some(name), point: None, .. }) = expr
            && name.name == TIME
            && reader.names.get(TIME).is_none()
            && !reader.constants().has(TIME)
        {
            let time = reader.variable_for(Measured::Quantity(model::Quantity::Time))?;
            return Some(Subject::Number(time));
        }
        reader.subject(self.0, expr, place)
    }
}

impl Reader<'_> {
    fn measured(&mut self, draft: &Draft, expr: &MeasuredExpr, place: Place) -> Option<Quantity> {
        let subject = self.subject(draft, expr, place)?;
        self.number(subject, expr, place)
    }

    /// A number; of a vector without a part its length.
    fn number(&mut self, subject: Subject, expr: &MeasuredExpr, place: Place) -> Option<Quantity> {
        match subject {
            Subject::Number(number) => Some(number),
            Subject::Vector(vector, None) if vector.is_place() => {
                let text = format!("`{expr}` is a place; measure `{expr}.x` or `{expr}.y`");
                self.report.refuse(place, text)
            }
            Subject::Vector(vector, part) => self.part_of_vector(vector, part),
        }
    }

    /// Finds out what is measured.
    pub(super) fn subject(
        &mut self,
        draft: &Draft,
        expr: &MeasuredExpr,
        place: Place,
    ) -> Option<Subject> {
        let quantity = match expr {
            MeasuredExpr::Moving(rate, of) => return self.moving(draft, *rate, of),
            MeasuredExpr::Transmission(joint) => {
                model::Quantity::Transmission(Some(find::joint(self, draft, joint)?))
            }
            MeasuredExpr::Pressure(cam) => {
                model::Quantity::Pressure(self.cam_with_roller(draft, cam)?)
            }
            MeasuredExpr::Curvature(name) => {
                let cam = self.cam_with_roller(draft, name)?;
                self.refuse_corner(draft, cam, name)?;
                model::Quantity::Curvature(cam)
            }
            MeasuredExpr::Angle(link, None) => {
                model::Quantity::Angle(self.moving_link(draft, link)?)
            }
            MeasuredExpr::Angle(from, Some(to)) => {
                let (from, to) = (find::link(self, draft, from), find::link(self, draft, to));
                model::Quantity::AngleBetween([from?, to?])
            }
            MeasuredExpr::Distance(spots) => self.distance(draft, spots, place)?,
            MeasuredExpr::Clearance(links) => self.clearance(draft, links, place)?,
            MeasuredExpr::Centre(names, part) => {
                let links = self.two_links(draft, names, place)?;
                return Some(Subject::Vector(Vector::Centre(links), *part));
            }
            MeasuredExpr::Summary(summary, word, of) => {
                let inner = self.quantity(of)?;
                let summary = self.summary((*summary, word), (of, inner), place)?;
                return Some(Subject::Number(summary));
            }
            MeasuredExpr::Dwell([of, width]) => {
                let inner = self.quantity(of)?;
                let width = self.width(draft, (of, inner), width)?;
                let dwell = (Summary::Dwell(width), "dwell");
                return self.summary(dwell, (of, inner), place).map(Subject::Number);
            }
            MeasuredExpr::Influence(of, motor) => {
                let motor = find::motor(self, draft, motor);
                let of = self.quantity(of)?;
                let (Some(of), Some(motor)) = (of.formula, motor) else {
                    motor?;
                    let text = "this never changes: nothing has an influence on it";
                    return self.report.refuse(place, text);
                };
                let influence = self.variable_for(Measured::Influence(of, motor))?;
                return Some(Subject::Number(influence));
            }
            MeasuredExpr::Advantage(load, motor) => {
                let motor = find::motor(self, draft, motor);
                model::Quantity::Advantage(self.load(draft, load)?, motor?)
            }
            MeasuredExpr::Torque(motor) => {
                model::Quantity::Torque(find::motor(self, draft, motor)?)
            }
            MeasuredExpr::Power(motor) => model::Quantity::Power(find::motor(self, draft, motor)?),
            MeasuredExpr::Reaction(reaction) => return self.reaction(draft, reaction),
            MeasuredExpr::Shaking(part) => {
                self.refuse_massless(draft, false, place)?;
                return Some(Subject::Vector(Vector::Shaking, *part));
            }
        };
        self.variable_for(Measured::Quantity(quantity)).map(Subject::Number)
    }

    /// The number of a load.
    pub(super) fn load(&mut self, draft: &Draft, name: &Name) -> Option<usize> {
        let key = path::key(self, name)?;
        let loads = &draft.model.actions.loads;
        if let Some(number) = loads.iter().position(|load| load.name == key) {
            return Some(number);
        }
        let names: Vec<&str> = loads.iter().map(|load| load.name.as_str()).collect();
        let text = if names.is_empty() {
            format!("there is no load `{name}`; declare one, as `load {name} = force(LINK.POINT);`")
        } else {
            format!("unknown load `{name}`{}", spelling::remedy(&key, &names))
        };
        self.report.refuse(name.place(), text)
    }

    /// Whether a name is that of a motor.
    pub(super) fn is_motor(&mut self, draft: &Draft, name: &Name) -> bool {
        let key = path::key(self, name);
        let mut motors = draft.model.motors.iter();
        motors.any(|motor| Some(&draft.model.joint(motor.joint).name) == key.as_ref())
    }

    fn two_links(&mut self, draft: &Draft, names: &[Name; 2], place: Place) -> Option<[LinkId; 2]> {
        let links = names.each_ref().map(|name| find::link(self, draft, name));
        let links = [links[0]?, links[1]?];
        if links[0] == links[1] {
            let text = format!("`{}` is no two links: name another one beside it", names[0]);
            return self.report.refuse(place, text);
        }
        Some(links)
    }

    /// A new variable of the requirement.
    pub(super) fn variable_for(&mut self, measured: Measured) -> Option<Quantity> {
        let all = &mut self.law.as_mut()?.measured;
        let known = all.iter().position(|known| *known == measured);
        let number = known.unwrap_or_else(|| {
            all.push(measured);
            all.len() - 1
        });
        Some(Quantity {
            value: None,
            formula: Some(self.formulas().add(Formula::Variable(number))),
        })
    }

    /// Whether a name is that of a constant; nothing if it is also one of the mechanism.
    pub(super) fn is_constant(&mut self, name: &Name) -> Option<bool> {
        let text = name.name.to_string();
        if !name.uses.is_empty() || !self.constants().has(&text) {
            return Some(false);
        }
        let other = match find::look_up(self, name) {
            Some(Referent::Link(_)) => "link",
            Some(Referent::Joint(_)) => "joint",
            _ => return Some(true),
        };
        let word = self.constants().word_for(&name.name);
        let text =
            format!("`{text}` is a {word}, and a {other} too; give one of them another name");
        self.report.refuse(name.place(), text)
    }

    /// The coordinate of a joint, or the angle of a link.
    pub(super) fn named(&mut self, draft: &Draft, name: &Name) -> Option<model::Quantity> {
        match find::look_up(self, name) {
            Some(Referent::Broken) => None,
            Some(Referent::Joint(joint)) => {
                let joint = joint?;
                if let Some(text) = coordinate::missing(&draft.model, name, joint, "measure") {
                    return self.report.refuse(name.place(), text);
                }
                Some(model::Quantity::Coordinate(joint))
            }
            Some(Referent::Link(_) | Referent::Use) => {
                Some(model::Quantity::Angle(self.moving_link(draft, name)?))
            }
            None if name.uses.is_empty() && name.name == TRANSMISSION => {
                Some(model::Quantity::Transmission(None))
            }
            None => {
                let text = name.to_string();
                if let Some(link) = find::point_called(&draft.model, &text) {
                    let point = format!("{}.{text}", draft.model.link(link).name);
                    let text = format!("`{text}` is a point; measure `{point}.x` or `{point}.y`");
                    return self.report.refuse(name.place(), text);
                }
                let key = self.key_of(&name.name);
                let joints = self.names.joints(&key);
                let mut known = [self.names.links(&key), joints].concat();
                known.push(TRANSMISSION);
                let numbers = self.constants().names_before(self.report.statement());
                let numbers = numbers.filter(|name| *name != text);
                let all: Vec<&str> = known.iter().copied().chain(numbers).collect();
                let near = spelling::nearest(&text, &all);
                let remedy =
                    spelling::remedy(&text, near.as_ref().map_or(&known, std::slice::from_ref));
                let text = format!(
                    "nothing is called `{text}` that could be measured{remedy}\n\nhelp: a point is measured as `link.point.x`; there are also `transmission`, `angle(link)`, `distance(link.point, link.point)`"
                );
                let unknown = self.unknown_number(&name.name);
                self.report.refuse_unknown(unknown, name.place(), text)
            }
        }
    }

    fn moving_link(&mut self, draft: &Draft, name: &Name) -> Option<LinkId> {
        let link = find::link(self, draft, name)?;
        if link == LinkId::GROUND {
            let text = format!("`{name}` does not move: there is nothing to measure");
            return self.report.refuse(name.place(), text);
        }
        Some(link)
    }

    /// A cam whose roller is declared.
    fn cam_with_roller(&mut self, draft: &Draft, name: &Name) -> Option<JointId> {
        let cam = find::joint(self, draft, name)?;
        let text = match draft.model.joint(cam).kind {
            JointKind::Cam { shaft, .. }
                if matches!(draft.model.joint(shaft).kind, JointKind::Prismatic(..)) =>
            {
                format!("the shaft of `{name}` slides; this is measured of a cam that turns")
            }
            JointKind::Cam { .. } if draft.model.roller_of(cam).is_some() => return Some(cam),
            JointKind::Cam { .. } => format!(
                "nobody knows where `{name}` is followed; add `roller LINK.POINT radius 1` to it, after its brackets"
            ),
            _ => format!("`{name}` is no cam; this is measured of a cam with a roller"),
        };
        self.report.refuse(name.place(), text)
    }

    /// Complains about a cam whose disc has a corner.
    fn refuse_corner(&mut self, draft: &Draft, cam: JointId, name: &Name) -> Option<()> {
        let params: Vec<f64> = draft.model.params.values().collect();
        let mut cams = draft.model.cams();
        let (.., law) = cams.find(|(one, ..)| *one == cam)?;
        let jump = law.first_jump_in_turn(&params, false);
        let Some(jump) = jump else {
            return Some(());
        };
        let text = format!(
            "the disc of `{name}` has a corner at q = {} deg, where the rate of its law jumps: no curvature tells what a roller does there",
            format_number((jump.at.to_degrees() * 1e4).round() / 1e4)
        );
        self.report.refuse(name.place(), text)
    }

    pub(super) fn axis(
        &mut self,
        draft: &Draft,
        end: &End,
        kind: Option<AxisKind>,
    ) -> Option<AxisId> {
        let body = find::body(self, draft, &end.link)?;
        let Some(name) = &end.axis else {
            let text = format!("`{end}` is a link; name one of its points, as `{end}.tip`");
            return self.report.refuse(end.place(), text);
        };
        let axis = find::axis(self, draft, body, name, kind)?;
        if kind == Some(AxisKind::Point) && draft.model.axis(axis).kind == AxisKind::Line {
            let text = format!("`{end}` is a line, which has no one place; name a point");
            return self.report.refuse(end.place(), text);
        }
        Some(axis)
    }

    fn distance(
        &mut self,
        draft: &Draft,
        spots: &[SpotExpr; 2],
        place: Place,
    ) -> Option<model::Quantity> {
        let [from, to] = spots.each_ref().map(|spot| match spot {
            SpotExpr::Axis(end) => self.axis(draft, end, None).map(model::Spot::Axis),
            SpotExpr::At(pair) => self.fixed_place(pair).map(model::Spot::At),
        });
        let spots = [from?, to?];
        let is_line = |spot: &model::Spot| match spot {
            model::Spot::Axis(axis) => draft.model.axis(*axis).kind == AxisKind::Line,
            model::Spot::At(_) => false,
        };
        if spots.iter().all(is_line) {
            let text = "two lines have no one distance; measure that of a point and a line";
            return self.report.refuse(place, text);
        }
        Some(model::Quantity::Distance(spots))
    }

    fn clearance(
        &mut self,
        draft: &Draft,
        names: &[Name; 2],
        place: Place,
    ) -> Option<model::Quantity> {
        let links = self.two_links(draft, names, place)?;
        for (link, name) in links.into_iter().zip(names) {
            let text = match &draft.model.link(link).shapes[..] {
                // Perhaps its shape could not be read.
                [] if !self.report.is_empty() => return None,
                [] => format!(
                    "`{name}` has no shape, so nobody knows how far it reaches; give it one, as `bar [(0, 0), (1, 0)] width 0.2`"
                ),
                shapes if shapes.iter().any(|shape| matches!(shape.kind, ShapeKind::Figure(_))) => {
                    format!(
                        "`{name}` has a figure; clearances are measured of circles, rings, bars and polygons"
                    )
                }
                _ => continue,
            };
            return self.report.refuse(name.place(), text);
        }
        Some(model::Quantity::Clearance(links))
    }

    /// A place of the scene.
    fn fixed_place(&mut self, pair: &Pair) -> Option<[f64; 2]> {
        let [x, y] = [&pair.x, &pair.y].map(|expr| {
            let quantity = self.quantity(expr)?;
            if quantity.formula.is_some() {
                let text = format!("`{expr}` may change; name a point of a link, or a number");
                return self.report.refuse(expr.place, text);
            }
            quantity.value
        });
        Some([x?, y?])
    }

    /// The width within which something has to stay.
    fn width(
        &mut self,
        draft: &Draft,
        (of, inner): (&Expr, Quantity),
        width: &Expr,
    ) -> Option<f64> {
        let value = self.quantity(width)?;
        let (Some(value), None) = (value.value, value.formula) else {
            let text = format!("`{width}` may change; a dwell is within a width that does not");
            return self.report.refuse(width.place, text);
        };
        if !(value > 0.0 && value.is_finite()) {
            let text = format!("a dwell is within some width; `{width}` is none");
            return self.report.refuse(width.place, text);
        }
        let kind = inner.formula.map(|formula| {
            let measured = self.law.as_ref().map_or(&[][..], |law| &law.measured);
            let measured = measured.to_vec();
            kinds(&draft.model, self.formulas(), &measured)[formula.index()]
        });
        match kind {
            Some(Kind::Angle) if is_degrees_perhaps(self.report, width, value) => None,
            Some(Kind::Length) if is_in_degrees(width) => {
                let text = format!("`{of}` is a length, and `{width}` is an angle");
                self.report.refuse(width.place, text)
            }
            _ => Some(value),
        }
    }

    fn summary(
        &mut self,
        (summary, word): (Summary, &str),
        (of, inner): (&Expr, Quantity),
        place: Place,
    ) -> Option<Quantity> {
        if let Some(mut formula) = inner.formula {
            if summary == Summary::Rms {
                formula = self.formulas().add(Formula::Mul(formula, formula));
            }
            return self.variable_for(Measured::Summary(summary, formula));
        }
        let text = format!("`{of}` never changes; leave `{word}` out");
        self.report.refuse(place, text)
    }
}
