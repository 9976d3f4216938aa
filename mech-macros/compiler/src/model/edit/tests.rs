use super::{Edit, die_of};
use crate::model::{
    Axis, AxisId, AxisKind, Between, Joint, JointId, JointKind, Link, LinkId, LoadKind, Model,
    Motor, MotorId, Near, NewKind, Origin, Ratio, StartValue,
};

/// A small generator (splitmix64).
struct Dice(u64);

impl Dice {
    fn below(&mut self, end: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        usize::try_from((z ^ (z >> 31)) >> 33).unwrap_or(0) % end
    }
}

fn axis(model: &mut Model, dice: &mut Dice, kind: AxisKind) -> AxisId {
    let number = model.axes.len();
    model.axes.push(Axis {
        link: LinkId::new(dice.below(6)),
        name: (dice.below(2) == 0).then(|| format!("x{number}")),
        port: None,
        origin: Origin::default(),
        kind,
        at: [1.0, 2.0],
        formulas: [None; 2],
        direction_formulas: [None; 2],
        direction: [1.0, 0.0],
    });
    AxisId::new(number)
}

/// Links and joints of all kinds, without any sense.
fn jumble(dice: &mut Dice) -> Model {
    let mut model = Model::new("Jumble", Origin::default());
    for link in 1..6 {
        let mut link = Link::new(&format!("l{link}"), Origin::default());
        link.drawn = dice.below(2) == 0;
        model.links.push(link);
    }
    for number in 0..10 {
        let name = format!("j{number}");
        let kind = dice.below(5);
        let link = LinkId::new(dice.below(6));
        let other = LinkId::new((link.index() + 1) % 6);
        let on = (dice.below(2) == 0).then(|| LinkId::new(dice.below(6)));
        let kind = match kind {
            0 => JointKind::Revolute(
                axis(&mut model, dice, AxisKind::Point),
                axis(&mut model, dice, AxisKind::Point),
            ),
            1 => JointKind::Prismatic(
                axis(&mut model, dice, AxisKind::Line),
                axis(&mut model, dice, AxisKind::Line),
            ),
            2 => JointKind::Weld(
                axis(&mut model, dice, AxisKind::Point),
                axis(&mut model, dice, AxisKind::Point),
            ),
            3 => JointKind::Gear {
                a: link,
                b: other,
                ratio: Ratio::Teeth(1, 2),
                on,
            },
            _ => {
                let point = axis(&mut model, dice, AxisKind::Point);
                let line = axis(&mut model, dice, AxisKind::Line);
                model.add_slot(&name, Origin::default(), point, line);
                continue;
            }
        };
        model.joints.push(Joint {
            name,
            origin: Origin::default(),
            kind,
            hidden: false,
        });
    }
    for _ in 0..3 {
        let joint = JointId::new(dice.below(model.joints.len()));
        let origin = Origin::default();
        model.motors.push(Motor::new(joint, origin));
        model.start.values.push(StartValue {
            joint,
            value: 1.0,
            origin,
        });
        model.start.near.push(Near {
            link: LinkId::new(1 + dice.below(5)),
            angle: 0.0,
            origin,
        });
    }
    model
}

fn link_name(model: &Model, id: LinkId) -> &str {
    &model.link(id).name
}

fn ends(model: &Model, id: JointId) -> (String, String, std::mem::Discriminant<JointKind>) {
    let (a, b) = model.ends(id);
    let kind = std::mem::discriminant(&model.joint(id).kind);
    (
        link_name(model, a).to_owned(),
        link_name(model, b).to_owned(),
        kind,
    )
}

