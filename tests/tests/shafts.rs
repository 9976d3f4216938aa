//! What is welded turns and carries as one link, on whichever of its links pins, slides and wheels are.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{LinkId, Ratio};
use mech_compiler::program::Forces;
use mech_test_support::sketch::{Bond, Sketch};
use mech_test_support::{Dice, cases, model, seeds, size, with_ground, worst_gap};

/// A planetary gear whose sun, planet, carrier and housing are of several welded links each, and whose pins are on any of them: its text,
/// and how far all links turn on each other by Willis.
fn planetary(dice: &mut Dice) -> (String, Vec<f64>) {
    let (sun, planet) = (10 + dice.below(30), 10 + dice.below(30));
    let ring = sun + 2 * planet;
    let mut sketch = Sketch::default();
    // Seen from the carrier: of housing, sun, carrier and planet.
    let teeth = [ring, sun, planet].map(|teeth| i64::try_from(teeth).expect("few"));
    let [outer, inner, between] =
        [ring, sun, planet].map(|teeth| f64::from(u32::try_from(teeth).expect("few")));
    let turns = [1.0, -outer / inner, 0.0, outer / between];
    let mut turned = Vec::new();
    let bodies = turns.map(|turn| {
        let links: Vec<usize> = (0..=dice.below(3)).map(|_| sketch.link()).collect();
        for (number, &link) in links.iter().enumerate().skip(1) {
            let other = links[dice.below(number)];
            let at = *dice.pick(&[[0.0, 0.0], [3.0, 4.0], [0.3, -0.1]]);
            sketch.join(link, other, Bond::Weld(at));
        }
        turned.extend(links.iter().map(|_| turn));
        links
    });
    let [housing, sun, carrier, planet] = bodies;
    let (center, pivot) = ([0.0, 0.0], [3.0, 4.0]);
    let pins = [
        (dice.pick(&housing), dice.pick(&sun), center),
        (dice.pick(&housing), dice.pick(&carrier), center),
        (dice.pick(&carrier), dice.pick(&planet), pivot),
    ];
    let pins = pins.map(|(a, b, at)| sketch.join(*a, *b, Bond::Pin(at)));
    let [outer, inner, between] = teeth;
    let on = carrier[dice.below(carrier.len())];
    let on = [0, 1].map(|_| dice.once_in(3).then_some(on));
    for (wheels, ratio, on) in [
        ([&sun, &planet], Ratio::Teeth(inner, between), on[0]),
        ([&planet, &housing], Ratio::Teeth(between, -outer), on[1]),
    ] {
        let [a, b] = wheels.map(|links| *dice.pick(links));
        sketch.join(a, b, Bond::Gear(ratio, on));
    }
    sketch.ground = dice.below(sketch.links);
    sketch.motors = vec![*dice.pick(&pins)];
    let exact = dice.once_in(2);
    sketch.place(dice, exact);
    let (text, ground) = (sketch.text(dice), turned[sketch.ground]);
    (text, turned.iter().map(|turn| turn - ground).collect())
}

/// Coaxial pins are one shaft, whichever of the welded links they are on: a ring welded to the housing, a sun and a carrier on two brackets.
#[test]
fn welded_links_share_their_shafts() {
    for seed in seeds(cases(60)) {
        let mut dice = Dice::new(seed);
        let (text, turns) = planetary(&mut dice);
        let model = model(&text);
        let compiled = compile(&model).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
        let mut machine = Machine::<f64>::new(&compiled.program);
        let angles = |machine: &Machine<'_, f64>| -> Vec<f64> {
            let poses = with_ground(&model, &machine.position().poses);
            let mut angles = vec![0.0; turns.len()];
            for (link, pose) in model.links.iter().zip(poses) {
                if let Some(number) = link.name.strip_prefix('l') {
                    angles[number.parse::<usize>().expect("a number")] = pose[1].atan2(pose[0]);
                }
            }
            angles
        };
        let before = angles(&machine);
        let (a, b) = model.ends(model.motors[0].joint);
        let number = |link: LinkId| {
            model.link(link).name.strip_prefix('l').map(|n| n.parse::<usize>().expect("a number"))
        };
        let turn = |link| number(link).map_or(0.0, |number| turns[number]);
        let by = dice.between(-9.0, 9.0);
        let target = machine.position().motors[0] + by;
        machine.move_to(&[target]).expect("it turns");
        let unit = by / (turn(b) - turn(a));
        for (number, (before, now)) in before.iter().zip(angles(&machine)).enumerate() {
            let off = now - before - unit * turns[number];
            assert!(
                (0.5 * off).sin().abs() < 1e-12 * (1.0 + 9.0 * (unit * turns[number]).abs()),
                "l{number}: {off:e}\n{text}"
            );
        }
        let poses = with_ground(&model, &machine.position().poses);
        assert!(worst_gap(&model, &poses) < 1e-10 * size(&model), "{text}");
    }
}

