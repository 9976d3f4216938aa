//! A link has a line of its own, but another joint of it is placed by `at`.

use mech_runtime::mechanism;

mechanism! {
    struct SliderCrank;

    ground { line bore = (0, 0.5) -> (1, 0); }
    link crank;
    link rod;
    link block { line way = (0, 0) -> (1, 0); }

    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0.5);
    joint c = revolute(rod, block) at (4, 0.5);
    joint x = prismatic(ground.bore, block.way);

    motor a;
}

fn main() {}
