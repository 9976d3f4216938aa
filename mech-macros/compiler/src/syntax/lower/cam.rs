//! Cams: a law between two joints.

use super::Lowering;
use super::param::Quantity;
use super::{law, rolling};
use crate::model::{JointId, JointKind, LinkId};
use crate::syntax::Place;
use crate::syntax::ast::{End, Joint, JointBody};

impl Lowering {
    /// A cam, if it can be understood.
    pub(super) fn cam(&mut self, joint: &Joint, body: &JointBody) -> Option<JointKind> {
        let ends = body.ends.each_ref().map(|end| self.cam_end(end));
        let factors = ends.map(|joint| self.factor_of(joint));
        let law = body.law.as_ref();
        let law = law.and_then(|law| self.scaled_law(law, law::COORDINATE, factors));
        for keyword in body.clauses() {
            let text = "a `cam` has no place of its own; its shaft and its follower are where their joints are";
            self.report.error(Place::at(keyword), text);
        }
        let [shaft, follower] = [ends[0]?, ends[1]?];
        let place = body.ends[0].place().to(body.ends[1].place());
        if shaft == follower {
            let text = format!(
                "cam `{}` is between `{}` and itself; name the joints of its shaft and of its follower",
                joint.name, body.ends[1]
            );
            self.report.error(place, text);
            return None;
        }
        if self.model.carrier_of_cam(shaft, follower).is_none() {
            self.apart(place, shaft, follower);
            return None;
        }
        let law = law?;
        Some(JointKind::Cam {
            shaft,
            follower,
            law,
        })
    }

    /// The joint of a shaft or a follower: one that has a coordinate.
    fn cam_end(&mut self, end: &End) -> Option<JointId> {
        if end.axis.is_some() {
            let text = format!(
                "a `cam` takes joints, that of its shaft and that of its follower; `{end}` is none"
            );
            self.report.error(end.place(), text);
            return None;
        }
        let name = self.key(&end.link)?;
        let (joint, word) = if self.cams.contains(&name) {
            (None, Some("cam"))
        } else {
            let joint = self.find_joint(&end.link)?;
            (Some(joint), self.unfit_for_cam(joint))
        };
        if let Some(word) = word {
            let text = format!(
                "`{end}` is a {word}; a `cam` takes joints that are `revolute` or `prismatic`"
            );
            self.report.error(end.place(), text);
            return None;
        }
        joint
    }

    /// How many times the coordinate that a part gives a joint is that which the joint has.
    fn factor_of(&self, joint: Option<JointId>) -> Quantity {
        match joint.map(|joint| self.model.joint(joint).kind) {
            Some(JointKind::Prismatic(..)) => self.similarity.scale,
            Some(_) => Quantity::fixed(self.similarity.sense()),
            None => Quantity::fixed(1.0),
        }
    }

    /// What a joint is called that cannot be the shaft or the follower of a cam.
    fn unfit_for_cam(&self, joint: JointId) -> Option<&'static str> {
        let kind = self.model.joint(joint).kind;
        let (a, b) = self.model.ends(joint);
        let on_die = [a, b]
            .iter()
            .any(|&link| self.model.link(link).die.is_some());
        match kind {
            JointKind::Weld(..) => Some("weld"),
            _ if on_die => Some("slot"),
            _ => rolling::word_for(kind),
        }
    }

    /// Complains about joints that have no link in common.
    fn apart(&mut self, place: Place, shaft: JointId, follower: JointId) {
        let name = |link: LinkId| format!("`{}`", self.model.link(link).name);
        let joins = |joint: JointId| {
            let (a, b) = self.model.ends(joint);
            format!(
                "`{}` joins {}",
                self.model.joint(joint).name,
                [name(a), name(b)].join(" to ")
            )
        };
        let text = format!(
            "the shaft and the follower of a cam are carried by one link, but {} and {}; name two joints with a link in common",
            joins(shaft),
            joins(follower)
        );
        self.report.error(place, text);
    }
}
