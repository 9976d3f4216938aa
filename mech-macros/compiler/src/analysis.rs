//! The text of a mechanism, read and analysed: what the macro and programs that work on texts have in common.

use crate::compile::compile;
use crate::compiled::Compiled;
use crate::model::Model;
use crate::repair::{self, Offers, Repair};
use crate::reporter;
use crate::requirement;
use crate::structure::{Diagnosis, RequirementTrouble};
use crate::syntax::{self, Message, Parsed, Place};
use proc_macro2::{Span, TokenStream};

/// A text, and what was found out about it.
pub struct Analysis {
    /// The parsed text.
    pub parsed: Parsed,
    /// The compiled mechanism, or what is wrong.
    pub result: Result<Box<Compiled>, Faults>,
}

/// The faults of a mechanism, or of its text.
#[derive(Clone, Debug)]
pub struct Faults {
    /// All of it in words, at its places; never empty.
    pub messages: Vec<Message>,
    /// The diagnoses of the analysis, without words; empty if the text itself is wrong.
    pub diagnoses: Vec<Diagnosis>,
    /// The repairs that mend each of these.
    pub offers: Vec<Offers>,
}

/// Reads and analyses the text of a mechanism: the body of a `mechanism!`, whose parts are all declared in it.
#[must_use]
pub fn analyse(text: TokenStream) -> Analysis {
    let parsed = syntax::parse(text);
    let result = match faults_of_text(&parsed) {
        Some(faults) => Err(faults),
        None => compile(&parsed.model)
            .map(Box::new)
            .map_err(|diagnoses| faults_of_mechanism(&parsed, diagnoses)),
    };
    Analysis { parsed, result }
}

impl Analysis {
    /// The same with the requirements of the mechanism proved: those that are not met are faults.
    #[must_use]
    pub fn prove(self) -> Self {
        let Ok(compiled) = &self.result else {
            return self;
        };
        let unmet = requirement::unmet(&self.parsed.model, compiled);
        if unmet.is_empty() {
            return self;
        }
        let is_only = unmet.len() == 1;
        let offers = unmet.iter().map(|diagnosis| {
            let limit = nearest_limit(&self.parsed, compiled, diagnosis);
            let limit = limit.or_else(|| missing_effects(&self.parsed, diagnosis));
            let limit = limit.into_iter().collect();
            let mut offers = Offers::default();
            if is_only {
                offers.single = limit;
            } else {
                offers.partial = limit;
            }
            offers
        });
        let faults = faults(&self.parsed, offers.collect(), unmet);
        Self { result: Err(faults), ..self }
    }
}

fn faults_of_text(parsed: &Parsed) -> Option<Faults> {
    let mut messages = parsed.errors.clone();
    if parsed.header.is_none() && messages.is_empty() {
        let place = Place::at(Span::call_site());
        messages.push(Message::new(place, "this mechanism could not be read"));
    }
    (!messages.is_empty()).then(|| Faults {
        messages: Message::first(messages, 0),
        diagnoses: Vec::new(),
        offers: Vec::new(),
    })
}

fn faults_of_mechanism(parsed: &Parsed, diagnoses: Vec<Diagnosis>) -> Faults {
    let offers = repair::offers(&parsed.model, &parsed.source, &diagnoses);
    faults(parsed, offers, diagnoses)
}

fn faults(parsed: &Parsed, offers: Vec<Offers>, diagnoses: Vec<Diagnosis>) -> Faults {
    Faults {
        messages: reporter::messages(&diagnoses, &offers, &parsed.model, &parsed.places),
        diagnoses,
        offers,
    }
}

/// The nearest limit that a requirement keeps which is not met; nothing if it has none. A limit changes nothing in the compiled mechanism.
fn nearest_limit(parsed: &Parsed, compiled: &Compiled, diagnosis: &Diagnosis) -> Option<Repair> {
    let (requirement, witness) = diagnosis.witness()?;
    let (model, source) = (&parsed.model, &parsed.source);
    repair::nearest_limit(model, source, requirement, witness, |changed| {
        let requirements = changed.requirements.get(requirement).cloned();
        let alone = Model { requirements: requirements.into_iter().collect(), ..changed.clone() };
        requirement::unmet(&alone, compiled).is_empty()
    })
}

/// The effects that are not declared, and by which the mechanism computes what a requirement measures.
fn missing_effects(parsed: &Parsed, diagnosis: &Diagnosis) -> Option<Repair> {
    let Diagnosis::Unmet { trouble: RequirementTrouble::NoEffect { effects }, .. } = diagnosis
    else {
        return None;
    };
    let compiles = |changed: &Model| compile(changed).is_ok();
    repair::add_effects(&parsed.model, &parsed.source, effects, compiles)
}
