//! Parts: each instance is a scope, in which the statements of the part are read.

use super::Lowering;
use super::constant::{Constants, INSTANCE};
use super::link::error_of;
use super::name::Referent;
use super::param::Quantity;
use super::port::PartOutline;
use super::report::StatementPlace;
use super::scope::UsedPart;
use super::similarity::Similarity;
use crate::bug::bug;
use crate::model::{Instance, JointId, JointKind};
use crate::syntax::ast::{Effect, Link, Part, Port, Statement, Text, Use};
use crate::syntax::{Message, Place, spelling};

/// The value of a number of a part, and the same as an integer if it is computed from integers alone.
type Given = (Option<Quantity>, Option<i64>);

/// No mechanism has more instances of parts than this.
const MOST_SCOPES: usize = 4096;

/// A statement in one of the scopes in which it is read.
pub(super) struct Located<'t> {
    pub(super) scope: usize,
    pub(super) place: StatementPlace,
    pub(super) statement: &'t Statement,
}

/// The statements as they are read, and the parts that they may use.
pub(super) struct Expansion<'t> {
    /// Each with the number of its statement.
    parts: Vec<(usize, &'t Part)>,
    statements: Vec<Located<'t>>,
}

impl<'t> Expansion<'t> {
    fn part(&self, name: &str) -> Option<(usize, &'t Part)> {
        let mut parts = self.parts.iter();
        parts.find(|(_, part)| part.name == name).copied()
    }
}

impl Lowering {
    /// From now on this statement is read, in this scope.
    pub(super) fn enter(&mut self, scope: usize, place: StatementPlace) {
        self.scopes.enter(scope);
        let here = self.scopes.here();
        self.similarity = here.similarity;
        let instance = here
            .part
            .as_ref()
            .map(|_| here.prefix.trim_end_matches('.'));
        self.report.enter(place, instance.map(str::to_owned));
    }

