//! Shapes that stand for a part of a machine.

use super::Lowering;
use super::param::Spot;
use crate::model::{Figure, JointKind, LinkId, Ratio, ShapeKind};
use crate::syntax::Place;
use crate::syntax::ast::{Expr, Outline, Pair};
use std::f64::consts::PI;

/// A gear has at least so many teeth, and at most.
const TEETH: [i32; 2] = [3, 2000];
/// A text has at most so many letters.
const MOST_LETTERS: usize = 100;

/// A gear whose radius is that of a mesh.
pub(super) struct Unsized {
    link: LinkId,
    teeth: u32,
    place: Place,
}

impl Lowering {
    /// A shape that depends on no param.
    pub(super) fn figure(
        &mut self,
        link: LinkId,
        outline: &Outline,
        keyword: Place,
    ) -> Option<ShapeKind> {
        let figure = match outline {
            Outline::Gear {
                center,
                radius,
                teeth,
                turned,
            } => {
                let center = self.steady_place(center);
                let length = self.steady_length(radius.as_ref(), "a pitch radius");
                let teeth = self.whole(teeth, "a number of teeth", TEETH);
                let turned = self.steady_angle(turned.as_ref());
                let (teeth, turned) = (u32::try_from(teeth?).ok()?, turned?);
                if radius.is_none() {
                    self.unsized_gears.push(Unsized {
                        link,
                        teeth,
                        place: keyword,
                    });
                }
                let sense = self.similarity.sense();
                Figure::Gear {
                    center: center?,
                    radius: length?,
                    teeth,
                    turned: turned.map(|angle| {
                        let mirrored = if sense < 0.0 { PI - angle } else { angle };
                        mirrored + self.similarity.angle()
                    }),
                }
            }
            Outline::Stand { at, height, turned } => {
                let at = self.steady_place(at);
                let height = self.steady_length(height.as_ref(), "a height");
                let turned = self.steady_angle(turned.as_ref())?.unwrap_or(0.0);
                Figure::Stand {
                    at: at?,
                    height: height?,
                    turned: self.similarity.sense() * turned + self.similarity.angle(),
                }
            }
            Outline::Rail { ends, place, width } => {
                let ends = self.two_ends(ends, *place, "rail");
                let width = self.steady_length(width.as_ref(), "a width");
                let [from, to] = ends?;
                // Mirrored, the right would be the left.
                let is_mirrored = self.similarity.sense() < 0.0;
                let ends = if is_mirrored { [to, from] } else { [from, to] };
                Figure::Rail {
                    ends,
                    width: width?,
                }
            }
            Outline::Spring { ends, place, width } => {
                let ends = self.two_ends(ends, *place, "spring");
                let width = self.steady_length(Some(width), "a width");
                Figure::Spring {
                    ends: ends?,
                    width: width??,
                }
            }
            Outline::Text {
                at,
                text,
                height,
                turned,
            } => {
                let at = self.steady_place(at);
                let height = self.steady_length(Some(height), "a height");
                let turned = self.steady_angle(turned.as_ref())?.unwrap_or(0.0);
                let letters = text.value();
                if letters.chars().count() > MOST_LETTERS {
                    let message = format!("a text has at most {MOST_LETTERS} letters");
                    self.report.error(Place::at(text.span()), message);
                    return None;
                }
                Figure::Text {
                    at: at?,
                    height: height??,
                    turned: self.similarity.sense() * turned + self.similarity.angle(),
                    text: letters,
                }
            }
            _ => return None,
        };
        Some(ShapeKind::Figure(figure))
    }

    /// The two ends of something straight.
    fn two_ends(&mut self, pairs: &[Pair], place: Place, what: &str) -> Option<[[f64; 2]; 2]> {
        let ends: Vec<Option<[f64; 2]>> =
            pairs.iter().map(|pair| self.steady_place(pair)).collect();
        let [from, to] = ends[..] else {
            let text = format!("a {what} has two ends, not {}", pairs.len());
            self.report.error(place, text);
            return None;
        };
        let ends = [from?, to?];
        if ends[0] == ends[1] {
            let text = format!("both ends of this {what} are in one place");
            self.report.error(place, text);
            return None;
        }
        Some(ends)
    }

    /// A place in a link that no param moves.
    fn steady_place(&mut self, pair: &Pair) -> Option<[f64; 2]> {
        let spot: Spot = (self.pair(pair)?, [None; 2]);
        let similarity = self.similarity;
        let (place, formulas) = self.transform(spot, &similarity, pair.place)?;
        self.is_steady(&formulas, pair.place).then_some(place)
    }

    /// A length that no param changes; none if it is not given.
    #[expect(
        clippy::option_option,
        reason = "an error, or a length that may be left out"
    )]
    fn steady_length(&mut self, expr: Option<&Expr>, what: &str) -> Option<Option<f64>> {
        let Some(expr) = expr else {
            return Some(None);
        };
        let length = self.positive(expr, what)?;
        let scale = self.similarity.scale;
        let formulas = [scale.formula];
        self.is_steady(&formulas, expr.place)
            .then_some(Some(length * scale.value?))
    }

    /// An angle that no param changes; none if it is not given.
    #[expect(
        clippy::option_option,
        reason = "an error, or an angle that may be left out"
    )]
    fn steady_angle(&mut self, expr: Option<&Expr>) -> Option<Option<f64>> {
        let Some(expr) = expr else {
            return Some(None);
        };
        let value = self.value(expr)?;
        (!self.is_degrees_perhaps(expr, value)).then_some(Some(value))
    }

    fn is_steady<F>(&mut self, formulas: &[Option<F>], place: Place) -> bool {
        let is_steady = formulas.iter().all(Option::is_none);
        if !is_steady {
            let text = "a param scales or moves this instance, but no param may change this shape; draw it with `circle`, `polygon` or `bar`";
            self.report.error(place, text);
        }
        is_steady
    }

    /// Whether every gear without a radius is a wheel of a joint that gives it one. All joints are known then.
    pub(super) fn check_gears(&mut self) {
        // A joint that could not be read may be the mesh.
        if !self.report.is_empty() {
            return;
        }
        for gear in std::mem::take(&mut self.unsized_gears) {
            let has_radius = self.model.joints.iter().any(|joint| match joint.kind {
                JointKind::Gear { a, b, ratio, .. } => {
                    let own = [a, b].iter().position(|link| *link == gear.link);
                    own.is_some_and(|own| match ratio {
                        Ratio::Teeth(..) => ratio.sizes()[own].abs() == f64::from(gear.teeth),
                        Ratio::Radii(..) => true,
                    })
                }
                JointKind::Rack { pinion, .. } => pinion == gear.link,
                _ => false,
            });
            if !has_radius {
                let name = &self.model.link(gear.link).name;
                let teeth = gear.teeth;
                let text = format!(
                    "`{name}` has no mesh with {teeth} teeth that would give this gear its size; write `radius r` before `teeth {teeth}`"
                );
                self.report.error(gear.place, text);
            }
        }
    }
}
