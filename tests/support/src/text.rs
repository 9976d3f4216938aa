//! Mechanisms as text.

use mech_compiler::model::{AxisId, Joint, JointKind, LinkId, Model, Precision, Ratio};

/// The text of a `mechanism!`, in the form of a drawing. Where a mechanism is not drawn, a comment says where its second axis is.
#[must_use]
pub fn text(model: &Model) -> String {
    let precision = match model.precision {
        Precision::F32 => ": f32",
        Precision::F64 => "",
    };
    let mut text = format!("struct {}{precision};\n", model.name);
    for link in model.declared_links() {
        text += &format!("link {};\n", model.link(link).name);
    }
    for joint in model.joints.iter().filter(|joint| !joint.hidden) {
        text += &format!("joint {} = {};\n", joint.name, kind(model, joint));
    }
    for motor in &model.motors {
        text += &format!("motor {};\n", model.joint(motor.joint).name);
    }
    for (allowed, word) in [(model.allow.coupled, "coupled"), (model.allow.redundant, "redundant")]
    {
        if allowed {
            text += &format!("allow {word};\n");
        }
    }
    text
}

/// The statements of a part that does what a text does, with `frame` instead of the ground; of its motors what follows the word; and what is
/// allowed.
#[must_use]
pub fn part_of(text: &str) -> (String, Vec<String>, String) {
    let (mut body, mut motors) = (String::from("port frame;\n"), Vec::new());
    let mut allowed = String::new();
    for line in text.replace("ground", "frame").lines().skip(1) {
        match line.strip_prefix("motor ") {
            Some(joint) => motors.push(joint.to_owned()),
            None if line.starts_with("allow ") => allowed += line,
            None => body += &format!("{line}\n"),
        }
    }
    (body, motors, allowed)
}

fn kind(model: &Model, joint: &Joint) -> String {
    let name = |link: LinkId| &model.link(link).name;
    let on = |on: Option<LinkId>| on.map_or(String::new(), |on| format!(" on {}", name(on)));
    let points = |word: &str, a, b| format!("{word}{}", pair(model, a, b));
    let lines = |word: &str, a, b| {
        // The pin of a slot has none.
        let [x, y] = model.axis(b).direction;
        format!("{word}{} along ({x:?}, {y:?})", pair(model, a, b))
    };
    let wheels = |word: &str, [a, b]: [LinkId; 2], sizes: String, carrier| {
        format!("{word}({}, {}, {sizes}{})", name(a), name(b), on(carrier))
    };
    let ratio = |ratio| match ratio {
        Ratio::Teeth(a, b) => format!("{a} : {b}"),
        Ratio::Radii(a, b) => format!("{a:?} : {b:?}"),
    };
    match joint.kind {
        JointKind::Revolute(a, b) => points("revolute", a, b),
        JointKind::Weld(a, b) => points("weld", a, b),
        JointKind::Prismatic(a, b) => match model.link(model.axis(b).link).die {
            Some((point, line)) => lines("slot", point, line),
            None => lines("prismatic", a, b),
        },
        JointKind::Gear { a, b, ratio: sizes, on } => wheels("gear", [a, b], ratio(sizes), on),
        JointKind::Belt { a, b, ratio: sizes, on } => wheels("belt", [a, b], ratio(sizes), on),
        JointKind::Rack { pinion, bar, radius, on } => {
            wheels("rack", [pinion, bar], format!("radius {radius:?}"), on)
        }
        JointKind::Cam { shaft, follower, law } => {
            let [shaft, follower] = [shaft, follower].map(|id| &model.joint(id).name);
            // Where it was written for a motor, its variable is the time.
            let law = model.law(law).written.replace("(t)", "(q)");
            format!("cam({shaft}, {follower}, {})", law.replace(" t", " q"))
        }
    }
}

/// Two links, and where the axes are on which they meet.
fn pair(model: &Model, a: AxisId, b: AxisId) -> String {
    let [a, b] = [a, b].map(|axis| model.axis(axis));
    let [from, to] = [a, b].map(|axis| &model.link(axis.link).name);
    let ([x, y], [u, v]) = (a.at, b.at);
    let elsewhere = if a.at == b.at { String::new() } else { format!(" /* ({u:?}, {v:?}) */") };
    format!("({from}, {to}) at ({x:?}, {y:?}){elsewhere}")
}
