//! What messages advise, and doing it.

use mech_compiler::compile;
use mech_compiler::repair::{Offers, Repair, edits};
use mech_compiler::reporter::repair_text;
use mech_compiler::structure::Diagnosis;

/// The repairs that are enough, in words, in the order in which they are offered; each was made to the text, and the text compiled.
pub(crate) fn repairs(text: &str) -> Vec<String> {
    let analysis = mech_compiler::analyse(text.parse().expect("tokens"));
    let faults = analysis.result.err().into_iter();
    let offers = faults.flat_map(|faults| faults.offers);
    let parsed = &analysis.parsed;
    let mut found = Vec::new();
    for repairs in offers.flat_map(|offers| enough(&offers)) {
        let words = repair_text(&repairs, &parsed.model);
        let edits = edits(&repairs, &parsed.model, parsed.source.tokens());
        let changed = edits.and_then(|edits| parsed.source.model_with(&edits));
        let Some(changed) = changed else {
            // What is drawn has to be drawn anew, by hand.
            let is_start = matches!(repairs[..], [Repair::StartAt { .. }]);
            assert!(is_start, "cannot be made: {words}\n{text}");
            continue;
        };
        if let Err(wrong) = compile(&changed) {
            let several = matches!(wrong[..], [Diagnosis::SeveralAssemblies { .. }]);
            assert!(several, "{words}: {wrong:?}\n{text}");
        }
        if !found.contains(&words) {
            found.push(words);
        }
    }
    found
}

/// What is offered as enough: single changes, and those that are made together.
fn enough(offers: &Offers) -> Vec<Vec<Repair>> {
    let single = offers.single.iter().map(|repair| vec![repair.clone()]);
    let coupled = offers.coupled.iter();
    let coupled = coupled.map(|repair| vec![repair.clone(), Repair::AllowCoupled]);
    let pairs = offers.pairs.iter().map(|pair| pair.to_vec());
    single.chain(coupled).chain(pairs).collect()
}

/// What the compiler says of a text, as the macro does.
pub(crate) fn messages(text: &str) -> Vec<String> {
    let analysis = mech_compiler::analyse(text.parse().expect("tokens"));
    let faults = analysis.result.err().into_iter();
    let messages = faults.flat_map(|faults| faults.messages);
    messages.map(|message| message.text).collect()
}

/// The lines of help, without the words that join them.
fn help(message: &str) -> impl Iterator<Item = &str> {
    message.lines().filter_map(|line| {
        let line = line.trim().strip_prefix("help: ")?;
        let line = line.strip_prefix("or ").unwrap_or(line);
        let line = line.strip_prefix("for this alone, ").unwrap_or(line);
        Some(line.strip_prefix("together: ").unwrap_or(line))
    })
}

/// Each thing that could be done, in the order in which it is offered.
pub(crate) fn alternatives(message: &str) -> Vec<String> {
    let mut all = Vec::new();
    for phrase in help(message).flat_map(|line| line.split(", or ")) {
        match phrase.strip_prefix("remove ") {
            Some(list) if !list.contains(" and ") => {
                let names = list.split("`, `").flat_map(|names| names.split("` or `"));
                let names = names.map(|name| format!("remove `{}`", name.trim_matches('`')));
                all.extend(names);
            }
            _ => all.push(phrase.to_owned()),
        }
    }
    all
}

/// The advice that is written out in the words of the language, the whole line of it.
pub(crate) fn written_out(message: &str) -> Vec<String> {
    let is_written = |line: &&str| line.contains(": add `") || line.contains(": write `");
    let lines = help(message).filter(is_written);
    lines
        // Two changes at once are tried as data, by `repairs`.
        .filter(|line| line.matches(": add `").count() + line.matches(": write `").count() == 1)
        .filter(|line| !line.contains("` and `"))
        // So are links, with their joints.
        .filter(|line| !line.starts_with("remove ") && !line.contains(": write `link "))
        .map(str::to_owned)
        .collect()
}

/// The text of a mechanism after what is written out was done.
pub(crate) fn mend(text: &str, advice: &str) -> String {
    let quoted: Vec<&str> =
        advice[advice.find(": ").expect("a colon")..].split('`').skip(1).step_by(2).collect();
    let added = advice.contains(": add `");
    let replaced = quoted.iter().skip(usize::from(added));
    let name = |statement: &str| statement.split_whitespace().nth(1).map(str::to_owned);
    let left = replaced
        .filter_map(|statement| name(statement))
        .fold(text.to_owned(), |text, joint| without(&text, &joint));
    left + quoted.first().expect("a statement") + "\n"
}

/// The text without a joint.
fn without(text: &str, joint: &str) -> String {
    let start = text
        .find(&format!("joint {joint} ="))
        .unwrap_or_else(|| panic!("no joint {joint}\n{text}"));
    let end = start + text[start..].find(';').expect("a semicolon") + 1;
    format!("{}{}", &text[..start], &text[end..])
}
