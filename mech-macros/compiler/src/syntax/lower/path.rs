//! Paths to what is within uses of parts.

use super::name::Referent;
use super::reader::Reader;
use super::scope::UsedPart;
use crate::syntax::ast::{
    BetweenEnds, Effect, End, Expr, Index, LoadOn, Name, Segment, Statement, Text,
};
use crate::syntax::{Noun, Place, spelling};

/// The uses of the mechanism and of each part.
struct UseTable(Vec<Uses>);

/// The uses of the mechanism or of one part.
struct Uses {
    /// The name of the part; none for the mechanism.
    by: Option<String>,
    /// The name of each use, and that of the part it uses.
    parts: Vec<(String, String)>,
}

impl UseTable {
    fn of(text: &Text) -> Self {
        let uses = |body: &[Statement]| {
            let uses = body.iter().filter_map(|statement| match statement {
                Statement::Use(used) => Some((used.name.to_string(), used.part.to_string())),
                _ => None,
            });
            uses.collect()
        };
        let parts = text.statements.iter().filter_map(|statement| match statement {
            Statement::Part(part) => {
                let body = part.body.as_deref().unwrap_or_default();
                Some(Uses { by: Some(part.name.to_string()), parts: uses(body) })
            }
            _ => None,
        });
        let whole = Uses { by: None, parts: uses(&text.statements) };
        Self(std::iter::once(whole).chain(parts).collect())
    }

    /// The part that a use of this name uses, in the mechanism or in a part.
    fn part(&self, scope: Option<&str>, name: &str) -> Option<&str> {
        let uses = self.0.iter().find(|uses| uses.by.as_deref() == scope)?;
        let (_, part) = uses.parts.iter().find(|(known, _)| known == name)?;
        Some(part)
    }

    /// Whether this is a use in the scope to which the path leads.
    fn is_use(&self, scope: Option<&str>, name: &Name) -> bool {
        let mut scope = scope;
        for segment in &name.uses {
            scope = self.part(scope, &segment.name.to_string());
            if scope.is_none() {
                return false;
            }
        }
        self.part(scope, &name.name.to_string()).is_some()
    }
}

/// Finds out where the word before the last is a use of a part: then the last is no axis, but a link or a joint.
pub(super) fn find_uses(text: &mut Text) {
    let table = UseTable::of(text);
    for statement in &mut text.statements {
        if let Statement::Part(part) = statement {
            let scope = part.name.to_string();
            for statement in part.body.iter_mut().flatten() {
                correct(statement, &table, Some(&scope));
            }
        } else {
            correct(statement, &table, None);
        }
    }
}

fn correct(statement: &mut Statement, table: &UseTable, scope: Option<&str>) {
    for end in ends(statement) {
        if end.axis.is_some() && table.is_use(scope, &end.link) {
            let link = end.axis.take();
            let used = link.map(|link| std::mem::replace(&mut end.link.name, link));
            end.link.uses.extend(used.map(|name| Segment { name, index: None }));
        }
    }
}

/// Everything in a statement that may be a link or an axis.
fn ends(statement: &mut Statement) -> Vec<&mut End> {
    match statement {
        Statement::Joint(joint) => match &mut joint.body {
            Ok(body) => {
                let roller = body.roller.iter_mut().map(|roller| &mut roller.point);
                body.ends.iter_mut().chain(roller).collect()
            }
            Err(_) => Vec::new(),
        },
        Statement::Spring(elastic) | Statement::Damper(elastic) => match &mut elastic.body {
            Ok(body) => match &mut body.between {
                BetweenEnds::Points(ends) => ends.iter_mut().collect(),
                BetweenEnds::Joint(_) => Vec::new(),
            },
            Err(_) => Vec::new(),
        },
        Statement::Load(load) => match &mut load.on {
            Ok(LoadOn::Force(end)) => vec![end],
            _ => Vec::new(),
        },
        Statement::Show { what, .. } => what.iter_mut().collect(),
        Statement::Effects { effects, .. } => {
            let traces = effects.iter_mut().filter_map(|effect| match effect {
                Ok(Effect::Trace(trace)) => Some(&mut trace.point),
                _ => None,
            });
            traces.collect()
        }
        _ => Vec::new(),
    }
}

/// A name with the path to its scope; reported if a use on the way is not there.
pub(super) fn key(reader: &mut Reader, name: &Name) -> Option<String> {
    let mut scope = reader.scope;
    let mut every = reader.every.iter();
    for segment in &name.uses {
        let used = used(reader, scope, segment)?;
        let instance = match &segment.index {
            Some(Index::Every(place)) => {
                let Some(&instance) = every.next() else {
                    let text = "`[*]` stands for every instance in `show` and `trace` alone; write a number";
                    return refuse(reader, *place, text.to_owned());
                };
                instance
            }
            Some(Index::At(index)) => instance(reader, used, index)?,
            None => 0,
        };
        scope = used.instances[instance];
    }
    Some(reader.names.scope(scope).key_of(&name.name))
}

