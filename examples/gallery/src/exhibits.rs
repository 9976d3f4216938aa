//! The exhibits.

use crate::andrews::AndrewsSqueezer;
use crate::antikythera::Antikythera;
use crate::crane::LuffingCrane;
use crate::diagram::PistonDiagram;
use crate::excavator::Excavator;
use crate::four_bar::CrankRocker;
use crate::geared_piston::GearedPiston;
use crate::jansen::JansenLeg;
use crate::rocker_arm::RockerArm;
use crate::skeleton::Skeleton;
use crate::velocities::CouplerCurve;
use crate::walker::Walker;
use crate::watt::Watt;
use crate::{Exhibit, Scene, Showcase};
use mech_runtime::overlay::Arrows;
use mech_runtime::{Mechanism, Overlay, Palette};

/// All exhibits, in the order in which they hang.
#[must_use]
pub fn exhibits() -> Vec<Box<dyn Exhibit>> {
    vec![
        geared_piston(),
        diagram(),
        four_bar(),
        velocities(),
        watt(),
        andrews(),
        jansen(),
        rocker_arm(),
        crane(),
        excavator(),
        walker(),
        antikythera(),
        skeleton(),
    ]
}

/// Two turns of the pinion are one of the wheel.
fn geared_piston() -> Box<dyn Exhibit> {
    Box::new(Showcase::<GearedPiston> {
        title: "Piston driven through gears",
        caption: "The mechanism of the paper’s first figure. The motor turns the pinion of 20 \
                  teeth; the wheel of 40 turns the other way at half the speed, which is worked \
                  out in whole numbers at compile time. A crank pin on the wheel, a connecting rod \
                  and the piston in its bore make a slider-crank: one loop of three revolutes and \
                  a prismatic, solved once the gear has told it where the wheel is.",
        frames: 144,
        still: 0.08,
        ..Showcase::untitled()
    })
}

/// Two turns of the pinion are one of the wheel.
fn diagram() -> Box<dyn Exhibit> {
    Box::new(Showcase::<PistonDiagram> {
        title: "Piston driven through gears, as a diagram",
        caption: "The same mechanism without a single shape: `effects { overlay; }` draws pitch \
                  circles with ticks by which they are seen to turn, fixed pivots, the block on \
                  its rail, the motor; blue arrows are velocities, red ones accelerations. \
                  Symbols and lines keep their size in pixels, however large the scene is seen.",
        frames: 144,
        still: 0.08,
        move_to: |mechanism, motors| mechanism.move_with(motors, [2.0], [0.0]),
        paint: paint_diagram,
        ..Showcase::untitled()
    })
}

fn paint_diagram(mechanism: &PistonDiagram, scene: &mut Scene) {
    let overlay = Overlay::new().links(true).axes(true).size(1.4);
    mechanism.draw_overlay(scene, &overlay);
    mechanism.draw_accelerations(scene, &Arrows::new(0.6, Palette::RED).size(1.3));
    mechanism.draw_velocities(scene, &Arrows::new(1.0, Palette::BLUE).size(1.3));
}

/// One turn of the crank.
fn four_bar() -> Box<dyn Exhibit> {
    Box::new(Showcase::<CrankRocker> {
        title: "Four-bar linkage",
        caption: "The crank is the shortest bar, and with the longest it is shorter than the other \
                  two together: by Grashof’s rule it turns all the way round while the rocker \
                  swings to and fro. The coupler between them is a plate, and its red point runs \
                  along a coupler curve; the dots show it at every ten degrees of the crank. One \
                  loop of four revolutes, of which one has the motor.",
        still: 0.1,
        ..Showcase::untitled()
    })
}

/// The trace is that of one turn: after it, every new place is one that it was at before.
fn velocities() -> Box<dyn Exhibit> {
    Box::new(Showcase::<CouplerCurve> {
        title: "Four-bar linkage, with velocities",
        caption: "What a textbook draws: fixed pivots on hatched stands, links as bars, an arrow \
                  for the motor, the path of the coupler’s tracer point, and the velocities \
                  at a constant rate of the crank. The path is a ring of 720 places in the \
                  struct that every move adds to; the velocities come from the linear system \
                  of the loop, exactly.",
        still: 0.85,
        move_to: |mechanism, motors| mechanism.move_with(motors, [1.0], [0.0]),
        paint: paint_velocities,
        ..Showcase::untitled()
    })
}

fn paint_velocities(mechanism: &CouplerCurve, scene: &mut Scene) {
    Mechanism::draw(mechanism, scene);
    mechanism.draw_overlay(scene, &Overlay::new().links(true).size(1.4));
    mechanism.draw_velocities(scene, &Arrows::new(1.2, Palette::BLUE).size(1.3));
}

/// One turn of the crank.
fn watt() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Watt> {
        title: "Watt’s six-bar linkage",
        caption: "Two four-bar loops in a row. In the first, crank and coupler rock the bell \
                  crank, a ternary link; in the second, the bell crank rocks the rocker on the \
                  right through a connecting rod. The second loop waits for the first, and \
                  together they swing the rocker through 138°, much farther than a single four-bar \
                  could at such good transmission angles. Windscreen wipers are made this way. The \
                  links are declared as they are drawn, in the coordinates of the scene.",
        ..Showcase::untitled()
    })
}

