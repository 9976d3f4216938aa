//! What people see who look at the code that is generated for the texts in `tests/cases/expanded`. Renew with
//! `INSTA_UPDATE=always cargo test -p mech-tests --test compiler expand`, and read it.

use mech_test_support::{bodies, folder, four_bar_text};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens as _;
use std::fs;
use std::path::Path;

fn expansion(text: &str) -> String {
    let text: TokenStream = text.parse().expect("tokens");
    let tokens = mech_compiler::expand(quote::quote!(::mech_runtime; #text));
    prettyplease::unparse(&syn::parse2(tokens).expect("the expansion is Rust"))
}

/// What a snapshot shows of a text: what the lines `//:` before it say, or all.
///
/// - `item` shows what begins with these words, until its brace closes.
/// - `rest` shows all from these words on.
/// - `added` shows the lines that are there because of the last line of the text.
fn shown(text: &str) -> String {
    let all = expansion(text);
    let mut shown = Vec::new();
    for wish in text.lines().map_while(|line| line.strip_prefix("//: ")) {
        let (kind, words) = wish.split_once(' ').expect("words");
        let rest = all.lines().skip_while(|line| !line.trim_start().starts_with(words));
        match kind {
            "item" => {
                let first = rest.clone().next().expect(words);
                let indent = first.len() - first.trim_start().len();
                let end = format!("{:indent$}}}", "");
                shown.extend(rest.take_while(|line| *line != end).map(str::to_owned));
                shown.push(end);
            }
            "rest" => shown.extend(rest.map(str::to_owned)),
            "added" => {
                let (before, _) = text.trim_end().rsplit_once('\n').expect("lines");
                let without = expansion(before);
                let known: Vec<&str> = without.lines().collect();
                let added = all.lines().filter(|line| !known.contains(line));
                shown.extend(added.map(str::to_owned));
            }
            _ => panic!("nothing is shown by `{wish}`"),
        }
        assert!(!shown.is_empty(), "{wish}");
    }
    if shown.is_empty() { all } else { shown.join("\n") }
}

#[test]
fn texts_of_the_folder() {
    let cases = folder("expanded");
    for case in &cases {
        insta::assert_snapshot!(&*case.name, shown(&case.text));
    }
    assert!(cases.len() >= 11, "{}", cases.len());
}

/// One of the modules in an expansion.
fn module<'a>(all: &'a str, name: &str) -> &'a str {
    let start = all.find(&format!("        mod {name} {{"));
    let start = start.unwrap_or_else(|| panic!("a module `{name}`"));
    let length = all[start..].find("\n        }\n").expect("its end");
    &all[start..start + length]
}

/// The four-bar of which effects are shown.
fn four_bar(effects: &str) -> String {
    let start = format!("start {{ coupler near 50 deg; }} {effects}");
    four_bar_text([4.0, 1.0, 3.5, 3.0]) + &start
}

/// What nobody asked for costs nothing: the step to a position is the same, token for token, whatever effects there are.
#[test]
fn the_step_to_a_position_never_knew_of_effects() {
    let step = |effects: &str| module(&expansion(&four_bar(effects)), "positions").to_owned();
    let alone = step("");
    assert!(alone.contains("fn step_reduced("));
    let all = [
        "effects { velocity; }",
        "effects { velocity; acceleration; }",
        "effects { trace coupler.c 64; }",
        "effects { overlay; }",
        "load push = force(coupler.c); effects { force; }",
        "load push = force(coupler.c); spring s = torsional(ja) stiffness 2; effects { velocity; acceleration; force; overlay; }",
    ];
    for effects in all {
        assert_eq!(step(effects), alone, "{effects}");
    }
    // Only a torsional spring at a joint that no motor drives has something carried: the angle of that joint.
    let sprung = "spring s = torsional(jd) stiffness 2; effects { force; }";
    let all = expansion(&four_bar(sprung));
    let (_, solving) = all.split_once("/// Loop 1").expect("a loop");
    assert!(solving.contains("jd_angle"));
    // What acts costs nothing as long as nobody asks what it does.
    let plain = four_bar("look none;");
    let heavy = plain.replace("point b = (1, 0);", "point b = (1, 0); mass 2 at (0.5, 0);");
    assert_ne!(heavy, plain);
    assert_eq!(
        expansion(&format!("{heavy} gravity (0, -9.81); spring s = torsional(jd) stiffness 2;")),
        expansion(&plain)
    );
}

