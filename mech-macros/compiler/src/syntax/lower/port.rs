//! Ports: the links that are lent to the instances of parts, and where what a part fixes to them comes to lie.

use super::draft::Draft;
use super::name::{Body, LentLink, Names, Referent};
use super::part::parts;
use super::reader::{Located, Reader};
use super::report::Report;
use super::similarity::Similarity;
use super::{find, link};
use crate::model::{LinkId, Params};
use crate::syntax::ast::{Part, PortBinding, Statement, Text, Use};
use crate::syntax::{Place, spelling};
use proc_macro2::Ident;

/// Lends a link to a port, or brings to its place what a part fixes to a link.
pub(super) fn lend(
    text: &Text,
    located: &Located,
    names: &mut Names,
    draft: &mut Draft,
    params: &mut Params,
    report: &mut Report,
) {
    let scope = located.scope;
    let mut reader = Reader::of(located, names, params, report);
    let (name, items) = match located.statement {
        Statement::Use(used) => {
            return lend_links(text, used, scope, names, draft, params, report);
        }
        Statement::Port(port) => (&port.name, &port.items),
        Statement::Link(link) if reader.here().part.is_some() => (&link.name, &link.items),
        _ => return,
    };
    let Some(Referent::Link(body)) = names.get(&reader.key_of(name)) else {
        return;
    };
    let is_port = matches!(located.statement, Statement::Port(_));
    if is_port != body.port.is_some() {
        return;
    }
    if let Some(port) = body.port {
        reader.frame = names.ports[port].similarity;
    }
    link::fix(&mut reader, draft, body, items);
}

/// Lends links to the ports of all instances of a use.
fn lend_links(
    text: &Text,
    used: &Use,
    scope: usize,
    names: &mut Names,
    draft: &Draft,
    params: &mut Params,
    report: &mut Report,
) {
    let Some(known) = names.scope(scope).used(&used.name).cloned() else {
        return;
    };
    let Some((_, part)) = parts(text).find(|(_, part)| part.name == used.part) else {
        return;
    };
    let ports: Vec<String> = part.ports().map(|port| port.name.to_string()).collect();
    check_ports(used, part, &ports, report);
    let drawn_joint = drawn_joint(part);
    for (number, &instance) in known.instances.iter().enumerate() {
        let said = report.len();
        let mut places: Vec<Similarity> = Vec::new();
        for port in &ports {
            let path = format!("{}{port}", names.scope(instance).prefix);
            let binding = used.ports.iter().find(|binding| binding.port == port);
            let mut reader = Reader::new(names, scope, params, report);
            reader.passing.instance = known.is_array.then_some(number);
            let lent =
                binding.and_then(|binding| lent_link(&mut reader, draft, binding, &known.own));
            let Some((id, similarity)) = lent else {
                names.enter(path, Referent::Broken);
                continue;
            };
            let port = Some(names.ports.len());
            names.enter(path.clone(), Referent::Link(Body { id, port }));
            names.ports.push(LentLink { path, similarity });
            places.push(similarity);
        }
        let here = names.scopes.get_mut(instance);
        here.place(places.first(), drawn_joint.is_some());
        if let (Some(joint), [first, others @ ..]) = (drawn_joint, &places[..])
            && others.iter().any(|other| other != first)
        {
            let text = format!(
                "part `{}` has joints in a drawing, like `{joint}`, so all its ports are lent at one place; give each the same `at` and `turned`",
                part.name
            );
            report.error(Place::at(used.part.span()), text);
        }
        // What is wrong with the first instance is so with all. Nobody is to be blamed for ports that have no link because of it.
        if report.len() > said {
            for &instance in &known.instances {
                for port in &ports {
                    let path = format!("{}{port}", names.scope(instance).prefix);
                    names.enter(path, Referent::Broken);
                }
            }
            break;
        }
    }
}

/// The first joint of a part that is placed in a drawing.
fn drawn_joint(part: &Part) -> Option<&Ident> {
    part.body
        .iter()
        .flatten()
        .find_map(|statement| match statement {
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
        report.error(Place::at(port.span()), text);
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
        report.error(Place::at(used.part.span()), text);
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
