//! The constants and params, and where in the text each may be used.

use super::quantity::Quantity;
use super::report::Report;
use crate::model::{Model, function_names};
use crate::syntax::ast::Statement;
use crate::syntax::{Place, spelling};
use proc_macro2::Ident;

/// Names of the language that no constant or param may take, beside those of the functions.
const BUILT_IN: [&str; 3] = ["PI", "deg", "rpm"];

/// The name of an instance's number, where a part is used several times.
pub(super) const INSTANCE: &str = "k";

/// The word in messages for a number of a part.
const NUMBER: &str = "number";

/// The time, in laws of motors.
pub(super) const TIME: &str = "t";

/// The coordinate of the shaft, in laws of cams.
pub(super) const COORDINATE: &str = "q";

/// The names of the variables of laws.
const VARIABLES: [&str; 2] = [TIME, COORDINATE];

/// All constants of the text.
#[derive(Default)]
pub(super) struct Constants {
    entries: Vec<Entry>,
}

/// The value of a constant.
#[derive(Clone, Copy, Default)]
pub(super) struct Value {
    /// None before it is computed, or if it could not be: then whoever uses it is not to blame.
    pub(super) quantity: Option<Quantity>,
    /// The same as an integer, if it is computed from integers alone.
    pub(super) integer: Option<i64>,
}

/// The names that count as constants for as long as something is read.
#[derive(Clone, Copy, Default)]
pub(super) struct Passing {
    /// The variable of the law that is read.
    pub(super) variable: Option<&'static str>,
    /// The number of the instance whose use is read.
    pub(super) instance: Option<usize>,
}

struct Entry {
    name: String,
    /// The number of the statement that declares it; 0 for what was there before.
    statement: usize,
    value: Value,
    /// The word for it in messages: constant, or param.
    word: &'static str,
}

impl Constants {
    /// Notes down where each is declared; statements are counted from 1.
    pub(super) fn of(statements: &[Statement]) -> Self {
        let mut constants = Self::default();
        for (statement, content) in (1..).zip(statements) {
            match content {
                Statement::Constant(constant) => {
                    constants.enter(&constant.name, statement, "constant");
                }
                Statement::Param(param) => constants.enter(&param.name, statement, "param"),
                // Something that could not be read counts as declared before everything else.
                Statement::Broken(broken) => {
                    let names = broken.names.iter();
                    names.for_each(|name| constants.enter(name, 0, "constant"));
                }
                _ => {}
            }
        }
        constants
    }

    /// Those of a model that is made.
    pub(super) fn of_model(model: &Model) -> Self {
        let entries = model.constants.iter().map(|(name, value)| Entry {
            name: name.clone(),
            statement: 0,
            value: Value { quantity: Some(Quantity::fixed(*value)), integer: None },
            word: "constant",
        });
        Self { entries: entries.collect() }
    }

    /// All that have a value, by their names.
    pub(super) fn known(&self) -> Vec<(String, f64)> {
        let known = self.entries.iter().filter_map(|entry| {
            let value = entry.value.quantity?.value?;
            Some((entry.name.clone(), value))
        });
        known.collect()
    }

    fn enter(&mut self, name: &Ident, statement: usize, word: &'static str) {
        let name = name.to_string();
        if self.find(&name).is_none() {
            self.entries.push(Entry { name, statement, value: Value::default(), word });
        }
    }

    /// Gives a number of a part its value; false if there is one of its name.
    pub(super) fn give(&mut self, name: &Ident, value: Value) -> bool {
        let is_new = self.entries.iter().all(|entry| name != &entry.name || entry.statement != 0);
        self.entries.retain(|entry| name != &entry.name);
        self.entries.push(Entry { name: name.to_string(), statement: 0, value, word: NUMBER });
        is_new
    }

