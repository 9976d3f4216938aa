//! The diagram of a mechanism: its joints, links, motors and axes as a textbook draws them.

use crate::model::{AxisId, AxisKind, JointId, JointKind, LinkId, Model, Ratio};
use crate::structure::{Pin, Rolling, RollingEnd, Structure};

/// A place on a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The link; the ground too.
    pub link: LinkId,
    /// Where, in its frame: at the start, if params move it.
    pub at: [f64; 2],
    /// The axis whose place it is.
    pub axis: AxisId,
}

impl Spot {
    /// Where an axis is.
    pub(crate) fn of(model: &Model, id: AxisId) -> Self {
        let axis = model.axis(id);
        Self {
            link: axis.link,
            at: axis.at,
            axis: id,
        }
    }

    /// Whether another is on the same link and in the same place, also where params move them.
    fn is_with(&self, other: &Self, model: &Model) -> bool {
        let formulas = |spot: &Self| model.axis(spot.axis).formulas;
        self.link == other.link && self.at == other.at && formulas(self) == formulas(other)
    }
}

/// What is drawn of a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Symbol {
    /// A side of a link, from one of its joints to the next.
    Bar {
        /// The link.
        link: LinkId,
        /// Both ends, on it.
        ends: [Spot; 2],
    },
    /// A point of a link where no joint is.
    Mark(Spot),
    /// The pitch circle of a wheel, as large as at the start.
    Wheel {
        /// Its centre.
        center: Spot,
        /// Its radius, in scene units.
        radius: f64,
    },
    /// The strands of a belt between two wheels.
    Belt {
        /// The centres of the wheels.
        centers: [Spot; 2],
        /// Their radii, in scene units.
        radii: [f64; 2],
    },
    /// The pitch line of a toothed bar.
    Rack {
        /// The centre of the pinion.
        pinion: Spot,
        /// The pinion's pitch radius, in scene units, as declared: negative on the other side.
        radius: f64,
        /// The bar, at the origin of the line along which it slides.
        bar: Spot,
        /// That line.
        along: AxisId,
    },
    /// A line along which something slides.
    Line {
        /// Its origin.
        at: Spot,
        /// The line.
        along: AxisId,
    },
    /// A point about which something turns.
    Point(Spot),
    /// A prismatic joint, or that of a slot.
    Slide {
        /// The part with the guide, at the origin of its line.
        guide: Spot,
        /// The line of the guide.
        along: AxisId,
        /// The part that slides.
        block: Spot,
    },
    /// A weld.
    Weld(Spot),
    /// A revolute joint; on the ground, a fixed pivot.
    Pivot(Spot),
    /// A motor that turns.
    Turned(Spot),
    /// A motor that slides.
    Pushed {
        /// What it slides.
        block: Spot,
        /// The link with the guide.
        guide: LinkId,
        /// The line of the guide.
        along: AxisId,
    },
}

/// The diagram of a coherent mechanism, from what is drawn first to what is drawn last. Only what lies on links that `is_kept` is
/// in it; the ground always is.
#[must_use]
pub fn symbols(
    model: &Model,
    structure: &Structure,
    is_kept: impl Fn(LinkId) -> bool,
) -> Vec<Symbol> {
    let diagram = Diagram {
        model,
        structure,
        is_kept: &|link| link == LinkId::GROUND || is_kept(link),
    };
    let slides: Vec<Symbol> = model
        .joint_ids()
        .filter_map(|joint| diagram.slide(joint))
        .collect();
    let links = model.declared_links().filter(|&link| is_kept(link));
    let mut all: Vec<Symbol> = links.flat_map(|link| diagram.bars(link)).collect();
    all.extend(
        structure
            .rollings
            .iter()
            .flat_map(|one| diagram.rolling(one)),
    );
    all.extend(diagram.axes(AxisKind::Line));
    all.extend(diagram.axes(AxisKind::Point));
    all.extend(slides);
    all.extend(model.joints.iter().filter_map(|joint| match joint.kind {
        JointKind::Weld(a, b) => diagram.first_kept(&[a, b]).map(Symbol::Weld),
        _ => None,
    }));
    let pivots = structure.pins.iter().filter_map(|pin| diagram.pivot(pin));
    all.extend(pivots.map(Symbol::Pivot));
    all.extend(diagram.marks());
    all.extend(diagram.motors());
    all
}

