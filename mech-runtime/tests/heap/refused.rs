//! Sizes that cannot be had are an error, and all others can be painted on.

use super::Arm;
use mech_runtime::raster::TooLarge;
use mech_runtime::{Canvas, HeapFrame, HeapSmooth, HeapStage, Outline, Palette, Pose, View};

const MOST: usize = 1 << 21;

/// Returns the errors of all kinds of pictures of this size.
fn refusals([width, height]: [usize; 2]) -> [Option<TooLarge>; 6] {
    [
        HeapFrame::new(width, height).err(),
        HeapFrame::of::<Arm>(width, height).err(),
        HeapSmooth::new(width, height).err(),
        HeapSmooth::of::<Arm>(width, height).err(),
        HeapStage::new(width, height).err(),
        HeapStage::of::<Arm>(width, height).err(),
    ]
}

#[test]
fn sides_that_are_too_long_are_refused() {
    for size in [
        [usize::MAX, 2],
        [2, usize::MAX],
        [usize::MAX; 2],
        [usize::MAX, 0],
        [0, usize::MAX],
        [1 << 32; 2],
        [MOST + 1, 1],
        [1, MOST + 1],
    ] {
        assert_eq!(refusals(size), [Some(TooLarge::Sides(size)); 6]);
    }
    assert_eq!(
        TooLarge::Sides([3_000_000, 2]).to_string(),
        "a picture of 3000000 × 2 pixels has more than 2097152 in one direction"
    );
}

/// Systems that promise more memory than there is cannot refuse.
#[cfg(target_os = "linux")]
#[test]
fn what_memory_does_not_hold_is_refused() {
    let promises = std::fs::read_to_string("/proc/sys/vm/overcommit_memory");
    if promises.is_ok_and(|mode| mode.trim() != "1") {
        let size = [MOST; 2]; // 4 TiB, or 16
        assert_eq!(refusals(size), [Some(TooLarge::Memory(size)); 6]);
    }
    assert_eq!(
        TooLarge::Memory([MOST; 2]).to_string(),
        "there is no memory for a picture of 2097152 × 2097152 pixels"
    );
}

#[test]
fn the_longest_sides_are_painted_to_their_ends() {
    let disc = Outline::Circle { center: [0.0, 0.0], radius: 1.9 };
    let half = 0.5 * 2_097_152.0;
    let mut wide = HeapFrame::new(MOST, 1).expect("there is memory");
    wide.look_at(View::new([1.0 - half, 0.0], 1.0));
    wide.fill(disc, Pose::identity(), Palette::INK);
    assert_eq!(wide.pixel(MOST - 1, 0), Some(Palette::INK));
    assert_eq!(wide.pixels().iter().filter(|&&entry| entry != 0).count(), 3);
    let mut high = HeapSmooth::new(1, MOST).expect("there is memory");
    high.look_at(View::new([0.0, half - 1.0], 1.0));
    high.fill(disc, Pose::identity(), Palette::INK);
    let ink = Some(Palette::TEXTBOOK.rgba(Palette::INK));
    assert_eq!(high.pixel(0, MOST - 1), ink);
}

#[test]
fn there_may_be_no_pixel_at_all() {
    let arm = Arm::new();
    for [width, height] in [[0, 0], [0, 9], [9, 0], [MOST, 0], [0, MOST]] {
        assert_eq!(refusals([width, height]), [None; 6]);
        let mut frame = HeapFrame::of::<Arm>(width, height).expect("it is small");
        let mut smooth = HeapSmooth::of::<Arm>(width, height).expect("it is small");
        let mut stage = HeapStage::of::<Arm>(width, height).expect("it is small");
        arm.draw(&mut frame);
        frame.clear();
        arm.draw(&mut smooth);
        Canvas::<f64>::text(&mut smooth, [0.0, 0.0], "Arm", 3);
        smooth.clear();
        stage.show(|canvas| arm.draw(canvas));
        assert_eq!([frame.width(), frame.height()], [width, height]);
        assert_eq!([smooth.width(), smooth.height()], [width, height]);
        assert_eq!((frame.pixel(0, 0), smooth.pixel(0, 0)), (None, None));
        assert!(frame.png().is_err() && smooth.png().is_err());
    }
}
