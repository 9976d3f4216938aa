//! From the tree of the text to the model: names get their meaning, numbers their value.

mod action;
mod angle;
mod cam;
mod constant;
mod continuous;
mod drawn;
mod effect;
mod figure;
mod joint;
mod law;
mod link;
mod method;
mod motor;
mod name;
mod param;
mod part;
mod path;
mod port;
mod quality;
mod report;
mod rolling;
mod scope;
mod setting;
mod show;
mod similarity;
mod start;
mod trace;
mod value;
mod weld;

use self::action::ActionPlaces;
use self::constant::Constants;
use self::figure::Unsized;
use self::motor::WrittenRange;
use self::name::{Names, Referent};
use self::param::Quantity;
use self::part::Located;
use self::port::{LentLink, PartOutline};
use self::report::Report;
use self::scope::Scopes;
use self::similarity::Similarity;
use super::ast::{Statement, Text};
use super::{Message, Place, Places};
use crate::model::{AxisId, Formulas, JointId, LinkId, Model, Origin};
use proc_macro2::{Ident, Span};
use std::collections::BTreeMap;

/// What a text means, as far as it could be understood.
pub(super) struct Lowered {
    pub(super) model: Model,
    /// Where everything in the model was declared.
    pub(super) places: Places,
    /// Everything that is wrong with the text, in the order of the text.
    pub(super) errors: Vec<Message>,
}

/// Makes the model of a text.
pub(super) fn lower(text: &mut Text) -> Lowered {
    path::find_uses(text);
    let mut lowering = Lowering::new(text);
    let statements = lowering.expand(text);
    lowering.pass(&statements, Lowering::lend);
    lowering.pass(&statements, Lowering::join);
    lowering.pass(&statements, Lowering::join_joints);
    lowering.pass(&statements, Lowering::set);
    lowering.pass(&statements, Lowering::begin);
    lowering.pass(&statements, Lowering::carry);
    lowering.scopes.enter(0);
    lowering.start_by_laws();
    lowering.check_unlisted();
    lowering.check_effects();
    lowering.check_gears();
    lowering.check_actions();
    lowering.claim_rate_methods();
    lowering.claim_force_methods();
    lowering.claim_time_method();
    lowering.claim_trace_methods();
    Lowered {
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
    /// What is local to the mechanism, and to each instance of a part.
    scopes: Scopes,
    /// What the numbers of the link, joint or start that is read undergo.
    similarity: Similarity,
    parts: Vec<PartOutline>,
    /// The links that are lent to parts.
    ports: Vec<LentLink>,
    /// The axes that the drawing has put on links.
    drawn: BTreeMap<LinkId, Vec<AxisId>>,
    /// The scope of each link, except of the dies of slots.
    link_scopes: Vec<usize>,
    /// Which instances `[*]` stands for, from the outermost inwards.
    every: Vec<usize>,
    /// What the law that is being read is made from.
    law: Option<Formulas>,
    /// By what the variable of that law is divided, where a part is scaled or mirrored.
    law_input: Quantity,
    /// Why the numbers that are being read may not depend on params, if there is a reason of their own.
    why_fixed: Option<&'static str>,
    names: Names,
    /// The statements whose joint cannot have its name, and is left out: scopes, and numbers there.
    nameless: Vec<(usize, usize)>,
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
    /// The gears whose radii follow from what they mesh with.
    unsized_gears: Vec<Unsized>,
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
        names.enter("ground".to_owned(), Referent::Link(LinkId::GROUND.into()));
        let constants = Constants::of(&text.statements);
        Self {
            model,
            places,
            report: Report::default(),
            scopes: Scopes::new(constants),
            similarity: Similarity::IDENTITY,
            parts: Vec::new(),
            ports: Vec::new(),
            drawn: BTreeMap::new(),
            link_scopes: vec![0],
            every: Vec::new(),
            law: None,
            law_input: Quantity::fixed(1.0),
            why_fixed: None,
            names,
            nameless: Vec::new(),
            ranges: Vec::new(),
            acting: ActionPlaces::default(),
            cams: Vec::new(),
            lawful: Vec::new(),
            has_params: false,
            unsized_gears: Vec::new(),
        }
    }

    /// Goes once through the text, and through each part as often as there are instances.
    fn pass(&mut self, statements: &[Located], visit: fn(&mut Self, &Statement)) {
        for located in statements {
            self.enter(located.scope, located.place);
            visit(self, located.statement);
        }
    }

    /// The numbers of the mechanism or the instance that is read.
    fn constants(&self) -> &Constants {
        &self.scopes.here().constants
    }

    /// The scope and the number of the statement that is read.
    fn statement(&self) -> (usize, usize) {
        (self.scopes.current(), self.report.statement())
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
                let is_declared = self.scopes.here_mut().constants.declare(
                    &constant.name,
                    value,
                    "constant",
                    &mut self.report,
                );
                if let (true, Ok(expr)) = (is_declared, &constant.value) {
                    let integer = self.integer(expr);
                    let constants = &mut self.scopes.here_mut().constants;
                    constants.set_integer(&constant.name, integer);
                }
            }
            Statement::Param(param) => self.declare_param(param),
            Statement::Ground(ground) => self.declare_ground(ground),
            Statement::Link(link) => self.declare_link(link),
            Statement::Joint(joint) => self.declare_joint(joint),
            Statement::Broken(broken) => {
                self.report.pass_on(broken.error.clone());
                if let Some(name) = &broken.name {
                    self.names.enter(self.key_of(name), Referent::Broken);
                }
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
            Statement::Look { keyword, word } => self.lower_look(*keyword, word),
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
        let (what, singles) = match &self.scopes.here().part {
            None => ("mechanism", &self.scopes.here().singles),
            Some(_) => ("part", &self.scopes.here().singles),
        };
        if singles.contains(&word) {
            self.report.error(
                Place::at(keyword),
                format!("a {what} has one `{word}`; {remedy}"),
            );
        } else {
            self.scopes.here_mut().singles.push(word);
        }
    }

    fn note(&mut self, name: &Ident) -> Origin {
        note(&mut self.places, name)
    }
}

fn note(places: &mut Places, name: &Ident) -> Origin {
    places.note(Place::at(name.span()))
}
