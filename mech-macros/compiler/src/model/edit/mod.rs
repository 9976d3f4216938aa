//! Changes to a mechanism, as a user would make them in the text: everything else follows, and is numbered anew.

use super::{
    Actions, Axis, AxisId, AxisKind, Between, Joint, JointId, JointKind, Link, LinkId, LoadKind,
    Model, Motor, MotorId, NewJoint, NewKind, Origin, Ratio, Shown, Start, StartValue,
};
use crate::bug::bug;

/// Changes to a mechanism. All ids are those of the mechanism that is changed, until [`Edit::finish`].
#[derive(Clone, Debug)]
pub struct Edit {
    model: Model,
    keeps_link: Vec<bool>,
    keeps_joint: Vec<bool>,
    keeps_motor: Vec<bool>,
}

impl Edit {
    /// No change yet.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        Self {
            model: model.clone(),
            keeps_link: vec![true; model.links.len()],
            keeps_joint: vec![true; model.joints.len()],
            keeps_motor: vec![true; model.motors.len()],
        }
    }

    /// Takes a joint away, with the motor on it. Of a slot both joints go, and the die.
    pub fn remove_joint(&mut self, id: JointId) {
        self.keeps_joint[id.index()] = false;
        if let Some(die) = die_of(&self.model, id) {
            self.keeps_link[die.index()] = false;
        }
    }

    /// Takes a link away, with everything that is fixed to it or joins it. The ground stays.
    pub fn remove_link(&mut self, id: LinkId) {
        if id != LinkId::GROUND {
            self.keeps_link[id.index()] = false;
        }
    }

    /// Takes a motor away, with its start.
    pub fn remove_motor(&mut self, id: MotorId) {
        self.keeps_motor[id.index()] = false;
        self.forget_start(self.model.motor(id).joint);
    }

    /// Puts a motor on a joint, after all others.
    pub fn add_motor(&mut self, joint: JointId) {
        let origin = self.model.joint(joint).origin;
        self.model.motors.push(Motor::new(joint, origin));
        self.keeps_motor.push(true);
    }

    /// Moves a motor to another joint; its start is forgotten, unless a law says where that is.
    pub fn move_motor(&mut self, id: MotorId, joint: JointId) {
        self.forget_start(self.model.motor(id).joint);
        self.model.motors[id.index()].joint = joint;
        let Motor { law, origin, .. } = *self.model.motor(id);
        if let Some(law) = law {
            let value = self.model.at_start(self.model.law(law), 0.0);
            self.model.start.values.push(StartValue {
                joint,
                value,
                origin,
            });
        }
    }

    /// Makes a joint one of another kind, if it can be: a weld revolute, or a revolute joint a slot. Its line is then fixed to the second
    /// link, through its point.
    pub fn replace(&mut self, id: JointId, by: NewKind) {
        match (by, self.model.joint(id).kind) {
            (NewKind::Revolute, JointKind::Weld(a, b)) => {
                self.model.joints[id.index()].kind = JointKind::Revolute(a, b);
            }
            (NewKind::Slot(along), JointKind::Revolute(point, other)) => {
                let Joint { name, origin, .. } = self.model.joint(id).clone();
                let line = AxisId::new(self.model.axes.len());
                self.model.axes.push(Axis {
                    name: None,
                    port: None,
                    origin,
                    kind: AxisKind::Line,
                    direction: along,
                    direction_formulas: [None; 2],
                    ..self.model.axis(other).clone()
                });
                self.keeps_joint[id.index()] = false;
                self.model.add_slot(&name, origin, point, line);
                self.keeps_link.push(true);
                self.keeps_joint.extend([true, true]);
            }
            _ => {}
        }
    }

    /// Adds a link. Joints may be declared on it by the id that is returned.
    pub fn add_link(&mut self, name: &str) -> LinkId {
        let id = LinkId::new(self.model.links.len());
        self.model.links.push(Link::new(name, Origin::default()));
        self.keeps_link.push(true);
        id
    }

    /// Declares a joint, after all others.
    pub fn declare(&mut self, joint: &NewJoint) {
        joint.declare(&mut self.model);
        self.keeps_link.resize(self.model.links.len(), true);
        self.keeps_joint.resize(self.model.joints.len(), true);
    }

    /// Names the link that carries what rolls, or leaves it unnamed.
    pub fn carry(&mut self, id: JointId, carrier: Option<LinkId>) {
        if let Some(on) = carrier_of(&mut self.model.joints[id.index()].kind) {
            *on = carrier;
        }
    }

    /// Gives two wheels other sizes.
    pub fn resize(&mut self, id: JointId, sizes: Ratio) {
        if let JointKind::Gear { ratio, .. } | JointKind::Belt { ratio, .. } =
            &mut self.model.joints[id.index()].kind
        {
            *ratio = sizes;
        }
    }

    /// Whatever has no ids.
    pub fn settings(&mut self) -> &mut Model {
        &mut self.model
    }

    fn forget_start(&mut self, joint: JointId) {
        self.model.start.values.retain(|value| value.joint != joint);
    }

    /// The changed mechanism.
    #[must_use]
    pub fn finish(mut self) -> Model {
        self.follow();
        let axes = self.axes_in_use();
        let (links, joints) = (self.link_numbers(), numbers(&self.keeps_joint));
        let axis_numbers = numbers(&axes);
        let link = |id: LinkId| links[id.index()].map(LinkId::new);
        let joint = |id: JointId| joints[id.index()].map(JointId::new);
        let axis = |id: AxisId| axis_numbers[id.index()].map(AxisId::new);
        let mut model = self.model;
        for (id, one) in model.links.iter_mut().enumerate() {
            let placed = model.axes.iter().zip(&axes);
            one.drawn &= placed
                .into_iter()
                .any(|(axis, used)| *used && axis.name.is_none() && axis.link.index() == id);
            one.die = one.die.and_then(|(a, b)| Some((axis(a)?, axis(b)?)));
        }
        keep(&mut model.links, &self.keeps_link);
        model.links.sort_by_key(|link| link.die.is_some());
        keep(&mut model.axes, &axes);
        keep(&mut model.joints, &self.keeps_joint);
        keep(&mut model.motors, &self.keeps_motor);
        for one in &mut model.axes {
            one.link = new_id(one.link, link);
        }
        for one in &mut model.joints {
            renumber(&mut one.kind, link, axis, joint);
        }
        for one in &mut model.motors {
            one.joint = new_id(one.joint, joint);
        }
        let Start { values, near } = &mut model.start;
        values.retain_mut(|value| {
            joint(value.joint).is_some_and(|id| {
                value.joint = id;
                true
            })
        });
        near.retain_mut(|near| {
            link(near.link).is_some_and(|id| {
                near.link = id;
                true
            })
        });
        let still = |shown: Shown| {
            Some(match shown {
                Shown::Link(id) => Shown::Link(link(id)?),
                Shown::Point(id) => Shown::Point(axis(id)?),
                Shown::Joint(id) => Shown::Joint(joint(id)?),
            })
        };
        if let Some(shown) = &mut model.show {
            *shown = shown.iter().copied().filter_map(still).collect();
        }
        model.continuous = model.continuous.iter().copied().filter_map(joint).collect();
        model.traces.retain_mut(|trace| {
            axis(trace.point).is_some_and(|id| {
                trace.point = id;
                true
            })
        });
        renumber_actions(&mut model.actions, link, axis, joint);
        model
    }

    /// The new numbers of links: dies come after all others.
    fn link_numbers(&self) -> Vec<Option<usize>> {
        let is_die: Vec<bool> = self
            .model
            .links
            .iter()
            .map(|link| link.die.is_some())
            .collect();
        let of = |dies: bool| {
            let kept = self.keeps_link.iter().zip(&is_die);
            let kept: Vec<bool> = kept.map(|(kept, die)| *kept && *die == dies).collect();
            numbers(&kept)
        };
        let (declared, dies) = (of(false), of(true));
        let before = declared.iter().flatten().count();
        let moved = |number: Option<usize>| number.map(|number| number + before);
        let all = declared.into_iter().zip(dies);
        all.map(|(declared, die)| declared.or(moved(die))).collect()
    }

    /// Takes away what cannot be without what was taken away.
    fn follow(&mut self) {
        let model = &self.model;
        for (id, one) in model.links.iter().enumerate() {
            if let Some((point, line)) = one.die {
                let held = [point, line]
                    .iter()
                    .all(|&axis| self.keeps_link[model.axis(axis).link.index()]);
                self.keeps_link[id] &= held;
            }
        }
        for id in model.joint_ids() {
            let (a, b) = model.ends(id);
            self.keeps_joint[id.index()] &=
                self.keeps_link[a.index()] && self.keeps_link[b.index()];
        }
        for (id, shaft, follower, _) in model.cams() {
            self.keeps_joint[id.index()] &=
                self.keeps_joint[shaft.index()] && self.keeps_joint[follower.index()];
        }
        for id in model.motor_ids() {
            self.keeps_motor[id.index()] &= self.keeps_joint[model.motor(id).joint.index()];
        }
    }

    /// The axes that are still there: an axis without a name is only there for its joints.
    fn axes_in_use(&self) -> Vec<bool> {
        let mut used: Vec<bool> = self
            .model
            .axes
            .iter()
            .map(|axis| axis.name.is_some())
            .collect();
        let kept = self
            .model
            .joints
            .iter()
            .zip(&self.keeps_joint)
            .filter(|(_, kept)| **kept);
        for (joint, _) in kept {
            for axis in joint.kind.axes().into_iter().flatten() {
                used[axis.index()] = true;
            }
        }
        for (used, axis) in used.iter_mut().zip(&self.model.axes) {
            *used &= self.keeps_link[axis.link.index()];
        }
        used
    }
}

