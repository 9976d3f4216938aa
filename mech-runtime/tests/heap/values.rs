//! Promises about pictures besides their pixels.

use super::Arm;
use core::mem::size_of;
use mech_runtime::files::{Picture, Sheet};
use mech_runtime::{
    Frame, HeapFrame, HeapSmooth, HeapStage, Mechanism, Palette, Smooth, Stage, View,
};
use proptest::prelude::*;

proptest! {
    /// All of it is seen: nothing is painted within half a margin of the border.
    #[test]
    fn of_looks_at_all_of_a_mechanism(shoulder in -7.0..7.0, elbow in -7.0..7.0, width in 24_usize..200, height in 24_usize..200) {
        let mut arm = Arm::new();
        arm.move_to([shoulder, elbow]).expect("it is free");
        let mut frame = HeapFrame::of::<Arm>(width, height).expect("it is small");
        arm.draw(&mut frame);
        prop_assert_eq!(frame.view(), Arm::view(width, height));
        let margin = width.min(height) / 48;
        let mut painted = 0;
        for (place, entry) in frame.pixels().iter().enumerate() {
            let (x, y) = (place % width, place / width);
            let is_within = x.min(width - 1 - x) >= margin && y.min(height - 1 - y) >= margin;
            prop_assert!(*entry == Palette::PAPER || is_within, "{x}, {y}");
            painted += usize::from(*entry != Palette::PAPER);
        }
        prop_assert!(painted > 0);
        prop_assert_eq!(HeapSmooth::of::<Arm>(width, height).map(|picture| picture.view()), Ok(frame.view()));
        prop_assert_eq!(HeapStage::of::<Arm>(width, height).map(|stage| stage.frame().view()), Ok(frame.view()));
    }
}

#[test]
fn files_are_the_same() {
    let arm = Arm::new();
    let mut array = Arm::picture::<64, 48>();
    let mut heap = HeapFrame::of::<Arm>(64, 48).expect("it is small");
    arm.draw(&mut array);
    arm.draw(&mut heap);
    assert_eq!(heap.png().expect("a PNG"), array.png().expect("a PNG"));
    assert_eq!(Picture::from(&heap).size(), [64, 48]);
    assert_eq!(format!("{:?}", Sheet::from(&heap)), format!("{:?}", Sheet::from(&array)));
    let mut array = Smooth::<64, 48>::new();
    array.look_at(heap.view());
    let mut heap = HeapSmooth::of::<Arm>(64, 48).expect("it is small");
    arm.draw(&mut array);
    arm.draw(&mut heap);
    assert_eq!(heap.png().expect("a PNG"), array.png().expect("a PNG"));
    assert_eq!(Picture::from(&heap).size(), [64, 48]);
    assert_eq!(format!("{:?}", Sheet::from(&heap)), format!("{:?}", Sheet::from(&array)));
}

#[test]
fn a_picture_on_the_heap_is_a_value() {
    let mut one = HeapFrame::new(8, 6).expect("it is small");
    let other = one.clone();
    assert_eq!(one, other);
    assert_eq!([one.width(), one.height()], [8, 6]);
    one.look_at(View::new([1.0, 2.0], 3.0));
    assert_ne!(one, other);
    one.look_at(other.view());
    one.set_palette(Palette::NIGHT);
    assert_ne!(one, other);
    assert_eq!(one.palette(), &Palette::NIGHT);
    assert_eq!(one.rgb(0, 0), Some(Palette::NIGHT.rgb(0)));
    assert_eq!(one.rgb(0, 6), None);
    // As many pixels, but others.
    assert_ne!(other, HeapFrame::new(6, 8).expect("it is small"));
    assert_eq!(
        format!("{other:?}"),
        "HeapFrame<8, 6> { view: View { center: [0.0, 0.0], scale: 1.0 }, .. }"
    );
    let smooth = HeapSmooth::new(8, 6).expect("it is small");
    assert_eq!(smooth, smooth.clone());
    assert!(format!("{smooth:?}").starts_with("HeapSmooth<8, 6> { view"));
    let stage = HeapStage::new(8, 6).expect("it is small");
    assert!(format!("{:?}", stage.clone()).starts_with("HeapStage { frame: HeapFrame<8, 6>"));
    let stage = Stage::<8, 6>::new();
    assert!(format!("{stage:?}").starts_with("Stage { frame: Frame<8, 6>"));
}

/// Pictures take the space that the documentation says, but for a few words.
#[test]
fn pictures_take_what_is_said() {
    const WORDS: usize = 200;
    let is_about = |size: usize, said: usize| said <= size && size <= said + WORDS;
    assert!(is_about(size_of::<Frame<320, 240>>(), 320 * 240 + 768));
    let smooth = 4 * 320 * (240 + 16) + 768 + 1152;
    assert!(is_about(size_of::<Smooth<320, 240>>(), smooth));
    if cfg!(target_pointer_width = "64") {
        let stage = |width: usize| 2 * (width * width + 768) + 64 * 40 + 12 * 32;
        assert!(is_about(size_of::<Stage<64, 64>>(), stage(64)));
        assert!(is_about(size_of::<Stage<240, 240>>(), stage(240)));
    }
    // On the stack there are only the palettes, and what is touched.
    assert!(size_of::<HeapFrame>() < 1024);
    assert!(size_of::<HeapSmooth>() < 3 * 1024);
    assert!(size_of::<HeapStage>() < 3 * 1024);
}
