//! Forces: three ways to find them (virtual work, the equilibrium of each link, reduced inertia) must agree, each link must obey
//! Newton and Euler, and torques at rest must be the slope of the energy: on random mechanisms with random masses, springs, dampers
//! and loads, and on those of the zoo.

use mech_compiler::evaluate::{LinkRates, Machine, Stop};
use mech_compiler::model::{
    Actions, AxisId, AxisKind, Between, Damper, Effects, JointKind, LinkId, Load, LoadKind, Mass,
    Model, Origin, Spring,
};
use mech_compiler::program::{Forces, Inertia, InverseDynamics};
use mech_compiler::{Compiled, compile};
use mech_tests::{Dice, SOURCES, grow, grow_coupled, models, reach, size};

fn cases() -> u64 {
    mech_tests::cases(200)
}

/// Puts random masses on all links, and lets random things act on them.
fn load_up(model: &mut Model, dice: &mut Dice) {
    let size = size(model);
    let near = |dice: &mut Dice| dice.between(-0.5 * size, 0.5 * size);
    for id in model.declared_links().collect::<Vec<_>>() {
        let center = [near(dice), near(dice)];
        model.links[id.index()].mass = Some(Mass {
            mass: dice.between(0.1, 2.0),
            center,
            inertia: dice.between(0.0, 0.2) * size * size,
        });
    }
    let points: Vec<AxisId> = (0..model.axes.len())
        .map(AxisId::new)
        .filter(|&axis| {
            let axis = model.axis(axis);
            axis.kind == AxisKind::Point && model.link(axis.link).die.is_none()
        })
        .collect();
    let moving: Vec<AxisId> = points
        .iter()
        .copied()
        .filter(|&point| model.axis(point).link != LinkId::GROUND)
        .collect();
    let revolutes: Vec<_> = model
        .declared_joints()
        .filter(|&joint| matches!(model.joint(joint).kind, JointKind::Revolute(..)))
        .collect();
    let mut actions = Actions {
        gravity: Some([dice.between(-3.0, 3.0), dice.between(-10.0, 0.0)]),
        ..Actions::default()
    };
    let origin = Origin::default();
    let mut betweens = Vec::new();
    for _ in 0..if points.is_empty() { 0 } else { 3 } {
        let (a, b) = (*dice.pick(&points), *dice.pick(&points));
        let together = |kind: JointKind| matches!(kind, JointKind::Revolute(p, q) if [p, q] == [a, b] || [q, p] == [a, b]);
        let joined = model.joints.iter().any(|joint| together(joint.kind));
        if model.axis(a).link != model.axis(b).link && !joined {
            betweens.push(Between::Points(a, b));
        }
    }
    if !revolutes.is_empty() {
        betweens.push(Between::Joint(*dice.pick(&revolutes)));
    }
    for (number, &between) in betweens.iter().enumerate() {
        let rest = match between {
            Between::Points(..) if dice.once_in(3) => 0.0,
            Between::Points(..) => dice.between(0.1, 1.0) * size,
            Between::Joint(_) => dice.between(-1.0, 1.0),
        };
        actions.springs.push(Spring {
            name: format!("spring{number}"),
            origin,
            between,
            stiffness: dice.between(1.0, 5.0),
            rest,
        });
        actions.dampers.push(Damper {
            name: format!("damper{number}"),
            origin,
            between,
            damping: dice.between(0.1, 1.0),
        });
    }
    if !moving.is_empty() {
        let point = *dice.pick(&moving);
        for (name, kind) in [
            ("push", LoadKind::Force(point)),
            (
                "twist",
                LoadKind::Torque(model.axis(*dice.pick(&moving)).link),
            ),
        ] {
            actions.loads.push(Load {
                name: name.to_owned(),
                origin,
                kind,
            });
        }
    }
    model.actions = actions;
    model.effects = Effects {
        velocity: true,
        acceleration: true,
        force: true,
        dynamics: true,
        overlay: false,
        sensitivity: false,
    };
    model.show = None;
}

#[derive(Debug, Default)]
struct Seen {
    places: usize,
    singular: usize,
    torques: usize,
    links: usize,
    slopes: usize,
}

/// Where a mechanism is, and what it is given there.
struct Given {
    rates: Vec<f64>,
    seconds: Vec<f64>,
    loads: Vec<f64>,
}

