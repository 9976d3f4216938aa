//! `mech table` and `mech plot`.

use crate::pictures::pixels;
use crate::run::{FOUR_BAR, Folder, numbers};

pub(crate) fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-6
}

#[test]
fn without_a_quantity_all_coordinates() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let table = folder.mech("table a.mech --steps 4").done();
    assert_eq!(table.lines().next(), Some("motor a [deg],a [deg],b [deg],c [deg],d [deg]"));
    let rows = numbers(&table);
    assert_eq!(rows.len(), 5);
    // The angles of a quadrangle add up, and a whole turn leads back; the crank has turned against the coupler.
    for row in &rows {
        assert!(close(row[1] + row[2] + row[3], row[4]), "{row:?}");
        assert!(close(row[0], row[1]), "{row:?}");
    }
    assert!(close(rows[4][2], -360.0) && close(rows[4][4], 0.0), "{rows:?}");
}

/// A crank of length 2, whose pin and coordinate are known.
pub(crate) const CRANK: &str = "struct Crank;
link crank { point pin = (2, 0); mass 3 at (2, 0); }
joint a = revolute(ground, crank) at (0, 0);
motor a;
gravity (0, -10);
";

#[test]
fn rates_and_forces_of_a_crank() {
    let folder = Folder::new().with("a.mech", CRANK);
    let words = "table a.mech crank.pin velocity:crank.pin acceleration:crank.pin.norm torque:a \
        reaction:a velocity:crank --from 30 --to 60 --steps 1 --rate 0.5 --length m --force N";
    let table = folder.mech(words).done();
    assert_eq!(
        table.lines().next(),
        Some(
            "motor a [deg],crank.pin.x [m],crank.pin.y [m],velocity:crank.pin.x [m/s],velocity:crank.pin.y [m/s],\
             acceleration:crank.pin.norm [m/s²],torque:a at rate 0.5 [N·m],reaction:a.x at rate 0.5 [N],\
             reaction:a.y at rate 0.5 [N],velocity:crank [rad/s]"
        )
    );
    for row in numbers(&table) {
        let (sin, cos) = row[0].to_radians().sin_cos();
        // A mass of 3 at distance 2 turns at half a radian per second.
        let expected = [
            2.0 * cos,
            2.0 * sin,
            -sin,
            cos,
            0.5,
            3.0 * 10.0 * 2.0 * cos,
            -3.0 * 0.5 * cos,
            3.0 * (10.0 - 0.5 * sin),
            0.5,
        ];
        for (found, expected) in row[1..].iter().zip(expected) {
            assert!(close(*found, expected), "{row:?}");
        }
    }
}

#[test]
fn a_slide_is_measured_along_its_guide() {
    let text = "struct SliderCrank; link crank; link rod; link block;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (1, 0);
joint c = revolute(rod, block) at (4, 0);
joint x = prismatic(ground, block) at (4, 0) along (1, 0);
motor a;";
    let folder = Folder::new().with("a.mech", text);
    let words = "table a.mech x velocity:x acceleration:x --from 90 --to 90 --steps 1";
    let row = &folder.rows(words)[0];
    // A crank of 1 and a rod of 3, upright.
    let root = 8.0_f64.sqrt();
    assert!(close(row[1], root - 4.0) && close(row[2], -1.0), "{row:?}");
    assert!(close(row[3], 1.0 / root), "{row:?}");
}

#[test]
fn a_slide_on_a_link_that_turns() {
    // The coordinate of the slot changes as if the arm stood still: compared with differences.
    let text = "struct Whitworth;
ground { point o = (0, 0); point q = (0, -1); }
link crank { point o = (0, 0); point pin = (2, 0); }
link arm { point q = (0, 0); line way = (0, 0) -> (1, 0); }
joint a = revolute(ground.o, crank.o);
joint e = revolute(ground.q, arm.q);
joint s = slot(crank.pin, arm.way);
motor a;
start { a = 20 deg; arm near 40 deg; }";
    let folder = Folder::new().with("a.mech", text);
    let words = "table a.mech s velocity:s acceleration:s --from 50 --to 50.002 --steps 2";
    let rows = folder.rows(words);
    let step = 0.001_f64.to_radians();
    let rate = (rows[2][1] - rows[0][1]) / (2.0 * step);
    let second = (rows[2][2] - rows[0][2]) / (2.0 * step);
    assert!((rate - rows[1][2]).abs() < 1e-6, "{rows:?}");
    assert!((second - rows[1][3]).abs() < 1e-6, "{rows:?}");
}

