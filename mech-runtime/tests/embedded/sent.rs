//! Changes that are sent to a display.

use super::panel::{Panel, SIDE};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use mech_runtime::raster::Area;
use mech_runtime::raster::embedded::rgb;
use mech_runtime::{Canvas, Outline, Pose, Stage, View};
use proptest::collection::vec;
use proptest::prelude::*;

proptest! {
    /// A display that is sent only what has changed shows everything.
    #[test]
    fn areas_that_have_changed_are_enough(
        moments in vec(vec((-150.0..150.0_f32, -150.0..150.0_f32, 0.0..80.0_f32), 3), 1..8),
    ) {
        let mut stage = Stage::<SIDE, SIDE, 2>::new();
        stage.look_at(View::new([0.0, 0.0], 1.0));
        let mut panel = Panel::new();
        for circles in &moments {
            stage.show(|canvas| {
                for (&(x, y, radius), color) in circles.iter().zip(2..) {
                    canvas.fill(Outline::Circle { center: [x, y], radius }, Pose::identity(), color);
                }
            });
            for area in stage.changed() {
                let part = Rectangle::from(area);
                prop_assert_eq!(stage.frame().show_part(&mut panel, &part, rgb), Ok(()));
            }
            prop_assert!(panel.pixels == Panel::map(stage.frame()));
        }
    }
}

#[test]
fn an_area_larger_than_displays_are_is_cut() {
    let area = Area { x: usize::MAX, y: 3, width: usize::MAX, height: 5 };
    let cut = Rectangle::new(Point::new(i32::MAX, 3), Size::new(u32::MAX, 5));
    assert_eq!(Rectangle::from(area), cut);
}