fn check(model: &Model, dice: &mut Dice, places: usize, seen: &mut Seen) {
    let Ok(compiled) = compile(model) else {
        return;
    };
    let (Some(inverse_dynamics), Some(inertia), Some(holding)) = (
        &compiled.forced.inverse_dynamics,
        &compiled.forced.inertia,
        &compiled.forced.holding,
    ) else {
        return;
    };
    let mut machine = Machine::<f64>::new(&compiled.program);
    let count = compiled.program.motors.len();
    for _ in 0..places {
        let motors: Vec<f64> = machine
            .position()
            .motors
            .iter()
            .map(|motor| motor + dice.between(-0.7, 0.7))
            .collect();
        let _ = machine.move_toward(&motors);
        let mut some =
            |count: usize| -> Vec<f64> { (0..count).map(|_| dice.between(-1.0, 1.0)).collect() };
        let given = Given {
            rates: some(count),
            seconds: some(count),
            loads: some(model.actions.load_names().len()),
        };
        let at = machine.position().clone();
        let found = |program, rates: &[f64], seconds: &[f64]| {
            let mut machine = Machine::<f64>::new(program);
            machine.put_back(at.clone());
            machine.forces(rates, seconds, &given.loads)
        };
        let zero = vec![0.0; count];
        let moving = found(inverse_dynamics, &given.rates, &given.seconds);
        let Forces::InverseDynamics(moving) = (match moving {
            Err(Stop::Singular(_)) => {
                seen.singular += 1;
                continue;
            }
            other => other.unwrap_or_else(|stop| panic!("{}: {stop:?}", model.name)),
        }) else {
            panic!("not what it takes to move");
        };
        let (
            Ok(Forces::InverseDynamics(resting)),
            Ok(Forces::Holding(held)),
            Ok(Forces::Inertia(felt)),
        ) = (
            found(inverse_dynamics, &zero, &zero),
            found(holding, &zero, &zero),
            found(inertia, &given.rates, &zero),
        )
        else {
            panic!("{}: some forces are found and some are not", model.name);
        };
        let reach = size(model) + reach(&at.poses);
        let [most_moving, most_resting] = [&moving, &resting].map(|found| largest(found, reach));
        if most_moving.max(most_resting) > 1e6 * reach {
            // So near a dead point that what is left of them is rounding.
            seen.singular += 1;
            continue;
        }
        seen.places += 1;
        let agree = |found: &[f64], expected: &[f64], scale: f64, what: &str| {
            for (found, expected) in found.iter().zip(expected) {
                assert!(
                    (found - expected).abs() <= 1e-10 * scale,
                    "{}: {what}: {found}, not {expected}, of {scale}",
                    model.name
                );
            }
        };
        agree(&resting.torques, &held, most_resting, "torques at rest");
        let felt = by_inertia(&felt, &given.seconds);
        agree(&moving.torques, &felt, most_moving, "torques in motion");
        seen.torques += 2 * count;
        let found = (&at, &given);
        newton_and_euler(model, &compiled, found, &moving, most_moving, seen);
        slopes(model, &compiled, (&at, &held, &given), most_resting, seen);
    }
}

/// How large the forces are that cancel: near a dead point they are larger than what is left of them.
fn largest(inverse_dynamics: &InverseDynamics<f64>, reach: f64) -> f64 {
    let reactions = inverse_dynamics.reactions.iter();
    let reactions = reactions.map(|[x, y, torque]| x.hypot(*y) * reach + torque.abs());
    reactions.fold(1.0, f64::max)
}

/// What the motors have to do by their reduced inertia.
fn by_inertia(felt: &Inertia<f64>, seconds: &[f64]) -> Vec<f64> {
    let rows = felt.matrix.iter().zip(&felt.drive);
    let torque = |(row, drive): (&Vec<f64>, &f64)| {
        let inertia: f64 = row
            .iter()
            .zip(seconds)
            .map(|(part, second)| part * second)
            .sum();
        inertia - drive
    };
    rows.map(torque).collect()
}

type Position = mech_compiler::program::Position<f64>;

/// A point of a link in the scene.
fn place(model: &Model, at: &Position, axis: AxisId) -> [f64; 2] {
    let axis = model.axis(axis);
    carried(at, axis.link, axis.at)
}

fn carried(at: &Position, link: LinkId, [x, y]: [f64; 2]) -> [f64; 2] {
    match link.index().checked_sub(1) {
        None => [x, y],
        Some(index) => {
            let [cos, sin, u, v] = at.poses[index];
            [u + cos * x - sin * y, v + sin * x + cos * y]
        }
    }
}

