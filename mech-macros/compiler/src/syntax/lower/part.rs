//! Parts: each instance is a scope, in which the statements of the part are read.

use super::constant::{Constants, INSTANCE, Value};
use super::draft::Draft;
use super::expansion::{Expansion, locate, parts};
use super::link::errors_of;
use super::name::Referent;
use super::quantity::Quantity;
use super::reader::{Located, Reader};
use super::report::{Report, StatementPlace};
use super::scope::{Scope, UsedPart};
use super::similarity::Similarity;
use super::single::Single;
use super::unknown::Unknown;
use super::{joint, link};
use crate::model::Instance;
use crate::syntax::ast::{Constant, Effect, Link, Part, Port, Statement, Text, Use};
use crate::syntax::limits::Limit;
use crate::syntax::{Message, Noun, Place, spelling};
use proc_macro2::Ident;

impl<'t> Expansion<'t> {
    /// Enters everything that has a name, and gives the statements of the mechanism and of all instances.
    pub(super) fn declare_all(&mut self) -> Vec<Located<'t>> {
        check_parts(self.text, &mut self.report);
        // The next is the last.
        let mut waiting: Vec<_> = locate(&self.text.statements, 0, None).rev().collect();
        let mut statements = Vec::new();
        let mut motors = 0;
        while let Some(mut located) = waiting.pop() {
            self.enter(&located);
            motors += usize::from(matches!(located.statement, Statement::Motor(_)));
            let scope = self.names.scopes.get_mut(located.scope);
            if let Some((place, text)) = misplacement(scope, located.statement) {
                self.report.error(place, text);
                continue;
            }
            if let Some(single) = Single::of(located.statement) {
                single.check(scope, &mut self.report);
            }
            located.is_named = self.declare(&located);
            if let Statement::Use(used) = located.statement {
                let inner = self.instantiate(&located, used);
                waiting.extend(inner.into_iter().flatten().rev());
            }
            let counts = [
                (Limit::Links, self.draft.model.links.len() - 1),
                (Limit::Motors, motors),
                (Limit::Instances, self.names.scopes.len() - 1),
                (Limit::Copies, statements.len() + waiting.len()),
            ];
            let beyond = counts.iter().find(|(limit, count)| *count > limit.most());
            if let Some(((limit, _), place)) = beyond.zip(place_of(located.statement)) {
                // What else is wrong with so large a mechanism is told when it is smaller.
                self.report = Report::default();
                self.enter(&located);
                self.report.error(place, limit.to_string());
                return Vec::new();
            }
            statements.push(located);
        }
        check_unused(self.text, &statements, &mut self.report);
        statements
    }

    /// Enters what has a name: whether it can have it.
    fn declare(&mut self, located: &Located) -> bool {
        let scope = located.scope;
        let (mut reader, draft) = self.read(scope);
        let (name, referent) = match located.statement {
            Statement::Link(link) => (&link.name, link::declare(&mut reader, draft, link)),
            Statement::Joint(joint) => (&joint.name, joint::declare(&mut reader, draft, joint)),
            Statement::Use(used) => (&used.name, declare_use(&mut reader, draft, used)),
            Statement::Broken(broken) => {
                reader.report.pass_on(broken.error.clone());
                draft.lose(&broken.names);
                let keys: Vec<String> =
                    broken.names.iter().map(|name| reader.key_of(name)).collect();
                for key in keys {
                    self.names.enter(key, Referent::Broken);
                }
                return false;
            }
            Statement::Ground(ground) => {
                link::declare_ground(&mut reader, draft, ground);
                return true;
            }
            Statement::Constant(constant) => {
                self.declare_constant(constant, scope);
                return true;
            }
            Statement::Param(param) => {
                self.declare_param(param, scope);
                return true;
            }
            _ => return true,
        };
        let key = reader.key_of(name);
        if let Statement::Joint(joint) = located.statement
            && joint::is_cam(joint)
        {
            self.names.cams.push(key.clone());
        }
        if let Referent::Link(_) = referent {
            self.names.link_scopes.push(scope);
        }
        self.names.enter(key, referent);
        !matches!(referent, Referent::Broken)
    }

    fn declare_constant(&mut self, constant: &Constant, scope: usize) {
        let value = self.report.read(&constant.value);
        let value = value.map_or(Value::default(), |expr| self.read(scope).0.both(expr));
        let constants = &mut self.names.scopes.get_mut(scope).constants;
        constants.declare(&constant.name, value, "constant", &mut self.report);
    }

    /// Makes the instances of a use, and gives the statements of its part in each.
    fn instantiate(&mut self, located: &Located, used: &Use) -> Option<Vec<Located<'t>>> {
        let (text, scope) = (self.text, located.scope);
        let (mut reader, _) = self.read(scope);
        let count = count(&mut reader, used);
        let (outer, part) = find_part(&mut reader, text, &used.part)?;
        let count = count.filter(|_| located.is_named)?;
        let own = own_similarity(&mut reader, used)?;
        let frame = reader.frame;
        let similarity = reader.compose(&frame, &own, Place::at(used.name.span()))?;
        let mut known = UsedPart {
            name: used.name.to_string(),
            is_array: used.count.is_some(),
            own,
            instances: Vec::new(),
        };
        let said = self.report.len();
        let body = part.body.as_deref().unwrap_or_default();
        if count * body.len() > Limit::Copies.most() {
            let place = Place::at(used.name.span());
            return self.report.refuse(place, Limit::Copies.to_string());
        }
        for instance in 0..count {
            let index = known.is_array.then_some(instance);
            // Errors in the numbers of the first instance are in those of all.
            let numbers = if self.report.len() == said {
                let (mut reader, _) = self.read(scope);
                reader.passing.instance = index;
                arguments(&mut reader, used, part)
            } else {
                vec![Some(Value::default()); part.parameters.len()]
            };
            let mut path = used.name.to_string();
            path.extend(index.map(|index| format!("[{index}]")));
            let scopes = &mut self.names.scopes;
            let instance = scopes.add(scope, &path, &part.name.to_string(), Constants::of(body));
            known.instances.push(instance);
            let own = scopes.get_mut(instance);
            own.similarity = similarity;
            self.draft.model.instances.push(Instance {
                name: used.name.to_string(),
                index,
                part: part.name.to_string(),
                path: own.instance().unwrap_or_default(),
                parent: scope.checked_sub(1),
            });
            self.give_numbers(part, numbers, instance);
        }
        let instances = known.instances.iter();
        let statements = instances.flat_map(|&scope| locate(body, scope, Some(outer)));
        let statements = statements.collect();
        self.names.scopes.get_mut(scope).uses.push(known);
        Some(statements)
    }

    /// Gives the numbers of an instance their values: those of its use, or else those of the part.
    fn give_numbers(&mut self, part: &Part, values: Vec<Option<Value>>, instance: usize) {
        for (parameter, value) in part.parameters.iter().zip(values) {
            let value = value.unwrap_or_else(|| match &parameter.value {
                Ok(expr) => self.read(instance).0.both(expr),
                Err(_) => Value::default(),
            });
            let name = &parameter.name;
            let constants = &mut self.names.scopes.get_mut(instance).constants;
            if !constants.give(name, value) {
                let text = format!("there is a number `{name}` already; choose another name");
                if !self.report.has(&text) {
                    self.report.error(Place::at(name.span()), text);
                }
            }
        }
    }
}

