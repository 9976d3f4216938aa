//! What is constructed over drawings is where other methods have it: positions in closed form, and differences of them.

use crate::pictures::pixels;
use crate::run::Folder;

const FOUR_BAR: &str = "struct M; link crank; link rod; link rocker;
joint o = revolute(ground, crank) at (0, 0); joint a = revolute(crank, rod) at (1, 0.5);
joint b = revolute(rod, rocker) at (4, 3); joint d = revolute(ground, rocker) at (5, 0); motor o;";

type Place = [f64; 2];

/// The colours of forces and of torques.
const RED: &str = "#c94f45";
const PURPLE: &str = "#7b62a6";
/// Those of fixed centrodes and of inflection circles. Moving centrodes have that of torques.
const TEAL: &str = "#2e9c90";
const GREEN: &str = "#76a856";

/// A drawing as SVG, whose numbers are in pixels, y up.
struct Drawing {
    dots: Vec<Place>,
    texts: Vec<(Place, String)>,
    /// Each with how many texts stand before it: the next is its name.
    arrows: Vec<(Place, usize)>,
    /// The same of curved arrows: whether they go counter-clockwise.
    turns: Vec<(bool, usize)>,
    /// The places of lines, each with how it is painted.
    lines: Vec<(Vec<Place>, String)>,
    /// The middle and the radius of the inflection circle.
    circle: Option<(Place, f64)>,
}

impl Drawing {
    /// The drawing of a text, with these options.
    fn of(text: &str, options: &str) -> Self {
        let folder = Folder::new().with("a.mech", text);
        let words = format!("draw a.mech -o a.svg --look diagram {options}");
        folder.mech(&words).done();
        let svg = folder.text("a.svg");
        let (mut dots, mut texts) = (Vec::new(), Vec::<(Place, String)>::new());
        let (mut arrows, mut turns) = (Vec::new(), Vec::new());
        let (mut lines, mut circle) = (Vec::new(), None);
        let (mut group, mut turned) = ([0.0; 2], 0.0_f64);
        for line in svg.lines() {
            if let Some((_, rest)) = line.split_once("<g transform=\"translate(") {
                let (place, _) = rest.split_once(')').expect("an end");
                let (x, y) = place.split_once(',').expect("two numbers");
                group = [x, y].map(|part| part.parse().expect("a number"));
                let angle = rest.split_once("rotate(").and_then(|(_, rest)| rest.split_once(')'));
                turned = angle.map_or(0.0, |(angle, _)| angle.parse::<f64>().expect("a number"));
            } else if line.starts_with("<circle") && line.contains("r=\"3.5\"") {
                let [x, y] = ["cx", "cy"].map(|name| attribute(line, name));
                dots.push([group[0] + x, -group[1] - y]);
            } else if line.starts_with("<circle") && line.contains(GREEN) {
                let [x, y, radius] = ["cx", "cy", "r"].map(|name| attribute(line, name));
                circle = Some(([group[0] + x, -group[1] - y], radius));
            } else if let Some((_, rest)) = line.split_once("<polyline points=\"") {
                let (points, style) = rest.split_once('"').expect("an end");
                let (sin, cos) = turned.to_radians().sin_cos();
                let places = points.split(' ').map(|point| {
                    let (x, y) = point.split_once(',').expect("two numbers");
                    let [x, y] = [x, y].map(|part| part.parse::<f64>().expect("a number"));
                    [group[0] + x * cos - y * sin, -group[1] - x * sin - y * cos]
                });
                lines.push((places.collect(), style.to_owned()));
            } else if let Some((_, rest)) = line.split_once("<polygon points=\"") {
                let (tip, _) = rest.split_once(',').expect("two numbers");
                let tip: f64 = tip.parse().expect("a number");
                let (sin, cos) = (-turned.to_radians()).sin_cos();
                if line.contains(RED) {
                    arrows.push(([tip * cos, tip * sin], texts.len()));
                } else if line.contains(PURPLE) {
                    turns.push((tip < 0.0, texts.len()));
                }
            } else if let Some((_, rest)) = line.split_once("<text xml:space=\"preserve\"") {
                let (_, rest) = rest.split_once('>').expect("an end");
                let (words, _) = rest.split_once('<').expect("an end");
                texts.push(([group[0], -group[1]], words.to_owned()));
            }
        }
        Self { dots, texts, arrows, turns, lines, circle }
    }

