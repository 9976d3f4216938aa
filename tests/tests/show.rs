//! `show`: only what is asked for is computed, and that to the same bits.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{LinkId, Method, Model, Shown};
use mech_compiler::plan::{Plan, Source, Step};
use mech_compiler::program::{BlockKind, Op, Program, Slot, Value, build};
use mech_tests::{Dice, grow};
use std::collections::BTreeSet;

fn cases() -> u64 {
    std::env::var("MECH_CASES")
        .ok()
        .and_then(|cases| cases.parse().ok())
        .unwrap_or(1_500)
}

/// A random mechanism, solved by this method, and its plan.
fn case(dice: &mut Dice, method: Method) -> Option<(Model, Plan)> {
    let additions = 1 + dice.below(9);
    let mut model = grow(dice, additions).model;
    model.method = Some(method);
    let plan = compile(&model).ok()?.plan;
    Some((model, plan))
}

fn showing(model: &Model, shown: Vec<Shown>) -> Model {
    Model {
        show: Some(shown),
        ..model.clone()
    }
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
            links: (0..model.links.len())
                .map(|link| (link, BTreeSet::new()))
                .collect(),
            sources: vec![None; plan.sources.len()],
        };
        let mut loops = 0..;
        for step in &plan.steps {
            let (connections, parts, closed) = match step {
                Step::Weld(connection) => (vec![*connection], Vec::new(), None),
                Step::Drive(drive) => (vec![drive.connection], Vec::new(), None),
                Step::Mesh(mesh) => (vec![mesh.connection], mesh.parts.clone(), None),
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
            Source::Way(joint) => {
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
fn reached(program: &Program, link: LinkId) -> BTreeSet<usize> {
    let place = program.place_of(link).expect("the whole keeps all");
    let mut waiting: Vec<Value> = program.poses[place].to_vec();
    let mut seen = vec![false; program.nodes.len()];
    let mut loops = BTreeSet::new();
    while let Some(value) = waiting.pop() {
        if std::mem::replace(&mut seen[value.index()], true) {
            continue;
        }
        let node = program.node(value);
        waiting.extend(node.op.operands());
        match node.op {
            Op::Last(Slot::Pose(link, _)) => waiting.extend(program.poses[link]),
            Op::Last(Slot::Kept(kept)) => waiting.push(program.kept[kept]),
            Op::Solved(block, _) => {
                let newton = program.newton(block).expect("it is iterated");
                loops.insert(newton.number);
                let scalars = newton.scalars.iter();
                waiting.extend(scalars.flat_map(|scalar| [scalar.first, scalar.next]));
            }
            _ => {
                let closed = program.closed(node.block);
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
    for seed in 0..cases() {
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
            assert_eq!(solved, reached(&whole, link), "{what}");
            // The other way, which does not see that a direction is known however far its link slides.
            let carried = Carried::through(&model, &plan).loops(&program.stored);
            assert!(solved.is_subset(&carried), "{what}");
            assert!(program.place_of(link).is_some(), "{what}");
            fewer += usize::from(solved.len() < loops(&whole).len());
            other += usize::from(solved != carried);
        }
    }
    assert!(fewer > 50 * other.min(2), "it is worth it: {fewer}");
    assert!(fewer > 5 * other, "{fewer}, {other}");
}

#[test]
fn what_is_shown_moves_as_in_the_whole_to_the_last_bit() {
    let mut moved = 0;
    for seed in 0..cases() {
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
            if part.is_closed() || part.strides == whole.strides {
                let what = format!("seed {seed} {method:?}");
                moved += same_motion(&mut dice, (&whole, &part), &what);
            }
        }
    }
    assert!(moved > 1_000, "they move");
}

/// Moves a mechanism and a part of it; tells how often that was possible.
fn same_motion(dice: &mut Dice, (whole, part): (&Program, &Program), what: &str) -> usize {
    let mut everything = Machine::<f64>::new(whole);
    let mut shown = Machine::<f64>::new(part);
    let mut moved = 0;
    for _ in 0..20 {
        let reach = *dice.pick(&[0.02, 0.02, 0.3, 3.0]);
        let motors = everything.position().motors.iter();
        let motors: Vec<f64> = motors
            .map(|motor| motor + dice.between(-reach, reach))
            .collect();
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
                let place = program.place_of(*link).expect("it is kept");
                machine.position().poses[place].map(f64::to_bits)
            };
            assert_eq!(pose(whole, &everything), pose(part, &shown), "{what}");
        }
    }
    moved
}
