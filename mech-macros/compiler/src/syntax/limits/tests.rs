use super::{Limit, of_text, of_tokens};
use crate::expand::expand;
use crate::syntax::{self, Tokens};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use std::fmt::Write;

/// A text that has so many of what is limited, and nothing else without measure; none if only a mechanism has them.
fn text_with(limit: Limit, many: usize) -> Option<String> {
    Some(match limit {
        Limit::Length => format!("struct A; //{}", "x".repeat(many - 12)),
        Limit::Depth => format!(
            "struct A; link a {{ point p = {}1{}; }}",
            "(".repeat(many - 1),
            ")".repeat(many - 1)
        ),
        Limit::Number => format!("struct A; const N = {};", "9".repeat(many)),
        Limit::Word => format!("struct A; link {};", "a".repeat(many)),
        Limit::Tokens => format!("struct A; const N = 1 {}", "+ 1 ".repeat(many / 2 - 4) + ";"),
        Limit::Statements => format!("struct A{}", ";".repeat(many)),
        _ => return None,
    })
}

#[test]
fn what_is_at_a_limit_is_read_and_what_is_beyond_is_not() {
    for limit in Limit::ALL {
        let most = limit.most();
        let Some(text) = text_with(limit, most) else {
            continue;
        };
        assert_eq!(of_text(&text), Ok(()), "{limit:?}");
        let beyond = text_with(limit, most + 2).expect("a text");
        let excess = of_text(&beyond).expect_err("it is beyond");
        assert_eq!(excess.limit, limit);
        assert!(excess.place.end <= beyond.len(), "{limit:?}");
        // The places of tokens are the same, but nobody counts bytes there.
        proc_macro2::extra::invalidate_current_thread_spans();
        let tokens = |text: &str| text.parse::<TokenStream>().expect("tokens");
        if limit != Limit::Length {
            assert!(of_tokens(&tokens(&text)).is_ok(), "{limit:?}");
            let found = of_tokens(&tokens(&beyond)).expect_err("it is beyond");
            assert_eq!(found.limit, limit);
            assert_eq!(found.place.byte_range(), excess.place, "{limit:?}");
            let parsed = syntax::parse(tokens(&beyond));
            let said: Vec<&str> = parsed.errors.iter().map(|error| &*error.text).collect();
            assert_eq!(said, [limit.to_string()]);
            assert_eq!(parsed.header.expect("a header").name, "A");
        }
    }
}

#[test]
fn what_stands_in_comments_and_quotes_is_not_counted() {
    let many = "(".repeat(2 * Limit::Depth.most());
    for text in [
        format!("// {many}"),
        format!("/* /* {many} */ {many} */"),
        format!("\"{many}\""),
        format!("r#\"{many}\"#"),
        "'(' ".repeat(2 * Limit::Depth.most()),
    ] {
        assert_eq!(of_text(&text), Ok(()));
    }
}

#[test]
fn quotes_and_comments_without_an_end_do_not_take_the_square_of_their_number() {
    for piece in ["/*", "\"\\", "r#\"", "'\\", "b'\\", "cr\""] {
        let text = piece.repeat(Limit::Length.most() / piece.len());
        // Whatever is said of it: it is said soon.
        let _ = of_text(&text);
    }
}

#[test]
fn brackets_that_no_stack_holds_are_an_error_of_the_macro() {
    let mut deep = TokenStream::new();
    for _ in 0..200_000 {
        deep = TokenTree::from(Group::new(Delimiter::Parenthesis, deep)).into();
    }
    let excess = of_tokens(&deep).expect_err("it is deep");
    assert_eq!(excess.limit, Limit::Depth);
    assert_eq!(Tokens::of(deep.clone()).places().count(), 400_000);
    let mut text: TokenStream = "krate; struct A; const N = ".parse().expect("tokens");
    text.extend(deep);
    let written = expand(text).to_string();
    assert!(written.contains(&Limit::Depth.to_string()), "{written}");
}

#[test]
fn what_is_computed_of_links_has_limits_of_its_own() {
    let text = |count: usize, effects: &str| {
        format!(
            "struct A; ground {{ point o = (0, 0); }} link axle {{ point o = (0, 0); }}
            joint main = revolute(ground.o, axle.o); motor main;
            part Flap {{ port frame {{ point o = (0, 0); }} link flap {{ point o = (0, 0); mass 1 at (1, 0); }}
            joint o = revolute(frame.o, flap.o); }}
            use flap[{count}]: Flap {{ frame = ground }}; effects {{ {effects} }}"
        )
    };
    for (limit, effects, word) in [
        (Limit::Rates, "velocity;", "velocity"),
        (Limit::Rates, "velocity; acceleration;", "velocity"),
        (Limit::Forces, "force;", "force"),
        (Limit::Forces, "velocity; dynamics;", "dynamics"),
    ] {
        let said = |count: usize| {
            proc_macro2::extra::invalidate_current_thread_spans();
            let text = text(count, effects);
            let parsed = syntax::parse(text.parse().expect("tokens"));
            let errors = parsed.errors.into_iter().map(|error| {
                let place = error.place.start.byte_range();
                (text[place].to_owned(), error.text)
            });
            errors.collect::<Vec<_>>()
        };
        assert_eq!(said(limit.most() - 1), [], "{effects}");
        assert_eq!(said(limit.most()), [(word.to_owned(), limit.to_string())]);
    }
}

#[test]
fn the_page_of_limits_tells_them_all() {
    let mut table = String::new();
    for limit in Limit::ALL {
        let [subject, counted] = limit.words();
        let subject = subject.trim_start_matches("this ");
        writeln!(table, "| {counted} | a {subject} | {} |", limit.most()).expect("a line");
    }
    let page = include_str!("../../../../../docs/limits.md");
    assert!(page.contains(&table), "docs/limits.md needs these rows:\n{table}");
}
