//! Names that the language takes.

use crate::document::{Document, Source};
use crate::failure::Failure;
use crate::text::is_of_word;
use std::collections::BTreeSet;

/// Names that were given in one mechanism.
#[derive(Debug, Default)]
pub(super) struct Names {
    taken: BTreeSet<String>,
}

impl Names {
    /// A name for a link, a joint or a load (`kind`): the one that is wished for, as far as it can be a name and is free.
    pub(super) fn claim(&mut self, wish: &str, kind: &str) -> Result<String, Failure> {
        let base = allowed(wish, kind)?;
        let free = numbered(&base).find(|name| !self.taken.contains(name));
        let name = free.ok_or_else(|| Failure::internal("all names are taken"))?;
        self.taken.insert(name.clone());
        Ok(name)
    }

    /// A name for a point of a link. The methods that read it are taken with it.
    pub(super) fn claim_point(&mut self, link: &str, wish: &str) -> Result<String, Failure> {
        let base = allowed(wish, "point")?;
        let methods = |name: &str| [format!("{link}_{name}"), format!("{link}_{name}_trace")];
        let is_free = |name: &String| {
            let mut methods = methods(name).into_iter();
            methods.all(|method| !self.taken.contains(&method))
        };
        let name = numbered(&base).find(is_free);
        let name = name.ok_or_else(|| Failure::internal("all names are taken"))?;
        self.taken.extend(methods(&name));
        Ok(name)
    }
}

/// `rod`, `rod_2`, `rod_3` and so on.
fn numbered(base: &str) -> impl Iterator<Item = String> {
    let others = (2..u32::MAX).map(move |number| format!("{base}_{number}"));
    std::iter::once(base.to_owned()).chain(others)
}

/// The word nearest to a wish that the language takes.
fn allowed(wish: &str, kind: &str) -> Result<String, Failure> {
    let base = word(wish, kind);
    if is_allowed(&base)? {
        return Ok(base);
    }
    let longer = format!("{kind}_{base}");
    if is_allowed(&longer)? {
        return Ok(longer);
    }
    // Letters that are none in Rust.
    let plain: String = longer.chars().filter(char::is_ascii).collect();
    Ok(word(&plain, kind))
}

/// A wish as a word in small letters: `crank_arm` for `Crank Arm` and `crankArm`, `link_3` for `3`.
fn word(wish: &str, kind: &str) -> String {
    let words = words(wish).join("_").to_lowercase();
    match words.chars().next() {
        Some(first) if first.is_alphabetic() => words,
        Some(_) => format!("{kind}_{words}"),
        None => kind.to_owned(),
    }
}

/// The name of a type, as near to a wish as it can be: `FourBar` for `four bar`.
pub(crate) fn type_name(wish: &str) -> Result<String, Failure> {
    let words = words(wish).into_iter();
    let capital = words.map(|word| {
        let mut letters = word.chars();
        let first = letters.next().map(|first| first.to_uppercase().to_string());
        first.unwrap_or_default() + letters.as_str()
    });
    let name: String = capital.collect();
    let is_right = name.starts_with(char::is_alphabetic) && is_type(&name)?;
    Ok(if is_right { name } else { format!("Mechanism{name}") })
}

/// The stretches of letters and digits of a text. A capital after a small letter begins a new one.
fn words(text: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    for letter in text.chars() {
        let is_new = !before.is_alphanumeric() || before.is_lowercase() && letter.is_uppercase();
        before = letter;
        if !letter.is_alphanumeric() {
            continue;
        }
        match words.last_mut() {
            Some(word) if !is_new => word.push(letter),
            _ => words.push(letter.to_string()),
        }
    }
    words
}

/// Whether the language takes this word as the name of a link, a point and a joint.
fn is_allowed(word: &str) -> Result<bool, Failure> {
    is_right(&format!(
        "struct Trial; link {word} {{ point {word} = (0, 0); }} joint joint_of_trial = revolute(ground, {word}) at (0, 0); \
         motor joint_of_trial; load load_of_trial = force({word}.{word}); effects {{ force; trace {word}.{word} 2; }}"
    ))
}

/// Whether the language takes this word as the name of a mechanism.
pub(crate) fn is_type(word: &str) -> Result<bool, Failure> {
    if !word.chars().all(is_of_word) {
        return Ok(false);
    }
    is_right(&format!("struct {word}; link a; joint b = revolute(ground, a) at (0, 0); motor b;"))
}

fn is_right(text: &str) -> Result<bool, Failure> {
    let document = Document::of(Source::new("trial.mech", text));
    match document.declarations() {
        [only] => Ok(document.model(only)?.is_some()),
        _ => Ok(false),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_words_that_the_language_takes() {
        let mut names = Names::default();
        let mut name = |wish: &str| names.claim(wish, "link").expect("a name");
        assert_eq!(name("Crank Arm"), "crank_arm");
        assert_eq!(name("crankArm"), "crank_arm_2");
        assert_eq!(name("ABC"), "abc");
        assert_eq!(name("3"), "link_3");
        assert_eq!(name("  -- "), "link");
        assert_eq!(name("größe"), "größe");
        // A word of Rust, a method of every mechanism, and the ground.
        assert_eq!(name("fn"), "link_fn");
        assert_eq!(name("motors"), "link_motors");
        assert_eq!(name("Ground"), "link_ground");
        assert_eq!(name("self"), "link_self");
        assert_eq!(name("日本; }"), "日本");
        assert_eq!(name("x²"), "link_x");
    }

    #[test]
    fn points_take_the_names_of_their_methods() {
        let mut names = Names::default();
        assert_eq!(names.claim("rod", "link").expect("a name"), "rod");
        assert_eq!(names.claim_point("rod", "Tip").expect("a name"), "tip");
        assert_eq!(names.claim_point("rod", "tip").expect("a name"), "tip_2");
        assert_eq!(names.claim("rod tip", "link").expect("a name"), "rod_tip_3");
    }

    #[test]
    fn types_have_capitals() {
        let name = |wish: &str| type_name(wish).expect("a name");
        assert_eq!(name("four bar"), "FourBar");
        assert_eq!(name("slider-crank 2"), "SliderCrank2");
        assert_eq!(name("2 cranks"), "Mechanism2Cranks");
        assert_eq!(name("self"), "MechanismSelf");
        assert_eq!(name(""), "Mechanism");
    }
}