impl Model {
    /// This mechanism with a change.
    #[must_use]
    pub fn with_edit(&self, change: impl FnOnce(&mut Edit)) -> Self {
        let mut edit = Edit::new(self);
        change(&mut edit);
        edit.finish()
    }
}

/// The die of the slot to which a joint belongs, if it does.
fn die_of(model: &Model, id: JointId) -> Option<LinkId> {
    let (a, b) = model.ends(id);
    [a, b]
        .into_iter()
        .find(|&link| model.link(link).die.is_some())
}

fn carrier_of(kind: &mut JointKind) -> Option<&mut Option<LinkId>> {
    match kind {
        JointKind::Gear { on, .. } | JointKind::Belt { on, .. } | JointKind::Rack { on, .. } => {
            Some(on)
        }
        JointKind::Revolute(..)
        | JointKind::Prismatic(..)
        | JointKind::Weld(..)
        | JointKind::Cam { .. } => None,
    }
}

fn renumber(
    kind: &mut JointKind,
    link: impl Fn(LinkId) -> Option<LinkId>,
    axis: impl Fn(AxisId) -> Option<AxisId>,
    joint: impl Fn(JointId) -> Option<JointId>,
) {
    // What is left has all its parts; only a named carrier may have been removed.
    if let Some(on) = carrier_of(kind) {
        *on = on.and_then(&link);
    }
    match kind {
        JointKind::Revolute(a, b) | JointKind::Prismatic(a, b) | JointKind::Weld(a, b) => {
            *a = new_id(*a, &axis);
            *b = new_id(*b, &axis);
        }
        JointKind::Gear { a, b, .. } | JointKind::Belt { a, b, .. } => {
            *a = new_id(*a, &link);
            *b = new_id(*b, &link);
        }
        JointKind::Rack { pinion, bar, .. } => {
            *pinion = new_id(*pinion, &link);
            *bar = new_id(*bar, &link);
        }
        JointKind::Cam {
            shaft, follower, ..
        } => {
            *shaft = new_id(*shaft, &joint);
            *follower = new_id(*follower, &joint);
        }
    }
}

