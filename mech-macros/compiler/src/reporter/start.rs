//! Starts of joints that follow from others.

use super::Words;
use super::wording::{brief, places_enough};
use crate::bug::bug;
use crate::digits::round_to;
use crate::kinematics::LinkFrames;
use crate::model::{JointId, JointKind, LinkId, Model, Near, Origin};
use crate::plan::{self, Plan};
use crate::structure::{self, Diagnosis};

/// So many assemblies are looked at.
const MOST: usize = 64;

impl Words<'_> {
    pub(super) fn start_not_free(&self, joint: JointId) -> (Origin, String) {
        let mut values = self.model.start.values.iter();
        let Some(value) = values.find(|value| value.joint == joint) else {
            bug!("a start that is not given is not free");
        };
        let text = self.start_by_cam(joint).unwrap_or_else(|| {
            format!(
                "joint {} has no motor, and no gear, belt or rack drives it: its start follows from the other joints{}",
                self.joint(joint),
                self.assembly_near(joint)
            )
        });
        (value.origin, text)
    }

    /// Returns a help that says which assembly is meant instead, from the coordinate of the joint in each.
    fn assembly_near(&self, joint: JointId) -> String {
        let wanted = self.model.start.value(joint);
        let mut free = self.model.clone();
        match assemble(&mut free) {
            Ok(plan) => match coordinate(&free, &plan, joint) {
                Some(value) => format!(
                    "\nhelp: leave this out: there is only one assembly, in which {} is at {}",
                    self.joint(joint),
                    self.format_coordinate(joint, value)
                ),
                None => "\nhelp: leave this out".to_owned(),
            },
            Err(Diagnosis::SeveralAssemblies { links, angles, .. }) => {
                let places = places_enough(links.len(), &angles);
                let found = angles.iter().take(MOST).filter_map(|angles| {
                    let angles = angles.iter().map(|angle| round_to(angle.to_degrees(), places));
                    let angles: Vec<f64> = angles.collect();
                    let value = coordinate_near(&free, joint, &links, &angles)?;
                    Some((value, angles))
                });
                let away = |value: f64| self.distance(joint, value, wanted);
                let nearest = found.min_by(|(a, _), (b, _)| away(*a).total_cmp(&away(*b)));
                match nearest {
                    Some((value, angles)) => self.clauses(joint, value, &links, &angles),
                    None => NO_ANGLE.to_owned(),
                }
            }
            Err(_) => NO_ANGLE.to_owned(),
        }
    }

    fn clauses(&self, joint: JointId, value: f64, links: &[LinkId], angles: &[f64]) -> String {
        let clauses = links.iter().zip(angles);
        let clauses = clauses
            .map(|(link, angle)| format!("{} near {angle} deg;", self.model.link(*link).name));
        let clauses: Vec<_> = clauses.collect();
        format!(
            "\nhelp: write `{}` instead: then {} is at {}, the nearest of all assemblies",
            clauses.join(" "),
            self.joint(joint),
            self.format_coordinate(joint, value)
        )
    }

    fn distance(&self, joint: JointId, a: f64, b: f64) -> f64 {
        match self.model.joint(joint).kind {
            JointKind::Revolute(..) => (0.5 * (a - b)).sin().abs(),
            _ => (a - b).abs(),
        }
    }

    pub(super) fn format_coordinate(&self, joint: JointId, value: f64) -> String {
        match self.model.joint(joint).kind {
            JointKind::Revolute(..) => format!("{} deg", brief(value.to_degrees())),
            _ => brief(value),
        }
    }
}

/// The help where no assembly was found.
const NO_ANGLE: &str =
    "\nhelp: leave this out; `near` after a link chooses one of several assemblies";

/// The start of a mechanism, without what it says of joints that follow from others.
fn assemble(model: &mut Model) -> Result<Plan, Diagnosis> {
    loop {
        let structure = structure::analyse(model).map_err(|diagnoses| {
            let first = diagnoses.into_iter().next();
            first.unwrap_or_else(|| bug!("a structure is refused without a reason"))
        })?;
        match plan::plan(model, &structure) {
            Err(Diagnosis::StartNotFree { joint }) => {
                model.start.values.retain(|value| value.joint != joint);
            }
            plan => return plan,
        }
    }
}

/// Where a joint is in the assembly that is nearest to these angles, in degrees.
fn coordinate_near(model: &Model, joint: JointId, links: &[LinkId], angles: &[f64]) -> Option<f64> {
    let mut chosen = model.clone();
    let near = links.iter().zip(angles).map(|(&link, angle)| Near {
        link,
        angle: angle.to_radians(),
        origin: Origin::default(),
    });
    chosen.start.near.extend(near);
    let plan = assemble(&mut chosen).ok()?;
    coordinate(&chosen, &plan, joint)
}

fn coordinate(model: &Model, plan: &Plan, joint: JointId) -> Option<f64> {
    LinkFrames::new(model, &plan.start.poses).coordinate(joint)
}
