//! The start: every assembly of the parts, and the one that is meant.

use super::algebra::Numbers;
use super::closed_form::{LoopSolutions, solve};
use super::equation::Equation;
use super::placement::Placement;
use super::search::search;
use super::step::{Cam, Connection, ConnectionKind, Loop, Source, Step};
use super::unknown::Solution;
use crate::bug::bug;
use crate::model::{JointId, JointKind, LinkId, Model, Near};
use crate::structure::{Diagnosis, LoopAssembly, OpenLoop};
use std::f64::consts::TAU;

/// No more assemblies than this are compared with each other.
const MOST: usize = 64;

/// The angles of two assemblies differ by more than this.
const APART: f64 = 1e-5;

/// The position of everything at the start.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Assembly {
    /// For each link the cosine, sine, x and y of its pose in the scene.
    pub poses: Vec<[f64; 4]>,
    /// The values of the motors.
    pub motors: Vec<f64>,
    /// For each mesh step, in order, the coordinate of the joint it moves.
    pub meshes: Vec<f64>,
    /// For each cam step, in order, where it starts.
    pub cams: Vec<CamStart>,
    /// The sources that gears, belts, racks and cams are solved from.
    pub sources: Vec<f64>,
}

/// The start of a cam.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CamStart {
    /// The cam.
    pub cam: JointId,
    /// The coordinate of its shaft.
    pub shaft: f64,
    /// The coordinate of its follower.
    pub follower: f64,
}

/// An assembly in the making.
#[derive(Clone)]
struct Draft<'m> {
    placement: Placement<'m, f64>,
    meshes: Vec<f64>,
    cams: Vec<CamStart>,
    /// The number of each loop's assembly, in the order of the loops.
    solutions: Vec<usize>,
}

/// Assembles a mechanism.
pub(super) fn assemble(
    model: &Model,
    steps: &[Step],
    sources: &[Source],
) -> Result<Assembly, Diagnosis> {
    start_is_free(model, steps)?;
    let mut drafts = vec![Draft {
        placement: Placement::new(&mut Numbers, model),
        meshes: Vec::new(),
        cams: Vec::new(),
        solutions: Vec::new(),
    }];
    let mut many = false;
    let mut wishes: Vec<Near> = model.start.near.clone();
    let size = size(model);
    for step in steps {
        drafts = match step {
            Step::Close(closing) => close_loop((&drafts, size), closing)?,
            step => drafts
                .into_iter()
                .map(|draft| draft.follow(model, steps, step))
                .collect::<Result<_, _>>()?,
        };
        drafts = keep_as_drawn(model, drafts, size)?;
        let is_ready = |wish: &Near| is_placed(&drafts, wish.link);
        let ready = wishes.extract_if(.., |wish| is_ready(wish)).collect();
        follow_wishes(&mut drafts, ready);
        if drafts.len() > MOST {
            many = true;
            keep_alike(&mut drafts);
        }
    }
    match &drafts[..] {
        [draft] if !many => Ok(draft.finish(model, sources)),
        _ => Err(several(model, steps, &drafts, many)),
    }
}

/// Of very many drafts, keeps the first and those in which one loop is closed otherwise.
fn keep_alike(drafts: &mut Vec<Draft<'_>>) {
    if let Some(first) = drafts.first().map(|draft| draft.solutions.clone()) {
        drafts.retain(|draft| differing_loops(&draft.solutions, &first).count() <= 1);
    }
}

/// The loops that are closed otherwise.
fn differing_loops(a: &[usize], b: &[usize]) -> impl Iterator<Item = usize> {
    let pairs: Vec<bool> = a.iter().zip(b).map(|(a, b)| a != b).collect();
    (0..pairs.len()).filter(move |&number| pairs[number])
}

/// The start value of a connection's joint, from the connection's first axis to its second.
fn start_along(model: &Model, connection: Connection) -> f64 {
    let forwards = model.ends(connection.joint).1 == model.axis(connection.to).link;
    let value = model.start.value(connection.joint);
    if forwards { value } else { -value }
}

/// Whether a joint's start may be chosen: only a motor or a gear, belt or rack leaves it open.
fn is_free(model: &Model, steps: &[Step], joint: JointId) -> bool {
    let meshed = |step: &Step| matches!(step, Step::Mesh(mesh) if mesh.connection.joint == joint);
    model.motor_of(joint).is_some() || steps.iter().any(meshed)
}

fn start_is_free(model: &Model, steps: &[Step]) -> Result<(), Diagnosis> {
    let free = |joint| is_free(model, steps, joint);
    match model.start.values.iter().find(|value| !free(value.joint)) {
        Some(value) => Err(Diagnosis::StartNotFree { joint: value.joint }),
        None => Ok(()),
    }
}

