//! Commands that declare links once more.

use crate::edit::Command;
use crate::editor::Gesture;
use crate::editor::drawing::Drawing;
use crate::editor::names::Names;
use crate::editor::snap::grid;
use crate::text::shortest;
use mech_compiler::model::{AxisId, AxisKind};

/// Makes the gesture that declares links once more, and the names of the copies; none if there are no links.
pub(in crate::editor) fn gesture_of_copies(
    links: &[String],
    drawing: Option<&Drawing>,
    scale: f64,
) -> Option<(Gesture, Vec<String>)> {
    let copies = copies(links, drawing, scale);
    let title = match (&copies[..], links) {
        ([], _) => return None,
        ([(copy, _)], [name, ..]) => format!("copy {name} as {copy}"),
        (several, _) => format!("copy {} links", several.len()),
    };
    let (names, commands): (Vec<_>, Vec<_>) = copies.into_iter().unzip();
    Some((Gesture::new(title, commands.concat()), names))
}

/// Makes the commands that declare links once more, each under a name that is free.
fn copies(links: &[String], drawing: Option<&Drawing>, scale: f64) -> Vec<(String, Vec<Command>)> {
    let mut names = Names::of(drawing);
    let copies = links.iter().map(|name| {
        let copy = names.numbered(name.trim_end_matches(|last: char| last.is_ascii_digit()));
        let duplicate = Command::Duplicate { name: name.clone(), copy: copy.clone() };
        let points = drawing.map(|drawing| points_of_copy(name, &copy, drawing, scale));
        (copy, [vec![duplicate], points.unwrap_or_default()].concat())
    });
    copies.collect()
}

/// Points where a link is joined, for its copy, which no joint gives a place. A link that nothing else gives one is copied beside itself.
fn points_of_copy(name: &str, copy: &str, drawing: &Drawing, scale: f64) -> Vec<Command> {
    let link = drawing.link(name);
    let Some(link) = link.filter(|link| drawing.model.link(*link).drawn) else {
        return Vec::new();
    };
    let (own, joined): (Vec<AxisId>, Vec<AxisId>) =
        drawing.axes_on(link).partition(|axis| drawing.path(*axis).is_some());
    let is_free = own.is_empty() && drawing.model.link(link).shapes.is_empty();
    let beside = if is_free { grid(scale) } else { 0.0 };
    let pins = joined
        .into_iter()
        .map(|axis| drawing.model.axis(axis))
        .filter(|axis| axis.kind == AxisKind::Point);
    let mut places: Vec<[f64; 2]> = Vec::new();
    for axis in pins {
        let place = [axis.at[0] + beside, axis.at[1] - beside];
        if !places.contains(&place) {
            places.push(place);
        }
    }
    let tolerance = 1e-6 * drawing.model.size();
    // The copy has the points of the other, too.
    let numbers = (1_u32..).filter(|number| drawing.axis(&format!("{name}.end{number}")).is_none());
    let points = numbers.zip(places).map(|(number, place)| Command::Axis {
        path: format!("{copy}.end{number}"),
        at: place.map(|part| shortest(part, tolerance)),
        along: None,
    });
    points.collect()
}
