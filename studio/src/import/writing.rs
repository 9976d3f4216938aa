//! The text of a drawing.

use super::drawing::{
    Direction, Drawing, End, Form, Joint, Link, Motor, Pair, Sizes, Speed, Times,
};
use super::names::Names;
use crate::document::in_rust;
use crate::failure::Failure;
use crate::text::{masked, shortest, written_like};

/// The kind of a file with a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FileKind {
    /// `.mech`: the inside of a mechanism.
    Mechanism,
    /// `.rs`: a call of `mechanism!`.
    Rust,
}

/// The places of a path that are recorded: a turn in the pictures and films that divide it most finely.
const TRACE: u32 = 720;
/// The number of places that a window records in a second, by laws.
const PLACES_A_SECOND: f64 = 60.0;
const LONGEST_TRACE: u32 = 1 << 14;
/// The error of a written number, as a part of the size of the drawing.
const PRECISION: f64 = 1e-9;
/// The width of a bar, as a part of the size of the drawing.
const WIDTH: f64 = 0.03;
/// The longest line, where it can be broken.
const LINE: usize = 100;

pub(super) fn text(
    drawing: &Drawing,
    terms: &Terms,
    name: &str,
    kind: FileKind,
) -> Result<String, Failure> {
    let writer = Writer { drawing, terms, named: Named::of(drawing)?, size: drawing.size() };
    let lines = writer.lines(name, kind);
    Ok(match kind {
        FileKind::Mechanism => lines.join("\n") + "\n",
        FileKind::Rust => in_rust(lines.iter().map(String::as_str)),
    })
}

pub(super) fn joint_names(drawing: &Drawing) -> Result<Vec<String>, Failure> {
    Ok(Named::of(drawing)?.joints)
}

/// The names of everything in a drawing, in its order.
struct Named {
    links: Vec<String>,
    points: Vec<Vec<String>>,
    joints: Vec<String>,
    loads: Vec<String>,
}

impl Named {
    fn of(drawing: &Drawing) -> Result<Self, Failure> {
        let mut names = Names::default();
        let links = drawing.links.iter();
        let links =
            links.map(|link| names.claim(&link.name, "link")).collect::<Result<Vec<_>, _>>()?;
        let points = drawing.links.iter().zip(&links).map(|(link, name)| {
            let points = link.points.iter();
            points.map(|point| names.claim_point(name, &point.name)).collect()
        });
        let points = points.collect::<Result<Vec<Vec<_>>, _>>()?;
        let joints = drawing.joints.iter();
        let joints =
            joints.map(|joint| names.claim(&joint.name, "joint")).collect::<Result<Vec<_>, _>>()?;
        let loads = drawing.loads.iter();
        let loads =
            loads.map(|load| names.claim(&load.name, "load")).collect::<Result<Vec<_>, _>>()?;
        Ok(Self { links, points, joints, loads })
    }
}

struct Writer<'d> {
    drawing: &'d Drawing,
    terms: &'d Terms,
    named: Named,
    size: f64,
}

