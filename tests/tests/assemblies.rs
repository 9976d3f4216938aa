//! A mechanism that has several assemblies: one statement settles it, and each of its loops can be turned over by itself.

use mech_compiler::model::{Model, Near, Origin};
use mech_compiler::structure::{Diagnosis, LoopAssembly, OpenLoop};
use mech_compiler::{compile, reporter};
use mech_test_support::{
    Sample, cases, coordinate, driven_on_the_ground, for_all, in_own_frames, model, samples,
};

/// Legs of two loops each, in frames of their own, that one crank moves through gears.
fn legs(count: usize) -> String {
    let shafts = |leg: usize| {
        let [a, d] = [3 * leg, 3 * leg + 2];
        format!("point a{leg} = ({a}, 0); point d{leg} = ({d} - 0.5, -0.5);")
    };
    let ground: String = (0..count).map(shafts).collect();
    let each = |leg: usize| {
        format!(
            "link crank{leg} {{ point a = (0, 0); point b = (0.4, 0); }}
            link rod{leg} {{ point b = (0, 0); point c = (1.4, 0); point e = (1.4, 0.8); }}
            link knee{leg} {{ point d = (0, 0); point c = (1.1, 0); point f = (1, -1); }}
            link shin{leg} {{ point f = (0, 0); point h = (1.2, 0); }}
            link foot{leg} {{ point e = (0, 0); point h = (1.3, 0); }}
            joint ja{leg} = revolute(ground.a{leg}, crank{leg}.a);
            joint jb{leg} = revolute(crank{leg}.b, rod{leg}.b);
            joint jc{leg} = revolute(rod{leg}.c, knee{leg}.c);
            joint jd{leg} = revolute(ground.d{leg}, knee{leg}.d);
            joint jf{leg} = revolute(knee{leg}.f, shin{leg}.f);
            joint je{leg} = revolute(rod{leg}.e, foot{leg}.e);
            joint jh{leg} = revolute(shin{leg}.h, foot{leg}.h);\n"
        )
    };
    let gears = (1..count).map(|leg| {
        format!("joint mesh{leg} = gear(crank{}, crank{leg}, 20 : 20 on ground);\n", leg - 1)
    });
    let parts: String = (0..count).map(each).chain(gears).collect();
    format!("struct Legs;\nground {{ {ground} }}\n{parts}motor ja0;\n")
}

fn message(text: &str) -> String {
    let model = model(text);
    let wrong = compile(&model).expect_err("several assemblies");
    assert_eq!(wrong.len(), 1, "{wrong:?}");
    reporter::text(&wrong[0], &model)
}

/// Everything in backticks of a line.
fn quotes(line: &str) -> Vec<&str> {
    line.split('`').skip(1).step_by(2).collect()
}

#[test]
fn what_is_offered_is_enough() {
    for count in [1, 2, 6] {
        let text = legs(count);
        let messages = message(&text);
        let first = messages.lines().find(|line| line.starts_with("help: ")).expect("help");
        let start = quotes(first)[0].to_owned();
        let all = start.matches(" near ").count();
        assert_eq!(all, 2 * count, "a loop has no clause\n{messages}");
        assert!(compile(&model(&format!("{text}{start}"))).is_ok(), "{messages}");
        // Each loop can be turned over in that statement.
        let others = messages.lines().filter(|line| line.contains("; instead `"));
        let mut turned = 0;
        for line in others {
            let (_, instead) = line.split_once("; instead ").expect("the other one");
            let clause = quotes(instead)[0];
            let link = clause.split(" near ").next().expect("a link");
            let clauses = start.trim_start_matches("start { ").trim_end_matches(" }");
            let clauses = clauses.split_inclusive(';').map(str::trim);
            let changed: Vec<&str> = clauses
                .map(|one| if one.starts_with(&format!("{link} ")) { clause } else { one })
                .collect();
            let text = format!("{text}start {{ {} }}", changed.join(" "));
            assert!(compile(&model(&text)).is_ok(), "{line}\n{messages}");
            turned += 1;
        }
        assert_eq!(turned, if count == 1 { 0 } else { 2 * count }, "{messages}");
    }
}

/// The mechanism with the first assembly of each loop, but another of one.
fn choose(model: &Model, loops: &[OpenLoop], other: Option<(usize, usize)>) -> Model {
    let mut chosen = model.clone();
    for (number, open) in loops.iter().enumerate() {
        let assembly =
            other.map_or(0, |(turned, assembly)| if turned == number { assembly } else { 0 });
        chosen.start.near.push(Near {
            link: open.link,
            angle: open.assemblies[assembly].angle,
            origin: Origin::default(),
        });
    }
    chosen
}

/// How many mechanisms a test tries.
const CASES: u64 = 100;

#[test]
fn each_loop_of_a_random_mechanism_is_named_by_its_joint() {
    let (mut compared, mut open) = (0, 0);
    for_all(CASES, &samples(2..=6), |Sample { grown, mut dice }| {
        // Driven between moving links, one loop may turn the link by which another is named.
        let model = driven_on_the_ground(&grown.model);
        let (mut free, _) = in_own_frames(&model, &mut dice);
        free.start.near.clear();
        let Err(wrong) = compile(&free) else {
            return;
        };
        let [Diagnosis::SeveralAssemblies { loops, .. }] = &wrong[..] else {
            return;
        };
        let choices = loops.iter().enumerate().flat_map(|(number, open)| {
            (0..open.assemblies.len()).map(move |assembly| (number, assembly))
        });
        for (number, assembly) in choices {
            let model = choose(&free, loops, Some((number, assembly)));
            let Ok(compiled) = compile(&model) else {
                // Slides may have two assemblies in one direction: no clause settles these.
                open += 1;
                continue;
            };
            let OpenLoop { joint, ref assemblies, .. } = loops[number];
            let LoopAssembly { coordinate: expected, .. } = assemblies[assembly];
            let mut reversed = model.clone();
            reversed.start.near.reverse();
            let same = compile(&reversed).expect("the order of clauses is free");
            assert_eq!(same.plan.start, compiled.plan.start);
            let (is, turns) = coordinate(&model, &compiled.plan.start.poses, joint);
            let off = if turns { (0.5 * (is - expected)).sin() } else { is - expected };
            assert!(off.abs() < 1e-6, "loop {number}: {is}, expected {expected}");
            compared += 1;
        }
    });
    assert!(3 * compared > 2 * cases(CASES), "only {compared} assemblies");
    assert!(20 * open < compared, "{open} of {compared} assemblies stay open");
}
