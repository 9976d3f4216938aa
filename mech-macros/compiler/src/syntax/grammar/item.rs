//! The items of a link: `{ point pin = (1, 0); circle (0, 0) radius 0.2; }`.

use super::beginning::{ITEMS, STATEMENTS};
use super::ending::missing_after;
use super::expression::{direction, expression, pair, read_labelled};
use super::figure::{self, corners};
use super::foreign;
use super::recover::{declared_name, doubled, leave_behind, skip, to_semicolon};
use super::tokens::{
    any_word, comes, expected_message, in_braces, in_brackets, symbol, take, take_tree, take_word,
};
use crate::model::AxisKind;
use crate::syntax::ast::{
    Axis, AxisValue, Broken, Color, Expr, Item, Matter, MatterKind, Outline, Read, Shade, Shape,
};
use crate::syntax::{Message, Place, spelling};
use proc_macro2::{Ident, Span};
use syn::LitStr;
use syn::buffer::Cursor;
use syn::parse::ParseStream;
use syn::token;

/// Reads `{ ... }`.
pub(super) fn items(input: ParseStream) -> Read<Vec<Item>> {
    in_braces(input, "`{`", item)
}

fn item(input: ParseStream) -> Item {
    let Some(keyword) = any_word(input) else {
        let otherwise = foreign::comment(input)
            .unwrap_or_else(|| expected_message(input, "`point`, `line`, `circle` or `polygon`"));
        if take(input, ";").is_none() {
            take_tree(input);
            skip(input, &ITEMS);
        }
        return Item::Broken(Broken { error: otherwise, names: Vec::new() });
    };
    if let Some(error) = doubled(input, &keyword) {
        return Item::Broken(Broken { error, names: Vec::new() });
    }
    match keyword.to_string().as_str() {
        "point" => axis(input, AxisKind::Point),
        "line" => axis(input, AxisKind::Line),
        "circle" => shape(input, keyword.span(), circle),
        "ring" => shape(input, keyword.span(), ring),
        "polygon" => shape(input, keyword.span(), polygon),
        "bar" => shape(input, keyword.span(), bar),
        "gear" => shape(input, keyword.span(), figure::gear),
        "stand" => shape(input, keyword.span(), figure::stand),
        "rail" => shape(input, keyword.span(), figure::rail),
        // With a name it is the spring between two links.
        "spring" if input.peek(syn::Ident) => unknown_item(input, &keyword),
        "spring" => shape(input, keyword.span(), figure::spring),
        "text" => shape(input, keyword.span(), figure::text),
        "mass" => matter(input, keyword.span(), mass),
        "density" => matter(input, keyword.span(), density),
        _ => unknown_item(input, &keyword),
    }
}

fn unknown_item(input: ParseStream, keyword: &Ident) -> Item {
    let text = as_item(&keyword.to_string()).unwrap_or_else(|| {
        let remedy = match spelling::nearest(&keyword.to_string(), &ITEMS) {
            Some(near) => format!("did you mean `{near}`?"),
            None => {
                format!("what is fixed to a link begins with one of {}", spelling::list(&ITEMS))
            }
        };
        format!("unknown item `{keyword}`; {remedy}")
    });
    let error = Message::new(Place::at(keyword.span()), text);
    Item::Broken(leave_behind(input, &ITEMS, keyword, error))
}

fn axis(input: ParseStream, kind: AxisKind) -> Item {
    let what = match kind {
        AxisKind::Point => "the name of a point",
        AxisKind::Line => "the name of a line",
    };
    let name = match declared_name(input, &ITEMS, what) {
        Ok(name) => name,
        Err(broken) => return Item::Broken(broken),
    };
    let value = to_semicolon(input, &ITEMS, |input| axis_value(input, kind));
    Item::Axis(Axis { kind, name, value })
}

fn axis_value(input: ParseStream, kind: AxisKind) -> Read<AxisValue> {
    let begin = input.cursor();
    symbol(input, "=")?;
    let at = pair(input)?;
    let direction = take(input, "->").map(|_| direction(input)).transpose()?;
    if direction.is_none() && kind == AxisKind::Line {
        let missing = "`-> (dx, dy)`";
        let forgotten = missing_after(input, begin, &ITEMS, missing);
        let mut error = forgotten.unwrap_or_else(|| expected_message(input, missing));
        error.text.push_str("; a line has a direction");
        return Err(error);
    }
    let turned = take_word(input, "turned").map(|_| expression(input)).transpose()?;
    if direction.is_none() && turned.is_none() && !comes(input, ";") {
        let missing = "`;`, or `-> (dx, dy)`";
        let forgotten = missing_after(input, begin, &ITEMS, "`;`");
        return Err(forgotten.unwrap_or_else(|| expected_message(input, missing)));
    }
    Ok(AxisValue { at, direction, turned })
}

fn shape(input: ParseStream, keyword: Span, outline: fn(ParseStream) -> Read<Outline>) -> Item {
    let shape = to_semicolon(input, &ITEMS, |input| {
        let outline = outline(input)?;
        let (plane, color) = look(input)?;
        Ok(Shape { keyword, outline, plane, color })
    });
    match shape {
        Ok(shape) => Item::Shape(shape),
        Err(error) => Item::Broken(Broken { error, names: Vec::new() }),
    }
}

