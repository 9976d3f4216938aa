//! Mechanisms far from the origin.

use mech_compiler::compile;
use mech_compiler::evaluate::Machine;
use mech_runtime::Real;

/// A four-bar with frames of its own, one that is drawn where it stands, and a slider-crank.
const FAR: [fn(f64) -> String; 3] = [
    |far| {
        format!(
            "ground {{ point a = ({far:?}, -{far:?}); point d = ({:?}, -{far:?}); }}
            link crank {{ point a = (0, 0); point b = (1, 0); }} link coupler {{ point b = (0, 0); point c = (3.5, 0); }}
            link rocker {{ point d = (0, 0); point c = (3, 0); }} joint ja = revolute(ground.a, crank.a);
            joint jb = revolute(crank.b, coupler.b); joint jc = revolute(coupler.c, rocker.c);
            joint jd = revolute(ground.d, rocker.d); motor ja; start {{ coupler near 50 deg; }}",
            far + 4.0
        )
    },
    |far| {
        let at = |x: f64, y: f64| format!("({:?}, {:?})", x + far, y - far);
        format!(
            "link crank; link coupler; link rocker; joint ja = revolute(ground, crank) at {};
            joint jb = revolute(crank, coupler) at {}; joint jc = revolute(coupler, rocker) at {};
            joint jd = revolute(ground, rocker) at {}; motor ja;",
            at(0.0, 0.0),
            at(1.0, 0.0),
            at(3.25, 2.5),
            at(4.0, 0.0)
        )
    },
    |far| {
        let at = |x: f64, y: f64| format!("({:?}, {:?})", x + far, y - far);
        format!(
            "link crank; link rod; link block; joint ja = revolute(ground, crank) at {};
            joint jb = revolute(crank, rod) at {}; joint jc = revolute(rod, block) at {};
            joint x = prismatic(block, ground) at {} along (3, 1); motor ja;",
            at(0.0, 0.0),
            at(1.0, 0.0),
            at(4.0, 0.5),
            at(4.0, 0.5)
        )
    },
];

/// A platform on three legs, all of which are solved together.
fn platform(far: f64) -> String {
    let at = |x: f64, y: f64| format!("({:?}, {:?})", x + far, y - far);
    let legs = [
        ("crank", [0.0, 0.0], [1.0, 2.0]),
        ("left", [6.0, 0.0], [4.0, 3.0]),
        ("right", [8.0, 5.0], [4.0, 5.0]),
    ];
    let mut text = "link hand; joint drive = revolute(ground, hand) at ".to_owned();
    text += &format!(
        "{}; link rod; joint push = revolute(hand, rod) at {};",
        at(-2.0, 0.0),
        at(-2.5, 0.5)
    );
    text += "link plate; motor drive; allow coupled;";
    text += &format!("joint pull = revolute(rod, plate) at {};", at(1.0, 2.0));
    for (name, foot, head) in &legs[1..] {
        let (foot, head) = (at(foot[0], foot[1]), at(head[0], head[1]));
        text += &format!(
            "link {name}; joint f_{name} = revolute(ground, {name}) at {foot}; joint h_{name} = revolute({name}, plate) at {head};"
        );
    }
    text
}

/// The directions of all links on a way of small steps, with what comes before the motor's angle among the motors.
fn directions<T: Real>(text: &str, before: &[f64]) -> Vec<[f64; 2]> {
    let model = mech_test_support::model(text);
    let compiled = compile(&model).unwrap_or_else(|found| panic!("{found:?}: {text}"));
    let mut machine = Machine::<T>::new(&compiled.program);
    let mut found = Vec::new();
    for step in 1..=40 {
        let angle = 0.01 * f64::from(step);
        let motors: Vec<T> =
            before.iter().chain([&angle]).map(|value| T::from_f64(*value)).collect();
        machine.move_to(&motors).unwrap_or_else(|stop| panic!("{stop:?}: {text}"));
        let poses = machine.position().poses.iter();
        found.extend(poses.map(|[cos, sin, ..]| [*cos, *sin].map(Real::to_f64)));
    }
    found
}

/// Wherever a mechanism stands, or its carriage has gone, its links point as they do at the origin in double precision. No coordinate is
/// rounded.
#[test]
fn links_turn_as_they_do_at_the_origin_wherever_they_stand() {
    fn compare<T: Real>(here: &[[f64; 2]], there: &str, motors: &[f64]) {
        let found = directions::<T>(there, motors);
        let apart = here.iter().zip(&found).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
        let worst = apart.fold(0.0, f64::max);
        assert!(worst <= 64.0 * T::EPSILON, "turned by {worst:e}: {there}");
    }
    for method in ["exact", "newton", "newton(4)"] {
        let text =
            |scalar: &str, body: &str| format!("struct Far: {scalar}; {body} method {method};");
        for far in [1024.0, -32768.0, 1_048_576.0] {
            for body in FAR.into_iter().chain([platform as fn(f64) -> String]) {
                let here = directions::<f64>(&text("f64", &body(0.0)), &[]);
                compare::<f64>(&here, &text("f64", &body(far)), &[]);
                compare::<f32>(&here, &text("f32", &body(far)), &[]);
            }
            let on_car =
                FAR[0](0.0).replace("ground.", "car.").replace("ground {", "link car {").replace(
                    "motor ja;",
                    "joint s = prismatic(ground, car) at (0, 0) along (3, 4); motor s; motor ja;",
                );
            let here = directions::<f64>(&text("f64", &on_car), &[0.0]);
            compare::<f64>(&here, &text("f64", &on_car), &[far]);
            compare::<f32>(&here, &text("f32", &on_car), &[far]);
        }
    }
}
