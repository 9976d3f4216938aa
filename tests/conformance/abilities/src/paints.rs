//! Pictures of every kind, of everything that can be painted, with good numbers and bad ones.

use super::moves::BAD;
use super::recorder::Recorder;
use core::hint::black_box;
use embedded_graphics_core::Pixel;
use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::geometry::{Point, Size};
use embedded_graphics_core::image::ImageDrawable;
use embedded_graphics_core::primitives::Rectangle;
use mech_probes::Listener;
use mech_probes::sum;
use mech_runtime::overlay::{arrow, moment};
use mech_runtime::raster::embedded::{Entry, Screen};
use mech_runtime::raster::{bar, line};
use mech_runtime::{
    Canvas, Frame, Outline, Palette, Pose, Real, Scalar, Smooth, Stage, Trace, View,
};

/// The corners of a star: a polygon that surrounds its middle twice.
const STAR: [[f64; 2]; 5] = [[0.0, 20.0], [12.0, -16.0], [-19.0, 6.0], [19.0, 6.0], [-12.0, -16.0]];

/// Asks for all of it.
pub(super) fn ask(listener: &mut impl Listener) {
    in_precision::<f64>(&mut Recorder::new(listener, "f64"));
    in_precision::<f32>(&mut Recorder::new(listener, "f32"));
    let recorder = &mut Recorder::new(listener, "f32");
    palettes(recorder);
    targets(recorder);
}

fn in_precision<T: Scalar>(recorder: &mut Recorder<impl Listener>) {
    for number in [0.0, 1.0, 7.3, -2.0, 1e4, 1e-9].into_iter().chain(BAD) {
        let number = black_box(number);
        of_size::<T, 96, 64>(recorder, number);
        of_size::<T, 0, 0>(recorder, number);
        of_size::<T, 3, 0>(recorder, number);
        of_size::<T, 0, 3>(recorder, number);
        of_size::<T, 1, 70>(recorder, number);
    }
}

/// Paints on pictures of this size.
fn of_size<T: Scalar, const W: usize, const H: usize>(
    recorder: &mut Recorder<impl Listener>,
    number: f64,
) {
    let fit = View::fit([-20.0, -20.0], [number, 20.0], W, H, black_box(2.0));
    for view in [fit, View::new([number, 0.0], 1.0), View::new([0.0, 0.0], number)] {
        let mut frame = Frame::<W, H>::new();
        frame.look_at(view);
        all::<T>(&mut frame, number);
        let painted = pixels(&frame);
        let pixel = (frame.pixel(black_box(90), 5), frame.rgb(5, black_box(60)));
        recorder.record("frame", &(painted, pixel));

        let mut smooth = Smooth::<W, H>::new();
        smooth.look_at(view);
        all::<T>(&mut smooth, number);
        let painted = sum(smooth.pixels().iter().flatten().flatten().copied().map(u16::from));
        recorder.record("smooth", &(painted, smooth.pixel(black_box(5), 60)));

        let mut display = Frame::<80, 50>::new();
        let mut screen = Screen::new(&mut display, view, mixed);
        screen.clear();
        all::<T>(&mut screen, number);
        let Ok(()) = screen.finish();
        recorder.record("screen", &pixels(&display));
        let Ok(()) = frame.show(&mut display, mixed);
        recorder.record("shown", &pixels(&display));
    }
    staged::<T, W, H>(recorder, number, fit);
}

/// What stands still, what moves, and more than there is account of.
fn staged<T: Scalar, const W: usize, const H: usize>(
    recorder: &mut Recorder<impl Listener>,
    number: f64,
    view: View,
) {
    let mut display = Frame::<80, 50>::new();
    let mut stage = Stage::<W, H, 20>::new();
    stage.set_palette(Palette::TEXTBOOK);
    stage.look_at(view);
    for moment in [0.0, 0.0, 1.0, 3.0, 3.5, number] {
        stage.show(|pass| {
            all::<T>(pass, 1.0);
            for place in [moment, -moment, moment * moment] {
                let [center, [radius, _]] =
                    [[place; 2], [3.0; 2]].map(|pair| pair.map(<T as Real>::from_f64));
                pass.fill(Outline::Circle { center, radius }, Pose::identity(), 3);
                pass.text(center, "it moves", 4);
            }
        });
        for area in stage.changed() {
            recorder.record("changed", &area);
            let corner = [area.x, area.y].map(|at| i32::try_from(at).unwrap_or(i32::MAX));
            let size =
                [area.width, area.height].map(|side| u32::try_from(side).unwrap_or(u32::MAX));
            let part = Rectangle::new(corner.into(), size.into());
            let Ok(()) = stage.frame().show_part(&mut display, &part, mixed);
        }
        recorder.record("stage", &(pixels(stage.frame()), pixels(&display)));
    }
}

