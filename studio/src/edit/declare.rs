//! Declarations, as statements of the language.

use super::{ActionKind, Change, Command, Expression, Pair, Refusal, Scene};
use crate::document::NumberText;
use crate::text::{Kind as Lexical, Lexer, Replacement, is_of_word, quoted};
use mech_compiler::syntax::{Rewriter, StatementText};

/// Where constants stand: before everything that may use them.
const NUMBERS: [&str; 2] = ["const", "param"];
const LINKS: [&str; 6] = ["link", "ground", "param", "const", "look", "use"];
const JOINTS: [&str; 3] = ["joint", "link", "ground"];
const MOTORS: [&str; 4] = ["motor", "joint", "link", "ground"];
const OTHERS: [&str; 7] = ["effects", "start", "motor", "joint", "link", "ground", "const"];

pub(super) fn declare(scene: &Scene, command: &Command) -> Result<Change, Refusal> {
    let mut rewriter = scene.rewriter()?;
    match command {
        Command::Constant { name, value, is_param } => {
            if scene.listing.number(name, "value").is_some() && !is_param {
                return set(scene, name, "value", value);
            }
            check_name(name)?;
            check_expression(value)?;
            let word = if *is_param { "param" } else { "const" };
            let statement = format!("{word} {name} = {value};");
            add(&mut rewriter, &statement, &NUMBERS)?;
        }
        Command::Link { name } => {
            check_name(name)?;
            add(&mut rewriter, &format!("link {name};"), &LINKS)?;
        }
        Command::Axis { path, at, along } => {
            let (link, name) = split(path)?;
            check_name(name)?;
            let at = pair(at)?;
            let item = match along {
                Some(along) => {
                    check_expression(along)?;
                    format!("line {name} = {at} -> {along};")
                }
                None => format!("point {name} = {at};"),
            };
            add_item(&mut rewriter, link, &item)?;
        }
        Command::Shape { link, shape } => {
            check_fragment(shape)?;
            add_item(&mut rewriter, link, &format!("{shape};"))?;
        }
        Command::Mass { link, mass, at, inertia } => {
            check_expression(mass)?;
            let mut item = format!("mass {mass}");
            if let Some(at) = at {
                item += &format!(" at {}", pair(at)?);
            }
            if let Some(inertia) = inertia {
                check_expression(inertia)?;
                item += &format!(" inertia {inertia}");
            }
            item += ";";
            match matter(&rewriter, link) {
                Some(known) => rewriter.edits.replace(known.range(), item),
                None => add_item(&mut rewriter, link, &item)?,
            }
        }
        Command::Motor { joint, law, range, step } => {
            motor(scene, &mut rewriter, joint, [law, step], range.as_ref())?;
        }
        Command::Start { name, is_near, value } => start(&mut rewriter, name, *is_near, value)?,
        Command::Action { kind, name, body } => {
            check_name(name)?;
            check_fragment(body)?;
            let statement = format!("{} {name} = {body};", kind.word());
            add(&mut rewriter, &statement, &[kind.word(), "start", "motor", "joint", "link"])?;
            if let ActionKind::Load = kind {
                rewriter.ask_for_forces().ok_or_else(unwritten)?;
            }
        }
        Command::Use { body } => {
            let shown = body.trim().trim_end_matches(';');
            check_brackets(shown)?;
            add(&mut rewriter, &format!("use {shown};"), &["use", "joint", "link", "ground"])?;
        }
        Command::Trace { point, length } => {
            check_path(point)?;
            check_expression(length)?;
            trace(&mut rewriter, point, length)?;
        }
        Command::Setting { statement } => setting(&mut rewriter, statement)?,
        _ => return Err(Refusal::internal("a command that declares nothing")),
    }
    Change::of(scene, &rewriter)
}

pub(super) fn set(scene: &Scene, owner: &str, role: &str, value: &str) -> Result<Change, Refusal> {
    let Some(number) = scene.listing.number(owner, role) else {
        let roles = scene.listing.numbers_of(owner).map(|one| &one.role);
        let roles = quoted(roles);
        return Err(Refusal::of(format!("`{owner}` has no number `{role}`; it has {roles}")));
    };
    if number.is_pair || role == "color" || role.ends_with(" color") {
        check_fragment(value)?;
    } else {
        check_expression(value)?;
    }
    Ok(Change::from(replaced(number, value.trim())))
}

/// Another text in place of a number.
pub(super) fn replaced(number: &NumberText, by: impl Into<String>) -> Replacement {
    Replacement::new(number.place.clone(), by.into())
}