/// A four-bar linkage whose first crank is driven, by its four pins.
fn driven_four_bar([c, a, b, d]: [[f64; 2]; 4], precision: &str) -> String {
    let at = |[x, y]: [f64; 2]| format!("({x}, {y})");
    format!(
        "struct M: {precision}; link one; link two; link three;
joint c = revolute(ground, one) at {}; joint a = revolute(one, two) at {};
joint b = revolute(two, three) at {}; joint d = revolute(ground, three) at {};
motor c;",
        at(c),
        at(a),
        at(b),
        at(d)
    )
}

/// Cranks that cannot turn round stop where coupler and rocker lie in line, by the law of cosines: a motion that nobody bounds ends a hair
/// before that, and what is said to be possible is.
#[test]
fn a_motion_without_ends_stays_within_what_is_possible() {
    let mut seed = 7_u32;
    let mut number = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 22) / 100.0
    };
    let mut limited = 0;
    while limited < 24 {
        let pins = [(); 4].map(|()| [number(), number()]);
        let far = |a: usize, b: usize| (pins[a][0] - pins[b][0]).hypot(pins[a][1] - pins[b][1]);
        let [crank, coupler, rocker, frame] = [far(0, 1), far(1, 2), far(2, 3), far(0, 3)];
        let possible = (coupler - rocker).abs()..=coupler + rocker;
        let [near, most] = [(crank - frame).abs(), crank + frame];
        if far(1, 3) < 0.5 || (possible.contains(&near) && possible.contains(&most)) {
            continue;
        }
        limited += 1;
        let precision = if limited % 3 == 0 { "f32" } else { "f64" };
        let text = driven_four_bar(pins, precision);
        let folder = Folder::new().with("a.mech", &text);
        let rows = folder.rows("table a.mech b velocity:b torque:c");
        let angle = |of: usize| (pins[of][1] - pins[0][1]).atan2(pins[of][0] - pins[0][0]);
        for row in [&rows[0], &rows[360]] {
            let turned = angle(1) - angle(3) + row[0].to_radians();
            let reach = (crank * crank + frame * frame - 2.0 * crank * frame * turned.cos()).sqrt();
            let off = (reach - possible.start()).abs().min((reach - possible.end()).abs());
            let hair = if precision == "f32" { 2e-4 } else { 1e-7 };
            assert!(off < hair * most, "{off:e} before the end: {text}");
            assert!(row[1].is_finite(), "{text}");
        }
        folder.mech("plot a.mech b velocity:b -o a.svg").done();
        folder.mech("film a.mech -o a.gif --seconds 1 --rate 6").done();
        // Beyond: the message says what is possible, and that is true.
        let beyond = rows[360][0] + 0.5;
        let told = folder.mech(&format!("table a.mech --to {beyond}")).refused(1);
        let ends = told.split("it can go from ").nth(1).expect("ends").trim();
        let (from, to) = ends.split_once(" to ").expect("two ends");
        let words =
            format!("table a.mech b --from={from} --to={to} --steps 9").replace(" deg", "deg");
        folder.mech(&words).done();
    }
}

/// A ram between two pins reaches from where boom and base lie on one side to where they lie opposite.
#[test]
fn a_ram_goes_as_far_as_its_triangle() {
    let text = "struct Ram; link boom; link barrel; link rod;
joint o = revolute(ground, boom) at (0, 0);
joint g = revolute(ground, barrel) at (4, 0);
joint h = revolute(boom, rod) at (0, 3);
joint s = prismatic(barrel, rod) at (4, 0) along (-4, 3);
motor s;";
    let folder = Folder::new().with("a.mech", text);
    let rows = folder.rows("table a.mech o");
    // Lengths 4 and 3, drawn with 5 between the pins: from 1 to 7.
    for (row, end) in [(0, -4.0), (360, 2.0)] {
        assert!((rows[row][0] - end).abs() < 1e-7, "{:?}", rows[row]);
    }
    folder.mech("film a.mech -o a.svg").done();
    limits_are_told(text, &["-4", "2"]);
    // One that nothing stops goes half as far as the mechanism is large.
    let free =
        "struct Free; link a; joint x = prismatic(ground, a) at (4, 0) along (1, 0); motor x;";
    let folder = Folder::new().with("a.mech", free);
    let rows = folder.rows("table a.mech --steps 1");
    assert!(close(rows[0][0], -2.0) && close(rows[1][0], 2.0), "{rows:?}");
}