/// Paints one of everything.
fn all<T: Scalar>(canvas: &mut impl Canvas<T>, number: f64) {
    let at = |pair: [f64; 2]| pair.map(<T as Real>::from_f64);
    let [_, size] = at([0.0, number]);
    let star = STAR.map(at);
    let far = [at([number, -number]), at([-number, 3.0]), at([5.0, number])];
    let turned = Pose {
        cos: <T as Real>::from_f64(0.8),
        sin: <T as Real>::from_f64(0.6),
        x: size,
        y: T::ONE,
    };
    for (pose, center) in [(Pose::identity(), at([3.0, 2.0])), (turned, at([number, 1.0]))] {
        let radius = <T as Real>::from_f64(6.0);
        for outline in [
            Outline::Circle { center, radius },
            Outline::Circle { center, radius: size },
            Outline::Ring { center, radius, hole: size },
            Outline::Ring { center, radius: size, hole: T::ONE },
            Outline::Polygon(&star),
            Outline::Winding(&star),
            Outline::Polygon(&far),
            Outline::Winding(&far),
            Outline::Polygon(&[]),
            Outline::Line { points: &star, width: T::ONE + T::ONE },
            Outline::Line { points: &far, width: size },
            Outline::Line { points: &[center], width: radius },
            Outline::Line { points: &[], width: radius },
            Outline::Arc { center, start: at([9.0, 4.0]), angle: size, width: radius },
            Outline::Arc { center, start: at([9.0, number]), angle: T::TURN, width: T::ONE },
            Outline::Arc { center, start: center, angle: -T::ONE, width: size },
        ] {
            canvas.fill(outline, pose, black_box(5));
        }
        bar(canvas, &star, pose, <T as Real>::from_f64(3.0), Palette::TEAL);
        canvas.text(center, black_box("Ag 7°: ±½λ ✓\n"), Palette::INK);
    }
    line(canvas, [at([number, 0.0]), at([-20.0, 3.0])], size, Palette::RED);
    let thickness = f32::from_f64(number);
    arrow(canvas, [at([number, 0.0]), at([-20.0, 3.0])], thickness, Palette::BLUE);
    moment(canvas, at([number, 0.0]), true, thickness, 1.0, Palette::BLUE);
    moment(canvas, at([0.0, 1.0]), false, 12.0, thickness, Palette::BLUE);
    let mut trace = Trace::<T, 40>::new();
    for place in 0..50_u8 {
        let place = f64::from(place);
        trace.push(at([place, if place == 20.0 { number } else { place / 3.0 }]));
    }
    trace.draw(canvas, Palette::PURPLE);
    Trace::<T, 0>::new().draw(canvas, Palette::PURPLE);
}

fn palettes(recorder: &mut Recorder<impl Listener>) {
    let mut palette = Palette::TEXTBOOK;
    for entry in 0..=u8::MAX {
        let entry = black_box(entry);
        let kinds = [Palette::darker(entry), Palette::lighter(entry), Palette::shade(entry, entry)];
        palette = palette.with(entry, kinds);
        recorder.record("palette", &(kinds, palette.rgb(entry), palette.rgba(entry)));
    }
    let frame = Frame::<4, 4>::new();
    let entries: [[u8; 3]; 256] = *frame.palette().entries();
    recorder.record("palette", &entries);
}

/// A check sum of all pixels.
fn pixels<const W: usize, const H: usize>(frame: &Frame<W, H>) -> u64 {
    sum(frame.pixels().iter().flatten().copied().map(u16::from))
}

/// A colour of a display that is a frame itself.
const fn mixed([red, green, blue]: [u8; 3]) -> Entry {
    Entry(red ^ green.rotate_left(3) ^ blue.rotate_left(5))
}

/// Frames that embedded-graphics draws on, and that are drawn as images.
fn targets(recorder: &mut Recorder<impl Listener>) {
    let mut frame = Frame::<40, 30>::new();
    let mut display = Frame::<80, 50>::new();
    let far = [i32::MIN, -3, 7, i32::MAX];
    for (x, y) in far.into_iter().flat_map(|x| far.map(|y| (x, y))) {
        let corner = Point::new(black_box(x), black_box(y));
        for size in [[0, 0], [5, 9], [u32::MAX, 20], [u32::MAX, u32::MAX]] {
            let area = Rectangle::new(corner, Size::from(size));
            let Ok(()) = frame.fill_solid(&area, Entry(3));
            // As many as a display of usual size takes.
            let colors = (0..2000_u16).map(|number| Entry(number.to_le_bytes()[0]));
            let Ok(()) = frame.fill_contiguous(&area, colors);
            let Ok(()) = frame.draw_iter([Pixel(corner, Entry(9))]);
            let Ok(()) = frame.show_part(&mut display, &area, mixed);
            let picture = frame.image(mixed);
            let Ok(()) = picture.draw_sub_image(&mut display, &area);
            let Ok(()) = picture.draw(&mut display);
            recorder.record("target", &(pixels(&frame), pixels(&display)));
        }
    }
    let Ok(()) = DrawTarget::clear(&mut frame, Entry(black_box(7)));
    recorder.record("target", &pixels(&frame));
}
