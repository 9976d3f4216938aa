//! Velocities and accelerations of generated code, against numbers nobody here made: the tables of `PMKS_Verification` and the
//! literature on Andrews' squeezer.
#![allow(
    clippy::approx_constant,
    clippy::excessive_precision,
    reason = "numbers are as they were published"
)]

use mech_runtime::{Cause, Velocity, mechanism};

mechanism! {
    /// The four-bar of the tables.
    struct FourBar;
    link crank { point pin = (1.52, 0); }
    link coupler { point end = (4.23, 3.029); point f = (2.548, 1.958); }
    link rocker { point e = (4.79, 1.632); }
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (1.52, 0);
    joint c = revolute(coupler, rocker) at (4.23, 3.029);
    joint d = revolute(ground, rocker) at (4.572, 0);
    motor a;
    effects { velocity; acceleration; }
}

mechanism! {
    /// The slider-crank of the tables.
    struct SliderCrank;
    link crank;
    link rod { point end = (-0.97, 10.01); }
    link block;
    joint a = revolute(ground, crank) at (13.79, 10.01);
    joint b = revolute(crank, rod) at (13.79, 13.82);
    joint c = revolute(rod, block) at (-0.97, 10.01);
    joint x = prismatic(ground, block) at (-0.97, 10.01) along (1, 0);
    motor a;
    effects { velocity; acceleration; }
}

mechanism! {
    /// The slider-crank with a tracer point of the tables.
    struct Tracer;
    link crank;
    link rod { point end = (12, 0); point tracer = (20, 2); }
    link block;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (4, 2);
    joint c = revolute(rod, block) at (12, 0);
    joint x = prismatic(ground, block) at (12, 0) along (1, 0);
    motor a;
    effects { acceleration; }
}

mechanism! {
    /// Andrews' squeezer, drawn as it starts.
    struct Andrews;
    const RR = 0.007; const D = 0.028; const SS = 0.035; const E = 0.02; const ZT = 0.04; const ZF = 0.02; const U = 0.04;
    ground { point o = (0, 0); point a = (-0.06934, -0.00227); point b = (-0.03635, 0.03273); }
    link k1 { point o = (0, 0); point tip = (RR, 0); }
    link k2 { point tip = (0, 0); point e = (-D, 0); }
    link k3 { point b = (0, 0); point e = (0, -SS); }
    link k4 { point e = (0, -E); point knee = (0, 0); }
    link k5 { point a = (0, 0); point knee = (ZT, 0); }
    link k6 { point e = (ZF, 0); point knee = (0, 0); }
    link k7 { point a = (0, 0); point knee = (0, -U); }
    joint beta = revolute(ground.o, k1.o);
    joint theta = revolute(k1.tip, k2.tip);
    joint gamma = revolute(ground.b, k3.b);
    joint e3 = revolute(k2.e, k3.e);
    joint delta = revolute(ground.a, k5.a);
    joint phi = revolute(k5.knee, k4.knee);
    joint e4 = revolute(k2.e, k4.e);
    joint epsilon = revolute(ground.a, k7.a);
    joint omega = revolute(k7.knee, k6.knee);
    joint e6 = revolute(k2.e, k6.e);
    motor beta;
    start {
        beta = -0.0617138900142764964;
        k2 near -0.06; k5 near 0.49; k7 near 1.23;
    }
    effects { velocity; acceleration; }
}

#[track_caller]
fn near(found: f64, expected: f64, scale: f64, tolerance: f64) {
    let off = (found - expected).abs();
    assert!(
        off <= tolerance * scale,
        "{found:?} instead of {expected:?}: off by {:e} of {scale}",
        off / scale
    );
}

/// A row of the tables: the input's turn in degrees, then the point's velocity and acceleration, then angular rates.
struct Row {
    degrees: f64,
    velocity: [f64; 2],
    acceleration: [f64; 2],
    coupler: [f64; 2],
}

