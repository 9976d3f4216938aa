//! Whatever joint of a drawing is forgotten, or missed by a little: it is offered, where it was.

use super::advice::{alternatives, mend, messages, written_out};
use mech_compiler::compile;
use mech_compiler::syntax::parse;
use proptest::prelude::*;

/// A four-bar whose ends are given; one joint is left out, and one end is beside its place.
fn text(pins: [[f64; 2]; 4], left_out: Option<usize>, beside: [f64; 2]) -> String {
    let place = |[x, y]: [f64; 2]| format!("({x:?}, {y:?})");
    let [a, b, c, d] = pins.map(place);
    let end = place([pins[2][0] + beside[0], pins[2][1] + beside[1]]);
    let joints = [
        format!("joint a = revolute(ground, crank) at {a};"),
        format!("joint b = revolute(crank, coupler) at {b};"),
        format!("joint c = revolute(coupler, rocker) at {c};"),
        format!("joint d = revolute(ground, rocker) at {d};"),
    ];
    let left = joints.iter().enumerate();
    let left = left.filter(|(number, _)| Some(*number) != left_out);
    let left: Vec<&str> = left.map(|(_, joint)| joint.as_str()).collect();
    format!(
        "struct FourBar;
        link crank {{ point pb = {b}; }}
        link coupler {{ bar [{b}, {c}] width 0.1; }}
        link rocker {{ bar [{end}, {d}] width 0.1; }}
        {}
        motor a;\n",
        left.join("\n        ")
    )
}

fn compiles(text: &str) -> bool {
    let parsed = parse(text.parse().expect("tokens"));
    parsed.errors.is_empty() && compile(&parsed.model).is_ok()
}

fn pins() -> impl Strategy<Value = [[f64; 2]; 4]> {
    let part = || (-40_i32..40).prop_map(|part| f64::from(part) / 8.0);
    prop::array::uniform4([part(), part()])
}

/// No two pins are so near each other that one could be meant for the other.
fn apart(pins: &[[f64; 2]; 4]) -> bool {
    let distance = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    (0..4).all(|one| (0..one).all(|other| distance(pins[one], pins[other]) > 2.5))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_forgotten_joint_is_offered_where_it_was(
        pins in pins().prop_filter("pins apart", apart),
        forgotten in 1_usize..4,
        angle in -3.0_f64..3.0,
    ) {
        prop_assume!(compiles(&text(pins, None, [0.0; 2])));
        let beside = if forgotten == 2 { [0.05 * angle.cos(), 0.05 * angle.sin()] } else { [0.0; 2] };
        let broken = text(pins, Some(forgotten), beside);
        let messages = messages(&broken);
        let links = ["", "crank, coupler", "coupler, rocker", "ground, rocker"][forgotten];
        let [x, y] = pins[forgotten];
        let wanted = format!("revolute({links}) at ({x}, {y});");
        let first = messages.iter().flat_map(|message| alternatives(message)).next().unwrap_or_default();
        prop_assert!(first.contains(&wanted), "no {wanted} in {messages:#?}\n{broken}");
        prop_assert_eq!(forgotten == 2, first.contains("which are drawn 0.05 apart there"));
        for advice in messages.iter().flat_map(|message| written_out(message)) {
            let text = mend(&broken, &advice);
            prop_assert!(compiles(&text), "{advice}\n{text}");
        }
    }
}
