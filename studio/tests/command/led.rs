//! Points that are led to a place, and along a path.

use crate::numbers::close;
use crate::run::{Folder, numbers};

/// A plotter whose pen is led by two motors.
const PLOTTER: &str = include_str!("../../../tests/tests/subjects/inverse/plotter.mech");

#[test]
fn a_point_is_led_where_it_is_asked_and_no_farther() {
    let folder = Folder::new().with("a.mech", PLOTTER);
    for step in 0..8 {
        let turn = f64::from(step) * 0.785;
        let place = [0.3 + turn.cos(), 3.0 + 0.8 * turn.sin()];
        let words = format!("a.mech lm rm pen.tip --reach={},{}", place[0], place[1]);
        let [row] = &numbers(&folder.mech(&format!("table {words}")).done())[..] else {
            panic!("it is measured there alone");
        };
        assert!(close(row[3], place[0]) && close(row[4], place[1]), "{row:?}");
        // Each arm, of 2 and 2.5, is a triangle with the way from its foot to the pen.
        for (foot, side, motor) in [(-1.0, 1.0, row[1]), (1.0, -1.0, row[2])] {
            let [x, y] = [place[0] - foot, place[1]];
            let away = x.hypot(y);
            let corner = (4.0 + away * away - 6.25) / (4.0 * away);
            let angle = y.atan2(x) + side * corner.acos();
            assert!(close(motor, angle.to_degrees()), "{row:?}");
        }
        // What is drawn there is what is drawn with the motors there.
        let reach = format!("{},{}", place[0], place[1]);
        folder.mech(&format!("draw a.mech -o led.svg --reach={reach}")).done();
        let at = format!("--at lm={} --at rm={}", row[1], row[2]);
        folder.mech(&format!("draw a.mech -o put.svg {at}")).done();
        assert_eq!(folder.text("led.svg"), folder.text("put.svg"));
    }
    // An arm is as long as 4.5, and as short as 0.5.
    for place in ["9,9", "-1,4.6", "1.2,0.1", "1e300,1e300", "-1,0"] {
        for command in ["table a.mech pen.tip", "draw a.mech -o no.svg"] {
            let said = folder.mech(&format!("{command} --reach={place}")).refused(1);
            assert!(
                said.contains("`pen.tip` cannot be led to (") && !said.contains("NaN"),
                "{said}"
            );
        }
    }
}

#[test]
fn a_bucket_is_led_past_where_its_cylinder_is_longest() {
    let text = include_str!("../../../tests/tests/subjects/inverse/excavator.mech");
    let folder = Folder::new().with("a.mech", text);
    let words = "table a.mech bucket bucket.teeth --reach=6,0.5,-40";
    let [row] = &numbers(&folder.mech(words).done())[..] else {
        panic!("it is measured there alone");
    };
    // The first is the motor of the lift.
    let off = row[1..].iter().zip([-40.0, 6.0, 0.5]);
    assert!(off.clone().all(|(found, asked)| close(*found, asked)), "{row:?}");
}