#[test]
fn a_four_bar_has_the_rates_that_three_programs_agree_on() {
    const RATE: f64 = 1.079_660_675_283_692_1;
    let rows = [
        (
            0.0,
            [1.628_716_946_874_227_3, 0.183_896_069_934_296_86],
            [-2.257_927_844_372_618_5, -1.141_877_840_986_470_5],
            [-0.537_707_806_825_429_96, -0.098_193_366_621_151_19],
            [-0.537_707_806_825_429_96, 0.778_081_940_185_145_43],
        ),
        (
            90.0,
            [-1.494_888_964_608_885, -0.388_938_363_822_781_41],
            [-0.371_073_223_097_513_12, -0.905_338_430_757_266_3],
            [-0.102_232_102_356_830_32, 0.231_680_861_727_352_92],
            [0.506_736_383_917_585_6, 0.192_595_295_526_761_97],
        ),
        (
            180.0,
            [-0.487_532_840_259_048_36, -0.660_752_953_273_645_92],
            [0.972_336_000_959_646_56, 0.945_235_292_890_207_58],
            [0.269_383_490_878_396_97, 0.295_828_372_754_988_5],
            [0.269_383_490_878_404_3, -0.438_908_072_770_926_64],
        ),
        (
            270.0,
            [0.555_415_522_530_927_85, 0.694_847_543_274_201_95],
            [0.900_141_856_585_776_2, 0.710_353_730_826_856_04],
            [0.317_144_889_988_033_4, -0.327_322_476_034_966_45],
            [-0.291_823_596_286_381_3, -0.366_408_042_235_543_3],
        ),
    ];
    let mut four_bar = FourBar::new();
    for (degrees, v, a, coupler, rocker) in rows {
        let turn = f64::to_radians(degrees);
        four_bar.move_with([turn], [RATE], [0.0]).expect("it turns");
        let (velocity, acceleration) = (
            four_bar.coupler_end_velocity(),
            four_bar.coupler_end_acceleration(),
        );
        for part in 0..2 {
            near(velocity[part], v[part], 1.0, 1e-10);
            near(acceleration[part], a[part], 1.0, 1e-10);
        }
        near(four_bar.coupler_velocity().angular, coupler[0], 1.0, 1e-10);
        near(
            four_bar.coupler_acceleration().angular,
            coupler[1],
            1.0,
            1e-10,
        );
        near(four_bar.rocker_velocity().angular, rocker[0], 1.0, 1e-10);
        near(
            four_bar.rocker_acceleration().angular,
            rocker[1],
            1.0,
            1e-10,
        );
        near(four_bar.d_rate(), rocker[0], 1.0, 1e-10);
        near(four_bar.c_rate(), rocker[0] - coupler[0], 1.0, 1e-10);
        near(four_bar.a_rate(), RATE, 1.0, 1e-15);
        let [influence] = four_bar.influence_coefficients().expect("it is regular");
        near(influence[1].angular * RATE, coupler[0], 1.0, 1e-10);
    }
}

#[test]
fn slider_cranks_have_the_rates_that_three_programs_agree_on() {
    let row = |degrees, x, a, coupler| Row {
        degrees,
        velocity: [x, 0.0],
        acceleration: [a, 0.0],
        coupler,
    };
    let rows = [
        row(
            0.0,
            -6.024_632_231_789_146_5,
            -2.459_091_702_460_208_6,
            [0.0, -0.645_430_893_034_175_45],
        ),
        row(
            45.0,
            -5.024_990_036_490_456_7,
            6.775_293_179_770_29,
            [-0.283_930_926_143_124_65, -0.434_495_508_278_979_7],
        ),
        row(
            135.0,
            5.024_990_036_490_348_4,
            6.775_293_179_770_583,
            [-0.283_930_926_143_131_53, 0.434_495_508_278_967_66],
        ),
        row(
            225.0,
            3.495_126_574_016_025_3,
            -6.697_297_148_381_385,
            [0.283_930_926_143_114_83, 0.434_495_508_278_996_7],
        ),
    ];
    let mut slider = SliderCrank::new();
    for Row {
        degrees,
        velocity,
        acceleration,
        coupler,
    } in rows
    {
        slider
            .move_with([degrees.to_radians()], [1.581_268_302_306_862_5], [0.0])
            .expect("it turns");
        let (v, a) = (slider.rod_end_velocity(), slider.rod_end_acceleration());
        for part in 0..2 {
            near(v[part], velocity[part], 1.0, 1e-10);
            near(a[part], acceleration[part], 1.0, 1e-10);
        }
        near(slider.x_rate(), velocity[0], 1.0, 1e-10);
        near(slider.x_acceleration(), acceleration[0], 1.0, 1e-10);
        near(slider.rod_velocity().angular, coupler[0], 1.0, 1e-10);
        near(slider.rod_acceleration().angular, coupler[1], 1.0, 1e-10);
    }
    let rows = [
        row(
            0.0,
            -3.141_592_653_589_793,
            -6.168_502_750_680_848,
            [-0.523_598_775_598_298_9, 0.205_616_758_356_028],
        ),
        row(
            90.0,
            -3.027_028_830_515_726_5,
            3.830_967_665_440_699,
            [0.290_440_343_567_666_07, 0.561_504_769_020_476_5],
        ),
        row(
            180.0,
            1.047_197_551_196_564,
            2.604_478_939_176_362,
            [0.523_598_775_598_299, -0.205_616_758_356_021_67],
        ),
        row(
            270.0,
            5.350_551_579_056_977,
            -0.555_523_179_487_612_3,
            [-0.290_440_343_567_646_4, -0.561_504_769_020_493],
        ),
    ];
    let mut tracer = Tracer::new();
    for Row {
        degrees,
        velocity,
        acceleration,
        coupler,
    } in rows
    {
        tracer
            .move_with([degrees.to_radians()], [1.047_197_551_196_597_6], [0.0])
            .expect("it turns");
        near(tracer.rod_end_velocity()[0], velocity[0], 1.0, 1e-10);
        near(
            tracer.rod_end_acceleration()[0],
            acceleration[0],
            1.0,
            1e-10,
        );
        near(tracer.rod_velocity().angular, coupler[0], 1.0, 1e-10);
        near(tracer.rod_acceleration().angular, coupler[1], 1.0, 1e-10);
    }
}

