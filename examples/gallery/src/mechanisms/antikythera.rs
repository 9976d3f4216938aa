//! The computer of Antikythera: gears whose ratios are the periods of the sky.

use crate::mechanisms::precisions::{exhibited, mechanism};
use mech_runtime::Real;

mechanism! {
    /// The gears of the Antikythera mechanism, with the teeth that Freeth and others counted in 2006. A turn of the input is a year.
    pub struct Antikythera;
    part Axle { // a wheel, or several on one shaft
        port plate { point hole = (0, 0); }
        link wheel { point axis = (0, 0); }
        joint turn = revolute(plate.hole, wheel.axis);
    }

    part PinAndSlot {
        port driver { point pin = (19.2, 0); }
        port driven { line slot = (0, 0) -> (1, 0); }
        joint slide = slot(driver.pin, driven.slot);
    }

    // Lengths are half millimetres: a tooth takes one on the diameter. The plate has 15 axles.
    use year: Axle { plate = ground };
    use moon: Axle { plate = ground };
    use c: Axle { plate = ground at (47.9, 17.4) };
    use d: Axle { plate = ground at (75.2, -6.1) };
    use mean_moon: Axle { plate = ground at (0, -32) };
    use carrier: Axle { plate = ground at (0, -32) };
    use true_moon: Axle { plate = ground at (0, -32) };
    use l: Axle { plate = ground at (-47.2, 19.4) };
    use m: Axle { plate = ground at (-25, 90.5) };
    use metonic: Axle { plate = ground at (-8, 119.9) };
    use games: Axle { plate = ground at (-58.7, 149.2) };
    use p: Axle { plate = ground at (29.5, 119.9) };
    use callippic: Axle { plate = ground at (47.5, 151.1) };
    use f: Axle { plate = ground at (60.3, -136.4) };
    use saros: Axle { plate = ground at (23.9, -157.4) };
    use h: Axle { plate = ground at (-16.1, -157.4) };
    use exeligmos: Axle { plate = ground at (-44.9, -133.3) };
    motor year.turn;

    // The moon: its mean motion from the year, its anomaly by a pin in a slot on two axles 1.1 mm apart.
    joint b2_c1 = gear(year.wheel, c.wheel, 64 : 38);
    joint c2_d1 = gear(c.wheel, d.wheel, 48 : 24);
    joint d2_e2 = gear(d.wheel, mean_moon.wheel, 127 : 32);
    use k1: Axle { plate = carrier.wheel at (50, 0) };
    use k2: Axle { plate = carrier.wheel at (50 * cos(2 * asin(0.022)), 50 * sin(2 * asin(0.022))) };
    joint e5_k1 = gear(mean_moon.wheel, k1.wheel, 50 : 50);
    joint k2_e6 = gear(k2.wheel, true_moon.wheel, 50 : 50);
    joint e1_b3 = gear(true_moon.wheel, moon.wheel, 32 : 32);
    use anomaly: PinAndSlot { driver = k1.wheel, driven = k2.wheel };
    start { k2.wheel near 0 deg; }

    // The calendar: 235 months are 19 years.
    joint b2_l1 = gear(year.wheel, l.wheel, 64 : 38);
    joint l2_m1 = gear(l.wheel, m.wheel, 53 : 96);
    joint m2_n1 = gear(m.wheel, metonic.wheel, 15 : 53);
    joint n3_o1 = gear(metonic.wheel, games.wheel, 57 : 60);
    joint n2_p1 = gear(metonic.wheel, p.wheel, 15 : 60);
    joint p2_q1 = gear(p.wheel, callippic.wheel, 12 : 60);

    // The eclipses: 223 months.
    joint m3_e3 = gear(m.wheel, carrier.wheel, 27 : 223);
    joint e4_f1 = gear(carrier.wheel, f.wheel, 188 : 53);
    joint f2_g1 = gear(f.wheel, saros.wheel, 30 : 54);
    joint g2_h1 = gear(saros.wheel, h.wheel, 20 : 60);
    joint h2_i1 = gear(h.wheel, exeligmos.wheel, 15 : 60);
}

exhibited!(Antikythera, "antikythera", "antikythera.rs", motion);

/// A year forwards and back.
fn motion<T: Real>(phase: T) -> [T; 1] {
    let (_, cos) = Real::sin_cos(phase * T::TURN);
    [T::from_f64(0.5) * (T::ONE - cos) * T::TURN]
}