/// The place of a statement that makes a mechanism larger.
fn place_of(statement: &Statement) -> Option<Place> {
    Some(match statement {
        Statement::Link(link) => Place::at(link.name.span()),
        Statement::Joint(joint) => Place::at(joint.name.span()),
        Statement::Use(used) => Place::at(used.name.span()),
        Statement::Motor(motor) => motor.joint.place(),
        _ => return None,
    })
}

/// Complains about parts of which no use is to be made.
fn check_parts(text: &Text, report: &mut Report) {
    for (number, part) in parts(text) {
        report.enter(StatementPlace::of_mechanism(number), None);
        let name = &part.name;
        if parts(text).any(|(earlier, part)| earlier < number && part.name == *name) {
            let text = format!("there is a part `{name}` already; choose another name");
            report.error(Place::at(name.span()), text);
        }
        for parameter in &part.parameters {
            report.read(&parameter.value);
        }
        report.read(&part.body);
    }
}

/// Of parts that nothing uses, at least what could not be read is reported.
fn check_unused(text: &Text, statements: &[Located], report: &mut Report) {
    for (outer, part) in parts(text) {
        let is_within = |place: StatementPlace| place.outer == outer && place.inner.is_some();
        if statements.iter().any(|located| is_within(located.place)) {
            continue;
        }
        for (inner, statement) in (1..).zip(part.body.iter().flatten()) {
            let inner = Some(inner);
            report.enter(StatementPlace { outer, inner }, None);
            for error in unread(statement) {
                report.pass_on(error.clone());
            }
        }
    }
}

