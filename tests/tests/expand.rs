//! What people see who look at the generated code. Renew with `INSTA_UPDATE=always cargo test -p mech-tests --test compiler expand`,
//! and read it.

use mech_test_support::{bodies, four_bar_text};
use proc_macro2::{TokenStream, TokenTree};
use quote::ToTokens as _;
use std::fs;
use std::path::Path;

fn expansion(text: &str) -> String {
    let text: TokenStream = text.parse().expect("tokens");
    let tokens = mech_compiler::expand(quote::quote!(::mech_runtime; #text));
    prettyplease::unparse(&syn::parse2(tokens).expect("the expansion is Rust"))
}

/// The part in which everything is solved, without the accessors around it.
fn solving(text: &str) -> String {
    let all = expansion(text);
    let start = all.find("        /// Loop 1").unwrap_or(0);
    all.split_at(start).1.to_owned()
}

/// One of the modules in an expansion.
fn module<'a>(all: &'a str, name: &str) -> &'a str {
    let start = all.find(&format!("        mod {name} {{"));
    let start = start.unwrap_or_else(|| panic!("a module `{name}`"));
    let length = all[start..].find("\n        }\n").expect("its end");
    &all[start..start + length]
}

#[test]
fn a_whole_mechanism() {
    insta::assert_snapshot!(expansion(
        "/// A crank on the ground.
        pub struct Crank;
        look none;
        ground { point shaft = (0, 0); circle (0, 0) radius 2 on plane 0 color 1; }
        link crank { point shaft = (0, 0); point pin = (1, 0); }
        joint a = revolute(ground.shaft, crank.shaft);
        motor a;
        start { a = 30 deg; }"
    ));
}

#[test]
fn a_four_bar_with_a_fixed_number_of_rounds() {
    insta::assert_snapshot!(solving(
        "struct FourBar;
        link crank; link coupler; link rocker;
        joint a = revolute(ground, crank) at (0, 0);
        joint b = revolute(crank, coupler) at (0.8, 0.6);
        joint c = revolute(coupler, rocker) at (3.3, 2.9);
        joint d = revolute(ground, rocker) at (4, 0);
        motor a;
        method newton(3);"
    ));
}