/// Reads `on plane 2 color teal light`, each part of which may be left out.
pub(super) fn look(input: ParseStream) -> Read<(Option<Expr>, Option<Color>)> {
    let plane = plane(input)?;
    let color = color(input)?;
    after_color(input)?;
    Ok((plane, color))
}

fn plane(input: ParseStream) -> Read<Option<Expr>> {
    if let Some(word) = take_word(input, "plane") {
        let plane = expression(input)?;
        let text = format!("a plane is given by two words; write `on plane {plane}`");
        return Err(Message::new(Place::at(word).to(plane.place), text));
    }
    if take_word(input, "on").is_none() {
        return Ok(None);
    }
    read_labelled(input, "plane").map(Some)
}

fn color(input: ParseStream) -> Read<Option<Color>> {
    if let Some(word) = take_word(input, "colour") {
        return Err(Message::new(Place::at(word), "write `color` for `colour`"));
    }
    if take_word(input, "color").is_none() {
        return Ok(None);
    }
    if input.peek(LitStr) || comes(input, "#") {
        let mut error = expected_message(input, "a color's name or number");
        error.text.push_str("; ");
        error.text.push_str(&crate::syntax::color::choices());
        return Err(error);
    }
    // Before the name it would be a name itself, and the color's name a stray word.
    if let Some(first) = take_shade(input)
        && let Some(word) = any_word(input)
    {
        let shade = if first.0 == Shade::Light { "light" } else { "dark" };
        let place = Place::at(first.1).to(Place::at(word.span()));
        let text = format!("`{shade}` stands after the color's name; write `{word} {shade}`");
        return Err(Message::new(place, text));
    }
    let value = expression(input)?;
    let shade = take_shade(input);
    Ok(Some(Color { value, shade }))
}

/// Takes the word `light` or `dark`.
fn take_shade(input: ParseStream) -> Option<(Shade, Span)> {
    let light = take_word(input, "light").map(|word| (Shade::Light, word));
    light.or_else(|| take_word(input, "dark").map(|word| (Shade::Dark, word)))
}

fn after_color(input: ParseStream) -> Read<()> {
    let on = take_word(input, "on").or_else(|| take_word(input, "plane"));
    match on {
        Some(on) => {
            Err(Message::new(Place::at(on), "`on plane` stands before `color`; swap the two"))
        }
        None => Ok(()),
    }
}

fn circle(input: ParseStream) -> Read<Outline> {
    let center = pair(input)?;
    Ok(Outline::Circle { center, radius: read_labelled(input, "radius")? })
}

fn ring(input: ParseStream) -> Read<Outline> {
    let center = pair(input)?;
    Ok(Outline::Ring {
        center,
        radius: read_labelled(input, "radius")?,
        hole: read_labelled(input, "hole")?,
    })
}

fn bar(input: ParseStream) -> Read<Outline> {
    let (pins, place) = in_brackets(input, "`[(x, y), ...]`", corners)?;
    Ok(Outline::Bar { pins, place, width: read_labelled(input, "width")? })
}

fn polygon(input: ParseStream) -> Read<Outline> {
    let (corners, place) = in_brackets(input, "`[(x, y), ...]`", corners)?;
    Ok(Outline::Polygon { corners, place })
}

fn matter(input: ParseStream, keyword: Span, kind: fn(ParseStream) -> Read<MatterKind>) -> Item {
    match to_semicolon(input, &ITEMS, kind) {
        Ok(kind) => Item::Matter(Box::new(Matter { keyword, kind })),
        Err(error) => Item::Broken(Broken { error, names: Vec::new() }),
    }
}

/// Reads `0.4 at (0.1, 0) inertia 2e-3`.
fn mass(input: ParseStream) -> Read<MatterKind> {
    let mass = expression(input)?;
    let at = take_word(input, "at").map(|_| pair(input)).transpose()?;
    let inertia = take_word(input, "inertia").map(|_| expression(input)).transpose()?;
    Ok(MatterKind::Mass { mass, at, inertia })
}

fn density(input: ParseStream) -> Read<MatterKind> {
    expression(input).map(MatterKind::Density)
}

/// `{ ... }` or `;`
pub(super) fn body(input: ParseStream, begin: Cursor) -> Read<Vec<Item>> {
    if take(input, ";").is_some() {
        return Ok(Vec::new());
    }
    if input.peek(token::Brace) {
        return items(input);
    }
    let missing = "`{` or `;`";
    let forgotten = missing_after(input, begin, &STATEMENTS, missing);
    Err(forgotten.unwrap_or_else(|| expected_message(input, missing)))
}

/// Returns the help for a word that begins no item of a link, but something else.
fn as_item(word: &str) -> Option<String> {
    STATEMENTS.contains(&word).then(|| {
        format!("`{word}` is a statement of its own; write it after the braces of the link")
    })
}
