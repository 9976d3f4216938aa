//! Parts that machines are made of, for `use mech_runtime::parts::…;` in a [`mechanism!`](crate::mechanism).
//!
//! Each has ports for the links that it joins, and numbers with values that a use may replace. Lengths are in scene units.
//! [`language::parts`](crate::language::parts) describes how parts are used.
//!
//! ```
//! mech_runtime::mechanism! {
//!     struct Crane;
//!     use mech_runtime::parts::Cylinder;
//!     link boom { point foot = (0, 0); point tip = (4, 0); }
//!     ground { point foot = (0, 0); }
//!     joint foot = revolute(ground.foot, boom.foot);
//!     use ram: Cylinder { base = ground at (2, 0), load = boom at (3, 0) };
//!     motor ram.stroke in 1.2 ..= 3;
//!     start { ram.stroke = 2; boom near 40 deg; }
//! }
//! let mut crane = Crane::new();
//! crane.move_to([2.5])?;
//! let apart = (crane.ram().rod_pin() - crane.ram().barrel_pin()).norm();
//! assert!((apart - 2.5).abs() < 1e-12);
//! # Ok::<(), mech_runtime::Blocked>(())
//! ```

use crate::mechanism_part;

/// The source of all parts here, for programs that read mechanisms from files.
pub const SOURCE: &str = include_str!("parts.rs");

mechanism_part! {
    /// A hydraulic or pneumatic cylinder, or any ram, between the origins of the frames of `base` and `load`.
    ///
    /// Joint `stroke` is the distance between its two pins; a motor goes there.
    pub Cylinder {
        port base { point pin = (0, 0); }
        port load { point pin = (0, 0); }
        link barrel { point pin = (0, 0); line bore = (0, 0) -> (1, 0); }
        link rod { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }
        joint pivot = revolute(base.pin, barrel.pin);
        joint stroke = prismatic(barrel.bore, rod.axis);
        joint eye = revolute(rod.pin, load.pin);
    }
}

mechanism_part! {
    /// A pantograph: what `follower.tracer` draws is `ratio` times as large as what `inner.guide` draws, both seen from the origin of
    /// `frame`. It has two freedoms, such as the joints `pivot` and `elbow`.
    pub Pantograph(arm = 4, ratio = 2) {
        port frame { point pivot = (0, 0); }
        link main { point pivot = (0, 0); point knee = (arm / ratio, 0); point elbow = (arm, 0); }
        link follower { point elbow = (0, 0); point knee = (arm / ratio, 0); point tracer = (arm, 0); }
        link inner { point knee = (0, 0); point guide = (arm / ratio, 0); }
        link outer { point knee = (0, 0); point guide = (arm - arm / ratio, 0); }
        joint pivot = revolute(frame.pivot, main.pivot);
        joint elbow = revolute(main.elbow, follower.elbow);
        joint upper_knee = revolute(main.knee, inner.knee);
        joint lower_knee = revolute(follower.knee, outer.knee);
        joint guide = revolute(inner.guide, outer.guide);
        start { pivot = 120 deg; elbow = -120 deg; inner near 0 deg; outer near -60 deg; }
    }
}

mechanism_part! {
    /// A stage of a scissor lift: `top` stays parallel to `base`. Stages stand on one another where the next is lent this one's `top`.
    ///
    /// Joint `rise` is the angle of an arm; a motor goes there.
    pub ScissorStage(arm = 2) {
        port base { point pin = (0, 0); line rail = (0, 0) -> (1, 0); }
        link rising { point foot = (0, 0); point middle = (arm / 2, 0); point head = (arm, 0); }
        link falling { point foot = (0, 0); point middle = (arm / 2, 0); point head = (arm, 0); }
        link top { point pin = (0, 0); line rail = (0, 0) -> (1, 0); }
        joint rise = revolute(base.pin, rising.foot);
        joint middle = revolute(rising.middle, falling.middle);
        joint foot = slot(falling.foot, base.rail);
        joint head = revolute(falling.head, top.pin);
        joint slide = slot(rising.head, top.rail);
        start { rise = 30 deg; falling near 150 deg; top near 0 deg; }
    }
}

