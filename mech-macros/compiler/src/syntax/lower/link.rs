//! Links, and what is fixed to them.

use super::draft::Draft;
use super::figure;
use super::mass::{matter, weigh};
use super::name::{Body, Referent, word_for};
use super::quantity::{Length, Quantity, Spot};
use super::reader::Reader;
use crate::model::{self, AxisKind, FORWARD, FormulaId, LinkId, ShapeKind, color_of};
use crate::syntax::ast::{
    Axis, AxisValue, Color, Expr, ExprKind, Ground, Item, Link, Outline, Pair, Read, Shape,
};
use crate::syntax::{Message, Place, color};

/// Places in a link, and how each of their numbers is computed that depends on a param.
type Spots = (Vec<[f64; 2]>, Vec<Option<FormulaId>>);
/// The outline of a shape, and how each of its numbers is computed that depends on a param.
type Drawing = (ShapeKind, Vec<Option<FormulaId>>);

pub(super) fn declare_ground(reader: &mut Reader, draft: &mut Draft, ground: &Ground) {
    if let Some(link) = draft.model.links.first_mut()
        && link.origin == model::Origin::default()
    {
        link.origin = draft.places.note(Place::at(ground.keyword));
    }
    fix(reader, draft, LinkId::GROUND.into(), &ground.items);
}

/// Declares a link and returns its referent.
pub(super) fn declare(reader: &mut Reader, draft: &mut Draft, link: &Link) -> Referent {
    if draft.claims.take_name(reader, &link.name, "link") {
        let id = LinkId::new(draft.model.links.len());
        let origin = draft.note(&link.name);
        let key = reader.key_of(&link.name);
        draft.model.links.push(model::Link::new(&key, origin));
        // The items of a part get their places when its ports are lent.
        if reader.here().part.is_none() {
            fix(reader, draft, id.into(), &link.items);
        }
        return Referent::Link(id.into());
    }
    // The first link of a name lacks the axes of the second; but that is not the fault to report.
    if let Some(Referent::Link(first)) = reader.names.get(&reader.key_of(&link.name)) {
        draft.lose_axis(first, None);
    }
    for error in errors_of(&link.items) {
        reader.report.next_item();
        reader.report.pass_on(error.clone());
    }
    Referent::Broken
}

/// Enters what is fixed to a link.
pub(super) fn fix(reader: &mut Reader, draft: &mut Draft, link: Body, items: &Read<Vec<Item>>) {
    let Some(items) = reader.report.read(items) else {
        return draft.lose_axis(link, None);
    };
    let mut massive = None;
    for item in items {
        reader.report.next_item();
        match item {
            Item::Matter(item) => matter(reader, draft, link, item, &mut massive),
            Item::Axis(axis) => lower_axis(reader, draft, link, axis),
            Item::Shape(shape) => lower_shape(reader, draft, link.id, shape),
            Item::Broken(broken) => {
                reader.report.pass_on(broken.error.clone());
                let names = broken.names.iter();
                names.for_each(|name| draft.lose_axis(link, Some(name)));
            }
        }
    }
    if let Some(massive) = massive {
        weigh(reader, draft, link.id, massive);
    }
}

/// Enters an axis, also one whose numbers are wrong: its name is known, and it is not to be missed elsewhere.
fn lower_axis(reader: &mut Reader, draft: &mut Draft, link: Body, axis: &Axis) {
    let kept = take_axis(reader, draft, link, axis);
    let value = reader.report.read(&axis.value);
    let (at, direction) = value.map_or((None, None), |value| axis_value(reader, axis.kind, value));
    if !kept {
        return;
    }
    let origin = draft.note(&axis.name);
    // An error was reported: any value will do.
    let (at, formulas) = at.unwrap_or_default();
    let direction = direction.unwrap_or((FORWARD, [None; 2]));
    let (frame, formulas_of) = (reader.frame, reader.formulas());
    let (direction, direction_formulas) = frame.direction(direction, formulas_of);
    let port = link.port.map(|port| reader.names.ports[port].path.clone());
    draft.model.axes.push(model::Axis {
        link: link.id,
        name: Some(axis.name.to_string()),
        port,
        origin,
        kind: axis.kind,
        at,
        formulas,
        direction,
        direction_formulas,
    });
}

