//! Several errors in one text.

use super::parsed;
use crate::model::{AtChangePoints, Target};

#[test]
fn a_setting_after_a_missing_semicolon_is_read() {
    let text = "struct M; joint d = revolute(ground, a) at (0, 0)\nat change points stop; link a\naccuracy 1e-9;\n\
        const A = 1\ncost cortex_m4f; link b;";
    let model = parsed(text).model;
    assert_eq!(model.accuracy, Some(1e-9));
    assert_eq!(model.change_points, AtChangePoints::Stop);
    assert_eq!(model.target, Target::CortexM4f);
}