/// A dead point at a round number is told as it is, and a motion comes to it.
fn limits_are_told(text: &str, ends: &[&str]) {
    for precision in ["", ": f32"] {
        let folder = Folder::new().with("a.mech", text.replacen(';', &format!("{precision};"), 1));
        let told = folder.mech("table a.mech --from=-200 --to=200").refused(1);
        let told = told.split("it can go from ").nth(1).expect("ends").trim();
        let told: Vec<&str> = told.split(" to ").collect();
        let words = format!("table a.mech --from={} --to={} --steps 9", told[0], told[1]);
        folder.mech(&words.replace(" deg", "deg")).done();
        // Single precision may not come quite as far.
        if precision.is_empty() {
            assert!(ends.iter().all(|end| told.contains(end)), "{told:?}: {text}");
        }
    }
}

/// Coupler and rocker lie in line where the crank lies along the ground, on either side of it.
#[test]
fn a_dead_point_at_zero_is_told_as_zero() {
    for side in [1, -1] {
        let text = format!(
            "struct M;
ground {{ point o = (0, 0); point d = (3, {}); }}
link crank {{ point o = (0, 0); point p = (3, 0); }}
link coupler {{ point p = (0, 0); point q = (3, 0); }}
link rocker {{ point q = (0, 0); point d = (4, 0); }}
joint a = revolute(ground.o, crank.o); joint b = revolute(crank.p, coupler.p);
joint c = revolute(coupler.q, rocker.q); joint d = revolute(ground.d, rocker.d);
motor a; start {{ a = {} deg; coupler near 0 deg; }}",
            -7 * side,
            -40 * side
        );
        limits_are_told(&text, &["0 deg"]);
    }
}

/// However few steps it takes, a wheel has turned as often as it has.
#[test]
fn whole_turns_do_not_depend_on_steps() {
    let text =
        "struct Train; link arm { point tip = (1, 0); } link small; link coupler; link rocker;
joint a = revolute(ground, arm) at (0, 0);
joint s = revolute(ground, small) at (3, 0);
joint mesh = gear(arm, small, 50 : 7);
joint b = revolute(arm, coupler) at (0.5, 0.5);
joint c = revolute(coupler, rocker) at (2, 5);
joint d = revolute(ground, rocker) at (4, 3);
motor a;";
    let folder = Folder::new().with("a.mech", text);
    let ends = |steps: u32| {
        let words = format!("table a.mech s small b coupler rocker --to 1080 --steps {steps}");
        folder.rows(&words).pop().expect("a row")
    };
    let turned = -3.0 * 360.0 * 50.0 / 7.0;
    for steps in [1, 2, 7, 720] {
        let row = ends(steps);
        let expected = [1080.0, turned, turned, -1080.0, 0.0, 0.0];
        for (found, expected) in row.iter().zip(expected) {
            assert!(close(*found, expected), "{steps}: {row:?}");
        }
    }
}

#[test]
fn a_plot_has_a_graph_for_each_unit() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    folder.mech("plot a.mech b c velocity:coupler.tip -o a.svg --title Rocking --length mm").done();
    let text = folder.text("a.svg");
    for words in
        ["Rocking", "motor a [deg]", "[deg]", "[mm/s]", "velocity:coupler.tip.x", "180", "360"]
    {
        assert!(text.contains(words), "{words}");
    }
    assert_eq!(text.matches("motor a [deg]").count(), 2);
    folder.mech("plot a.mech transmission -o a.png").done();
    let bytes = std::fs::read(folder.path("a.png")).expect("a picture");
    assert!(bytes.starts_with(b"\x89PNG"));
}

#[test]
fn one_quantity_over_another() {
    let folder = Folder::new().with("a.mech", CRANK);
    let table = folder.mech("table a.mech crank.pin.y --over crank.pin.x --steps 12").done();
    assert_eq!(table.lines().next(), Some("crank.pin.x [unit],crank.pin.y [unit]"));
    for row in numbers(&table) {
        assert!(close(row[0].hypot(row[1]), 2.0), "{row:?}");
    }
    // Time is counted from where the motion begins.
    let table = folder
        .mech("table a.mech crank.pin.y --over t --from 30 --to 60 --steps 3 --rate 0.5")
        .done();
    assert_eq!(table.lines().next(), Some("t [s],crank.pin.y [unit]"));
    let rows = numbers(&table);
    assert!(close(rows[3][0], 30_f64.to_radians() / 0.5), "{rows:?}");
    for row in rows {
        let angle = 30_f64.to_radians() + 0.5 * row[0];
        assert!(close(row[1], 2.0 * angle.sin()), "{row:?}");
    }
    folder.mech("plot a.mech crank.pin.y velocity:crank.pin.y --over crank.pin.x -o a.svg").done();
    let text = folder.text("a.svg");
    assert_eq!(text.matches("crank.pin.x [unit]").count(), 2, "{text}");
}

