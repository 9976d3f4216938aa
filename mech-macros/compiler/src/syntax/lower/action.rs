//! Masses, and what acts on them.

use super::Lowering;
use super::name::Body;
use crate::api::Owner;
use crate::model::{
    AxisId, AxisKind, Between, Damper, Figure, JointId, JointKind, LinkId, Load, LoadKind, Mass,
    Shape, ShapeKind, Spring,
};
use crate::syntax::Place;
use crate::syntax::ast::{
    BetweenEnds, Elastic, ElasticBody, End, Expr, LoadOn, Matter, MatterKind, Name, Pair,
};
use proc_macro2::Span;

/// What the mass of a link is made from, once all its shapes are known.
pub(super) enum Massive {
    Given(Mass),
    Density(f64, Place),
}

impl Lowering {
    /// The mass of a link; `earlier` is what was said of it before.
    pub(super) fn lower_matter(
        &mut self,
        link: Body,
        matter: &Matter,
        earlier: &mut Option<Massive>,
    ) {
        let place = Place::at(matter.keyword);
        let massive = match &matter.kind {
            MatterKind::Mass { mass, at, inertia } => self
                .mass(mass, at.as_ref(), inertia.as_ref())
                .map(Massive::Given),
            MatterKind::Density(density) => self
                .positive(density, "a density")
                .map(|density| Massive::Density(density, place)),
        };
        if link.id == LinkId::GROUND {
            let text = "the ground does not move, whatever its mass; leave this out";
            return self.report.error(place, text);
        }
        if earlier.is_some() || self.model.link(link.id).mass.is_some() {
            let name = self.name_of(link);
            let text = format!("`{name}` has a mass already; remove one of the two");
            return self.report.error(place, text);
        }
        *earlier = massive;
    }

    fn mass(&mut self, mass: &Expr, at: Option<&Pair>, inertia: Option<&Expr>) -> Option<Mass> {
        let weight = self.not_negative(mass, "a mass");
        let similarity = self.similarity;
        let center = at.map_or(Some([0.0, 0.0]), |at| self.pair(at));
        let center = center.and_then(|center| {
            let place = at.map_or(mass.place, |at| at.place);
            self.transform((center, [None; 2]), &similarity, place)
        });
        let center = center.map(|(center, _)| center);
        let inertia = inertia.map_or(Some(0.0), |inertia| {
            self.not_negative(inertia, "a moment of inertia")
        });
        Some(Mass {
            mass: weight?,
            center: center?,
            inertia: inertia?,
        })
    }

    fn not_negative(&mut self, expr: &Expr, what: &str) -> Option<f64> {
        let value = self.value(expr)?;
        if value >= 0.0 {
            return Some(value);
        }
        self.report.error(
            expr.place,
            format!("{what} cannot be negative, but this is {value}"),
        );
        None
    }

    /// Gives a link its mass, now that its shapes are known.
    pub(super) fn weigh(&mut self, link: LinkId, massive: Option<Massive>) {
        let Some(massive) = massive else {
            return;
        };
        let known = &self.model.link(link).shapes;
        let mass = match massive {
            Massive::Given(mass) => mass,
            Massive::Density(density, place) => {
                if known.is_empty() {
                    let name = &self.model.link(link).name;
                    let text = format!(
                        "`{name}` has no shapes whose mass this could be; draw it, or give its `mass`"
                    );
                    return self.report.error(place, text);
                }
                if known.iter().any(Shape::varies) {
                    let name = &self.model.link(link).name;
                    let text = format!(
                        "the shapes of `{name}` depend on a param, but a mass may not; give its `mass`"
                    );
                    return self.report.error(place, text);
                }
                let has_unknown = known.iter().any(|shape| {
                    matches!(
                        &shape.kind,
                        ShapeKind::Figure(Figure::Gear { radius: None, .. })
                    )
                });
                if has_unknown {
                    let text = "a gear without `radius` has no area yet; give its `radius`, or the `mass` of the link";
                    return self.report.error(place, text);
                }
                Mass::of_shapes(known, density)
            }
        };
        self.model.links[link.index()].mass = Some(mass);
    }

    pub(super) fn lower_gravity(&mut self, keyword: Span, value: &Pair) {
        self.single(keyword, "gravity", "remove this one");
        let value = self.pair(value);
        if let Some(value) = value.filter(|_| self.model.actions.gravity.is_none()) {
            self.model.actions.gravity = Some(value);
            self.acting.gravity = Some(Place::at(keyword));
        }
    }

    pub(super) fn lower_spring(&mut self, spring: &Elastic) {
        let Some((between, strength, body)) = self.elastic(spring, "spring", "a stiffness") else {
            return self.keep_spring(spring);
        };
        let rest = match &body.rest {
            None => Some(0.0),
            Some(rest) if matches!(between, Between::Points(..)) => {
                self.not_negative(rest, "a length at rest")
            }
            Some(rest) => self.value(rest),
        };
        let (scale, sense) = (self.start_scale(), self.similarity.sense());
        let rest = rest.map(|rest| match between {
            Between::Points(..) => scale * rest,
            Between::Joint(_) => sense * rest,
        });
        let origin = self.note(&spring.name);
        if let Some(rest) = rest {
            self.model.actions.springs.push(Spring {
                name: self.key_of(&spring.name),
                origin,
                between,
                stiffness: strength,
                rest,
            });
        }
    }