/// Springs, dampers and loads go with what they act on.
fn renumber_actions(
    actions: &mut Actions,
    link: impl Fn(LinkId) -> Option<LinkId>,
    axis: impl Fn(AxisId) -> Option<AxisId>,
    joint: impl Fn(JointId) -> Option<JointId>,
) {
    let held = |between: &mut Between| {
        let new = match *between {
            Between::Points(a, b) => axis(a).zip(axis(b)).map(|(a, b)| Between::Points(a, b)),
            Between::Joint(id) => joint(id).map(Between::Joint),
        };
        new.is_some_and(|new| {
            *between = new;
            true
        })
    };
    actions
        .springs
        .retain_mut(|spring| held(&mut spring.between));
    actions
        .dampers
        .retain_mut(|damper| held(&mut damper.between));
    actions.loads.retain_mut(|load| {
        let new = match load.kind {
            LoadKind::Force(point) => axis(point).map(LoadKind::Force),
            LoadKind::Torque(on) => link(on).map(LoadKind::Torque),
        };
        new.is_some_and(|new| {
            load.kind = new;
            true
        })
    });
}

/// The new id of something that cannot have been removed, because something that stays needs it.
fn new_id<I: Copy + std::fmt::Debug>(id: I, new: impl Fn(I) -> Option<I>) -> I {
    new(id).unwrap_or_else(|| bug!("an edit keeps what needs {id:?}, which it takes away"))
}

/// The new number of everything that stays.
fn numbers(kept: &[bool]) -> Vec<Option<usize>> {
    let mut next = 0;
    let number = |kept: &bool| {
        kept.then(|| {
            next += 1;
            next - 1
        })
    };
    kept.iter().map(number).collect()
}

fn keep<T>(list: &mut Vec<T>, kept: &[bool]) {
    let mut kept = kept.iter();
    list.retain(|_| {
        let Some(kept) = kept.next() else {
            bug!("an edit does not say whether all of a list is kept");
        };
        *kept
    });
}

#[cfg(test)]
mod tests;