#[test]
fn the_paper_s_figure_1() {
    insta::assert_snapshot!(solving(
        "struct GearedPiston;
        ground {
            point pinion_shaft = (-3.0, 0.0);
            point wheel_shaft = (0.0, 0.0);
            line bore = (0.0, 0.0) -> (1.0, 0.0);
        }
        link pinion { point shaft = (0.0, 0.0); }
        link wheel  { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
        link rod    { point big_end = (0.0, 0.0); point small_end = (4.0, 0.0); }
        link piston { point pin = (0.0, 0.0); line axis = (0.0, 0.0) -> (1.0, 0.0); }
        joint d = revolute(ground.pinion_shaft, pinion.shaft);
        joint e = revolute(ground.wheel_shaft, wheel.shaft);
        joint mesh = gear(pinion, wheel, 20 : 40);
        joint f = revolute(wheel.pin, rod.big_end);
        joint g = revolute(rod.small_end, piston.pin);
        joint h = prismatic(ground.bore, piston.axis);
        motor d;
        start { rod near 0 deg; }"
    ));
}

#[test]
fn a_mechanism_with_errors() {
    insta::assert_snapshot!(expansion(
        "struct Lost;
        link crank { point shaft = (0, 0); }
        joint a = revolute(ground.shaft, crank.shaft);
        motor a;"
    ));
}

/// The four-bar of which effects are shown.
fn four_bar(effects: &str) -> String {
    let start = format!("start {{ coupler near 50 deg; }} {effects}");
    four_bar_text([4.0, 1.0, 3.5, 3.0]) + &start
}

#[test]
fn velocities_and_accelerations() {
    let text = four_bar("effects { velocity; acceleration; }");
    insta::assert_snapshot!(module(&expansion(&text), "rates"));
}

/// The lines that are there with effects and not without.
fn lines_added_by(effects: &str) -> String {
    let without = expansion(&four_bar(""));
    let lines: Vec<&str> = without.lines().collect();
    let all = expansion(&four_bar(effects));
    let added = all.lines().filter(|line| !lines.contains(line));
    added.collect::<Vec<_>>().join("\n")
}

#[test]
fn what_a_trace_adds() {
    insta::assert_snapshot!(lines_added_by("effects { trace coupler.c 256; }"));
}

#[test]
fn what_an_overlay_adds() {
    insta::assert_snapshot!(lines_added_by("effects { overlay; }"));
}

#[test]
fn a_param_and_what_follows_it() {
    let varied = four_bar("")
        .replacen(';', "; param rod = 3.5; const HALF = rod / 2;", 1)
        .replace("(3.5, 0);", "(rod, 0); point tip = (HALF, 1);");
    insta::assert_snapshot!(expansion(&format!(
        "{varied} effects {{ sensitivity; }} show coupler.tip, jd;"
    )));
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
    assert!(solving(&four_bar(sprung)).contains("jd_angle"));
    // What acts costs nothing as long as nobody asks what it does.
    let plain = four_bar("look none;");
    let heavy = plain.replace("point b = (1, 0);", "point b = (1, 0); mass 2 at (0.5, 0);");
    assert_ne!(heavy, plain);
    assert_eq!(
        expansion(&format!(
            "{heavy} gravity (0, -9.81); spring s = torsional(jd) stiffness 2;"
        )),
        expansion(&plain)
    );
}

#[test]
fn what_torques_at_rest_add() {
    let all = expansion(&four_bar(
        "load push = force(coupler.c); effects { force; }",
    ));
    let all = module(&all, "holding");
    let from = all.find("            /// The position at these motor values, what holds it there");
    let to = all.find("            pub(super) fn step_reduced");
    let part = from.zip(to).map(|(from, to)| &all[from..to]);
    insta::assert_snapshot!(part.expect("a step that goes on to torques"));
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

#[test]
fn motors_that_follow_laws() {
    let text = "struct Swing: f32;
        const SLOW = 0.5;
        ground { point o = (0, 0); line rail = (0, 0) -> (0, 1); }
        link arm { point shaft = (0, 0); point tip = (1, 0); }
        link hand { point wrist = (0, 0); }
        link cart { line rail = (0, 0) -> (0, 1); }
        joint a = revolute(ground.o, arm.shaft);
        joint b = revolute(arm.tip, hand.wrist);
        joint c = prismatic(ground.rail, cart.rail);
        motor a = 2 * PI * t;
        motor b;
        motor c = max(0, exp(-SLOW * t) * sin(3 * t)) / (1 + t);
        effects { velocity; }";
    let all = expansion(text);
    let start = all
        .find("            /// Moves the motors that follow laws")
        .expect("a method");
    let end = "\n            }\n";
    let length = all[start..].find(end).expect("its end") + end.len();
    let method = &all[start..start + length];
    insta::assert_snapshot!(format!("{method}\n{}", module(&all, "laws")));
}

#[test]
fn a_cam_and_what_follows_it() {
    let text = "struct Lifter;
        ground { point o = (0, 0); line guide = (0, 1) -> (0, 1); }
        link disk { point o = (0, 0); }
        link valve { line stem = (0, 0) -> (0, 1); }
        joint a = revolute(ground.o, disk.o);
        joint h = prismatic(ground.guide, valve.stem);
        joint c = cam(a, h, 0.2 * (1 - cos(q)) + max(0, 0.1 * sin(2 * q)));
        motor a;
        effects { velocity; }";
    let all = expansion(text);
    let start = all
        .find("        /// The position at these motor values, and for each loop a margin")
        .expect("a step");
    insta::assert_snapshot!(all.split_at(start).1);
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
    for folder in [
        "tests",
        "examples",
        "studio",
        "docs",
        "mech-runtime",
        "mech-macros",
    ] {
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