/// The Rust compiler's stack does not hold thousands of brackets in one another.
#[test]
fn long_laws_are_not_deep() {
    let law = vec!["t"; 490].join(" * ");
    let text = format!(
        "struct M; ground {{ point o = (0, 0); }} link a {{ point o = (0, 0); }}
        joint j = revolute(ground.o, a.o); motor j = {law}; effects {{ acceleration; }}"
    );
    let text: TokenStream = text.parse().expect("tokens");
    let tokens = mech_compiler::expand(quote::quote!(::mech_runtime; #text)).to_string();
    let (mut depth, mut deepest) = (0, 0);
    for character in tokens.chars() {
        match character {
            '(' => depth += 1,
            ')' => depth -= 1,
            _ => {}
        }
        deepest = deepest.max(depth);
    }
    assert!(deepest < 100, "{deepest}");
}

/// Equal cranks under a table: all but two hold it again, and share what they are compared with.
#[test]
fn rows_of_equal_cranks_expand() {
    for (cranks, precision) in [(3, "f64"), (4, "f64"), (4, "f32"), (7, "f64")] {
        let mut text = format!("struct Row: {precision}; link table; allow redundant;");
        for crank in 0..cranks {
            text += &format!(
                "link c{crank}; joint a{crank} = revolute(ground, c{crank}) at ({crank}, 0);
                joint b{crank} = revolute(c{crank}, table) at ({crank}.5, 1);"
            );
        }
        let all = expansion(&(text + "motor a0;"));
        assert!(!all.contains("compile_error"), "{cranks} cranks: {all}");
    }
}

/// Everything that a test, an example or a page declares expands to Rust, if the analysis finds nothing wrong.
#[test]
fn what_the_analysis_accepts_expands() {
    let mut texts = Vec::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    for folder in ["tests", "examples", "studio", "docs", "mech-runtime", "mech-macros"] {
        collect(&root.join(folder), &mut texts);
    }
    let mut expanded = 0;
    for text in texts {
        let analysis = mech_compiler::analyse(text.clone());
        if analysis.result.is_err() {
            continue;
        }
        let written = mech_compiler::catch(|| {
            mech_compiler::write(&quote::quote!(::mech_runtime), &analysis)
        });
        let written = written.unwrap_or_else(|what| panic!("{what}: {text}"));
        assert!(syn::parse2::<syn::File>(written).is_ok(), "{text}");
        expanded += 1;
    }
    assert!(expanded > 200, "only {expanded} texts were found");
}

/// The texts of mechanisms in all files of a folder: in calls of the macro, in strings, and in files and pages of their own.
fn collect(path: &Path, texts: &mut Vec<TokenStream>) {
    if path.is_dir() {
        if !path.ends_with("target") {
            let entries = fs::read_dir(path).expect("a folder").flatten();
            entries.for_each(|entry| collect(&entry.path(), texts));
        }
        return;
    }
    let kind = path.extension().and_then(|kind| kind.to_str());
    let Ok(text) = fs::read_to_string(path) else {
        return;
    };
    match kind {
        Some("rs") => {
            let Ok(tokens) = text.parse::<TokenStream>() else {
                return;
            };
            texts.extend(bodies(&text));
            strings(tokens, texts);
        }
        Some("md") => texts.extend(text.split("```").skip(1).step_by(2).filter_map(text_in)),
        Some("mech") => texts.extend(text_in(&text)),
        _ => {}
    }
}

fn strings(tokens: TokenStream, texts: &mut Vec<TokenStream>) {
    for tree in tokens {
        match tree {
            TokenTree::Group(group) => strings(group.stream(), texts),
            TokenTree::Literal(literal) => {
                let literal = syn::parse2::<syn::LitStr>(literal.into_token_stream());
                texts.extend(literal.ok().and_then(|literal| text_in(&literal.value())));
            }
            _ => {}
        }
    }
}

/// A text that declares a mechanism, perhaps.
fn text_in(text: &str) -> Option<TokenStream> {
    let declares = text.contains("struct ") && text.contains("motor ");
    let text = text.trim_start_matches("text").trim_start_matches("rust");
    declares.then(|| text.parse().ok())?
}