/// Puts a motor on a joint, or says more of one.
fn motor(
    scene: &Scene,
    rewriter: &mut Rewriter<'_>,
    joint: &str,
    [law, step]: [&Option<Expression>; 2],
    range: Option<&[Expression; 2]>,
) -> Result<(), Refusal> {
    check_path(joint)?;
    for value in law.iter().chain(range.into_iter().flatten()).chain(step) {
        check_expression(value)?;
    }
    let text_of = |role: &str| {
        let number = scene.listing.number(joint, role)?;
        Some(scene.text()[number.place.clone()].to_owned())
    };
    let mut statement = format!("motor {joint}");
    let known = rewriter.declared("motor", joint);
    if known.is_some() && law.is_none() && range.is_none() && step.is_none() {
        return Err(Refusal::of(format!("`{joint}` has a motor already")));
    }
    if let Some(law) = law.clone().or_else(|| text_of("motor law")) {
        statement += &format!(" = {law}");
    }
    let declared = text_of("low").zip(text_of("high")).map(|(low, high)| [low, high]);
    if let Some([low, high]) = range.cloned().or(declared) {
        statement += &format!(" in {low} ..= {high}");
    }
    if let Some(step) = step.clone().or_else(|| text_of("step")) {
        statement += &format!(" by {step}");
    }
    statement += ";";
    match known {
        Some(known) => rewriter.edits.replace(known.range(), statement),
        None => add(rewriter, &statement, &MOTORS)?,
    }
    Ok(())
}

fn start(
    rewriter: &mut Rewriter<'_>,
    name: &str,
    is_near: bool,
    value: &str,
) -> Result<(), Refusal> {
    check_path(name)?;
    check_expression(value)?;
    let sign = if is_near { "near" } else { "=" };
    let clause = format!("{name} {sign} {value};");
    let clauses = rewriter.clauses("start");
    let is_it =
        |one: &&StatementText<'_>| one.path(0).0 == name && one.find("near").is_some() == is_near;
    if let Some(known) = clauses.iter().find(is_it) {
        rewriter.edits.replace(known.range(), clause);
        return Ok(());
    }
    rewriter.add_to_start(&clause).ok_or_else(unwritten)
}

fn trace(rewriter: &mut Rewriter<'_>, point: &str, length: &str) -> Result<(), Refusal> {
    let clause = format!("trace {point} {length};");
    let effects = rewriter.statements.iter().find(|one| one.is("effects"));
    let Some(effects) = effects else {
        return add(rewriter, &format!("effects {{ {clause} }}"), &OTHERS);
    };
    let is_it = |one: &StatementText<'_>| one.is("trace") && one.path(1).0 == point;
    if effects.clauses().iter().any(is_it) {
        return Err(Refusal::of(format!("`{point}` is traced already")));
    }
    rewriter.add_clause("effects", &clause).ok_or_else(unwritten)
}

/// Says something of the whole mechanism, in place of what was said.
fn setting(rewriter: &mut Rewriter<'_>, statement: &str) -> Result<(), Refusal> {
    const WORDS: [&str; 12] = [
        "gravity",
        "look",
        "quality",
        "method",
        "accuracy",
        "cost",
        "allow",
        "show",
        "continuous",
        "follow",
        "path",
        "at",
    ];
    let statement = statement.trim().trim_end_matches(';');
    check_fragment(statement)?;
    let word = statement.split_whitespace().next().unwrap_or_default();
    if !WORDS.contains(&word) {
        return Err(Refusal::of(format!(
            "`{word}` is no setting; there are {}",
            WORDS.map(|word| format!("`{word}`")).join(", ")
        )));
    }
    let known = rewriter
        .statements
        .iter()
        .find(|one| one.is(word) && (word != "allow" || statement.ends_with(one.word(1))));
    if let Some(range) = known.map(StatementText::range) {
        rewriter.edits.replace(range, format!("{statement};"));
        return Ok(());
    }
    let siblings: &[&str] = match word {
        "look" | "quality" => &[],
        _ => &OTHERS,
    };
    add(rewriter, &format!("{statement};"), siblings)
}

/// The mass or density of a link.
pub(super) fn matter<'t>(rewriter: &Rewriter<'t>, link: &str) -> Option<StatementText<'t>> {
    let items = rewriter.declared("link", link)?.clauses();
    let mut items = items.into_iter();
    items.find(|one| one.is("mass") || one.is("density"))
}

