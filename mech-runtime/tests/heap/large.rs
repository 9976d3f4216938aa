//! Large pictures need no large stack, whether optimised or not.

use super::Arm;
use mech_runtime::{
    Canvas, Frame, HeapFrame, HeapSmooth, HeapStage, Mechanism, Outline, Palette, Pose, Smooth,
};
use std::f64::consts::PI;
use std::sync::Mutex;
use std::thread;

const STACK: usize = 256 * 1024;
const SIZES: [[usize; 2]; 2] = [[1920, 1080], [3840, 2160]];
const RADIUS: f64 = 500.25;
const DISC: Outline<'static, f64> = Outline::Circle { center: [0.0, 0.0], radius: RADIUS };

fn on_a_small_stack(work: impl FnOnce() + Send + 'static) {
    let thread = thread::Builder::new().stack_size(STACK);
    let thread = thread.spawn(work).expect("a thread begins");
    thread.join().expect("the stack suffices");
}

/// Whether so many pixels are painted as a disc covers; of a few on its edge that is not said.
fn is_a_disc(pixels: f64) -> bool {
    (pixels - PI * RADIUS * RADIUS).abs() < RADIUS
}

#[test]
fn a_large_frame_is_painted() {
    on_a_small_stack(|| {
        for [width, height] in SIZES {
            let mut frame = HeapFrame::new(width, height).expect("there is memory");
            frame.fill(DISC, Pose::identity(), Palette::INK);
            let painted = frame.pixels().iter().filter(|&&entry| entry == Palette::INK);
            assert!(is_a_disc(painted.map(|_| 1.0).sum()));
            assert_eq!(frame.pixel(width / 2, height / 2), Some(Palette::INK));
            assert_eq!(frame.pixel(width - 1, height - 1), Some(Palette::PAPER));
            frame.clear();
            assert_eq!(frame, HeapFrame::new(width, height).expect("there is memory"));
        }
    });
}

#[test]
fn a_large_smooth_picture_is_painted() {
    on_a_small_stack(|| {
        for [width, height] in SIZES {
            let mut picture = HeapSmooth::new(width, height).expect("there is memory");
            picture.set_palette(Palette::TEXTBOOK.with(0, [255; 3]).with(1, [0; 3]));
            picture.clear();
            picture.fill(DISC, Pose::identity(), 1);
            let shares = picture.pixels().iter().map(|pixel| 255 - pixel[0]);
            assert!(is_a_disc(shares.map(|share| f64::from(share) / 255.0).sum()));
            let copy = picture.clone();
            assert_eq!(copy, picture);
            // Sides that cross each other, in more than one row.
            let corners = [[-900.0, -500.0], [900.0, 500.0], [900.0, -500.0], [-900.0, 500.0]];
            picture.fill(Outline::Polygon(&corners), Pose::identity(), 2);
            assert_ne!(copy, picture);
        }
    });
}

#[test]
fn a_large_stage_is_painted() {
    on_a_small_stack(|| {
        for [width, height] in SIZES {
            let mut arm = Arm::new();
            let mut stage = HeapStage::of::<Arm>(width, height).expect("there is memory");
            let mut frame = HeapFrame::of::<Arm>(width, height).expect("there is memory");
            for step in 0..3 {
                let angle = 0.1 * f64::from(step);
                arm.move_to([angle, angle]).expect("it is free");
                stage.show(|canvas| arm.draw(canvas));
                frame.clear();
                arm.draw(&mut frame);
                assert_eq!(stage.frame(), &frame);
            }
        }
    });
}

#[test]
fn a_large_picture_is_that_in_a_static() {
    static FRAME: Mutex<Frame<1920, 1080>> = Mutex::new(Frame::new());
    static SMOOTH: Mutex<Smooth<1920, 1080>> = Mutex::new(Smooth::new());
    on_a_small_stack(|| {
        let mut arm = Arm::new();
        arm.move_to([0.7, -1.9]).expect("it is free");
        let mut frame = FRAME.lock().expect("nobody else has it");
        frame.look_at(Arm::view(1920, 1080));
        arm.draw(&mut *frame);
        let mut heap = HeapFrame::of::<Arm>(1920, 1080).expect("there is memory");
        arm.draw(&mut heap);
        assert!(heap.pixels() == frame.pixels().as_flattened());
        let mut smooth = SMOOTH.lock().expect("nobody else has it");
        smooth.look_at(Arm::view(1920, 1080));
        arm.draw(&mut *smooth);
        let mut heap = HeapSmooth::of::<Arm>(1920, 1080).expect("there is memory");
        arm.draw(&mut heap);
        assert!(heap.pixels() == smooth.pixels().as_flattened());
    });
}
