//! The symbols of a diagram, one method for each kind.

use super::{Spot, Symbol, spot};
use crate::model::{AxisId, AxisKind, JointId, JointKind, LinkId, Measure, Model};
use crate::structure::{Pin, Structure};

/// The diagram of a coherent mechanism, in the order in which it is drawn. Only the ground and links for which `has_pose` holds are
/// in it.
#[must_use]
pub fn symbols(
    model: &Model,
    structure: &Structure,
    has_pose: impl Fn(LinkId) -> bool,
) -> Vec<Symbol> {
    let diagram =
        Diagram { model, structure, has_pose: &|link| link == LinkId::GROUND || has_pose(link) };
    let links = model.declared_links().filter(|&link| has_pose(link));
    let mut all: Vec<Symbol> = links.flat_map(|link| diagram.bars(link)).collect();
    let rollings = structure.rollings.iter();
    all.extend(rollings.flat_map(|rolling| diagram.rolling(rolling)));
    all.extend(diagram.axes(AxisKind::Line));
    all.extend(diagram.axes(AxisKind::Point));
    all.extend(model.joint_ids().filter_map(|joint| diagram.slide(joint)));
    all.extend(model.joints.iter().filter_map(|joint| match joint.kind {
        JointKind::Weld(a, b) => diagram.first_visible(&[a, b]).map(Symbol::Weld),
        _ => None,
    }));
    all.extend(diagram.elastic());
    all.extend(model.cams().filter_map(|(_, shaft, follower, _)| diagram.cam(shaft, follower)));
    let pivots = structure.pins.iter().filter_map(|pin| diagram.pivot(pin));
    all.extend(pivots.map(Symbol::Pivot));
    all.extend(diagram.marks());
    all.extend(diagram.motors());
    all
}

/// The symbols of springs and dampers only.
#[must_use]
pub(crate) fn elastic_symbols(
    model: &Model,
    structure: &Structure,
    has_pose: impl Fn(LinkId) -> bool,
) -> Vec<Symbol> {
    let diagram = Diagram { model, structure, has_pose: &has_pose };
    diagram.elastic()
}

/// The points whose velocities are drawn: named points and revolute joints on links for which `has_pose` holds. Each is there once, and
/// none that is fixed.
#[must_use]
pub fn moving_points(
    model: &Model,
    structure: &Structure,
    has_pose: impl Fn(LinkId) -> bool,
) -> Vec<Spot> {
    let mut spots: Vec<Spot> = Vec::new();
    for id in axis_ids(model) {
        let axis = model.axis(id);
        let mut pins = structure.pins.iter();
        let pin = pins.find(|pin| pin.members.iter().any(|member| member.1 == id));
        let is_point =
            axis.kind == AxisKind::Point && (axis.name.is_none() || model.shows_point(id));
        let is_declared = model.link(axis.link).die.is_none() && axis.link != LinkId::GROUND;
        // One axis of each pin is enough.
        let is_first = pin.is_none_or(|pin| {
            let mut members = pin.members.iter().filter(|member| has_pose(member.0));
            pin.axis_of(LinkId::GROUND).is_none()
                && members.next().is_some_and(|member| member.1 == id)
        });
        let spot = spot(model, id);
        let is_new = !spots.contains(&spot);
        if is_point && is_declared && is_first && has_pose(axis.link) && is_new {
            spots.push(spot);
        }
    }
    spots
}

fn axis_ids(model: &Model) -> impl Iterator<Item = AxisId> + use<> {
    (0..model.axes.len()).map(AxisId::new)
}

/// A mechanism, of which only links with poses are drawn.
pub(super) struct Diagram<'m> {
    pub(super) model: &'m Model,
    pub(super) structure: &'m Structure,
    pub(super) has_pose: &'m dyn Fn(LinkId) -> bool,
}

