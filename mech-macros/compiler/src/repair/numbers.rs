//! Numbers of the text that may be meant otherwise: lengths with which a loop does not close, and places that were copied.

use super::guess::{apex, handy};
use super::sketch::{Sketch, distance};
use super::tie::ties;
use super::trial::Trials;
use super::{NewNumbers, Repair};
use crate::model::{JointId, LinkId, Ratio};
use crate::structure::{Diagnosis, MeshTrouble};
use crate::syntax::StatementText;
use std::ops::Range;

/// If no slip of a hand explains it, lengths are made so many times as long, the least change first.
const SCALES: [f64; 10] = [1.25, 0.8, 1.5, 0.65, 2.0, 0.5, 3.0, 0.3, 5.0, 0.2];

impl NewNumbers {
    fn moved(&self, at: [f64; 2]) -> Repair {
        Repair::Numbers(Self { new: format!("({}, {})", at[0], at[1]), ..self.clone() })
    }
}

/// A number of the text on which the size or the place of a link depends.
struct Number {
    tokens: Range<usize>,
    written: String,
    value: f64,
    statement: String,
}

impl Number {
    fn replaced(&self, value: f64) -> Repair {
        Repair::Numbers(NewNumbers {
            tokens: self.tokens.clone(),
            old: self.written.clone(),
            new: value.to_string(),
            statement: self.statement.clone(),
        })
    }
}

/// Other numbers with which nothing is wrong.
pub(super) fn numbers(trials: &mut Trials<'_>, of: &Diagnosis) -> Vec<Repair> {
    let changes = match of {
        Diagnosis::CannotClose { unknowns, .. } => return lengths(trials, unknowns),
        // What was declared last is the likelier slip.
        Diagnosis::OnOnePin { joints, .. } => places(trials, joints.iter().rev().copied()),
        Diagnosis::DeadStart { .. } => places(trials, copies(trials).into_iter()),
        Diagnosis::NoMesh {
            joint,
            carrier,
            ratio,
            trouble: MeshTrouble::OneShaft | MeshTrouble::Distance { .. },
        } => in_mesh(trials, *joint, *carrier, *ratio),
        _ => return Vec::new(),
    };
    trials.first_that_mend(changes.into_iter())
}

/// A point in the wrong decimal place or with the wrong sign is a slip, the likelier the more its number is like the others afterwards.
/// Where that explains nothing, the least change of one length.
fn lengths(trials: &mut Trials<'_>, unknowns: &[JointId]) -> Vec<Repair> {
    let numbers = numbers_of(trials, unknowns);
    let usual = usual(&numbers);
    let mut slips: Vec<(f64, Repair)> = numbers
        .iter()
        .flat_map(|number| {
            let unlike = |value: f64| (value.abs() / usual).ln().abs();
            let changes = [0.1, 10.0, -1.0].into_iter();
            let changes = changes.map(|factor| tidy(number.value * factor));
            let likely = changes.filter(move |value| unlike(*value) <= unlike(number.value));
            likely.map(move |value| (unlike(value), number.replaced(value)))
        })
        .collect();
    slips.sort_by(|a, b| a.0.total_cmp(&b.0));
    let found = trials.first_that_mend(slips.into_iter().map(|slip| slip.1));
    if !found.is_empty() {
        return found;
    }
    let scaled = SCALES.iter().flat_map(|scale| {
        let numbers = numbers.iter();
        numbers.map(move |number| number.replaced(handy(number.value * scale, number.value.abs())))
    });
    trials.first_that_mend(scaled)
}

