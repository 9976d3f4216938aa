//! Which links of a document are one link of the drawing.

use super::document::{Document, Fastening};
use crate::import::drawing::{End, Omission};
use std::collections::BTreeSet;

/// The number of the ground among links, before the first of them.
const GROUND: usize = 0;

/// Unions: links of a document that are one link of the drawing.
pub(super) struct Unions {
    /// The member for each link; none for pictures, and for links that carry nothing.
    ends: Vec<Option<Member>>,
    pub(super) links: Vec<Vec<usize>>,
    /// The connectors of each link, with those that are fastened to it.
    pub(super) connectors: Vec<Vec<usize>>,
}

/// A link of the document as a member of the drawing.
#[derive(Clone, Copy)]
pub(super) enum Member {
    /// A rigid link, or the ground.
    Rigid(End),
    /// A cylinder: two links of the drawing, at its first connector and at its second.
    Cylinder([usize; 2]),
}

impl Unions {
    /// The unions of a document, in the order of their first links. Cylinders have two, one after the other.
    pub(super) fn of(document: &Document, omissions: &mut Vec<Omission>) -> Self {
        let connectors = carried(document, omissions);
        let groups = grouped(document, &connectors, omissions);
        let mut unions =
            Self { ends: vec![None; document.links.len()], links: Vec::new(), connectors };
        let mut numbers: Vec<Option<usize>> = vec![None; document.links.len() + 1];
        for (number, link) in document.links.iter().enumerate() {
            if !link.is_of_mechanism {
                continue;
            }
            let root = groups.root(number + 1);
            let member = if root == groups.root(GROUND) {
                Member::Rigid(End::Ground)
            } else if link.cylinder.is_some() {
                let first = unions.add(number);
                Member::Cylinder([first, unions.add(number)])
            } else if let Some(union) = numbers[root] {
                unions.links[union].push(number);
                Member::Rigid(End::Link(union))
            } else if unions.carries_something(document, &groups, root) {
                let union = unions.add(number);
                numbers[root] = Some(union);
                Member::Rigid(End::Link(union))
            } else {
                let what = "it has one connector and is no wheel, so it carries nothing";
                omissions.push(Omission::new(format!("link {}", link.id), what));
                continue;
            };
            unions.ends[number] = Some(member);
        }
        unions
    }

    fn add(&mut self, link: usize) -> usize {
        self.links.push(vec![link]);
        self.links.len() - 1
    }

    /// Whether a group of links has two connectors or a wheel.
    fn carries_something(&self, document: &Document, groups: &Groups, root: usize) -> bool {
        let all = document.links.iter().enumerate();
        let links = all.filter(|(number, _)| groups.root(number + 1) == root);
        let mut connectors: BTreeSet<usize> = BTreeSet::new();
        for (number, link) in links {
            if link.is_wheel {
                return true;
            }
            connectors.extend(&self.connectors[number]);
        }
        connectors.len() > 1
    }

    pub(super) fn member(&self, link: usize) -> Option<Member> {
        self.ends[link]
    }

    /// Returns the union of a rigid link, or the ground; none for cylinders.
    pub(super) fn rigid(&self, link: usize) -> Option<End> {
        match self.ends[link] {
            Some(Member::Rigid(end)) => Some(end),
            Some(Member::Cylinder(_)) | None => None,
        }
    }

    /// Lists the ends that carry a connector: the ground first, then unions in their order, each once.
    pub(super) fn at(&self, document: &Document, connector: usize) -> Vec<End> {
        let mut ends = BTreeSet::new();
        if document.connectors[connector].is_anchor {
            ends.insert(End::Ground);
        }
        for (link, connectors) in self.connectors.iter().enumerate() {
            if !connectors.contains(&connector) {
                continue;
            }
            match self.ends[link] {
                Some(Member::Rigid(end)) => {
                    ends.insert(end);
                }
                Some(Member::Cylinder(halves)) => {
                    let own = document.links[link].cylinder.map(|cylinder| cylinder.ends);
                    let own = own.into_iter().flatten().zip(halves);
                    let found = own.filter(|(end, _)| *end == connector);
                    ends.extend(found.map(|(_, union)| End::Link(union)));
                }
                None => {}
            }
        }
        ends.into_iter().collect()
    }
}

