//! The words of the language.

/// Words that begin a statement, or stand in one for something fixed.
pub(crate) const KEYWORDS: &str = "struct link ground point line joint motor const param start near at along on plane color in every \
    revolute prismatic slot weld gear belt rack cam spring damper load mass density inertia part port use look trace show effects \
    circle ring polygon bar stand rail text radius teeth width deg method accuracy cost continuous quality gravity allow redundant \
    coupled expect follow path least velocity acceleration forces newton light dark from to by with sin cos tan sqrt abs min max hypot atan2 exp floor sign mod";

pub(crate) fn is_keyword(word: &str) -> bool {
    KEYWORDS.split(' ').any(|keyword| keyword == word)
}

/// The words that stand before round brackets.
pub(crate) const CALLED: [&str; 43] = [
    "revolute",
    "prismatic",
    "gear",
    "slot",
    "rack",
    "belt",
    "weld",
    "cam",
    "linear",
    "torsional",
    "force",
    "torque",
    "at",
    "along",
    "asin",
    "acos",
    "atan",
    "sin",
    "cos",
    "tan",
    "sqrt",
    "abs",
    "exp",
    "ln",
    "min",
    "max",
    "atan2",
    "hypot",
    "turns",
    "swing",
    "stroke",
    "mean",
    "rms",
    "dwell",
    "ratio",
    "distance",
    "angle",
    "clear",
    "transmission",
    "pressure",
    "centre",
    "advantage",
    "shaking",
];
