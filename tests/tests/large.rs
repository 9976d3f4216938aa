//! Large mechanisms: the Rust compiler nests a scope for every `let` of a function, and its stack overflows at about three thousand
//! of them where there is debug information.

use super::alike::{Case, run};
use mech_test_support::chain_text;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::fmt::Write as _;

/// What a function holds at most.
const MOST_LETS: usize = 512;

/// The longest of the functions in an expansion, and its `let`s.
fn longest(text: &str) -> (String, usize) {
    let tokens: TokenStream = text.parse().expect("tokens");
    let mut longest = (String::new(), 0);
    lets(mech_compiler::expand(quote::quote!(::mech_runtime; #tokens)), &mut longest);
    longest
}

/// The `let`s of some tokens without those of the functions in them, of which the longest is put down; closures and inner blocks count.
fn lets(tokens: TokenStream, longest: &mut (String, usize)) -> usize {
    let (mut count, mut function, mut before) = (0, None, None);
    for tree in tokens {
        match &tree {
            TokenTree::Ident(word) if is_before(before.as_ref(), "fn") => {
                function = Some(word.to_string());
            }
            TokenTree::Ident(word) => {
                assert_ne!(word, "compile_error");
                let is_condition =
                    || ["if", "while", "&"].iter().any(|word| is_before(before.as_ref(), word));
                count += usize::from(word == "let" && !is_condition());
            }
            TokenTree::Group(group) => {
                let inner = lets(group.stream(), longest);
                match function.take_if(|_| group.delimiter() == Delimiter::Brace) {
                    Some(name) if inner > longest.1 => *longest = (name, inner),
                    Some(_) => {}
                    None => count += inner,
                }
            }
            // Of a function without a body.
            TokenTree::Punct(mark) if mark.as_char() == ';' => function = None,
            TokenTree::Punct(_) | TokenTree::Literal(_) => {}
        }
        before = Some(tree);
    }
    count
}

/// Whether this word or mark stood before.
fn is_before(before: Option<&TokenTree>, word: &str) -> bool {
    match before {
        Some(TokenTree::Ident(before)) => before == word,
        Some(TokenTree::Punct(before)) => word.starts_with(before.as_char()),
        _ => false,
    }
}

/// A chain whose rockers have masses, in gravity.
fn heavy(loops: usize, effects: &str) -> String {
    let mut text = chain_text(loops);
    for rocker in (0..loops).map(|number| format!("link rocker_{number};")) {
        let heavy = rocker.replace(';', " { mass 2 at (1, 2) inertia 0.5; }");
        text = text.replace(&rocker, &heavy);
    }
    text + "gravity (0, -9.81);" + effects
}

/// A chain with a few params in it.
fn variable(loops: usize, effects: &str) -> String {
    let mut text = chain_text(loops);
    for number in 0..3 {
        let name = format!("link coupler_{number};");
        let varied = format!("link coupler_{number} {{ point tip = (size_{number}, 2); }}");
        text = text.replace(&name, &varied);
        let param = format!("struct Chain; param size_{number} = 1.5;");
        text = text.replacen("struct Chain;", &param, 1);
        // The foot of a rocker, which is where it is drawn.
        text = text.replace(
            &format!(
                "j{} = revolute(ground, rocker_{number}) at ({:?}, 0.0)",
                3 * number + 3,
                3.0 * f64::from(number + 1)
            ),
            &format!(
                "j{} = revolute(ground, rocker_{number}) at ({:?} + 2 * size_{number}, 0.0)",
                3 * number + 3,
                3.0 * f64::from(number)
            ),
        );
    }
    text + effects
}

/// A crank that turns a train of gears, each of which drives a four-bar of its own.
fn geared(loops: usize) -> String {
    let mut text = "struct Geared; link wheel_0; joint shaft_0 = revolute(ground, wheel_0) at (0, 0); motor shaft_0;".to_owned();
    for number in 1..=loops {
        let (before, x) = (number - 1, 10 * number);
        let _ = write!(
            text,
            "link wheel_{number}; link rod_{number}; link rocker_{number};
            joint shaft_{number} = revolute(ground, wheel_{number}) at ({x}, 0);
            joint mesh_{number} = gear(wheel_{before}, wheel_{number}, 20 : {});
            joint pin_{number} = revolute(wheel_{number}, rod_{number}) at ({x}.3, 1);
            joint top_{number} = revolute(rod_{number}, rocker_{number}) at ({x}.3 + 3, 1.6);
            joint foot_{number} = revolute(ground, rocker_{number}) at ({x} + 3, 0);",
            20 + number % 3,
        );
    }
    text
}

/// So many sliders, each with a law of its own that is long.
fn lawful(motors: usize) -> String {
    let mut text = "struct Lawful; effects { velocity; acceleration; }".to_owned();
    for number in 0..motors {
        let _ = write!(
            text,
            "link slider_{number}; joint j_{number} = prismatic(ground, slider_{number}) at (0, {number}) along (1, 0);
            motor j_{number} = sin({number} * t) * exp(-{number} * t) * cos(2 * t) / (1 + t * t);"
        );
    }
    text
}

fn check(what: &str, text: &str) {
    let (name, lets) = longest(text);
    assert!(lets <= MOST_LETS, "{what}: `{name}` has {lets} `let`s");
}

#[test]
fn no_function_is_long_whatever_the_method() {
    for loops in [10, 200] {
        for method in ["", "method linear;", "method newton(2);", "method newton;"] {
            check(&format!("{loops} loops, {method}"), &(chain_text(loops) + method));
        }
    }
    check("600 loops", &(chain_text(600) + "method newton;"));
    check("gears", &geared(200));
    check("laws", &lawful(150));
}

#[test]
fn no_function_is_long_whatever_the_effects() {
    for loops in [10, 120] {
        let effects = [
            heavy(loops, "effects { velocity; }"),
            heavy(loops, "effects { velocity; acceleration; overlay; trace rocker_0.far 100; }")
                .replacen("link rocker_0 {", "link rocker_0 { point far = (1, 1);", 1),
            heavy(loops, "effects { velocity; acceleration; force; dynamics; overlay; }"),
            variable(loops, "effects { sensitivity; }"),
            chain_text(loops).replace("motor j0;", "motor j0 = 0.1 * sin(t);")
                + "effects { velocity; acceleration; }",
        ];
        for (number, text) in effects.iter().enumerate() {
            check(&format!("{loops} loops, effects {number}"), text);
        }
    }
}

/// Large mechanisms are compiled as users do it first, without optimisation and with all debug information, on the compiler's
/// ordinary stack; then they move as the interpreter does.
#[test]
fn large_ones_compile_in_debug() {
    let forced = heavy(60, "effects { velocity; acceleration; force; dynamics; overlay; }");
    let chains = [
        forced,
        chain_text(200),
        heavy(220, "effects { velocity; acceleration; }"),
        chain_text(600) + "method newton;",
    ];
    let (mut modules, mut calls) = (String::new(), String::new());
    for (number, text) in chains.into_iter().enumerate() {
        let motors =
            [1, 2, 3, 2, 1, 0, -1, -2_i32].map(|degrees| vec![f64::from(degrees).to_radians()]);
        let motors = motors.to_vec();
        modules += &Case { text, motors }.module::<f64>(number, "f64");
        let _ = write!(calls, "f64_{number}::run();");
    }
    let motors = 150;
    let _ = write!(modules, "mech_runtime::mechanism! {{ {} }}", lawful(motors));
    calls +=
        "let (mut lawful, t) = (Lawful::new(), 0.7_f64); lawful.at_time(t).expect(\"it moves\");";
    for number in 0..motors {
        let _ = write!(
            calls,
            "let law = ({number}.0 * t).sin() * (-{number}.0 * t).exp() * (2.0 * t).cos() / (1.0 + t * t);
            assert!((lawful.j_{number}() - law).abs() < 1e-12, \"{{law}}\");"
        );
    }
    run("large", &modules, &calls, &["-C", "debuginfo=2"]);
}