/// Each link: forces are mass times acceleration, and moments about its centre are inertia times angular acceleration.
fn newton_and_euler(
    model: &Model,
    compiled: &Compiled,
    (at, given): (&Position, &Given),
    inverse_dynamics: &InverseDynamics<f64>,
    scale: f64,
    seen: &mut Seen,
) {
    let mut machine = Machine::<f64>::new(compiled.moving.as_ref().expect("asked for"));
    machine.put_back(at.clone());
    let moved = machine
        .motion(&given.rates, &given.seconds)
        .expect("it is regular");
    let accelerations = moved.accelerations.as_ref().expect("asked for");
    let (mut acts, rolls) = by_joints(model, at, inverse_dynamics);
    acts.extend(by_actions(model, (at, given), &moved));
    for (index, link) in model.declared_links().enumerate() {
        let mass = model.link(link).mass.expect("all have one");
        let center = carried(at, link, mass.center);
        let [_, _, u, v] = at.poses[index];
        let ([turning, ..], [change, x, y]) = (moved.velocities[index], accelerations[index]);
        let arm = [center[0] - u, center[1] - v];
        let acceleration = [
            x - change * arm[1] - turning * turning * arm[0],
            y + change * arm[0] - turning * turning * arm[1],
        ];
        let gravity = model.actions.gravity.unwrap_or_default();
        let mut sums = [
            mass.mass * (gravity[0] - acceleration[0]),
            mass.mass * (gravity[1] - acceleration[1]),
            -mass.inertia * change,
        ];
        for (_, point, force, torque) in acts.iter().filter(|(on, ..)| *on == link) {
            let arm = [point[0] - center[0], point[1] - center[1]];
            sums[0] += force[0];
            sums[1] += force[1];
            sums[2] += arm[0] * force[1] - arm[1] * force[0] + torque;
        }
        let count = if rolls.contains(&link) { 2 } else { 3 };
        let scale = [scale / size(model), scale / size(model), scale];
        for (sum, scale) in sums.iter().zip(scale).take(count) {
            assert!(
                sum.abs() <= 1e-10 * scale.max(scale * size(model)),
                "{}, link {}: {sums:?} of {scale}",
                model.name,
                model.link(link).name
            );
            seen.links += 1;
        }
    }
}

/// What acts on a link: a force at a point, and a torque.
type Act = (LinkId, [f64; 2], [f64; 2], f64);

/// What joints do to links, and the links of which not all of that is told.
fn by_joints(
    model: &Model,
    at: &Position,
    inverse_dynamics: &InverseDynamics<f64>,
) -> (Vec<Act>, Vec<LinkId>) {
    let mut acts: Vec<Act> = Vec::new();
    let mut rolls: Vec<LinkId> = Vec::new();
    for (joint, &[x, y, torque]) in model.declared_joints().zip(&inverse_dynamics.reactions) {
        let (mut first, mut second) = model.ends(joint);
        let mut point = [0.0, 0.0];
        match model.joint(joint).kind {
            JointKind::Revolute(a, _) | JointKind::Weld(a, _) => point = place(model, at, a),
            JointKind::Prismatic(a, b) => {
                let pin = |link: LinkId| model.link(link).die.map(|(pin, _)| pin);
                let seen = [a, b].map(|axis| pin(model.axis(axis).link).unwrap_or(axis));
                point = place(model, at, seen[1]);
                if pin(first).is_some() {
                    point = place(model, at, seen[0]);
                }
                for link in [&mut first, &mut second] {
                    if let Some(pin) = pin(*link) {
                        *link = model.axis(pin).link;
                    }
                }
            }
            // Where it touches is not told.
            _ => rolls.extend(model.link_ids()),
        }
        acts.push((second, point, [x, y], torque));
        acts.push((first, point, [-x, -y], -torque));
    }
    (acts, rolls)
}