impl Writer<'_> {
    fn lines(&self, name: &str, kind: FileKind) -> Vec<String> {
        let remarks = self.drawing.remarks.iter().cloned().chain(self.speeds());
        let mut lines: Vec<String> =
            remarks.map(|remark| format!("/// {}", on_one_line(&remark))).collect();
        lines.push(match kind {
            FileKind::Mechanism => format!("struct {name};"),
            FileKind::Rust => format!("pub struct {name};"),
        });
        // A link without shapes has a body even if others have shapes.
        let is_colored = self.drawing.links.iter().any(|link| link.color.is_some());
        if is_colored {
            lines.push("look machine;".to_owned());
        }
        let allowed = [(self.terms.is_coupled, "coupled"), (self.terms.is_redundant, "redundant")];
        let allowed = allowed.iter().filter(|(is_allowed, _)| *is_allowed);
        lines.extend(allowed.map(|(_, what)| format!("allow {what};")));
        lines.push(String::new());
        if is_colored {
            lines.extend(self.ground());
        }
        for number in 0..self.drawing.links.len() {
            lines.extend(self.link(number));
        }
        lines.push(String::new());
        lines.extend(self.joints());
        lines.extend(self.motors());
        let gravity = self.drawing.gravity;
        lines.extend(gravity.map(|size| format!("gravity (0, -{});", written_like(size, ""))));
        lines.extend(self.loads());
        lines.extend(self.effects());
        lines
    }

    /// The stands of fixed pivots: only bodies that the compiler makes have their own. Where something slides on the ground, its rails
    /// are worth more.
    fn ground(&self) -> Vec<String> {
        let joints = self.drawing.joints.iter();
        let mut places = Vec::new();
        for joint in joints.filter(|joint| joint.ends.contains(&End::Ground)) {
            match joint.form {
                Form::Revolute { at } if !places.contains(&at) => places.push(at),
                Form::Prismatic { .. } | Form::Slot { .. } => return Vec::new(),
                Form::Revolute { .. } | Form::Gear(_) | Form::Belt(_) => {}
            }
        }
        let stands = places.into_iter().map(|at| format!("stand {};", self.place(at)));
        block("ground", &stands.collect::<Vec<_>>())
    }

    fn link(&self, number: usize) -> Vec<String> {
        let items = self.items(number);
        let name = &self.named.links[number];
        if items.is_empty() {
            return vec![format!("link {name};")];
        }
        block(&format!("link {name}"), &items)
    }

    fn items(&self, number: usize) -> Vec<String> {
        let link = &self.drawing.links[number];
        let points = link.points.iter().zip(&self.named.points[number]);
        let mut items: Vec<String> = points
            .map(|(point, name)| format!("point {name} = {};", self.place(point.at)))
            .collect();
        if let Some(mass) = link.mass {
            // Units were changed, which rounds.
            let exact = |value: f64| shortest(value, value * 1e-12);
            let mut item = format!("mass {} at {}", exact(mass.value), self.place(mass.at));
            if mass.inertia != 0.0 {
                item += &format!(" inertia {}", exact(mass.inertia));
            }
            items.push(item + ";");
        }
        items.extend(self.bar(number, link));
        items
    }

    /// A bar in the colour of a link, from pin to pin.
    fn bar(&self, number: usize, link: &Link) -> Option<String> {
        let color = link.color.filter(|_| !self.drawing.is_wheel(number))?;
        let mut places = around(self.drawing.places(number));
        if places.len() > 2 {
            places.extend(places.first().copied());
        }
        let places: Vec<String> = places.into_iter().map(|at| self.place(at)).collect();
        let width = shortest(self.size * WIDTH, self.size * WIDTH * 0.05);
        // As bodies lie that the compiler makes: two planes for each link.
        let plane = 2 * number + 2;
        let color = color.name();
        (places.len() > 1).then(|| {
            format!("bar [{}] width {width} on plane {plane} color {color};", places.join(", "))
        })
    }

    fn joints(&self) -> impl Iterator<Item = String> {
        let joints = self.drawing.joints.iter().zip(&self.named.joints);
        joints.map(|(joint, name)| format!("joint {name} = {};", self.joint(joint)))
    }

    fn joint(&self, joint: &Joint) -> String {
        let [a, b] = joint.ends.map(|end| match end {
            End::Ground => "ground",
            End::Link(number) => &self.named.links[number],
        });
        match joint.form {
            Form::Revolute { at } => format!("revolute({a}, {b}) at {}", self.place(at)),
            Form::Prismatic { at, along } => {
                let along = self.direction(along);
                format!("prismatic({a}, {b}) at {} along {along}", self.place(at))
            }
            Form::Slot { at, along } => {
                let along = self.direction(along);
                format!("slot({a}, {b}) at {} along {along}", self.place(at))
            }
            Form::Gear(sizes) => format!("gear({a}, {b}, {})", self.ratio(sizes)),
            Form::Belt(sizes) => format!("belt({a}, {b}, {})", self.ratio(sizes)),
        }
    }

    fn motors(&self) -> impl Iterator<Item = String> {
        let motors = self.drawing.motors.iter().zip(&self.terms.ranges);
        motors.map(|(motor, has_range)| self.motor(motor, self.terms.has_laws, *has_range))
    }

    fn motor(&self, motor: &Motor, has_law: bool, has_range: bool) -> String {
        let law = self.law(motor).filter(|_| has_law);
        let law = law.map(|law| format!(" = {law}"));
        let range = motor.stroke.filter(|_| has_range).map(|stroke| {
            let [low, high] = [stroke.min(0.0), stroke.max(0.0)];
            format!(" in {} ..= {}", self.number(low), self.number(high))
        });
        let name = &self.named.joints[motor.joint];
        let [law, range] = [law, range].map(Option::unwrap_or_default);
        format!("motor {name}{law}{range};")
    }

    /// Writes the law of a motor, by the time in seconds.
    fn law(&self, motor: &Motor) -> Option<String> {
        match (motor.speed?, motor.stroke) {
            (Speed::Turns(turns), _) => {
                let sign = if turns < 0.0 { "-" } else { "" };
                let turns = written_like(turns.abs(), "");
                Some(format!("{sign}2 * PI * {turns} / 60 * t"))
            }
            (Speed::Cycles(cycles), Some(stroke)) => {
                let (stroke, cycles) = (self.number(stroke), written_like(cycles, ""));
                Some(format!("{stroke} * (1 - abs(1 - mod({cycles} / 30 * t, 2)))"))
            }
            (Speed::Cycles(_), None) | (Speed::Way(_), _) => None,
        }
    }

    /// Writes the remarks on speeds above the text: where motors have no laws, all that is known of them.
    fn speeds(&self) -> Vec<String> {
        let motors = self.drawing.motors.iter();
        let mut remarks: Vec<String> = motors
            .filter(|motor| !(self.terms.has_laws && motor.rounds().is_some()))
            .filter_map(|motor| self.speed(motor))
            .collect();
        if self.terms.has_laws {
            let back = Times::of(&self.drawing.motors).and_then(|times| times.back);
            let back = back.map(|back| {
                let back = shortest(back, 1e-9 * back);
                format!(" After {back} seconds all are back where they started.")
            });
            let back = back.unwrap_or_default();
            remarks.push(format!("Inputs go at their speeds; the time `t` is in seconds.{back}"));
        }
        remarks
    }

    fn speed(&self, motor: &Motor) -> Option<String> {
        let name = &self.named.joints[motor.joint];
        let exact = |value: f64| written_like(value, "");
        let fact = match motor.speed? {
            Speed::Turns(turns) => {
                let sense = if turns < 0.0 { "clockwise" } else { "counter-clockwise" };
                format!("turns {} times a minute, {sense}", exact(turns.abs()))
            }
            Speed::Cycles(cycles) => {
                format!("goes to its end and back {} times a minute", exact(cycles))
            }
            Speed::Way(way) => format!("slides {} units a second", exact(way)),
        };
        let law = self.law(motor);
        let law = law.map(|law| format!("; as a law in seconds `= {law}`"));
        Some(format!("Input `{name}` {fact}{}.", law.unwrap_or_default()))
    }

    fn loads(&self) -> impl Iterator<Item = String> {
        let loads = self.drawing.loads.iter().zip(&self.named.loads);
        loads.map(|(load, name)| {
            let link = &self.named.links[load.link];
            let point = &self.named.points[load.link][load.point];
            format!("load {name} = force({link}.{point});")
        })
    }

    /// Computes the number of places of one turn's path: by laws until all inputs are back.
    fn places_of_trace(&self) -> u32 {
        let laws = Times::of(&self.drawing.motors).filter(|_| self.terms.has_laws);
        let seconds = laws.and_then(|times| times.back).unwrap_or_default();
        let wanted = seconds * PLACES_A_SECOND;
        (TRACE..LONGEST_TRACE).find(|places| f64::from(*places) >= wanted).unwrap_or(LONGEST_TRACE)
    }

    fn effects(&self) -> Option<String> {
        let places = self.places_of_trace();
        let force = (!self.drawing.loads.is_empty()).then(|| "force;".to_owned());
        let links = self.drawing.links.iter().enumerate();
        let traces = links.flat_map(|(number, drawn)| {
            let points = drawn.points.iter().zip(&self.named.points[number]);
            let traced = points.filter(|(point, _)| point.is_traced);
            let link = &self.named.links[number];
            traced.map(move |(_, point)| format!("trace {link}.{point} {places};"))
        });
        let clauses: Vec<String> = force.into_iter().chain(traces).collect();
        (!clauses.is_empty()).then(|| format!("effects {{ {} }}", clauses.join(" ")))
    }

    /// Numbers of teeth are whole; radii have a point.
    fn ratio(&self, sizes: Sizes) -> String {
        let [a, b] = match sizes {
            Sizes::Teeth(sizes) => sizes.map(|size| size.to_string()),
            Sizes::Radii(sizes) => sizes.map(|size| {
                let text = shortest(size, self.tolerance(size));
                if text.contains(['.', 'e']) { text } else { text + ".0" }
            }),
        };
        format!("{a} : {b}")
    }

    fn place(&self, [x, y]: Pair) -> String {
        format!("({}, {})", self.number(x), self.number(y))
    }

    fn number(&self, value: f64) -> String {
        shortest(value, self.tolerance(self.size))
    }

    /// Computes the tolerance of a length, relative to this size.
    fn tolerance(&self, size: f64) -> f64 {
        (size * PRECISION).max(self.drawing.rounding)
    }

    fn direction(&self, direction: Direction) -> String {
        match direction {
            Direction::Vector(vector) => {
                // Short vectors keep their direction, too.
                let length = vector[0].hypot(vector[1]);
                // Both its ends were rounded.
                let tolerance = 2.0 * self.tolerance(length);
                let [x, y] = vector.map(|part| shortest(part, tolerance));
                format!("({x}, {y})")
            }
            Direction::Radians(angle) => written_like(angle, ""),
            Direction::Degrees(angle) => format!("{} deg", written_like(angle, "")),
        }
    }
}

