//! Gears, belts, racks and cams.

in_both_precisions! {
    {
        /// A train with a belt.
        Clock {
            link first; link second; link third; link fourth;
            joint a = revolute(ground, first) at (0, 0);
            joint b = revolute(ground, second) at (3, 0);
            joint c = revolute(ground, third) at (6, 0);
            joint d = revolute(ground, fourth) at (9, 0);
            joint ab = gear(first, second, 8 : 60);
            joint bc = gear(second, third, 10 : 64);
            joint cd = belt(third, fourth, 2 : 3);
            motor a;
        }
        /// Two motors.
        Differential {
            ground { point shaft = (0, 0); }
            link sun { point shaft = (0, 0); }
            link ring { point shaft = (0, 0); }
            link arm { point shaft = (0, 0); point pin = (6, 0); }
            link planet { point pin = (0, 0); }
            joint s = revolute(ground.shaft, sun.shaft);
            joint r = revolute(ground.shaft, ring.shaft);
            joint a = revolute(ground.shaft, arm.shaft);
            joint p = revolute(arm.pin, planet.pin);
            joint inner = gear(sun, planet, 5 : 1);
            joint outer = gear(planet, ring, 1 : -7);
            motor s;
            motor r;
        }
        /// Redundant.
        FourGears {
            link a; link b; link c; link d;
            joint pa = revolute(ground, a) at (0, 0);
            joint pb = revolute(ground, b) at (2, 0);
            joint pc = revolute(ground, c) at (2, 2);
            joint pd = revolute(ground, d) at (0, 2);
            joint ab = gear(a, b, 20 : 20);
            joint bc = gear(b, c, 20 : 20);
            joint cd = gear(c, d, 20 : 20);
            joint da = gear(d, a, 20 : 20);
            motor pa;
            allow redundant;
        }
        /// Racks on both sides.
        TwoRacks {
            link pinion;
            link lower { point mark = (1, -0.5); }
            link upper { point mark = (1, 0.5); }
            joint a = revolute(ground, pinion) at (0, 0);
            joint low = prismatic(ground, lower) at (0, -0.5) along (1, 0);
            joint up = prismatic(upper, ground) at (0, 0.5) along (1, 0);
            joint mesh = rack(pinion, lower, radius 0.5);
            joint across = rack(pinion, upper, radius -0.5);
            motor low;
        }
        /// A loop whose unknown angles a gear ties.
        TiedFiveBar {
            link left; link right; link rod;
            link arm { point pen = (2.2, 4); }
            joint a = revolute(ground, left) at (0, 0);
            joint b = revolute(left, rod) at (0, 1);
            joint c = revolute(rod, arm) at (2, 3);
            joint d = revolute(arm, right) at (4, 1.2);
            joint e = revolute(ground, right) at (4, 0);
            joint mesh = gear(left, right, -30 : 20);
            motor c;
        }
        /// A gear turned by a loop.
        GearedRocker {
            link crank; link coupler; link rocker; link wheel;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (0.8, 0.6);
            joint c = revolute(coupler, rocker) at (3.3, 2.9);
            joint d = revolute(ground, rocker) at (4, 0);
            joint e = revolute(ground, wheel) at (6, 0);
            joint mesh = gear(rocker, wheel, 30 : 10);
            motor a;
            continuous c, e;
        }
        /// A cam, and what its follower drives.
        Lifter {
            const LIFT = 0.2;
            ground { point shaft = (0, 0); line guide = (0, 1) -> (0, 1); point o = (2, 0); }
            link disk { point shaft = (0, 0); }
            link valve { line stem = (0, 0) -> (0, 1); point top = (0, 0.5); }
            link rod { point first = (0, 0); point last = (2, 0); }
            link rocker { point o = (0, 0); point end = (1.2, 0); }
            joint a = revolute(ground.shaft, disk.shaft);
            joint h = prismatic(ground.guide, valve.stem);
            joint c = cam(a, h, LIFT * (1 - cos(q)) + max(0, 0.1 * sin(2 * q)) + atan(tan(q / 8)) / 50);
            joint x = revolute(valve.top, rod.first);
            joint y = revolute(rod.last, rocker.end);
            joint o = revolute(ground.o, rocker.o);
            motor a;
            start { rod near 0 deg; }
        }
        /// A cam turned by a loop.
        Rocking {
            link crank; link coupler; link rocker; link follower;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (0.8, 0.6);
            joint c = revolute(coupler, rocker) at (3.3, 2.9);
            joint d = revolute(ground, rocker) at (4, 0);
            joint f = prismatic(ground, follower) at (6, 0) along (0, 1);
            joint k = cam(d, f, q * q + 0.3 * q);
            motor a;
        }
        /// A law that ends.
        Ending {
            ground { point o = (0, 0); line rail = (0, 0) -> (1, 0); }
            link disk { point o = (0, 0); }
            link block { line rail = (0, 0) -> (1, 0); }
            joint a = revolute(ground.o, disk.o);
            joint x = prismatic(ground.rail, block.rail);
            joint c = cam(a, x, sqrt(1 - q) + exp(q) / (q - 3) + min(abs(q), 1));
            motor a;
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::all_moves;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        all_moves::<Clock>(recorder, 1.3);
        all_moves::<Differential>(recorder, 0.9);
        all_moves::<FourGears>(recorder, 0.4);
        all_moves::<TwoRacks>(recorder, 0.3);
        all_moves::<TiedFiveBar>(recorder, 0.05);
        all_moves::<GearedRocker>(recorder, 0.3);
        all_moves::<Lifter>(recorder, 0.5);
        all_moves::<Rocking>(recorder, 0.3);
        all_moves::<Ending>(recorder, 0.11);
    }
}
