//! The exhibits against numbers that were computed elsewhere.

use mech_examples::FRAMES;
use mech_examples::gallery::andrews::AndrewsSqueezer;
use mech_examples::gallery::four_bar::CrankRocker;
use mech_examples::gallery::geared_piston::GearedPiston;
use mech_examples::gallery::jansen::JansenLeg;
use mech_examples::gallery::{self, rocker_arm::RockerArm, watt::Watt};
use mech_runtime::Point2;
use std::f64::consts::{PI, TAU};

fn near(found: Point2<f64>, [x, y]: [f64; 2], tolerance: f64) {
    let error = (found - Point2::new(x, y)).norm();
    assert!(error < tolerance, "{found} is {error:e} off");
}

#[test]
fn every_exhibit_goes_through_its_motion() {
    for exhibit in gallery::exhibits() {
        let film = exhibit.film().expect(exhibit.slug());
        assert!(film.scenes().len() >= FRAMES);
        assert!((0.0..1.0).contains(&exhibit.still()));
    }
}

#[test]
fn slugs_are_unique() {
    let exhibits = gallery::exhibits();
    for (n, exhibit) in exhibits.iter().enumerate() {
        assert!(
            exhibits[..n]
                .iter()
                .all(|other| other.slug() != exhibit.slug())
        );
    }
}

#[test]
fn geared_piston() {
    let mut m = GearedPiston::new();
    for degrees in (0..=720).step_by(7) {
        let d = f64::from(degrees).to_radians();
        m.move_to([d]).expect("it turns");
        let (sin, cos) = (-d / 2.0).sin_cos();
        near(m.rod_big_end(), [cos, sin], 1e-12);
        near(
            m.rod_small_end(),
            [cos + (16.0 - sin * sin).sqrt(), 0.0],
            1e-12,
        );
    }
}

/// HARD.md, case 1.
#[test]
fn four_bar() {
    let mut m = CrankRocker::new();
    for (degrees, place) in [
        (0.0, [3.041_666_666_666_666_7, 2.842_815_017_235_947_8]),
        (90.0, [2.987_218_950_531_729_7, 2.823_875_802_126_919]),
        (180.0, [1.825, 2.066_246_597_093_386_6]),
        (270.0, [1.777_486_931_821_211_5, 2.015_052_272_715_154_1]),
        (360.0, [3.041_666_666_666_666_7, 2.842_815_017_235_947_8]),
    ] {
        m.move_to([f64::to_radians(degrees)]).expect("it turns");
        near(m.coupler_rocker_pin(), place, 1e-13);
    }
}

#[test]
fn watt() {
    let mut m = Watt::new();
    let mut rocker = (f64::MAX, f64::MIN);
    for degrees in 0..360 {
        m.move_to([f64::from(degrees).to_radians()])
            .expect("it turns");
        rocker = (rocker.0.min(m.g()), rocker.1.max(m.g()));
    }
    assert_eq!((rocker.1 - rocker.0).to_degrees().round(), 138.0);
}

/// CASES.md, every second row: beta, Theta, gamma, Phi, delta, Omega, epsilon.
const ANDREWS: [[f64; 7]; 7] = [
    [
        -0.061_713_890_014_276,
        0.0,
        0.455_279_819_163_070,
        0.222_668_390_165_886,
        0.487_364_979_543_843,
        -0.222_668_390_165_886,
        1.230_547_444_549_821,
    ],
    [
        0.985_483_661_182_321,
        -0.781_193_036_323_181,
        0.374_384_056_301_545,
        0.064_139_949_470_523,
        0.503_238_402_482_178,
        -0.064_139_949_470_523,
        1.173_349_996_257_509,
    ],
    [
        2.032_681_212_378_919,
        -1.744_807_848_607_768,
        0.183_390_555_041_016,
        -0.284_733_047_141_633,
        0.524_082_696_396_319,
        0.284_733_047_141_633,
        1.076_524_628_842_305,
    ],
    [
        3.079_878_763_575_516,
        -2.984_378_162_651_492,
        0.042_610_435_278_267,
        -0.531_603_238_361_022,
        0.524_501_545_581_851,
        0.531_603_238_361_022,
        1.048_137_484_379_987,
    ],
    [
        4.127_076_314_772_114,
        -4.266_425_800_642_793,
        0.136_255_391_485_086,
        -0.367_779_188_963_360,
        0.525_773_604_760_335,
        0.367_779_188_963_360,
        1.062_211_402_987_371,
    ],
    [
        5.174_273_865_968_712,
        -5.396_691_291_459_007,
        0.354_802_366_156_187,
        0.027_003_544_048_380,
        0.506_406_870_814_837,
        -0.027_003_544_048_380,
        1.160_881_912_611_673,
    ],
    [
        6.221_471_417_165_31,
        -TAU, // there: -6.283185307179586
        0.455_279_819_163_070,
        0.222_668_390_165_886,
        0.487_364_979_543_843,
        -0.222_668_390_165_886,
        1.230_547_444_549_821,
    ],
];

#[test]
fn andrews() {
    let mut m = AndrewsSqueezer::new();
    for row in ANDREWS {
        m.move_to([row[0]]).expect("it turns");
        let found = [
            m.beta(),
            m.theta(),
            m.gamma(),
            m.phi(),
            m.delta(),
            m.omega(),
            m.epsilon(),
        ];
        for (found, expected) in found.into_iter().zip(row) {
            let off = (found - expected + PI).rem_euclid(TAU) - PI;
            assert!(off.abs() < 1e-12, "{off:e}: {found} for {expected}");
        }
    }
}

#[test]
fn jansen() {
    let mut m = JansenLeg::new();
    let start = f64::atan2(11.52, 9.61);
    for (angle, place) in [
        (0.0, [-43.170_055_155, -91.753_225_905]),
        (PI / 4.0, [-24.406_393_593, -91.789_596_143]),
    ] {
        m.move_to([angle - start]).expect("it turns");
        near(m.lower_plate_foot(), place, 1e-8);
    }
}

#[test]
fn rocker_arm() {
    let mut m = RockerArm::new();
    m.move_to([1.0, 0.5, -0.25]).expect("it turns");
    let turned = m.hand().rotation.angle() - m.rocker().rotation.angle();
    assert!((turned - 0.25).abs() < 1e-12);
    let shoulder = m.rocker_shoulder();
    near(m.upper_arm_shoulder(), [shoulder.x, shoulder.y], 1e-12);
}
