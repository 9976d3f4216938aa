//! Joints.

use super::assert_messages;

/// Two links with a point and a line each, and a ground with a point.
pub(super) const LINKS: &str = "ground { point o = (0, 0); } link crank { point pin = (0, 0); line rail = (0, 0) -> (1, 0); }\n\
    link rod { point eye = (0, 0); line way = (0, 0) -> (1, 0); } link bare;\n";

#[test]
fn a_bad_joint_is_left_out_and_not_missed() {
    let text =
        format!("{LINKS}joint d = revolute(crank.«pni», rod.eye); motor d; start {{ d = 0; }}");
    let parsed = assert_messages(&text, &["`crank` has no point `pni`; did you mean `pin`?"]);
    assert!(parsed.model.joints.is_empty() && parsed.model.motors.is_empty());
    assert_eq!(parsed.motors, 1);
}
