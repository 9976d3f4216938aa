//! Mistakes that people make who draw mechanisms: the repair that a teacher would give is offered first or second, and whatever is
//! written out can be pasted.

mod advice;
mod forgotten;

use advice::{alternatives, mend, messages};

/// A mechanism as it is drawn: points with their places, links by the letters of their points, what is pinned to the ground, and
/// what else there is.
struct Drawing {
    points: &'static [(char, f64, f64)],
    /// More points, where a drawing is another with these.
    extra: &'static [(char, f64, f64)],
    links: &'static [&'static str],
    grounded: &'static str,
    others: &'static str,
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

const STYLES: [Style; 3] = [Style::Points, Style::Bars, Style::Bare];

impl Drawing {
    fn place(&self, letter: char) -> String {
        let mut points = self.points.iter().chain(self.extra);
        let (_, x, y) = points.find(|point| point.0 == letter).expect("a point");
        format!("({x}, {y})")
    }

    fn link(&self, letters: &str, style: Style) -> String {
        let name = letters.to_lowercase();
        let places: Vec<String> = letters.chars().map(|letter| self.place(letter)).collect();
        let points = letters.to_lowercase();
        let points = points.chars().zip(&places);
        let points: Vec<String> = points
            .map(|(point, place)| format!("point {point} = {place};"))
            .collect();
        match style {
            Style::Points => format!("link {name} {{ {} }}\n", points.join(" ")),
            Style::Bars => format!("link {name} {{ bar [{}] width 0.1; }}\n", places.join(", ")),
            Style::Bare => format!("link {name};\n"),
        }
    }

    /// The joints of a point: all links there turn on the first, or on the ground.
    fn joints(&self, letter: char) -> String {
        let here = |link: &&&str| link.contains(letter);
        let mut links: Vec<String> = self
            .links
            .iter()
            .filter(here)
            .map(|link| link.to_lowercase())
            .collect();
        if self.grounded.contains(letter) {
            links.insert(0, "ground".to_owned());
        }
        let name = letter.to_ascii_lowercase();
        let others = links.iter().skip(1).enumerate();
        let joint = |(number, other): (usize, &String)| {
            let number = if number == 0 {
                String::new()
            } else {
                (number + 1).to_string()
            };
            let place = self.place(letter);
            let first = &links[0];
            format!("joint {name}{number} = revolute({first}, {other}) at {place};\n")
        };
        others.map(joint).collect()
    }

    fn text(&self, style: Style) -> String {
        let links = self.links.iter().map(|link| self.link(link, style));
        let joints = self.points.iter().chain(self.extra);
        let joints = joints.map(|point| self.joints(point.0));
        let parts: String = links.chain(joints).collect();
        format!("struct Drawn;\n{parts}{}\n", self.others)
    }
}

/// Holds what is offered against what a teacher would say, in these styles: first or second in one of the messages.
fn assert_advised(drawing: &Drawing, styles: &[Style], wanted: &str) {
    for &style in styles {
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
        for message in &reported {
            assert!(
                message.matches("help: ").count() <= 4,
                "too much help\n{message}"
            );
            for advice in advice::written_out(message) {
                let text = mend(&text, &advice);
                let left = messages(&text);
                let alone = message.contains("for this alone");
                assert!(
                    left.is_empty() || alone,
                    "{advice}\n{text}{}",
                    left.join("\n")
                );
            }
        }
    }
}

/// Tests that messages about a text contain these phrases.
#[track_caller]
fn assert_says(text: &str, phrases: &[&str]) {
    let all = messages(text).join("\n");
    for phrase in phrases {
        assert!(all.contains(phrase), "no `{phrase}` in {all}");
    }
}

const FOUR_BAR: Drawing = Drawing {
    points: &[
        ('A', 0.0, 0.0),
        ('B', 0.5, 1.0),
        ('C', 3.0, 2.0),
        ('D', 4.0, 0.0),
    ],
    extra: &[],
    links: &["AB", "BC", "CD"],
    grounded: "AD",
    others: "motor a;",
};

const UPRIGHT: Drawing = Drawing {
    points: &[
        ('A', 0.0, 0.0),
        ('B', 1.0, 2.0),
        ('C', 4.0, 3.0),
        ('D', 4.0, 0.0),
    ],
    ..FOUR_BAR
};

#[test]
fn an_ungrounded_pivot() {
    let drawing = Drawing {
        grounded: "A",
        ..UPRIGHT
    };
    let wanted = "pin `cd` to the ground: add `joint d = revolute(ground, cd) at (4, 0);`";
    assert_advised(&drawing, &[Style::Points], wanted);
    let wanted = "pin `cd` to the ground: add `joint pin = revolute(ground, cd) at (4, 0);`";
    assert_advised(&drawing, &[Style::Bars, Style::Bare], wanted);
}

#[test]
fn a_brace() {
    let drawing = Drawing {
        links: &["AB", "BC", "CD", "BD"],
        ..UPRIGHT
    };
    assert_advised(&drawing, &STYLES, "remove `link bd`");
}

