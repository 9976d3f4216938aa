//! What is constructed over drawings is where other methods have it: positions in closed form, and differences of them.

use crate::pictures::pixels;
use crate::run::Folder;

const FOUR_BAR: &str = "struct M; link crank; link rod; link rocker;
joint o = revolute(ground, crank) at (0, 0); joint a = revolute(crank, rod) at (1, 0.5);
joint b = revolute(rod, rocker) at (4, 3); joint d = revolute(ground, rocker) at (5, 0); motor o;";

type Place = [f64; 2];

/// A drawing as SVG, whose numbers are in pixels, y up.
struct Drawing {
    dots: Vec<Place>,
    texts: Vec<(Place, String)>,
}

impl Drawing {
    /// The drawing of a text, with these options.
    fn of(text: &str, options: &str) -> Self {
        let folder = Folder::new().with("a.mech", text);
        let words = format!("draw a.mech -o a.svg --look diagram {options}");
        folder.mech(&words).done();
        let svg = folder.text("a.svg");
        let (mut dots, mut texts, mut group) = (Vec::new(), Vec::new(), [0.0; 2]);
        for line in svg.lines() {
            if let Some((_, rest)) = line.split_once("<g transform=\"translate(") {
                let (place, _) = rest.split_once(')').expect("an end");
                let (x, y) = place.split_once(',').expect("two numbers");
                group = [x, y].map(|part| part.parse().expect("a number"));
            } else if line.starts_with("<circle") && line.contains("r=\"3.5\"") {
                let [x, y] = ["cx", "cy"].map(|name| attribute(line, name));
                dots.push([group[0] + x, -group[1] - y]);
            } else if let Some((_, rest)) = line.split_once("<text xml:space=\"preserve\"") {
                let (_, rest) = rest.split_once('>').expect("an end");
                let (words, _) = rest.split_once('<').expect("an end");
                texts.push(([group[0], -group[1]], words.to_owned()));
            }
        }
        Self { dots, texts }
    }

    /// Where the dots of this name are: beside each stands the name, alone or with others.
    fn named(&self, name: &str) -> Vec<Place> {
        let is_name = |(_, words): &&(Place, String)| words.split(", ").any(|word| word == name);
        let beside = self.texts.iter().filter(is_name).filter_map(|([x, y], words)| {
            #[expect(clippy::cast_precision_loss, reason = "a short text")]
            let width = 6.0 * words.chars().count() as f64;
            let is_there = |dot: &&Place| {
                let [right, up] = [x - dot[0], y - dot[1]];
                let is = |a: f64, b: f64| (a - b).abs() < 1e-3;
                (is(right, 5.0) || is(right, -5.0 - width)) && (is(up, 5.0) || is(up, -12.0))
            };
            self.dots.iter().find(is_there).copied()
        });
        beside.collect()
    }

    /// How many pixels stand for one of a unit, by the scale that is drawn.
    fn scale(&self, unit: &str) -> f64 {
        let mut texts = self.texts.iter();
        let found = texts.find_map(|(at, words)| {
            let (number, rest) = words.split_once(' ')?;
            Some((*at, number.parse::<f64>().ok()?)).filter(|_| rest == unit)
        });
        let ([x, y], number) = found.expect("a scale");
        let ends = self.dots.iter().filter(|dot| (dot[1] - y + 8.0).abs() < 1e-3);
        let lengths = ends.map(|dot| dot[0] - x).filter(|length| *length > 1.0);
        lengths.fold(f64::INFINITY, f64::min) / number
    }

    /// The vector to the only end of this name, in this unit.
    fn vector(&self, name: &str, unit: &str) -> Place {
        let [pole] = self.named("pole")[..] else {
            panic!("{:?}", self.texts);
        };
        let [end] = self.named(name)[..] else {
            panic!("{name} {:?}", self.texts);
        };
        let scale = self.scale(unit);
        [0, 1].map(|part| (end[part] - pole[part]) / scale)
    }
}

fn attribute(line: &str, name: &str) -> f64 {
    let (_, rest) = line.split_once(&format!(" {name}=\"")).expect("it is there");
    let (number, _) = rest.split_once('"').expect("an end");
    number.parse().expect("a number")
}

