//! The names and numbers of requirements.

use super::{Noun, Reader, in_words};
use crate::model::Rate;
use crate::syntax::Place;
use crate::syntax::ast::{ConditionExpr, Expect, MeasuredExpr, MovingExpr, ReactionExpr, SpotExpr};

impl Reader {
    pub(super) fn expect(&mut self, expect: &Expect) {
        match &expect.condition {
            ConditionExpr::Compare { sides: [first, second], .. } => {
                self.number("expect", "first", first);
                self.number("expect", "second", second);
            }
            ConditionExpr::Within(of, [low, high]) => {
                self.number("expect", "first", of);
                self.number("expect", "low", low);
                self.number("expect", "high", high);
            }
            ConditionExpr::Turns(motor, _) => self.name(motor, Noun::Joint),
        }
        for case in &expect.cases {
            self.name(&case.motor, Noun::Joint);
            let roles = ["low", "high"].into_iter();
            for (value, role) in case.values.iter().zip(roles) {
                self.number(&in_words(&case.motor), role, value);
            }
        }
        for load in &expect.loads {
            self.name(&load.name, Noun::Action);
            let roles = ["x", "y"].into_iter();
            for (value, role) in load.numbers.iter().zip(roles) {
                self.number(&in_words(&load.name), role, value);
            }
        }
    }

    pub(super) fn measured(&mut self, measured: &MeasuredExpr, literals: &mut Vec<Place>) {
        match measured {
            MeasuredExpr::Transmission(joint)
            | MeasuredExpr::Pressure(joint)
            | MeasuredExpr::Curvature(joint) => self.name(joint, Noun::Joint),
            MeasuredExpr::Angle(from, to) => {
                self.name(from, Noun::Body);
                if let Some(to) = to {
                    self.name(to, Noun::Body);
                }
            }
            MeasuredExpr::Distance(spots) => {
                for spot in spots {
                    match spot {
                        SpotExpr::Axis(end) => self.end(end, Noun::Body),
                        SpotExpr::At(place) => {
                            self.leaves(&place.x, literals);
                            self.leaves(&place.y, literals);
                        }
                    }
                }
            }
            MeasuredExpr::Clearance(links) | MeasuredExpr::Centre(links, _) => {
                for link in links {
                    self.name(link, Noun::Body);
                }
            }
            MeasuredExpr::Summary(_, _, of) => self.leaves(of, literals),
            MeasuredExpr::Dwell([of, width]) => {
                self.leaves(of, literals);
                self.leaves(width, literals);
            }
            MeasuredExpr::Influence(of, motor) => {
                self.leaves(of, literals);
                self.name(motor, Noun::Joint);
            }
            MeasuredExpr::Advantage(load, motor) => {
                self.name(load, Noun::Action);
                self.name(motor, Noun::Joint);
            }
            MeasuredExpr::Shaking(_) => {}
            MeasuredExpr::Moving(rate, of) => self.moving(*rate, of),
            MeasuredExpr::Torque(motor) | MeasuredExpr::Power(motor) => {
                self.name(motor, Noun::Joint);
            }
            MeasuredExpr::Reaction(ReactionExpr { whole, part: None }) => {
                self.name(whole, Noun::Joint);
            }
            MeasuredExpr::Reaction(ReactionExpr { whole, part: Some((joint, _)) }) => {
                self.name(joint, Noun::Joint);
                // Or it is a joint of an instance that is called so.
                self.mention(Noun::Joint, in_words(whole), false, whole.span());
            }
        }
    }
    fn moving(&mut self, rate: Option<Rate>, MovingExpr { named, point, .. }: &MovingExpr) {
        if let Some(point) = point {
            self.end(point, Noun::Body);
        }
        let Some(name) = named else {
            return;
        };
        if point.is_some() {
            // Or it is a joint or a link of an instance.
            self.mention(Noun::BodyOrJoint, in_words(name), false, name.span());
        } else {
            self.name(name, Noun::BodyOrJoint);
            if rate.is_none() {
                // Or it is a constant.
                self.mention(Noun::Number, name.name.to_string(), false, name.span());
            }
        }
    }
}