/// The connectors of each link, with those that are fastened to it.
fn carried(document: &Document, omissions: &mut Vec<Omission>) -> Vec<Vec<usize>> {
    let own = document.links.iter().map(|link| {
        let fastened = link.fastened_connectors.iter();
        let mut all = link.connectors.clone();
        all.extend(fastened.filter(|one| {
            let is_of_mechanism = document.connectors[**one].is_of_mechanism;
            is_of_mechanism && !link.connectors.contains(one)
        }));
        all
    });
    let mut all: Vec<Vec<usize>> = own.collect();
    for (number, connector) in document.connectors.iter().enumerate() {
        let link = match connector.fastened {
            Some(Fastening::Link(link)) if connector.is_of_mechanism => Some(link),
            Some(Fastening::Connector(other)) if connector.is_of_mechanism => {
                only_link(document, other)
            }
            // Nothing, or a picture.
            Some(_) | None => continue,
        };
        match link {
            Some(link) if document.links[link].cylinder.is_none() => {
                if !all[link].contains(&number) {
                    all[link].push(number);
                }
            }
            _ => {
                let what = "what it is fastened to is no single rigid link";
                omissions.push(Omission::new(format!("connector {}", connector.id), what));
            }
        }
    }
    all
}

/// The link of the mechanism that has a connector, if it is the only one.
fn only_link(document: &Document, connector: usize) -> Option<usize> {
    let links = document.links.iter().enumerate();
    let mut links = links.filter(|(_, link)| {
        link.is_of_mechanism && !link.is_wheel && link.connectors.contains(&connector)
    });
    let (only, _) = links.next()?;
    links.next().is_none().then_some(only)
}

/// Links that are one with each other or with the ground.
struct Groups(Vec<usize>);

impl Groups {
    fn root(&self, mut one: usize) -> usize {
        while self.0[one] != one {
            one = self.0[one];
        }
        one
    }

    /// Makes two groups one. Its root is the earlier.
    fn join(&mut self, a: usize, b: usize) {
        let [a, b] = [self.root(a), self.root(b)];
        self.0[a.max(b)] = a.min(b);
    }
}

fn grouped(
    document: &Document,
    connectors: &[Vec<usize>],
    omissions: &mut Vec<Omission>,
) -> Groups {
    let mut groups = Groups((0..=document.links.len()).collect());
    for (number, link) in document.links.iter().enumerate() {
        if !link.is_of_mechanism {
            continue;
        }
        let is_anchor = |connector: &&usize| document.connectors[**connector].is_anchor;
        let anchors = connectors[number].iter().filter(is_anchor).count();
        if anchors > 1 && link.cylinder.is_none() {
            groups.join(GROUND, number + 1);
        }
        let other = match link.fastened {
            None => continue,
            Some(Fastening::Link(other)) => Some(other + 1),
            Some(Fastening::Connector(connector)) => {
                let pin = &document.connectors[connector];
                let is_fixed = pin.is_anchor && !pin.is_input;
                let link = only_link(document, connector).map(|link| link + 1);
                if is_fixed { Some(GROUND) } else { link }
            }
        };
        let is_rigid = |one: usize| one == GROUND || document.links[one - 1].cylinder.is_none();
        match other {
            Some(other) if link.cylinder.is_none() && is_rigid(other) => {
                groups.join(other, number + 1);
            }
            _ => {
                let what = "what it is fastened to is no single rigid link";
                omissions.push(Omission::new(format!("link {}", link.id), what));
            }
        }
    }
    groups
}