/// The points whose velocities are worth an arrow: named points and revolute joints on links that `is_kept`, each once, and none that
/// does not move.
#[must_use]
pub fn moving_points(
    model: &Model,
    structure: &Structure,
    is_kept: impl Fn(LinkId) -> bool,
) -> Vec<Spot> {
    let mut spots: Vec<Spot> = Vec::new();
    for (index, axis) in model.axes.iter().enumerate() {
        let id = AxisId::new(index);
        let pin = structure
            .pins
            .iter()
            .find(|pin| pin.members.iter().any(|member| member.1 == id));
        let is_point =
            axis.kind == AxisKind::Point && (axis.name.is_none() || model.shows_point(id));
        let declared = model.link(axis.link).die.is_none() && axis.link != LinkId::GROUND;
        // Of all that is on one pin the first will do.
        let first = pin.is_none_or(|pin| {
            let mut kept = pin.members.iter().filter(|member| is_kept(member.0));
            pin.axis_of(LinkId::GROUND).is_none()
                && kept.next().is_some_and(|member| member.1 == id)
        });
        let spot = Spot::of(model, id);
        let is_new = !spots.iter().any(|known| known.is_with(&spot, model));
        if is_point && declared && first && is_kept(axis.link) && is_new {
            spots.push(spot);
        }
    }
    spots
}

/// A mechanism of which some links are seen.
struct Diagram<'m> {
    model: &'m Model,
    structure: &'m Structure,
    is_kept: &'m dyn Fn(LinkId) -> bool,
}

