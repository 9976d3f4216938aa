// What may depend on a param, and what not.
mech_runtime::mechanism! {
    struct FourBar;
    param rod_length = 3.5;
    const WIDTH = rod_length / 20;
    ground { point a = (0, 0); point d = (4, 0) -> (1, WIDTH); }
    link crank { point a = (0, 0); point b = (1, 0); circle (0, 0) radius WIDTH on plane rod_length; }
    link rod { point b = (0, 0); point c = (rod_length, 0); density 2; polygon [(0, 0), (rod_length, 0), (0, 1)]; }
    link rocker { point d = (0, 0); point c = (3, 0); }
    joint ja = revolute(ground.a, crank.a);
    joint jb = revolute(crank.b, rod.b);
    joint jc = revolute(rod.c, rocker.c);
    joint jd = revolute(ground.d, rocker.d);
    joint mesh = gear(crank, rocker, rod_length : 2.0);
    motor ja in 0 deg ..= 90 deg by rod_length;
    start { ja = 40 deg; rod near rod_length; }
}

fn main() {
    // Nothing else turns red.
    let mut four_bar = FourBar::new();
    let _ = four_bar.set_rod_length(4.0);
    let _ = four_bar.set_params([four_bar.rod_length()]);
    let _ = four_bar.params();
}