/// A sun, a planet in a ring and a rack: each of one link, or of welded ones with frames of their own.
fn train(in_parts: bool, motor: &str) -> String {
    let mass = "mass 1.3 at (0.4, 0.2) inertia 0.2;";
    let [frame, ring, arm, pinion, table] = if in_parts {
        [
            "link frame { point w = (5, 1); point o = (1, 2); line x = (2, 3) -> (1, 0); } joint w1 = weld(frame.w, ground.w);",
            "link ring { point w = (0.25, 0.5); } joint w2 = weld(ring.w, ground.o);",
            "link arm { point w = (0, 0); point p = (1, 0); } joint w3 = weld(arm.w, carrier.w);",
            "link pinion { point w = (3, 1); } joint w4 = weld(sun.w, pinion.w);",
            "link table { point w = (0.5, 0); line x = (0, 0) -> (1, 0); } joint w5 = weld(table.w, bar.w);",
        ]
    } else {
        [""; 5]
    };
    let [frame_at, ring_at, arm_at, pinion_at, table_at] = if in_parts {
        ["frame", "ring", "arm", "pinion", "table"]
    } else {
        ["ground", "ground", "carrier", "sun", "bar"]
    };
    format!(
        "struct Train;
        ground {{ point o = (0, -2); point w = (4, -3); line x = (1, -1) -> (1, 0); }}
        link sun {{ point o = (0, 0); point w = (1, 0); {mass} }}
        link carrier {{ point o = (0, 0); point w = (1, 2); point p = (2, 2); {mass} }}
        link planet {{ point p = (0, 0); {mass} }}
        link bar {{ point w = (0, 0); line x = (-0.5, 0) -> (1, 0); {mass} }}
        {frame} {ring} {arm} {pinion} {table}
        joint s = revolute(ground.o, sun.o);
        joint c = revolute({frame_at}.o, carrier.o);
        joint q = revolute({arm_at}.p, planet.p);
        joint m = gear(sun, planet, 10 : 10);
        joint n = gear(planet, {ring_at}, 10 : -30);
        joint x = prismatic({frame_at}.x, {table_at}.x);
        joint r = rack({pinion_at}, bar, radius 0.5);
        motor {motor};
        gravity (0, -9.81);
        effects {{ velocity; acceleration; force; dynamics; }}"
    )
}

#[test]
fn welded_links_carry_wheels_and_bars_as_one() {
    for motor in ["s", "c", "q", "x"] {
        let found = [false, true].map(|in_parts| {
            let model = model(&train(in_parts, motor));
            let compiled = compile(&model).unwrap_or_else(|wrong| panic!("{wrong:?}"));
            let mut machine = Machine::<f64>::new(&compiled.program);
            machine.move_to(&[machine.position().motors[0] + 0.7]).expect("it turns");
            let mut there =
                Machine::new(compiled.forced.inverse_dynamics.as_ref().expect("asked for"));
            there.put_back(machine.position().clone());
            let Ok(Forces::InverseDynamics(forces)) = there.forces(&[0.7], &[0.4], &[]) else {
                panic!("no forces");
            };
            // Links and joints that both have.
            let links = compiled.program.links.iter().zip(&machine.position().poses);
            let links = links
                .filter(|(name, _)| ["sun", "carrier", "planet", "bar"].contains(&name.as_str()));
            let mut numbers: Vec<f64> = links.flat_map(|(_, pose)| *pose).collect();
            let joints = model.declared_joints().zip(&forces.reactions);
            let joints = joints.filter(|(joint, _)| model.joint(*joint).name.len() == 1);
            numbers.extend(joints.flat_map(|(_, reaction)| *reaction));
            numbers
        });
        assert_eq!(found[0].len(), found[1].len());
        for (one, parts) in found[0].iter().zip(&found[1]) {
            assert!((one - parts).abs() < 1e-12, "{motor}: {found:?}");
        }
    }
}

/// The place of a part, turned and scaled, is that of its user's pin but for rounding.
#[test]
fn a_shaft_of_a_part_is_that_of_its_user() {
    for seed in seeds(cases(20)) {
        let mut dice = Dice::new(seed);
        let [x, y, u, v] = [0; 4].map(|_| dice.between(-3.0, 3.0));
        let (angle, scale) = (dice.between(-3.0, 3.0), dice.between(0.3, 3.0));
        let (sin, cos) = angle.sin_cos();
        let place = [x + scale * (cos * u - sin * v), y + scale * (sin * u + cos * v)];
        let text = format!(
            "struct Staged;
            part Stage {{
                port frame {{ point o = ({u:?}, {v:?}); }}
                port sun {{ point o = (0, 0); }}
                link carrier {{ point o = (0, 0); point p = (3, 1); }}
                link planet {{ point p = (0, 0); }}
                link ring {{ point o = (0, 0); }}
                joint c = revolute(frame.o, carrier.o);
                joint p = revolute(carrier.p, planet.p);
                joint fixed = weld(frame.o, ring.o);
                joint m1 = gear(sun, planet, 18 : 12);
                joint m2 = gear(planet, ring, 12 : -42);
            }}
            ground {{ point s = ({:?}, {:?}); }}
            link sun {{ point o = (0, 0); }}
            joint s = revolute(ground.s, sun.o);
            use stage: Stage scaled {scale:?} {{ frame = ground at ({x:?}, {y:?}) turned {angle:?}, sun = sun }};
            motor s;",
            place[0], place[1]
        );
        let compiled = compile(&model(&text)).unwrap_or_else(|wrong| panic!("{wrong:?}\n{text}"));
        let mut machine = Machine::<f64>::new(&compiled.program);
        let angle = |machine: &Machine<'_, f64>, name: &str| {
            let mut links = compiled.program.links.iter();
            let place = links.position(|link| link == name).expect("it is there");
            let pose = machine.position().poses[place];
            pose[1].atan2(pose[0])
        };
        let names = ["sun", "stage.carrier", "stage.planet"];
        let before = names.map(|name| angle(&machine, name));
        machine.move_to(&[0.1]).expect("it turns");
        for (number, turn) in [1.0, 0.3, -0.75].into_iter().enumerate() {
            let off = angle(&machine, names[number]) - before[number] - 0.1 * turn;
            assert!((0.5 * off).sin().abs() < 1e-13, "{}: {off:e}\n{text}", names[number]);
        }
    }
}
