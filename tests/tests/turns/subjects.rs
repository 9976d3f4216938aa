//! Mechanisms whose joints turn over and over. What is asked of them is put at their end.

use std::cmp::Ordering;

/// A drag link with these lengths: the ground is the shortest, so that all links turn all the way round.
pub(super) fn drag_link([crank, coupler, rocker]: [f64; 3], asked: &str) -> String {
    format!(
        "struct Drag;
        ground {{ point a = (0, 0); point d = (0.8, 0); point w = (9, 0); }}
        link crank {{ point a = (0, 0); point b = ({crank}, 0); mass 1 at (0, 0) inertia 1; }}
        link coupler {{ point b = (0, 0); point c = ({coupler}, 0); }}
        link rocker {{ point d = (0, 0); point c = ({rocker}, 0); }}
        joint a = revolute(ground.a, crank.a); joint b = revolute(crank.b, coupler.b);
        joint c = revolute(coupler.c, rocker.c); joint d = revolute(ground.d, rocker.d);
        motor a; start {{ a = 60 deg; coupler near -60 deg; }}
        {asked}"
    )
}

/// A wheel and a planet on an arm, of sizes in this ratio, which follow two motors.
pub(super) fn geared([p, q]: [i32; 2], asked: &str) -> String {
    let planet = f64::from(p + q).abs().max(1.0);
    let shaft = f64::from(p + q);
    format!(
        "struct Geared;
        ground {{ point o = (0, 0); point w = ({shaft}, 0); }}
        link sun {{ point o = (0, 0); mass 1 at (0, 0) inertia 1; }} link arm {{ point o = (0, 0); point p = ({planet}, 0); mass 1 at (0, 0) inertia 1; }}
        link planet {{ point p = (0, 0); }} link big {{ point w = (0, 0); }}
        joint s = revolute(ground.o, sun.o); joint r = revolute(ground.o, arm.o);
        joint pin = revolute(arm.p, planet.p); joint wheel = revolute(ground.w, big.w);
        joint inner = gear(sun, planet, {p} : {q}); joint outer = gear(sun, big, {q} : {p});
        motor s; motor r;
        {asked}"
    )
}

/// A drag link that turns a wheel by this joint.
pub(super) fn behind(lengths: [f64; 3], by: &str, asked: &str) -> String {
    let wheel = "link wheel { point w = (0, 0); } joint wheel_pin = revolute(ground.w, wheel.w);";
    drag_link(lengths, &format!("{wheel} {by} {asked}"))
}

/// The same ratio with the ring the larger, if it is one.
pub(super) fn meshing(p: i32, q: i32, inside: bool) -> [i32; 2] {
    match (inside, p.cmp(&q)) {
        (true, Ordering::Less) => [p, -q],
        (true, Ordering::Greater) => [-p, q],
        _ => [p, q],
    }
}
