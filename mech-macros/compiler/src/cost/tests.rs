//! Operations counted by hand.

use super::{Cost, of_blocks, of_dense, of_loops, of_program, weight};
use crate::compile;
use crate::model::{InputId, Method, Model, Number, Precision, Target};
use crate::program::{Block, BlockId, BlockKind, Node, Op, Program, Value};
use crate::syntax::parse;

const FOUR_BAR: &str = "struct FourBar;
    link crank; link coupler; link rocker;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, coupler) at (0.8, 0.6);
    joint c = revolute(coupler, rocker) at (3.3, 2.9);
    joint d = revolute(ground, rocker) at (4, 0);
    motor a;";

fn model(text: &str) -> Model {
    parse(text.parse().expect("tokens")).model
}

fn program(method: Method) -> Program {
    let model = Model { method: Some(method), ..model(FOUR_BAR) };
    compile(&model).expect("coherent").program
}

/// A program made by hand: each operation is given those values that were made before it. All of it is live.
fn made(operations: &[fn(&[Value]) -> Op]) -> Program {
    let mut program = program(Method::Exact);
    program.live = vec![true; operations.len()];
    let values: Vec<Value> = program.live_values().collect();
    let first: Vec<BlockId> = program.block_ids().take(1).collect();
    let nodes = operations.iter().map(|operation| Node {
        op: operation(&values),
        block: first[0],
        iterated: false,
        name: None,
    });
    program.ssa.nodes = nodes.collect();
    program.ssa.blocks =
        vec![Block { name: String::new(), title: String::new(), kind: BlockKind::Straight }];
    program
}

#[test]
fn each_operation_is_counted_once() {
    let program = made(&[
        |_| Op::Input(InputId::new(0)),
        |_| Op::Constant(Number::new(2.0)),
        |v| Op::Sin(v[0]),
        |v| Op::Cos(v[0]),
        |v| Op::Cos(v[1]),
        |v| Op::Add(v[2], v[3]),
        |v| Op::Sub(v[2], v[3]),
        |v| Op::Neg(v[2]),
        |v| Op::Mul(v[2], v[3]),
        |v| Op::Div(v[2], v[3]),
        |v| Op::Sqrt(v[2]),
        |v| Op::Atan2(v[2], v[3]),
        |v| Op::Abs(v[2]),
        |v| Op::Max(v[2], v[3]),
        |v| Op::CopySign(v[2], v[3]),
        |v| Op::Choose(v[2], v[3], v[4]),
        |v| Op::Round(v[2]),
    ]);
    let counted = Cost {
        additions: 3,
        multiplications: 1,
        divisions: 1,
        square_roots: 1,
        // The sine and the cosine of the motor, and the cosine of another angle.
        sine_cosine_pairs: 2,
        arctangents: 1,
        selections: 5,
    };
    assert_eq!(of_program(&program), counted);
    assert_eq!(of_blocks(&program), [counted]);
    assert_eq!(of_loops(&program), []);
}

#[test]
fn what_nothing_needs_costs_nothing() {
    let mut program = made(&[|_| Op::Input(InputId::new(0)), |v| Op::Cos(v[0]), |v| Op::Sin(v[0])]);
    program.live = vec![true, true, false];
    assert_eq!(of_program(&program).sine_cosine_pairs, 1);
    program.live = vec![true, false, false];
    assert_eq!(of_program(&program), Cost::default());
}

/// Elimination as the runtime does it, with a tally.
#[test]
fn a_dense_system_is_counted_as_it_is_solved() {
    for count in 1..9 {
        let (mut products, mut divisions, mut comparisons, mut factors) = (0, 0, 0, 0);
        for pivot in 0..count {
            factors += 1;
            for _row in pivot + 1..count {
                comparisons += 1;
                divisions += 1;
                products += count - (pivot + 1) + 1;
            }
        }
        for row in 0..count {
            products += count - (row + 1);
            divisions += 1;
        }
        let tally = |count: usize| u32::try_from(count).expect("few");
        let counted = Cost {
            additions: tally(products),
            multiplications: tally(products + factors),
            divisions: tally(divisions),
            selections: tally(comparisons),
            ..Cost::default()
        };
        assert_eq!(of_dense(count), counted, "{count} unknowns");
    }
}

#[test]
fn each_round_costs_the_same() {
    let costs: Vec<Cost> =
        (1..=4).map(|rounds| of_program(&program(Method::NewtonSteps(rounds)))).collect();
    let round = Cost {
        additions: costs[1].additions - costs[0].additions,
        multiplications: costs[1].multiplications - costs[0].multiplications,
        divisions: costs[1].divisions - costs[0].divisions,
        ..Cost::default()
    };
    // One over the determinant, and one for each of two directions.
    assert_eq!(round.divisions, 3);
    assert_eq!(costs[2], costs[1] + round);
    assert_eq!(costs[3], costs[2] + round);
    // Until it closes, each round is tested besides.
    let until_closed = of_program(&program(Method::Newton));
    assert_eq!(until_closed.multiplications, costs[2].multiplications);
    assert!(until_closed.selections > costs[2].selections);
}

#[test]
fn a_dyad_in_closed_form_is_the_cheapest() {
    let targets = [
        (Target::X86_64, Precision::F32),
        (Target::X86_64, Precision::F64),
        (Target::CortexM4f, Precision::F32),
        (Target::CortexM4f, Precision::F64),
    ];
    for (target, precision) in targets {
        let weight = |method| weight(of_program(&program(method)), target, precision);
        let exact = weight(Method::Exact);
        for method in [Method::NewtonSteps(1), Method::NewtonSteps(2), Method::Newton] {
            assert!(exact < weight(method), "{target:?} {precision:?} {method:?}");
        }
    }
}

#[test]
fn loops_are_parts_of_the_whole() {
    let program = program(Method::Exact);
    let [closing] = of_loops(&program)[..] else {
        panic!("one loop");
    };
    assert_eq!((closing.square_roots, closing.sine_cosine_pairs), (1, 0));
    assert_eq!(of_program(&program).sine_cosine_pairs, 1);
    let all: Cost = of_blocks(&program).into_iter().sum();
    assert_eq!(all, of_program(&program));
}

#[test]
fn it_reads_well() {
    let cost = Cost {
        additions: 12,
        multiplications: 14,
        divisions: 1,
        square_roots: 1,
        ..Cost::default()
    };
    assert_eq!(cost.to_string(), "12 + · 14 × · 1 ÷ · 1 √");
    assert_eq!(Cost::default().to_string(), "nothing");
}
