//! Loops that wait for each other, and joints that hold a part more than once.

use super::between::{Between, Block, Sliding};
use super::step::{Connection, ConnectionKind};
use crate::model::LinkId;

/// The rings of a set of clusters that hold each other. Clusters that are in no ring are left to be solved afterwards.
pub(super) fn block(connections: &[Between], set: &[LinkId]) -> Option<Block> {
    let mut left: Vec<Between> = connections
        .iter()
        .filter(|between| set.contains(&between.a) && set.contains(&between.b))
        .copied()
        .collect();
    leave_ends(&mut left);
    let left = drop_redundant(&left);
    let first = left.iter().map(|between| between.a).min()?;
    let (tree, chords) = spanning_tree(&left, first);
    let rings: Vec<Vec<Connection>> = chords.iter().map(|chord| ring(&tree, *chord)).collect();
    let tree = match &rings[..] {
        [ring] => ring[..ring.len() - 1].to_vec(),
        _ => tree.into_iter().map(|branch| branch.connection).collect(),
    };
    Some((rings, tree))
}

/// Two clusters that two connections hold: one turning joint and any other. That is once more than it takes.
pub(super) fn redundant_block(connections: &[Between]) -> Option<Block> {
    let turns = |between: &Between| between.connection.kind == ConnectionKind::Revolute;
    let twice = |pair: &&[Between]| {
        (pair[0].a, pair[0].b) == (pair[1].a, pair[1].b) && pair.iter().any(turns)
    };
    let pair = connections.windows(2).find(twice)?;
    let ring = vec![pair[0].connection, pair[1].connection.reverse()];
    let tree = if pair[0].connection.kind == ConnectionKind::Revolute {
        ring[0]
    } else {
        pair[1].connection
    };
    Some((vec![ring], vec![tree]))
}

/// Leaves out slides that follow from others: two clusters that slide on a third in one direction also slide on each other.
pub(super) fn drop_parallel(connections: Vec<Between>) -> Vec<Between> {
    let mut sliding = Sliding::default();
    let is_new = |between: &Between| {
        let mut directions = between.direction.into_iter();
        directions.all(|direction| sliding.join(direction, between.a, between.b))
    };
    connections.into_iter().filter(is_new).collect()
}

/// Leaves out connections that follow from others: on a pin of several clusters, one connection for each further cluster is enough.
fn drop_redundant(connections: &[Between]) -> Vec<Between> {
    let mut kept: Vec<Between> = Vec::new();
    let mut on_pin: Vec<(usize, Vec<LinkId>)> = Vec::new();
    for &between in connections {
        let Some(pin) = between.pin else {
            kept.push(between);
            continue;
        };
        let index = on_pin.iter().position(|(known, _)| *known == pin).unwrap_or_else(|| {
            on_pin.push((pin, vec![between.a]));
            on_pin.len() - 1
        });
        let joined = &mut on_pin[index].1;
        match (joined.contains(&between.a), joined.contains(&between.b)) {
            (true, false) => joined.push(between.b),
            (false, true) => joined.push(between.a),
            _ => continue,
        }
        kept.push(between);
    }
    kept
}

/// Takes away, from the outside, clusters that hang on the rest by one connection or one pin: they are in no ring.
fn leave_ends(left: &mut Vec<Between>) {
    let is_end = |left: &[Between], base: LinkId| {
        let mut own = left.iter().filter(|between| between.a == base || between.b == base);
        let first = own.next();
        own.all(|other| first.is_some_and(|first| other.pin.is_some() && other.pin == first.pin))
    };
    loop {
        let ends = left.iter().flat_map(|between| [between.a, between.b]);
        let Some(end) = ends.into_iter().find(|&base| is_end(left, base)) else {
            return;
        };
        left.retain(|between| between.a != end && between.b != end);
    }
}

/// A connection by which a cluster hangs on one before it.
#[derive(Clone, Copy)]
struct Branch {
    from: LinkId,
    to: LinkId,
    connection: Connection,
}

/// A tree over all clusters, from the first, in breadth; and the connections that are not in it.
fn spanning_tree(left: &[Between], first: LinkId) -> (Vec<Branch>, Vec<Between>) {
    let mut tree: Vec<Branch> = Vec::new();
    let mut chords = left.to_vec();
    let mut queue = std::collections::VecDeque::from([first]);
    let mut reached = vec![first];
    while let Some(base) = queue.pop_front() {
        for &between in left {
            let touches = between.a == base || between.b == base;
            let to = between.beyond(base);
            if touches && !reached.contains(&to) {
                reached.push(to);
                queue.push_back(to);
                tree.push(Branch { from: base, to, connection: between.from(base) });
                chords.retain(|chord| *chord != between);
            }
        }
    }
    (tree, chords)
}

/// The ring that a connection closes: down the tree to its one end, across, and back up from its other.
fn ring(tree: &[Branch], chord: Between) -> Vec<Connection> {
    let (mut down, mut up) = (path(tree, chord.a), path(tree, chord.b));
    while let (Some(a), Some(b)) = (down.first(), up.first()) {
        if a != b {
            break;
        }
        down.remove(0);
        up.remove(0);
    }
    down.push(chord.connection);
    down.extend(up.into_iter().rev().map(Connection::reverse));
    down
}

/// The path from the root of the tree to a cluster.
fn path(tree: &[Branch], to: LinkId) -> Vec<Connection> {
    let mut path = Vec::new();
    let mut at = to;
    while let Some(branch) = tree.iter().find(|branch| branch.to == at) {
        path.insert(0, branch.connection);
        at = branch.from;
    }
    path
}
