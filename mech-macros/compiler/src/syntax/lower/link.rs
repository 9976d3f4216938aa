//! Links, and what is fixed to them.

use super::Lowering;
use super::name::{Body, Referent, word_for};
use super::param::{Length, Quantity, Spot};
use crate::model::{self, AxisKind, FORWARD, FormulaId, LinkId, ShapeKind, color_of};
use crate::syntax::ast::{
    Axis, AxisValue, Color, Expr, ExprKind, Ground, Item, Link, Outline, Pair, Read, Shape,
};
use crate::syntax::{Place, color};

/// Places in a link, and how each of their numbers is computed that depends on a param.
type Spots = (Vec<[f64; 2]>, Vec<Option<FormulaId>>);
/// The outline of a shape, and how each of its numbers is computed that depends on a param.
type Drawing = (ShapeKind, Vec<Option<FormulaId>>);

impl Lowering {
    pub(super) fn declare_ground(&mut self, ground: &Ground) {
        self.single(ground.keyword, "ground", "put everything into the first");
        if let Some(link) = self.model.links.first_mut()
            && link.origin == model::Origin::default()
        {
            link.origin = self.places.note(Place::at(ground.keyword));
        }
        self.lower_items(LinkId::GROUND.into(), &ground.items);
    }

    pub(super) fn declare_link(&mut self, link: &Link) {
        if self.claim(&link.name, "link") {
            let id = LinkId::new(self.model.links.len());
            let origin = self.note(&link.name);
            let key = self.key_of(&link.name);
            self.model.links.push(model::Link::new(&key, origin));
            self.link_scopes.push(self.scopes.current());
            self.names.enter(key, Referent::Link(id.into()));
            // What belongs to a part comes to its place when its ports are lent.
            if self.scopes.here().part.is_none() {
                self.lower_items(id.into(), &link.items);
            }
            return;
        }
        // What the second of a name has, the first has not; but that is not the trouble.
        let key = self.key_of(&link.name);
        match self.names.get(&key) {
            Some(Referent::Link(first)) => self.names.lose_axis(first, None),
            _ => self.names.enter(key, Referent::Broken),
        }
        self.pass_on_items(&link.items);
    }

    /// Reports at least what could not be read in a link that is left out.
    fn pass_on_items(&mut self, items: &Read<Vec<Item>>) {
        let errors: Vec<_> = match items {
            Err(error) => vec![error],
            Ok(items) => items.iter().filter_map(error_of).collect(),
        };
        for error in errors {
            self.report.next_item();
            self.report.pass_on(error.clone());
        }
    }

    /// Enters what is fixed to a link.
    pub(super) fn lower_items(&mut self, link: Body, items: &Read<Vec<Item>>) {
        let items = match items {
            Ok(items) => items,
            Err(error) => {
                self.report.pass_on(error.clone());
                return self.names.lose_axis(link, None);
            }
        };
        let mut massive = None;
        for item in items {
            self.report.next_item();
            match item {
                Item::Matter(matter) => self.lower_matter(link, matter, &mut massive),
                Item::Axis(axis) => self.lower_axis(link, axis),
                Item::Shape(shape) => self.lower_shape(link.id, shape),
                Item::Broken(broken) => {
                    self.report.pass_on(broken.error.clone());
                    broken
                        .name
                        .iter()
                        .for_each(|name| self.names.lose_axis(link, Some(name)));
                }
            }
        }
        self.weigh(link.id, massive);
    }