mechanism_part! {
    /// The inversor of Peaucellier and Lipkin: `upper_far.tip` moves on a straight line, exactly.
    ///
    /// Its origin is the centre of inversion. Motor: joint `drive`.
    pub Peaucellier(crank = 2, arm = 5, side = 2.5) {
        port frame { point center = (0, 0); point shaft = (crank, 0); }
        link handle { point shaft = (0, 0); point pin = (crank, 0); }
        link upper { point center = (0, 0); point pin = (arm, 0); }
        link lower { point center = (0, 0); point pin = (arm, 0); }
        link upper_near { point tip = (0, 0); point pin = (side, 0); }
        link lower_near { point tip = (0, 0); point pin = (side, 0); }
        link upper_far { point tip = (0, 0); point pin = (side, 0); }
        link lower_far { point tip = (0, 0); point pin = (side, 0); }
        joint drive = revolute(frame.shaft, handle.shaft);
        joint first = revolute(frame.center, upper.center);
        joint second = revolute(frame.center, lower.center);
        joint third = revolute(handle.pin, upper_near.tip);
        joint fourth = revolute(handle.pin, lower_near.tip);
        joint fifth = revolute(upper.pin, upper_near.pin);
        joint sixth = revolute(lower.pin, lower_near.pin);
        joint seventh = revolute(upper.pin, upper_far.pin);
        joint eighth = revolute(lower.pin, lower_far.pin);
        joint ninth = revolute(upper_far.tip, lower_far.tip);
        start {
            drive = 60 deg; upper near 57 deg; lower near 3 deg; upper_near near 97 deg; lower_near near -37 deg;
            upper_far near 143 deg; lower_far near -83 deg;
        }
    }
}

mechanism_part! {
    /// A leg of Theo Jansen's beasts, with his lengths, to the left of a crank shaft at the origin of both ports.
    ///
    /// `crank` is the turning axle. `phase` is the angle of the leg's pin on it.
    pub JansenLeg(phase = 0 deg, unit = 1) {
        const hip = acos((41.5 * 41.5 + 40.1 * 40.1 - 55.8 * 55.8) / (2 * 41.5 * 40.1));
        const ankle = acos((36.7 * 36.7 + 49 * 49 - 65.7 * 65.7) / (2 * 36.7 * 49));
        port frame { point hip = (-38 * unit, -7.8 * unit); }
        port crank { point pin = (15 * unit, 0) turned phase; }
        link upper_rod { point pin = (0, 0); point knee = (50 * unit, 0); }
        link lower_rod { point pin = (0, 0); point ankle = (61.9 * unit, 0); }
        link thigh { point hip = (0, 0); point knee = (41.5 * unit, 0); point heel = (40.1 * unit, 0) turned hip; }
        link shin { point hip = (0, 0); point ankle = (39.3 * unit, 0); }
        link tendon { point heel = (0, 0); point calf = (39.4 * unit, 0); }
        link foot { point ankle = (0, 0); point calf = (36.7 * unit, 0); point tip = (49 * unit, 0) turned ankle; }
        joint upper_pin = revolute(crank.pin, upper_rod.pin);
        joint lower_pin = revolute(crank.pin, lower_rod.pin);
        joint upper_hip = revolute(frame.hip, thigh.hip);
        joint lower_hip = revolute(frame.hip, shin.hip);
        joint knee = revolute(upper_rod.knee, thigh.knee);
        joint ankle = revolute(lower_rod.ankle, shin.ankle);
        joint heel = revolute(thigh.heel, tendon.heel);
        joint calf = revolute(tendon.calf, foot.calf);
        joint sole = revolute(shin.ankle, foot.ankle);
        start { thigh near 106 deg; shin near -36 deg; tendon near -94 deg; }
    }
}

mechanism_part! {
    /// A leg of Joe Klann's walkers, with the lengths of US patent 6,260,862. It is to the left of a crank shaft at the origin of both ports.
    ///
    /// `crank` is the turning axle. `phase` is the angle of the leg's pin on it.
    pub KlannLeg(phase = 0 deg, unit = 1) {
        const bend = acos((0.59 * 0.59 + 1.1051 * 1.1051 - 0.5221 * 0.5221) / (2 * 0.59 * 1.1051));
        const calf = acos((0.8966 * 0.8966 + 1.732 * 1.732 - 0.8966 * 0.8966) / (2 * 0.8966 * 1.732));
        port frame { point lower = (-0.59 * unit, -0.176 * unit); point upper = (-0.233 * unit, 0.616 * unit); }
        port crank { point pin = (0.268 * unit, 0) turned phase; }
        link rod { point pin = (0, 0); point elbow = (0.59 * unit, 0); point knee = (1.1051 * unit, 0) turned -bend; }
        link lower_rocker { point pivot = (0, 0); point elbow = (0.3206 * unit, 0); }
        link upper_rocker { point pivot = (0, 0); point hip = (0.5177 * unit, 0); }
        link leg { point hip = (0, 0); point knee = (0.8966 * unit, 0); point foot = (1.732 * unit, 0) turned calf; }
        joint pin = revolute(crank.pin, rod.pin);
        joint lower = revolute(frame.lower, lower_rocker.pivot);
        joint elbow = revolute(rod.elbow, lower_rocker.elbow);
        joint upper = revolute(frame.upper, upper_rocker.pivot);
        joint hip = revolute(upper_rocker.hip, leg.hip);
        joint knee = revolute(rod.knee, leg.knee);
        start { lower_rocker near 124 deg; upper_rocker near 90 deg; leg near -16 deg; }
    }
}