    fn find(&self, name: &str) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.name == name)
    }

    /// Whether there is a constant of this name, anywhere in the text.
    pub(super) fn has(&self, name: &str) -> bool {
        self.find(name).is_some()
    }

    /// The integer that this stands for, if it is computed from integers alone.
    pub(super) fn integer(&self, name: &Ident) -> Option<i64> {
        let entry = self.find(&name.to_string())?;
        entry.value.integer
    }

    /// Whether this stands for a number that depends on a param.
    pub(super) fn depends(&self, name: &Ident) -> bool {
        let value = self.find(&name.to_string()).and_then(|entry| entry.value.quantity);
        value.is_some_and(|value| value.formula.is_some())
    }

    /// Returns the word for it in messages: constant, or param.
    pub(super) fn word_for(&self, name: &Ident) -> &'static str {
        self.find(&name.to_string()).map_or("constant", |entry| entry.word)
    }

    /// Gives a constant or param (`what`) its value, at its declaration: whether this is its declaration.
    pub(super) fn declare(
        &mut self,
        name: &Ident,
        value: Value,
        what: &str,
        report: &mut Report,
    ) -> bool {
        let text = name.to_string();
        let here = report.statement();
        let entry = self.entries.iter_mut().find(|entry| entry.name == text);
        let message = match entry {
            _ if BUILT_IN.contains(&text.as_str()) || is_function(&text) => {
                format!("`{text}` belongs to the language; choose another name")
            }
            Some(entry) if entry.statement == here => {
                entry.value = value;
                return true;
            }
            Some(entry) if entry.statement != 0 || entry.word == NUMBER => match (entry.word, what)
            {
                ("constant", "constant") => {
                    format!("there is a constant `{text}` already; choose another name")
                }
                (word, what) => {
                    format!(
                        "there is a {word} `{text}` already; choose another name for this {what}"
                    )
                }
            },
            _ => return false,
        };
        report.error(Place::at(name.span()), message);
        false
    }

    /// Gives a param its value, after its declaration.
    pub(super) fn assign(&mut self, name: &Ident, value: Quantity) {
        let text = name.to_string();
        if let Some(entry) = self.entries.iter_mut().find(|entry| entry.name == text) {
            entry.value.quantity = Some(value);
        }
    }

    /// The value of a constant in the statement of this number.
    ///
    /// # Errors
    /// Why it has none there.
    pub(super) fn value(
        &self,
        name: &Ident,
        passing: Passing,
        here: usize,
    ) -> Result<Option<Quantity>, String> {
        let text = name.to_string();
        Err(match self.find(&text) {
            Some(entry) if entry.statement < here => return Ok(entry.value.quantity),
            Some(entry) if entry.statement == here => {
                format!("{} `{text}` cannot be computed from itself", entry.word)
            }
            Some(entry) => {
                let word = entry.word;
                format!("{word} `{text}` is declared further down; move its line up")
            }
            None => self.unknown_name(&text, passing, here),
        })
    }

    /// Returns the message about an unknown name; one of Rust's may be meant, which a macro cannot see.
    fn unknown_name(&self, text: &str, passing: Passing, here: usize) -> String {
        let beginning = format!("unknown constant `{text}`");
        if text == "TAU" {
            return format!("{beginning}; write `(2 * PI)`");
        }
        if text == "deg" {
            return "`deg` stands after a number, as `30 deg`".to_owned();
        }
        if is_function(text) {
            return format!("`{text}` is a function; write what it is of, as `{text}(...)`");
        }
        let known = self.known_names(passing, here);
        let remedy = spelling::remedy(text, &known);
        let is_variable = VARIABLES.contains(&text);
        if is_variable || spelling::nearest(text, &known).is_some() {
            return format!("{beginning}{remedy}");
        }
        format!(
            "{beginning}{remedy}\n\nhelp: constants of Rust outside of the mechanism are unknown to the macro; declare `const {text} = ...;` inside it"
        )
    }

    /// The names of those that may stand in the statement of this number.
    pub(super) fn names_before(&self, here: usize) -> impl Iterator<Item = &str> {
        let known = self.entries.iter().filter(move |entry| entry.statement < here);
        known.map(|entry| entry.name.as_str())
    }

    fn known_names(&self, passing: Passing, here: usize) -> Vec<&str> {
        self.names_before(here)
            .chain(["PI"])
            .chain(passing.variable)
            .chain(passing.instance.map(|_| INSTANCE))
            .collect()
    }
}

fn is_function(name: &str) -> bool {
    function_names().any(|function| function == name)
}
