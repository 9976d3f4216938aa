//! The public names of a mechanism and of the runtime, as Rust sees them.

use super::{files_in, text_of};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::BTreeSet;

/// Methods and constants of mechanisms that get everything between them.
pub(super) fn generated() -> Vec<String> {
    let mut found = BTreeSet::new();
    for text in include_str!("mechanisms.txt").split("\n\n") {
        let tokens = format!("mech_runtime; {text}").parse().expect("tokens");
        let items = mech_compiler::expand(tokens);
        assert!(!items.to_string().contains("compile_error"), "{text}");
        add_public(items, "", "mod", &mut found);
    }
    // Which of the types it writes has a method is the macro's own affair.
    let names = found.iter().filter_map(|path| path.rsplit("::").next());
    let names: BTreeSet<&str> = names.collect();
    names.into_iter().map(str::to_owned).collect()
}

/// Lists the public names in the sources of the runtime, and those of its core that it shows.
pub(super) fn runtime() -> Vec<String> {
    let mut found = BTreeSet::new();
    let files = |folder: &str| files_in(&format!("mech-runtime/{folder}"), ".rs");
    let core = "joint.rs outline.rs phase pose.rs real.rs symbol.rs".split(' ');
    let core = core.flat_map(|file| files(&format!("core/src/{file}")));
    for path in files("src").into_iter().chain(core) {
        let tokens = text_of(&path).parse().expect("tokens");
        if !path.contains("/generated/") {
            add_public(tokens, "", "mod", &mut found);
        }
    }
    found.into_iter().collect()
}

/// Adds the public names within an owner of a kind: of a `mod`, `impl`, `struct`, `enum` or `trait`.
fn add_public(tokens: TokenStream, owner: &str, kind: &str, found: &mut BTreeSet<String>) {
    const KINDS: [&str; 7] = ["const", "fn", "struct", "enum", "trait", "type", "mod"];
    let path = |name: &str| [owner, name].join("::").trim_start_matches(':').to_owned();
    // The words since something ended, those in `<…>` apart.
    let (mut words, mut depth, mut before): (Vec<String>, _, _) = (Vec::new(), 0, ' ');
    for tree in tokens {
        let is_public = kind == "trait" || words.first().is_some_and(|word| word == "pub");
        let last = words.last().cloned().unwrap_or_default();
        match tree {
            TokenTree::Ident(word) if depth == 0 => {
                let word = word.to_string();
                let is_declared = is_public && KINDS.contains(&&*last) && word != "fn";
                if is_declared || kind == "enum" && words.is_empty() {
                    found.insert(path(&word));
                }
                words.push(word);
            }
            TokenTree::Punct(sign) => {
                let (sign, is_use) = (sign.as_char(), words.iter().any(|word| word == "use"));
                depth += i32::from(sign == '<') - i32::from(sign == '>' && before != '-');
                let is_field = kind == "struct" && sign == ':' && words.len() == 2;
                if is_public && (is_field || is_use && sign == ';') {
                    found.insert(path(&last));
                }
                if depth == 0 && (sign == ';' || sign == ',') {
                    words.clear();
                }
                before = sign;
            }
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let after = |kind: &str| words.iter().skip_while(|word| *word != kind).nth(1);
                let bare = words.iter().take_while(|word| *word != "where");
                if let (Some(_), Some(owner)) = (after("impl"), bare.last()) {
                    add_public(group.stream(), owner, "impl", found);
                } else if after("mod").is_some() || after("const").is_some() {
                    add_public(group.stream(), owner, "mod", found);
                } else if is_public && after("use").is_some() {
                    add_public(group.stream(), owner, "enum", found);
                }
                for kind in ["struct", "enum", "trait"] {
                    if let Some(name) = after(kind).filter(|_| is_public) {
                        add_public(group.stream(), name, kind, found);
                    }
                }
                words.clear();
            }
            // `pub(crate)` is not public.
            TokenTree::Group(_) if last == "pub" => words.clear(),
            _ => {}
        }
    }
}
