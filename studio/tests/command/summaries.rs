//! What a mechanism does, as `mech report` and `mech table` tell it, beside closed forms of textbooks.

use crate::numbers::{CRANK, close};
use crate::run::Folder;
use proptest::prelude::*;

/// How a text says the same: its order, its ends, its ground, its place, its size and its hand.
#[derive(Clone, Debug)]
struct Manner {
    order: u32,
    swapped: u32,
    angle: f64,
    scale: f64,
    is_mirrored: bool,
}

fn manner() -> impl Strategy<Value = Manner> {
    let numbers = (any::<u32>(), any::<u32>(), -3.0..3.0, 0.05..40.0, any::<bool>());
    numbers.prop_map(|(order, swapped, angle, scale, is_mirrored)| Manner {
        order,
        swapped,
        angle,
        scale,
        is_mirrored,
    })
}

impl Manner {
    fn place(&self, [x, y]: [f64; 2]) -> String {
        let y = if self.is_mirrored { -y } else { y };
        let (sin, cos) = self.angle.sin_cos();
        let [x, y] = [x * cos - y * sin + 0.3, x * sin + y * cos - 0.7];
        format!("({:?}, {:?})", self.scale * x, self.scale * y)
    }

    /// A mechanism of these links and joints, each with its kind, its links and its place.
    fn text(&self, links: [&str; 3], joints: &[(&str, &str, [&str; 2], [f64; 2]); 4]) -> String {
        let mut statements: Vec<String> =
            links.iter().map(|link| format!("link {link};")).collect();
        for (number, &(name, kind, ends, at)) in joints.iter().enumerate() {
            let [mut a, mut b] = ends;
            if self.swapped >> number & 1 == 1 {
                (a, b) = (b, a);
            }
            let along = match kind {
                "prismatic" => {
                    let (sin, cos) = self.angle.sin_cos();
                    format!(" along ({cos:?}, {sin:?})")
                }
                _ => String::new(),
            };
            let at = self.place(at);
            statements.push(format!("joint {name} = {kind}({a}, {b}) at {at}{along};"));
        }
        statements.push("motor input;".to_owned());
        let mut order = self.order;
        for last in (1..statements.len()).rev() {
            let count = u32::try_from(last + 1).expect("few");
            statements.swap(last, (order % count) as usize);
            order /= count;
        }
        format!("struct Some;\n{}\n", statements.join("\n"))
    }
}

/// The numbers of a summary: least, greatest, extent, time ratio.
fn summary(folder: &Folder, quantity: &str) -> [f64; 4] {
    let words = format!("table a.mech {quantity} --summary");
    let row = &folder.rows(&words)[0];
    [row[2], row[4], row[6], row[9]]
}

/// The angle between two sides of a triangle, opposite to the third, in degrees.
fn angle(side: f64, other: f64, opposite: f64) -> f64 {
    let cos = (side * side + other * other - opposite * opposite) / (2.0 * side * other);
    cos.acos().to_degrees()
}

fn near(found: f64, expected: f64) -> bool {
    (found - expected).abs() <= 1e-7 * expected.abs().max(1.0)
}

