//! Only what is asked for: the other loop, its motor's arm and their shapes are left out.

use mech_runtime::{Mechanism, mechanism};

mechanism! {
    pub struct Press: f32;
    look none;

    ground { circle (0, 0) radius 0.1 on plane 0 color 1; }
    link crank { circle (1, 0.5) radius 0.1 on plane 1 color 2; }
    link rod { point big_end = (1, 0.5); }
    link block { polygon [(3, -1), (5, -1), (5, 1)] on plane 2 color 3; }
    link arm { point tip = (-2, 1); circle (-2, 1) radius 0.1 on plane 1 color 4; }
    link lever;
    link idle;

    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0.5);
    joint c = revolute(rod, block) at (4, 0);
    joint x = prismatic(ground, block) at (4, 0) along (1, 0);
    joint d = revolute(crank, arm) at (0.5, 1);
    joint e = revolute(arm, lever) at (-2, 1);
    joint f = revolute(ground, lever) at (-2, -1);
    joint g = revolute(lever, idle) at (-3, -1);

    motor a;
    motor g;
    show block, rod.big_end, x, g;
}

fn main() {
    let mut press = Press::new();
    assert!(press.move_to([0.2, 1.0]).is_ok());
    assert_eq!(Press::LINKS, ["rod", "block"]);
    assert_eq!(Press::MOTORS, ["a", "g"]);
    assert_eq!(press.poses().len(), 2);
    assert_eq!(Press::SHAPES.len(), 2);
    assert_eq!(Press::SHAPES[1].link, 2);
    assert_eq!(Press::LOOP_COSTS.len(), 1);
    assert_eq!(press.g(), 1.0);
    let moved: f32 = press.block().translation.x;
    assert!((moved - press.x()).abs() < 1e-6);
    assert!(press.rod_big_end().y > 0.5);
    assert!(Press::REPORT.contains("  left out  loop 2 and joint g: "));
}
