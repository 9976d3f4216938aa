//! Motors, and how to compute.

use super::Lowering;
use super::name::Named;
use super::rolling;
use crate::model::{JointKind, Method};
use crate::syntax::ast::{self, End, Expr, Motor, Read};
use crate::syntax::{Place, spelling};
use proc_macro2::{Ident, Span};

const METHODS: [&str; 3] = ["newton", "linear", "exact"];
const PERMISSIONS: [&str; 2] = ["redundant", "coupled"];

/// More Newton steps than this are a mistake: the error is squared by each.
const MOST_STEPS: i32 = 64;

impl Lowering {
    pub(super) fn lower_motor(&mut self, motor: &Motor) {
        let joint = self.find_joint(&motor.joint);
        self.check_range(motor);
        let Some(joint) = joint else {
            return;
        };
        let name = &motor.joint;
        let place = Place::at(name.span());
        let kind = self.model.joint(joint).kind;
        if let Some(word) = rolling::word_for(kind) {
            let text = format!(
                "`{name}` is a {word}, which carries no motor; {}",
                self.motor_remedy(joint)
            );
            self.report.tell(place, text);
        } else if let JointKind::Weld(..) = kind {
            let text = format!(
                "`{name}` is a weld, which does not move; make it a `revolute`, or put the motor on another joint"
            );
            self.report.tell(place, text);
        } else if self.model.motor_of(joint).is_some() {
            let text = format!("joint `{name}` has a motor already; remove one of the two");
            self.report.tell(place, text);
        } else {
            let origin = self.places.note(place);
            self.model
                .motors
                .push(crate::model::Motor::new(joint, origin));
        }
    }

    fn check_range(&mut self, motor: &Motor) {
        if let Some((keyword, bounds)) = &motor.range {
            self.report
                .tell(Place::at(*keyword), "motor ranges are not supported yet");
            for bound in bounds {
                self.value(bound);
            }
        }
        if let Some((keyword, step)) = &motor.step {
            self.report
                .tell(Place::at(*keyword), "motor steps are not supported yet");
            self.value(step);
        }
    }

    pub(super) fn lower_method(&mut self, method: &ast::Method) {
        self.single(method.keyword, "method", "remove one of the two");
        let place = Place::at(method.word.span());
        let text = method.word.to_string();
        match text.as_str() {
            "newton" => self.newton(method.steps.as_ref()),
            "linear" | "exact" => self
                .report
                .tell(place, format!("method `{text}` is not supported yet")),
            _ => {
                let remedy = spelling::remedy(&text, &METHODS);
                self.report
                    .tell(place, format!("unknown method `{text}`{remedy}"));
            }
        }
    }

    fn newton(&mut self, steps: Option<&Expr>) {
        let method = match steps {
            None => Some(Method::Newton),
            Some(steps) => {
                let steps = self.whole(steps, "the number of newton steps", [1, MOST_STEPS]);
                steps
                    .and_then(|steps| u32::try_from(steps).ok())
                    .map(Method::NewtonSteps)
            }
        };
        self.model.method = method.or(self.model.method);
    }

    pub(super) fn lower_accuracy(&mut self, keyword: Span, value: &Expr) {
        self.report.tell(
            Place::at(keyword),
            "`accuracy` is not supported yet; use `method newton(2)`",
        );
        self.value(value);
    }

    pub(super) fn lower_effects(&mut self, keyword: Span, effects: &[Read<Ident>]) {
        self.single(keyword, "effects", "put everything into the first");
        for effect in effects {
            self.report.next_item();
            match effect {
                Ok(effect) => {
                    let text = format!("effect `{effect}` is not supported yet");
                    self.report.tell(Place::at(effect.span()), text);
                }
                Err(error) => self.report.pass_on(error.clone()),
            }
        }
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
