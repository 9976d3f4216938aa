//! Long trunks: four-bars in a row, each driven by the rocker of the one before it.

use mech_compiler::model::{
    Axis, AxisId, AxisKind, Joint, JointId, JointKind, Link, LinkId, Model, Motor, Origin,
};

/// A trunk of this many loops, one motor, as drawn. Its declaration order is that of the sequence.
#[must_use]
pub fn chain(loops: usize) -> Model {
    let mut model = Model::new("Chain", Origin::default());
    let crank = link(&mut model, "crank");
    let mut along = 0.0;
    revolute(&mut model, LinkId::GROUND, crank, [along, 0.0]);
    model
        .motors
        .push(Motor::new(JointId::new(0), Origin::default()));
    let (mut input, mut pin) = (crank, [along + 0.3, 1.0]);
    for number in 0..loops {
        let coupler = link(&mut model, &format!("coupler_{number}"));
        let rocker = link(&mut model, &format!("rocker_{number}"));
        along += 3.0;
        let top = [along + 0.3, 1.6];
        revolute(&mut model, input, coupler, pin);
        revolute(&mut model, coupler, rocker, top);
        revolute(&mut model, LinkId::GROUND, rocker, [along, 0.0]);
        // The next loop is driven from lower on the rocker, so that the swing does not grow along the chain.
        (input, pin) = (rocker, [along + 0.2, 1.0]);
    }
    model
}

/// The same as the text of a `mechanism!`, in the form of a drawing.
#[must_use]
pub fn chain_text(loops: usize) -> String {
    crate::text(&chain(loops))
}

fn link(model: &mut Model, name: &str) -> LinkId {
    let mut link = Link::new(name, Origin::default());
    link.drawn = true;
    model.links.push(link);
    LinkId::new(model.links.len() - 1)
}

fn revolute(model: &mut Model, a: LinkId, b: LinkId, at: [f64; 2]) {
    let mut axis = |link| {
        let (kind, direction, origin) = (AxisKind::Point, [1.0, 0.0], Origin::default());
        model.axes.push(Axis {
            link,
            name: None,
            port: None,
            origin,
            kind,
            at,
            formulas: [None; 2],
            direction_formulas: [None; 2],
            direction,
        });
        AxisId::new(model.axes.len() - 1)
    };
    let kind = JointKind::Revolute(axis(a), axis(b));
    let name = format!("j{}", model.joints.len());
    model.joints.push(Joint {
        name,
        origin: Origin::default(),
        kind,
        hidden: false,
    });
}
