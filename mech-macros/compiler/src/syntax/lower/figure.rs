//! Shapes that stand for a part of a machine.

use super::angle::is_degrees_perhaps;
use super::draft::Draft;
use super::quantity::Spot;
use super::reader::Reader;
use super::report::Report;
use crate::model::{Figure, JointKind, LinkId, Model, Ratio, ShapeKind};
use crate::syntax::Place;
use crate::syntax::ast::{Expr, Outline, Pair};
use std::f64::consts::PI;

/// A gear has at least so many teeth, and at most.
const TEETH: [i32; 2] = [3, 2000];
/// A text has at most so many letters.
const MOST_LETTERS: usize = 100;

/// A shape that depends on no param.
pub(super) fn figure(reader: &mut Reader, outline: &Outline) -> Option<ShapeKind> {
    let figure = match outline {
        Outline::Gear { center, radius, teeth, turned } => {
            let center = steady_place(reader, center);
            let length = steady_length(reader, radius.as_ref(), "a pitch radius");
            let teeth = reader.whole(teeth, "a number of teeth", TEETH);
            let turned = steady_angle(reader, turned.as_ref());
            let (teeth, turned) = (u32::try_from(teeth?).ok()?, turned?);
            let sense = reader.frame.sense();
            Figure::Gear {
                center: center?,
                radius: length?,
                teeth,
                turned: turned.map(|angle| {
                    let mirrored = if sense < 0.0 { PI - angle } else { angle };
                    mirrored + reader.frame.angle()
                }),
            }
        }
        Outline::Stand { at, height, turned } => {
            let at = steady_place(reader, at);
            let height = steady_length(reader, height.as_ref(), "a height");
            let turned = steady_angle(reader, turned.as_ref())?.unwrap_or(0.0);
            Figure::Stand {
                at: at?,
                height: height?,
                turned: reader.frame.sense() * turned + reader.frame.angle(),
            }
        }
        Outline::Rail { ends, place, width } => {
            let ends = two_ends(reader, ends, *place, "rail");
            let width = steady_length(reader, width.as_ref(), "a width");
            let [from, to] = ends?;
            // Mirrored, the right would be the left.
            let is_mirrored = reader.frame.sense() < 0.0;
            let ends = if is_mirrored { [to, from] } else { [from, to] };
            Figure::Rail { ends, width: width? }
        }
        Outline::Spring { ends, place, width } => {
            let ends = two_ends(reader, ends, *place, "spring");
            let width = steady_length(reader, Some(width), "a width");
            Figure::Spring { ends: ends?, width: width?? }
        }
        Outline::Text { at, text, height, turned } => {
            let at = steady_place(reader, at);
            let height = steady_length(reader, Some(height), "a height");
            let turned = steady_angle(reader, turned.as_ref())?.unwrap_or(0.0);
            let letters = text.value();
            if letters.chars().count() > MOST_LETTERS {
                let message = format!("a text has at most {MOST_LETTERS} letters");
                return reader.report.refuse(Place::at(text.span()), message);
            }
            Figure::Text {
                at: at?,
                height: height??,
                turned: reader.frame.sense() * turned + reader.frame.angle(),
                text: letters,
            }
        }
        _ => return None,
    };
    Some(ShapeKind::Figure(figure))
}

/// The two ends of something straight.
fn two_ends(
    reader: &mut Reader,
    pairs: &[Pair],
    place: Place,
    what: &str,
) -> Option<[[f64; 2]; 2]> {
    let ends = pairs.iter().map(|pair| steady_place(reader, pair));
    let ends: Vec<Option<[f64; 2]>> = ends.collect();
    let [from, to] = ends[..] else {
        let text = format!("a {what} has two ends, not {}", pairs.len());
        return reader.report.refuse(place, text);
    };
    let ends = [from?, to?];
    if ends[0] == ends[1] {
        let text = format!("both ends of this {what} are in one place");
        return reader.report.refuse(place, text);
    }
    Some(ends)
}

/// A place in a link that no param moves.
fn steady_place(reader: &mut Reader, pair: &Pair) -> Option<[f64; 2]> {
    let spot: Spot = (reader.pair(pair)?, [None; 2]);
    let (place, formulas) = reader.transform(spot, reader.frame, pair.place)?;
    is_steady(reader, &formulas, pair.place).then_some(place)
}

/// A length that no param changes; none if it is not given.
#[expect(clippy::option_option, reason = "an error, or a length that may be left out")]
fn steady_length(reader: &mut Reader, expr: Option<&Expr>, what: &str) -> Option<Option<f64>> {
    let Some(expr) = expr else {
        return Some(None);
    };
    let length = reader.positive(expr, what)?;
    let scale = reader.frame.scale;
    let formulas = [scale.formula];
    is_steady(reader, &formulas, expr.place).then_some(Some(length * scale.value?))
}

/// An angle that no param changes; none if it is not given.
#[expect(clippy::option_option, reason = "an error, or an angle that may be left out")]
fn steady_angle(reader: &mut Reader, expr: Option<&Expr>) -> Option<Option<f64>> {
    let Some(expr) = expr else {
        return Some(None);
    };
    let value = reader.value(expr)?;
    (!is_degrees_perhaps(reader.report, expr, value)).then_some(Some(value))
}

fn is_steady<F>(reader: &mut Reader, formulas: &[Option<F>], place: Place) -> bool {
    let is_steady = formulas.iter().all(Option::is_none);
    if !is_steady {
        let text = "a param scales or moves this instance, but no param may change this shape; draw it with `circle`, `polygon` or `bar`";
        reader.report.error(place, text);
    }
    is_steady
}

/// Complains about gears without a radius that are no wheel of a joint that gives them one. All joints are known then.
pub(super) fn check_gears(draft: &Draft, report: &mut Report) {
    // A joint that could not be read may be the mesh.
    if !report.is_empty() {
        return;
    }
    let links = (0..).map(LinkId::new).zip(&draft.model.links);
    let shapes = links.flat_map(|(id, link)| link.shapes.iter().map(move |shape| (id, shape)));
    let mut gears: Vec<_> = shapes
        .filter_map(|(link, shape)| match shape.kind {
            ShapeKind::Figure(Figure::Gear { radius: None, teeth, .. }) => {
                let has_radius = meshes(&draft.model, link, teeth);
                (!has_radius).then_some((shape.origin, link, teeth))
            }
            _ => None,
        })
        .collect();
    gears.sort_unstable_by_key(|(origin, ..)| *origin);
    for (origin, link, teeth) in gears {
        let name = &draft.model.link(link).name;
        let text = format!(
            "`{name}` has no mesh with {teeth} teeth that would give this gear its size; write `radius r` before `teeth {teeth}`"
        );
        report.error(draft.places.get(origin), text);
    }
}

/// Whether a joint gives a gear with so many teeth its radius.
fn meshes(model: &Model, link: LinkId, teeth: u32) -> bool {
    model.joints.iter().any(|joint| match joint.kind {
        JointKind::Gear { a, b, ratio, .. } => {
            let own = [a, b].iter().position(|wheel| *wheel == link);
            own.is_some_and(|own| match ratio {
                Ratio::Teeth(..) => ratio.sizes()[own].abs() == f64::from(teeth),
                Ratio::Radii(..) => true,
            })
        }
        JointKind::Rack { pinion, .. } => pinion == link,
        _ => false,
    })
}