/// Declares a use and returns its referent.
fn declare_use(reader: &mut Reader, draft: &mut Draft, used: &Use) -> Referent {
    let name = &used.name;
    let method = format!("{}_mut", reader.key_of(name));
    let owner = format!("changing `{name}`");
    let place = Place::at(name.span());
    let claims = &mut draft.claims;
    if claims.take_name(reader, name, "use") && claims.take(method, owner, place, reader.report) {
        Referent::Use
    } else {
        Referent::Broken
    }
}

/// Returns the message about a statement that does not belong into this scope.
fn misplacement(scope: &Scope, statement: &Statement) -> Option<(Place, String)> {
    let Some(part) = &scope.part else {
        return match statement {
            Statement::Port(port) => {
                let text = "only a part has ports; write `link` here, or move this into a `part`";
                Some((Place::at(port.name.span()), text.to_owned()))
            }
            _ => None,
        };
    };
    let whole = |keyword, word: &str| {
        let text = format!("`{word}` belongs to the whole mechanism; move it out of part `{part}`");
        Some((Place::at(keyword), text))
    };
    match statement {
        Statement::Motor(motor) => {
            let joint = &motor.joint;
            let text = format!(
                "a part has no motor of its own; write `motor name.{joint};` where the part is used as `name`"
            );
            Some((joint.place(), text))
        }
        Statement::Ground(ground) => {
            let text = "a part has no ground of its own; declare `port frame { ... }`, and lend it `ground` where the part is used";
            Some((Place::at(ground.keyword), text.to_owned()))
        }
        Statement::Part(inner) => {
            let text =
                format!("parts stand beside one another; move `{}` out of `{part}`", inner.name);
            Some((Place::at(inner.name.span()), text))
        }
        Statement::Allow(word) => whole(word.span(), "allow"),
        Statement::Effects { effects, .. } => effects.iter().find_map(|effect| match effect {
            Ok(Effect::Plain(effect)) => whole(effect.span(), &effect.to_string()),
            _ => None,
        }),
        _ => {
            let single = Single::of(statement).filter(|single| single.is_whole)?;
            whole(single.keyword, single.word)
        }
    }
}

/// Returns the number of instances of a use.
fn count(reader: &mut Reader, used: &Use) -> Option<usize> {
    let Some((count, place)) = &used.count else {
        return Some(1);
    };
    if reader.constants().has(INSTANCE) {
        let text = format!(
            "`{INSTANCE}` is the number of an instance here; choose another name for the constant `{INSTANCE}`"
        );
        reader.report.error(*place, text);
    }
    let most = i32::try_from(Limit::Instances.most()).unwrap_or(i32::MAX);
    let count = reader.whole(count, "the number of instances", [1, most])?;
    usize::try_from(count).ok()
}

