//! From the tree of the text to the model: names get their meaning, numbers their value.

mod action;
mod angle;
mod cam;
mod claim;
mod constant;
mod continuous;
mod coordinate;
mod direction;
mod draft;
mod drawn;
mod effect;
mod ends;
mod figure;
mod find;
mod given;
mod joint;
mod law;
mod link;
mod mass;
mod method;
mod motor;
mod name;
mod param;
mod part;
mod path;
mod port;
mod quality;
mod quantity;
mod reader;
mod report;
mod rolling;
mod scope;
mod setting;
mod show;
mod similarity;
mod single;
mod start;
mod trace;
mod value;
mod weld;

use self::action::ActionPlaces;
use self::constant::Constants;
use self::draft::Draft;
use self::motor::WrittenMotor;
use self::name::Names;
use self::reader::{Located, Reader};
use self::report::Report;
use self::scope::Scopes;
use super::ast::{Statement, Text};
use super::{Message, Places};
use crate::model::{Model, Params};

/// What a text means, as far as it could be understood.
pub(super) struct Lowered {
    pub(super) model: Model,
    /// Where everything in the model was declared.
    pub(super) places: Places,
    /// Everything that is wrong with the text, in the order of the text.
    pub(super) errors: Vec<Message>,
}

/// Makes the model of a text. Each pass goes once through the text, and through each part as often as there are instances.
pub(super) fn lower(text: &mut Text) -> Lowered {
    path::find_uses(text);
    let mut report = Report::default();
    let mut draft = Draft::of(text);
    let mut names = Names::new(Scopes::new(Constants::of(&text.statements)));
    let mut params = Params::default();
    let statements = part::expand(text, &mut names, &mut draft, &mut params, &mut report);
    for located in &statements {
        port::lend(
            text,
            located,
            &mut names,
            &mut draft,
            &mut params,
            &mut report,
        );
    }
    // Cams join joints that may be declared after them.
    for is_cam in [false, true] {
        for located in &statements {
            join(
                located,
                is_cam,
                &mut names,
                &mut draft,
                &mut params,
                &mut report,
            );
        }
    }
    let (mut motors, mut acting) = (Vec::new(), ActionPlaces::default());
    for located in &statements {
        let mut reader = Reader::of(located, &names, &mut params, &mut report);
        set(
            &mut reader,
            &mut draft,
            &mut motors,
            &mut acting,
            located.statement,
        );
    }
    for located in &statements {
        let mut reader = Reader::of(located, &names, &mut params, &mut report);
        begin(&mut reader, &mut draft, &motors, located.statement);
    }
    for located in &statements {
        let mut reader = Reader::of(located, &names, &mut params, &mut report);
        if let Statement::Continuous { joints, .. } = located.statement {
            continuous::lower(&mut reader, &mut draft, joints);
        }
    }
    draft.model.params = params;
    start::start_by_laws(&mut draft, &motors, &mut report);
    motor::check_unlisted(&draft, &motors, &mut report);
    action::check_effects(&draft, &acting, &mut report);
    figure::check_gears(&draft, &mut report);
    action::check_actions(&draft, &acting, &mut report);
    effect::take_rate_methods(&mut draft, &mut report);
    action::take_methods(&mut draft, &acting, &mut report);
    effect::take_time_method(&mut draft, &mut report);
    trace::take_methods(&mut draft, &mut report);
    Lowered {
        model: draft.model,
        places: draft.places,
        errors: report.finish(),
    }
}

/// Enters a joint, which may refer to links declared after it.
fn join(
    located: &Located,
    is_cam: bool,
    names: &mut Names,
    draft: &mut Draft,
    params: &mut Params,
    report: &mut Report,
) {
    let mut reader = Reader::of(located, names, params, report);
    if let Statement::Joint(joint) = located.statement
        && joint::is_cam(joint) == is_cam
        && let Some(id) = joint::lower(&mut reader, draft, joint, located.is_named)
    {
        let key = reader.key_of(&joint.name);
        names.joint_is(&key, id);
    }
}

/// What refers to joints.
fn set(
    reader: &mut Reader,
    draft: &mut Draft,
    motors: &mut Vec<WrittenMotor>,
    acting: &mut ActionPlaces,
    statement: &Statement,
) {
    match statement {
        Statement::Motor(motor) => motor::lower(reader, draft, motors, motor),
        Statement::Method(method) => method::method(reader, draft, method),
        Statement::Accuracy { value, .. } => method::accuracy(reader, draft, value),
        Statement::Cost { word, .. } => method::cost(reader, draft, word),
        Statement::Quality { word, .. } => quality::quality(reader, draft, word),
        Statement::Look { word, .. } => quality::look(reader, draft, word),
        Statement::ChangePoints { what, .. } => draft.model.change_points = *what,
        Statement::Effects { effects, .. } => effect::lower(reader, draft, acting, effects),
        Statement::Allow(word) => setting::allow(reader, draft, word),
        Statement::Gravity { keyword, value } => {
            action::gravity(reader, draft, acting, *keyword, value);
        }
        Statement::Spring(spring) => action::spring(reader, draft, spring),
        Statement::Damper(damper) => action::damper(reader, draft, damper),
        Statement::Load(load) => action::load(reader, draft, load),
        _ => {}
    }
}

/// Where it starts, which must be within the ranges of the motors; and what is shown, which they may give.
fn begin(reader: &mut Reader, draft: &mut Draft, motors: &[WrittenMotor], statement: &Statement) {
    match statement {
        Statement::Start(start) => start::lower(reader, draft, motors, start),
        Statement::Show { keyword, what } => show::lower(reader, draft, *keyword, what),
        _ => {}
    }
}