#[test]
fn motors_that_are_more_than_needed_go_as_little_as_they_can() {
    let text = include_str!("../../../tests/tests/subjects/inverse/snake.mech");
    let folder = Folder::new().with("a.mech", text);
    for [x, y] in [[3.9, 1.2], [3.6, 0.4], [4.1, 0.7], [3.2, 1.9]] {
        let words = format!("a.mech a b c third.tip --reach={x},{y}");
        let [row] = &numbers(&folder.mech(&format!("table {words}")).done())[..] else {
            panic!("it is measured there alone");
        };
        let [.., a, b, c, tip_x, tip_y] = row[..] else {
            panic!("{row:?}");
        };
        assert!(close(tip_x, x) && close(tip_y, y), "{row:?}");
        // As it is declared: bars of 2, of 1, and one to (1, 1) that is behind its joint turned backwards.
        let gone = [a, b, c].map(f64::to_radians);
        let angles = [gone[0], gone[0] + gone[1], gone[0] + gone[1] - gone[2]];
        let bars = [[2.0, 0.0], [1.0, 0.0], [1.0, 1.0]];
        let turned = [0, 1, 2].map(|bar| {
            let ((sin, cos), [x, y]) = (angles[bar].sin_cos(), bars[bar]);
            [cos * x - sin * y, sin * x + cos * y]
        });
        let from = |first: usize| {
            turned[first..].iter().fold([0.0, 0.0], |sum, bar| [sum[0] + bar[0], sum[1] + bar[1]])
        };
        let end = from(0);
        assert!((end[0] - x).hypot(end[1] - y) < 1e-9, "{row:?} {end:?}");
        // Nowhere do they go less: where the tip stays, the way does not change to the first order.
        let arms = [(0, 1.0), (1, 1.0), (2, -1.0)].map(|(first, sense)| {
            let [x, y] = from(first);
            [-sense * y, sense * x]
        });
        let still = [(1, 2), (2, 0), (0, 1)]
            .map(|(one, other)| arms[one][0] * arms[other][1] - arms[one][1] * arms[other][0]);
        let along: f64 = gone.iter().zip(still).map(|(gone, still)| gone * still).sum();
        let lengths =
            [gone, still].map(|all| all.map(|part| part * part).iter().sum::<f64>().sqrt());
        assert!(along.abs() < 1e-7 * lengths[0] * lengths[1], "{row:?} {along}");
    }
    // One that comes to the end of its range stays there, and the others go on.
    let narrow = text.replace("param", "const").replace("motor b;", "motor b in -5 deg ..= 5 deg;");
    let folder = Folder::new().with("a.mech", &narrow);
    let [row] = &numbers(&folder.mech("table a.mech b third.tip --reach=3.2,1.9").done())[..]
    else {
        panic!("it is measured there alone");
    };
    let [.., b, x, y] = row[..] else {
        panic!("{row:?}");
    };
    assert!(close(b.abs(), 5.0) && close(x, 3.2) && close(y, 1.9), "{row:?}");
    let said = folder.mech("table a.mech b --reach=9,9").refused(1);
    assert!(said.contains("`third.tip` cannot be led to (9, 9)"), "{said}");
}

#[test]
fn a_point_and_its_motors_move_along_its_path() {
    let text =
        format!("{PLOTTER}\npath pen.tip = (0.3 + cos(60 rpm * t), 3 + 0.5 * sin(120 rpm * t));");
    let folder = Folder::new().with("a.mech", text);
    let words = "table a.mech pen.tip velocity:pen.tip acceleration:pen.tip lm velocity:lm \
                 acceleration:lm --steps 2000";
    let rows = numbers(&folder.mech(words).done());
    // Once round, after a second.
    assert!(rows.len() == 2001 && close(rows[2000][0], 1.0), "{:?}", rows[2000]);
    let turn = std::f64::consts::TAU;
    for three in rows.windows(3).step_by(17) {
        let [before, row, after] = three else {
            panic!("there are three");
        };
        let (one, two) = (turn * row[0], 2.0 * turn * row[0]);
        let place = [0.3 + one.cos(), 3.0 + 0.5 * two.sin()];
        let velocity = [-turn * one.sin(), turn * two.cos()];
        let acceleration = [-turn * turn * one.cos(), -2.0 * turn * turn * two.sin()];
        let given = [place, velocity, acceleration].concat();
        let off = row[1..7].iter().zip(given);
        assert!(off.clone().all(|(found, given)| (found - given).abs() < 1e-8), "{row:?}");
        // The motor's rates are those of its differences, which are in degrees.
        let step = row[0] - before[0];
        let rate = ((after[7] - before[7]) / (2.0 * step)).to_radians();
        let second = ((after[7] - 2.0 * row[7] + before[7]) / (step * step)).to_radians();
        assert!((rate - row[8]).abs() < 1e-4 * rate.abs().max(10.0), "{row:?} {rate}");
        assert!((second - row[9]).abs() < 1e-3 * second.abs().max(10.0), "{row:?} {second}");
    }
    // A path that nobody knows the end of may leave the reach.
    let text = format!("{PLOTTER}\npath pen.tip = (0.3, 3 + t);");
    let folder = Folder::new().with("a.mech", text);
    folder.mech("table a.mech pen.tip --to 1").done();
    let said = folder.mech("table a.mech pen.tip --to 3").refused(1);
    assert!(said.contains("`pen.tip` cannot follow its path until t = "), "{said}");
}