impl Draft<'_> {
    /// The draft after a step that closes no loop.
    fn follow(mut self, model: &Model, steps: &[Step], step: &Step) -> Result<Self, Diagnosis> {
        Ok(match step {
            Step::Weld(weld) => {
                let direction = Solution::Direction(weld.direction);
                self.placement.connect(&mut Numbers, weld.connection, direction);
                self
            }
            Step::Drive(drive) => {
                let value = model.start.value(drive.connection.joint);
                self.put(drive.connection, value)
            }
            Step::Mesh(mesh) => {
                let value = start_along(model, mesh.connection);
                self.meshes.push(value);
                self.put(mesh.connection, value)
            }
            Step::Cam(cam) => self.cam(model, steps, cam)?,
            Step::Close(_) => self,
        })
    }

    fn put(mut self, connection: Connection, value: f64) -> Self {
        let coordinate = match connection.kind {
            ConnectionKind::Revolute => Solution::Direction([value.cos(), value.sin()]),
            ConnectionKind::Prismatic => Solution::Slide(value),
        };
        self.placement.connect(&mut Numbers, connection, coordinate);
        self
    }

    /// Puts a follower where the law of its cam has it.
    fn cam(mut self, model: &Model, steps: &[Step], cam: &Cam) -> Result<Self, Diagnosis> {
        let JointKind::Cam { shaft, law, .. } = model.joint(cam.by).kind else {
            return Ok(self);
        };
        let shaft = self.coordinate(model, steps, shaft);
        let follower = model.at_start(model.law(law), shaft);
        if !model.precision.holds(follower) {
            return Err(Diagnosis::CamWithoutValue { joint: cam.by, at: shaft });
        }
        self.cams.push(CamStart { cam: cam.by, shaft, follower });
        Ok(self.put(cam.connection, follower))
    }

    /// The coordinate of a joint whose links are in one cluster. Of an angle that nothing gives, that between −π and π.
    fn coordinate(&self, model: &Model, steps: &[Step], joint: JointId) -> f64 {
        let follows = |start: &&CamStart| matches!(model.joint(start.cam).kind, JointKind::Cam { follower, .. } if follower == joint);
        if is_free(model, steps, joint) {
            return model.start.value(joint);
        }
        if let Some(start) = self.cams.iter().find(follows) {
            return start.follower;
        }
        match model.joint(joint).kind {
            JointKind::Revolute(from, to) => {
                let axes = [from, to];
                angle_between(axes.map(|axis| self.placement.heading(&mut Numbers, axis)))
            }
            _ => self.placement.sliding_coordinate(&mut Numbers, joint),
        }
    }

    fn finish(&self, model: &Model, sources: &[Source]) -> Assembly {
        Assembly {
            poses: model.link_ids().map(|link| self.placement.pose(link).numbers()).collect(),
            motors: model.motors.iter().map(|motor| model.start.value(motor.joint)).collect(),
            meshes: self.meshes.clone(),
            cams: self.cams.clone(),
            sources: sources.iter().map(|source| self.source(model, *source)).collect(),
        }
    }

    fn source(&self, model: &Model, source: Source) -> f64 {
        match source {
            Source::Motor(motor) => model.start.value(model.motor(motor).joint),
            Source::Angle { from, to } => {
                angle_between([from, to].map(|link| self.placement.pose(link).direction))
            }
            Source::Displacement(joint) => self.placement.sliding_coordinate(&mut Numbers, joint),
        }
    }
}

/// The angle from one direction to another, between −π and π.
fn angle_between([[a, b], [c, d]]: [[f64; 2]; 2]) -> f64 {
    (a * d - b * c).atan2(a * c + b * d)
}

/// Every assembly of a loop, for every draft.
fn close_loop<'m>(
    (drafts, size): (&[Draft<'m>], f64),
    closing: &Loop,
) -> Result<Vec<Draft<'m>>, Diagnosis> {
    let mut gap = f64::INFINITY;
    let mut dead = false;
    let mut found = Vec::new();
    for draft in drafts {
        let equation = Equation::new(&mut Numbers, &draft.placement, closing);
        let solutions = solve(&equation).unwrap_or_else(|| {
            let wanted = equation.directions(|base| wanted_angle(&draft.placement, base));
            search(&equation, &wanted, size)
        });
        match solutions {
            LoopSolutions::Found(solutions) => {
                for (number, solution) in solutions.into_iter().enumerate() {
                    let mut draft = draft.clone();
                    draft.solutions.push(number);
                    equation.place(&mut Numbers, &mut draft.placement, closing, &solution);
                    found.push(draft);
                }
            }
            LoopSolutions::Gap(missing) => gap = gap.min(missing),
            LoopSolutions::DeadPoint => dead = true,
        }
    }
    if !found.is_empty() {
        return Ok(found);
    }
    let unknowns = closing.unknowns();
    if dead {
        return Err(Diagnosis::DeadStart { unknowns });
    }
    let ring = closing.rings.last();
    let Some(across) = ring.and_then(|ring| ring.get(1).or(ring.first())) else {
        bug!("a loop has no connection across which it closes");
    };
    Err(Diagnosis::CannotClose { unknowns, gap, axes: (across.from, across.to) })
}