fn find_part<'t>(reader: &mut Reader, text: &'t Text, name: &Ident) -> Option<(usize, &'t Part)> {
    let word = name.to_string();
    let trouble = match parts(text).find(|(_, part)| part.name == *name) {
        Some(_) if reader.names.scopes.is_within(reader.scope, &word) => {
            format!("part `{word}` uses itself; it would never end")
        }
        Some(found) => return Some(found),
        None if matches!(reader.names.get(&word), Some(Referent::Broken)) => return None,
        None => {
            let known: Vec<String> = parts(text).map(|(_, part)| part.name.to_string()).collect();
            let known: Vec<&str> = known.iter().map(String::as_str).collect();
            let remedy = match known.as_slice() {
                [] => format!("; declare `part {word} {{ ... }}` in the mechanism"),
                known => spelling::remedy(&word, known),
            };
            let text = format!("unknown part `{word}`{remedy}");
            let unknown = Unknown::new(Noun::Part, None, name);
            return reader.report.refuse_unknown(unknown, Place::at(name.span()), text);
        }
    };
    reader.report.refuse(Place::at(name.span()), trouble)
}

/// Returns the similarity by which a use mirrors and scales an instance.
fn own_similarity(reader: &mut Reader, used: &Use) -> Option<Similarity> {
    let mut own = Similarity::IDENTITY;
    own.is_mirrored = used.mirrored.is_some();
    if let Some(scaled) = &used.scaled {
        let (value, formula) = reader.length(scaled, "a scale")?;
        own.scale = Quantity { value: Some(value), formula };
    }
    Some(own)
}

/// The values of the numbers of an instance, as far as its use gives them.
fn arguments(reader: &mut Reader, used: &Use, part: &Part) -> Vec<Option<Value>> {
    let mut values: Vec<Option<_>> = part.parameters.iter().map(|_| None).collect();
    for argument in &used.arguments {
        let name = &argument.name;
        let value = match reader.report.read(&argument.value) {
            Some(expr) => reader.both(expr),
            None => Value::default(),
        };
        let found = part.parameters.iter().position(|known| known.name == *name);
        let trouble = match found {
            Some(index) if values[index].is_some() => {
                format!("`{name}` is given twice; remove one of the two")
            }
            Some(index) => {
                values[index] = Some(value);
                continue;
            }
            None if part.body.is_err() => continue,
            None => {
                let known: Vec<String> =
                    part.parameters.iter().map(|known| known.name.to_string()).collect();
                let known: Vec<&str> = known.iter().map(String::as_str).collect();
                let part = part.name.to_string();
                let text = format!(
                    "part `{part}` has no number `{name}`{}",
                    spelling::remedy(&name.to_string(), &known)
                );
                let unknown = Unknown::new(Noun::Number, Some(part), name);
                let place = Place::at(name.span());
                reader.report.refuse_unknown::<()>(unknown, place, text);
                continue;
            }
        };
        reader.report.error(Place::at(name.span()), trouble);
    }
    values
}

/// Returns the messages about parts of a statement that could not be read.
fn unread(statement: &Statement) -> Vec<&Message> {
    match statement {
        Statement::Broken(broken) => vec![&broken.error],
        Statement::Link(Link { items, .. }) | Statement::Port(Port { items, .. }) => {
            errors_of(items)
        }
        Statement::Joint(joint) => joint.body.as_ref().err().into_iter().collect(),
        Statement::Constant(constant) | Statement::Param(constant) => {
            constant.value.as_ref().err().into_iter().collect()
        }
        Statement::Spring(elastic) | Statement::Damper(elastic) => {
            elastic.body.as_ref().err().into_iter().collect()
        }
        Statement::Load(load) => load.on.as_ref().err().into_iter().collect(),
        Statement::Start(start) => {
            let clauses = start.clauses.iter();
            clauses.filter_map(|clause| clause.as_ref().err()).collect()
        }
        _ => Vec::new(),
    }
}