#[test]
fn andrews_squeezer_has_the_rates_of_the_literature() {
    let positions = [
        15.810_771_196_299_04,
        -15.756_371_059_842_98,
        0.040_822_240_130_731_01,
        -0.534_730_116_322_694_8,
        0.524_409_965_880_530_4,
        0.534_730_116_322_694_8,
        1.048_080_741_042_263,
    ];
    let rates = [
        1_139.920_302_151_208,
        -1_424.379_294_994_111,
        11.032_912_219_371_34,
        19.293_374_644_213_85,
        0.573_569_928_479_080_8,
        -19.293_374_644_213_85,
        0.323_179_165_802_695_5,
    ];
    let seconds = [
        -24_631.763_169_459_52,
        51_850.377_016_103_29,
        324_102.568_641_378_1,
        566_749.364_517_621_3,
        16_743.629_294_793_61,
        -566_749.364_517_622_2,
        9_826.520_791_458_422,
    ];
    let mut andrews = Andrews::new();
    andrews
        .move_with([positions[0]], [rates[0]], [seconds[0]])
        .expect("it turns");
    let angles = [
        andrews.theta(),
        andrews.gamma(),
        andrews.phi(),
        andrews.delta(),
        andrews.omega(),
        andrews.epsilon(),
    ];
    for (found, expected) in angles.into_iter().zip(&positions[1..]) {
        let turns = ((found - expected) / std::f64::consts::TAU).round();
        near(found - turns * std::f64::consts::TAU, *expected, 1.0, 1e-12);
    }
    let found = [
        andrews.theta_rate(),
        andrews.gamma_rate(),
        andrews.phi_rate(),
        andrews.delta_rate(),
        andrews.omega_rate(),
        andrews.epsilon_rate(),
    ];
    for (found, expected) in found.into_iter().zip(&rates[1..]) {
        near(found, *expected, expected.abs(), 1e-7);
    }
    let found = [
        andrews.theta_acceleration(),
        andrews.gamma_acceleration(),
        andrews.phi_acceleration(),
        andrews.delta_acceleration(),
        andrews.omega_acceleration(),
        andrews.epsilon_acceleration(),
    ];
    for (found, expected) in found.into_iter().zip(&seconds[1..]) {
        near(found, *expected, expected.abs(), 1e-5);
    }
}

