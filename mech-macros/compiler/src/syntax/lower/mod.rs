//! From the tree of the text to the model: names get their meaning, numbers their value.

mod action;
mod angle;
mod cam;
mod case;
mod claim;
mod constant;
mod coordinate;
mod direction;
mod draft;
mod drawn;
mod effect;
mod ends;
mod expansion;
mod figure;
mod find;
mod follow;
mod given;
mod joint;
mod kind;
mod law;
mod link;
mod mass;
mod measurand;
mod measured;
mod method;
mod motion;
mod motor;
mod name;
mod part;
mod path;
mod port;
mod quantity;
mod reader;
mod report;
mod requirement;
mod rolling;
mod scope;
mod setting;
mod show;
mod similarity;
mod single;
mod start;
mod trace;
mod unknown;
mod value;
mod vector;

pub(super) use self::measurand::lower as measurands;

use self::draft::Draft;
use self::expansion::Expansion;
use self::reader::Reader;
use super::ast::{Statement, Text};
use super::{Message, Places};
use crate::model::Model;
use proc_macro2::TokenStream;

/// The meaning of a text, as far as it could be understood.
pub(super) struct Lowered {
    pub(super) model: Model,
    /// Where everything in the model was declared.
    pub(super) places: Places,
    /// Everything that is wrong with the text, in the order of the text.
    pub(super) errors: Vec<Message>,
}

/// The passes through the statements once all joints are known.
const PASSES: [fn(&mut Reader, &mut Draft, &Statement); 4] = [set, begin, go_on, lead];

/// Makes the model of a text, of which `tokens` are all words, readable or not. Each pass goes once through the text, and through each part as often as there are instances.
pub(super) fn lower(text: &mut Text, tokens: &TokenStream) -> Lowered {
    path::find_uses(text);
    let text = &*text;
    let mut expansion = Expansion::of(text);
    let statements = expansion.declare_all();
    for located in &statements {
        expansion.lend(located);
    }
    let Expansion { mut names, mut draft, mut params, mut report, .. } = expansion;
    // Cams join joints that may be declared after them.
    for is_cam in [false, true] {
        for located in &statements {
            let mut reader = Reader::of(located, &names, &mut params, &mut report);
            if let Statement::Joint(joint) = located.statement
                && joint::is_cam(joint) == is_cam
                && let Some(id) = joint::lower(&mut reader, &mut draft, joint, located.is_named)
            {
                names.joint_is(&draft.model.joint(id).name, id);
            }
        }
    }
    for pass in PASSES {
        for located in &statements {
            let mut reader = Reader::of(located, &names, &mut params, &mut report);
            pass(&mut reader, &mut draft, located.statement);
        }
    }
    draft.model.params = params;
    draft.model.constants = names.scope(0).constants.known();
    start::start_by_laws(&mut draft, &mut report);
    follow::check(&draft, &mut report);
    motor::check_unlisted(&draft, &mut report);
    effect::check(&draft, &mut report);
    figure::check_gears(&draft, &mut report);
    action::check(&draft, &statements, &mut report);
    effect::take_rate_methods(&mut draft, &mut report);
    action::take_methods(&mut draft, &statements, &mut report);
    effect::take_time_method(&mut draft, &mut report);
    trace::take_methods(&mut draft, &mut report);
    follow::take_method(&mut draft, &mut report);
    Lowered { model: draft.model, places: draft.places, errors: report.finish(text, tokens) }
}

/// Lowers a setting, or a statement that refers to joints.
fn set(reader: &mut Reader, draft: &mut Draft, statement: &Statement) {
    match statement {
        Statement::Motor(motor) => motor::lower(reader, draft, motor),
        Statement::Method(method) => method::method(reader, draft, method),
        Statement::Accuracy { value, .. } => method::accuracy(reader, draft, value),
        Statement::Cost { word, .. } => setting::cost(word, &mut draft.model, reader.report),
        Statement::Quality { word, .. } => setting::quality(word, &mut draft.model, reader.report),
        Statement::Look { word, .. } => setting::look(word, &mut draft.model, reader.report),
        Statement::ChangePoints { what, .. } => draft.model.change_points = *what,
        Statement::Effects { effects, .. } => effect::lower(reader, draft, effects),
        Statement::Allow(word) => setting::allow(word, &mut draft.model, reader.report),
        Statement::Gravity { value, .. } => action::gravity(reader, draft, value),
        Statement::Spring(spring) => action::spring(reader, draft, spring),
        Statement::Damper(damper) => action::damper(reader, draft, damper),
        Statement::Load(load) => action::load(reader, draft, load),
        _ => {}
    }
}

/// Where it starts, which must be within the ranges of the motors; and what is shown, which they may give.
fn begin(reader: &mut Reader, draft: &mut Draft, statement: &Statement) {
    match statement {
        Statement::Start(start) => start::lower(reader, draft, start),
        Statement::Show { keyword, what } => show::lower(reader, draft, *keyword, what),
        _ => {}
    }
}

/// Lowers a list of joints that go on over whole turns, once it is known what is shown; and what is expected of all that.
fn go_on(reader: &mut Reader, draft: &mut Draft, statement: &Statement) {
    match statement {
        Statement::Continuous { joints, .. } => coordinate::lower_continuous(reader, draft, joints),
        Statement::Follow(follow) => follow::lower(reader, draft, follow),
        Statement::Expect(expect) => requirement::lower(reader, draft, expect),
        _ => {}
    }
}

/// Lowers the path of a point, once it is known that motors follow it.
fn lead(reader: &mut Reader, draft: &mut Draft, statement: &Statement) {
    if let Statement::Path(trajectory) = statement {
        follow::trajectory(reader, draft, trajectory);
    }
}
