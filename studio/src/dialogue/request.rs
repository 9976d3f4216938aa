//! The requests of lines, made from the words that the user filled in.

use super::pattern::Found;
use crate::edit::{ActionKind, Assembly, Command, JointForm, Pair};
use crate::failure::Failure;

/// The request of a line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Request {
    /// A change of the mechanism.
    Edit(Command),
    /// A subcommand of `mech`, on the mechanism as it is now.
    Ask(Vec<String>),
    Repairs,
    /// The last step is undone.
    Undo,
    Redo,
    Steps,
    Text,
    /// The numbers of something, with their roles.
    Numbers(Option<String>),
    Open {
        file: String,
        mechanism: Option<String>,
    },
    Save(Option<String>),
    /// The help: on all lines, or on a topic.
    Help(Option<String>),
    Quit,
}

pub(super) struct Row {
    pub(super) pattern: &'static str,
    /// Its description in `help`.
    pub(super) help: &'static str,
    pub(super) request: fn(Taken) -> Result<Request, Failure>,
}

/// The words that a user filled in.
pub(super) struct Taken(pub(super) Found);

impl Taken {
    pub(super) fn text(&mut self, name: &str) -> String {
        self.0.remove(name).unwrap_or_default()
    }

    pub(super) fn optional(&mut self, name: &str) -> Option<String> {
        self.0.remove(name)
    }

    pub(super) fn place(&mut self, name: &str) -> Result<Option<Pair>, Failure> {
        self.optional(name).map(|text| pair(&text)).transpose()
    }

    pub(super) fn given_place(&mut self, name: &str) -> Result<Pair, Failure> {
        pair(&self.text(name))
    }

    pub(super) fn number(&mut self, name: &str) -> Result<usize, Failure> {
        let text = self.text(name);
        text.parse().map_err(|_| Failure::usage(format!("`{text}` is too large")))
    }
}

/// The two numbers of `(x, y)`.
fn pair(text: &str) -> Result<Pair, Failure> {
    let inner = text.trim().strip_prefix('(').and_then(|text| text.strip_suffix(')'));
    let inner = inner.unwrap_or_default();
    let mut depth = 0_usize;
    let comma = inner.char_indices().find(|(_, letter)| {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && *letter == ','
    });
    let (comma, _) = comma.ok_or_else(|| {
        Failure::usage(format!("expected a place as `(1, 2)`, found `{}`", text.trim()))
    })?;
    let [x, y] = [&inner[..comma], &inner[comma + 1..]].map(|part| part.trim().to_owned());
    Ok([x, y])
}

/// Two numbers that are given as such.
pub(super) fn numbers([x, y]: Pair) -> Result<[f64; 2], Failure> {
    let number = |text: &str| crate::motion::read_value(text).map_err(Failure::usage);
    Ok([number(&x)?, number(&y)?])
}

/// `a = 30, b = 2`
pub(super) fn pose(text: &str) -> Result<Vec<(String, f64)>, Failure> {
    let values = text.split(',').map(|one| {
        let setting: crate::motion::Setting = one.parse().map_err(Failure::usage)?;
        Ok((setting.motor, setting.value.number))
    });
    values.collect()
}

#[expect(clippy::unnecessary_wraps, reason = "the rows of the table read alike")]
pub(super) fn edit(command: Command) -> Result<Request, Failure> {
    Ok(Request::Edit(command))
}

/// A subcommand of `mech`, with the file that it writes.
#[expect(clippy::unnecessary_wraps, reason = "the rows of the table read alike")]
pub(super) fn ask(
    name: &str,
    file: Option<String>,
    words: Option<String>,
) -> Result<Request, Failure> {
    let mut all = vec![name.to_owned()];
    if let Some(file) = file {
        all.push("--output".to_owned());
        all.push(file);
    }
    let words = words.unwrap_or_default();
    all.extend(words.split_whitespace().map(ToOwned::to_owned));
    Ok(Request::Ask(all))
}

pub(super) fn constant(mut taken: Taken, is_param: bool) -> Result<Request, Failure> {
    edit(Command::Constant { name: taken.text("name"), value: taken.text("value"), is_param })
}

pub(super) fn join(mut taken: Taken, kind: JointForm) -> Result<Request, Failure> {
    edit(Command::Join(Assembly {
        name: taken.text("name"),
        kind,
        ends: [taken.text("a"), taken.text("b")],
        at: taken.place("at")?,
        along: taken.optional("along"),
    }))
}

pub(super) fn rolling(mut taken: Taken) -> Result<Request, Failure> {
    let sizes = [taken.text("first"), taken.text("second")];
    let on = taken.optional("on");
    let kind = match taken.text("kind").as_str() {
        "belt" => JointForm::Belt { sizes, on },
        _ => JointForm::Gear { sizes, on },
    };
    join(taken, kind)
}

pub(super) fn action(mut taken: Taken, kind: ActionKind) -> Result<Request, Failure> {
    edit(Command::Action { kind, name: taken.text("name"), body: taken.text("body") })
}

pub(super) fn start(mut taken: Taken, is_near: bool) -> Result<Request, Failure> {
    edit(Command::Start { name: taken.text("name"), is_near, value: taken.text("value") })
}