    /// Keeps the name of a spring that is wrong: its method is not to be missed elsewhere. Nothing is made of a mechanism with errors.
    fn keep_spring(&mut self, spring: &Elastic) {
        let name = self.key_of(&spring.name);
        let mut known = self.model.actions.springs.iter();
        let is_own = self.owns_method(&name, &format!("spring `{}`", spring.name));
        if !is_own || known.any(|known| known.name == name) {
            return;
        }
        if let Ok(ElasticBody {
            between: BetweenEnds::Points(_),
            ..
        }) = spring.body
        {
            let (origin, nowhere) = (self.note(&spring.name), AxisId::new(0));
            self.model.actions.springs.push(Spring {
                name,
                origin,
                between: Between::Points(nowhere, nowhere),
                stiffness: 0.0,
                rest: 0.0,
            });
        }
    }

    pub(super) fn lower_damper(&mut self, damper: &Elastic) {
        let Some((between, damping, _)) = self.elastic(damper, "damper", "a damping") else {
            return;
        };
        let origin = self.note(&damper.name);
        self.model.actions.dampers.push(Damper {
            name: self.key_of(&damper.name),
            origin,
            between,
            damping,
        });
    }

    /// What a spring or damper lies between, its strength, and what else was said of it.
    fn elastic<'e>(
        &mut self,
        elastic: &'e Elastic,
        what: &str,
        strength: &str,
    ) -> Option<(Between, f64, &'e ElasticBody)> {
        let kept = self.claim(&elastic.name, what);
        let body = match &elastic.body {
            Ok(body) => body,
            Err(error) => {
                self.report.pass_on(error.clone());
                return None;
            }
        };
        let between = self.resolve_between(&body.between, what);
        let strength = self.not_negative(&body.strength, strength);
        let both = between.zip(strength).filter(|_| kept);
        both.map(|(between, strength)| (between, strength, body))
    }

    fn resolve_between(&mut self, ends: &BetweenEnds, what: &str) -> Option<Between> {
        match ends {
            BetweenEnds::Points([first, second]) => {
                let (a, b) = (self.end_point(first, what), self.end_point(second, what));
                let (a, b) = (a?, b?);
                if self.model.axis(a).link == self.model.axis(b).link {
                    let link = &second.link;
                    let text = format!(
                        "both ends of this {what} are on `{link}`, where it does nothing; fix one of them to another link"
                    );
                    self.report.error(first.place().to(second.place()), text);
                    return None;
                }
                if let Some(joint) = self.pinned_together(a, b) {
                    let text = format!(
                        "joint `{joint}` holds both ends of this {what} together; fix one of them elsewhere"
                    );
                    self.report.error(first.place().to(second.place()), text);
                    return None;
                }
                Some(Between::Points(a, b))
            }
            BetweenEnds::Joint(name) => self.find_turning(name, what).map(Between::Joint),
        }
    }

    /// The joint that holds two points together, if one does.
    fn pinned_together(&self, a: AxisId, b: AxisId) -> Option<&str> {
        let mut joints = self.model.joints.iter();
        let holds = |kind: JointKind| match kind {
            JointKind::Revolute(p, q) | JointKind::Weld(p, q) => {
                [p, q] == [a, b] || [q, p] == [a, b]
            }
            _ => false,
        };
        joints
            .find(|joint| holds(joint.kind))
            .map(|joint| joint.name.as_str())
    }

    /// The joint of this name, if it turns.
    fn find_turning(&mut self, name: &Name, what: &str) -> Option<JointId> {
        let joint = self.find_joint(name)?;
        if let JointKind::Revolute(..) = self.model.joint(joint).kind {
            return Some(joint);
        }
        let text = format!(
            "joint `{name}` is not a revolute; a {what} at a joint turns its links, one between points is `linear(a.p, b.q)`"
        );
        self.report.error(name.place(), text);
        None
    }

    /// The point at which something is fixed.
    fn end_point(&mut self, end: &End, what: &str) -> Option<AxisId> {
        let link = self.find_body(&end.link)?;
        let Some(name) = &end.axis else {
            let points = self.axes_of(link, Some(AxisKind::Point));
            let text = match points.first() {
                Some(point) => format!("a {what} is fixed to a point: `{}.{point}`", end.link),
                None => format!(
                    "a {what} is fixed to a point; declare one in `{}`",
                    end.link
                ),
            };
            self.report.error(end.place(), text);
            return None;
        };
        let axis = self.find_axis(link, name, Some(AxisKind::Point))?;
        if self.model.axis(axis).kind == AxisKind::Line {
            let text = format!("`{end}` is a line; a {what} is fixed to a point");
            self.report.error(Place::at(name.span()), text);
            return None;
        }
        Some(axis)
    }

    pub(super) fn lower_load(&mut self, load: &crate::syntax::ast::Load) {
        let kept = self.claim(&load.name, "load");
        let on = match &load.on {
            Ok(on) => on,
            Err(error) => return self.report.pass_on(error.clone()),
        };
        let kind = match on {
            LoadOn::Force(end) => self.end_point(end, "load").map(LoadKind::Force),
            LoadOn::Torque(name) => self.find_link(name).map(LoadKind::Torque),
        };
        let Some(kind) = kind else {
            // Its methods are not to be missed elsewhere; nothing is made of a mechanism with errors.
            let kind = match on {
                LoadOn::Force(_) => LoadKind::Force(AxisId::new(0)),
                LoadOn::Torque(_) => LoadKind::Torque(LinkId::GROUND),
            };
            let (name, origin) = (self.key_of(&load.name), self.note(&load.name));
            if kept {
                self.model.actions.loads.push(Load { name, origin, kind });
            }
            return;
        };
        let link = match kind {
            LoadKind::Force(point) => self.model.axis(point).link,
            LoadKind::Torque(link) => link,
        };
        if link == LinkId::GROUND {
            let text = "a load on the ground does nothing; put it on a link that moves";
            return self.report.error(Place::at(load.name.span()), text);
        }
        if kept {
            let name = self.key_of(&load.name);
            self.claim_method(
                format!("{}set_{}", self.scopes.here().prefix, load.name),
                format!("load `{name}`"),
                Place::at(load.name.span()),
            );
            self.claim_method(
                format!("{name}_advantage"),
                format!("the advantage over load `{name}`"),
                Place::at(load.name.span()),
            );
            let origin = self.note(&load.name);
            self.model.actions.loads.push(Load { name, origin, kind });
        }
    }

    /// Effects that contradict what motors do.
    pub(super) fn check_effects(&mut self) {
        // What stands beside them may only be wrong.
        if !self.report.is_empty() {
            return;
        }
        if self.acting.dynamics.is_some()
            && let Some((motor, _)) = self.model.lawful_motors().next()
        {
            let motor = self.model.motor(motor);
            let text = format!(
                "motor `{}` follows a law, so forces cannot move it; leave out its law, or the effect `dynamics`",
                self.model.joint(motor.joint).name
            );
            let place = self.places.get(motor.origin);
            self.report.error(place, text);
        }
    }

    /// What acts must have something to act on, and something must ask for it.
    pub(super) fn check_actions(&mut self) {
        // What is missing may only be wrong.
        if !self.report.is_empty() {
            return;
        }
        let actions = &self.model.actions;
        let has_mass = |axis: fn(&Mass) -> f64| {
            self.model
                .links
                .iter()
                .filter_map(|link| link.mass.as_ref())
                .any(|mass| axis(mass) > 0.0)
        };
        if let (Some(place), false) = (self.acting.gravity, has_mass(|mass| mass.mass)) {
            let text =
                "no link has a mass on which gravity could act; give a link `mass` or `density`";
            return self.report.error(place, text);
        }
        if let Some(place) = self.acting.dynamics
            && !has_mass(|mass| mass.mass + mass.inertia)
        {
            let text =
                "nothing has a mass that would keep it moving; give links `mass` or `density`";
            return self.report.error(place, text);
        }
        let nothing =
            actions.springs.is_empty() && actions.dampers.is_empty() && actions.loads.is_empty();
        if let Some(place) = self.acting.force
            && nothing
            && !has_mass(|mass| mass.mass + mass.inertia)
        {
            let text = "there are no forces: declare a `load`, a `spring`, or the `mass` of a link";
            return self.report.error(place, text);
        }
        if let (Some(load), false) = (actions.loads.first(), self.model.effects.needs_actions()) {
            let text = format!(
                "nothing asks what load `{}` does; add `effects {{ force; }}` or `dynamics`, or leave it out",
                load.name
            );
            let place = self.places.get(load.origin);
            self.report.error(place, text);
        }
    }
}

impl Lowering {
    /// The methods that forces add must not be called as others are.
    pub(super) fn claim_force_methods(&mut self) {
        let ActionPlaces {
            force, dynamics, ..
        } = self.acting;
        let picture = force.filter(|_| self.model.effects.overlay);
        for (place, owner) in [
            (force, Owner::Force),
            (dynamics, Owner::Dynamics),
            (picture, Owner::Overlay),
        ] {
            if let Some(place) = place {
                self.claim_methods(owner, place);
            }
        }
    }
}

/// Where gravity and effects stand, for messages.
#[derive(Clone, Copy, Default)]
pub(super) struct ActionPlaces {
    pub(super) gravity: Option<Place>,
    pub(super) force: Option<Place>,
    pub(super) dynamics: Option<Place>,
}