/// The median of the sizes.
fn usual(numbers: &[Number]) -> f64 {
    let mut sizes: Vec<f64> = numbers.iter().map(|number| number.value.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    sizes.get(sizes.len() / 2).copied().unwrap_or(1.0)
}

/// Without the digits that multiplying adds.
fn tidy(value: f64) -> f64 {
    const DIGITS: usize = 12;
    format!("{value:.DIGITS$e}").parse().unwrap_or(value)
}

/// The numbers in the places of the links of a loop, and in constants.
fn numbers_of(trials: &Trials<'_>, unknowns: &[JointId]) -> Vec<Number> {
    let model = trials.model;
    let links = unknowns.iter().flat_map(|&joint| <[LinkId; 2]>::from(model.ends(joint)));
    let names: Vec<&str> = links.map(|link| &*model.link(link).name).collect();
    let mut numbers = Vec::new();
    for statement in trials.tokens().statements() {
        let (name, _) = statement.path(1);
        match statement.word(0) {
            "const" => numbers.extend(numbers_in(&statement, &format!("const {name}"))),
            "ground" => numbers.extend(numbers_of_places(&statement, "ground")),
            "link" if names.contains(&&*name) => {
                numbers.extend(numbers_of_places(&statement, &format!("link {name}")));
            }
            _ => {}
        }
    }
    numbers
}

/// The numbers in the points and lines that a link declares.
fn numbers_of_places(link: &StatementText<'_>, name: &str) -> Vec<Number> {
    let clauses = link.clauses().into_iter();
    let places = clauses.filter(|clause| clause.is("point") || clause.is("line"));
    places.flat_map(|place| numbers_in(&place, name)).collect()
}

/// The lengths that stand in a text as numbers, with their signs.
fn numbers_in(text: &StatementText<'_>, statement: &str) -> Vec<Number> {
    let number = |index: usize| {
        let value: f64 = text.word(index).parse().ok()?;
        let before = index.checked_sub(1).map_or("", |before| text.word(before));
        let is_sign = before == "-" && index > 1 && ["(", ",", "="].contains(&text.word(index - 2));
        // A factor, or the number of a link, is no length.
        let is_whole = is_sign || ["(", ",", "="].contains(&before);
        let is_ended = [")", ",", ";"].contains(&text.word(index + 1));
        let is_length = value.is_finite() && value != 0.0 && is_whole && is_ended;
        is_length.then(|| Number {
            tokens: text.token(index - usize::from(is_sign))..text.token(index + 1),
            written: [if is_sign { "-" } else { "" }, text.word(index)].concat(),
            value: if is_sign { -value } else { value },
            statement: statement.to_owned(),
        })
    };
    (0..text.len()).filter_map(number).collect()
}

/// Other places for joints: over the middle between others of their links, or where what they join slides.
fn places(trials: &Trials<'_>, joints: impl Iterator<Item = JointId>) -> Vec<Repair> {
    let model = trials.model;
    let (ties, sketch) = (ties(model), Sketch::of(model));
    let mut changes = Vec::new();
    for joint in joints {
        let Some((old, here)) = place_of(trials, joint) else {
            continue;
        };
        let (a, b) = model.ends(joint);
        let [first, second] = [a, b].map(|link| {
            let others = ties.iter().filter(move |tie| tie.has(link));
            others.filter(|tie| !sketch.is_same(tie.at, here)).collect::<Vec<_>>()
        });
        let slides = first.iter().chain(&second).filter(|tie| tie.along().is_some());
        let slides = slides.map(|tie| tie.at.map(|part| handy(part, distance(tie.at, here))));
        let between =
            first.iter().flat_map(|one| second.iter().map(|other| apex(one.at, other.at)));
        let beside = first.iter().chain(&second).map(|tie| apex(here, tie.at));
        changes.extend(slides.chain(between).chain(beside).map(|at| old.moved(at)));
    }
    changes
}

/// Places for the shaft of two wheels that was declared last where they touch each other.
fn in_mesh(trials: &Trials<'_>, gear: JointId, carrier: LinkId, ratio: Ratio) -> Vec<Repair> {
    let model = trials.model;
    let asked = match ratio {
        Ratio::Radii(a, b) => (a + b).abs(),
        // Of teeth nothing says how large they are.
        Ratio::Teeth(..) => {
            let size = Sketch::of(model).size;
            handy(if size > 0.0 { 0.5 * size } else { 1.0 }, size)
        }
    };
    let (a, b) = model.ends(gear);
    let shafts: Vec<JointId> = model
        .declared_joints()
        .filter(|&joint| {
            let ends = <[LinkId; 2]>::from(model.ends(joint));
            ends.contains(&carrier) && (ends.contains(&a) || ends.contains(&b))
        })
        .collect();
    let places: Vec<_> = shafts.into_iter().filter_map(|joint| place_of(trials, joint)).collect();
    let [(_, from), (last, to)] = &places[..] else {
        return Vec::new();
    };
    let away = distance(*from, *to);
    let along = if away == 0.0 {
        vec![[1.0, 0.0], [-1.0, 0.0]]
    } else {
        vec![[0, 1].map(|part| (to[part] - from[part]) / away)]
    };
    let place = |along: [f64; 2]| [0, 1].map(|part| tidy(from[part] + asked * along[part]));
    let places = along.into_iter().map(place);
    places.map(|at| last.moved(at)).collect()
}

/// The joints with the same place as the joint in the line above, the last first.
fn copies(trials: &Trials<'_>) -> Vec<JointId> {
    let joints: Vec<JointId> = trials.model.declared_joints().collect();
    let place = |joint: JointId| place_of(trials, joint).map(|(_, at)| at);
    let pairs = joints.windows(2).rev();
    let copies = pairs.filter(|pair| place(pair[1]).is_some_and(|at| place(pair[0]) == Some(at)));
    copies.map(|pair| pair[1]).collect()
}

/// The brackets after the word `at` of a joint, as far as two numbers stand there.
fn place_of(trials: &Trials<'_>, joint: JointId) -> Option<(NewNumbers, [f64; 2])> {
    let name = &*trials.model.joint(joint).name;
    let mut statements = trials.tokens().statements().into_iter();
    let statement = statements.find(|one| one.declares("joint", name))?;
    let open = statement.find("at")? + 1;
    let close = (open..statement.len()).find(|&index| statement.word(index) == ")")?;
    let words: Vec<&str> = (open..=close).map(|index| statement.word(index)).collect();
    let old = words.concat().replace(',', ", ");
    let [x, y] = old.strip_prefix('(')?.strip_suffix(')')?.split(", ").collect::<Vec<_>>()[..]
    else {
        return None;
    };
    let at = [x.parse().ok()?, y.parse().ok()?];
    let numbers = NewNumbers {
        tokens: statement.token(open)..statement.token(close + 1),
        new: old.clone(),
        old,
        statement: format!("joint {name}"),
    };
    Some((numbers, at))
}