/// The angle in which the start wants the base of a cluster. It is given by any link of the cluster that has a wish or is drawn: the base
/// may be one that nobody declared.
fn wanted_angle(placement: &Placement<'_, f64>, base: LinkId) -> Option<f64> {
    let model = placement.model;
    let wished = |link: LinkId| {
        let near = model.start.near.iter().find(|near| near.link == link);
        let drawn = link == LinkId::GROUND || model.link(link).drawn;
        near.map(|near| near.angle).or(drawn.then_some(0.0))
    };
    let mut links = placement.clusters.links(base).into_iter();
    links.find_map(|link| {
        let [cos, sin] = placement.pose(link).direction;
        Some(wished(link)? - sin.atan2(cos))
    })
}

/// The greatest distance of an axis from the origin of its link.
fn size(model: &Model) -> f64 {
    model.axes.iter().fold(0.0_f64, |size, axis| size.max(axis.at[0].abs()).max(axis.at[1].abs()))
}

/// Whether the pose of a link is known in all drafts.
fn is_placed(drafts: &[Draft<'_>], link: LinkId) -> bool {
    let mut clusters = drafts.iter().map(|draft| &draft.placement.clusters);
    clusters.all(|clusters| clusters.are_joined(link, LinkId::GROUND))
}

/// Keeps the drafts that the wishes (`near`) ask for, in whatever order these were declared. The link with the fewest directions comes
/// first: it may decide the others.
fn follow_wishes(drafts: &mut Vec<Draft<'_>>, mut wishes: Vec<Near>) {
    let key =
        |drafts: &[Draft<'_>], wish: &Near| (directions(drafts, wish.link), wish.link.index());
    while let Some(next) = (0..wishes.len()).min_by_key(|&number| key(drafts, &wishes[number])) {
        keep_nearest(drafts, wishes.swap_remove(next));
    }
}

/// The number of directions a link has in the drafts.
fn directions(drafts: &[Draft<'_>], link: LinkId) -> usize {
    let mut angles: Vec<f64> = Vec::new();
    for angle in drafts.iter().map(|draft| angle(draft, link)) {
        if angles.iter().all(|&other| turn(angle, other) >= APART) {
            angles.push(angle);
        }
    }
    angles.len()
}

/// Keeps the drafts in which this link points nearest to where it is wanted.
fn keep_nearest(drafts: &mut Vec<Draft<'_>>, wish: Near) {
    let away = |draft: &Draft<'_>| {
        let (sin, cos) = wish.angle.sin_cos();
        angle_between([[cos, sin], draft.placement.pose(wish.link).direction]).abs()
    };
    let least = drafts.iter().map(away).fold(f64::INFINITY, f64::min);
    drafts.retain(|draft| away(draft) <= least + 1e-6);
}

/// Keeps the drafts that leave the links of the drawing where they were drawn.
fn keep_as_drawn<'m>(
    model: &Model,
    drafts: Vec<Draft<'m>>,
    size: f64,
) -> Result<Vec<Draft<'m>>, Diagnosis> {
    let mut astray = None;
    let mut kept = Vec::new();
    for mut draft in drafts {
        match misplaced_link(model, &mut draft.placement, size) {
            None => kept.push(draft),
            Some(link) => astray = astray.or(Some(link)),
        }
    }
    match astray {
        Some(link) if kept.is_empty() => Err(Diagnosis::NotAsDrawn { link }),
        _ => Ok(kept),
    }
}

/// A drawn link that the last step did not leave where it was drawn, relative to the first drawn link in its cluster.
fn misplaced_link(model: &Model, placement: &mut Placement<'_, f64>, size: f64) -> Option<LinkId> {
    let drawn = |link: &LinkId| *link == LinkId::GROUND || model.link(*link).drawn;
    let moved = placement.take_moved();
    let cluster = placement.clusters.base(*moved.first()?);
    let (first, looked_at) = if drawn(&cluster) {
        (cluster, moved)
    } else {
        let links = placement.clusters.links(cluster);
        (links.iter().copied().find(drawn)?, links)
    };
    let there = placement.pose(first).numbers();
    looked_at.into_iter().filter(drawn).find(|&link| {
        let here = placement.pose(link).numbers();
        let scale = [1.0, 1.0, size, size];
        (0..4).any(|i| (here[i] - there[i]).abs() > 1e-7 * scale[i])
    })
}

