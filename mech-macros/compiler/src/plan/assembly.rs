//! The start: every way in which the parts can be put together, and the one that is meant.

use super::algebra::{Numbers, Pose};
use super::angles::Angles;
use super::closed_form::{Closure, close};
use super::equation::Equation;
use super::placement::{Coordinate, Placement};
use super::step::{Connection, ConnectionKind, Loop, Mesh, Step};
use crate::model::{JointId, LinkId, Model, Near};
use crate::structure::Diagnosis;

/// With more assemblies than this still open the search stops and lists them.
const MOST: usize = 64;

/// Where everything is at the start.
#[derive(Clone, Debug, PartialEq)]
pub struct Assembly {
    /// For each link the cosine, sine, x and y of its pose in the scene.
    pub poses: Vec<[f64; 4]>,
    /// The values of the motors.
    pub motors: Vec<f64>,
    /// For each gear step, in order, the angles of the driving and of the driven wheel relative to the carrier.
    pub meshes: Vec<(f64, f64)>,
}

/// An assembly in the making.
#[derive(Clone)]
struct Draft<'m> {
    placement: Placement<'m, f64>,
    angles: Angles<f64>,
    meshes: Vec<(f64, f64)>,
}

/// Assembles a mechanism.
pub(super) fn assemble(model: &Model, steps: &[Step]) -> Result<Assembly, Diagnosis> {
    start_is_free(model, steps)?;
    let mut drafts = vec![Draft {
        placement: Placement::new(&mut Numbers, model),
        angles: Angles::new(&mut Numbers, model.links.len()),
        meshes: Vec::new(),
    }];
    let mut wishes: Vec<Near> = model.start.near.clone();
    for step in steps {
        drafts = match step {
            Step::Drive(drive) => {
                let value = start_value(model, drive.connection.joint);
                drafts
                    .into_iter()
                    .map(|draft| draft.drive(drive.connection, value))
                    .collect()
            }
            Step::Mesh(mesh) => drafts
                .into_iter()
                .map(|draft| draft.mesh(model, mesh))
                .collect(),
            Step::Close(ring) => closed(&drafts, ring)?,
        };
        drafts = as_drawn(model, drafts)?;
        wishes.retain(|wish| {
            let ready = drafts
                .iter()
                .all(|draft| draft.placement.clusters.joined(wish.link, LinkId::GROUND));
            if ready {
                keep_nearest(&mut drafts, *wish);
            }
            !ready
        });
        if drafts.len() > MOST {
            return Err(several(model, &drafts));
        }
    }
    match &drafts[..] {
        [draft] => Ok(Assembly {
            poses: model
                .link_ids()
                .map(|link| flat(draft.placement.pose(link)))
                .collect(),
            motors: model
                .motors
                .iter()
                .map(|motor| start_value(model, motor.joint))
                .collect(),
            meshes: draft.meshes.clone(),
        }),
        _ => Err(several(model, &drafts)),
    }
}

fn flat(pose: Pose<f64>) -> [f64; 4] {
    [
        pose.direction[0],
        pose.direction[1],
        pose.origin[0],
        pose.origin[1],
    ]
}

fn start_value(model: &Model, joint: JointId) -> f64 {
    model
        .start
        .values
        .iter()
        .find(|value| value.joint == joint)
        .map_or(0.0, |value| value.value)
}

/// Only a motor or a gear leaves a joint's start to be chosen.
fn start_is_free(model: &Model, steps: &[Step]) -> Result<(), Diagnosis> {
    let meshed = |joint| {
        steps
            .iter()
            .any(|step| matches!(step, Step::Mesh(mesh) if mesh.output.joint == joint))
    };
    let free = |joint| model.motor_of(joint).is_some() || meshed(joint);
    match model.start.values.iter().find(|value| !free(value.joint)) {
        Some(value) => Err(Diagnosis::StartNotFree { joint: value.joint }),
        None => Ok(()),
    }
}

impl Draft<'_> {
    fn drive(mut self, connection: Connection, value: f64) -> Self {
        let coordinate = match connection.kind {
            ConnectionKind::Revolute => Coordinate::Turn([value.cos(), value.sin()]),
            ConnectionKind::Prismatic => Coordinate::Slide(value),
        };
        let turn = if connection.kind == ConnectionKind::Revolute {
            value
        } else {
            0.0
        };
        self.note_angle(connection, turn);
        self.placement.connect(&mut Numbers, connection, coordinate);
        self
    }

    fn mesh(mut self, model: &Model, mesh: &Mesh) -> Self {
        let carrier = model.axis(mesh.input.from).link;
        let wheel = model.axis(mesh.input.to).link;
        let input = match self.angles.between(&mut Numbers, carrier, wheel) {
            Some(angle) => angle,
            None => self.principal(carrier, wheel),
        };
        // From here on its turns are counted, by the program too.
        self.angles.join(&mut Numbers, carrier, wheel, input);
        let forwards = model.ends(mesh.output.joint).1 == model.axis(mesh.output.to).link;
        let given = start_value(model, mesh.output.joint);
        let value = if forwards { given } else { -given };
        let output = value + mesh.output.frame_angle(model);
        self.meshes.push((input, output));
        self.drive(mesh.output, value)
    }

    /// The angle in (−π, π] from the frame of one link to that of another in the same cluster.
    fn principal(&self, from: LinkId, to: LinkId) -> f64 {
        let [a, b] = self.placement.pose(from).direction;
        let [c, d] = self.placement.pose(to).direction;
        (a * d - b * c).atan2(a * c + b * d)
    }

    fn note_angle(&mut self, connection: Connection, turn: f64) {
        let (from, to) = (
            self.placement.axis(connection.from),
            self.placement.axis(connection.to),
        );
        let angle = turn + connection.frame_angle(self.placement.model);
        self.angles.join(&mut Numbers, from.link, to.link, angle);
    }
}