#[test]
fn a_crank_grounded_at_both_ends() {
    let drawing = Drawing {
        points: &[('A', 0.0, 0.0), ('B', 1.0, 1.0), ('C', 3.0, 1.5)],
        links: &["AB", "BC"],
        grounded: "AB",
        ..FOUR_BAR
    };
    let wanted = "join these links to each other, not to the ground: write `joint b2 = revolute(ab, bc) at (1, 1);` without `joint b`";
    assert_advised(&drawing, &STYLES, wanted);
    // The same, declared otherwise.
    let text = "struct Drawn; link ab; link bc;
        joint a = revolute(ground, ab) at (0, 0);
        joint b = revolute(ab, bc) at (1, 1);
        joint b2 = revolute(ground, ab) at (1, 1);
        motor a;";
    let messages = messages(text);
    let first = messages.iter().map(|message| alternatives(message));
    assert!(
        first.flatten().any(|advice| advice == "remove `joint b2`"),
        "{messages:#?}"
    );
}

/// It is momentarily still, not stuck; but which way it goes from there is not determined.
#[test]
fn a_rocker_that_drives_from_its_limit() {
    let drawing = Drawing {
        points: &[
            ('A', 0.0, 0.0),
            ('B', 0.875, 0.484),
            ('C', 3.5, 1.936),
            ('D', 3.0, 0.0),
        ],
        others: "motor d;",
        ..FOUR_BAR
    };
    assert_advised(&drawing, &STYLES, "move the motor from `d` to `a`");
}

#[test]
fn a_slider_welded_to_its_rod() {
    let drawing = Drawing {
        points: &[('A', 0.0, 0.0), ('B', 1.0, 1.0), ('C', 4.0, 0.0)],
        links: &["AB", "BC"],
        grounded: "A",
        others: "joint c = prismatic(ground, bc) at (4, 0) along (1, 0); motor a;",
        ..FOUR_BAR
    };
    let wanted = "let `bc` turn: write `joint c = slot(bc, ground) at (4, 0) along (1, 0);`";
    assert_advised(&drawing, &STYLES, wanted);
}

#[test]
fn a_rocker_dropped_beside_the_coupler_s_pin() {
    let drawing = Drawing {
        extra: &[('E', 3.08, 1.94)],
        links: &["AB", "BC", "DE"],
        ..FOUR_BAR
    };
    let wanted = "join `bc` and `de`, which are drawn 0.1 apart there: add `joint c = revolute(bc, de) at (3, 2);`";
    assert_advised(&drawing, &[Style::Points], wanted);
    assert_advised(
        &drawing,
        &[Style::Bars],
        &wanted.replace("joint c", "joint pin"),
    );
}

#[test]
fn a_link_that_hangs_from_a_pivot() {
    let drawing = Drawing {
        extra: &[('E', 5.0, 1.2)],
        links: &["AB", "BC", "CD", "DE"],
        ..FOUR_BAR
    };
    assert_advised(&drawing, &STYLES, "remove `link de`");
    assert_advised(&drawing, &STYLES, "add `motor d2;`");
}

#[test]
fn two_motors_for_one_freedom() {
    let drawing = Drawing {
        others: "motor a; motor d;",
        ..FOUR_BAR
    };
    assert_advised(&drawing, &STYLES, "remove `motor d;`");
}

#[test]
fn a_stray_link() {
    let drawing = Drawing {
        extra: &[('E', 6.0, 1.0), ('F', 7.0, 2.0)],
        links: &["AB", "BC", "CD", "EF"],
        ..FOUR_BAR
    };
    assert_advised(&drawing, &STYLES, "remove `link ef`");
}

#[test]
fn the_frame_drawn_as_a_bar() {
    let mut drawing = Drawing {
        links: &["AB", "BC", "CD", "AD"],
        ..FOUR_BAR
    };
    assert_advised(&drawing, &STYLES, "make one link of the two");
    // Without the ground, it is the frame.
    drawing.grounded = "";
    let wanted = "make `ad` a part of the ground: add `joint frame = weld(ground, ad) at (0, 0);`";
    drawing.links = &["AD", "AB", "BC", "CD"];
    assert_advised(&drawing, &STYLES, wanted);
}

#[test]
fn a_motor_on_a_point_of_one_link() {
    let drawing = Drawing {
        extra: &[('E', 2.0, 2.4)],
        links: &["AB", "BCE", "CD"],
        others: "motor e;",
        ..FOUR_BAR
    };
    let why = "`e` is a point of link `bce`, not a joint: a joint joins two links";
    assert_says(&drawing.text(Style::Points), &[why]);
}

#[test]
fn a_link_that_hangs_and_no_motor() {
    let drawing = Drawing {
        extra: &[('E', 2.0, 3.0)],
        links: &["AB", "BC", "CD", "CE"],
        others: "",
        ..FOUR_BAR
    };
    assert_advised(&drawing, &STYLES, "remove `link ce` and add `motor a;`");
}

