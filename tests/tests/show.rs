//! `show`: only what is asked for is computed, and that to the same bits.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{LinkId, Method, Model, Range, Shown};
use mech_compiler::plan::{Plan, Source, Step, plan};
use mech_compiler::program::{Op, Program, Slot, Value, build};
use mech_compiler::structure::analyse;
use mech_test_support::{Dice, cases, grow, seeds};
use proc_macro2::TokenStream;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// A random mechanism, solved by this method, and its plan.
fn case(dice: &mut Dice, method: Method) -> Option<(Model, Plan)> {
    let additions = 1 + dice.below(9);
    let mut model = grow(dice, additions).model;
    model.method = Some(method);
    let structure = analyse(&model).ok()?;
    let plan = plan(&model, &structure).ok()?;
    Some((model, plan))
}

fn showing(model: &Model, shown: Vec<Shown>) -> Model {
    Model { show: Some(shown), ..model.clone() }
}

/// The loops that a program closes, by their numbers.
fn loops(program: &Program) -> BTreeSet<usize> {
    program.solved_loops().into_iter().collect()
}

/// For each link the loops on which its pose depends: carried forwards through the plan, from step to step.
struct Carried {
    /// For each link its cluster, and what its place in that depends on.
    links: Vec<(usize, BTreeSet<usize>)>,
    /// What each source depended on when it was read.
    sources: Vec<Option<BTreeSet<usize>>>,
}

impl Carried {
    fn through(model: &Model, plan: &Plan) -> Self {
        let mut carried = Self {
            links: (0..model.links.len()).map(|link| (link, BTreeSet::new())).collect(),
            sources: vec![None; plan.sources.len()],
        };
        let mut loops = 0..;
        for step in &plan.steps {
            let (connections, parts, closed) = match step {
                Step::Weld(weld) => (vec![weld.connection], Vec::new(), None),
                Step::Drive(drive) => (vec![drive.connection], Vec::new(), None),
                Step::Mesh(mesh) => (vec![mesh.connection], mesh.parts.clone(), None),
                Step::Cam(cam) => (vec![cam.connection], cam.parts.clone(), None),
                Step::Close(closing) => {
                    let ties = closing.ties.iter().flat_map(|tie| tie.sources.clone());
                    let rings = closing.rings.concat();
                    (rings, ties.collect(), loops.next())
                }
            };
            let axes = connections.iter().flat_map(|one| [one.from, one.to]);
            let ends: Vec<usize> = axes.map(|axis| model.axis(axis).link.index()).collect();
            let mut depends: BTreeSet<usize> = closed.into_iter().collect();
            for end in &ends {
                depends.extend(&carried.links[*end].1);
            }
            for (source, _) in &parts {
                depends.extend(carried.source(model, plan, *source));
            }
            carried.merge(&ends, &depends);
        }
        carried
    }

    fn source(&mut self, model: &Model, plan: &Plan, number: usize) -> BTreeSet<usize> {
        let links: Vec<LinkId> = match plan.sources[number] {
            Source::Motor(_) => Vec::new(),
            Source::Angle { from, to } => vec![from, to],
            Source::Displacement(joint) => {
                let (from, to) = model.ends(joint);
                vec![from, to]
            }
        };
        let read = links.iter().flat_map(|link| &self.links[link.index()].1);
        let read = read.copied().collect();
        self.sources[number].get_or_insert(read).clone()
    }

    /// The clusters of these links become one, in the frame of the first.
    fn merge(&mut self, ends: &[usize], depends: &BTreeSet<usize>) {
        let clusters: Vec<usize> = ends.iter().map(|end| self.links[*end].0).collect();
        let first = clusters.iter().copied().min().expect("a step has ends");
        for (cluster, known) in &mut self.links {
            if *cluster != first && clusters.contains(cluster) {
                *cluster = first;
                known.extend(depends);
            }
        }
    }

    /// The loops on which the poses of these links depend.
    fn loops(&self, links: &[LinkId]) -> BTreeSet<usize> {
        let loops = links.iter().flat_map(|link| &self.links[link.index()].1);
        loops.copied().collect()
    }
}