#[test]
fn a_load_is_carried_by_the_motor() {
    let text = CRANK.to_owned()
        + "load push = force(crank.pin);\nload brake = torque(crank);\neffects { force; }\n";
    let folder = Folder::new().with("a.mech", text);
    let motion = "--from 30 --to 60 --steps 1 --rate 0";
    let words =
        format!("table a.mech torque:a reaction:a {motion} --load push=-7,4 --load brake=-1.5");
    for row in folder.rows(&words) {
        let (sin, cos) = row[0].to_radians().sin_cos();
        let expected =
            [3.0 * 10.0 * 2.0 * cos - 2.0 * (cos * 4.0 - sin * -7.0) + 1.5, 7.0, 3.0 * 10.0 - 4.0];
        for (found, expected) in row[1..].iter().zip(expected) {
            assert!(close(*found, expected), "{row:?}");
        }
    }
}

/// A lift of scissors is held by (W + Wa / 2) / tan φ, where W is the weight of the table and Wa that of the arms.
#[test]
fn forces_are_those_at_rest_unless_a_rate_is_said() {
    let text = "struct Scissor; const L = 1.2;
link left { point foot = (0, 0); point mid = (L / 2, 0); point top = (L, 0); mass 8 at (L / 2, 0) inertia 0.96; }
link right { point foot = (0, 0); point mid = (L / 2, 0); point top = (L, 0); mass 8 at (L / 2, 0) inertia 0.96; }
link foot { point pin = (0, 0); line way = (0, 0) -> (1, 0); }
link table { point fixed = (0, 0); line way = (0, 0) -> (1, 0); mass 100 at (0.5, 0.1); }
ground { point o = (0, 0); line floor = (0, 0) -> (1, 0); }
joint a = revolute(ground.o, left.foot); joint m = revolute(left.mid, right.mid);
joint f = revolute(foot.pin, right.foot); joint x = prismatic(ground.floor, foot.way);
joint t = revolute(right.top, table.fixed); joint s = slot(left.top, table.way);
motor x; gravity (0, -9.81);
start { x = 1.0; left near 33 deg; right near 147 deg; table near 0 deg; }";
    let folder = Folder::new().with("a.mech", text);
    let words = "table a.mech torque:x --from 1 --to 0.4 --steps 3";
    let table = folder.mech(words).done();
    assert!(table.starts_with("motor x [unit],torque:x at rest [force]\n"), "{table}");
    for row in numbers(&table) {
        let x = row[0];
        let expected = -108.0 * 9.81 * x / (1.44 - x * x).sqrt();
        assert!(close(row[1], expected), "{row:?}, not {expected}");
    }
    let moving = folder.mech(&format!("{words} --rate 1")).done();
    assert!(moving.contains("torque:x at rate 1 [force]"), "{moving}");
    assert!(!close(numbers(&moving)[0][1], numbers(&table)[0][1]), "{moving}");
}

/// A balance of Roberval is overconstrained: virtual work still tells what holds it, and what moves it.
#[test]
fn redundant_joints_leave_torques() {
    let text = "struct Roberval; link upper { mass 3 at (0, 2) inertia 5; } link lower;
link left { mass 1 at (-6, 4); } link right { mass 2 at (3.5, 4); }
joint u = revolute(ground, upper) at (0, 2); joint l = revolute(ground, lower) at (0, 0);
joint a = revolute(upper, left) at (-3, 2); joint b = revolute(lower, left) at (-3, 0);
joint c = revolute(upper, right) at (3, 2); joint d = revolute(lower, right) at (3, 0);
motor u = 0.3 * t * t; gravity (0, -9.81); allow redundant;";
    let folder = Folder::new().with("a.mech", text);
    for row in folder.rows("table a.mech torque:u --steps 3 --to 1.2") {
        // The pans go on circles of radius 3 without turning.
        let inertia = 5.0 + (1.0 + 2.0) * 9.0;
        let expected = 9.81 * 3.0 * (0.3 * row[0] * row[0]).cos() + inertia * 0.6;
        assert!(close(row[1], expected), "{row:?}, not {expected}");
    }
}