#[test]
fn two_links_that_hang_on_a_plate() {
    let drawing = Drawing {
        points: &[
            ('A', -2.0, 1.5),
            ('B', -1.0, 0.5),
            ('D', 0.0, 0.0),
            ('F', 1.5, 0.8),
            ('G', 3.0, 0.4),
        ],
        links: &["AB", "BDF", "FG"],
        grounded: "D",
        others: "motor d;",
        ..FOUR_BAR
    };
    assert_advised(&drawing, &STYLES, "add `motor b;` and `motor f;`");
    assert_advised(&drawing, &STYLES, "remove `link ab` and `link fg`");
}

/// Relatives of the cases above.
#[test]
fn a_rod_that_is_not_joined_to_its_block() {
    let drawing = Drawing {
        points: &[('A', 0.0, 0.0), ('B', 1.0, 1.0), ('C', 4.0, 0.0)],
        links: &["AB", "BC"],
        grounded: "A",
        others: "link block; joint x = prismatic(ground, block) at (4, 0) along (1, 0); motor a;",
        ..FOUR_BAR
    };
    let wanted = "join `bc` and `block`: add `joint pin = revolute(bc, block) at (4, 0);`";
    assert_advised(&drawing, &[Style::Bars, Style::Bare], wanted);
    assert_advised(
        &drawing,
        &[Style::Points],
        &wanted.replace("joint pin", "joint c"),
    );
}

#[test]
fn a_coupler_whose_joints_are_forgotten() {
    let text = "struct Drawn; link ab; link cd; link bc { point b = (1, 2); point c = (4, 3); }
        joint a = revolute(ground, ab) at (0, 0);
        joint d = revolute(ground, cd) at (4, 0);
        motor a;";
    let wanted = "together: join `ab` and `bc`: add `joint b = revolute(ab, bc) at (1, 2);` and join `cd` and `bc`: add `joint c = revolute(cd, bc) at (4, 3);`";
    assert_says(text, &[wanted]);
}

#[test]
fn a_missing_coupler() {
    let drawing = Drawing {
        links: &["AB", "CD"],
        ..UPRIGHT
    };
    let wanted = "connect `ab` and `cd`: add `link bar; joint b = revolute(ab, bar) at (1, 2); joint c = revolute(cd, bar) at (4, 3);`";
    assert_says(&drawing.text(Style::Points), &[wanted]);
}

#[test]
fn nothing_is_pinned_to_the_ground() {
    let drawing = Drawing {
        grounded: "",
        others: "motor b;",
        ..UPRIGHT
    };
    let wanted = "together: pin `ab` to the ground: add `joint a = revolute(ground, ab) at (0, 0);` and pin `cd` to the ground: add `joint d = revolute(ground, cd) at (4, 0);`";
    assert_says(&drawing.text(Style::Points), &[wanted]);
}

#[test]
fn one_bent_link_drawn_as_two_bars() {
    const A: (char, f64, f64) = ('A', 0.0, 0.0);
    const B: (char, f64, f64) = ('B', 1.0, 2.0);
    const M: (char, f64, f64) = ('M', 2.5, 2.5);
    const C: (char, f64, f64) = ('C', 4.0, 3.0);
    const D: (char, f64, f64) = ('D', 4.0, 0.0);
    // What the drawing suggests does not depend on the order of the joints.
    for points in [&[A, B, M, C, D], &[A, B, C, D, M], &[M, D, C, B, A]] {
        let drawing = Drawing {
            points,
            links: &["AB", "BM", "MC", "CD"],
            ..UPRIGHT
        };
        let wanted =
            "make one bent link of `bm` and `mc`: write `joint m = weld(bm, mc) at (2.5, 2.5);`";
        assert_says(&drawing.text(Style::Points), &[wanted]);
    }
}

#[test]
fn a_block_whose_guide_is_forgotten() {
    for (knee, block, along) in [
        ("(1, 0.5)", "(4, 0)", "(1, 0)"),
        ("(1, 0.5)", "(-4, 0.3)", "(1, 0)"),
        ("(0.5, 1)", "(0.25, 5)", "(0, 1)"),
    ] {
        let text = format!(
            "struct Slider; link block; link crank; link rod;
            joint c = revolute(block, rod) at {block};
            joint b = revolute(rod, crank) at {knee};
            joint a = revolute(crank, ground) at (0, 0);
            motor a;"
        );
        let wanted = format!("joint guide = prismatic(ground, block) at {block} along {along};");
        let reported = messages(&text);
        let mut all = reported.iter().flat_map(|message| alternatives(message));
        let first = all.next().unwrap_or_default();
        assert!(first.contains(&wanted), "{reported:#?}");
        let left = messages(&format!("{text} {wanted}"));
        assert!(left.is_empty(), "{left:#?}\n{text}");
    }
}
