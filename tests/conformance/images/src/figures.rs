//! What a subject costs on this processor.

use crate::clock::{Clock, stack_of};
use crate::subject::{Picture, Subject};
use core::array;
use core::hint::black_box;
use firmware::{Line, exit};
use mech_probes::STEPS;

/// A frame is drawn for every tenth step.
const STRIDE: usize = 10;

/// Moves a subject through its motion and draws it, measures that, prints it and ends: with a failure if something was in the way.
pub fn figures<S: Subject>() -> ! {
    exit(print::<S>().is_some())
}

fn print<S: Subject>() -> Option<()> {
    let mut clock = Clock::take()?;
    // Every program copies something: that routine is no part of what a mechanism costs.
    black_box(*black_box(&[0_u32; 64]));
    let mut picture = Picture::new();
    picture.look_at(S::view());
    let mut subject = S::new();
    let motion: [S::Motors; STEPS as usize] = array::from_fn(|step| S::motion(step as u16));

    let mut moved = true;
    let position = clock.instructions(|| {
        for motors in &motion {
            moved &= subject.move_to(*motors);
        }
    });
    // One by one, and their sum in more bits: many are more than the clock can count.
    let mut frame = 0_u64;
    for motors in motion.iter().step_by(STRIDE) {
        frame += u64::from(clock.instructions(|| {
            moved &= subject.move_to(*motors);
            subject.draw(&mut picture);
        }));
    }
    let stack_of_position = stack_of(|| {
        for motors in &motion {
            moved &= subject.move_to(*motors);
        }
    });
    let stack_of_drawing = stack_of(|| {
        for motors in motion.iter().step_by(STRIDE) {
            moved &= subject.move_to(*motors);
            subject.draw(&mut picture);
        }
    });

    let steps = u32::from(STEPS);
    let frames = u64::from(steps) / STRIDE as u64;
    for (name, value) in [
        ("state", S::state() as u32),
        ("position", (position + steps / 2) / steps),
        ("frame", ((frame + frames / 2) / frames) as u32),
        ("stack", stack_of_position),
        ("stack-drawing", stack_of_drawing),
    ] {
        Line::new().text(name).number(value).print().ok()?;
    }
    moved.then_some(())
}
