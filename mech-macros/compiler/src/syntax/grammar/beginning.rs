//! The words that statements and items begin with.

use syn::parse::ParseStream;

/// The words that a statement may begin with.
pub const STATEMENTS: [&str; 28] = [
    "const",
    "param",
    "ground",
    "link",
    "joint",
    "motor",
    "start",
    "method",
    "accuracy",
    "cost",
    "at",
    "allow",
    "effects",
    "show",
    "continuous",
    "quality",
    "look",
    "gravity",
    "spring",
    "damper",
    "load",
    "follow",
    "path",
    "expect",
    "part",
    "port",
    "use",
    NOT_YET,
];

/// That of them which stands for nothing today.
pub(super) const NOT_YET: &str = "certify";

/// The words that an item may begin with.
pub(super) const ITEMS: [&str; 13] = [
    "point", "line", "circle", "ring", "polygon", "bar", "gear", "stand", "rail", "spring", "text",
    "mass", "density",
];

/// Whether one of the words comes next, followed by what may follow it: a name, a number or a bracket. The word `at`
/// also stands within joints, before a bracket: it begins a statement only with `change` after it.
pub(super) fn at_beginning(input: ParseStream, beginnings: &[&str]) -> bool {
    let Some((word, rest)) = input.cursor().ident() else {
        return false;
    };
    let name = rest.ident().map(|(name, _)| name);
    let follows = if word == "at" {
        name.is_some_and(|name| name == "change")
    } else {
        name.is_some() || rest.literal().is_some() || rest.any_group().is_some()
    };
    follows && beginnings.iter().any(|beginning| word == *beginning)
}
