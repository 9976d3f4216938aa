//! Graphs of a mechanism, as data and as text for Graphviz: one of links and joints, and two of loops.

mod dot;
mod driver;
#[cfg(test)]
mod tests;

use crate::model::{JointId, LinkId, Model};
use crate::plan::{Loop, Plan};
use crate::structure::Structure;

/// A graph with names, for a page or a tool to draw.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Graph {
    /// The name of the mechanism, and what the graph shows of it.
    pub name: String,
    /// Whether its edges have a direction.
    pub directed: bool,
    /// The vertices.
    pub vertices: Vec<Vertex>,
    /// The edges.
    pub edges: Vec<Edge>,
}

/// A vertex.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Vertex {
    /// Its kind.
    pub kind: VertexKind,
    /// Its name.
    pub name: String,
    /// The unknowns of a loop; empty for other vertices.
    pub detail: String,
    /// The row in which it is best drawn: for a link its distance from the ground in joints, for a loop its level, for a motor 0.
    pub level: usize,
}

/// The kind of a vertex.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexKind {
    /// The fixed link.
    Ground,
    /// A link that can move.
    Link,
    /// A motor.
    Motor,
    /// A loop.
    Loop,
}

/// An edge.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edge {
    /// The index of the vertex at which it begins.
    pub from: usize,
    /// The index of the vertex at which it ends.
    pub to: usize,
    /// Its kind.
    pub kind: EdgeKind,
    /// The names of its joints.
    pub name: String,
    /// The kind of its joint, as it is declared; empty between loops.
    pub detail: String,
    /// Whether it is a joint with a motor.
    pub motor: bool,
}

/// The kind of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EdgeKind {
    /// A joint that belongs to a loop.
    Trunk,
    /// A joint that belongs to no loop.
    Arm,
    /// The first vertex determines the second.
    Leads,
    /// Both loops have joints in common.
    Shares,
}

/// The kinematic graph: links, and the joints between them.
#[must_use]
pub fn kinematic(model: &Model, structure: &Structure) -> Graph {
    let distances = distances(model);
    let vertices = model.link_ids().map(|id| Vertex {
        kind: if id == LinkId::GROUND { VertexKind::Ground } else { VertexKind::Link },
        name: model.link(id).name.clone(),
        detail: String::new(),
        level: distances[id.index()],
    });
    let edges = model.joint_ids().map(|id| {
        let (from, to) = model.ends(id);
        Edge {
            from: from.index(),
            to: to.index(),
            kind: if structure.arms.contains(&id) { EdgeKind::Arm } else { EdgeKind::Trunk },
            name: model.joint(id).name.clone(),
            detail: model.joint(id).kind.plain().word().to_owned(),
            motor: model.motor_of(id).is_some(),
        }
    });
    Graph {
        name: format!("{}: links and joints", model.name),
        directed: false,
        vertices: vertices.collect(),
        edges: edges.collect(),
    }
}

/// The dependency graph of the loops: each loop with its unknowns, after the loops and motors that determine it. The arrow from a motor
/// that acts through gears has the name of the last of them.
#[must_use]
pub fn loops(model: &Model, plan: &Plan) -> Graph {
    let motors = model.motor_ids().map(|id| {
        let joint = model.joint(model.motor(id).joint);
        Vertex {
            kind: VertexKind::Motor,
            name: format!("motor {}", joint.name),
            detail: String::new(),
            level: 0,
        }
    });
    let first = model.motors.len();
    let leads = |(from, to, by): (usize, usize, Option<JointId>)| Edge {
        from,
        to,
        kind: EdgeKind::Leads,
        name: by.map_or(String::new(), |joint| model.joint(joint).name.clone()),
        detail: String::new(),
        motor: false,
    };
    let driven = driver::drivers(model, plan)
        .into_iter()
        .map(|driver| (driver.motor.index(), first + driver.ring, driver.by));
    let needed = plan.loops().enumerate().flat_map(|(index, ring)| {
        let needs = ring.needs.iter();
        needs.map(move |need| (first + need, first + index, None))
    });
    let edges = driven.chain(needed).map(leads).collect();
    let mut graph = Graph {
        name: format!("{}: loops", model.name),
        directed: true,
        vertices: motors.chain(loop_vertices(model, plan)).collect(),
        edges,
    };
    graph.remove_idle_motors();
    graph
}

/// The graph of loops that have joints in common, as the paper introduces them.
#[must_use]
pub fn common_joints(model: &Model, plan: &Plan) -> Graph {
    let rings: Vec<&Loop> = plan.loops().collect();
    let mut edges = Vec::new();
    for (to, ring) in rings.iter().enumerate() {
        for (from, other) in rings[..to].iter().enumerate() {
            let common = |joint: &&JointId| other.members.contains(joint);
            let common: Vec<JointId> = ring.members.iter().filter(common).copied().collect();
            if !common.is_empty() {
                edges.push(Edge {
                    from,
                    to,
                    kind: EdgeKind::Shares,
                    name: names(model, common),
                    detail: String::new(),
                    motor: false,
                });
            }
        }
    }
    Graph {
        name: format!("{}: loops with joints in common", model.name),
        directed: false,
        vertices: loop_vertices(model, plan).collect(),
        edges,
    }
}

impl Graph {
    /// The graph as text for Graphviz.
    #[must_use]
    pub fn to_dot(&self) -> String {
        dot::dot(self)
    }

    /// Removes the motors that determine no loop.
    fn remove_idle_motors(&mut self) {
        for index in (0..self.vertices.len()).rev() {
            let idle = |edge: &Edge| edge.from != index && edge.to != index;
            if self.vertices[index].kind == VertexKind::Motor && self.edges.iter().all(idle) {
                self.vertices.remove(index);
                for edge in &mut self.edges {
                    edge.from -= usize::from(edge.from > index);
                    edge.to -= usize::from(edge.to > index);
                }
            }
        }
    }
}

fn loop_vertices(model: &Model, plan: &Plan) -> impl Iterator<Item = Vertex> {
    plan.loops().enumerate().map(|(index, ring)| Vertex {
        kind: VertexKind::Loop,
        name: format!("loop {}", index + 1),
        detail: names(model, ring.unknowns()),
        level: ring.level,
    })
}

fn names(model: &Model, joints: impl IntoIterator<Item = JointId>) -> String {
    let names = joints.into_iter().map(|id| model.joint(id).name.as_str()).collect::<Vec<_>>();
    names.join(" ")
}

/// The distance of each link from the ground in joints: the number of links, if no joints lead to it.
fn distances(model: &Model) -> Vec<usize> {
    let far = model.links.len();
    let mut distances = vec![far; far];
    distances[LinkId::GROUND.index()] = 0;
    for round in 1..far {
        for joint in model.joint_ids() {
            let (a, b) = model.ends(joint);
            for (near, next) in [(a, b), (b, a)] {
                if distances[near.index()] + 1 == round && distances[next.index()] == far {
                    distances[next.index()] = round;
                }
            }
        }
    }
    distances
}