/// Every way of closing a loop, for every draft.
fn closed<'m>(drafts: &[Draft<'m>], ring: &Loop) -> Result<Vec<Draft<'m>>, Diagnosis> {
    let mut gap = f64::INFINITY;
    let mut dead = false;
    let mut found = Vec::new();
    for draft in drafts {
        let closure = match Equation::new(&mut Numbers, &draft.placement, ring) {
            Some(equation) => (close(&equation), Some(equation)),
            None => (Closure::Dead, None),
        };
        match closure {
            (Closure::Ways(ways), Some(equation)) => {
                for way in ways {
                    let mut draft = draft.clone();
                    equation.place(&mut Numbers, &mut draft.placement, ring, way);
                    let slides = ring
                        .ring
                        .iter()
                        .filter(|connection| connection.kind == ConnectionKind::Prismatic);
                    slides.for_each(|&connection| draft.note_angle(connection, 0.0));
                    found.push(draft);
                }
            }
            (Closure::Gap(missing), _) => gap = gap.min(missing),
            _ => dead = true,
        }
    }
    if !found.is_empty() {
        Ok(found)
    } else if dead {
        Err(Diagnosis::DeadStart {
            unknowns: ring.unknowns(),
        })
    } else {
        Err(Diagnosis::CannotClose {
            unknowns: ring.unknowns(),
            gap,
            axes: (ring.ring[1].from, ring.ring[1].to),
        })
    }
}

/// Keeps the drafts in which this link points nearest to where it is wanted.
fn keep_nearest(drafts: &mut Vec<Draft<'_>>, wish: Near) {
    let away = |draft: &Draft<'_>| {
        let [cos, sin] = draft.placement.pose(wish.link).direction;
        let (s, c) = wish.angle.sin_cos();
        (sin * c - cos * s).atan2(cos * c + sin * s).abs()
    };
    let least = drafts.iter().map(away).fold(f64::INFINITY, f64::min);
    drafts.retain(|draft| away(draft) <= least + 1e-6);
}

/// Keeps the drafts that leave the links of the drawing where they were drawn.
fn as_drawn<'m>(model: &Model, drafts: Vec<Draft<'m>>) -> Result<Vec<Draft<'m>>, Diagnosis> {
    let mut astray = None;
    let mut kept = Vec::new();
    for draft in drafts {
        match strayed(model, &draft.placement) {
            None => kept.push(draft),
            Some(link) => astray = astray.or(Some(link)),
        }
    }
    match astray {
        Some(link) if kept.is_empty() => Err(Diagnosis::NotAsDrawn { link }),
        _ => Ok(kept),
    }
}

/// A drawn link that is not where it was drawn, relative to the drawn link before it in its cluster.
fn strayed(model: &Model, placement: &Placement<'_, f64>) -> Option<LinkId> {
    let drawn = |link: LinkId| link == LinkId::GROUND || model.link(link).drawn;
    let size = model.axes.iter().fold(0.0_f64, |size, axis| {
        size.max(axis.at[0].abs()).max(axis.at[1].abs())
    });
    let links: Vec<LinkId> = model.link_ids().filter(|&link| drawn(link)).collect();
    links
        .iter()
        .copied()
        .enumerate()
        .skip(1)
        .find_map(|(index, link)| {
            let first = links[..index]
                .iter()
                .copied()
                .find(|&other| placement.clusters.joined(other, link))?;
            let (here, there) = (flat(placement.pose(link)), flat(placement.pose(first)));
            let scale = [1.0, 1.0, size, size];
            let off = (0..4).any(|i| (here[i] - there[i]).abs() > 1e-7 * scale[i]);
            off.then_some(link)
        })
}

/// Which links tell the assemblies apart, and by which angles.
fn several(model: &Model, drafts: &[Draft<'_>]) -> Diagnosis {
    let placed = |link: &LinkId| {
        drafts
            .iter()
            .all(|draft| draft.placement.clusters.joined(*link, LinkId::GROUND))
    };
    let angle = |draft: &Draft<'_>, link| {
        let [cos, sin] = draft.placement.pose(link).direction;
        sin.atan2(cos)
    };
    let same = |a: &Draft<'_>, b: &Draft<'_>, link| {
        let off = (angle(a, link) - angle(b, link)).abs();
        off.min(std::f64::consts::TAU - off) < 1e-5
    };
    let mut links: Vec<LinkId> = Vec::new();
    for link in model.moving_links().filter(placed) {
        let alike = |a: &Draft<'_>, b: &Draft<'_>| links.iter().all(|&link| same(a, b, link));
        let mut pairs = drafts
            .iter()
            .enumerate()
            .flat_map(|(i, a)| drafts[i + 1..].iter().map(move |b| (a, b)));
        if pairs.any(|(a, b)| alike(a, b) && !same(a, b, link)) {
            links.push(link);
        }
    }
    let angles = drafts
        .iter()
        .map(|draft| links.iter().map(|&link| angle(draft, link)).collect())
        .collect();
    Diagnosis::SeveralAssemblies { links, angles }
}
