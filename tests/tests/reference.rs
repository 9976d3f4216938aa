//! Positions held against numbers that nobody of this project made.
//!
//! Four-bars and slider-cranks: the rows are those of the `PMKS_Verification` collection: three independent programs, one row a degree.

#![allow(
    clippy::approx_constant,
    clippy::unreadable_literal,
    clippy::excessive_precision,
    reason = "the digits stand as their sources print them"
)]

use mech_gallery::andrews::AndrewsSqueezer;
use mech_gallery::jansen::JansenLeg;
use mech_runtime::{Isometry2, Point2, mechanism};
use mech_test_support::four_bar;
use std::f64::consts::{PI, TAU};

mechanism! {
    /// The four-bar of the collection, as it is drawn there.
    struct TeachingFourBar;

    link crank;
    link coupler { point c = (4.23, 3.029); }
    link rocker { point c = (4.23, 3.029); }

    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (1.52, 0);
    joint c = revolute(coupler, rocker) at (4.23, 3.029);
    joint d = revolute(ground, rocker) at (4.572, 0);

    motor a;
}

mechanism! {
    /// The slider-crank of the collection.
    struct TeachingSliderCrank;

    link crank;
    link rod { point c = (-0.97, 10.01); }
    link block;

    joint a = revolute(ground, crank) at (13.79, 10.01);
    joint b = revolute(crank, rod) at (13.79, 13.82);
    joint c = revolute(rod, block) at (-0.97, 10.01);
    joint guide = prismatic(ground, block) at (-0.97, 10.01) along (1, 0);

    motor a;
}

mechanism! {
    /// The slider-crank with a tracer point.
    struct SliderCrankTracer;

    link crank;
    link rod { point c = (12, 0); point d = (20, 2); }
    link block;

    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (4, 2);
    joint c = revolute(rod, block) at (12, 0);
    joint guide = prismatic(ground, block) at (12, 0) along (1, 0);

    motor a;
}

four_bar!(struct Plain: f64; motor a;);