/// The first and second derivative of a place, by differences.
fn rates(place: impl Fn(f64) -> Place, at: f64) -> [Place; 2] {
    const STEP: f64 = 1e-4;
    let [before, here, after] = [-STEP, 0.0, STEP].map(|step| place(at + step));
    let first = [0, 1].map(|part| (after[part] - before[part]) / (2.0 * STEP));
    let second = |part: usize| (after[part] - 2.0 * here[part] + before[part]) / STEP.powi(2);
    [first, [0, 1].map(second)]
}

/// The joints a and b of the four-bar where its crank is turned so far, in radians: b is where two circles meet.
fn four_bar(turned: f64) -> [Place; 2] {
    let angle = turned + 0.5_f64.atan2(1.0);
    let crank = 1.25_f64.sqrt();
    let [x, y] = [crank * angle.cos(), crank * angle.sin()];
    let (rod, rocker) = (3.0_f64.hypot(2.5), 1.0_f64.hypot(3.0));
    let apart = (5.0 - x).hypot(y);
    let along = (rod.powi(2) - rocker.powi(2) + apart.powi(2)) / (2.0 * apart);
    let across = (rod.powi(2) - along.powi(2)).sqrt();
    let [u, v] = [(5.0 - x) / apart, -y / apart];
    let b = [x + along * u - across * v, y + along * v + across * u];
    [[x, y], b]
}

#[track_caller]
fn assert_near(found: Place, expected: Place) {
    let [x, y] = [0, 1].map(|part| found[part] - expected[part]);
    assert!(x.hypot(y) < 1e-4, "{found:?} {expected:?}");
}

#[test]
fn polygons_have_the_differences_of_positions() {
    for degrees in [0.0_f64, 60.0, 200.0] {
        let at = format!("--at o={degrees}");
        let turned = degrees.to_radians();
        let velocities = Drawing::of(FOUR_BAR, &format!("--velocities {at}"));
        let accelerations = Drawing::of(FOUR_BAR, &format!("--accelerations {at}"));
        for (number, name) in ["a", "b"].into_iter().enumerate() {
            let [first, second] = rates(|turned| four_bar(turned)[number], turned);
            assert_near(velocities.vector(name, "unit/s"), first);
            assert_near(accelerations.vector(name, "unit/s²"), second);
        }
        // What rests is where the vectors begin.
        assert_eq!(velocities.named("o"), velocities.named("pole"));
        assert_eq!(velocities.named("d"), velocities.named("pole"));
    }
}

#[test]
fn a_polygon_has_both_points_where_a_link_slides_on_another() {
    let text = "struct M; link crank; link die; link arm;
joint a = revolute(ground, crank) at (0, 2); joint b = revolute(crank, die) at (1, 2);
joint x = prismatic(arm, die) at (1, 2) along (1, 2); joint d = revolute(ground, arm) at (0, 0); motor a;";
    let turned = 0.7_f64;
    let pin = |turned: f64| [turned.cos(), 2.0 + turned.sin()];
    let [x, y] = pin(turned);
    // The point of the arm keeps its distance from the arm's pivot.
    let on_arm = |turned: f64| {
        let [pin_x, pin_y] = pin(turned);
        let part = x.hypot(y) / pin_x.hypot(pin_y);
        [part * pin_x, part * pin_y]
    };
    let at = format!("--at a={}", turned.to_degrees());
    for (option, unit, order) in [("--velocities", "unit/s", 0), ("--accelerations", "unit/s²", 1)] {
        let drawing = Drawing::of(text, &format!("{option} {at}"));
        assert_near(drawing.vector("b", unit), rates(pin, turned)[order]);
        assert_near(drawing.vector("x on arm", unit), rates(on_arm, turned)[order]);
    }
}

#[test]
fn a_film_shows_what_drawings_show() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let options = "--size 500 --look diagram --centres --velocities --accelerations";
    let resting = "--from 20 --to 20 --seconds 1 --rate 1";
    folder
        .mech(&format!("film a.mech -o film.png {options} {resting}"))
        .done();
    folder
        .mech(&format!("draw a.mech -o draw.png {options} --at o=20"))
        .done();
    let [film, drawing] = ["film.png", "draw.png"].map(|name| pixels(&folder.path(name)));
    assert!(film == drawing);
}