mechanism_part! {
    /// A planetary gear with one planet. Its user lends sun, ring and arm, each turning about the origin of its port, and holds or drives
    /// them. Numbers of teeth are whole; the ring has `sun + 2 * planet`. A tooth is `pitch` wide on the pitch circle's diameter.
    pub EpicyclicStage(sun = 20, planet = 20, pitch = 0.1) {
        port sun_wheel;
        port ring_wheel;
        port arm { point axle = ((sun + planet) * pitch / 2, 0); }
        link planet_wheel { point axle = (0, 0); }
        joint axle = revolute(arm.axle, planet_wheel.axle);
        joint outside = gear(sun_wheel, planet_wheel, sun : planet on arm);
        joint inside = gear(planet_wheel, ring_wheel, planet : -(sun + 2 * planet) on arm);
    }
}

mechanism_part! {
    /// A Geneva drive: while joint `drive` turns once, joint `index` turns by one of `slots` and dwells.
    ///
    /// It is exact as a law of the two angles; pin and slots do not touch anything.
    pub Geneva(slots = 4, distance = 1) {
        const a = sin(PI / slots);
        const half = PI / 2 - PI / slots;
        port frame { point shaft = (0, 0); point index = (distance, 0); }
        link driver { point shaft = (0, 0); point pin = (distance * a, 0); }
        link wheel { point shaft = (0, 0); }
        joint drive = revolute(frame.shaft, driver.shaft);
        joint index = revolute(frame.index, wheel.shaft);
        joint law = cam(drive, index, (q - 2 * atan(tan(q / 2))) / slots
            + atan(a * sin(max(-half, min(half, 2 * atan(tan(q / 2))))) / (1 - a * cos(max(-half, min(half, 2 * atan(tan(q / 2))))))));
    }
}

mechanism_part! {
    /// An Oldham coupling: two shafts, `offset` apart, turn alike. Motor: joint `input`.
    pub Oldham(offset = 0.3) {
        port frame { point input = (0, 0); point output = (offset, 0); }
        link first { point shaft = (0, 0); line groove = (0, 0) -> (1, 0); }
        link middle { line tongue = (0, 0) -> (1, 0); line cross = (0, 0) -> (0, 1); }
        link second { point shaft = (0, 0); line groove = (0, 0) -> (0, 1); }
        joint input = revolute(frame.input, first.shaft);
        joint output = revolute(frame.output, second.shaft);
        joint tongue = prismatic(first.groove, middle.tongue);
        joint cross = prismatic(middle.cross, second.groove);
    }
}

mechanism_part! {
    /// A toggle: two bars with a knee press a ram along the y axis of `frame`, below its origin. Motor: joint `swing`.
    pub Toggle(upper = 1, lower = 1) {
        port frame { point top = (0, 0); line guide = (0, 0) -> (0, -1); }
        link thigh { point top = (0, 0); point knee = (upper, 0); }
        link shin { point knee = (0, 0); point ram = (lower, 0); }
        link ram { point pin = (0, 0); line axis = (0, 0) -> (0, -1); }
        joint swing = revolute(frame.top, thigh.top);
        joint knee = revolute(thigh.knee, shin.knee);
        joint foot = revolute(shin.ram, ram.pin);
        joint guide = prismatic(frame.guide, ram.axis);
        start { swing = -60 deg; shin near -120 deg; }
    }
}

mechanism_part! {
    /// A cylinder of an engine: rod and piston on a crank whose shaft is at the origin of both ports. `angle` is that of the bore;
    /// `phase` that of the pin on the crank.
    pub EngineBank(throw = 0.5, rod = 1.8, angle = 90 deg, phase = 0 deg) {
        port frame { line bore = (0, 0) -> angle; }
        port crank { point pin = (throw, 0) turned phase; }
        link connecting_rod { point big_end = (0, 0); point small_end = (rod, 0); }
        link piston { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }
        joint big_end = revolute(crank.pin, connecting_rod.big_end);
        joint small_end = revolute(connecting_rod.small_end, piston.pin);
        joint bore = prismatic(frame.bore, piston.axis);
        start { connecting_rod near angle; }
    }
}