/// Whether all words before the last are uses of parts; also where there is no such word.
pub(super) fn is_path(reader: &Reader, name: &Name) -> bool {
    let mut scope = reader.scope;
    name.uses.iter().all(|segment| {
        let used = reader.names.scope(scope).used(&segment.name);
        let first = used.and_then(|used| used.instances.first());
        scope = first.copied().unwrap_or(scope);
        used.is_some()
    })
}

/// The use that is named in a path.
fn used<'r>(reader: &mut Reader<'r>, scope: usize, segment: &Segment) -> Option<&'r UsedPart> {
    let name = &segment.name;
    let scope = reader.names.scope(scope);
    let Some(used) = scope.used(name) else {
        let text = match reader.names.get(&scope.key_of(name)) {
            // Its part is not known, or it has no instances: that was told.
            Some(Referent::Broken | Referent::Use) => return None,
            Some(Referent::Link(_)) => format!("`{name}` is a link, not a use of a part"),
            Some(Referent::Joint(_)) => format!("`{name}` is a joint, not a use of a part"),
            _ => {
                let known = scope.uses.iter().map(|used| used.name.as_str());
                let remedy = spelling::remedy(&name.to_string(), &known.collect::<Vec<_>>());
                let text = format!("`{name}` is not a use of a part{remedy}");
                let key = scope.key_of(name);
                let unknown = reader.names.unknown(Noun::Body, &key);
                let place = Place::at(name.span());
                return reader.report.refuse_unknown(unknown, place, text);
            }
        };
        return refuse(reader, Place::at(name.span()), text);
    };
    let text = match (&segment.index, used.is_array) {
        (None, true) => format!(
            "`{name}` has {} instances; name one of them, as `{name}[0]`",
            used.instances.len()
        ),
        (Some(_), false) => {
            format!("`{name}` is a single instance; write it without brackets")
        }
        _ => return Some(used),
    };
    refuse(reader, Place::at(name.span()), text)
}

/// The number of an instance in brackets.
fn instance(reader: &mut Reader, used: &UsedPart, index: &Expr) -> Option<usize> {
    let value = reader.value(index)?;
    let count = used.instances.len();
    let mut all = 0..count;
    #[expect(clippy::cast_precision_loss, reason = "there are not so many instances")]
    let found = all.find(|&instance| instance as f64 == value);
    if found.is_some() {
        return found;
    }
    let text = format!(
        "`{}` has {count} instances, from `{0}[0]` to `{0}[{}]`; there is no `{0}[{index}]`",
        used.name,
        count - 1
    );
    refuse(reader, index.place, text)
}

/// Reports something, if that was not said of this item before: names are looked up more than once.
fn refuse<T>(reader: &mut Reader, place: Place, text: String) -> Option<T> {
    if !reader.report.has(&text) {
        reader.report.error(place, text);
    }
    None
}

/// The instances that `[*]` stands for in a path: each choice of them.
pub(super) fn choices(reader: &mut Reader, name: &Name) -> Vec<Vec<usize>> {
    let mut choices = Vec::new();
    let scope = reader.scope;
    choose(reader, scope, &name.uses, &mut Vec::new(), &mut choices);
    choices
}

/// The choices of instances for each `[*]` in the remainder of a path; one of nothing if it has none.
fn choose(
    reader: &mut Reader,
    scope: usize,
    uses: &[Segment],
    chosen: &mut Vec<usize>,
    choices: &mut Vec<Vec<usize>>,
) {
    let is_every = |segment: &Segment| matches!(segment.index, Some(Index::Every(_)));
    let Some((segment, remainder)) = uses.split_first().filter(|_| uses.iter().any(is_every))
    else {
        return choices.push(chosen.clone());
    };
    let Some(used) = used(reader, scope, segment) else {
        return;
    };
    match &segment.index {
        Some(Index::Every(_)) => {
            for (number, &instance) in used.instances.iter().enumerate() {
                chosen.push(number);
                choose(reader, instance, remainder, chosen, choices);
                chosen.pop();
            }
        }
        Some(Index::At(index)) => {
            if let Some(instance) = instance(reader, used, index) {
                choose(reader, used.instances[instance], remainder, chosen, choices);
            }
        }
        None => choose(reader, used.instances[0], remainder, chosen, choices),
    }
}
