//! Four-bars on the ground, and the class of each by Grashof's condition.

use mech_compiler::model::{AxisId, JointId, JointKind, LinkId, Model};

/// Lengths whose sums differ by less, in parts of the sum, are taken for equal.
const NEAR: f64 = 1e-9;
/// So many are told.
const MOST: usize = 12;

/// A pin between two links, with the axis on each.
#[derive(Clone, Copy)]
struct Pin {
    joint: JointId,
    links: [LinkId; 2],
    axes: [AxisId; 2],
}

impl Pin {
    /// The same, seen from this link.
    fn from(self, link: LinkId) -> Option<Self> {
        let [a, b] = self.links;
        let [first, second] = self.axes;
        if a == link {
            Some(self)
        } else if b == link {
            Some(Self { links: [b, a], axes: [second, first], ..self })
        } else {
            None
        }
    }
}

/// The four-bars of which one link is the ground, each with its class in words.
pub(super) fn four_bars(model: &Model) -> impl Iterator<Item = String> {
    let pins: Vec<Pin> = model
        .declared_joints()
        .filter_map(|joint| match model.joint(joint).kind {
            JointKind::Revolute(a, b) => {
                Some(Pin { joint, links: [a, b].map(|axis| model.axis(axis).link), axes: [a, b] })
            }
            _ => None,
        })
        .collect();
    let from = |link: LinkId| pins.iter().filter_map(move |pin| pin.from(link));
    let mut found = Vec::new();
    for first in from(LinkId::GROUND) {
        for last in from(LinkId::GROUND).filter(|last| last.joint > first.joint) {
            let [crank, rocker] = [first.links[1], last.links[1]];
            for second in from(crank).filter(|pin| pin.joint != first.joint) {
                for third in from(rocker).filter(|pin| pin.joint != last.joint) {
                    let is_coupler = second.links[1] == third.links[1]
                        && ![LinkId::GROUND, crank, rocker].contains(&second.links[1]);
                    if is_coupler && crank != rocker {
                        found.extend(described(model, [first, second, third, last]));
                    }
                }
            }
        }
    }
    found.truncate(MOST);
    found.into_iter()
}

/// The four joints, and the class.
fn described(model: &Model, [first, second, third, last]: [Pin; 4]) -> Option<String> {
    let between = |a: AxisId, b: AxisId| {
        let [from, to] = [a, b].map(|axis| model.axis(axis).at);
        (to[0] - from[0]).hypot(to[1] - from[1])
    };
    let lengths = [
        between(first.axes[0], last.axes[0]),
        between(first.axes[1], second.axes[0]),
        between(second.axes[1], third.axes[1]),
        between(third.axes[0], last.axes[1]),
    ];
    let names = [first.joint, second.joint, third.joint, last.joint];
    let names = names.map(|joint| format!("`{}`", model.joint(joint).name));
    let links = [first.links[1], second.links[1], last.links[1]];
    let links = links.map(|link| model.link(link).name.as_str());
    Some(format!("{}: {}", names.join(", "), class(lengths, links)?))
}

/// The class of a four-bar with these lengths: of the ground, of the first link on it, of the coupler and of the second link on the ground.
fn class(lengths: [f64; 4], [first, coupler, second]: [&str; 3]) -> Option<String> {
    let mut sorted = lengths;
    sorted.sort_by(f64::total_cmp);
    let [shortest, one, other, longest] = sorted;
    if shortest <= NEAR * longest {
        return None;
    }
    // Shortest and longest less the other two.
    let excess = (shortest + longest) - (one + other);
    let sum: f64 = lengths.iter().sum();
    if excess.abs() <= NEAR * sum {
        return Some("a change-point four-bar, whose links can lie on one line".to_owned());
    }
    if excess > 0.0 {
        return Some("a triple rocker, as Grashof's condition does not hold".to_owned());
    }
    let place = lengths.iter().position(|length| *length == shortest)?;
    Some(match place {
        0 => "a double crank by Grashof's condition: the ground is the shortest link".to_owned(),
        2 => format!(
            "a double rocker by Grashof's condition: `{coupler}`, the shortest link, can turn right round"
        ),
        place => {
            let [crank, rocker] = if place == 1 { [first, second] } else { [second, first] };
            format!(
                "a crank-rocker by Grashof's condition: `{crank}` can turn right round, `{rocker}` swings"
            )
        }
    })
}
