//! Ranges of several motors: what one motor alone moves is proved over that motor alone, wherever its carrier stands.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::reporter;
use mech_compiler::structure::{Diagnosis, RangeTrouble};
use mech_test_support::model;
use proptest::prelude::*;
use std::fmt::Write as _;

/// An arm of several links, each turned by a cylinder on the one before it, the first on the ground or on a turret.
#[derive(Clone, Debug)]
struct Digger {
    turret: bool,
    /// Of each link how long it is and how it leans, where on it its cylinder ends, and where on the one before it that begins.
    links: Vec<([f64; 2], [f64; 2], [f64; 2])>,
}

/// Ends of the range of a cylinder.
type Ends = [f64; 2];

const NARROW: Ends = [-0.01, 0.01];

impl Digger {
    fn text(&self, ranges: &[Ends]) -> String {
        let mut text = "struct Digger;\n".to_owned();
        let mut carrier = "ground".to_owned();
        if self.turret {
            text += "link turret; joint t = revolute(ground, turret) at (0, -1); motor t;\n";
            "turret".clone_into(&mut carrier);
        }
        let mut pivot = [0.0, 0.0];
        for (number, (&([length, lean], [along, beside], [back, below]), [low, high])) in
            self.links.iter().zip(ranges).enumerate()
        {
            let (sin, cos) = lean.sin_cos();
            let at = |x: f64, y: f64| [pivot[0] + cos * x - sin * y, pivot[1] + sin * x + cos * y];
            let end = at(along * length, beside);
            let begin = at(-back, -below);
            let middle = [0.5 * (begin[0] + end[0]), 0.5 * (begin[1] + end[1])];
            let offset = [end[0] - begin[0], end[1] - begin[1]];
            let _ = writeln!(
                text,
                "link l{number}; link c{number}; link r{number};
                joint p{number} = revolute({carrier}, l{number}) at ({:?}, {:?});
                joint b{number} = revolute({carrier}, c{number}) at ({:?}, {:?});
                joint x{number} = prismatic(c{number}, r{number}) at ({:?}, {:?}) along ({:?}, {:?});
                joint e{number} = revolute(r{number}, l{number}) at ({:?}, {:?});
                motor x{number} in {low:?} ..= {high:?};",
                pivot[0],
                pivot[1],
                begin[0],
                begin[1],
                middle[0],
                middle[1],
                offset[0],
                offset[1],
                end[0],
                end[1],
            );
            pivot = at(length, 0.0);
            carrier = format!("l{number}");
        }
        text
    }
}

fn diggers() -> impl Strategy<Value = Digger> {
    let link = ([1.0..4.0_f64, -1.5..1.5], [0.2..0.8_f64, 0.0..0.6], [0.3..1.5_f64, 0.2..1.0]);
    (any::<bool>(), prop::collection::vec(link, 2..=4))
        .prop_map(|(turret, links)| Digger { turret, links })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn what_is_proved_of_each_cylinder_is_proved_of_all(
        digger in diggers(), shares in prop::array::uniform4([0.1..0.95, 0.1..0.95]),
    ) {
        // As far as the triangle of pivot and cylinder lets it, by the law of cosines.
        let ends = digger.links.iter().zip(shares).map(|(&([length, _], [along, beside], [back, below]), shares)| {
            let [arm, base] = [f64::hypot(along * length, beside), f64::hypot(back, below)];
            let own = f64::hypot(along * length + back, beside + below);
            [shares[0] * ((arm - base).abs() - own), shares[1] * (arm + base - own)]
        });
        let ends: Vec<Ends> = ends.map(|[low, high]: Ends| [low.min(-0.001), high.max(0.001)]).collect();
        for (one, own) in ends.iter().enumerate() {
            let mut alone = vec![NARROW; ends.len()];
            alone[one] = *own;
            if let Err(wrong) = compile(&model(&digger.text(&alone))) {
                // Then the error speaks of no motor that has no part in it.
                for diagnosis in &wrong {
                    let Diagnosis::Range { motor, trouble, .. } = diagnosis else {
                        prop_assert!(false, "{:?}", diagnosis);
                        unreachable!();
                    };
                    let others = match trouble {
                        RangeTrouble::Blocked { others, .. } => others.len(),
                        RangeTrouble::Undecided { between } => between.len() - 1,
                        _ => 0,
                    };
                    let text = reporter::text(diagnosis, &model(&digger.text(&alone)));
                    prop_assert_eq!(others, 0, "{} {:?}", text, motor);
                }
                return Err(TestCaseError::reject("it does not move so far"));
            }
        }
        let all = compile(&model(&digger.text(&ends)));
        prop_assert!(all.is_ok(), "{:?} {}", all.err(), digger.text(&ends));
    }
}

