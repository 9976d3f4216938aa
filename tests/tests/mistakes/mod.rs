//! Mistakes that people make who draw mechanisms: the repair that a teacher would give is offered first or second, and whatever is
//! written out can be pasted.

mod advice;
mod forgotten;

use advice::{alternatives, messages, repairs};
use std::panic::catch_unwind;

/// A mechanism as it is drawn: points with their places, links by the letters of their points, what is pinned to the ground, and
/// what else there is.
#[derive(Default)]
struct Drawing<'t> {
    points: Vec<(char, &'t str)>,
    links: Vec<&'t str>,
    grounded: &'t str,
    others: String,
}

/// How the ends of links are given.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Style {
    /// As points with names.
    Points,
    /// As the ends of bars.
    Bars,
    /// Not at all: only joints have places.
    Bare,
}

impl Drawing<'_> {
    fn place(&self, letter: char) -> &str {
        let mut points = self.points.iter();
        points.find(|point| point.0 == letter).expect("a point").1
    }

    fn link(&self, letters: &str, style: Style) -> String {
        let name = letters.to_lowercase();
        let places: Vec<&str> = letters.chars().map(|letter| self.place(letter)).collect();
        let points = name.chars().zip(&places);
        let points: Vec<String> =
            points.map(|(point, place)| format!("point {point} = {place};")).collect();
        match style {
            Style::Points => format!("link {name} {{ {} }}\n", points.join(" ")),
            Style::Bars => format!("link {name} {{ bar [{}] width 0.1; }}\n", places.join(", ")),
            Style::Bare => format!("link {name};\n"),
        }
    }

    /// The joints of a point: all links there turn on the first, or on the ground.
    fn joints(&self, letter: char) -> String {
        let here = |link: &&&str| link.contains(letter);
        let links = self.links.iter().filter(here);
        let mut links: Vec<String> = links.map(|link| link.to_lowercase()).collect();
        if self.grounded.contains(letter) {
            links.insert(0, "ground".to_owned());
        }
        let name = letter.to_ascii_lowercase();
        let others = links.iter().skip(1).enumerate();
        let joint = |(number, other): (usize, &String)| {
            let number = if number == 0 { String::new() } else { (number + 1).to_string() };
            let place = self.place(letter);
            let first = &links[0];
            format!("joint {name}{number} = revolute({first}, {other}) at {place};\n")
        };
        others.map(joint).collect()
    }

    fn text(&self, style: Style) -> String {
        let links = self.links.iter().map(|link| self.link(link, style));
        let joints = self.points.iter().map(|point| self.joints(point.0));
        let parts: String = links.chain(joints).collect();
        format!("struct Drawn;\n{parts}{}\n", self.others)
    }
}

/// Holds what is offered against what a teacher would say, in this style: first or second in one of the messages.
fn assert_advised(drawing: &Drawing, style: Style, wanted: &str) {
    let text = drawing.text(style);
    let reported = messages(&text);
    let first: Vec<Vec<String>> = reported
        .iter()
        .map(|message| alternatives(message).into_iter().take(2).collect())
        .collect();
    assert!(
        first.iter().flatten().any(|advice| advice == wanted),
        "{style:?}: no `{wanted}` in {first:#?}\n{text}{}",
        reported.join("\n")
    );
    // What is offered compiles, and this is not far behind.
    let mended = repairs(&text);
    let place = mended.iter().position(|words| words == wanted);
    assert!(place.is_none_or(|place| place < 2), "{mended:#?}");
    for message in &reported {
        assert!(message.matches("help: ").count() <= 4, "too much help\n{message}");
    }
}

/// A statement is offered before anything else, and is enough.
fn assert_offered_first(text: &str, wanted: &str) {
    let reported = messages(text);
    let mut all = reported.iter().flat_map(|message| alternatives(message));
    let first = all.next().unwrap_or_default();
    assert!(first.contains(wanted), "{reported:#?}");
    let left = messages(&format!("{text} {wanted}"));
    assert!(left.is_empty(), "{left:#?}\n{text}");
}

/// A repair is offered first or second, was made to the text, and compiled.
fn assert_mended(text: &str, wanted: &str) {
    let offered = repairs(text);
    let place = offered.iter().position(|words| words == wanted);
    assert!(
        place.is_some_and(|place| place < 2),
        "no `{wanted}` in {offered:#?}\n{text}{}",
        messages(text).join("\n")
    );
}

/// A line of a mistake: more of what is drawn, or what is to be said of it.
fn follow<'t>(line: &'t str, drawing: &mut Drawing<'t>) -> bool {
    let (word, rest) = line.split_once(' ').expect("a word and more");
    match word {
        "places" => {
            let point = |point: &'t str| {
                let (letter, place) = point.trim().split_once(' ').expect("a letter and a place");
                (letter.chars().next().expect("a letter"), place)
            };
            drawing.points = rest.split_inclusive(')').map(point).collect();
        }
        "links" => drawing.links = rest.split(' ').collect(),
        "grounded" => drawing.grounded = rest,
        "others" => drawing.others += rest,
        "points:" => assert_advised(drawing, Style::Points, rest),
        "bars:" => assert_advised(drawing, Style::Bars, rest),
        "bare:" => assert_advised(drawing, Style::Bare, rest),
        "any:" => {
            for style in [Style::Points, Style::Bars, Style::Bare] {
                assert_advised(drawing, style, rest);
            }
        }
        "mend:" => assert_mended(&drawing.text(Style::Points), rest),
        "first:" => assert_offered_first(&drawing.text(Style::Points), rest),
        "says:" => {
            let all = messages(&drawing.text(Style::Points)).join("\n");
            assert!(all.contains(rest), "no `{rest}` in {all}");
        }
        _ => panic!("{line}"),
    }
    word.ends_with(':')
}

#[test]
fn a_teacher_s_advice_is_offered() {
    let text = include_str!("../../cases/mistakes.txt");
    let (mut asked, mut wrong) = (0, Vec::new());
    for mistake in text.split("\n\n").skip(1) {
        let (title, lines) = mistake.trim().split_once('\n').expect("a title and more");
        println!("{title}");
        let follow_all = || {
            let mut drawing = Drawing::default();
            let lines = lines.lines();
            lines.filter(|line| follow(line, &mut drawing)).count()
        };
        match catch_unwind(follow_all) {
            Ok(count) => asked += count,
            Err(_) => wrong.push(title),
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
    // As many as there were when this was written: none is lost by a slip of the format.
    assert!(asked >= 55, "{asked}");
}