/// The loops of the whole program whose solution is reached from the pose of a link, backwards.
fn dependencies(program: &Program, link: LinkId) -> BTreeSet<usize> {
    let place = program.place_of(link).expect("the whole keeps all");
    let mut waiting: Vec<Value> = program.poses[place].to_vec();
    let mut seen = vec![false; program.ssa.nodes.len()];
    let mut loops = BTreeSet::new();
    while let Some(value) = waiting.pop() {
        if std::mem::replace(&mut seen[value.index()], true) {
            continue;
        }
        let node = program.node(value);
        waiting.extend(node.op.operands());
        match node.op {
            Op::Last(Slot::Pose(link, _)) => waiting.extend(program.poses[link]),
            Op::Last(Slot::State(state)) => waiting.push(program.state[state]),
            Op::Solved(block, _) => {
                let newton = program.newton(block).expect("it is iterated");
                loops.insert(newton.number);
                let scalars = newton.scalars.iter();
                waiting.extend(scalars.flat_map(|scalar| [scalar.first, scalar.next]));
            }
            _ => {
                let closed = program.closed_form(node.block);
                if let Some(closed) = closed.filter(|closed| closed.found.contains(&value)) {
                    loops.insert(closed.number);
                    waiting.push(closed.margin);
                }
            }
        }
    }
    loops
}

#[test]
fn exactly_the_loops_are_solved_that_what_is_shown_depends_on() {
    let (mut fewer, mut other) = (0, 0);
    for seed in seeds(cases(500)) {
        let mut dice = Dice::new(seed);
        for method in [Method::Exact, Method::Newton] {
            let Some((model, plan)) = case(&mut dice, method) else {
                continue;
            };
            let links: Vec<LinkId> = model.declared_links().collect();
            let link = *dice.pick(&links);
            let program = build(&showing(&model, vec![Shown::Link(link)]), &plan);
            let whole = build(&model, &plan);
            let solved = loops(&program);
            let what = format!("seed {seed} {method:?}");
            assert_eq!(solved, dependencies(&whole, link), "{what}");
            // The other method, which does not see that a direction is known however far its link slides.
            let carried = Carried::through(&model, &plan).loops(&program.stored);
            assert!(solved.is_subset(&carried), "{what}");
            assert!(program.place_of(link).is_some(), "{what}");
            fewer += usize::from(solved.len() < loops(&whole).len());
            other += usize::from(solved != carried);
        }
    }
    assert!(fewer > 50 * other.min(2), "it is worth it: {fewer}");
    // On any ground, every fourth link or so is held in its direction by slides alone.
    assert!(fewer > 3 * other, "{fewer}, {other}");
}

/// How many mechanisms are moved, whole and in part.
const CASES: u64 = 100;

#[test]
fn what_is_shown_moves_as_in_the_whole_to_the_last_bit() {
    let mut moved = 0_u64;
    for seed in seeds(cases(CASES)) {
        let mut dice = Dice::new(seed);
        for method in [Method::Exact, Method::NewtonSteps(4), Method::Linear] {
            let Some((model, plan)) = case(&mut dice, method) else {
                continue;
            };
            let links: Vec<LinkId> = model.declared_links().collect();
            let link = *dice.pick(&links);
            let whole = build(&model, &plan);
            let part = build(&showing(&model, vec![Shown::Link(link)]), &plan);
            // Where an angle is followed over whole turns a move is made in pieces, and an iteration ends elsewhere by a rounding.
            if part.is_closed() || part.max_steps == whole.max_steps {
                let what = format!("seed {seed} {method:?}");
                moved += same_motion(&mut dice, (&whole, &part), &what);
            }
        }
    }
    assert!(moved > 2 * cases(CASES), "they move");
}

/// Moves a mechanism and a part of it; tells how often that was possible.
fn same_motion(dice: &mut Dice, (whole, part): (&Program, &Program), what: &str) -> u64 {
    let mut everything = Machine::<f64>::new(whole);
    let mut shown = Machine::<f64>::new(part);
    let mut moved = 0;
    for _ in 0..20 {
        let reach = *dice.pick(&[0.02, 0.02, 0.3, 3.0]);
        let motors = everything.position().motors.iter();
        let motors: Vec<f64> = motors.map(|motor| motor + dice.between(-reach, reach)).collect();
        let before = shown.position().clone();
        if everything.move_to(&motors).is_err() {
            // What does not move may still move in part.
            shown.put_back(before);
            continue;
        }
        assert_eq!(shown.move_to(&motors), Ok(()), "{what}");
        moved += 1;
        for link in &part.stored {
            let pose = |program: &Program, machine: &Machine<'_, f64>| {
                let place = program.place_of(*link).expect("it is state");
                machine.position().poses[place].map(f64::to_bits)
            };
            assert_eq!(pose(whole, &everything), pose(part, &shown), "{what}");
        }
    }
    moved
}

