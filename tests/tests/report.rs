//! The report says ratios as a reader would.

use mech_compiler::compile;
use mech_test_support::model;

#[test]
fn a_pitch_radius_is_told_as_it_is_written() {
    for radius in [0.02, 0.1, 1.0 / 3.0, 12.5, 0.378] {
        let model = model(&format!(
            "struct Rack; link pinion; link bar; joint a = revolute(ground, pinion) at (0, 0);
            joint s = prismatic(ground, bar) at (0, -1) along (1, 0);
            joint r = rack(pinion, bar, radius {radius:?}); motor a;"
        ));
        let text = compile(&model).expect("it is coherent").report;
        let line = text.split("s by ").nth(1).expect("what moves the bar");
        let (number, _) = line.split_once(" · a").expect("the motor");
        let value = match number.split_once('/') {
            Some((a, b)) => {
                a.parse::<f64>().expect("a number") / b.parse::<f64>().expect("a number")
            }
            None => number.parse().expect("a number"),
        };
        assert!(number.len() <= format!("{radius}").len().max(5), "{number}");
        assert!((value - radius).abs() <= 1e-15 * radius, "{number}");
    }
}
