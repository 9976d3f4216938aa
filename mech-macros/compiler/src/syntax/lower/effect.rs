//! What is computed beyond positions, and the methods that return it.

use super::Lowering;
use crate::api::Owner;
use crate::model::{AxisKind, Effects, JointKind, LinkId, Origin};
use crate::syntax::ast::{Effect, Read};
use crate::syntax::{Place, spelling};
use proc_macro2::{Ident, Span};

const EFFECTS: [&str; 7] = [
    "velocity",
    "acceleration",
    "force",
    "dynamics",
    "trace",
    "overlay",
    "sensitivity",
];

impl Lowering {
    pub(super) fn lower_effects(&mut self, keyword: Span, effects: &[Read<Effect>]) {
        self.single(keyword, "effects", "put everything into the first");
        let mut listed: Vec<&Ident> = Vec::new();
        for effect in effects {
            self.report.next_item();
            match effect {
                Ok(Effect::Trace(trace)) => {
                    self.for_every(&trace.point.link, |lowering| lowering.lower_trace(trace));
                }
                Ok(Effect::Plain(effect)) if listed.contains(&effect) => {
                    let text = format!("`{effect}` is listed already; remove one of the two");
                    self.report.error(Place::at(effect.span()), text);
                }
                Ok(Effect::Plain(effect)) => {
                    listed.push(effect);
                    self.lower_effect(effect);
                }
                Err(error) => self.report.pass_on(error.clone()),
            }
        }
    }

    fn lower_effect(&mut self, effect: &Ident) {
        let text = effect.to_string();
        let effects = &mut self.model.effects;
        let message = match text.as_str() {
            "velocity" => {
                effects.velocity = true;
                return;
            }
            // Accelerations are made from velocities.
            "acceleration" => {
                (effects.velocity, effects.acceleration) = (true, true);
                return;
            }
            "force" => {
                effects.force = true;
                self.acting.force = Some(Place::at(effect.span()));
                return;
            }
            "dynamics" => {
                effects.dynamics = true;
                self.acting.dynamics = Some(Place::at(effect.span()));
                return;
            }
            "overlay" => {
                effects.overlay = true;
                return;
            }
            "sensitivity" if self.has_params => {
                effects.sensitivity = true;
                return;
            }
            "sensitivity" => {
                "`sensitivity` tells how everything follows the params, and there is none; write \
                 `param name = ...;` for a number that points depend on, or leave this out"
                    .to_owned()
            }
            _ => format!(
                "unknown effect `{text}`{}",
                spelling::remedy(&text, &EFFECTS)
            ),
        };
        self.report.error(Place::at(effect.span()), message);
    }

    /// Claims the names of the methods that return rates.
    pub(super) fn claim_rate_methods(&mut self) {
        let Effects {
            velocity,
            acceleration,
            sensitivity,
            ..
        } = self.model.effects;
        for (name, owner, origin, rate) in self.accessors() {
            let rates = [
                (velocity, rate),
                (acceleration, "acceleration"),
                (sensitivity, "sensitivity"),
            ];
            for (_, what) in rates.into_iter().filter(|(wanted, _)| *wanted) {
                let place = self.places.get(origin);
                self.claim_method(
                    format!("{name}_{what}"),
                    format!("the {what} of {owner}"),
                    place,
                );
            }
        }
    }

    /// The method that follows laws must not be called as others are.
    pub(super) fn claim_time_method(&mut self) {
        let first = self.model.lawful_motors().next().map(|(motor, _)| motor);
        if let Some(motor) = first {
            let place = self.places.get(self.model.motor(motor).origin);
            self.claim_methods(Owner::Laws, place);
        }
    }

    /// Everything that has a method of its own: its name, what it is, where it was declared, and what its rate is called.
    fn accessors(&self) -> Vec<(String, String, Origin, &'static str)> {
        let model = &self.model;
        let links = model.declared_links().map(|id| {
            let link = model.link(id);
            (
                link.name.clone(),
                format!("link `{}`", link.name),
                link.origin,
                "velocity",
            )
        });
        let points = model.axes.iter().filter_map(|axis| {
            let name = axis.name.as_deref()?;
            let is_exposed = axis.kind == AxisKind::Point && axis.link != LinkId::GROUND;
            let link = model.owner_of(axis);
            let owner = format!("point `{link}.{name}`");
            is_exposed.then(|| (format!("{link}_{name}"), owner, axis.origin, "velocity"))
        });
        let joints = model.joints.iter().filter(|joint| {
            let moves = matches!(
                joint.kind,
                JointKind::Revolute(..) | JointKind::Prismatic(..)
            );
            moves && !joint.hidden
        });
        let joints = joints.map(|joint| {
            (
                joint.name.clone(),
                format!("joint `{}`", joint.name),
                joint.origin,
                "rate",
            )
        });
        links.chain(points).chain(joints).collect()
    }
}