/// A piston and, on the same crank, a rocker whose arm is moved by a gear that follows it.
const PRESS: &str = "
    link crank; link rod; link block { circle (4, 0) radius 1 on plane 1 color 1; }
    link arm { point tip = (-2, 1); circle (-2, 1) radius 1 on plane 0 color 2; }
    link lever; link wheel; link idle;
    joint a = revolute(ground, crank) at (0, 0);
    joint b = revolute(crank, rod) at (1, 0.5);
    joint c = revolute(rod, block) at (4, 0);
    joint x = prismatic(ground, block) at (4, 0) along (1, 0);
    joint d = revolute(crank, arm) at (0.5, 1);
    joint e = revolute(arm, lever) at (-2, 1);
    joint f = revolute(ground, lever) at (-2, 0);
    joint w = revolute(ground, wheel) at (-4, -1);
    joint mesh = gear(lever, wheel, 20 : 10);
    joint g = revolute(wheel, idle) at (-5, -1);
    motor a; motor g;";

fn model(head: &str, show: &str) -> Model {
    mech_test_support::model(&format!("{head} {PRESS} {show}"))
}

/// What the mechanism becomes.
fn code(head: &str, show: &str) -> String {
    let text: TokenStream = format!("{head} {PRESS} {show}").parse().expect("tokens");
    mech_compiler::expand(quote::quote!(::mech_runtime; #text)).to_string()
}

const HEADS: [&str; 3] = [
    "struct Press;",
    "struct Press: f32; method newton;",
    "struct Press; method newton(2) predictor(2);",
];

#[test]
fn shown_as_a_whole_it_is_what_it_is_without() {
    for head in HEADS {
        let all = "show crank, rod, block, arm, lever, wheel, idle, a, b, c, x, d, e, f, w, g;";
        assert_eq!(code(head, all), code(head, ""), "{head}");
    }
}

#[test]
fn in_part_it_says_what_is_left_out() {
    let compiled = |show: &str| compile(&model(HEADS[0], show)).expect("it is coherent");
    let whole = compiled("");
    assert_eq!(whole.saved, None);
    assert!(!whole.report.contains("left out"), "{}", whole.report);
    for (show, left_out, stored) in [
        ("show block;", "loop 2 and joints w g: ", &["block"][..]),
        ("show x, arm.tip;", "joints w g: ", &["block", "arm"]),
        ("show g, idle;", "loop 1: ", &["idle"]),
        ("show crank;", "loops 1, 2 and joints w g: ", &["crank"]),
        ("show c;", "loop 2 and joints w g: ", &["rod", "block"]),
    ] {
        let part = compiled(show);
        assert_eq!(part.program.links, stored, "{show}");
        let saved = part.saved.expect("something is saved");
        let line = format!("  left out  {left_out}{saved}\n");
        assert!(part.report.contains(&line), "{show}{}", part.report);
        assert_eq!(part.loops.len(), part.program.solved_loops().len());
    }
}

#[test]
fn an_iteration_begins_where_the_last_position_was() {
    let compiled = compile(&model(HEADS[1], "show block;")).expect("it is coherent");
    // The loop's unknowns are the direction of the rod, and the displacement of the block.
    assert_eq!(compiled.program.links, ["rod", "block"]);
}

#[test]
fn what_is_left_out_does_not_block() {
    // The arm and the lever do not let the crank turn round; the rod does.
    let [whole, part] = ["", "show block;"]
        .map(|show| compile(&model(HEADS[0], show)).expect("it is coherent").program);
    let goes_round = |program: &Program| {
        let mut machine = Machine::<f64>::new(program);
        (1..=12).all(|twelfth| machine.move_to(&[f64::from(twelfth) * TAU / 12.0, 0.0]).is_ok())
    };
    assert!(!goes_round(&whole));
    assert!(goes_round(&part));
}

#[test]
fn an_accuracy_is_kept_by_what_is_shown() {
    for show in ["", "show block;", "show lever;", "show idle;"] {
        let mut model = model("struct Press; accuracy 1e-3; cost cortex_m4f;", show);
        for motor in &mut model.motors {
            motor.step = Some(0.01);
        }
        let compiled = compile(&model).expect("it is accurate enough");
        let error = compiled.prediction.expect("a prediction").error;
        assert!(error <= 1e-3, "{show} {error}");
    }
}

#[test]
fn a_range_is_proved_of_what_is_shown() {
    let ranged = |show: &str| {
        let mut model = model(HEADS[0], show);
        for motor in &mut model.motors {
            motor.range = Some(Range { low: 0.0, high: TAU, origin: motor.origin });
        }
        compile(&model)
    };
    assert!(ranged("").is_err(), "the lever stops the crank");
    assert!(ranged("show block;").is_ok());
    assert!(ranged("show crank;").is_ok());
}