mechanism! {
    /// An offset slider-crank: crank 1, rod 3, offset 0.5.
    struct Offset;

    ground { point shaft = (0, 0); line guide = (0, 0.5) -> (1, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link rod { point big = (0, 0); point small = (3, 0); }
    link block { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }

    joint a = revolute(ground.shaft, crank.shaft);
    joint b = revolute(crank.pin, rod.big);
    joint c = revolute(rod.small, block.pin);
    joint x = prismatic(ground.guide, block.axis);

    motor a;
    start { rod near 0 deg; }
}

const TOLERANCE: f64 = 1e-12;

#[track_caller]
fn assert_point(found: Point2<f64>, x: f64, y: f64) {
    assert!(
        (found.x - x).abs() < TOLERANCE,
        "x: {} instead of {x}",
        found.x
    );
    assert!(
        (found.y - y).abs() < TOLERANCE,
        "y: {} instead of {y}",
        found.y
    );
}

#[track_caller]
fn assert_turned(link: Isometry2<f64>, angle: f64) {
    let found = link.rotation.angle();
    assert!(
        (found - angle).abs() < TOLERANCE,
        "{found} instead of {angle}"
    );
}

/// Each row: the motor's angle from the start, point C, the turns of two links.
type Row = (f64, [f64; 2], [f64; 2]);

#[test]
fn teaching_four_bar() {
    const ROWS: [Row; 4] = [
        (0.0, [4.2300000000000004, 3.0289999999999999], [0.0, 0.0]),
        (
            1.5707963267948983,
            [3.8044641052693042, 2.9500328219021474],
            [-0.48138116669905362, 0.14210310775773349],
        ),
        (
            3.1415926535897825,
            [2.1191661195009908, 1.8098096459783182],
            [-0.37942881370556009, 0.82268793702630227],
        ),
        (
            4.7123889803846613,
            [2.1909466783477205, 1.9032577543382425],
            [0.16054472582765755, 0.78402900028445965],
        ),
    ];
    let mut mechanism = TeachingFourBar::new();
    for (angle, [x, y], [coupler, rocker]) in ROWS {
        mechanism.move_to([angle]).unwrap();
        assert_point(mechanism.coupler_c(), x, y);
        assert_point(mechanism.rocker_c(), x, y);
        assert_turned(mechanism.coupler(), coupler);
        assert_turned(mechanism.rocker(), rocker);
    }
}

#[test]
fn teaching_slider_crank() {
    // The collection gives the crank's absolute angle, which is a quarter turn at the start.
    const ROWS: [(f64, f64, f64); 4] = [
        (1.5707963267948966, -0.96999999999999997, 0.0),
        (
            2.3561944901923413,
            -3.9079313410805039,
            -0.074950018490655967,
        ),
        (
            3.9269908169872201,
            -3.9079313410805856,
            -0.43028147380786619,
        ),
        (5.4977871437820989, 1.4802223315608867, -0.43028147380787685),
    ];
    let mut mechanism = TeachingSliderCrank::new();
    for (angle, x, rod) in ROWS {
        mechanism.move_to([angle - ROWS[0].0]).unwrap();
        assert_point(mechanism.rod_c(), x, 10.01);
        assert_turned(mechanism.rod(), rod);
        assert!((mechanism.guide() - (x - ROWS[0].1)).abs() < TOLERANCE);
    }
}

#[test]
fn slider_crank_tracer() {
    const ROWS: [(f64, f64, f64); 4] = [
        (0.46364760900080609, 12.0, 0.0),
        (2.0344439357957045, 5.2111025509279738, -0.26146598028663581),
        (3.6052402625905833, 3.999999999999984, 0.48995732625372024),
        (5.1760365893854621, 9.2111025509278051, 0.75142330654037404),
    ];
    let mut mechanism = SliderCrankTracer::new();
    for (angle, x, rod) in ROWS {
        mechanism.move_to([angle - ROWS[0].0]).unwrap();
        assert_point(mechanism.rod_c(), x, 0.0);
        assert_turned(mechanism.rod(), rod);
        // The tracer is (8, 2) from C at the start, and turns with the rod.
        let (sin, cos) = rod.sin_cos();
        assert_point(
            mechanism.rod_d(),
            x + 8.0 * cos - 2.0 * sin,
            8.0 * sin + 2.0 * cos,
        );
    }
}

#[test]
fn plain_four_bar_of_the_hard_cases() {
    const ROWS: [(f64, [f64; 2]); 9] = [
        (0.0, [3.0416666666666667, 2.8428150172359478]),
        (30.0, [3.3799283376819533, 2.9352190946486660]),
        (45.0, [3.4024212024777522, 2.9398808786670021]),
        (90.0, [2.9872189505317297, 2.8238758021269188]),
        (135.0, [2.3110132659266012, 2.4793797232622666]),
        (180.0, [1.825, 2.0662465970933866]),
        (225.0, [1.6570882969224770, 1.8737034855020100]),
        (270.0, [1.7774869318212115, 2.0150522727151541]),
        (315.0, [2.2481542774747260, 2.4353719560818427]),
    ];
    let mut mechanism = Plain::new();
    for (degrees, [x, y]) in ROWS {
        mechanism.move_to([f64::to_radians(degrees)]).unwrap();
        assert_point(mechanism.coupler_c(), x, y);
        assert_point(mechanism.rocker_c(), x, y);
    }
    // In one leap to anywhere, and many turns on: the same positions.
    for (degrees, [x, y]) in ROWS.into_iter().rev() {
        let mut fresh = Plain::new();
        fresh.move_to([f64::to_radians(degrees - 3600.0)]).unwrap();
        assert_point(fresh.coupler_c(), x, y);
    }
}

#[test]
fn offset_slider_crank_of_the_hard_cases() {
    const ROWS: [(f64, f64); 4] = [
        (0.0, 3.95803989154980802),
        (90.0, 2.95803989154980802),
        (180.0, 1.95803989154980802),
        (270.0, 2.59807621135331594),
    ];
    let mut mechanism = Offset::new();
    for (degrees, x) in ROWS {
        mechanism.move_to([f64::to_radians(degrees)]).unwrap();
        assert!((mechanism.x() - x).abs() < TOLERANCE);
        assert_point(mechanism.rod_small(), x, 0.5);
    }
}

/// Andrews' squeezer (Hairer & Wanner; test set of Mazzia and Magherini): beta, Theta, gamma, Phi, delta, Omega, epsilon.
/// One turn in twelve steps, then two and a half turns to the state at t = 0.03 s.
const ANDREWS: [[f64; 7]; 14] = [
    [
        -0.061713890014276,
        0.000000000000000,
        0.455279819163070,
        0.222668390165886,
        0.487364979543843,
        -0.222668390165886,
        1.230547444549821,
    ],
    [
        0.461884885584022,
        -0.384913399068923,
        0.433426505931541,
        0.178923929152767,
        0.492120508749196,
        -0.178923929152766,
        1.214195448926015,
    ],
    [
        0.985483661182321,
        -0.781193036323181,
        0.374384056301545,
        0.064139949470523,
        0.503238402482178,
        -0.064139949470523,
        1.173349996257509,
    ],
    [
        1.509082436780620,
        -1.225739216407346,
        0.286717705959561,
        -0.099263953701614,
        0.515554622309058,
        0.099263953701613,
        1.121845892975159,
    ],
    [
        2.032681212378919,
        -1.744807848607768,
        0.183390555041016,
        -0.284733047141633,
        0.524082696396319,
        0.284733047141633,
        1.076524628842305,
    ],
    [
        2.556279987977218,
        -2.340542989413422,
        0.090532053492615,
        -0.447850470116421,
        0.525976972505298,
        0.447850470116421,
        1.052748273008495,
    ],
    [
        3.079878763575516,
        -2.984378162651492,
        0.042610435278267,
        -0.531603238361022,
        0.524501545581851,
        0.531603238361022,
        1.048137484379987,
    ],
    [
        3.603477539173815,
        -3.636069482143850,
        0.059989436397123,
        -0.501226352268807,
        0.525250429066937,
        0.501226352268807,
        1.049134486442777,
    ],
    [
        4.127076314772114,
        -4.266425800642793,
        0.136255391485086,
        -0.367779188963360,
        0.525773604760335,
        0.367779188963360,
        1.062211402987371,
    ],
    [
        4.650675090370413,
        -4.858207590948902,
        0.245872456186934,
        -0.173295625884311,
        0.519695515485253,
        0.173295625884311,
        1.101807181388506,
    ],
    [
        5.174273865968712,
        -5.396691291459007,
        0.354802366156187,
        0.027003544048380,
        0.506406870814837,
        -0.027003544048380,
        1.160881912611673,
    ],
    [
        5.697872641567010,
        -5.869657962215951,
        0.430201978598874,
        0.172532222831708,
        0.492791558647229,
        -0.172532222831708,
        1.211839267703009,
    ],
    [
        6.221471417165310,
        -6.283185307179586,
        0.455279819163070,
        0.222668390165886,
        0.487364979543843,
        -0.222668390165886,
        1.230547444549821,
    ],
    [
        15.81077119629904,
        -15.75637105984298,
        0.04082224013073101,
        -0.5347301163226948,
        0.5244099658805304,
        0.5347301163226948,
        1.048080741042263,
    ],
];

#[test]
fn andrews_squeezer_by_continuation_from_its_start() {
    let mut mechanism = AndrewsSqueezer::new();
    let mut worst: f64 = 0.0;
    for row in ANDREWS {
        let from = mechanism.beta();
        // A degree a step, as a film would.
        let steps = ((row[0] - from).abs().to_degrees()).ceil().max(1.0);
        let mut done = 0.0;
        while done < steps {
            done += 1.0;
            mechanism
                .move_to([from + (row[0] - from) * (done / steps)])
                .unwrap();
        }
        let found = [
            mechanism.beta(),
            mechanism.theta(),
            mechanism.gamma(),
            mechanism.phi(),
            mechanism.delta(),
            mechanism.omega(),
            mechanism.epsilon(),
        ];
        for (found, expected) in found.into_iter().zip(row) {
            worst = worst.max(((found - expected + PI).rem_euclid(TAU) - PI).abs());
        }
    }
    println!("Andrews: worst of 14 rows {worst:.1e} rad");
    assert!(worst < TOLERANCE, "{worst:e}");
}

#[test]
fn jansens_foot() {
    let mut mechanism = JansenLeg::new();
    let drawn = f64::atan2(11.52, 9.61);
    let mut worst: f64 = 0.0;
    for (degrees, x, y) in [
        (0.0, -43.170055155, -91.753225905),
        (45.0, -24.406393593, -91.789596143),
    ] {
        mechanism
            .move_to([f64::to_radians(degrees) - drawn])
            .unwrap();
        worst = worst.max((mechanism.lower_plate_foot() - Point2::new(x, y)).norm());
    }
    println!("Jansen: foot at most {worst:.1e} off");
    assert!(worst < 1e-6, "{worst:e}");
}