/// The first wheel of a belt turns the second by what the second's weight asks for, however its ratio is written.
#[test]
fn a_belt_tells_the_moment_on_its_second_wheel() {
    let belt = |ratio: &str| {
        let text = format!(
            "struct Belt; link a; link b {{ mass 1 at (6, 0); }}
joint j = revolute(ground, a) at (0, 0); joint k = revolute(ground, b) at (5, 0);
joint belt = belt(a, b, {ratio}); motor j; gravity (0, -10);"
        );
        let folder = Folder::new().with("a.mech", text);
        let words = "table a.mech reaction:belt reaction:belt.torque torque:j --to 90 --steps 2";
        folder.rows(words)
    };
    for ratio in ["20 : 40", "1 : 2", "0.5 : 1.0"] {
        for row in belt(ratio) {
            let weight = 10.0 * (row[0] / 2.0).to_radians().cos();
            let expected = [0.0, 0.0, weight, weight / 2.0];
            for (found, expected) in row[1..].iter().zip(expected) {
                assert!(close(*found, expected), "{ratio}: {row:?}");
            }
        }
    }
}

mech_runtime::mechanism! {
    struct Single: f32;
    link crank; link coupler { point tip = (2.5, 3); } link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a;
}

/// A text in single precision is measured as its generated code computes, to the bit.
#[test]
fn single_precision_stays_single() {
    let text = FOUR_BAR.replace("struct FourBar", "struct Single: f32");
    let folder = Folder::new().with("a.mech", text);
    let table = folder.mech("table a.mech coupler.tip --steps 36").done();
    let mut generated = Single::new();
    for (step, row) in (0..=36).zip(table.lines().skip(1)) {
        let angle = f64::from(step) / 36.0 * std::f64::consts::TAU;
        #[expect(clippy::cast_possible_truncation, reason = "the motor takes that")]
        generated.move_to([angle as f32]).expect("it turns");
        let tip = generated.coupler_tip();
        let cells: Vec<f32> =
            row.split(',').skip(1).map(|cell| cell.parse().expect("a number")).collect();
        assert_eq!(cells, [tip.x, tip.y], "{step}");
    }
}

/// It is drawn and filmed there, too: after 10⁵ turns its motor is 1.7 degrees farther than was asked for.
#[test]
fn single_precision_is_seen_where_it_is() {
    let single = FOUR_BAR.replace("struct FourBar", "struct Single: f32");
    let folder = Folder::new().with("single.mech", single);
    let folder = folder.with("double.mech", FOUR_BAR);
    let asked = 36_000_018.0_f64;
    let mut generated = Single::new();
    #[expect(clippy::cast_possible_truncation, reason = "the motor takes that")]
    generated.move_to([asked.to_radians() as f32]).expect("it turns");
    let crank = generated.poses()[0];
    let moved = f64::from(crank.sin.atan2(crank.cos)).to_degrees();
    assert!((moved - 19.726).abs() < 0.01, "{moved}");
    let picture = |words: String| {
        folder.mech(&format!("{words} -o a.png --size 300x200")).done();
        pixels(&folder.path("a.png")).1
    };
    // Pixels differ by what rounding moves an edge.
    let worst = |one: &[u8], other: &[u8]| {
        let pairs = one.iter().zip(other);
        pairs.map(|(a, b)| a.abs_diff(*b)).max()
    };
    let expected = picture(format!("draw double.mech --at a={moved}"));
    let elsewhere = picture(format!("draw double.mech --at a={asked}"));
    assert!(worst(&expected, &elsewhere) > Some(50));
    for words in [
        format!("draw single.mech --at a={asked}"),
        format!("film single.mech --from {asked} --to 36000090 --seconds 1 --rate 1"),
    ] {
        let found = worst(&expected, &picture(words.clone()));
        assert!(found < Some(4), "{words}: {found:?}");
    }
}

