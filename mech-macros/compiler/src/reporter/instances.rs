//! Diagnoses of a part: what is wrong with the same joint or link in several instances is reported once.

use crate::model::Model;
use crate::structure::Diagnosis;
use std::collections::{BTreeMap, HashMap};
use std::mem::{Discriminant, discriminant};

/// A diagnosis that stands for itself and for those of other instances.
pub(super) struct Reported<'d> {
    /// The number of the diagnosis.
    pub(super) number: usize,
    /// The part, and in how many more of its instances the same is wrong; none if in no other.
    pub(super) more: Option<(&'d str, usize)>,
}

/// The diagnoses that are reported: of each joint or link of a part the first.
pub(super) fn reported<'d>(diagnoses: &[Diagnosis], model: &'d Model) -> Vec<Reported<'d>> {
    let parts = model.instances.iter();
    let parts: BTreeMap<&str, &str> =
        parts.map(|instance| (instance.path.as_str(), instance.part.as_str())).collect();
    let mut reported: Vec<Reported<'d>> = Vec::new();
    let mut first: HashMap<(Discriminant<Diagnosis>, &str, &str), usize> = HashMap::new();
    for (number, diagnosis) in diagnoses.iter().enumerate() {
        let declared = subject(diagnosis, model).and_then(|name| declaration(name, &parts));
        if let Some((part, local)) = declared {
            let key = (discriminant(diagnosis), part, local);
            let known = *first.entry(key).or_insert(reported.len());
            if let Some(reported) = reported.get_mut(known) {
                let (_, count) = reported.more.get_or_insert((part, 0));
                *count += 1;
                continue;
            }
        }
        reported.push(Reported { number, more: None });
    }
    reported
}

/// The name of the one joint or link that a diagnosis is about.
fn subject<'m>(diagnosis: &Diagnosis, model: &'m Model) -> Option<&'m str> {
    match diagnosis {
        Diagnosis::Loose { link } | Diagnosis::OnOnePin { link, .. } => {
            Some(&model.link(*link).name)
        }
        Diagnosis::NotCarrier { joint, .. }
        | Diagnosis::NoCarrier { joint }
        | Diagnosis::SeveralCarriers { joint, .. }
        | Diagnosis::NoMesh { joint, .. } => Some(&model.joint(*joint).name),
        _ => None,
    }
}

/// The part in which something was declared, and its name there.
fn declaration<'m>(name: &'m str, parts: &BTreeMap<&str, &'m str>) -> Option<(&'m str, &'m str)> {
    let (path, local) = name.rsplit_once('.')?;
    Some((*parts.get(path)?, local))
}
