//! Ports: the links that are lent to the instances of parts, and where what a part fixes to them comes to lie.

use super::draft::Draft;
use super::expansion::{Expansion, parts};
use super::name::{Body, LentLink, Referent};
use super::reader::{Located, Reader};
use super::report::Report;
use super::similarity::Similarity;
use super::unknown::Unknown;
use super::{find, link};
use crate::model::LinkId;
use crate::syntax::ast::{Part, PortBinding, Statement, Use};
use crate::syntax::{Noun, Place, spelling};
use proc_macro2::Ident;

impl Expansion<'_> {
    /// Lends links to the ports of a use, or brings to its place what a part fixes to a link.
    pub(super) fn lend(&mut self, located: &Located) {
        self.enter(located);
        let (mut reader, draft) = self.read(located.scope);
        let (name, items, is_port) = match located.statement {
            Statement::Use(used) => return self.lend_links(used, located.scope),
            Statement::Port(port) => (&port.name, &port.items, true),
            Statement::Link(link) if reader.here().part.is_some() => {
                (&link.name, &link.items, false)
            }
            _ => return,
        };
        if let Some(Referent::Link(body)) = reader.names.get(&reader.key_of(name))
            && body.port.is_some() == is_port
        {
            if is_port {
                reader.frame = reader.names.frame_of(body);
            }
            link::fix(&mut reader, draft, body, items);
        }
    }

    /// Lends links to the ports of all instances of a use.
    fn lend_links(&mut self, used: &Use, scope: usize) {
        let known = self.names.scope(scope).used(&used.name).cloned();
        let part = parts(self.text).find(|(_, part)| part.name == used.part);
        let (Some(known), Some((_, part))) = (known, part) else {
            return;
        };
        let ports: Vec<String> = part.ports().map(|port| port.name.to_string()).collect();
        check_ports(used, part, &ports, &mut self.report);
        let drawn_joint = drawn_joint(part);
        for (number, &instance) in known.instances.iter().enumerate() {
            let said = self.report.len();
            let mut places: Vec<Similarity> = Vec::new();
            for port in &ports {
                let path = format!("{}{port}", self.names.scope(instance).prefix);
                let binding = used.ports.iter().find(|binding| binding.port == port);
                let (mut reader, draft) = self.read(scope);
                reader.passing.instance = known.is_array.then_some(number);
                let lent =
                    binding.and_then(|binding| lent_link(&mut reader, draft, binding, &known.own));
                let Some((id, similarity)) = lent else {
                    self.names.enter(path, Referent::Broken);
                    continue;
                };
                let port = Some(self.names.ports.len());
                let body = Body { id, port };
                self.names.enter(path.clone(), Referent::Link(body));
                self.names.ports.push(LentLink { path, similarity });
                places.push(similarity);
            }
            let here = self.names.scopes.get_mut(instance);
            here.place(places.first(), drawn_joint.is_some());
            if let (Some(joint), [first, others @ ..]) = (drawn_joint, &places[..])
                && others.iter().any(|other| other != first)
            {
                let text = format!(
                    "part `{}` has joints in a drawing, like `{joint}`, so all its ports are lent at one place; give each the same `at` and `turned`",
                    part.name
                );
                self.report.error(Place::at(used.part.span()), text);
            }
            // Errors in the first instance are in all.
            if self.report.len() > said {
                return self.lose_ports(&known.instances, &ports);
            }
        }
    }

    /// Lets nobody be blamed for ports that have no link because of an error.
    fn lose_ports(&mut self, instances: &[usize], ports: &[String]) {
        for &instance in instances {
            for port in ports {
                let path = format!("{}{port}", self.names.scope(instance).prefix);
                self.names.enter(path, Referent::Broken);
            }
        }
    }
}

/// The first joint of a part that is placed in a drawing.
fn drawn_joint(part: &Part) -> Option<&Ident> {
    let mut body = part.body.iter().flatten();
    body.find_map(|statement| match statement {
        Statement::Joint(joint) => {
            let is_drawn = joint.body.as_ref().is_ok_and(|body| body.at.is_some());
            is_drawn.then_some(&joint.name)
        }
        _ => None,
    })
}

/// Complains about ports that are not lent, lent twice, or not there.
fn check_ports(used: &Use, part: &Part, ports: &[String], report: &mut Report) {
    let ports: Vec<&str> = ports.iter().map(String::as_str).collect();
    let is_unknown = |port: &Ident| ports.iter().all(|known| port != known);
    let lent = used.ports.iter().map(|binding| &binding.port);
    let unknown: Vec<&Ident> = lent.clone().filter(|port| is_unknown(port)).collect();
    // A link under an unknown name is meant for the port that looks like it, or else for any.
    let looks = unknown.iter().map(ToString::to_string);
    let meant = looks.filter_map(|port| spelling::nearest(&port, &ports));
    let meant: Vec<&str> = meant.collect();
    let is_lent = |port: &str| lent.clone().any(|lent| lent == port) || meant.contains(&port);
    let missing = ports.iter().copied().filter(|port| !is_lent(port));
    let missing: Vec<&str> = missing.collect();
    if let Some(first) = missing.first()
        && missing.len() > unknown.len() - meant.len()
    {
        let text = format!(
            "part `{}` needs a link for {}; write `{first} = ...` with the name of a link in the braces",
            part.name,
            spelling::list(&missing)
        );
        report.error(Place::at(used.part.span()), text);
    }
    for (number, port) in lent.clone().enumerate() {
        let place = Place::at(port.span());
        if is_unknown(port) && !part.seems_to_declare(port) {
            let remedy = spelling::remedy(&port.to_string(), &ports);
            let part = part.name.to_string();
            let text = format!("part `{part}` has no port `{port}`{remedy}");
            let name = Unknown::new(Noun::Body, Some(part), port);
            report.refuse_unknown::<()>(name, place, text);
        } else if lent.clone().take(number).any(|earlier| earlier == port) {
            let text = format!("port `{port}` is lent twice; remove one of the two");
            report.error(place, text);
        }
    }
}

/// The link that is lent, and what the numbers that the part fixes to it undergo.
fn lent_link(
    reader: &mut Reader,
    draft: &Draft,
    binding: &PortBinding,
    own: &Similarity,
) -> Option<(LinkId, Similarity)> {
    let place = binding.link.place();
    let body = find::body(reader, draft, &binding.link);
    let mut placement = Similarity::IDENTITY;
    if let Some(at) = &binding.at {
        placement.offset = reader.spot(at)?;
    }
    if let Some(turned) = &binding.turned {
        placement.turn = reader.direction_at_angle(turned)?;
    }
    let body = body?;
    let outer = reader.names.frame_of(body);
    let inner = reader.compose(&placement, own, place)?;
    let all = reader.compose(&outer, &inner, place)?;
    Some((body.id, all))
}