/// The angle of a link in the scene.
fn angle(draft: &Draft<'_>, link: LinkId) -> f64 {
    let [cos, sin] = draft.placement.pose(link).direction;
    sin.atan2(cos)
}

/// The difference of two angles, whole turns aside.
fn turn(a: f64, b: f64) -> f64 {
    let off = (a - b).abs() % TAU;
    off.min(TAU - off)
}

/// The links by whose angles the assemblies differ, and these angles.
fn several(model: &Model, steps: &[Step], drafts: &[Draft<'_>], many: bool) -> Diagnosis {
    let placed = |link: &LinkId| is_placed(drafts, *link);
    let same = |a: &Draft<'_>, b: &Draft<'_>, link| turn(angle(a, link), angle(b, link)) < APART;
    let mut links: Vec<LinkId> = Vec::new();
    for link in model.declared_links().filter(placed) {
        let alike = |a: &Draft<'_>, b: &Draft<'_>| links.iter().all(|&link| same(a, b, link));
        let mut pairs = drafts
            .iter()
            .enumerate()
            .flat_map(|(i, a)| drafts[i + 1..].iter().map(move |b| (a, b)));
        if pairs.any(|(a, b)| alike(a, b) && !same(a, b, link)) {
            links.push(link);
        }
    }
    let angles =
        drafts.iter().map(|draft| links.iter().map(|&link| angle(draft, link)).collect()).collect();
    Diagnosis::SeveralAssemblies { links, angles, loops: open_loops(model, steps, drafts), many }
}

/// The loops that have several assemblies while all others are as in the first draft.
fn open_loops(model: &Model, steps: &[Step], drafts: &[Draft<'_>]) -> Vec<OpenLoop> {
    let closings = steps.iter().filter_map(|step| match step {
        Step::Close(closing) => Some(closing),
        _ => None,
    });
    let Some((first, others)) = drafts.split_first() else {
        return Vec::new();
    };
    let open = |(number, closing): (usize, &Loop)| {
        let others = others.iter();
        let others =
            others.filter(|draft| differing_loops(&draft.solutions, &first.solutions).eq([number]));
        let all: Vec<&Draft<'_>> = std::iter::once(first).chain(others).collect();
        open_loop(model, steps, closing, &all)
    };
    closings.enumerate().filter_map(open).collect()
}

/// A loop, with the link by whose angle its assemblies differ most, and the joint by whose coordinate they do.
fn open_loop(
    model: &Model,
    steps: &[Step],
    closing: &Loop,
    drafts: &[&Draft<'_>],
) -> Option<OpenLoop> {
    let least = |differ: &dyn Fn(&Draft<'_>, &Draft<'_>) -> f64| {
        let pairs = drafts
            .iter()
            .enumerate()
            .flat_map(|(number, a)| drafts[..number].iter().map(move |b| (a, b)));
        pairs.map(|(a, b)| differ(a, b)).fold(f64::INFINITY, f64::min)
    };
    let best = |all: Vec<(f64, usize)>| all.into_iter().max_by(|a, b| a.0.total_cmp(&b.0));
    let unknowns = closing.unknowns();
    let ends = unknowns
        .iter()
        .flat_map(|&joint| <[LinkId; 2]>::from(model.ends(joint)))
        .filter(|link| model.declared_links().any(|declared| declared == *link));
    let ends = ends.map(|link| {
        let differ = least(&|a, b| turn(angle(a, link), angle(b, link)));
        (differ, link.index())
    });
    let (differ, link) = best(ends.collect())?;
    if drafts.len() < 2 || differ < APART {
        return None;
    }
    let shown = unknowns.iter().filter(|id| !model.joint(**id).hidden);
    let joints = shown.map(|&joint| {
        let at = |draft: &Draft<'_>| draft.coordinate(model, steps, joint);
        let differ = match model.joint(joint).kind {
            JointKind::Revolute(..) => least(&|a, b| turn(at(a), at(b))),
            _ => least(&|a, b| (at(a) - at(b)).abs()),
        };
        (differ, joint.index())
    });
    let joint = JointId::new(best(joints.collect())?.1);
    let link = LinkId::new(link);
    let assemblies = drafts.iter().map(|draft| LoopAssembly {
        angle: angle(draft, link),
        coordinate: draft.coordinate(model, steps, joint),
    });
    Some(OpenLoop { joint, link, assemblies: assemblies.collect() })
}
