//! What is wanted of the mechanism, and what is let pass.

use super::Lowering;
use super::name::Named;
use crate::syntax::ast::{End, Read};
use crate::syntax::{Place, spelling};
use proc_macro2::{Ident, Span};

const PERMISSIONS: [&str; 2] = ["redundant", "coupled"];
const EFFECTS: [&str; 2] = ["velocity", "acceleration"];
/// Effects that are to come.
const TO_COME: [&str; 4] = ["force", "dynamics", "trace", "sensitivity"];

impl Lowering {
    pub(super) fn lower_effects(&mut self, keyword: Span, effects: &[Read<Ident>]) {
        self.single(keyword, "effects", "put everything into the first");
        let mut listed: Vec<&Ident> = Vec::new();
        for effect in effects {
            self.report.next_item();
            match effect {
                Ok(effect) if listed.contains(&effect) => {
                    let text = format!("`{effect}` is listed already; remove one of the two");
                    self.report.tell(Place::at(effect.span()), text);
                }
                Ok(effect) => {
                    listed.push(effect);
                    self.lower_effect(effect);
                }
                Err(error) => self.report.pass_on(error.clone()),
            }
        }
    }

    fn lower_effect(&mut self, effect: &Ident) {
        let text = effect.to_string();
        let effects = &mut self.model.effects;
        let message = match text.as_str() {
            "velocity" => {
                effects.velocity = true;
                return;
            }
            // Accelerations are made from velocities.
            "acceleration" => {
                (effects.velocity, effects.acceleration) = (true, true);
                return;
            }
            word if TO_COME.contains(&word) => format!("effect `{text}` is not supported yet"),
            _ => format!(
                "unknown effect `{text}`{}",
                spelling::remedy(&text, &EFFECTS)
            ),
        };
        self.report.tell(Place::at(effect.span()), message);
    }

    pub(super) fn lower_show(&mut self, keyword: Span, what: &[End]) {
        self.report.tell(
            Place::at(keyword),
            "`show` is not supported yet; everything is shown",
        );
        for end in what {
            match (self.names.look_up(&end.link), &end.axis) {
                (Some(Named::Joint(_)), None) | (Some(Named::Broken), _) => {}
                (None, None) => self.unknown(&end.link),
                _ => self.check_end(end),
            }
        }
    }

    pub(super) fn lower_allow(&mut self, word: &Ident) {
        let text = word.to_string();
        let allow = &mut self.model.allow;
        let allowed = match text.as_str() {
            "redundant" => &mut allow.redundant,
            "coupled" => &mut allow.coupled,
            _ => {
                let remedy = spelling::remedy(&text, &PERMISSIONS);
                let text = format!("unknown permission `{text}`{remedy}");
                return self.report.tell(Place::at(word.span()), text);
            }
        };
        if std::mem::replace(allowed, true) {
            let text = format!("`{text}` is allowed already; remove one of the two");
            self.report.tell(Place::at(word.span()), text);
        }
    }
}