    /// Enters an axis, also one whose numbers are wrong: its name is known, and it is not to be missed elsewhere.
    fn lower_axis(&mut self, link: Body, axis: &Axis) {
        let kept = self.claim_axis(link, axis);
        let (at, direction) = match &axis.value {
            Ok(value) => self.axis_value(axis.kind, value),
            Err(error) => {
                self.report.pass_on(error.clone());
                (None, None)
            }
        };
        if !kept {
            return;
        }
        let origin = self.note(&axis.name);
        // An error was reported: any value will do.
        let (at, formulas) = at.unwrap_or_default();
        let direction = direction.unwrap_or((FORWARD, [None; 2]));
        let similarity = self.similarity;
        let (direction, direction_formulas) = self.transform_direction(direction, &similarity);
        let port = link.port.map(|port| self.ports[port].path.clone());
        self.model.axes.push(model::Axis {
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
    fn axis_value(&mut self, kind: AxisKind, value: &AxisValue) -> (Option<Spot>, Option<Spot>) {
        let (at, direction) = self.untransformed(kind, value);
        let similarity = self.similarity;
        let at = at.and_then(|at| self.transform(at, &similarity, value.at.place));
        (at, direction)
    }

    /// The same before what the scope does to it.
    fn untransformed(&mut self, kind: AxisKind, value: &AxisValue) -> (Option<Spot>, Option<Spot>) {
        let at = self.spot(&value.at);
        let direction = value.direction.as_ref();
        let direction = direction.and_then(|direction| match kind {
            AxisKind::Point => self.fixed_direction(direction),
            AxisKind::Line => self.direction(direction),
        });
        let Some(angle) = &value.turned else {
            return (at, direction);
        };
        let Some(by) = self.direction_at_angle(angle) else {
            return (None, None);
        };
        // A point without a direction of its own keeps that of its link.
        if kind == AxisKind::Point && direction.is_some() && by.1 != [None; 2] {
            self.refuse_turning_point(&[angle]);
            return (None, None);
        }
        let place = value.at.place;
        let mut turn = |spot: Option<Spot>| self.turn(spot?, by, place);
        (turn(at), turn(direction))
    }

    /// Takes the name of an axis: whether it can have it.
    fn claim_axis(&mut self, link: Body, axis: &Axis) -> bool {
        let text = axis.name.to_string();
        if let Some(earlier) = self.axis_of(link, &text) {
            let earlier = word_for(self.model.axis(earlier).kind);
            let link = self.name_of(link);
            let message = format!("`{link}` has a {earlier} `{text}` already; choose another name");
            self.report.error(Place::at(axis.name.span()), message);
            return false;
        }
        let kept = axis.kind == model::AxisKind::Line || self.claim_point(link, &axis.name);
        if !kept {
            self.names.lose_axis(link, Some(&axis.name));
        }
        kept
    }

    fn lower_shape(&mut self, link: LinkId, shape: &Shape) {
        let kind = match &shape.outline {
            Outline::Circle { center, radius } => self.circle(center, radius),
            Outline::Ring {
                center,
                radius,
                hole,
            } => self.ring(center, radius, hole),
            Outline::Polygon { corners, place } => self.polygon(corners, *place),
            Outline::Bar { pins, place, width } => self.bar(pins, *place, width),
            figure => {
                let why =
                    "`circle`, `ring`, `polygon` and `bar` may depend on one, this shape may not";
                let keyword = Place::at(shape.keyword);
                let figure =
                    self.with_fixed_numbers(why, |lowering| lowering.figure(link, figure, keyword));
                figure.map(|figure| (figure, Vec::new()))
            }
        };
        let plane = match &shape.plane {
            Some(plane) => self.plane(plane),
            None => Some(0),
        };
        let color = match &shape.color {
            Some(color) => self.color(color),
            None => Some(color_of(link)),
        };
        let (Some((kind, formulas)), Some(plane), Some(color)) = (kind, plane, color) else {
            return;
        };
        let origin = self.places.note(Place::at(shape.keyword));
        self.model.links[link.index()].shapes.push(model::Shape {
            origin,
            kind,
            plane,
            color,
            formulas,
        });
    }

    /// The number of a plane.
    pub(super) fn plane(&mut self, plane: &Expr) -> Option<i32> {
        self.whole(plane, "a plane", [i32::MIN, i32::MAX])
    }

    /// An entry of the palette.
    pub(super) fn color(&mut self, color: &Color) -> Option<u8> {
        let Color { value, shade } = color;
        if let ExprKind::Constant(name) = &value.kind
            && !self.constants().has(&name.to_string())
        {
            let entry = color::named(&name.to_string(), shade.map(|(shade, _)| shade));
            return match entry {
                Ok(entry) => Some(entry),
                Err(text) => {
                    self.report.error(value.place, text);
                    None
                }
            };
        }
        let number = self.whole(value, "the number of a color", [0, 255])?;
        if let Some((_, word)) = *shade {
            let text = "only a color with a name has a shade; leave this word out, or give the color by its name";
            self.report.error(Place::at(word), text);
            return None;
        }
        u8::try_from(number).ok()
    }

    fn circle(&mut self, center: &Pair, radius: &Expr) -> Option<Drawing> {
        let center = self.fixed_spot(center);
        let radius = self.fixed_length(radius, "a radius");
        let ((center, [x, y]), (radius, reach)) = (center?, radius?);
        Some((ShapeKind::Circle { center, radius }, vec![x, y, reach]))
    }

    fn ring(&mut self, center: &Pair, radius: &Expr, hole: &Expr) -> Option<Drawing> {
        let center = self.fixed_spot(center);
        let radius = self.fixed_length(radius, "a radius");
        let inner = self.fixed_length(hole, "the radius of a hole");
        let ((radius, reach), (inner, within)) = (radius?, inner?);
        if inner >= radius {
            let text =
                format!("the hole of a ring is smaller than the ring, whose radius is {radius}");
            self.report.error(hole.place, text);
            return None;
        }
        let (center, [x, y]) = center?;
        let kind = ShapeKind::Ring {
            center,
            radius,
            hole: inner,
        };
        Some((kind, vec![x, y, reach, within]))
    }

    fn bar(&mut self, pins: &[Pair], place: Place, width: &Expr) -> Option<Drawing> {
        let found = self.spots(pins);
        let width = self.fixed_length(width, "a width");
        if pins.len() < 2 {
            let text = format!("a bar has at least two pins, not {}", pins.len());
            self.report.error(place, text);
            return None;
        }
        let ((pins, mut formulas), (width, breadth)) = (found?, width?);
        formulas.push(breadth);
        Some((ShapeKind::Bar { pins, width }, formulas))
    }

    fn polygon(&mut self, corners: &[Pair], place: Place) -> Option<Drawing> {
        let found = self.spots(corners);
        if corners.len() < 3 {
            let text = format!(
                "a polygon has at least three corners, not {}",
                corners.len()
            );
            self.report.error(place, text);
            return None;
        }
        let (corners, formulas) = found?;
        Some((ShapeKind::Polygon(corners), formulas))
    }

    /// A place in a link.
    fn fixed_spot(&mut self, pair: &Pair) -> Option<Spot> {
        let (spot, similarity) = (self.spot(pair)?, self.similarity);
        self.transform(spot, &similarity, pair.place)
    }

    /// A length on a link, greater than zero.
    fn fixed_length(&mut self, expr: &Expr, what: &str) -> Option<Length> {
        let (value, formula) = self.length(expr, what)?;
        let length = Quantity {
            value: Some(value),
            formula,
        };
        let scaled = self.product(length, self.similarity.scale);
        Some((scaled.value?, scaled.formula))
    }

    /// Some places in a link, and how all of their numbers are computed. All are looked at, so that all of their errors are reported.
    fn spots(&mut self, pairs: &[Pair]) -> Option<Spots> {
        let spots: Vec<Option<Spot>> = pairs.iter().map(|pair| self.fixed_spot(pair)).collect();
        let spots: Vec<Spot> = spots.into_iter().collect::<Option<_>>()?;
        let (points, formulas): (_, Vec<_>) = spots.into_iter().unzip();
        Some((points, formulas.concat()))
    }
}

/// What could not be read of an item.
pub(super) fn error_of(item: &Item) -> Option<&crate::syntax::Message> {
    match item {
        Item::Axis(axis) => axis.value.as_ref().err(),
        Item::Shape(_) | Item::Matter(_) => None,
        Item::Broken(broken) => Some(&broken.error),
    }
}
