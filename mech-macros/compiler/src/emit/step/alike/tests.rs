//! Which pieces are alike, and how each differs.

use super::Term;
use super::class::{Class, Output};
use super::row::Row;
use super::shape::Shape;
use crate::model::{InputId, Number};
use crate::program::{Block, BlockId, BlockKind, Node, Op, Program, Value};

/// A program of one block that is being written.
#[derive(Default)]
struct Written(Program);

impl Written {
    fn make(&mut self, op: Op) -> Value {
        let nodes = &mut self.0.ssa.nodes;
        nodes.push(Node { op, block: BlockId::FIRST, iterated: false, name: None });
        Value::at(nodes.len() - 1)
    }

    fn input(&mut self, number: usize) -> Value {
        self.make(Op::Input(InputId::new(number)))
    }

    fn number(&mut self, number: f64) -> Value {
        self.make(Op::Constant(Number::new(number)))
    }

    /// The shape of these values.
    fn shape(&mut self, values: &[Value]) -> Shape {
        self.0.ssa.blocks =
            vec![Block { name: String::new(), title: String::new(), kind: BlockKind::Straight }];
        Shape::of(&self.0, values).expect("plain operations")
    }
}

/// x · a + b · y, with the operands of the product and of the sum in either order.
fn sum_of_products(numbers: [f64; 2], inputs: [usize; 2], swapped: [bool; 2]) -> Shape {
    let mut written = Written::default();
    let [x, y] = inputs.map(|number| written.input(number));
    let [a, b] = numbers.map(|number| written.number(number));
    let first = if swapped[0] { Op::Mul(a, x) } else { Op::Mul(x, a) };
    let (first, second) = (written.make(first), written.make(Op::Mul(b, y)));
    let sum = if swapped[1] { Op::Add(second, first) } else { Op::Add(first, second) };
    let root = written.make(sum);
    let absolute = written.make(Op::Abs(root));
    written.shape(&[first, second, root, absolute])
}

#[test]
fn pieces_that_are_equal_up_to_numbers_are_alike() {
    let first = sum_of_products([2.0, 3.0], [0, 1], [false, false]);
    let other = sum_of_products([4.0, 5.0], [2, 3], [false, false]);
    let row = Row::of(&first, &other).expect("they are alike");
    assert_eq!(row.numbers, [4.0, 5.0]);
    assert_eq!(row.opposite, [false; 4]);
}

#[test]
fn the_order_of_summands_and_factors_makes_no_difference() {
    let first = sum_of_products([2.0, 3.0], [0, 1], [false, false]);
    for swapped in [[true, false], [false, true], [true, true]] {
        let other = sum_of_products([4.0, 5.0], [2, 3], swapped);
        let row = Row::of(&first, &other).expect("they are alike");
        let mut numbers = row.numbers.clone();
        numbers.sort_by(f64::total_cmp);
        assert_eq!(numbers, [4.0, 5.0]);
        // Whichever summand stands for which, its number and its input go together.
        let four = row.numbers.iter().position(|&number| number == 4.0);
        let names = row.arguments.iter().map(|term| term.value.index());
        let names: Vec<usize> = names.collect();
        assert_eq!(names[four.expect("it is there")], 0);
    }
}

#[test]
fn another_operation_is_not_alike() {
    let shape = |op: fn(Value, Value) -> Op| {
        let mut written = Written::default();
        let [x, y] = [0, 1].map(|number| written.input(number));
        let value = written.make(op(x, y));
        written.shape(&[value])
    };
    assert!(Row::of(&shape(Op::Max), &shape(Op::Div)).is_none());
    assert!(Row::of(&shape(Op::Add), &shape(Op::Mul)).is_none());
    // The greater of two numbers is not the same in either order, if both are zero.
    assert!(Row::of(&shape(Op::Max), &shape(Op::Max)).is_some());
}

#[test]
fn another_wiring_is_not_alike() {
    // x / y + y, and x / y + x.
    let shape = |of_divisor: bool| {
        let mut written = Written::default();
        let [x, y] = [0, 1].map(|number| written.input(number));
        let quotient = written.make(Op::Div(x, y));
        let sum = written.make(Op::Add(quotient, if of_divisor { y } else { x }));
        written.shape(&[quotient, sum])
    };
    assert!(Row::of(&shape(true), &shape(false)).is_none());
    assert!(Row::of(&shape(true), &shape(true)).is_some());
}

#[test]
fn one_value_stands_for_one_other() {
    let shape = |numbers: [usize; 2]| {
        let mut written = Written::default();
        let [x, y] = [0, 1].map(|number| written.input(number));
        let values = numbers.map(|number| [x, y][number]);
        let product = written.make(Op::Mul(values[0], values[1]));
        written.shape(&[product])
    };
    assert!(Row::of(&shape([0, 0]), &shape([0, 1])).is_none());
    assert!(Row::of(&shape([0, 1]), &shape([0, 0])).is_some());
}

#[test]
fn a_difference_is_a_sum_of_an_opposite() {
    let shape = |op: fn(Value, Value) -> Op, number: f64| {
        let mut written = Written::default();
        let (x, a) = (written.input(0), written.number(number));
        let value = written.make(op(x, a));
        written.shape(&[value])
    };
    let row = Row::of(&shape(Op::Add, 2.0), &shape(Op::Sub, 3.0));
    assert_eq!(row.expect("they are alike").numbers, [-3.0]);
}

#[test]
fn signs_of_inner_sums_tell_apart() {
    // |a − b| and |a + b|: no sign of a number makes one of the other.
    let shape = |op: fn(Value, Value) -> Op| {
        let mut written = Written::default();
        let [x, y] = [0, 1].map(|number| written.input(number));
        let [x, y] = [x, y].map(|value| written.make(Op::Abs(value)));
        let value = written.make(op(x, y));
        written.shape(&[x, y, value])
    };
    assert!(Row::of(&shape(Op::Sub), &shape(Op::Add)).is_none());
}

#[test]
fn a_class_has_enough_pieces() {
    let shapes = |count: usize| {
        let shapes = (0..count).map(|number| {
            let numbers =
                [number, number + 1].map(|number| f64::from(u8::try_from(number).expect("few")));
            (number, sum_of_products(numbers, [0, 1], [number % 2 == 0, number % 3 == 0]))
        });
        shapes.collect()
    };
    assert!(Class::find(shapes(3)).is_empty());
    let classes = Class::find(shapes(7));
    assert_eq!(classes.len(), 1);
    assert_eq!(classes[0].pieces, [0, 1, 2, 3, 4, 5, 6]);
}

#[test]
fn an_opposite_is_an_output_of_its_own() {
    let mut written = Written::default();
    let x = written.input(0);
    let value = written.make(Op::Abs(x));
    let opposite = written.make(Op::Neg(value));
    let shape = written.shape(&[value, opposite]);
    let shapes = (0..4).map(|number| (number, shape.clone())).collect();
    let classes = Class::find(shapes);
    let outputs = [value, opposite].map(|value| classes[0].output(&written.0, 0, value));
    let expected = [false, true].map(|negative| Output { position: 0, negative });
    assert_eq!(outputs, expected);
    assert_eq!(Term::of(&written.0, opposite), Term { value, negative: true });
}
