// It moves only as long as its lengths match.
mech_runtime::mechanism! {
    struct Rails;
    param third_foot = 2;
    link first;
    link second;
    link third;
    link rail;
    joint a = revolute(ground, first) at (0, 0);
    joint b = revolute(ground, second) at (4, 0);
    joint c = revolute(ground, third) at (third_foot, 0);
    joint d = revolute(first, rail) at (0.5, 1);
    joint e = revolute(second, rail) at (4.5, 1);
    joint f = revolute(third, rail) at (2.5, 1);
    motor a;
    allow redundant;
    effects { sensitivity; }
}

fn main() {
    // Nothing else turns red.
    let rails = Rails::new();
    let _ = rails.sensitivities();
    let _ = rails.b_sensitivity();
    let _ = rails.rail_sensitivity();
}