pub(super) fn add(
    rewriter: &mut Rewriter<'_>,
    statement: &str,
    siblings: &[&str],
) -> Result<(), Refusal> {
    rewriter.add_beside(statement, siblings).ok_or_else(unwritten)
}

fn add_item(rewriter: &mut Rewriter<'_>, link: &str, item: &str) -> Result<(), Refusal> {
    let added = rewriter.add_item(link, item);
    added.ok_or_else(|| Refusal::of(format!("there is no link `{link}` in this text")))
}

/// Where a joint stands among the other statements.
pub(super) fn joint(rewriter: &mut Rewriter<'_>, statement: &str) -> Result<(), Refusal> {
    add(rewriter, statement, &JOINTS)
}

pub(super) fn unwritten() -> Refusal {
    Refusal::of("this cannot be written as a change of the text")
}

/// A link, and the name of something fixed to it.
fn split(path: &str) -> Result<(&str, &str), Refusal> {
    path.rsplit_once('.').ok_or_else(|| {
        Refusal::of(format!("`{path}` names no point of a link; write `link.{path}`"))
    })
}

/// `(x, y)`
pub(super) fn pair([x, y]: &Pair) -> Result<String, Refusal> {
    check_expression(x)?;
    check_expression(y)?;
    Ok(format!("({}, {})", x.trim(), y.trim()))
}

/// A word that can be a name.
pub(super) fn check_name(name: &str) -> Result<(), Refusal> {
    let mut letters = name.chars();
    let is_first = |letter: char| letter.is_alphabetic() || letter == '_';
    let is_right = letters.next().is_some_and(is_first) && letters.all(is_of_word);
    if is_right {
        Ok(())
    } else {
        Err(Refusal::of(format!(
            "`{name}` cannot be a name: letters, digits and `_`, and no digit first"
        )))
    }
}

/// A path: words with dots between them, and numbers in brackets.
pub(super) fn check_path(path: &str) -> Result<(), Refusal> {
    let is_right = !path.is_empty()
        && path.chars().all(|letter| letter.is_alphanumeric() || "_.[]* ".contains(letter));
    if is_right {
        check_fragment(path)
    } else {
        Err(Refusal::of(format!("`{path}` is no name of a link, a joint or a point")))
    }
}

/// A number: nothing but what an expression consists of.
pub(super) fn check_expression(text: &str) -> Result<(), Refusal> {
    let mut words = Lexer::new(text, 0);
    let stray = words.find(|one| {
        let word = &text[one.start..one.end];
        one.kind == Lexical::Word && ["turned", "on", "along", "near", "in", "by"].contains(&word)
    });
    match stray {
        Some(stray) => Err(Refusal::of(format!(
            "`{}` does not belong to a number",
            &text[stray.start..stray.end]
        ))),
        None => check_fragment(text),
    }
}

/// A piece of a statement: it may not end one, and it may not hide anything.
pub(super) fn check_fragment(text: &str) -> Result<(), Refusal> {
    if let Some(mark) = [';', '{', '}'].into_iter().find(|mark| has_mark(text, *mark)) {
        return Err(Refusal::of(format!("`{mark}` cannot stand in `{}`", text.trim())));
    }
    check_brackets(text)
}

/// Brackets match, and there is no comment: that would hide what follows.
fn check_brackets(text: &str) -> Result<(), Refusal> {
    let mut open = Vec::new();
    let mut last = None;
    let words = Lexer::new(text, 0).map(|one| &text[one.start..one.end]);
    for word in words {
        let partner = match word {
            ")" => "(",
            "]" => "[",
            "}" => "{",
            _ => "",
        };
        if ["(", "[", "{"].contains(&word) {
            open.push(word);
        } else if !partner.is_empty() && open.pop() != Some(partner) {
            return Err(Refusal::of(format!("the brackets of `{}` do not match", text.trim())));
        }
        last = Some(word);
    }
    let has_comment = text.contains("//") || text.contains("/*") || text.contains('\n');
    if !open.is_empty() {
        Err(Refusal::of(format!("the brackets of `{}` do not match", text.trim())))
    } else if has_comment {
        Err(Refusal::of("a comment or a new line cannot stand here"))
    } else if last.is_none() || text.matches('"').count() % 2 == 1 {
        Err(Refusal::of(format!("something is missing: `{}`", text.trim())))
    } else {
        Ok(())
    }
}

fn has_mark(text: &str, mark: char) -> bool {
    let mut words = Lexer::new(text, 0);
    words.any(|one| text[one.start..one.end].starts_with(mark))
}