/// One turn of the crank.
fn andrews() -> Box<dyn Exhibit> {
    Box::new(Showcase::<AndrewsSqueezer> {
        title: "Andrews’ squeezing mechanism",
        caption: "A test of solvers since 1978: seven bodies, drawn to scale, a few centimetres in \
                  size. The crank K1 moves K2, whose far end is pinned to the ternary plate K3: \
                  the first loop. In the same pin E hang the dyads K4, K5 and K6, K7, both held at \
                  the left: a loop each, which need the first but not one another. Four bodies \
                  meet in E, and that counts as three revolutes; so 3 × 7 − 2 × 10 = 1, and one \
                  motor moves it all. The anchor at the upper right is where the spring of K3 ends \
                  in the original.",
        still: 0.2,
        ..Showcase::untitled()
    })
}

/// One turn of the crank.
fn jansen() -> Box<dyn Exhibit> {
    Box::new(Showcase::<JansenLeg> {
        title: "Jansen’s leg",
        caption: "A leg of the beasts that walk on Dutch beaches. The crank drives two dyads at \
                  once, upper rod and upper plate, lower rod and rocker: two loops that need \
                  nothing but the motor. A third, tie and lower plate, hangs between them and \
                  needs both. The two plates are ternary links, each a dyad that was made rigid, \
                  so that the points of the leg are a chain of five dyads. The foot goes straight \
                  along the sand for half a turn and comes back through the air; the dots show it \
                  at every ten degrees of the crank.",
        ..Showcase::untitled()
    })
}

/// One turn of the crank, while the arm reaches out once and the hand nods twice.
fn rocker_arm() -> Box<dyn Exhibit> {
    Box::new(Showcase::<RockerArm> {
        title: "Arm on a rocker",
        caption: "Trunk and arm together. The trunk is a four-bar loop of crank, coupler and \
                  rocker, driven by one motor. Its rocker carries an arm, an open chain of two \
                  revolutes, the shoulder and the wrist, with two arm motors. An arm takes no part \
                  in any loop: its joints are simply put one after the other, and nothing in the \
                  trunk depends on them. So there are three motors for a mobility of 3.",
        frames: 120,
        still: 0.1,
        ..Showcase::untitled()
    })
}

/// The jib is let down and hauled in once.
fn crane() -> Box<dyn Exhibit> {
    Box::new(Showcase::<LuffingCrane> {
        title: "Level-luffing crane",
        caption: "A double rocker: neither jib nor tie can turn all the way round. Jib, tie and \
                  nose are made such that the tip, and the load below it, stay at one height while \
                  the jib is hauled in, so that luffing takes no work. Beyond the motion that is \
                  shown lie limits: let down to 28°, tie and nose are in one line, and \
                  the loop does not close any farther. Whoever drives the crane there is told so.",
        still: 0.6,
        ..Showcase::untitled()
    })
}

/// The bucket reaches out, digs, lifts and empties.
fn excavator() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Excavator> {
        title: "Excavator",
        caption: "Three cylinders, each a part of the library, move boom, stick and bucket. Each motor \
                  has a range, the stroke of its cylinder, and the compiler has proved that all \
                  strokes are free in any combination, so that `move_within` cannot fail. A \
                  four-bar between the last cylinder and the bucket lets it turn by more than a lever \
                  could.",
        frames: 150,
        still: 0.1,
        ..Showcase::untitled()
    })
}

/// One turn of the axle.
fn walker() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Walker> {
        title: "Walker on twelve legs",
        caption: "Twelve of Theo Jansen’s legs on one axle: six to the left, and six mirrored ones to \
                  the right, whose pins are evenly spaced. The leg is a part of the library, used \
                  twelve times. The report says once what all of them have alike. They are computed \
                  side by side, by one function. The lines are the paths of two feet; the beast is \
                  seen by somebody who walks beside it.",
        frames: 90,
        still: 0.08,
        ..Showcase::untitled()
    })
}

/// A year forwards and back.
fn antikythera() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Antikythera> {
        title: "The computer of Antikythera",
        caption: "A Greek computer of the sky, about 2,100 years old, with the teeth that Freeth and \
                  others counted in 2006. A turn of the input is a year; the moon makes 254/19 turns \
                  in it. The report has the periods as exact fractions: 5/19 for the calendar of \
                  Meton, 1/76 for that of Callippus, 1/4 for the games, 940/4237 for the eclipses. On \
                  the large wheel, two wheels turn about axles 1.1 mm apart, and a pin in a slot makes \
                  the moon faster and slower, by up to 6.58°.",
        frames: 150,
        still: 0.3,
        ..Showcase::untitled()
    })
}

/// Two strides forwards, and back.
fn skeleton() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Skeleton> {
        title: "Skeleton",
        caption: "“A human skeleton has nearly 200 degrees of freedom”, says the paper, so that moving \
                  it by brute force would take 200 motors. This figure in profile has 232, and eight \
                  motors: one for the way, three for hip, knee and ankle of each leg, one for the \
                  arms. Gears on every joint hand on a part of what the bone before does, from the hip \
                  up the spine to the jaw, and from the shoulder to the finger tips; a cam lets the \
                  body rise and fall. Spine, ribs, fingers and toes are one part of three bones, used \
                  36 times.",
        frames: 240,
        still: 0.3,
        ..Showcase::untitled()
    })
}
