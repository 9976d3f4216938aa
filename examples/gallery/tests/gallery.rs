//! The exhibits against numbers that were computed elsewhere.

use mech_gallery::four_bar::CrankRocker;
use mech_gallery::geared_piston::GearedPiston;
use mech_gallery::{Exhibited, Visitor, rocker_arm::RockerArm, visit_f64, watt::Watt};
use mech_gallery::{FRAMES, exhibits};
use mech_runtime::Point2;

fn near(found: Point2<f64>, [x, y]: [f64; 2], tolerance: f64) {
    let error = (found - Point2::new(x, y)).norm();
    assert!(error < tolerance, "{found} is {error:e} off");
}

#[test]
fn every_exhibit_goes_through_its_motion() {
    for exhibit in exhibits() {
        let film = exhibit.film().expect("it moves");
        assert!(film.scenes().len() >= FRAMES);
        assert!((0.0..1.0).contains(&exhibit.still()));
    }
}

#[test]
fn every_exhibit_has_its_graphs() {
    for exhibit in exhibits() {
        let graphs = exhibit.graphs().expect("its source declares it");
        assert!(graphs.links.edges.len() >= graphs.links.vertices.len() - 1);
        let mut lines = exhibit.report().lines();
        let has_loops = lines.any(|line| line.starts_with("  loop "));
        assert_eq!(!graphs.loops.vertices.is_empty(), has_loops);
    }
}

#[test]
fn the_studio_opens_every_exhibit() {
    for exhibit in exhibits() {
        assert!(exhibit.file().is_some(), "{}", exhibit.slug());
    }
}

/// Nothing that is declared is left out, and nothing hangs in another order than it is visited.
#[test]
fn every_mechanism_hangs() {
    struct Slugs(Vec<&'static str>);
    impl Visitor for Slugs {
        fn visit<M: Exhibited>(&mut self) {
            self.0.push(M::SLUG);
        }
    }
    let mut visited = Slugs(Vec::new());
    visit_f64(&mut visited);
    let exhibits = exhibits();
    let hanging: Vec<_> = exhibits.iter().map(|exhibit| exhibit.slug()).collect();
    assert_eq!(hanging, visited.0);
}

#[test]
fn geared_piston() {
    let mut m = GearedPiston::new();
    for degrees in (0..=720).step_by(7) {
        let d = f64::from(degrees).to_radians();
        m.move_to([d]).expect("it turns");
        let (sin, cos) = (-d / 2.0).sin_cos();
        near(m.rod_big_end(), [cos, sin], 1e-12);
        near(m.rod_small_end(), [cos + (16.0 - sin * sin).sqrt(), 0.0], 1e-12);
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
        m.move_to([f64::from(degrees).to_radians()]).expect("it turns");
        rocker = (rocker.0.min(m.g()), rocker.1.max(m.g()));
    }
    assert_eq!((rocker.1 - rocker.0).to_degrees().round(), 138.0);
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