/// Every id is in range, dies come last, and each slot is whole.
fn assert_sound(model: &Model) {
    let in_range = |axis: AxisId| axis.index() < model.axes.len();
    for axis in &model.axes {
        assert!(axis.link.index() < model.links.len());
    }
    for joint in &model.joints {
        match joint.kind {
            JointKind::Revolute(a, b) | JointKind::Prismatic(a, b) | JointKind::Weld(a, b) => {
                assert!(in_range(a) && in_range(b));
            }
            JointKind::Gear { a, b, on, .. } => {
                for link in [Some(a), Some(b), on].into_iter().flatten() {
                    assert!(link.index() < model.links.len());
                }
            }
            _ => {}
        }
    }
    for motor in &model.motors {
        assert!(motor.joint.index() < model.joints.len());
    }
    for value in &model.start.values {
        assert!(value.joint.index() < model.joints.len());
    }
    for near in &model.start.near {
        assert!(near.link.index() < model.links.len());
    }
    assert_eq!(model.links[0].name, "ground");
    let first_die = model.links.iter().position(|link| link.die.is_some());
    for (index, link) in model.links.iter().enumerate() {
        assert_eq!(
            link.die.is_some(),
            first_die.is_some_and(|first| index >= first)
        );
        if let Some((point, line)) = link.die {
            assert_eq!(model.axis(point).kind, AxisKind::Point);
            assert_eq!(model.axis(line).kind, AxisKind::Line);
            let own = model
                .joint_ids()
                .filter(|&id| die_of(model, id) == Some(LinkId::new(index)))
                .count();
            assert_eq!(own, 2, "both joints of the slot");
        }
    }
}

/// What is left is between the same links as before, and on motors and starts there is nothing new.
fn assert_rest_of(before: &Model, after: &Model) {
    let kept = |name: &str| after.links.iter().any(|link| link.name == name);
    let hidden = |model: &Model, id| model.joint(id).hidden;
    for id in after.joint_ids() {
        let name = &after.joint(id).name;
        let same = |old: &JointId| {
            before.joint(*old).name == *name && hidden(before, *old) == hidden(after, id)
        };
        let old = before.joint_ids().find(same).expect("it was there");
        assert_eq!(ends(before, old), ends(after, id), "joint {name}");
        if let (JointKind::Gear { on: was, .. }, JointKind::Gear { on: is, .. }) =
            (before.joint(old).kind, after.joint(id).kind)
        {
            let was = was
                .map(|link| link_name(before, link))
                .filter(|name| kept(name));
            assert_eq!(was, is.map(|link| link_name(after, link)));
        }
    }
    let driven = |model: &Model| -> Vec<String> {
        let names = model.motors.iter();
        names
            .map(|motor| model.joint(motor.joint).name.clone())
            .collect()
    };
    let names = driven(after);
    let mut old = driven(before).into_iter();
    assert!(
        names.iter().all(|name| old.any(|old| old == *name)),
        "motors keep their order"
    );
}

#[test]
fn what_is_left_after_removals_is_what_was_there() {
    for seed in 0..3000 {
        let mut dice = Dice(seed);
        let model = jumble(&mut dice);
        assert_sound(&model);
        let mut edit = Edit::new(&model);
        for _ in 0..=dice.below(3) {
            match dice.below(3) {
                0 => edit.remove_joint(JointId::new(dice.below(model.joints.len()))),
                1 => edit.remove_link(LinkId::new(dice.below(6))),
                _ => edit.remove_motor(MotorId::new(dice.below(model.motors.len()))),
            }
        }
        let after = edit.finish();
        assert_sound(&after);
        assert_rest_of(&model, &after);
    }
}

#[test]
fn nothing_changes_without_an_edit() {
    for seed in 0..300 {
        let mut dice = Dice(seed);
        let model = Edit::new(&jumble(&mut dice)).finish();
        assert_eq!(Edit::new(&model).finish(), model);
    }
}

#[test]
fn a_slot_goes_as_a_whole() {
    for seed in 0..300 {
        let model = jumble(&mut Dice(seed));
        for id in model.joint_ids() {
            let after = model.with_edit(|edit| edit.remove_joint(id));
            assert_sound(&after);
            let name = &model.joint(id).name;
            assert!(after.joints.iter().all(|joint| joint.name != *name));
            let slot = die_of(&model, id).is_some();
            assert_eq!(after.links.len() + usize::from(slot), model.links.len());
        }
    }
}