#[test]
fn after_a_move_without_rates_it_rests() {
    let mut four_bar = FourBar::new();
    four_bar.move_with([0.3], [2.0], [1.0]).expect("it turns");
    assert_ne!(four_bar.velocities()[0], Velocity::ZERO);
    four_bar.move_to([0.3]).expect("it is there");
    assert_eq!(*four_bar.velocities(), [Velocity::ZERO; 3]);
    four_bar.move_with([0.3], [2.0], [1.0]).expect("it turns");
    four_bar
        .turn_to([mech_runtime::Phase::from_turns(0.1).expect("a tenth")])
        .expect("it turns");
    assert_eq!(*four_bar.velocities(), [Velocity::ZERO; 3]);
}

#[test]
fn bad_rates_are_refused_and_leave_it_as_it_was() {
    let mut four_bar = FourBar::new();
    four_bar.move_with([0.3], [2.0], [1.0]).expect("it turns");
    let before = four_bar;
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for refused in [
            four_bar.move_with([bad], [1.0], [0.0]),
            four_bar.move_with([0.4], [bad], [0.0]),
            four_bar.move_with([0.4], [1.0], [bad]),
        ] {
            assert_eq!(
                refused.expect_err("it is not finite").cause,
                Cause::NotFinite
            );
            assert_eq!(four_bar, before);
        }
    }
    let overflown = four_bar.move_with([0.4], [1e308], [0.0]);
    assert_eq!(
        overflown.expect_err("its square overflows").cause,
        Cause::Overflow
    );
    assert_eq!(four_bar, before);
}

mechanism! {
    /// A crank whose rod lies in line with it at a quarter turn: blocked beyond.
    struct Rocker;
    ground { point a = (0, 0); point d = (5, 0); }
    link crank { point a = (0, 0); point b = (3, 0); }
    link coupler { point b = (0, 0); point c = (3.5, 0); }
    link rocker { point d = (0, 0); point c = (2, 0); }
    joint ja = revolute(ground.a, crank.a);
    joint jb = revolute(crank.b, coupler.b);
    joint jc = revolute(coupler.c, rocker.c);
    joint jd = revolute(ground.d, rocker.d);
    motor ja;
    start { ja = 40 deg; rocker near 120 deg; }
    effects { velocity; }
}

#[test]
fn at_a_dead_point_rates_are_an_error_and_not_a_large_number() {
    let mut rocker = Rocker::new();
    let _ = rocker.move_toward([3.0]).expect("finite");
    let limit = rocker.motors();
    let before = rocker;
    let singular = rocker
        .move_with(limit, [1.0])
        .expect_err("it is at its dead point");
    assert_eq!(singular.cause, Cause::Singular);
    assert_eq!(singular.place, "`jb`, `jc`, `jd`");
    assert_eq!(singular.reached, limit);
    assert_eq!(rocker, before);
    assert_eq!(
        rocker
            .influence_coefficients()
            .expect_err("there too")
            .cause,
        Cause::Singular
    );
    // A thousandth before it they are determined, and large.
    rocker
        .move_with([limit[0] - 1e-3], [1.0])
        .expect("before the dead point");
    assert!(rocker.rocker_velocity().angular.abs() > 10.0);
}

#[test]
fn a_slots_coordinate_has_the_rates_of_its_differences() {
    mechanism! {
        struct Slotted;
        ground { point a = (0, 0); point d = (3, 0.5); }
        link crank { point a = (0, 0); point b = (1, 0); }
        link arm { point d = (0, 0); line way = (0.2, 0.1) -> (1, 0.3); }
        joint ja = revolute(ground.a, crank.a);
        joint jd = revolute(ground.d, arm.d);
        joint s = slot(crank.b, arm.way);
        motor ja;
        start { ja = 30 deg; arm near 160 deg; }
        effects { velocity; acceleration; }
    }
    let mut slotted = Slotted::new();
    let at = |time: f64| 0.7 + 1.3 * time + 0.5 * 0.4 * time * time;
    let mut slide = |time: f64| {
        slotted.move_to([at(time)]).expect("it turns");
        slotted.s()
    };
    let step = 1e-3;
    let [a, b, c, d, e] = [-2.0, -1.0, 0.0, 1.0, 2.0].map(|index| slide(index * step));
    slotted.move_with([0.7], [1.3], [0.4]).expect("it turns");
    near(
        slotted.s_rate(),
        (a - 8.0 * b + 8.0 * d - e) / (12.0 * step),
        1.0,
        1e-10,
    );
    near(
        slotted.s_acceleration(),
        (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / (12.0 * step * step),
        1.0,
        1e-7,
    );
}