/// The place and the direction of an axis, both turned if it says so.
fn axis_value(
    reader: &mut Reader,
    kind: AxisKind,
    value: &AxisValue,
) -> (Option<Spot>, Option<Spot>) {
    let (at, direction) = untransformed(reader, kind, value);
    let at = at.and_then(|at| reader.transform(at, reader.frame, value.at.place));
    (at, direction)
}

/// The same before what the scope does to it.
fn untransformed(
    reader: &mut Reader,
    kind: AxisKind,
    value: &AxisValue,
) -> (Option<Spot>, Option<Spot>) {
    let at = reader.spot(&value.at);
    let direction = value.direction.as_ref();
    let direction = direction.and_then(|direction| match kind {
        AxisKind::Point => reader.fixed_direction(direction),
        AxisKind::Line => reader.direction(direction),
    });
    let Some(angle) = &value.turned else {
        return (at, direction);
    };
    let Some(by) = reader.direction_at_angle(angle) else {
        return (None, None);
    };
    // A point without a direction of its own keeps that of its link.
    if kind == AxisKind::Point && direction.is_some() && by.1 != [None; 2] {
        reader.refuse_turning_point(&[angle]);
        return (None, None);
    }
    let place = value.at.place;
    let mut turn = |spot: Option<Spot>| reader.turn(spot?, by, place);
    (turn(at), turn(direction))
}

/// Takes the name of an axis: whether it can have it.
fn take_axis(reader: &mut Reader, draft: &mut Draft, link: Body, axis: &Axis) -> bool {
    let text = axis.name.to_string();
    if let Some(earlier) = reader.names.axis_of(&draft.model, link, &text) {
        let earlier = word_for(draft.model.axis(earlier).kind);
        let link = reader.names.name_of(&draft.model, link);
        let message = format!("`{link}` has a {earlier} `{text}` already; choose another name");
        reader.report.error(Place::at(axis.name.span()), message);
        return false;
    }
    let kept = axis.kind == model::AxisKind::Line
        || draft.claims.take_point(reader, &draft.model, link, &axis.name);
    if !kept {
        draft.lose_axis(link, Some(&axis.name));
    }
    kept
}

fn lower_shape(reader: &mut Reader, draft: &mut Draft, link: LinkId, shape: &Shape) {
    let kind = match &shape.outline {
        Outline::Circle { center, radius } => circle(reader, center, radius),
        Outline::Ring { center, radius, hole } => ring(reader, center, radius, hole),
        Outline::Polygon { corners, place } => polygon(reader, corners, *place),
        Outline::Bar { pins, place, width } => bar(reader, pins, *place, width),
        figure => {
            let why = "`circle`, `ring`, `polygon` and `bar` may depend on one, this shape may not";
            let figure = figure::figure(&mut reader.fixed(why), figure);
            figure.map(|figure| (figure, Vec::new()))
        }
    };
    let plane = match &shape.plane {
        Some(plane) => read_plane(reader, plane),
        None => Some(0),
    };
    let color = match &shape.color {
        Some(color) => read_color(reader, color),
        None => Some(color_of(link)),
    };
    let (Some((kind, formulas)), Some(plane), Some(color)) = (kind, plane, color) else {
        return;
    };
    let origin = draft.places.note(Place::at(shape.keyword));
    draft.model.links[link.index()].shapes.push(model::Shape {
        origin,
        kind,
        plane,
        color,
        formulas,
    });
}

/// The number of a plane.
pub(super) fn read_plane(reader: &mut Reader, plane: &Expr) -> Option<i32> {
    reader.whole(plane, "a plane", [i32::MIN, i32::MAX])
}

