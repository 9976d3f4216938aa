//! Ports: the links that are lent to the instances of parts, and where what a part fixes to them comes to lie.

use super::Lowering;
use super::name::{Body, Referent};
use super::similarity::Similarity;
use crate::model::LinkId;
use crate::syntax::ast::{Part, Port, PortBinding, Statement, Use};
use crate::syntax::{Place, spelling};

/// A link that is lent to an instance of a part.
pub(super) struct LentLink {
    /// The path of its port.
    pub(super) path: String,
    /// What the numbers that the part fixes to it undergo.
    pub(super) similarity: Similarity,
}

/// What is known of a part before its instances are.
#[derive(Clone)]
pub(super) struct PartOutline {
    name: String,
    ports: Vec<String>,
    /// The first of its joints that are placed in a drawing.
    drawn_joint: Option<String>,
}

impl PartOutline {
    pub(super) fn new(part: &Part) -> Self {
        let mut body = part.body.iter().flatten();
        let drawn_joint = body.find_map(|statement| match statement {
            Statement::Joint(joint) => {
                let is_drawn = joint.body.as_ref().is_ok_and(|body| body.at.is_some());
                is_drawn.then(|| joint.name.to_string())
            }
            _ => None,
        });
        Self {
            name: part.name.to_string(),
            ports: part.ports().map(|port| port.name.to_string()).collect(),
            drawn_joint,
        }
    }
}

impl Lowering {
    /// Second: ports get their links, and what belongs to a part comes to its place.
    pub(super) fn lend(&mut self, statement: &Statement) {
        match statement {
            Statement::Use(used) => self.lend_links(used),
            Statement::Port(Port { name, items }) => {
                let key = self.key_of(name);
                if let Some(Referent::Link(
                    body @ Body {
                        port: Some(port), ..
                    },
                )) = self.names.get(&key)
                {
                    self.similarity = self.ports[port].similarity;
                    self.lower_items(body, items);
                }
            }
            Statement::Link(link) if self.scopes.here().part.is_some() => {
                let key = self.key_of(&link.name);
                if let Some(Referent::Link(body)) = self.names.get(&key)
                    && body.port.is_none()
                {
                    self.lower_items(body, &link.items);
                }
            }
            _ => {}
        }
    }

    /// Lends links to the ports of all instances of a use.
    fn lend_links(&mut self, used: &Use) {
        let mut uses = self.scopes.here().uses.iter();
        let Some(known) = uses.find(|known| used.name == known.name).cloned() else {
            return;
        };
        let mut parts = self.parts.iter();
        let Some(part) = parts.find(|part| used.part == part.name).cloned() else {
            return;
        };
        self.check_ports(used, &part);
        let scope = self.scopes.current();
        for (number, &instance) in known.instances.iter().enumerate() {
            let number = known.is_array.then_some(number);
            self.scopes.here_mut().constants.set_instance(number);
            let said = self.report.len();
            let prefix = self.scopes.get(instance).prefix.clone();
            let mut places: Vec<Similarity> = Vec::new();
            for port in &part.ports {
                let path = format!("{prefix}{port}");
                let binding = used.ports.iter().find(|binding| binding.port == port);
                match binding.and_then(|binding| self.lent_link(binding, &known.own)) {
                    None => self.names.enter(path, Referent::Broken),
                    Some((id, similarity)) => {
                        let port = Some(self.ports.len());
                        self.ports.push(LentLink {
                            path: path.clone(),
                            similarity,
                        });
                        self.names.enter(path, Referent::Link(Body { id, port }));
                        places.push(similarity);
                    }
                }
            }
            self.scopes.enter(instance);
            self.scopes
                .here_mut()
                .place(places.first(), part.drawn_joint.is_some());
            self.scopes.enter(scope);
            if let (Some(joint), [first, others @ ..]) = (&part.drawn_joint, &places[..])
                && others.iter().any(|other| other != first)
            {
                let text = format!(
                    "part `{}` has joints in a drawing, like `{joint}`, so all its ports are lent at one place; give each the same `at` and `turned`",
                    part.name
                );
                self.report.error(Place::at(used.part.span()), text);
            }
            // What is wrong with the first instance is so with all.
            if self.report.len() > said {
                self.lose_ports(&known.instances, &part);
                break;
            }
        }
        self.scopes.here_mut().constants.set_instance(None);
    }

    /// Lets nobody be blamed for ports that have no link because of an error.
    fn lose_ports(&mut self, instances: &[usize], part: &PartOutline) {
        for &instance in instances {
            for port in &part.ports {
                let path = format!("{}{port}", self.scopes.get(instance).prefix);
                self.names.enter(path, Referent::Broken);
            }
        }
    }

    /// Complains about ports that are not lent, lent twice, or not there.
    fn check_ports(&mut self, used: &Use, part: &PartOutline) {
        let ports: Vec<&str> = part.ports.iter().map(String::as_str).collect();
        for (number, binding) in used.ports.iter().enumerate() {
            let port = &binding.port;
            let text = if !ports.iter().any(|known| port == known) {
                let remedy = spelling::remedy(&port.to_string(), &ports);
                format!("part `{}` has no port `{port}`{remedy}", part.name)
            } else if used.ports[..number]
                .iter()
                .any(|earlier| earlier.port == *port)
            {
                format!("port `{port}` is lent twice; remove one of the two")
            } else {
                continue;
            };
            self.report.error(Place::at(port.span()), text);
        }
        let is_lent = |port: &&&str| used.ports.iter().any(|binding| binding.port == **port);
        let missing: Vec<&str> = ports
            .iter()
            .filter(|port| !is_lent(port))
            .copied()
            .collect();
        if let Some(first) = missing.first() {
            let text = format!(
                "part `{}` needs a link for {}; write `{first} = ...` with the name of a link in the braces",
                part.name,
                spelling::list(&missing)
            );
            self.report.error(Place::at(used.part.span()), text);
        }
    }

    /// The link that is lent, and what the numbers that the part fixes to it undergo.
    fn lent_link(
        &mut self,
        binding: &PortBinding,
        own: &Similarity,
    ) -> Option<(LinkId, Similarity)> {
        let place = binding.link.place();
        let body = self.find_body(&binding.link);
        let mut placement = Similarity::IDENTITY;
        if let Some(at) = &binding.at {
            placement.offset = self.spot(at)?;
        }
        if let Some(turned) = &binding.turned {
            placement.turn = self.direction_at_angle(turned)?;
        }
        let body = body?;
        let outer = self.frame_of(body);
        let inner = self.compose(&placement, own, place)?;
        let all = self.compose(&outer, &inner, place)?;
        Some((body.id, all))
    }

    /// What the numbers undergo that are written in the frame of this link.
    pub(super) fn frame_of(&self, body: Body) -> Similarity {
        match body.port {
            Some(port) => self.ports[port].similarity,
            None => self
                .link_scopes
                .get(body.id.index())
                .map_or(Similarity::IDENTITY, |&scope| {
                    self.scopes.get(scope).similarity
                }),
        }
    }
}
