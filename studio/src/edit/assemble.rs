//! Assembly: two axes are made to coincide, and the links with them.

use super::declare::{check_expression, check_name, check_path, joint, pair};
use super::{Assembly, Change, JointForm, Refusal, Rule, Scene, place, pose};
use crate::document::Reading;
use mech_compiler::model::{AxisId, JointId, JointKind, LinkId};
use mech_compiler::structure::Diagnosis;

pub(super) fn join(scene: &Scene, assembly: &Assembly) -> Result<Change, Refusal> {
    check_name(&assembly.name)?;
    assembly.ends.iter().try_for_each(|end| check_path(end))?;
    let is_cam = matches!(assembly.kind, JointForm::Cam { .. });
    if !is_cam {
        let [first, second] = assembly.ends.each_ref().map(|end| body_of(scene, end));
        if first.is_some() && first == second {
            return Err(Refusal::forbidden(Rule::TwoLinks, Vec::new()));
        }
        if let Some((first, second)) = first.zip(second)
            && let Some(holder) = holder(scene, assembly, [first, second])
        {
            let why = format!("joint `{holder}` holds them already; remove it first");
            return Err(Refusal::forbidden(Rule::HeldOnce, vec![why]));
        }
        if assembly.at.is_none() && is_joined(scene, assembly) {
            return Err(Refusal::forbidden(Rule::Once, Vec::new()));
        }
    }
    let mut rewriter = scene.rewriter()?;
    joint(&mut rewriter, &statement(assembly)?)?;
    Change::of(scene, &rewriter)
}

fn statement(assembly: &Assembly) -> Result<String, Refusal> {
    let Assembly { name, kind, ends: [first, second], at, along } = assembly;
    let mut roller = "";
    let (numbers, carrier) = match kind {
        JointForm::Gear { sizes: [a, b], on } | JointForm::Belt { sizes: [a, b], on } => {
            check_expression(a)?;
            check_expression(b)?;
            (format!(", {a} : {b}"), on.as_ref())
        }
        JointForm::Rack { radius, on } => {
            check_expression(radius)?;
            (format!(", radius {radius}"), on.as_ref())
        }
        JointForm::Cam { law } => {
            check_expression(law)?;
            let (law, after) = law.split_once(" roller ").unwrap_or((law, ""));
            roller = after;
            (format!(", {law}"), None)
        }
        JointForm::Revolute | JointForm::Prismatic | JointForm::Slot | JointForm::Weld => {
            (String::new(), None)
        }
    };
    let mut text = format!("joint {name} = {}({first}, {second}{numbers}", kind.word());
    if let Some(carrier) = carrier {
        check_path(carrier)?;
        text += &format!(" on {carrier}");
    }
    text += ")";
    if !roller.is_empty() {
        text += &format!(" roller {roller}");
    }
    if let Some(at) = at {
        text += &format!(" at {}", pair(at)?);
    }
    if let Some(along) = along {
        check_expression(along)?;
        text += &format!(" along {along}");
    }
    Ok(text + ";")
}

fn body_of(scene: &Scene, end: &str) -> Option<LinkId> {
    let model = &scene.model;
    if let Some(axis) = axis_at(scene, end) {
        return Some(model.axis(axis).link);
    }
    let mut links = model.link_ids();
    links.find(|&link| model.link(link).die.is_none() && model.link(link).name == end)
}

fn axis_at(scene: &Scene, end: &str) -> Option<AxisId> {
    let axis = end.contains('.').then(|| place::axis_of(&scene.model, end));
    axis.flatten()
}