/// Items in braces, on one line if it is short; nothing without items.
fn block(head: &str, items: &[String]) -> Vec<String> {
    let line = format!("{head} {{ {} }}", items.join(" "));
    if items.is_empty() {
        Vec::new()
    } else if line.chars().count() <= LINE {
        vec![line]
    } else {
        let inside = items.iter().map(|item| format!("    {item}"));
        let first = format!("{head} {{");
        [first].into_iter().chain(inside).chain(["}".to_owned()]).collect()
    }
}

/// Places in the order of a tour around their middle.
fn around(mut places: Vec<Pair>) -> Vec<Pair> {
    let count = f64::from(u32::try_from(places.len()).unwrap_or(u32::MAX));
    let middle = |axis: usize| places.iter().map(|at| at[axis]).sum::<f64>() / count;
    let [x, y] = [middle(0), middle(1)];
    if places.len() > 3 {
        places.sort_by(|a, b| {
            let angle = |at: &Pair| (at[1] - y).atan2(at[0] - x);
            angle(a).total_cmp(&angle(b))
        });
    }
    places
}

/// A text without anything that would end a line, or that Rust refuses in a comment: what changes the direction of reading.
fn on_one_line(text: &str) -> String {
    let letters = text.chars();
    let letters = letters.map(|letter| if letter.is_control() { ' ' } else { letter });
    masked(&letters.collect::<String>()).into_owned()
}

#[derive(Clone, Debug)]
pub(super) struct Terms {
    pub(super) is_coupled: bool,
    pub(super) is_redundant: bool,
    /// Whether each motor has its range.
    pub(super) ranges: Vec<bool>,
    /// Whether motors follow their speeds by laws.
    pub(super) has_laws: bool,
}