/// The text of a four-bar with these lengths - ground, input, coupler, output - whose input stands at this angle; none if it does not close.
fn four_bar(
    manner: &Manner,
    [ground, input, coupler, output]: [f64; 4],
    start: f64,
) -> Option<String> {
    let pin = [input * start.cos(), input * start.sin()];
    let apart = (ground - pin[0]).hypot(pin[1]);
    let closes = (coupler - output).abs() + 0.02 < apart && apart < coupler + output - 0.02;
    if !closes {
        return None;
    }
    let along = (coupler * coupler - output * output + apart * apart) / (2.0 * apart);
    let across = (coupler * coupler - along * along).sqrt();
    let to = [(ground - pin[0]) / apart, -pin[1] / apart];
    let other = [pin[0] + along * to[0] - across * to[1], pin[1] + along * to[1] + across * to[0]];
    let joints = [
        ("input", "revolute", ["ground", "driver"], [0.0, 0.0]),
        ("near", "revolute", ["driver", "floating"], pin),
        ("far", "revolute", ["floating", "follower"], other),
        ("output", "revolute", ["ground", "follower"], [ground, 0.0]),
    ];
    Some(manner.text(["driver", "floating", "follower"], &joints))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn crank_rockers_swing_as_textbooks_say(
        manner in manner(),
        crank in 0.4..1.2_f64,
        lengths in [1.3..5.0_f64, 1.3..5.0_f64, 1.3..5.0_f64],
        start in -3.0..3.0_f64,
    ) {
        let [d, b, c] = lengths;
        let longest = d.max(b).max(c);
        prop_assume!(crank + longest < d + b + c - longest - 0.1);
        let text = four_bar(&manner, [d, crank, b, c], start).expect("it closes everywhere");
        let folder = Folder::new().with("a.mech", &text);
        // The crank and the coupler lie on one line where the rocker turns round.
        let [out, back] = [b + crank, b - crank];
        let swing = angle(d, c, out) - angle(d, c, back);
        let between = 180.0 + angle(back, d, c) - angle(out, d, c);
        let ratio = between.max(360.0 - between) / between.min(360.0 - between);
        let [_, _, extent, time_ratio] = summary(&folder, "output");
        prop_assert!(near(extent, swing), "{extent} {swing}\n{text}");
        prop_assert!((time_ratio - ratio).abs() < 1e-5 * ratio, "{time_ratio} {ratio}\n{text}");
        let least = [d - crank, d + crank].map(|apart| angle(b, c, apart));
        let least = least.map(|angle| angle.min(180.0 - angle));
        let transmission = summary(&folder, "transmission")[0];
        prop_assert!(near(transmission, least[0].min(least[1])), "{transmission} {least:?}\n{text}");
        let report = folder.mech("report a.mech").done();
        prop_assert!(report.contains("motor     `input` turns right round"), "{report}");
        prop_assert!(report.contains("crank-rocker by Grashof's condition: `driver` can turn"), "{report}");
    }

    /// The class is told by lengths, the range by moving: both agree with the triangles at both ends of a turn.
    #[test]
    fn motors_turn_right_round_as_grashof_says(
        manner in manner(),
        lengths in [0.5..5.0_f64, 0.5..5.0_f64, 0.5..5.0_f64, 0.5..5.0_f64],
        start in -3.0..3.0_f64,
    ) {
        let [ground, input, coupler, output] = lengths;
        let text = four_bar(&manner, lengths, start);
        prop_assume!(text.is_some());
        let slack = [
            (ground - input).abs() - (coupler - output).abs(),
            coupler + output - ground - input,
        ];
        prop_assume!(slack.iter().all(|slack| slack.abs() > 0.02));
        let text = text.unwrap_or_default();
        let folder = Folder::new().with("a.mech", &text);
        let report = folder.mech("report a.mech").done();
        let turns = slack.iter().all(|slack| *slack > 0.0);
        prop_assert_eq!(report.contains("`input` turns right round"), turns, "{}\n{}", report, text);
        let is_crank = report.contains("a double crank") || report.contains("`driver` can turn");
        prop_assert_eq!(is_crank, turns, "{}\n{}", report, text);
    }

    #[test]
    fn slider_cranks_have_the_stroke_of_textbooks(
        manner in manner(),
        crank in 0.3..1.0_f64,
        rod in 2.5..6.0_f64,
        offset in -1.2..1.2_f64,
        start in -3.0..3.0_f64,
    ) {
        let pin = [crank * start.cos(), crank * start.sin()];
        let far = [pin[0] + (rod * rod - (offset - pin[1]).powi(2)).sqrt(), offset];
        let joints = [
            ("input", "revolute", ["ground", "crank"], [0.0, 0.0]),
            ("big", "revolute", ["crank", "rod"], pin),
            ("small", "revolute", ["rod", "piston"], far),
            ("bore", "prismatic", ["ground", "piston"], far),
        ];
        let text = manner.text(["crank", "rod", "piston"], &joints);
        let folder = Folder::new().with("a.mech", &text);
        let reach = |length: f64| (length * length - offset * offset).sqrt();
        let stroke = manner.scale * (reach(rod + crank) - reach(rod - crank));
        let [_, _, extent, _] = summary(&folder, "bore");
        prop_assert!(near(extent, stroke), "{extent} {stroke}\n{text}");
    }
}

/// A yoke moves as a cosine: within a width of its end it stays for twice the angle whose cosine is that much less.
#[test]
fn a_yoke_dwells_at_its_ends() {
    for (radius, start, width) in
        [(1.0, 0.4, 0.01), (2.5, -2.0, 0.2), (0.04, 3.0, 0.0), (3.0, 1.0, 7.0)]
    {
        let (sin, cos) = f64::sin_cos(start);
        let at = format!("({:?}, {:?})", radius * cos, radius * sin);
        let text = format!(
            "struct Yoke; link crank; link yoke; motor a;
            joint x = prismatic(yoke, ground) at {at} along (1, 0);
            joint b = slot(crank, yoke) at {at} along (0, 1);
            joint a = revolute(crank, ground) at (0, 0);"
        );
        let folder = Folder::new().with("a.mech", text);
        let words = format!("table a.mech x --summary --steps 3600 --dwell {width}");
        let row = &folder.rows(&words)[0];
        let expected = (2.0 * (1.0 - width / radius).max(-1.0).acos().to_degrees()).min(360.0);
        assert!((row[10] - expected).abs() < 1e-3 * expected + 1e-9, "{row:?} {expected}");
        assert!((row[6] - 2.0 * radius).abs() < 1e-9 * radius, "{row:?}");
        assert!((row[7] - row[2] - radius).abs() < 1e-9 * radius, "{row:?}");
    }
    let folder = Folder::new().with("a.mech", crate::run::FOUR_BAR);
    let told = folder.mech("table a.mech --summary --dwell=-1").refused(2);
    assert!(told.contains("not negative"), "{told}");
    folder.mech("table a.mech --dwell 1").refused(2);
    folder.mech("table a.mech --summary --over t").refused(2);
}

