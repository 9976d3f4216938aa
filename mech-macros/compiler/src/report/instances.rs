//! The report's lines about instances of parts: what all of them have alike is said once.

use crate::model::{JointId, Model};
use crate::motion::accuracy::SolvedLoop;
use crate::plan::{Loop, Plan};
use std::collections::BTreeMap;

/// The lines about the parts that the mechanism itself uses: how many instances there are, and what they have.
pub(super) fn part_lines(model: &Model, plan: &Plan, loops: &[SolvedLoop]) -> Vec<String> {
    let owners: Vec<Option<usize>> = plan
        .loops()
        .map(|closing| owner(model, closing).map(|instance| root(model, instance)))
        .collect();
    let mut parts: Vec<(&str, Vec<usize>)> = Vec::new();
    for (number, instance) in model.instances.iter().enumerate() {
        if instance.parent.is_some() {
            continue;
        }
        match parts.iter_mut().find(|(part, _)| *part == instance.part) {
            Some((_, instances)) => instances.push(number),
            None => parts.push((&instance.part, vec![number])),
        }
    }
    let line = |(part, instances): (&str, Vec<usize>)| {
        let of = |instance: usize| {
            let owners = owners.iter().enumerate();
            owners.filter(move |(_, owner)| **owner == Some(instance)).map(|(number, _)| number)
        };
        let counts: Vec<usize> = instances.iter().map(|&instance| of(instance).count()).collect();
        let (least, most) = (counts.iter().min(), counts.iter().max());
        let count = match (least, most) {
            (Some(0), Some(0)) | (None, _) | (_, None) => "no loops".to_owned(),
            (Some(1), Some(1)) => "1 loop each".to_owned(),
            (Some(least), Some(most)) if least == most => format!("{least} loops each"),
            (Some(least), Some(most)) => format!("{least} to {most} loops each"),
        };
        let numbers = instances.iter().flat_map(|&instance| of(instance));
        let solved =
            numbers.filter_map(|number| loops.iter().find(|solved| solved.number == number));
        let mut methods: Vec<String> = solved.map(|solved| solved.method.clone()).collect();
        methods.sort_unstable();
        methods.dedup();
        let methods = methods.iter().map(|method| format!(", {method}"));
        format!("{} × {part}: {count}{}", instances.len(), methods.collect::<String>())
    };
    parts.into_iter().map(line).collect()
}

/// Whether a loop is described already: by that of the first instance of the same use.
pub(super) fn is_described(model: &Model, closing: &Loop) -> bool {
    owner(model, closing).is_some_and(|instance| {
        let chain = std::iter::successors(Some(instance), |&number| model.instances[number].parent);
        let mut chain = chain.filter_map(|number| model.instances[number].index);
        chain.any(|index| index > 0)
    })
}

/// The innermost instance to which all unknown joints of a loop belong, if there is one.
fn owner(model: &Model, closing: &Loop) -> Option<usize> {
    let unknowns = closing.unknowns();
    let has_all = |path: &str| {
        unknowns.iter().all(|&joint| {
            let name = model.joint(joint).name.strip_prefix(path);
            name.is_some_and(|name| name.starts_with('.'))
        })
    };
    let owners =
        (0..model.instances.len()).filter(|&number| has_all(&model.instances[number].path));
    owners.max_by_key(|&number| model.instances[number].path.len())
}

/// The instance in the mechanism itself that contains this one.
fn root(model: &Model, instance: usize) -> usize {
    let chain = std::iter::successors(Some(instance), |&number| model.instances[number].parent);
    chain.last().unwrap_or(instance)
}

/// The names of joints; those that all instances of a use have once, with `[*]`.
pub(super) fn joint_names(model: &Model, ids: &[JointId]) -> Vec<String> {
    let names = ids.iter().map(|&id| model.joint(id).name.as_str());
    let mut names: Vec<&str> = names.collect();
    // A slot is two joints of one name.
    names.dedup();
    let mut instances: BTreeMap<String, usize> = BTreeMap::new();
    for instance in &model.instances {
        *instances.entry(pattern(&instance.path)).or_default() += 1;
    }
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for name in &names {
        *counts.entry(pattern(name)).or_default() += 1;
    }
    let mut shown: Vec<String> = Vec::new();
    for name in names {
        let all = pattern(name);
        let of = all.rsplit_once('.').and_then(|(scope, _)| instances.get(scope));
        if of.is_some_and(|&of| of > 1 && counts.get(&all) == Some(&of)) {
            if !shown.contains(&all) {
                shown.push(all);
            }
        } else {
            shown.push(name.to_owned());
        }
    }
    shown
}

/// Lines about joints. Lines that differ only in the number of an instance become one, with `[*]` and the count.
pub(super) fn alike(lines: &[String]) -> Vec<String> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for line in lines {
        *counts.entry(pattern(line)).or_default() += 1;
    }
    let shown = lines.iter().filter_map(|line| {
        let all = pattern(line);
        match counts.remove(&all)? {
            1 => Some(line.clone()),
            count => Some(format!("{count} × {all}")),
        }
    });
    shown.collect()
}

/// A path with `[*]` for every number in brackets.
fn pattern(path: &str) -> String {
    let mut pieces = path.split('[');
    let mut pattern = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let after = piece.split_once(']').map_or("", |(_, after)| after);
        pattern += &format!("[*]{after}");
    }
    pattern
}
