//! Masses of links.

use super::draft::Draft;
use super::name::Body;
use super::reader::Reader;
use crate::model::{Figure, LinkId, Mass, Shape, ShapeKind};
use crate::syntax::Place;
use crate::syntax::ast::{Expr, Matter, MatterKind, Pair};

/// The declared mass or density of a link, from which its mass is made once all its shapes are known.
#[derive(Clone, Copy)]
pub(super) enum Massive {
    Given(Mass),
    Density(f64, Place),
}

/// The mass of a link; `earlier` is what was said of it before.
pub(super) fn matter(
    reader: &mut Reader,
    draft: &Draft,
    link: Body,
    matter: &Matter,
    earlier: &mut Option<Massive>,
) {
    let place = Place::at(matter.keyword);
    let massive = match &matter.kind {
        MatterKind::Mass { mass, at, inertia } => {
            given(reader, mass, at.as_ref(), inertia.as_ref()).map(Massive::Given)
        }
        MatterKind::Density(density) => {
            reader.positive(density, "a density").map(|density| Massive::Density(density, place))
        }
    };
    if link.id == LinkId::GROUND {
        let text = "the ground does not move, whatever its mass; leave this out";
        return reader.report.error(place, text);
    }
    if earlier.is_some() || draft.model.link(link.id).mass.is_some() {
        let name = reader.names.name_of(&draft.model, link);
        let text = format!("`{name}` has a mass already; remove one of the two");
        return reader.report.error(place, text);
    }
    *earlier = massive;
}

fn given(
    reader: &mut Reader,
    mass: &Expr,
    at: Option<&Pair>,
    inertia: Option<&Expr>,
) -> Option<Mass> {
    let weight = reader.not_negative(mass, "a mass");
    let center = at.map_or(Some([0.0, 0.0]), |at| reader.pair(at));
    let center = center.and_then(|center| {
        let place = at.map_or(mass.place, |at| at.place);
        reader.transform((center, [None; 2]), reader.frame, place)
    });
    let what = "a moment of inertia";
    let inertia = inertia.map_or(Some(0.0), |inertia| reader.not_negative(inertia, what));
    Some(Mass { mass: weight?, center: center?.0, inertia: inertia? })
}

/// Gives a link its mass, now that its shapes are known.
pub(super) fn weigh(reader: &mut Reader, draft: &mut Draft, link: LinkId, massive: Massive) {
    let link = &mut draft.model.links[link.index()];
    let (density, place) = match massive {
        Massive::Given(mass) => {
            link.mass = Some(mass);
            return;
        }
        Massive::Density(density, place) => (density, place),
    };
    let name = &link.name;
    let has_no_radius = |shape: &Shape| match shape.kind {
        ShapeKind::Figure(Figure::Gear { radius, .. }) => radius.is_none(),
        _ => false,
    };
    let text = if link.shapes.is_empty() {
        format!("`{name}` has no shapes whose mass this could be; draw it, or give its `mass`")
    } else if link.shapes.iter().any(Shape::varies) {
        format!("the shapes of `{name}` depend on a param, but a mass may not; give its `mass`")
    } else if link.shapes.iter().any(has_no_radius) {
        "a gear without `radius` has no area yet; give its `radius`, or the `mass` of the link"
            .to_owned()
    } else {
        link.mass = Some(Mass::of_shapes(&link.shapes, density));
        return;
    };
    reader.report.error(place, text);
}