/// A shaper's quick return, a toggle that stops at both ends, and a slide that nothing stops.
#[test]
fn a_report_says_what_ends_a_range() {
    let folder = Folder::new()
        .with(
            "boom.mech",
            "struct Boom;
            link boom; link barrel; link rod;
            joint o = revolute(ground, boom) at (0, 0);
            joint g = revolute(ground, barrel) at (3, 0);
            joint c = revolute(boom, rod) at (0, 1);
            joint stroke = prismatic(barrel, rod) at (3, 0) along (-3, 1);
            motor stroke;",
        )
        .with(
            "free.mech",
            "struct Free; link block; joint slide = prismatic(ground, block) at (2, 0) along (1, 0); motor slide;",
        );
    let report = folder.mech("report boom.mech").done();
    // The cylinder is √10 long as it is drawn, and from 2 to 4 long in all.
    let [low, high] = [2.0, 4.0].map(|length: f64| length - 10.0_f64.sqrt());
    let line = report.lines().nth(1).expect("a motor");
    let ends: Vec<f64> = line
        .split_whitespace()
        .filter_map(|word| word.trim_end_matches([';', ',']).parse().ok())
        .collect();
    assert_eq!(ends.len(), 2, "{report}");
    assert!((ends[0] - low).abs() < 1e-4 && (ends[1] - high).abs() < 1e-4, "{report}");
    assert!(line.contains("does not close"), "{report}");
    assert!(report.contains("joint `o` swings by 180 deg"), "{report}");
    let check = folder.mech("check free.mech").done();
    assert!(check.contains("motor `slide` slides, and nothing stops it"), "{check}");
}

/// The pin of the crank from a place, and from a point of the ground; the angles of both links; and what holds the weight at a rate.
#[test]
fn distances_angles_and_power() {
    let text = CRANK.replace("struct Crank;", "struct Crank; ground { point o = (3, -1); }")
        + "link arm { point tip = (5, 0); } joint b = revolute(arm, crank) at (2, 0); motor b;";
    let folder = Folder::new().with("a.mech", &text);
    let words = "table a.mech distance(crank.pin,(3,-1)) distance(ground.o,crank.pin) angle(ground,crank) \
        angle(crank,arm) angle(arm,crank) power:a --motor a --from -400 --to 400 --steps 16 --rate 0.5 --at b=30";
    for row in folder.rows(words) {
        let (sin, cos) = row[0].to_radians().sin_cos();
        let apart = (2.0 * cos - 3.0).hypot(2.0 * sin + 1.0);
        let power = 3.0 * 10.0 * 2.0 * cos * 0.5;
        let expected = [apart, apart, row[0], -30.0, 30.0, power];
        for (found, expected) in row[1..].iter().zip(expected) {
            assert!(close(*found, expected), "{row:?} {expected}");
        }
    }
    let head =
        folder.mech("table a.mech distance(ground.o,crank.pin) angle(crank,arm) power:a --rate 1");
    let expected = "motor a [deg],\"distance(ground.o,crank.pin) [unit]\",\"angle(crank,arm) [deg]\",\
        power:a at rate 1 [force·unit/s]";
    assert_eq!(head.done().lines().next(), Some(expected));
    for (quantity, told) in [
        (
            "distance(crank.pin,crank.pim)",
            "`crank` has no point or line `pim`; did you mean `pin`?",
        ),
        ("distance(crank.pin,(1,x))", "nothing is called `x` that could be measured"),
        ("distance(crank.pin)", "expected `,`"),
        ("angle(crank,b)", "`b` is a joint; this must be a link, one of"),
        ("power:a", "`--rate 1`"),
    ] {
        let refused = folder.mech(&format!("table a.mech {quantity}")).refused(2);
        assert!(refused.contains(told), "{quantity}: {refused}");
    }
}