    /// Enters everything that has a name, and gives the statements of each instance of a part.
    pub(super) fn expand<'t>(&mut self, text: &'t Text) -> Vec<Located<'t>> {
        let mut expansion = Expansion {
            parts: Vec::new(),
            statements: Vec::new(),
        };
        for (number, statement) in (1..).zip(&text.statements) {
            if let Statement::Part(part) = statement {
                let outer = StatementPlace::of_mechanism(number);
                self.enter(0, outer);
                self.check_part(part, &expansion);
                self.parts.push(PartOutline::new(part));
                expansion.parts.push((number, part));
            }
        }
        for (number, statement) in (1..).zip(&text.statements) {
            let place = StatementPlace::of_mechanism(number);
            self.expand_statement(
                &mut expansion,
                Located {
                    scope: 0,
                    place,
                    statement,
                },
            );
        }
        self.check_unused(&expansion);
        expansion.statements
    }

    /// Complains about a part of which no use is to be made.
    fn check_part(&mut self, part: &Part, expansion: &Expansion) {
        let name = &part.name;
        if expansion.part(&name.to_string()).is_some() {
            let text = format!("there is a part `{name}` already; choose another name");
            self.report.error(Place::at(name.span()), text);
        }
        if let Err(error) = &part.body {
            self.report.pass_on(error.clone());
        }
    }

    /// Of parts that nothing uses, at least what could not be read is reported.
    fn check_unused(&mut self, expansion: &Expansion) {
        for (number, part) in &expansion.parts {
            let is_used = expansion
                .statements
                .iter()
                .any(|located| located.place.outer == *number && located.place.inner.is_some());
            let body = part.body.iter().flatten();
            for (inner, statement) in (1..).zip(body.filter(|_| !is_used)) {
                self.enter(
                    0,
                    StatementPlace {
                        outer: *number,
                        inner: Some(inner),
                    },
                );
                for error in unread(statement) {
                    self.report.pass_on(error.clone());
                }
            }
        }
    }

    fn expand_statement<'t>(&mut self, expansion: &mut Expansion<'t>, located: Located<'t>) {
        let Located {
            scope,
            place,
            statement,
        } = located;
        self.enter(scope, place);
        if let Some((place, text)) = self.misplacement(statement) {
            return self.report.error(place, text);
        }
        expansion.statements.push(located);
        match statement {
            Statement::Use(used) => self.declare_use(expansion, used),
            other => self.declare(other),
        }
    }

    /// What to say about a statement that does not belong into this scope.
    fn misplacement(&self, statement: &Statement) -> Option<(Place, String)> {
        let Some(part) = &self.scopes.here().part else {
            return match statement {
                Statement::Port(port) => {
                    let text =
                        "only a part has ports; write `link` here, or move this into a `part`";
                    Some((Place::at(port.name.span()), text.to_owned()))
                }
                _ => None,
            };
        };
        let whole = |keyword, word: &str| {
            let text =
                format!("`{word}` belongs to the whole mechanism; move it out of part `{part}`");
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
                let text = format!(
                    "parts stand beside one another; move `{}` out of `{part}`",
                    inner.name
                );
                Some((Place::at(inner.name.span()), text))
            }
            Statement::Method(method) => whole(method.keyword, "method"),
            Statement::Accuracy { keyword, .. } => whole(*keyword, "accuracy"),
            Statement::Cost { keyword, .. } => whole(*keyword, "cost"),
            Statement::Quality { keyword, .. } => whole(*keyword, "quality"),
            Statement::Look { keyword, .. } => whole(*keyword, "look"),
            Statement::ChangePoints { keyword, .. } => whole(*keyword, "at change points"),
            Statement::Gravity { keyword, .. } => whole(*keyword, "gravity"),
            Statement::Show { keyword, .. } => whole(*keyword, "show"),
            Statement::Allow(word) => whole(word.span(), "allow"),
            Statement::Effects { effects, .. } => effects.iter().find_map(|effect| match effect {
                Ok(Effect::Plain(effect)) => whole(effect.span(), &effect.to_string()),
                _ => None,
            }),
            _ => None,
        }
    }

    /// Makes the instances of a use, and reads the statements of its part in each.
    fn declare_use<'t>(&mut self, expansion: &mut Expansion<'t>, used: &'t Use) {
        let Use { name, part, .. } = used;
        let is_new = self.claim(name, "use") && {
            let method = format!("{}_mut", self.key_of(name));
            self.claim_method(method, format!("changing `{name}`"), Place::at(name.span()))
        };
        let key = self.key_of(name);
        self.names.enter(
            key,
            if is_new {
                Referent::Use
            } else {
                Referent::Broken
            },
        );
        let (scope, place) = (self.scopes.current(), self.report.place());
        let count = self.count(used);
        let Some((outer, part)) = self.find_part(expansion, part) else {
            return;
        };
        let Some(instances) = count.filter(|_| is_new) else {
            return;
        };
        let Some(own) = self.own_similarity(used) else {
            return;
        };
        let frame = self.similarity;
        let Some(similarity) = self.compose(&frame, &own, Place::at(name.span())) else {
            return;
        };
        let mut known = UsedPart {
            name: name.to_string(),
            is_array: used.count.is_some(),
            own,
            instances: Vec::new(),
        };
        let said = self.report.len();
        for instance in 0..instances {
            let number = known.is_array.then_some(instance);
            let own = match number {
                Some(number) => format!("{name}[{number}]"),
                None => name.to_string(),
            };
            // What is wrong with the numbers of the first instance is so with all.
            let numbers = if self.report.len() == said {
                self.arguments(used, part, number)
            } else {
                part.parameters.iter().map(|_| Some((None, None))).collect()
            };
            let body = part.body.as_deref().unwrap_or_default();
            let instance = self
                .scopes
                .add(&own, &part.name.to_string(), Constants::of(body));
            known.instances.push(instance);
            self.model.instances.push(Instance {
                name: name.to_string(),
                index: number,
                part: part.name.to_string(),
                path: self
                    .scopes
                    .get(instance)
                    .prefix
                    .trim_end_matches('.')
                    .to_owned(),
                parent: scope.checked_sub(1),
            });
            self.scopes.enter(instance);
            self.scopes.here_mut().similarity = similarity;
            self.give_numbers(part, numbers);
            self.scopes.enter(scope);
        }
        self.scopes.here_mut().uses.push(known.clone());
        for instance in known.instances {
            let body = part.body.iter().flatten();
            for (inner, statement) in (1..).zip(body) {
                let place = StatementPlace {
                    outer,
                    inner: Some(inner),
                };
                self.expand_statement(
                    expansion,
                    Located {
                        scope: instance,
                        place,
                        statement,
                    },
                );
            }
        }
        self.enter(scope, place);
    }

    /// How many instances a use has.
    fn count(&mut self, used: &Use) -> Option<usize> {
        let Some((count, place)) = &used.count else {
            return Some(1);
        };
        if self.constants().has(INSTANCE) {
            let text = format!(
                "`{INSTANCE}` is the number of an instance here; choose another name for the constant `{INSTANCE}`"
            );
            self.report.error(*place, text);
        }
        let most = i32::try_from(MOST_SCOPES).unwrap_or(i32::MAX);
        let count = self.whole(count, "the number of instances", [1, most])?;
        let count = usize::try_from(count).ok()?;
        if self.scopes.len() + count > MOST_SCOPES {
            let text = format!(
                "a mechanism has {MOST_SCOPES} instances of parts at most; this makes more"
            );
            self.report.error(*place, text);
            return None;
        }
        Some(count)
    }

    fn find_part<'t>(
        &mut self,
        expansion: &Expansion<'t>,
        name: &proc_macro2::Ident,
    ) -> Option<(usize, &'t Part)> {
        let text = name.to_string();
        let trouble = match expansion.part(&text) {
            Some(_) if self.scopes.is_within(&text) => {
                format!("part `{text}` uses itself; it would never end")
            }
            Some(found) => return Some(found),
            None => {
                let known = expansion
                    .parts
                    .iter()
                    .map(|(_, part)| part.name.to_string());
                let known: Vec<String> = known.collect();
                let known: Vec<&str> = known.iter().map(String::as_str).collect();
                let remedy = match known.as_slice() {
                    [] => format!("; declare `part {text} {{ ... }}` in the mechanism"),
                    known => spelling::remedy(&text, known),
                };
                format!("unknown part `{text}`{remedy}")
            }
        };
        self.report.error(Place::at(name.span()), trouble);
        None
    }

    /// How an instance is mirrored and scaled by its use.
    fn own_similarity(&mut self, used: &Use) -> Option<Similarity> {
        let mut own = Similarity::IDENTITY;
        own.is_mirrored = used.mirrored.is_some();
        if let Some(scaled) = &used.scaled {
            let (value, formula) = self.length(scaled, "a scale")?;
            own.scale = Quantity {
                value: Some(value),
                formula,
            };
        }
        Some(own)
    }

    /// The values of the numbers of an instance, as far as its use gives them.
    fn arguments(
        &mut self,
        used: &Use,
        part: &Part,
        instance: Option<usize>,
    ) -> Vec<Option<Given>> {
        self.scopes.here_mut().constants.set_instance(instance);
        let mut values: Vec<Option<_>> = part.parameters.iter().map(|_| None).collect();
        for argument in &used.arguments {
            let name = &argument.name;
            let Ok(expr) = &argument.value else {
                continue;
            };
            let value = (self.quantity(expr), self.integer(expr));
            let found = part.parameters.iter().position(|known| known.name == *name);
            let trouble = match found {
                Some(index) if values[index].is_some() => {
                    format!("`{name}` is given twice; remove one of the two")
                }
                Some(index) => {
                    values[index] = Some(value);
                    continue;
                }
                None => {
                    let known: Vec<String> = part
                        .parameters
                        .iter()
                        .map(|known| known.name.to_string())
                        .collect();
                    let known: Vec<&str> = known.iter().map(String::as_str).collect();
                    let part = &part.name;
                    format!(
                        "part `{part}` has no number `{name}`{}",
                        spelling::remedy(&name.to_string(), &known)
                    )
                }
            };
            self.report.error(Place::at(name.span()), trouble);
        }
        self.scopes.here_mut().constants.set_instance(None);
        values
    }

    /// Gives the numbers of an instance their values: those of its use, or else those of the part.
    fn give_numbers(&mut self, part: &Part, values: Vec<Option<Given>>) {
        for (parameter, value) in part.parameters.iter().zip(values) {
            let (value, integer) = value.unwrap_or_else(|| match &parameter.value {
                Ok(expr) => (self.quantity(expr), self.integer(expr)),
                Err(_) => (None, None),
            });
            let name = &parameter.name;
            let constants = &mut self.scopes.here_mut().constants;
            if !constants.give(name, value, integer) {
                let text = format!("there is a number `{name}` already; choose another name");
                if !self.report.has(&text) {
                    self.report.error(Place::at(name.span()), text);
                }
            }
        }
    }

    /// The coordinate of a joint that a part gives, as the joint has it.
    pub(super) fn own_coordinate(&self, joint: JointId, value: f64) -> f64 {
        match self.model.joint(joint).kind {
            JointKind::Revolute(..) => self.similarity.sense() * value,
            _ => self.start_scale() * value,
        }
    }

    /// The factor of the lengths of the part that is read, at the start.
    pub(super) fn start_scale(&self) -> f64 {
        let Some(scale) = self.similarity.scale.value else {
            bug!("a scale has no value at the start");
        };
        scale
    }
}

/// What could not be read of a statement.
fn unread(statement: &Statement) -> Vec<&Message> {
    match statement {
        Statement::Broken(broken) => vec![&broken.error],
        Statement::Link(Link { items, .. }) | Statement::Port(Port { items, .. }) => match items {
            Ok(items) => items.iter().filter_map(error_of).collect(),
            Err(error) => vec![error],
        },
        Statement::Joint(joint) => joint.body.as_ref().err().into_iter().collect(),
        Statement::Constant(constant) | Statement::Param(constant) => {
            constant.value.as_ref().err().into_iter().collect()
        }
        Statement::Spring(elastic) | Statement::Damper(elastic) => {
            elastic.body.as_ref().err().into_iter().collect()
        }
        Statement::Load(load) => load.on.as_ref().err().into_iter().collect(),
        Statement::Start(start) => start
            .clauses
            .iter()
            .filter_map(|clause| clause.as_ref().err())
            .collect(),
        _ => Vec::new(),
    }
}