#[test]
fn a_link_takes_what_joins_it_along() {
    for seed in 0..300 {
        let model = jumble(&mut Dice(seed));
        for id in model.declared_links() {
            let after = model.with_edit(|edit| edit.remove_link(id));
            assert_sound(&after);
            assert_rest_of(&model, &after);
            let name = link_name(&model, id);
            assert!(after.links.iter().all(|link| link.name != name));
        }
        assert_eq!(
            model.with_edit(|edit| edit.remove_link(LinkId::GROUND)),
            Edit::new(&model).finish()
        );
    }
}

#[test]
fn a_revolute_becomes_a_slot_in_its_second_link() {
    for seed in 0..300 {
        let model = jumble(&mut Dice(seed));
        for id in model.joint_ids().filter(|&id| die_of(&model, id).is_none()) {
            let JointKind::Revolute(point, other) = model.joint(id).kind else {
                continue;
            };
            let after = model.with_edit(|edit| edit.replace(id, NewKind::Slot([0.0, 1.0])));
            assert_sound(&after);
            let die = after.links.last().and_then(|link| link.die);
            let (pin, line) = die.expect("a die");
            assert_eq!(after.axis(pin).at, model.axis(point).at);
            assert_eq!(after.axis(line).at, model.axis(other).at);
            assert_eq!(after.axis(line).direction, [0.0, 1.0]);
            let owner =
                |model: &Model, axis: AxisId| link_name(model, model.axis(axis).link).to_owned();
            assert_eq!(owner(&after, pin), owner(&model, point));
            assert_eq!(owner(&after, line), owner(&model, other));
            assert_eq!(after.joints.len(), model.joints.len() + 1);
        }
    }
}

#[test]
fn motors_come_go_and_move() {
    let model = jumble(&mut Dice(7));
    let joint = JointId::new(0);
    let more = model.with_edit(|edit| edit.add_motor(joint));
    assert_eq!(more.motors.len(), model.motors.len() + 1);
    assert_eq!(
        more.with_edit(|edit| edit.remove_motor(MotorId::new(model.motors.len())))
            .motors,
        model.motors
    );
    let moved = model.with_edit(|edit| edit.move_motor(MotorId::new(1), joint));
    assert_eq!(moved.motor(MotorId::new(1)).joint, joint);
    assert_eq!(moved.motors.len(), model.motors.len());
}

#[test]
fn springs_and_loads_stay_on_what_they_act_on() {
    let text = "struct Wound; link a { point p = (1, 0); } link b { point q = (2, 0); } link c { point r = (3, 0); } \
        joint first = revolute(ground, a) at (0, 0); joint middle = revolute(a, b) at (1, 0); \
        joint last = revolute(b, c) at (2, 0); motor first; motor middle; motor last; \
        spring on_first = torsional(first) stiffness 1; spring on_last = torsional(last) stiffness 1; \
        damper between = linear(a.p, c.r) damping 1; load push = force(c.r); load turn = torque(c); effects { force; }";
    let parsed = crate::syntax::parse(text.parse().expect("tokens"));
    assert!(parsed.errors.is_empty(), "{:?}", parsed.errors);
    let before = parsed.model;
    let first = JointId::new(0);
    let after = before.with_edit(|edit| edit.remove_joint(first));
    let [spring] = &after.actions.springs[..] else {
        panic!("one spring is left: {:?}", after.actions);
    };
    let Between::Joint(on) = spring.between else {
        panic!("on a joint");
    };
    assert_eq!(
        (&spring.name[..], &after.joint(on).name[..]),
        ("on_last", "last")
    );
    let without_b = before.with_edit(|edit| edit.remove_link(LinkId::new(2)));
    let [damper] = &without_b.actions.dampers[..] else {
        panic!("the damper is left");
    };
    let Between::Points(p, r) = damper.between else {
        panic!("between points");
    };
    let name = |id: AxisId| without_b.axis(id).own_name();
    assert_eq!([name(p), name(r)], ["p", "r"]);
    let [push, turn] = &without_b.actions.loads[..] else {
        panic!("both loads are left");
    };
    let (LoadKind::Force(point), LoadKind::Torque(link)) = (push.kind, turn.kind) else {
        panic!("a force and a torque");
    };
    assert_eq!((name(point), &without_b.link(link).name[..]), ("r", "c"));
}
