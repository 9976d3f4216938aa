//! The names of the quantities of a mechanism, to choose from.

use super::naming::has_coordinate;
use mech_compiler::model::{AxisId, AxisKind, LinkId, Model};

/// Quantities that belong together, by their names.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Offer {
    /// Their subject: `point coupler.tip`.
    pub(crate) of: String,
    /// Their names: `velocity:coupler.tip.x`.
    pub(crate) names: Vec<String>,
}

/// Everything that can be measured, in the order of its declaration: points, joints, links, forces.
pub(crate) fn offers(model: &Model, has_loops: bool) -> Vec<Offer> {
    let mut offers = Vec::new();
    for name in points(model).filter_map(|point| point_name(model, point)) {
        let of = format!("point {name}");
        let orders = ["", "velocity:", "acceleration:"].into_iter();
        let names = orders.flat_map(|order| {
            // The distance from the origin says little.
            let parts: &[&str] = if order.is_empty() { &["x", "y"] } else { &["x", "y", "norm"] };
            parts.iter().map(|part| format!("{order}{name}.{part}")).collect::<Vec<_>>()
        });
        offers.push(Offer { of, names: names.collect() });
    }
    for joint in model.declared_joints() {
        let name = &model.joint(joint).name;
        let mut names = Vec::new();
        if has_coordinate(model, joint) {
            names.extend(["", "velocity:", "acceleration:"].map(|order| format!("{order}{name}")));
        }
        if model.motor_of(joint).is_some() {
            names.push(format!("torque:{name}"));
            let loads = model.actions.loads.iter();
            names.extend(loads.map(|load| format!("advantage({}, {name})", load.name)));
        }
        for motor in model.motors.iter().filter(|motor| motor.joint != joint) {
            if has_coordinate(model, joint) {
                names.push(format!("d({name}, {})", model.joint(motor.joint).name));
            }
        }
        names.extend(["x", "y", "norm"].map(|part| format!("reaction:{name}.{part}")));
        if model.roller_of(joint).is_some() {
            names.extend(["pressure", "curvature"].map(|word| format!("{word}({name})")));
        }
        offers.push(Offer { of: format!("joint {name}"), names });
    }
    for link in model.declared_links() {
        let name = &model.link(link).name;
        let names = ["", "velocity:", "acceleration:"].map(|order| format!("{order}{name}"));
        offers.push(Offer { of: format!("link {name}"), names: names.into() });
    }
    let has_mass = model.links.iter().any(|link| link.mass.is_some());
    if has_mass || !model.actions.loads.is_empty() {
        let names = ["x", "y", "norm", "torque"].map(|part| format!("reaction:ground.{part}"));
        offers.push(Offer { of: "the ground".to_owned(), names: names.into() });
    }
    if has_loops {
        offers.push(Offer { of: "loops".to_owned(), names: vec!["transmission".to_owned()] });
    }
    offers.push(Offer { of: "the motion".to_owned(), names: vec!["t".to_owned()] });
    offers
}

fn points(model: &Model) -> impl Iterator<Item = AxisId> + '_ {
    let all = (0..model.axes.len()).map(AxisId::new);
    all.filter(|&id| {
        let axis = model.axis(id);
        axis.kind == AxisKind::Point && axis.link != LinkId::GROUND
    })
}

fn point_name(model: &Model, id: AxisId) -> Option<String> {
    let axis = model.axis(id);
    let name = axis.name.as_ref()?;
    Some(format!("{}.{name}", model.owner_of(axis)))
}