/// An entry of the palette.
pub(super) fn read_color(reader: &mut Reader, color: &Color) -> Option<u8> {
    let Color { value, shade } = color;
    if let ExprKind::Constant(name) = &value.kind
        && !reader.constants().has(&name.to_string())
    {
        return match color::named(&name.to_string(), shade.map(|(shade, _)| shade)) {
            Ok(entry) => Some(entry),
            Err(text) if color::is_name(&name.to_string()) => {
                reader.report.refuse(value.place, text)
            }
            Err(text) => {
                let unknown = reader.unknown_number(name);
                reader.report.refuse_unknown(unknown, value.place, text)
            }
        };
    }
    let number = reader.whole(value, "the number of a color", [0, 255])?;
    if let Some((_, word)) = *shade {
        let text = "only a color with a name has a shade; leave this word out, or give the color by its name";
        return reader.report.refuse(Place::at(word), text);
    }
    u8::try_from(number).ok()
}

fn circle(reader: &mut Reader, center: &Pair, radius: &Expr) -> Option<Drawing> {
    let center = fixed_spot(reader, center);
    let radius = fixed_length(reader, radius, "a radius");
    let ((center, [x, y]), (radius, reach)) = (center?, radius?);
    Some((ShapeKind::Circle { center, radius }, vec![x, y, reach]))
}

fn ring(reader: &mut Reader, center: &Pair, radius: &Expr, hole: &Expr) -> Option<Drawing> {
    let center = fixed_spot(reader, center);
    let radius = fixed_length(reader, radius, "a radius");
    let inner = fixed_length(reader, hole, "the radius of a hole");
    let ((radius, reach), (inner, within)) = (radius?, inner?);
    if inner >= radius {
        let text = format!("the hole of a ring is smaller than the ring, whose radius is {radius}");
        return reader.report.refuse(hole.place, text);
    }
    let (center, [x, y]) = center?;
    let kind = ShapeKind::Ring { center, radius, hole: inner };
    Some((kind, vec![x, y, reach, within]))
}

fn bar(reader: &mut Reader, pins: &[Pair], place: Place, width: &Expr) -> Option<Drawing> {
    let found = spots(reader, pins);
    let width = fixed_length(reader, width, "a width");
    if pins.len() < 2 {
        let text = format!("a bar has at least two pins, not {}", pins.len());
        return reader.report.refuse(place, text);
    }
    let ((pins, mut formulas), (width, breadth)) = (found?, width?);
    formulas.push(breadth);
    Some((ShapeKind::Bar { pins, width }, formulas))
}

fn polygon(reader: &mut Reader, corners: &[Pair], place: Place) -> Option<Drawing> {
    let found = spots(reader, corners);
    if corners.len() < 3 {
        let text = format!("a polygon has at least three corners, not {}", corners.len());
        return reader.report.refuse(place, text);
    }
    let (corners, formulas) = found?;
    Some((ShapeKind::Polygon(corners), formulas))
}

/// A place in a link.
fn fixed_spot(reader: &mut Reader, pair: &Pair) -> Option<Spot> {
    let spot = reader.spot(pair)?;
    reader.transform(spot, reader.frame, pair.place)
}

/// A length on a link, greater than zero.
fn fixed_length(reader: &mut Reader, expr: &Expr, what: &str) -> Option<Length> {
    let (value, formula) = reader.length(expr, what)?;
    let length = Quantity { value: Some(value), formula };
    let scale = reader.frame.scale;
    let scaled = length.times(scale, reader.formulas());
    Some((scaled.value?, scaled.formula))
}

/// Some places in a link, and how all of their numbers are computed. All are looked at, so that all of their errors are reported.
fn spots(reader: &mut Reader, pairs: &[Pair]) -> Option<Spots> {
    let spots: Vec<Option<Spot>> = pairs.iter().map(|pair| fixed_spot(reader, pair)).collect();
    let spots: Vec<Spot> = spots.into_iter().collect::<Option<_>>()?;
    let (points, formulas): (_, Vec<_>) = spots.into_iter().unzip();
    Some((points, formulas.concat()))
}

/// Returns the messages about items of a link that could not be read.
pub(super) fn errors_of<'t>(items: &'t Read<Vec<Item>>) -> Vec<&'t Message> {
    let error_of = |item: &'t Item| match item {
        Item::Axis(axis) => axis.value.as_ref().err(),
        Item::Shape(_) | Item::Matter(_) => None,
        Item::Broken(broken) => Some(&broken.error),
    };
    match items {
        Ok(items) => items.iter().filter_map(error_of).collect(),
        Err(error) => vec![error],
    }
}
