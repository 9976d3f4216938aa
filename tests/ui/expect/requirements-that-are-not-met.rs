use mech_runtime::mechanism;

mechanism! {
    struct Wiper;
    ground { point shaft = (0, 0); point pivot = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1.2, 0); }
    link rod { point pin = (0, 0); point end = (4.2, 0); }
    link arm { point pivot = (0, 0); point end = (2, 0); point blade = (6, 0); }
    joint a = revolute(ground.shaft, crank.shaft);
    joint b = revolute(crank.pin, rod.pin);
    joint c = revolute(rod.end, arm.end);
    joint d = revolute(ground.pivot, arm.pivot);
    motor a;
    start { a = 60 deg; arm near 90 deg; }

    expect turns(a);
    expect transmission > 55 deg, "the bearing is worn";
    expect arm.blade.y > 5;
}

mechanism! {
    struct Press;
    link block { point tip = (0, 1); }
    joint a = prismatic(ground, block) at (0, 0) along (1, 0);
    motor a;

    expect block.tip.x < 3;
}

fn main() {
    let _ = Wiper::new().arm_blade();
}
