//! From the tree of the text to the model: names get their meaning, numbers their value.

mod action;
mod angle;
mod cam;
mod constant;
mod continuous;
mod drawn;
mod effect;
mod joint;
mod law;
mod link;
mod method;
mod motor;
mod name;
mod param;
mod quality;
mod report;
mod rolling;
mod setting;
mod show;
mod start;
mod trace;
mod value;
mod weld;

use self::action::ActionPlaces;
use self::constant::Constants;
use self::motor::WrittenRange;
use self::name::{Names, Referent};
use self::report::Report;
use super::ast::{Statement, Text};
use super::{Parsed, Place, Places};
use crate::model::{Formulas, JointId, LinkId, Model, Origin};
use proc_macro2::{Ident, Span};

/// Makes the model of a text.
pub(super) fn lower(text: Text) -> Parsed {
    let mut lowering = Lowering::new(&text);
    lowering.pass(&text.statements, Lowering::declare);
    lowering.pass(&text.statements, Lowering::join);
    lowering.pass(&text.statements, Lowering::join_joints);
    lowering.pass(&text.statements, Lowering::set);
    lowering.pass(&text.statements, Lowering::begin);
    lowering.pass(&text.statements, Lowering::carry);
    lowering.start_by_laws();
    lowering.check_unlisted();
    lowering.check_effects();
    lowering.check_actions();
    lowering.claim_rate_methods();
    lowering.claim_force_methods();
    lowering.claim_time_method();
    lowering.claim_trace_methods();
    Parsed {
        motors: text.motors,
        has_laws: text.has_laws,
        header: text.header.map(|(header, _)| header),
        model: lowering.model,
        places: lowering.places,
        errors: lowering.report.finish(),
    }
}

/// The model in the making.
struct Lowering {
    model: Model,
    places: Places,
    report: Report,
    constants: Constants,
    /// What the law that is being read is made from.
    law: Option<Formulas>,
    /// Why the numbers that are being read may not depend on params, if there is a reason of their own.
    why_fixed: Option<&'static str>,
    names: Names,
    /// The numbers of statements whose joint cannot have its name, and is left out.
    nameless: Vec<usize>,
    /// The statements that there may be only one of, as far as they have come.
    singles: Vec<&'static str>,
    /// The ranges of the motors that have one.
    ranges: Vec<WrittenRange>,
    /// Where gravity and the effects of forces stand.
    acting: ActionPlaces,
    /// The names of the cams.
    cams: Vec<String>,
    /// The joints whose motors follow laws, and the numbers of these motors' statements.
    lawful: Vec<(JointId, usize)>,
    /// Whether the text declares params, readable or not.
    has_params: bool,
}

impl Lowering {
    fn new(text: &Text) -> Self {
        let mut places = Places::default();
        let mut model = match &text.header {
            Some((header, _)) => {
                Model::new(&header.name.to_string(), note(&mut places, &header.name))
            }
            None => Model::new("Mechanism", Origin::default()),
        };
        if let Some((_, precision)) = &text.header {
            model.precision = *precision;
        }
        let mut names = Names::default();
        names.enter(
            &Ident::new("ground", Span::call_site()),
            Referent::Link(LinkId::GROUND),
        );
        let constants = Constants::of(&text.statements);
        Self {
            model,
            places,
            report: Report::default(),
            constants,
            law: None,
            why_fixed: None,
            names,
            nameless: Vec::new(),
            singles: Vec::new(),
            ranges: Vec::new(),
            acting: ActionPlaces::default(),
            cams: Vec::new(),
            lawful: Vec::new(),
            has_params: false,
        }
    }

    /// Goes through the text once.
    fn pass(&mut self, statements: &[Statement], visit: fn(&mut Self, &Statement)) {
        for (number, statement) in (1..).zip(statements) {
            self.report.enter(number);
            visit(self, statement);
        }
    }

    /// First: everything that has a name.
    fn declare(&mut self, statement: &Statement) {
        match statement {
            Statement::Constant(constant) => {
                let value = match &constant.value {
                    Ok(expr) => self.quantity(expr),
                    Err(error) => {
                        self.report.pass_on(error.clone());
                        None
                    }
                };
                let is_declared =
                    self.constants
                        .declare(&constant.name, value, "constant", &mut self.report);
                if let (true, Ok(expr)) = (is_declared, &constant.value) {
                    let integer = self.integer(expr);
                    self.constants.set_integer(&constant.name, integer);
                }
            }
            Statement::Param(param) => self.declare_param(param),
            Statement::Ground(ground) => self.declare_ground(ground),
            Statement::Link(link) => self.declare_link(link),
            Statement::Joint(joint) => self.declare_joint(joint),
            Statement::Broken(broken) => {
                self.report.pass_on(broken.error.clone());
                broken
                    .name
                    .iter()
                    .for_each(|name| self.names.enter(name, Referent::Broken));
            }
            _ => {}
        }
    }

    /// Second: joints, which may refer to links declared after them.
    fn join(&mut self, statement: &Statement) {
        if let Statement::Joint(joint) = statement {
            self.lower_joint(joint);
        }
    }

    /// Third: cams, which join joints.
    fn join_joints(&mut self, statement: &Statement) {
        if let Statement::Joint(joint) = statement {
            self.lower_cam(joint);
        }
    }

    /// Fourth: what refers to joints.
    fn set(&mut self, statement: &Statement) {
        match statement {
            Statement::Motor(motor) => self.lower_motor(motor),
            Statement::Method(method) => self.lower_method(method),
            Statement::Accuracy { keyword, value } => self.lower_accuracy(*keyword, value),
            Statement::Cost { keyword, word } => self.lower_cost(*keyword, word),
            Statement::Quality { keyword, word } => self.lower_quality(*keyword, word),
            Statement::ChangePoints { keyword, what } => self.lower_change_points(*keyword, *what),
            Statement::Effects { keyword, effects } => self.lower_effects(*keyword, effects),
            Statement::Allow(word) => self.lower_allow(word),
            Statement::Gravity { keyword, value } => self.lower_gravity(*keyword, value),
            Statement::Spring(spring) => self.lower_spring(spring),
            Statement::Damper(damper) => self.lower_damper(damper),
            Statement::Load(load) => self.lower_load(load),
            _ => {}
        }
    }

    /// Fifth: where it starts, which must be within the ranges of the motors; and what is shown, which they may give.
    fn begin(&mut self, statement: &Statement) {
        match statement {
            Statement::Start(start) => self.lower_start(start),
            Statement::Show { keyword, what } => self.lower_show(*keyword, what),
            _ => {}
        }
    }

    /// Sixth: what of it goes on over whole turns, where it is shown.
    fn carry(&mut self, statement: &Statement) {
        if let Statement::Continuous { keyword, joints } = statement {
            self.lower_continuous(*keyword, joints);
        }
    }

    /// Complains about a statement of which there is one already.
    fn single(&mut self, keyword: Span, word: &'static str, remedy: &str) {
        if self.singles.contains(&word) {
            self.report.error(
                Place::at(keyword),
                format!("a mechanism has one `{word}`; {remedy}"),
            );
        } else {
            self.singles.push(word);
        }
    }

    fn note(&mut self, name: &Ident) -> Origin {
        note(&mut self.places, name)
    }
}

fn note(places: &mut Places, name: &Ident) -> Origin {
    places.note(Place::at(name.span()))
}