/// What springs, dampers and loads do to links.
fn by_actions(model: &Model, (at, given): (&Position, &Given), moved: &LinkRates<f64>) -> Vec<Act> {
    let mut acts: Vec<Act> = Vec::new();
    let velocity = |axis: AxisId| {
        let (point, link) = (place(model, at, axis), model.axis(axis).link);
        match link.index().checked_sub(1) {
            None => [0.0, 0.0],
            Some(index) => {
                let ([turning, x, y], [_, _, u, v]) = (moved.velocities[index], at.poses[index]);
                [x - turning * (point[1] - v), y + turning * (point[0] - u)]
            }
        }
    };
    for (between, stiffness, rest, damping) in model
        .actions
        .springs
        .iter()
        .map(|spring| (spring.between, spring.stiffness, spring.rest, 0.0))
        .chain(
            model
                .actions
                .dampers
                .iter()
                .map(|damper| (damper.between, 0.0, 0.0, damper.damping)),
        )
    {
        match between {
            Between::Points(a, b) => {
                let (p, q) = (place(model, at, a), place(model, at, b));
                let (u, v) = (velocity(a), velocity(b));
                let length = (q[0] - p[0]).hypot(q[1] - p[1]);
                // Where its ends meet it has no direction, and does nothing.
                let apart = length.max(1e-9 * size(model));
                let unit = [(q[0] - p[0]) / apart, (q[1] - p[1]) / apart];
                let rate = (v[0] - u[0]) * unit[0] + (v[1] - u[1]) * unit[1];
                let tension = stiffness * (length - rest) + damping * rate;
                let force = unit.map(|part| tension * part);
                acts.push((model.axis(a).link, p, force, 0.0));
                acts.push((model.axis(b).link, q, force.map(|part| -part), 0.0));
            }
            Between::Joint(joint) => {
                let JointKind::Revolute(a, b) = model.joint(joint).kind else {
                    panic!("a spring turns revolutes");
                };
                let angle = |axis: AxisId| {
                    let (axis, [x, y]) = (model.axis(axis), model.axis(axis).direction);
                    let own = y.atan2(x);
                    axis.link
                        .index()
                        .checked_sub(1)
                        .map_or(own, |link| own + at.poses[link][1].atan2(at.poses[link][0]))
                };
                let turning = |axis: AxisId| {
                    let link = model.axis(axis).link.index().checked_sub(1);
                    link.map_or(0.0, |link| moved.velocities[link][0])
                };
                let between = angle(b) - angle(a) - rest;
                let deflection = match model.motor_of(joint) {
                    Some(motor) => at.motors[motor.index()] - rest,
                    None => between.sin().atan2(between.cos()),
                };
                let torque = stiffness * deflection + damping * (turning(b) - turning(a));
                acts.push((model.axis(a).link, [0.0; 2], [0.0; 2], torque));
                acts.push((model.axis(b).link, [0.0; 2], [0.0; 2], -torque));
            }
        }
    }
    for (first, load) in model.actions.numbered_loads() {
        match load.kind {
            LoadKind::Force(point) => {
                let force = [given.loads[first], given.loads[first + 1]];
                acts.push((model.axis(point).link, place(model, at, point), force, 0.0));
            }
            LoadKind::Torque(link) => acts.push((link, [0.0; 2], [0.0; 2], given.loads[first])),
        }
    }
    acts
}

/// Without loads, torques at rest are the slope of the potential energy.
fn slopes(
    model: &Model,
    compiled: &Compiled,
    (at, held, given): (&Position, &[f64], &Given),
    scale: f64,
    seen: &mut Seen,
) {
    let inertia = compiled.forced.inertia.as_ref().expect("asked for");
    let inverse_dynamics = compiled
        .forced
        .inverse_dynamics
        .as_ref()
        .expect("asked for");
    let zero = vec![0.0; held.len()];
    let unloaded = vec![0.0; given.loads.len()];
    let step = 1e-3;
    for motor in 0..held.len() {
        let energy = |displacement: f64| {
            let mut machine = Machine::<f64>::new(inertia);
            machine.put_back(at.clone());
            let mut motors = at.motors.clone();
            motors[motor] += displacement;
            machine.move_to(&motors).ok()?;
            match machine.forces(&zero, &zero, &unloaded) {
                Ok(Forces::Inertia(felt)) => Some(felt.energy[1]),
                _ => None,
            }
        };
        let slope = |step: f64| {
            Some(
                (energy(-2.0 * step)? - 8.0 * energy(-step)? + 8.0 * energy(step)?
                    - energy(2.0 * step)?)
                    / (12.0 * step),
            )
        };
        let (Some(fine), Some(coarse)) = (slope(step), slope(2.0 * step)) else {
            continue;
        };
        let mut machine = Machine::<f64>::new(inverse_dynamics);
        machine.put_back(at.clone());
        let Ok(Forces::InverseDynamics(resting)) = machine.forces(&zero, &zero, &unloaded) else {
            continue;
        };
        let explained = (fine - coarse).abs() + 1e-9 * scale;
        let off = (fine - resting.torques[motor]).abs();
        assert!(
            off <= explained,
            "{}: torque {}, slope {fine}, explained {explained:e}",
            model.name,
            resting.torques[motor]
        );
        seen.slopes += 1;
    }
}

#[test]
fn forces_in_random_mechanisms_obey_newton_and_euler_and_virtual_work() {
    let mut seen = Seen::default();
    for seed in mech_tests::seeds(cases()) {
        let mut dice = Dice::new(seed);
        let additions = 1 + dice.below(7);
        let mut model = if seed % 4 == 3 {
            grow_coupled(&mut dice, additions / 2).model
        } else {
            grow(&mut dice, additions).model
        };
        model.name = format!("Seed{seed}");
        load_up(&mut model, &mut dice);
        check(&model, &mut dice, 4, &mut seen);
    }
    println!("{seen:?}");
    assert!(
        seen.places > usize::try_from(cases()).unwrap_or(0),
        "{seen:?}"
    );
}

#[test]
fn forces_in_the_zoo_and_the_gallery_do_too() {
    let mut seen = Seen::default();
    let mut dice = Dice::new(11);
    for mut model in SOURCES[..8].iter().flat_map(|(_, source)| models(source)) {
        load_up(&mut model, &mut dice);
        check(&model, &mut dice, 8, &mut seen);
    }
    println!("{seen:?}");
    assert!(seen.places > 50, "{seen:?}");
}
