//! Masses of links.

use super::draft::Draft;
use super::name::Body;
use super::reader::Reader;
use crate::model::{Figure, LinkId, Mass, Shape, ShapeKind};
use crate::syntax::Place;
use crate::syntax::ast::{Expr, Matter, MatterKind, Pair};

/// What the mass of a link is made from, once all its shapes are known.
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
        MatterKind::Density(density) => reader
            .positive(density, "a density")
            .map(|density| Massive::Density(density, place)),
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
    let center = center.map(|(center, _)| center);
    let inertia = inertia.map_or(Some(0.0), |inertia| {
        reader.not_negative(inertia, "a moment of inertia")
    });
    Some(Mass {
        mass: weight?,
        center: center?,
        inertia: inertia?,
    })
}

/// Gives a link its mass, now that its shapes are known.
pub(super) fn weigh(
    reader: &mut Reader,
    draft: &mut Draft,
    link: LinkId,
    massive: Option<Massive>,
) {
    let Some(massive) = massive else {
        return;
    };
    let known = &draft.model.link(link).shapes;
    let mass = match massive {
        Massive::Given(mass) => mass,
        Massive::Density(density, place) => {
            if known.is_empty() {
                let name = &draft.model.link(link).name;
                let text = format!(
                    "`{name}` has no shapes whose mass this could be; draw it, or give its `mass`"
                );
                return reader.report.error(place, text);
            }
            if known.iter().any(Shape::varies) {
                let name = &draft.model.link(link).name;
                let text = format!(
                    "the shapes of `{name}` depend on a param, but a mass may not; give its `mass`"
                );
                return reader.report.error(place, text);
            }
            let has_unknown = known.iter().any(|shape| {
                matches!(
                    &shape.kind,
                    ShapeKind::Figure(Figure::Gear { radius: None, .. })
                )
            });
            if has_unknown {
                let text = "a gear without `radius` has no area yet; give its `radius`, or the `mass` of the link";
                return reader.report.error(place, text);
            }
            Mass::of_shapes(known, density)
        }
    };
    draft.model.links[link.index()].mass = Some(mass);
}
