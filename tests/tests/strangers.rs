//! Texts that no friend sends: each is told what is wrong with it, or moves, before anybody gives up. No clock is read: what once took the
//! square or the cube of its length would not end here.

use mech_compiler::cancel::Cancellation;
use mech_compiler::limits::Limit;
use mech_compiler::{analyse, syntax::Message};
use mech_test_support::chain_text;
use std::thread;
use std::time::Duration;

/// A text of something that stands there for each number.
fn many(count: usize, each: impl Fn(usize) -> String) -> String {
    let statements: String = (0..count).map(each).collect();
    format!("struct Many; {statements}")
}

/// What is said of a text.
fn said(text: &str) -> Vec<String> {
    let analysis = analyse(text.parse().expect("tokens"));
    let faults = analysis.result.err();
    let messages = faults.map_or(Vec::new(), |faults| faults.messages);
    messages.into_iter().map(|message| message.text).collect()
}

#[test]
fn of_many_faults_the_first_are_told_and_the_others_counted() {
    let count = 2500;
    let loose = many(count, |number| format!("link a{number};"));
    let unknown =
        many(count, |number| format!("joint j{number} = revolute(ground, a{number}) at (0, 0);"));
    let empty = many(count, |_| ";".to_owned());
    for text in [loose, unknown, empty] {
        let said = said(&text);
        assert_eq!(said.len(), Message::MOST + 1);
        let last = said.last().expect("a message");
        let others = format!("there are {} more", count - Message::MOST);
        assert!(last.starts_with(&others), "{last}");
    }
}

#[test]
fn a_mechanism_beyond_a_limit_is_told_so_and_nothing_else() {
    let links = many(Limit::Links.most() + 1, |number| format!("link a{number};"));
    assert_eq!(said(&links), [Limit::Links.to_string()]);
    // Each part uses the one before twice.
    let parts = many(40, |number| match number {
        0 => "part P0() { link x; }".to_owned(),
        _ => {
            format!("part P{number}() {{ use u: P{0}() {{ }}; use v: P{0}() {{ }}; }}", number - 1)
        }
    });
    let doubled = said(&(parts + "use all: P39() { };"));
    assert_eq!(doubled.len(), 1);
    assert!(doubled[0].starts_with(&Limit::Instances.to_string()), "{}", doubled[0]);
}

#[test]
fn many_links_without_motors_are_told_what_they_need() {
    let chain = many(800, |number| {
        let before = match number {
            0 => "ground".to_owned(),
            _ => format!("a{}", number - 1),
        };
        format!("link a{number}; joint j{number} = revolute({before}, a{number}) at (0, {number});")
    });
    let said = said(&chain);
    assert!(said[0].starts_with("there is no motor"), "{}", said[0]);
}

#[test]
fn many_dyads_in_a_row_move() {
    let text = many(700, |number| {
        let (link, [before, left, x]) = (number + 1, [number, 3 * number, 3 * number + 3]);
        let first = match number {
            0 => "link r0; joint a = revolute(ground, r0) at (0, 0); motor a;",
            _ => "",
        };
        format!(
            "{first} link k{link}; link r{link}; joint b{link} = revolute(r{before}, k{link}) at ({left}, 1);
            joint c{link} = revolute(k{link}, r{link}) at ({x}, 2); joint d{link} = revolute(r{link}, ground) at ({x}, 0);"
        )
    });
    assert_eq!(said(&text), [""; 0]);
}

#[test]
fn a_flag_ends_the_analysis_of_a_large_mechanism() {
    let cancellation = Cancellation::default();
    let setter = cancellation.clone();
    let waiting = thread::spawn(move || {
        thread::sleep(Duration::from_millis(100));
        setter.set();
    });
    let text = chain_text(900);
    // Without the flag it would go on for ever.
    let done: Option<()> = cancellation.heed(|| {
        loop {
            drop(said(&text));
        }
    });
    assert_eq!(done, None);
    waiting.join().expect("it only waits");
}
