//! A stepper on the screw or crank of a mechanism: the mechanism tells where the tool is, and the other way round how many steps to issue.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use firmware::{Line, entry, exit};
use mech_runtime::{Blocked, Reached, mechanism};
use panic_never as _;

/// Steps in a turn: 200 of the stepper's, with 16 microsteps to each.
const TURN: u16 = 200 * 16;

mechanism! {
    /// A table lifted by a crank on the stepper's shaft: where is the table?
    struct Lift: f32;
    ground { point shaft = (0, 0); line guide = (0, 0) -> (0, 1); }
    link crank { point shaft = (0, 0); point pin = (30, 0); }
    link rod { point crank_pin = (0, 0); point table_pin = (80, 0); }
    link table { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }
    joint shaft = revolute(ground.shaft, crank.shaft);
    joint pin = revolute(crank.pin, rod.crank_pin);
    joint head = revolute(rod.table_pin, table.pin);
    joint height = prismatic(ground.guide, table.axis);
    motor shaft in -60 deg ..= 60 deg;
    start { shaft = 0 deg; rod near 110 deg; }
    show height;
}

/// Where the table is after so many steps, in millimetres; `None` where the stepper must not go.
fn height_at(lift: &mut Lift, steps: i16) -> Option<f32> {
    const STEP: f32 = core::f32::consts::TAU / TURN as f32;
    let values = Lift::range([f32::from(steps) * STEP])?;
    lift.move_within(values); // cannot fail: it was proved that the lift moves through the whole range
    Some(lift.height())
}

mechanism! {
    /// The same lift with its motor at the table, which follows a law: where is the crank?
    struct Inverse: f32;
    ground { point shaft = (0, 0); line guide = (0, 0) -> (0, 1); }
    link crank { point shaft = (0, 0); point pin = (30, 0); }
    link rod { point crank_pin = (0, 0); point table_pin = (80, 0); }
    link table { point pin = (0, 0); line axis = (0, 0) -> (1, 0); }
    joint shaft = revolute(ground.shaft, crank.shaft);
    joint pin = revolute(crank.pin, rod.crank_pin);
    joint head = revolute(rod.table_pin, table.pin);
    joint height = prismatic(ground.guide, table.axis);
    motor height = 80 + 20 * sin(2 * PI * t);
    start { crank near 10 deg; }
    show shaft;
}

/// How many steps from the shaft's zero the stepper has to be where the crank is now.
fn steps(inverse: &Inverse) -> i16 {
    const STEPS: f32 = TURN as f32 / core::f32::consts::TAU;
    let steps = inverse.shaft() * STEPS; // less than half a turn to either side
    (steps + 0.5_f32.copysign(steps)) as i16
}

/// The same at a time of the law, in turns of its sine. The stepper is issued the difference to where it was.
fn steps_at(inverse: &mut Inverse, time: f64) -> Result<i16, Blocked<[f32; 1]>> {
    inverse.at_time(time)?;
    Ok(steps(inverse))
}

/// The same for a height that somebody wishes: as far as the lift goes, and whether it goes there.
fn steps_to(inverse: &mut Inverse, height: f32) -> Result<(i16, bool), Blocked<[f32; 1]>> {
    let reached = inverse.move_toward([height])?;
    Ok((steps(inverse), reached == Reached::Target))
}

#[entry]
fn main() -> ! {
    exit(run().is_some())
}

/// Whether the table is where the law has it, to half a step, all the time; and what is at the end of the way.
fn run() -> Option<()> {
    let (mut lift, mut inverse) = (Lift::new(), Inverse::new());
    let mut right = true;
    let mut issued = 0_u32;
    let mut last = steps_at(&mut inverse, 0.0).ok()?;
    for tick in 1..=1000 {
        let steps = steps_at(&mut inverse, f64::from(tick) / 1000.0).ok()?;
        let [height] = inverse.motors();
        // A step lifts the pin of the crank by 0.06 mm at most.
        right &= (height_at(&mut lift, steps)? - height).abs() < 0.04;
        issued += u32::from(steps.abs_diff(last));
        last = steps;
    }
    let (end, is_there) = steps_to(&mut inverse, 200.0).ok()?;
    Line::new()
        .text("issued")
        .number(issued)
        .text(" end")
        .number(end.unsigned_abs().into())
        .print()
        .ok()?;
    // Crank and rod are in one line there.
    right &= end == 800 && !is_there;
    // Beyond the declared range.
    right &= height_at(&mut lift, 900).is_none();
    right.then_some(())
}
