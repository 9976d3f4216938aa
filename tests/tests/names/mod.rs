//! Nothing that generated code introduces can be met by a name of the user's. Every identifier of some expansions, which have all
//! effects between them, is made the name of everything else that a crate may have, and of everything that a mechanism may have; all
//! of it is compiled. What a mechanism cannot be given as a name is refused by the macro's own message about that name.
//!
//! `MECH_CASES=100000 cargo test -p mech-tests --test compiler names` compiles every identifier in every role.

mod crates;
mod scopes;
mod subjects;

use crates::{Line, compile};
use mech_compiler::syntax;
use proc_macro2::{TokenStream, TokenTree};
use std::collections::BTreeSet;
use subjects::{Role, SUBJECTS, Subject};

/// Names that no expansion of the subjects has, and which have met something once, or are words of the language.
const OTHERS: &str = include_str!("others.txt");

/// What no name may be, however it is written.
const KEYWORDS: &[&str] =
    &["Self", "_", "crate", "dyn", "fn", "gen", "self", "try", "r#fn", "r#type", "r#union"];

/// How many mechanisms are compiled of each subject.
fn cases() -> usize {
    usize::try_from(mech_test_support::cases(3)).expect("not so many")
}

/// The expansion of a mechanism.
fn expansion(text: &str) -> TokenStream {
    let text: TokenStream = text.parse().expect("tokens");
    mech_compiler::expand(quote::quote!(::mech_runtime; #text))
}

/// All identifiers in some tokens.
fn collect(tokens: TokenStream, names: &mut BTreeSet<String>) {
    for tree in tokens {
        match tree {
            TokenTree::Ident(name) => {
                names.insert(name.to_string());
            }
            TokenTree::Group(group) => collect(group.stream(), names),
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
    }
}

/// Every identifier that an expansion of a subject has, without keywords.
fn identifiers() -> Vec<String> {
    let mut names = BTreeSet::new();
    for subject in SUBJECTS {
        collect(expansion(&subject.plain()), &mut names);
    }
    names.extend(OTHERS.lines().map(str::to_owned));
    let is_name = |name: &String| syn::parse_str::<syn::Ident>(name).is_ok() && name != "gen";
    names.into_iter().filter(is_name).collect()
}

/// What the macro finds wrong with the text of a mechanism, before anything is analysed.
fn messages(text: &str) -> Vec<String> {
    let errors = syntax::parse(text.parse().expect("tokens")).errors;
    errors.into_iter().map(|error| error.text).collect()
}

/// A subject, and what is wrong with it whatever the names.
struct Tried<'s> {
    subject: &'s Subject,
    known: Vec<String>,
}

impl<'s> Tried<'s> {
    fn new(subject: &'s Subject) -> Self {
        Self { subject, known: messages(&subject.plain()) }
    }

    /// What the macro says of these names; nothing, if they are possible.
    fn refusal(&self, given: &[(Role, &str)]) -> Vec<String> {
        let mut messages = messages(&self.subject.with(given));
        messages.retain(|message| !self.known.contains(message));
        messages
    }

    /// A line that compiles it with these names.
    fn line(&self, given: &[(Role, &str)]) -> Line {
        let text = self.subject.with(given);
        let code = if self.subject.is_wrong() { left(&text) } else { invocation(&text) };
        Line::new(format!("{given:?}"), code)
    }

    /// Names for all roles, of those that are possible: the `number`th mechanism has other names in every role than all others. Those
    /// that cannot be together with others stand alone.
    fn pack(&self, fit: &[Vec<&str>], number: usize) -> Vec<Line> {
        let (mut given, mut lines): (Vec<(Role, &str)>, Vec<Line>) = (Vec::new(), Vec::new());
        for (index, (role, names)) in self.subject.roles().zip(fit).enumerate() {
            let Some(name) = names.get((number + 37 * index) % names.len().max(1)) else {
                continue;
            };
            given.push((role, name));
            if !self.refusal(&given).is_empty() {
                given.pop();
                lines.push(self.line(&[(role, name)]));
            }
        }
        lines.push(self.line(&given));
        lines
    }
}

#[test]
fn other_things_may_be_called_like_anything_in_generated_code() {
    let names = identifiers();
    assert!(names.len() > 400, "there are only {} names", names.len());
    let lines = scopes::lines(&names);
    compile("scopes", &lines);
}

#[test]
fn a_keyword_is_refused_at_its_place() {
    for subject in SUBJECTS {
        let tried = Tried::new(subject);
        for role in subject.roles() {
            for name in KEYWORDS {
                let messages = tried.refusal(&[(role, name)]);
                let is_reported =
                    messages.iter().any(|message| message.contains(&format!("`{name}`")));
                assert!(is_reported, "{role} `{name}`: {messages:?}");
            }
        }
    }
}

/// Those of some names that are tried in a role: all of them, if so many are wanted, else some that are spread over them.
fn some_of(names: &[String], role: usize, wanted: usize) -> Vec<&str> {
    let step = (names.len() / wanted.min(names.len())).max(1);
    let spread = names.iter().skip(role % step).step_by(step);
    let others = names.iter().filter(|name| OTHERS.lines().any(|other| other == *name));
    let mut some: Vec<&str> = spread.chain(others).map(String::as_str).collect();
    some.sort_unstable();
    some.dedup();
    some
}

#[test]
fn whatever_a_mechanism_has_may_be_called_like_anything_in_generated_code_or_is_refused_by_name() {
    let names = identifiers();
    let (mut lines, mut refusals) = (Vec::new(), Vec::new());
    let mut pairs = [0, 0];
    for subject in SUBJECTS {
        let tried = Tried::new(subject);
        let mut fit = Vec::new();
        for (index, role) in subject.roles().enumerate() {
            let mut fits = Vec::new();
            let mut refused = 0;
            for name in some_of(&names, index, 10 * cases()) {
                let refusal = tried.refusal(&[(role, name)]);
                if refusal.is_empty() {
                    fits.push(name);
                    continue;
                }
                let is_about = refusal.iter().any(|message| message.contains(name));
                assert!(is_about, "{role} `{name}`: {refusal:?}");
                refused += 1;
                if refused > cases() {
                    continue;
                }
                let text = subject.with(&[(role, name)]);
                let what = format!("{role} `{name}`");
                lines.push(Line::new(format!("{what}, left"), left(&text)));
                refusals.push(Line::refused(what, invocation(&text), messages(&text)));
            }
            pairs[0] += fits.len();
            pairs[1] += refused;
            fit.push(fits);
        }
        let most = fit.iter().map(Vec::len).max().unwrap_or_default();
        let wanted = cases().min(most);
        for number in (0..wanted).map(|case| case * most / wanted) {
            lines.extend(tried.pack(&fit, number));
        }
    }
    let [fit, refused] = pairs;
    println!(
        "{} identifiers; {fit} pairs of role and name that fit, {refused} that are refused; {} mechanisms compiled, {} refused",
        names.len(),
        lines.len(),
        refusals.len()
    );
    compile("names", &lines);
    compile("refused", &refusals);
}

/// The call of the macro.
fn invocation(text: &str) -> String {
    format!("::mech_runtime::mechanism! {{ {text} }}")
}

/// What the macro leaves of a mechanism that is wrong.
fn left(text: &str) -> String {
    let file: syn::File = syn::parse2(expansion(text)).expect("the expansion is Rust");
    let items = file.items.iter().filter(|item| !matches!(item, syn::Item::Macro(_)));
    quote::quote!(#(#items)*).to_string()
}
