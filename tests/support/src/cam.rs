//! Random cams on random mechanisms.

use crate::{Dice, add_axis, model};
use mech_compiler::model::{
    AxisKind, Joint, JointId, JointKind, Law, LawId, Link, LinkId, Model, Origin,
};

/// A mechanism of one motor, which has this law in `t`.
///
/// # Panics
/// If the text is no law that has a value at zero.
#[must_use]
pub fn model_of_law(text: &str) -> Model {
    model(&format!(
        "struct M; ground {{ point o = (0, 0); }} link crank {{ point o = (0, 0); }}
        joint a = revolute(ground.o, crank.o); motor a = {text};"
    ))
}

/// A law by its text, in `t`.
///
/// # Panics
/// As [`model_of_law`].
#[must_use]
pub fn law(text: &str) -> Law {
    let laws = model_of_law(text).laws;
    laws.into_iter().next().expect("a law")
}

/// Puts a link on an end of some joint of a mechanism as drawn, with a cam by which it follows that joint: the cam, if the
/// mechanism has no slots, whose dies must be its last links.
pub fn add_cam(model: &mut Model, dice: &mut Dice) -> Option<JointId> {
    if model.links.iter().any(|link| link.die.is_some()) {
        return None;
    }
    let moves = |id: &JointId| {
        let kind = model.joint(*id).kind;
        matches!(kind, JointKind::Revolute(..) | JointKind::Prismatic(..))
    };
    let shafts: Vec<JointId> = model.joint_ids().filter(moves).collect();
    let shaft = *dice.pick(&shafts);
    let (a, b) = model.ends(shaft);
    let carrier = *dice.pick(&[a, b]);
    let number = model.links.len();
    let mut link = Link::new(&format!("l{number}"), Origin::default());
    link.drawn = true;
    model.links.push(link);
    let at = [dice.between(-5.0, 5.0), dice.between(-5.0, 5.0)];
    let (y, x) = dice.between(-3.0, 3.0).sin_cos();
    let slides = dice.once_in(2);
    let kind = if slides { AxisKind::Line } else { AxisKind::Point };
    let ends = [carrier, LinkId::new(number)].map(|link| {
        let direction = if slides { [x, y] } else { [1.0, 0.0] };
        add_axis(model, link, kind, at, direction)
    });
    let mut joint = |name: &str, kind: JointKind| {
        let id = JointId::new(model.joints.len());
        model.joints.push(Joint {
            name: format!("{name}{}", id.index()),
            origin: Origin::default(),
            kind,
            hidden: false,
        });
        id
    };
    let follower = joint(
        "j",
        if slides {
            JointKind::Prismatic(ends[0], ends[1])
        } else {
            JointKind::Revolute(ends[0], ends[1])
        },
    );
    let law_id = LawId::new(model.laws.len());
    let cam = joint("c", JointKind::Cam { shaft, follower, law: law_id });
    let size = dice.between(-1.0, 1.0);
    let text = match dice.below(6) {
        4 => format!(
            "rise {} over 1.2 with modified_sine, dwell 0.7, return over 2, dwell 2 * PI - 3.9, repeat",
            size.abs() + 0.1
        ),
        0 => format!("{size} * sin(t)"),
        1 => format!("{size} * (1 - cos(t))"),
        2 => format!("{size} * sin(2 * t) + 0.2 * (cos(t) - exp(sin(t)) + max(0, 0))"),
        3 => format!("{size} * t"),
        _ => format!("{size} * t / sqrt(1 + t * t) - 2 * t"),
    };
    model.laws.push(law(&text));
    Some(cam)
}