    /// Where the name of a joint says that it is.
    fn joint(&self, name: &str) -> Place {
        let is_name = |(_, words): &&(Place, String)| words.split(", ").any(|word| word == name);
        let ([x, y], _) = self.texts.iter().find(is_name).expect("a name");
        [x - 7.0, y - 7.0]
    }

    /// A place in scene units, if joint `o` is in the origin and another joint is so far from it.
    fn in_scene(&self, place: Place, (other, distance): (&str, f64)) -> Place {
        let [origin, other] = ["o", other].map(|name| self.joint(name));
        let scale = (other[0] - origin[0]).hypot(other[1] - origin[1]) / distance;
        [0, 1].map(|part| (place[part] - origin[part]) / scale)
    }

    /// The places of all lines of this colour, in scene units.
    fn curve(&self, color: &str, measure: (&str, f64)) -> Vec<Place> {
        let own = self.lines.iter().filter(|(_, style)| style.contains(color));
        let places = own.flat_map(|(places, _)| places);
        places.map(|place| self.in_scene(*place, measure)).collect()
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

    /// The force of this name in the free body of a link; none if there is no such arrow.
    fn force(&self, link: &str, name: &str) -> Option<Place> {
        let mut own = self.arrows.iter().filter(|(_, next)| self.is_of(link, name, *next));
        let (arrow, next) = own.next()?;
        let vector = arrow.map(|part| part / self.scale("force"));
        let (_, number) = self.texts[*next].1.rsplit_once(' ').expect("a number");
        let number: f64 = number.parse().expect("a number");
        assert!((vector[0].hypot(vector[1]) / number - 1.0).abs() < 1e-3, "{number}");
        Some(vector)
    }

    /// The torque of this name on a link.
    fn torque(&self, link: &str, name: &str) -> Option<f64> {
        let name = format!("{name} torque");
        let mut own = self.turns.iter().filter(|(_, next)| self.is_of(link, &name, *next));
        let (is_left, next) = own.next()?;
        let (_, number) = self.texts[*next].1.rsplit_once(' ').expect("a number");
        let number: f64 = number.parse().expect("a number");
        Some(if *is_left { number } else { -number })
    }

    /// Whether the text of this number has this name before its number, in the free body of a link.
    fn is_of(&self, link: &str, name: &str, number: usize) -> bool {
        let (before, rest) = self.texts.split_at(number);
        let titles = ["crank", "rod", "ram", "first", "second"];
        let mut above = before.iter().rev().map(|(_, words)| words.as_str());
        let title = above.find(|words| titles.contains(words));
        let named = rest[0].1.rsplit_once(' ').map(|(name, _)| name);
        title == Some(link) && named == Some(name)
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
    for (option, unit, order) in [("--velocities", "unit/s", 0), ("--accelerations", "unit/s²", 1)]
    {
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
    folder.mech(&format!("film a.mech -o film.png {options} {resting}")).done();
    folder.mech(&format!("draw a.mech -o draw.png {options} --at o=20")).done();
    let [film, drawing] = ["film.png", "draw.png"].map(|name| pixels(&folder.path(name)));
    assert!(film == drawing);
}

#[test]
fn free_bodies_of_a_slider_crank_are_those_of_its_triangle_of_forces() {
    let text = "struct M; ground { point shaft = (0, 0); line bed = (0, 0) -> (1, 0); }
link crank { point shaft = (0, 0); point pin = (1, 0); }
link rod { point big = (0, 0); point small = (3, 0); }
link ram { point pin = (0, 0); line way = (0, 0) -> (1, 0); }
joint o = revolute(ground.shaft, crank.shaft); joint a = revolute(crank.pin, rod.big);
joint b = revolute(rod.small, ram.pin); joint bed = prismatic(ground.bed, ram.way); motor o;
start { o = 60 deg; rod near -10 deg; } load push = force(ram.pin); effects { force; }";
    for degrees in [60.0_f64, 130.0, 290.0] {
        let angle = degrees.to_radians();
        let options = format!("--forces --load push=-100,0 --at o={degrees}");
        let drawing = Drawing::of(text, &options);
        // The rod pushes along itself.
        let rod = (angle.sin() / 3.0).asin();
        let along = [-100.0, 100.0 * rod.tan()];
        let back = along.map(|part| -part);
        let near = |found: Option<Place>, expected: Place| {
            let found = found.expect("an arrow");
            let [x, y] = [0, 1].map(|part| found[part] - expected[part]);
            assert!(x.hypot(y) < 0.01, "{degrees}: {found:?} {expected:?}");
        };
        near(drawing.force("crank", "a"), along);
        near(drawing.force("crank", "o"), back);
        near(drawing.force("rod", "a"), back);
        near(drawing.force("rod", "b"), along);
        near(drawing.force("ram", "b"), back);
        near(drawing.force("ram", "push"), [-100.0, 0.0]);
        near(drawing.force("ram", "bed"), [0.0, along[1]]);
        let torque = -100.0 * (angle + rod).sin() / rod.cos();
        let found = drawing.torque("crank", "o").expect("a torque");
        assert!((found / torque - 1.0).abs() < 1e-3, "{found} {torque}");
    }
}

#[test]
fn teeth_springs_and_weights_push_free_bodies() {
    let text = "struct M; ground { point hub = (0, 0); point other = (3, 0); }
link first { point hub = (0, 0); } link second { point hub = (0, 0); mass 2 at (0, 0); }
joint a = revolute(ground.hub, first.hub); joint b = revolute(ground.other, second.hub);
joint mesh = gear(first, second, 10 : 20); motor a; gravity (0, -5);
spring s = torsional(b) stiffness 4 rest 0; load brake = torque(second); effects { force; }";
    // The first wheel has turned by -90°, the second by 45°.
    let drawing = Drawing::of(text, "--forces --load brake=6 --at a=-90");
    let spring = std::f64::consts::PI;
    let near =
        |found: Option<Place>, expected: Place| assert_near(found.expect("an arrow"), expected);
    // The pitch circles, with radii 1 and 2, touch at (1, 0).
    let tooth = (6.0 - spring) / 2.0;
    near(drawing.force("second", "mesh"), [0.0, tooth]);
    near(drawing.force("first", "mesh"), [0.0, -tooth]);
    near(drawing.force("first", "a"), [0.0, tooth]);
    near(drawing.force("second", "weight"), [0.0, -10.0]);
    near(drawing.force("second", "b"), [0.0, 10.0 - tooth]);
    let torques = [("second", "brake", 6.0), ("second", "s", -spring), ("first", "a", tooth)];
    for (link, name, torque) in torques {
        let found = drawing.torque(link, name).expect("a torque");
        assert!((found / torque - 1.0).abs() < 1e-3, "{name} {found}");
    }
}

fn distance([a, b]: Place, [c, d]: Place) -> f64 {
    (c - a).hypot(d - b)
}

#[test]
fn centrodes_of_a_trammel_are_the_circles_of_cardan() {
    let text = "struct T; ground { point o = (0, 0); line x = (0, 0) -> (1, 0); }
link crank { point o = (0, 0); point m = (1, 0); }
link rod { point m = (0, 0); point b = (1, 0); }
link slide { point p = (0, 0); line l = (0, 0) -> (1, 0); }
joint o = revolute(ground.o, crank.o); joint m = revolute(crank.m, rod.m);
joint b = revolute(rod.b, slide.p); joint x = prismatic(ground.x, slide.l); motor o;
start { o = 40 deg; rod near -40 deg; }";
    let drawing = Drawing::of(text, "--names --centrodes rod --inflection rod");
    let measure = ("m", 1.0);
    let middle = drawing.in_scene(drawing.joint("m"), measure);
    let [fixed, moving] = [TEAL, PURPLE].map(|color| drawing.curve(color, measure));
    assert!(fixed.len() > 500 && moving.len() > 500);
    for place in fixed {
        assert!((place[0].hypot(place[1]) - 2.0).abs() < 1e-4, "{place:?}");
    }
    for place in moving {
        assert!((distance(place, middle) - 1.0).abs() < 1e-4, "{place:?}");
    }
    // All points of the smaller circle go straight ahead.
    let (centre, radius) = drawing.circle.expect("a circle");
    let centre = drawing.in_scene(centre, measure);
    assert!(distance(centre, middle) < 1e-4, "{centre:?}");
    let top = drawing.circle.map(|([x, y], _)| [x, y + radius]);
    let top = drawing.in_scene(top.expect("a circle"), measure);
    assert!((distance(centre, top) - 1.0).abs() < 1e-4, "{top:?}");
}

#[test]
fn centrodes_of_an_antiparallelogram_are_ellipses_about_its_pins() {
    let text = "struct A; link left; link bar; link right;
joint o = revolute(ground, left) at (0, 0); joint a = revolute(left, bar) at (1.2, 2.749545416973504);
joint d = revolute(ground, right) at (2, 0);
joint b = revolute(bar, right) at (-0.4878048780487809, 1.6765520835204293); motor o;";
    let drawing = Drawing::of(text, "--names --centrodes bar");
    let measure = ("d", 2.0);
    let foci = |names: [&str; 2]| names.map(|name| drawing.in_scene(drawing.joint(name), measure));
    for (color, names) in [(TEAL, ["o", "d"]), (PURPLE, ["a", "b"])] {
        let curve = drawing.curve(color, measure);
        assert!(curve.len() > 300, "{}", curve.len());
        let foci = foci(names);
        for place in curve {
            let sum = distance(place, foci[0]) + distance(place, foci[1]);
            assert!((sum - 3.0).abs() < 1e-3, "{place:?} {sum}");
        }
    }
}

#[test]
fn points_of_the_inflection_circle_go_straight_ahead() {
    for degrees in [10.0_f64, 80.0, 230.0] {
        let options = format!("--names --inflection rod --at o={degrees}");
        let drawing = Drawing::of(FOUR_BAR, &options);
        let (middle, radius) = drawing.circle.expect("a circle");
        let turned = degrees.to_radians();
        // Where a place of the scene is carried by the rod.
        let carried = |place: Place| {
            move |at: f64| {
                let frame = |at: f64| {
                    let [a, b] = four_bar(at);
                    let length = distance(a, b);
                    (a, [0, 1].map(|part| (b[part] - a[part]) / length))
                };
                let ((from, [c, s]), (to, [u, v])) = (frame(turned), frame(at));
                let [x, y] = [place[0] - from[0], place[1] - from[1]];
                let [along, across] = [c * x + s * y, c * y - s * x];
                [to[0] + u * along - v * across, to[1] + v * along + u * across]
            }
        };
        let curvature = |place: Place| {
            let [[x, y], [u, v]] = rates(carried(place), turned);
            (x * v - y * u) / x.hypot(y).powi(3)
        };
        let on_circle = |part: f64| {
            let (sin, cos) = part.sin_cos();
            let place = [middle[0] + radius * cos, middle[1] + radius * sin];
            drawing.in_scene(place, ("d", 5.0))
        };
        for part in 0..8 {
            let place = on_circle(f64::from(part));
            let bend = curvature(place);
            assert!(bend.abs() < 1e-3, "{degrees}: {place:?} {bend}");
        }
        // Others do not.
        let [a, b] = four_bar(turned);
        assert!(curvature(a).abs() > 0.1 && curvature(b).abs() > 0.1);
    }
}

#[test]
fn what_cannot_be_constructed_is_told() {
    let trammel = "struct T; ground { line x = (0, 0) -> (1, 0); } link crank; link rod;
link slide { line l = (0, 0) -> (1, 0); }
joint o = revolute(ground, crank) at (0, 0); joint m = revolute(crank, rod) at (1, 1);
joint b = revolute(rod, slide) at (2, 0); joint x = prismatic(ground.x, slide.l); motor o;";
    let parallelogram = "struct P: f32; link crank; link rod; link rocker;
joint o = revolute(ground, crank) at (0, 0); joint a = revolute(crank, rod) at (1, 0.7);
joint b = revolute(rod, rocker) at (4.3, 0.7); joint d = revolute(ground, rocker) at (3.3, 0); motor o;";
    let cases = [
        (FOUR_BAR, "--forces", "nothing pushes its links"),
        (FOUR_BAR, "--inflection ground", "the ground rests"),
        (FOUR_BAR, "--centrodes bar", "has no link `bar`"),
        (trammel, "--centrodes slide", "link `slide` never turns"),
        (trammel, "--inflection slide", "link `slide` does not turn here"),
        (parallelogram, "--centrodes rod", "link `rod` never turns"),
    ];
    for (text, option, words) in cases {
        let folder = Folder::new().with("a.mech", text);
        for kind in ["draw a.mech -o a.png", "film a.mech -o a.gif --seconds 1 --rate 3"] {
            let answer = folder.mech(&format!("{kind} {option}"));
            assert!(answer.code != Some(0), "{option}");
            assert!(answer.err.contains(words), "{option}: {}", answer.err);
        }
    }
    // What is at infinity alone leaves the rest.
    Drawing::of(parallelogram, "--centres --velocities --accelerations");
}