impl Diagram<'_> {
    pub(super) fn spot(&self, axis: AxisId) -> Spot {
        spot(self.model, axis)
    }

    /// The direction of a line.
    pub(super) fn along(&self, line: AxisId) -> [Measure; 2] {
        self.model.axis(line).along()
    }

    /// The first of these axes, all in one place, whose link has a pose.
    pub(super) fn first_visible(&self, axes: &[AxisId]) -> Option<Spot> {
        let mut spots = axes.iter().map(|&axis| self.spot(axis));
        spots.find(|spot| (self.has_pose)(spot.link))
    }

    /// The place of a pin: on the ground, if it is fixed there.
    fn pivot(&self, pin: &Pin) -> Option<Spot> {
        let mut axes: Vec<AxisId> = pin.members.iter().map(|member| member.1).collect();
        axes.sort_by_key(|&axis| self.model.axis(axis).link != LinkId::GROUND);
        self.first_visible(&axes)
    }

    /// The symbol of a prismatic joint.
    fn slide(&self, joint: JointId) -> Option<Symbol> {
        let [guide, block] = self.model.guide_and_block(joint)?;
        let block = self.model.seen_axis(block);
        let (at, block) = (self.first_visible(&[guide])?, self.first_visible(&[block])?);
        Some(Symbol::Slide { guide: at, along: self.along(guide), block })
    }

    /// The symbol of a cam, on the link of its shaft that is not its carrier.
    fn cam(&self, shaft: JointId, follower: JointId) -> Option<Symbol> {
        let carrier = self.model.carrier_of_cam(shaft, follower)?;
        let axes = self.model.joint(shaft).kind.axes()?;
        let own = axes.into_iter().find(|&axis| self.model.axis(axis).link != carrier)?;
        let at = self.first_visible(&[own])?;
        Some(match self.model.axis(own).kind {
            AxisKind::Point => Symbol::Cam(at),
            AxisKind::Line => Symbol::Wedge { at, along: self.along(own) },
        })
    }

    /// The sides of a link, as a polygon around its joints and named points.
    fn bars(&self, link: LinkId) -> Vec<Symbol> {
        let on_it = |axis: &AxisId| self.model.axis(*axis).link == link;
        let pins = self.structure.pins.iter().filter_map(|pin| pin.axis_of(link));
        let slides = self.model.joints.iter().flat_map(|joint| match joint.kind {
            JointKind::Prismatic(a, b) | JointKind::Weld(a, b) => vec![a, b],
            _ => Vec::new(),
        });
        let slides = slides.filter(on_it);
        let points = axis_ids(self.model);
        let points = points.filter(|axis| on_it(axis) && self.is_shown_point(*axis));
        let mut corners: Vec<Spot> = Vec::new();
        for axis in pins.chain(slides).chain(points) {
            let spot = self.spot(axis);
            if !corners.contains(&spot) {
                corners.push(spot);
            }
        }
        let bar = |ends: [Spot; 2]| {
            let ends = ends.map(|end| end.at);
            Symbol::Bar { link, ends }
        };
        match corners[..] {
            [] | [_] => Vec::new(),
            [one, other] => vec![bar([one, other])],
            _ => {
                sort_around_center(&mut corners);
                let next = corners.iter().cycle().skip(1);
                let sides = corners.iter().zip(next);
                sides.map(|(one, other)| bar([*one, *other])).collect()
            }
        }
    }

    /// Whether an axis is a named point that is shown.
    fn is_shown_point(&self, axis: AxisId) -> bool {
        self.model.axis(axis).name.is_some() && self.model.shows_point(axis)
    }

    /// The named points without a joint.
    fn marks(&self) -> Vec<Symbol> {
        let in_use = |axis: AxisId| {
            let spot = self.spot(axis);
            let mut pins = self.structure.pins.iter();
            pins.any(|pin| {
                let pin = pin.axis_of(spot.link);
                pin.is_some_and(|pin| self.spot(pin) == spot)
            })
        };
        let points = axis_ids(self.model).filter(|&axis| {
            let link = self.model.axis(axis).link;
            link != LinkId::GROUND
                && (self.has_pose)(link)
                && self.is_shown_point(axis)
                && !in_use(axis)
        });
        points.map(|axis| Symbol::Mark(self.spot(axis))).collect()
    }

    /// The declared axes of a kind on links with poses.
    fn axes(&self, kind: AxisKind) -> Vec<Symbol> {
        let declared = axis_ids(self.model).filter(|&id| {
            let axis = self.model.axis(id);
            axis.kind == kind && axis.name.is_some() && (self.has_pose)(axis.link)
        });
        let symbol = |axis: AxisId| match kind {
            AxisKind::Point => Symbol::Point(self.spot(axis)),
            AxisKind::Line => Symbol::Line { at: self.spot(axis), along: self.along(axis) },
        };
        declared.map(symbol).collect()
    }

    /// The symbols of the motors.
    fn motors(&self) -> Vec<Symbol> {
        let symbol = |joint: JointId| match self.model.joint(joint).kind {
            JointKind::Revolute(a, b) => self.first_visible(&[a, b]).map(Symbol::RotaryMotor),
            JointKind::Prismatic(..) => match self.slide(joint)? {
                Symbol::Slide { guide, along, block } => {
                    Some(Symbol::LinearMotor { block, guide: guide.link, along })
                }
                _ => None,
            },
            _ => None,
        };
        let motors = self.model.motors.iter();
        motors.filter_map(|motor| symbol(motor.joint)).collect()
    }
}

/// Sorts corners by their direction from their mean.
fn sort_around_center(corners: &mut [Spot]) {
    #[expect(clippy::cast_precision_loss, reason = "a few corners")]
    let share = 1.0 / corners.len() as f64;
    let at = |corner: &Spot| corner.at.map(Measure::at_start);
    let center =
        corners.iter().map(at).fold([0.0, 0.0], |[x, y], [u, v]| [x + u * share, y + v * share]);
    corners.sort_by(|one, other| {
        let angle = |[x, y]: [f64; 2]| libm::atan2(y - center[1], x - center[0]);
        angle(at(one)).total_cmp(&angle(at(other)))
    });
}
