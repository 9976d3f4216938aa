//! Long links beside short ones, and a mechanism far from the origin.

use crate::bed::Bed;
use crate::geometry::four_bar;
use mech_runtime::Mechanism;

macro_rules! ratios {
    ($($name:ident $long:literal $methods:tt;)*) => { $(
        variants! {
            $name by $methods four_bar [$long, 1, $long, 1.2] {
                motor ja;
                start { ja = 60 deg; rocker near 65 deg; }
            } {
                it_is_as_good_as_its_long_links: |bed| turns(bed, [$long, 1.0, $long, 1.2]);
            }
        }
    )* };
}

ratios! {
    links_of_ratio_1e2 1e2 [exact newton];
    links_of_ratio_1e3 1e3 [exact newton];
    links_of_ratio_1e4 1e4 [exact newton];
    links_of_ratio_1e5 1e5 [exact_f64 newton_f64];
    links_of_ratio_1e6 1e6 [exact_f64 newton_f64];
    links_of_ratio_1e7 1e7 [exact_f64 newton_f64];
    links_of_ratio_1e8 1e8 [exact_f64 newton_f64];
}

variants! {
    crank_of_a_millionth by [exact newton newton_4] four_bar [4, 1e-6, 3.5, 3] {
        motor ja;
        start { coupler near 50 deg; }
    } {
        its_motion_is_not_lost: |bed| turns(bed, [4.0, 1e-6, 3.5, 3.0]);
    }
}

variants! {
    far_from_the_origin by [exact newton newton_4] {
        ground { point a = (1e6, -1e6); point d = (1e6 + 4, -1e6); }
        link crank { point a = (0, 0); point b = (1, 0); }
        link coupler { point b = (0, 0); point c = (3.5, 0); }
        link rocker { point d = (0, 0); point c = (3, 0); }
        joint ja = revolute(ground.a, crank.a);
        joint jb = revolute(crank.b, coupler.b);
        joint jc = revolute(coupler.c, rocker.c);
        joint jd = revolute(ground.d, rocker.d);
        motor ja;
        start { coupler near 50 deg; }
    } {
        it_is_where_it_is_at_the_origin: far;
        #[ignore = "its links turn otherwise, by 1e-12 to 4e-11 in double precision and 6e-3 in single"]
        its_links_turn_as_they_do_at_the_origin: turned_alike;
    }
}

fn turns<M: Mechanism>(mut bed: Bed<M>, lengths: [f64; 4]) {
    let start = bed.motor();
    for degree in 1..=1080 {
        bed.must(&[start + f64::from(degree).to_radians()]);
        let should = four_bar(lengths, bed.motor(), true);
        bed.assert_at(("rocker", [lengths[3], 0.0]), should.at, should.sine);
    }
    for step in 1..=100 {
        bed.must(&[start + (97.0 * f64::from(step)).to_radians()]);
        let should = four_bar(lengths, bed.motor(), true);
        bed.assert_at(("rocker", [lengths[3], 0.0]), should.at, should.sine);
    }
}

fn far<M: Mechanism>(mut bed: Bed<M>) {
    for degree in 1..=720 {
        bed.must(&[f64::from(degree).to_radians()]);
        let should = four_bar([4.0, 1.0, 3.5, 3.0], bed.motor(), true);
        let [x, y] = should.at;
        bed.assert_at(("rocker", [3.0, 0.0]), [1e6 + x, y - 1e6], should.sine);
    }
}

/// Where a mechanism stands has nothing to do with how its links are turned.
fn turned_alike<M: Mechanism>(mut bed: Bed<M>) {
    for degree in 1..=720 {
        bed.must(&[f64::from(degree).to_radians()]);
        let [x, y] = four_bar([4.0, 1.0, 3.5, 3.0], bed.motor(), true).at;
        let [cos, sin, ..] = bed.pose("rocker");
        let off = (cos - (x - 4.0) / 3.0).hypot(sin - y / 3.0);
        assert!(off <= 64.0 * Bed::<M>::EPSILON, "it is turned by {off:e}");
    }
}
