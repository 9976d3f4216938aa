//! Whether two texts declare the same mechanism, whatever the order of their declarations and the places where these stand.

use mech_compiler::model::{AxisId, LawId, LinkId, Model};
use std::collections::BTreeSet;
use std::fmt::Debug;

/// Whether two models are the same but for the order of declarations, the names of lines that joints need, and rounding.
pub(crate) fn are_alike(a: &Model, b: &Model) -> bool {
    a.name == b.name && declarations(a) == declarations(b) && settings(a) == settings(b)
}

/// Everything with ids in it, in words.
fn declarations(model: &Model) -> BTreeSet<String> {
    let mut all = BTreeSet::new();
    let mut add = |kind: &str, what: &dyn Debug| {
        all.insert(format!("{kind} {}", in_words(model, what)));
    };
    for link in &model.links {
        add("link", link);
    }
    for joint in &model.joints {
        add("joint", joint);
    }
    for motor in &model.motors {
        add("motor", motor);
    }
    for value in &model.start.values {
        add("start", value);
    }
    for near in &model.start.near {
        add("near", near);
    }
    for joint in &model.continuous {
        add("continuous", joint);
    }
    for shown in model.show.iter().flatten() {
        add("show", shown);
    }
    for trace in &model.traces {
        add("trace", trace);
    }
    let actions = &model.actions;
    for spring in &actions.springs {
        add("spring", spring);
    }
    for damper in &actions.dampers {
        add("damper", damper);
    }
    for load in &actions.loads {
        add("load", load);
    }
    all
}

/// Everything else.
fn settings(model: &Model) -> String {
    let mut other = Model {
        show: model.show.as_ref().map(|_| Vec::new()),
        ..model.clone()
    };
    other.links.clear();
    other.axes.clear();
    other.joints.clear();
    other.motors.clear();
    other.laws.clear();
    other.start.values.clear();
    other.start.near.clear();
    other.continuous.clear();
    other.traces.clear();
    other.actions.springs.clear();
    other.actions.dampers.clear();
    other.actions.loads.clear();
    in_words(model, &other)
}

/// How something is written for debugging, with names for ids, without origins, and with numbers rounded.
fn in_words(model: &Model, what: &dyn Debug) -> String {
    let text = format!("{what:?}");
    let mut words = String::new();
    let mut remaining = text.as_str();
    while let Some(first) = remaining.chars().next() {
        let is_word = |letter: char| letter.is_alphanumeric() || letter == '_';
        let is_number = first.is_ascii_digit();
        let length = if is_number {
            number(remaining)
        } else if is_word(first) {
            remaining
                .find(|letter| !is_word(letter))
                .unwrap_or(remaining.len())
        } else {
            first.len_utf8()
        };
        let (word, after) = remaining.split_at(length);
        let id = after
            .strip_prefix('(')
            .and_then(|after| after.split_once(')'));
        let id = id.and_then(|(id, after)| Some((id.parse::<usize>().ok()?, after)));
        remaining = after;
        if let Some((id, after)) = id
            && let Some(name) = name(model, word, id)
        {
            words += &name;
            remaining = after;
        } else if is_number {
            let number = rounded(word);
            // Zero has no sign.
            if number == "0" && words.ends_with('-') {
                words.pop();
            }
            words += &number;
        } else {
            words += word;
        }
    }
    words
}

/// The length of the number with which a text begins.
fn number(text: &str) -> usize {
    let mut last = ' ';
    let end = text.find(|letter: char| {
        let is_sign = letter == '-' && last == 'e';
        last = letter;
        !(letter.is_ascii_digit() || letter == '.' || letter == 'e' || is_sign)
    });
    end.unwrap_or(text.len())
}

/// A number with as many digits as are the same in every way of computing it.
fn rounded(number: &str) -> String {
    match number.parse::<f64>() {
        Ok(value) if value.abs() < 1e-12 => "0".to_owned(),
        Ok(value) => format!("{value:.9e}"),
        Err(_) => number.to_owned(),
    }
}

/// What an id stands for; none if the word is none of an id.
fn name(model: &Model, word: &str, id: usize) -> Option<String> {
    match word {
        "Origin" => Some(String::new()),
        "LinkId" => Some(link(model, LinkId::new(id))),
        "JointId" => Some(model.joints.get(id)?.name.clone()),
        "LawId" => Some(in_words(model, model.laws.get(LawId::new(id).index())?)),
        "AxisId" => Some(axis(model, AxisId::new(id))),
        _ => None,
    }
}

/// The name of a link; of the die of a slot, where that is.
fn link(model: &Model, id: LinkId) -> String {
    match model.links.get(id.index()) {
        Some(link) if link.die.is_some() => format!("die of {}", link.name),
        Some(link) => link.name.clone(),
        None => String::new(),
    }
}

/// What an axis is; its name says nothing else.
fn axis(model: &Model, id: AxisId) -> String {
    let axis = model.axis(id);
    let exact = |part: f64| rounded(&part.abs().to_string()) + if part < -1e-12 { "-" } else { "" };
    let [x, y] = axis.at.map(exact);
    let [along, up] = axis.direction.map(exact);
    let formulas = (axis.formulas, axis.direction_formulas);
    format!(
        "{:?} of {} at ({x}, {y}) along ({along}, {up}) {formulas:?}",
        axis.kind,
        link(model, axis.link)
    )
}