/// A joint of the same links beside which another would hold nothing, or beside which a weld would: links that are welded together count as
/// one.
fn holder<'s>(scene: &'s Scene, assembly: &Assembly, links: [LinkId; 2]) -> Option<&'s str> {
    let model = &scene.model;
    let holds = match assembly.kind {
        JointForm::Revolute | JointForm::Prismatic | JointForm::Slot => false,
        JointForm::Weld => true,
        _ => return None,
    };
    let mut bodies: Vec<LinkId> = model.link_ids().collect();
    for joint in model.joint_ids() {
        if let JointKind::Weld(..) = model.joint(joint).kind {
            let (a, b) = model.ends(joint);
            let (to, from) = (bodies[a.index()], bodies[b.index()]);
            bodies.iter_mut().filter(|body| **body == from).for_each(|body| *body = to);
        }
    }
    let [first, second] = links.map(|link| bodies[link.index()]);
    let joins = |joint: &JointId| {
        let (a, b) = model.ends(*joint);
        let is_weld = matches!(model.joint(*joint).kind, JointKind::Weld(..));
        let ends = [a, b].map(|link| bodies[link.index()]);
        if first == second {
            // One of the welds that hold them.
            return is_weld && ends[0] == first;
        }
        holds
            && model.joint(*joint).kind.axes().is_some()
            && (ends == [first, second] || ends == [second, first])
    };
    let joint = model.joint_ids().find(joins)?;
    Some(&model.joint(joint).name)
}

/// Whether some joint joins the same two axes.
fn is_joined(scene: &Scene, assembly: &Assembly) -> bool {
    let [Some(a), Some(b)] = assembly.ends.each_ref().map(|end| axis_at(scene, end)) else {
        return false;
    };
    let mut joints = scene.model.joints.iter();
    joints.any(|joint| {
        let axes = joint.kind.axes();
        axes.is_some_and(|axes| axes == [a, b] || axes == [b, a])
    })
}

/// Refuses an assembly after which the mechanism breaks a rule that it kept before.
pub(super) fn judge(scene: &Scene, assembly: &Assembly, after: &Reading) -> Result<(), Refusal> {
    let Err(faults) = &after.result else {
        return Ok(());
    };
    let before = scene.reading()?;
    let known = before.result.as_ref().err();
    let known = known.into_iter().flat_map(|faults| &faults.diagnoses);
    let known: Vec<Rule> = known.filter_map(|one| rule_of(one, assembly)).collect();
    let broken = faults.diagnoses.iter().filter_map(|one| rule_of(one, assembly));
    for rule in broken {
        if !known.contains(&rule) {
            let messages = faults.messages.iter().map(|message| message.text.clone());
            return Err(Refusal::forbidden(rule, messages.collect()));
        }
    }
    Ok(())
}

/// The rule that is broken by what is wrong; none if it may be put right by going on.
fn rule_of(diagnosis: &Diagnosis, assembly: &Assembly) -> Option<Rule> {
    Some(match diagnosis {
        Diagnosis::Overdetermined { is_mobile: false, .. } => Rule::HeldOnce,
        Diagnosis::Blocked { .. } => Rule::Freedom,
        // Links are welded before others are joined to them.
        Diagnosis::Rigid if assembly.kind != JointForm::Weld => Rule::Freedom,
        Diagnosis::CannotClose { .. } | Diagnosis::NotAsDrawn { .. } => Rule::Coincidence,
        Diagnosis::NoMesh { .. } | Diagnosis::NoCarrier { .. } | Diagnosis::NotCarrier { .. } => {
            Rule::Rolling
        }
        _ => return None,
    })
}

/// Where the second link of an assembly has come to stand: `rod stands at (1, 0), turned 30 deg`.
pub(super) fn stand(assembly: &Assembly, after: &Reading) -> Option<String> {
    let compiled = after.result.as_ref().ok()?;
    let joint = after.model.joints.iter().position(|one| one.name == assembly.name)?;
    let (_, link) = after.model.ends(mech_compiler::model::JointId::new(joint));
    let [cos, sin, x, y] = pose::start_of(compiled, link)?;
    let rounded = |value: f64| (value * 1e4).round() / 1e4 + 0.0;
    let turned = rounded(sin.atan2(cos).to_degrees());
    let name = &after.model.link(link).name;
    (link != LinkId::GROUND)
        .then(|| format!("{name} stands at ({}, {}), turned {turned} deg", rounded(x), rounded(y)))
}