/// A second loop stands on a ring of four links that almost is a parallelogram: the ring is proved never to come to its change point, but
/// comes near, and there the second loop is fast.
#[test]
fn what_a_proved_loop_makes_fast_is_not_leapt_over() {
    let text = include_str!("ranges/near.mech");
    let compiled = compile(&model(text)).expect("a proved range");
    let ends = |steps: u32| {
        let mut machine = Machine::<f64>::new(&compiled.program);
        let (from, to) = (0.9037, -1.7145);
        machine.move_to(&[from]).expect("within the range");
        for step in 1..=steps {
            let part = f64::from(step) / f64::from(steps);
            let at = from + part * (to - from);
            machine.move_to(&[at]).expect("within the range");
        }
        machine.position().poses.clone()
    };
    let exact = ends(10_000);
    for steps in [1, 2, 7, 60] {
        for (pose, exact) in ends(steps).iter().zip(&exact) {
            for (number, exact) in pose.iter().zip(exact) {
                assert!((number - exact).abs() < 1e-9, "{steps} steps");
            }
        }
    }
}

/// A loop is carried by what the loops before it are made from: what carries it has a part in it through these.
#[test]
fn what_carries_a_loop_may_have_a_part_in_it() {
    let text = include_str!("ranges/chain.mech");
    let wrong = compile(&model(text)).expect_err("it is blocked within its range");
    let [Diagnosis::Range { trouble: RangeTrouble::Blocked { limit, .. }, .. }] = wrong[..] else {
        panic!("{wrong:?}");
    };
    // Where it stops without a range.
    let (free, _) = text.split_once(" in ").expect("a range");
    let compiled = compile(&model(&format!("{free};"))).expect("a mechanism");
    let mut machine = Machine::<f64>::new(&compiled.program);
    machine.move_to(&[-0.14]).expect_err("it is blocked");
    machine.move_toward(&[-0.14]).expect("a finite number");
    assert!((machine.position().motors[0] - limit).abs() < 1e-9);
}

/// A slide pushes a crank as far as this lies straight: at what end of the range that is told, and what range is offered.
fn offered(size: f64, [crank, rod, beside]: [f64; 3], start: f64, other: f64) -> (f64, String) {
    let text = |low: &str, high: &str| {
        let [crank, rod, beside, start] = [crank, rod, beside, start].map(|one| one * size);
        format!(
            "struct Push;
            ground {{ point o = (0, 0); line rail = (0, {beside:?}) -> (1, 0); }}
            link crank {{ point o = (0, 0); point p = ({crank:?}, 0); }}
            link rod {{ point p = (0, 0); point q = ({rod:?}, 0); }}
            link block {{ point q = (0, 0); line axis = (0, 0) -> (1, 0); }}
            joint a = revolute(ground.o, crank.o);
            joint b = revolute(crank.p, rod.p);
            joint c = revolute(rod.q, block.q);
            joint x = prismatic(ground.rail, block.axis);
            motor x in {low} ..= {high};
            start {{ x = {start:?}; crank near 60 deg; rod near -20 deg; }}"
        )
    };
    let start_text = format!("{:?}", start * size);
    let far = format!("{:?}", other * size);
    let is_up = other > start;
    let range = |end: &str| {
        if is_up { text(&start_text, end) } else { text(end, &start_text) }
    };
    let wrong = model(&range(&far));
    let diagnoses = compile(&wrong).expect_err("it goes past a dead point");
    let message = reporter::text(&diagnoses[0], &wrong);
    let word = if is_up { "end" } else { "begin" };
    let (_, offer) = message
        .split_once(&format!("let the range {word} at `"))
        .unwrap_or_else(|| panic!("{message}"));
    let (offer, _) = offer.split_once('`').expect("a quoted number");
    let found = compile(&model(&range(offer)));
    assert!(found.is_ok(), "{offer} of {message}: {:?}", found.err());
    let told = message.split('`').nth(3).expect("a quoted number");
    let told: f64 = told.parse().expect("a number");
    // By Pythagoras.
    let reach = if is_up { crank + rod } else { rod - crank };
    let limit = size * (reach * reach - beside * beside).sqrt();
    assert!((told - limit).abs() <= 1e-4 * size, "{told}, not {limit}: {message}");
    let offered: f64 = offer.parse().expect("a number");
    let short = if is_up { limit - offered } else { offered - limit } / size;
    (short, offer.to_owned())
}

/// What is offered instead of a range past a dead point is a range, however large the mechanism is: short of that by a thousandth at most.
#[test]
fn a_range_that_is_offered_is_one_at_any_size() {
    for size in [1e-6, 1e-3, 1.0, 1e3, 1e6, 1e9] {
        for lengths in [[1.0, 2.0, 0.0], [0.93, 2.71, 0.17], [1.13, 2.37, -0.29]] {
            let [crank, rod, _] = lengths;
            for other in [0.1, 5.0] {
                let (short, offer) = offered(size, lengths, rod + 0.2 * crank, other);
                assert!((-1e-9..=1e-3).contains(&short), "{offer} at {size}: {short}");
                let digits = offer.trim_matches(['0', '.']).replace('.', "").len();
                assert!(digits <= 4, "{offer} at {size}");
            }
            // The start is very near to it.
            let near = ((crank + rod).powi(2) - lengths[2].powi(2)).sqrt() - 2e-5;
            let (short, offer) = offered(size, lengths, near, 5.0);
            assert!((-1e-9..2e-5).contains(&short), "{offer} at {size}: {short}");
        }
    }
}
