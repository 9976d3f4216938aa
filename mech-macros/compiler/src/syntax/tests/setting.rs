//! The start, and what is wanted and let pass.

use super::good;
use crate::syntax::Parsed;

const CRANK: &str = "ground { point o = (0, 0); line l = (0, 0) -> (1, 0); } link crank { point p = (0, 0); } link wheel;\n\
    joint shaft = revolute(ground.o, crank.p); joint mesh = gear(crank, wheel, 1 : 2);\n\
    joint drawn = revolute(ground, wheel) at (3, 0);\n";

pub(super) fn with_crank(text: &str) -> Parsed {
    good(&format!("struct M; {CRANK}{text}"))
}

#[test]
fn accelerations_bring_velocities_with_them() {
    use crate::model::Effects;
    let effects = |text| {
        let Effects {
            velocity,
            acceleration,
            ..
        } = good(&format!("struct M; {text}")).model.effects;
        [velocity, acceleration]
    };
    assert_eq!(effects(""), [false, false]);
    assert_eq!(effects("effects { velocity; }"), [true, false]);
    assert_eq!(effects("effects { acceleration; }"), [true, true]);
}

#[test]
fn some_things_are_let_pass() {
    use crate::model::Allowances;
    let allow = |text| {
        let Allowances { redundant, coupled } = good(&format!("struct M; {text}")).model.allow;
        [redundant, coupled]
    };
    assert_eq!(allow(""), [false, false]);
    assert_eq!(allow("allow redundant;"), [true, false]);
    assert_eq!(allow("allow coupled; allow redundant;"), [true, true]);
}

#[test]
fn what_is_shown_is_noted() {
    use crate::model::{AxisId, JointId, LinkId, Shown};
    let show = |text| with_crank(text).model.show;
    assert_eq!(show(""), None);
    let (crank, wheel) = (LinkId::new(1), LinkId::new(2));
    assert_eq!(
        show("show crank, drawn; motor shaft;"),
        Some(vec![Shown::Link(crank), Shown::Joint(JointId::new(2))])
    );
    // The third axis of the text, after the two of the ground.
    assert_eq!(
        show("show wheel, crank.p, shaft,; motor shaft;"),
        Some(vec![
            Shown::Link(wheel),
            Shown::Point(AxisId::new(2)),
            Shown::Joint(JointId::new(0))
        ])
    );
}

#[test]
fn what_is_continuous_turns_and_is_shown() {
    use crate::model::JointId;
    let continuous = |text| with_crank(text).model.continuous;
    assert_eq!(continuous(""), []);
    assert_eq!(continuous("continuous shaft,;"), [JointId::new(0)]);
    assert_eq!(
        continuous("continuous drawn, shaft; show crank, shaft, drawn; motor shaft;"),
        [JointId::new(2), JointId::new(0)]
    );
}
