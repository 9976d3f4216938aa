//! What the page for embedded developers quotes stands in a program that is built and run, word for word.

use mech_test_support::repository;
use std::fs;

/// Before a quotation: from which file it is.
const FROM: &str = "<!-- from ";

fn read(path: &str) -> String {
    let text = fs::read_to_string(repository().join(path));
    text.unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Whether these lines stand in a text, one after the other, perhaps all deeper by the same.
fn stands_in(quoted: &[&str], text: &str) -> bool {
    let lines: Vec<_> = text.lines().collect();
    lines.windows(quoted.len()).any(|window| {
        [0, 4, 8].iter().any(|&depth| {
            let margin = " ".repeat(depth);
            quoted.iter().zip(window).all(|(quoted, line)| {
                quoted.is_empty() && line.is_empty() || line.strip_prefix(&margin) == Some(*quoted)
            })
        })
    })
}

#[test]
fn what_is_quoted_is_built() {
    let page = read("docs/embedded.md");
    let mut lines = page.lines().peekable();
    let mut previous = "";
    let mut quotations = 0;
    while let Some(line) = lines.next() {
        if matches!(line, "```rust" | "```toml") {
            let from = previous.strip_prefix(FROM);
            let file = from.and_then(|line| line.strip_suffix(" -->"));
            let quoted: Vec<_> = lines.by_ref().take_while(|line| *line != "```").collect();
            // What goes into a project of somebody's own is nowhere here.
            let Some(file) = file else {
                assert_eq!(line, "```toml", "from which file is {quoted:#?}");
                continue;
            };
            assert!(
                !quoted.is_empty() && stands_in(&quoted, &read(file)),
                "not in {file}: {quoted:#?}"
            );
            quotations += 1;
        }
        previous = line;
    }
    assert!(quotations >= 8, "only {quotations} quotations");
}

#[test]
fn what_is_linked_is_there() {
    let page = read("docs/embedded.md");
    let links = page.split("](").skip(1).filter_map(|link| link.split(')').next());
    for link in links.filter(|link| !link.starts_with("http") && !link.starts_with('#')) {
        let file = link.split('#').next().unwrap_or_default();
        assert!(repository().join("docs").join(file).exists(), "{link}");
    }
}