impl Diagram<'_> {
    fn spot(&self, axis: AxisId) -> Spot {
        Spot::of(self.model, axis)
    }

    /// The first of these axes, all in one place, that is on a link that is kept.
    fn first_kept(&self, axes: &[AxisId]) -> Option<Spot> {
        let mut spots = axes.iter().map(|&axis| self.spot(axis));
        spots.find(|spot| (self.is_kept)(spot.link))
    }

    /// Where a pin is: on the ground, if it is fixed there.
    fn pivot(&self, pin: &Pin) -> Option<Spot> {
        let mut axes: Vec<AxisId> = pin.members.iter().map(|member| member.1).collect();
        axes.sort_by_key(|&axis| self.model.axis(axis).link != LinkId::GROUND);
        self.first_kept(&axes)
    }

    /// The symbol of a joint that slides.
    fn slide(&self, joint: JointId) -> Option<Symbol> {
        let JointKind::Prismatic(a, b) = self.model.joint(joint).kind else {
            return None;
        };
        // The ground has the guide, whichever was named first.
        let (guide, block) = if self.model.axis(b).link == LinkId::GROUND {
            (b, a)
        } else {
            (a, b)
        };
        let block = self.model.seen_axis(block);
        let (at, block) = (self.first_kept(&[guide])?, self.first_kept(&[block])?);
        Some(Symbol::Slide {
            guide: at,
            along: guide,
            block,
        })
    }

    /// The sides of a link: between its joints and its named points, all the way round.
    fn bars(&self, link: LinkId) -> Vec<Symbol> {
        let on_it = |axis: &AxisId| self.model.axis(*axis).link == link;
        let pins = self
            .structure
            .pins
            .iter()
            .filter_map(|pin| pin.axis_of(link));
        let slides = self.model.joints.iter().flat_map(|joint| match joint.kind {
            JointKind::Prismatic(a, b) | JointKind::Weld(a, b) => vec![a, b],
            _ => Vec::new(),
        });
        let slides = slides.filter(on_it);
        let named = (0..self.model.axes.len()).map(AxisId::new);
        let named = named.filter(|axis| on_it(axis) && self.is_seen_point(*axis));
        let mut corners: Vec<Spot> = Vec::new();
        for axis in pins.chain(slides).chain(named) {
            let spot = self.spot(axis);
            if !corners.iter().any(|known| known.is_with(&spot, self.model)) {
                corners.push(spot);
            }
        }
        let bar = |ends: [Spot; 2]| Symbol::Bar { link, ends };
        match corners[..] {
            [] | [_] => Vec::new(),
            [one, other] => vec![bar([one, other])],
            _ => {
                in_a_ring(&mut corners);
                let next = corners.iter().cycle().skip(1);
                let sides = corners.iter().zip(next);
                sides.map(|(one, other)| bar([*one, *other])).collect()
            }
        }
    }

    /// Whether it is a named point that is asked for.
    fn is_seen_point(&self, axis: AxisId) -> bool {
        self.model.axis(axis).name.is_some() && self.model.shows_point(axis)
    }

    /// The named points where no joint is.
    fn marks(&self) -> Vec<Symbol> {
        let in_use = |axis: AxisId| {
            let spot = self.spot(axis);
            let mut pins = self.structure.pins.iter();
            pins.any(|pin| {
                pin.axis_of(spot.link)
                    .is_some_and(|pin| self.spot(pin).is_with(&spot, self.model))
            })
        };
        let axes = (0..self.model.axes.len()).map(AxisId::new);
        let points = axes.filter(|&axis| {
            let link = self.model.axis(axis).link;
            link != LinkId::GROUND
                && (self.is_kept)(link)
                && self.is_seen_point(axis)
                && !in_use(axis)
        });
        points.map(|axis| Symbol::Mark(self.spot(axis))).collect()
    }

    /// The axes of a kind that were declared on links that are kept.
    fn axes(&self, kind: AxisKind) -> Vec<Symbol> {
        let axes = (0..self.model.axes.len()).map(AxisId::new);
        let declared = axes.filter(|&id| {
            let axis = self.model.axis(id);
            axis.kind == kind && axis.name.is_some() && (self.is_kept)(axis.link)
        });
        let symbol = |axis: AxisId| match kind {
            AxisKind::Point => Symbol::Point(self.spot(axis)),
            AxisKind::Line => Symbol::Line {
                at: self.spot(axis),
                along: axis,
            },
        };
        declared.map(symbol).collect()
    }

    /// Wheels, belts and racks.
    fn rolling(&self, rolling: &Rolling) -> Vec<Symbol> {
        let [a, b] = rolling.ends.map(|(end, _)| end);
        match (self.model.joint(rolling.joint).kind, a, b) {
            (JointKind::Gear { ratio, .. }, RollingEnd::Wheel(a), RollingEnd::Wheel(b)) => {
                let (Some(first), Some(second)) =
                    (self.hub(a, rolling.carrier), self.hub(b, rolling.carrier))
                else {
                    return Vec::new();
                };
                let sizes = sizes(ratio);
                let unit = distance(first.1, second.1) / (sizes[0] + sizes[1]).abs();
                let wheels = [(first.0, sizes[0]), (second.0, sizes[1])];
                let wheels = wheels.map(|(center, size)| (center, size.abs() * unit));
                let drawn = wheels.into_iter().filter_map(|(center, radius)| {
                    let center = center.filter(|_| radius.is_finite() && radius > 0.0)?;
                    Some(Symbol::Wheel { center, radius })
                });
                drawn.collect()
            }
            (JointKind::Belt { ratio, .. }, RollingEnd::Wheel(a), RollingEnd::Wheel(b)) => {
                let hubs = (self.hub(a, rolling.carrier), self.hub(b, rolling.carrier));
                let (Some((Some(first), p)), Some((Some(second), q))) = hubs else {
                    return Vec::new();
                };
                let sizes = sizes(ratio);
                let unit = match ratio {
                    Ratio::Radii(..) => 1.0,
                    // As large as they look well.
                    Ratio::Teeth(..) => distance(p, q) / (3.0 * sizes[0].max(sizes[1])),
                };
                let radii = sizes.map(|size| size * unit);
                let wheel = |center, radius| Symbol::Wheel { center, radius };
                vec![
                    wheel(first, radii[0]),
                    wheel(second, radii[1]),
                    Symbol::Belt {
                        centers: [first, second],
                        radii,
                    },
                ]
            }
            (
                JointKind::Rack { radius, .. },
                RollingEnd::Wheel(pinion),
                RollingEnd::Bar { link, slide, .. },
            ) => self
                .rack((pinion, rolling.carrier), radius, link, slide)
                .unwrap_or_default(),
            _ => Vec::new(),
        }
    }

    fn rack(
        &self,
        (pinion, carrier): (LinkId, LinkId),
        radius: f64,
        bar: LinkId,
        slide: JointId,
    ) -> Option<Vec<Symbol>> {
        let center = self.hub(pinion, carrier)?.0?;
        let JointKind::Prismatic(a, b) = self.model.joint(slide).kind else {
            return None;
        };
        let line = if self.model.axis(a).link == bar { a } else { b };
        let wheel = Symbol::Wheel {
            center,
            radius: radius.abs(),
        };
        let Some(at) = self.first_kept(&[line]) else {
            return Some(vec![wheel]);
        };
        let rack = Symbol::Rack {
            pinion: center,
            radius,
            bar: at,
            along: line,
        };
        Some(vec![wheel, rack])
    }

    /// Where the hub of a wheel is, if that is seen, and where in its carrier.
    fn hub(&self, wheel: LinkId, carrier: LinkId) -> Option<(Option<Spot>, [f64; 2])> {
        let mut pins = self.structure.pins.iter();
        let (own, carriers) =
            pins.find_map(|pin| Some((pin.axis_of(wheel)?, pin.axis_of(carrier)?)))?;
        let spot = self.spot(own);
        let spot = (self.is_kept)(wheel).then_some(spot);
        Some((spot, self.model.axis(carriers).at))
    }

    /// The motors.
    fn motors(&self) -> Vec<Symbol> {
        let symbol = |joint: JointId| match self.model.joint(joint).kind {
            JointKind::Revolute(a, b) => self.first_kept(&[a, b]).map(Symbol::Turned),
            JointKind::Prismatic(..) => match self.slide(joint)? {
                Symbol::Slide {
                    guide,
                    along,
                    block,
                } => Some(Symbol::Pushed {
                    block,
                    guide: guide.link,
                    along,
                }),
                _ => None,
            },
            _ => None,
        };
        let motors = self.model.motors.iter();
        motors.filter_map(|motor| symbol(motor.joint)).collect()
    }
}

/// The sizes of two wheels as they were declared.
fn sizes(ratio: Ratio) -> [f64; 2] {
    match ratio {
        #[expect(
            clippy::cast_precision_loss,
            reason = "no wheel has 2⁵² teeth, and it is only drawn"
        )]
        Ratio::Teeth(a, b) => [a as f64, b as f64],
        Ratio::Radii(a, b) => [a, b],
    }
}

fn distance([x, y]: [f64; 2], [u, v]: [f64; 2]) -> f64 {
    libm::hypot(u - x, v - y)
}

/// Puts corners into the order in which they lie around their middle.
fn in_a_ring(corners: &mut [Spot]) {
    #[expect(clippy::cast_precision_loss, reason = "a few corners")]
    let share = 1.0 / corners.len() as f64;
    let middle = corners.iter().fold([0.0, 0.0], |[x, y], corner| {
        [x + corner.at[0] * share, y + corner.at[1] * share]
    });
    corners.sort_by(|one, other| {
        let angle = |[x, y]: [f64; 2]| libm::atan2(y - middle[1], x - middle[0]);
        angle(one.at).total_cmp(&angle(other.at))
    });
}
