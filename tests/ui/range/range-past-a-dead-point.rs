use mech_runtime::mechanism;

mechanism! {
    struct Rocking;

    ground { point a = (0, 0); point d = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point a = (0, 0); point b = (2, 0); }
    link rocker { point shaft = (0, 0); point b = (1.5, 0); }

    joint a = revolute(ground.a, crank.shaft);
    joint b = revolute(crank.pin, coupler.a);
    joint c = revolute(coupler.b, rocker.b);
    joint d = revolute(ground.d, rocker.shaft);

    motor a in -50 deg ..= 90 deg;
    start { coupler near 40 deg; }
}

mechanism! {
    struct Stopping;

    ground { point a = (0, 0); point d = (2, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point a = (0, 0); point b = (2, 0); }
    link rocker { point shaft = (0, 0); point b = (1, 0); }

    joint a = revolute(ground.a, crank.shaft);
    joint b = revolute(crank.pin, coupler.a);
    joint c = revolute(coupler.b, rocker.b);
    joint d = revolute(ground.d, rocker.shaft);

    motor a in 10 deg ..= 270 deg;
    start { a = 90 deg; rocker near 90 deg; }
    at change points stop;
}

mechanism! {
    struct Iterated;

    ground { point a = (0, 0); point d = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point a = (0, 0); point b = (3.5, 0); }
    link rocker { point shaft = (0, 0); point b = (3, 0); }

    joint a = revolute(ground.a, crank.shaft);
    joint b = revolute(crank.pin, coupler.a);
    joint c = revolute(coupler.b, rocker.b);
    joint d = revolute(ground.d, rocker.shaft);

    motor a in 0 deg ..= 360 deg;
    start { coupler near 50 deg; }
    method newton;
}

fn main() {}