/// The intersection of two lines, each through two points.
fn crossing([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> [f64; 2] {
    let (u, v) = ([b[0] - a[0], b[1] - a[1]], [d[0] - c[0], d[1] - c[1]]);
    let part = ((c[0] - a[0]) * v[1] - (c[1] - a[1]) * v[0]) / (u[0] * v[1] - u[1] * v[0]);
    [a[0] + part * u[0], a[1] + part * u[1]]
}

#[test]
fn instant_centres_are_where_kennedy_has_them() {
    let text =
        "struct M; link crank { point a = (1, 0.5); } link rod { point b = (4, 3); } link rocker;
joint o = revolute(ground, crank) at (0, 0); joint a = revolute(crank, rod) at (1, 0.5);
joint b = revolute(rod, rocker) at (4, 3); joint d = revolute(ground, rocker) at (5, 0); motor o;";
    let folder = Folder::new().with("a.mech", text);
    let words = "table a.mech crank.a rod.b centre(rod,ground) centre(crank,rocker) centre(crank,ground) \
        centre(rocker,rod) --from 10 --to 70 --steps 6";
    for row in numbers(&folder.mech(words).done()) {
        let [a, b] = [[row[1], row[2]], [row[3], row[4]]];
        let (o, d) = ([0.0, 0.0], [5.0, 0.0]);
        // Of the coupler on the ground, of the arms on one another, and two pins.
        let expected = [crossing([o, a], [d, b]), crossing([o, d], [a, b]), o, b];
        for (found, expected) in row[5..].iter().zip(expected.as_flattened()) {
            assert!(close(*found, *expected), "{row:?}");
        }
    }
    // Two links that turn as one have none, nor has a link on itself.
    let slide =
        "struct M; link block; joint x = prismatic(ground, block) at (0, 0) along (1, 0); motor x;";
    let folder = folder.with("b.mech", slide);
    let table = folder.mech("table b.mech centre(block,ground).x --from 0 --to 1 --steps 1").done();
    assert!(table.ends_with("1,\n"), "{table}");
}

/// Two cranks hold a pen: each has its influence on it, whatever the other does.
#[test]
fn influence_coefficients_are_slopes_by_one_motor() {
    let text = "struct M; link left; link right; link pen { point tip = (2, 3); } link arm;
joint a = revolute(ground, left) at (0, 0); joint b = revolute(ground, right) at (3, 0);
joint c = revolute(left, pen) at (-1, 1.5); joint e = revolute(right, arm) at (4, 1.5);
joint f = revolute(pen, arm) at (2, 3); motor a; motor b; ground { line rail = (0, 1) -> (1, 0); }";
    let folder = Folder::new().with("a.mech", text);
    for moved in ["a", "b"] {
        let measured = ["pen.tip.x*f", "distance(pen.tip,(1,-1))", "distance(pen.tip,ground.rail)"];
        let slopes = measured.map(|one| format!("d({one},{moved})"));
        let words = format!(
            "table a.mech pen.tip.x pen.tip.y f {} {} --motor {moved} --from 4.99 --to 5.01 --steps 2",
            measured.join(" "),
            slopes.join(" ")
        );
        let rows = numbers(&folder.mech(&words).done());
        let [x, y, f] = [rows[1][1], rows[1][2], rows[1][3].to_radians()];
        let values = [x * f, (x - 1.0).hypot(y + 1.0), (y - 1.0).abs()];
        for (number, value) in values.into_iter().enumerate() {
            assert!((rows[1][4 + number] - value).abs() < 1e-12, "{rows:?}");
            let rise = rows[2][4 + number] - rows[0][4 + number];
            let slope = rise / 0.02_f64.to_radians();
            assert!((rows[1][7 + number] - slope).abs() < 1e-6, "{rows:?}");
        }
    }
    for (moved, other) in [("a", "b"), ("b", "a")] {
        let words = format!(
            "table a.mech pen.tip.x f d(pen.tip.x,{moved}) d(f,{moved}) d(pen.tip.x,{other}) \
            --motor {moved} --from 4.99 --to 5.01 --steps 2"
        );
        let rows = numbers(&folder.mech(&words).done());
        let step = 0.02_f64.to_radians();
        let slopes =
            [(rows[2][1] - rows[0][1]) / step, (rows[2][2] - rows[0][2]).to_radians() / step];
        assert!((rows[1][3] - slopes[0]).abs() < 1e-6, "{rows:?}");
        assert!((rows[1][4] - slopes[1]).abs() < 1e-6, "{rows:?}");
        assert!((rows[1][5] - slopes[0]).abs() > 0.1, "{rows:?}");
    }
    let refused = folder.mech("table a.mech d(pen.tip,a)").refused(2);
    assert!(refused.contains("`pen.tip` is a place"), "{refused}");
}
