//! What is measured: quantities of the position, and summaries of the motion.

use super::angle::{is_degrees_perhaps, is_in_degrees};
use super::draft::Draft;
use super::kind::{Kind, kinds};
use super::name::Referent;
use super::quantity::Quantity;
use super::reader::{Measuring, Reader};
use super::value::format_number;
use super::{coordinate, find, path};
use crate::bug::bug;
use crate::model::{
    self, AxisKind, BinaryFunction, Formula, JointId, JointKind, LinkId, Measured, Rate,
    ReactionPart, ShapeKind, Summary,
};
use crate::syntax::Place;
use crate::syntax::ast::{
    End, Expr, MeasuredExpr, MovingExpr, Name, Pair, ReactionExpr, SpotExpr, VectorPart,
};
use crate::syntax::spelling;

/// The name of the transmission angles of all dyads.
const TRANSMISSION: &str = "transmission";

/// The mechanism that a requirement measures.
pub(super) struct OfDraft<'d>(pub(super) &'d Draft);

impl Measuring for OfDraft<'_> {
    fn measure(&self, reader: &mut Reader, expr: &MeasuredExpr, place: Place) -> Option<Quantity> {
        reader.measured(self.0, expr, place)
    }
}

impl Reader<'_> {
    fn measured(&mut self, draft: &Draft, expr: &MeasuredExpr, place: Place) -> Option<Quantity> {
        let quantity = match expr {
            MeasuredExpr::Named(name) if self.is_constant(name)? => {
                return self.constant(&name.name, place);
            }
            MeasuredExpr::Named(name) => self.named(draft, name)?,
            MeasuredExpr::Place(point, is_ordinate) => {
                let axis = self.axis(draft, point, Some(AxisKind::Point))?;
                if *is_ordinate {
                    model::Quantity::Y(axis)
                } else {
                    model::Quantity::X(axis)
                }
            }
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
            MeasuredExpr::Summary(summary, word, of) => {
                let inner = self.quantity(of)?;
                return self.summary((*summary, word), (of, inner), place);
            }
            MeasuredExpr::Dwell([of, width]) => {
                let inner = self.quantity(of)?;
                let width = self.width(draft, (of, inner), width)?;
                let dwell = (Summary::Dwell(width), "dwell");
                return self.summary(dwell, (of, inner), place);
            }
            MeasuredExpr::Influence(of, motor) => {
                let motor = find::motor(self, draft, motor);
                let of = self.quantity(of)?;
                let (Some(of), Some(motor)) = (of.formula, motor) else {
                    motor?;
                    let text = "this never changes: nothing has an influence on it";
                    return self.report.refuse(place, text);
                };
                return self.variable_for(Measured::Influence(of, motor));
            }
            MeasuredExpr::Rate(rate, moving) => return self.rate(draft, *rate, moving),
            MeasuredExpr::Torque(motor) => {
                model::Quantity::Torque(find::motor(self, draft, motor)?)
            }
            MeasuredExpr::Power(motor) => return self.power(draft, motor),
            MeasuredExpr::Reaction(reaction) => return self.reaction(draft, reaction),
        };
        self.variable_for(Measured::Quantity(quantity))
    }

    /// The velocity or acceleration of something that moves: of a point without a part the length of that.
    fn rate(&mut self, draft: &Draft, rate: Rate, moving: &MovingExpr) -> Option<Quantity> {
        let named = moving.named.as_ref();
        let named = named.filter(|name| path::is_path(self, name));
        let of = match (named, &moving.point) {
            (Some(name), _) => self.named(draft, name)?,
            (None, Some(point)) => {
                if !path::is_path(self, &point.link) {
                    let text = format!(
                        "`{point}` is no part of a {}; write `.x`, `.y` or `.norm` after a point",
                        rate.word()
                    );
                    return self.report.refuse(point.place(), text);
                }
                let axis = self.axis(draft, point, Some(AxisKind::Point))?;
                if draft.model.axis(axis).link == LinkId::GROUND {
                    let text = format!("`{point}` does not move: there is nothing to measure");
                    return self.report.refuse(point.place(), text);
                }
                let part = moving.part.as_ref().map(|(part, _)| *part);
                return self.part_of_vector(part, |reader, quantity| {
                    reader.rate_of(
                        rate,
                        [model::Quantity::X, model::Quantity::Y][quantity](axis),
                    )
                });
            }
            (None, None) => bug!("something that moves has no name"),
        };
        self.rate_of(rate, of)
    }

    fn rate_of(&mut self, rate: Rate, of: model::Quantity) -> Option<Quantity> {
        let of = self.variable_for(Measured::Quantity(of))?;
        let of = of.as_formula(self.formulas());
        self.variable_for(Measured::Rate(rate, of))
    }

    /// One part of a vector, by the number of its direction; without a part its length.
    fn part_of_vector(
        &mut self,
        part: Option<VectorPart>,
        mut along: impl FnMut(&mut Self, usize) -> Option<Quantity>,
    ) -> Option<Quantity> {
        match part {
            Some(VectorPart::X) => along(self, 0),
            Some(VectorPart::Y) => along(self, 1),
            _ => {
                let parts = [along(self, 0)?, along(self, 1)?];
                let [x, y] = parts.map(|part| part.as_formula(self.formulas()));
                let length = Formula::OfBoth(BinaryFunction::Hypot, x, y);
                Some(Quantity {
                    value: None,
                    formula: Some(self.formulas().add(length)),
                })
            }
        }
    }

    /// The torque of a motor times its rate.
    fn power(&mut self, draft: &Draft, name: &Name) -> Option<Quantity> {
        let motor = find::motor(self, draft, name)?;
        if draft.model.motor(motor).law.is_none() {
            let text = format!(
                "a power needs the rate at which a motor moves; give it a law, as `motor {name} = 60 rpm * t;`"
            );
            return self.report.refuse(name.place(), text);
        }
        let torque = self.variable_for(Measured::Quantity(model::Quantity::Torque(motor)))?;
        let joint = draft.model.motor(motor).joint;
        let rate = self.rate_of(Rate::Velocity, model::Quantity::Coordinate(joint))?;
        Some(torque.times(rate, self.formulas()))
    }

    /// What the first link of a joint does to the second: without a part the size of the force.
    fn reaction(&mut self, draft: &Draft, reaction: &ReactionExpr) -> Option<Quantity> {
        let (name, part) = match &reaction.part {
            Some((joint, part)) if !path::is_path(self, &reaction.whole) => (joint, Some(*part)),
            _ => (&reaction.whole, None),
        };
        let joint = find::joint(self, draft, name)?;
        let along = |reader: &mut Self, part| {
            reader.variable_for(Measured::Quantity(model::Quantity::Reaction(joint, part)))
        };
        match part {
            Some(VectorPart::Torque) => along(self, ReactionPart::Torque),
            part => self.part_of_vector(part, |reader, number| {
                along(reader, [ReactionPart::X, ReactionPart::Y][number])
            }),
        }
    }

    /// A new variable of the requirement.
    fn variable_for(&mut self, measured: Measured) -> Option<Quantity> {
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
    fn is_constant(&mut self, name: &Name) -> Option<bool> {
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
    fn named(&mut self, draft: &Draft, name: &Name) -> Option<model::Quantity> {
        if let [link] = &name.uses[..]
            && let Some(Referent::Link(_)) = self.names.get(&self.key_of(&link.name))
        {
            let text = format!("`{name}` is a place; measure `{name}.x` or `{name}.y`");
            return self.report.refuse(name.place(), text);
        }
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
                let key = self.key_of(&name.name);
                let joints = self.names.joints(&key);
                let mut known = [self.names.links(&key), joints].concat();
                known.push(TRANSMISSION);
                let remedy = spelling::remedy(&text, &known);
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

    fn axis(&mut self, draft: &Draft, end: &End, kind: Option<AxisKind>) -> Option<model::AxisId> {
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
        let links = names.each_ref().map(|name| find::link(self, draft, name));
        let links = [links[0]?, links[1]?];
        if links[0] == links[1] {
            let text = format!(
                "`{}` is no two links: name the one from which it keeps clear",
                names[0]
            );
            return self.report.refuse(place, text);
        }
        for (link, name) in links.into_iter().zip(names) {
            let text = match &draft.model.link(link).shapes[..] {
                // Perhaps its shape could not be read.
                [] if !self.report.is_empty() => return None,
                [] => format!(
                    "`{name}` has no shape, so nobody knows how far it reaches; give it one, as `bar [(0, 0), (1, 0)] width 0.2`"
                ),
                shapes
                    if shapes
                        .iter()
                        .any(|shape| matches!(shape.kind, ShapeKind::Figure(_))) =>
                {
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
