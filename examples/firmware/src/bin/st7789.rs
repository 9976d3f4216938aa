//! A mechanism on a display of 240 × 240 pixels with an ST7789, by the driver `mipidsi`.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use embedded_graphics_core::draw_target::DrawTarget;
use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
use firmware::wiring::{Quiet, St7789};
use firmware::{Line, entry, exit};
use mech_runtime::raster::embedded::{Screen, rgb};
use mech_runtime::{Frame, Mechanism, Stage, View, mechanism};
use mipidsi::interface::SpiInterface;
use mipidsi::options::ColorInversion;
use mipidsi::{Builder, models};
use panic_halt as _;

mechanism! {
    /// A crank drives a slide.
    struct SliderCrank: f32;
    const BLUE = 2; const ORANGE = 3; const TEAL = 4; const INK = 14;
    ground {
        point shaft = (0, 0); line guide = (0, 0) -> (1, 0);
        polygon [(1.5, -0.9), (6.5, -0.9), (6.5, 0.9), (1.5, 0.9)];
        ring (0, 0) radius 1.5 hole 1.4;
    }
    link crank { point shaft = (0, 0); point pin = (1, 0); bar [(0, 0), (1, 0)] width 0.4 on plane 3 color BLUE; }
    link rod { point big = (0, 0); point small = (4, 0); bar [(0, 0), (4, 0)] width 0.3 on plane 2 color ORANGE; }
    link slide {
        point pin = (0, 0); line axis = (0, 0) -> (1, 0);
        polygon [(-0.6, -0.8), (0.6, -0.8), (0.6, 0.8), (-0.6, 0.8)] on plane 1 color TEAL;
        circle (0, 0) radius 0.2 on plane 4 color INK;
    }
    joint turn = revolute(ground.shaft, crank.shaft);
    joint big = revolute(crank.pin, rod.big);
    joint small = revolute(rod.small, slide.pin);
    joint stroke = prismatic(ground.guide, slide.axis);
    motor turn;
    start { turn = 0 deg; rod near 0 deg; }
}

/// Where all of its motion fits on the display.
fn view() -> View {
    SliderCrank::view(240, 240)
}

/// Paints on the display itself, which needs no memory for pixels. What is painted over is seen for a moment.
fn paint<D: DrawTarget<Color = Rgb565>>(
    slider_crank: &SliderCrank,
    display: &mut D,
) -> Result<(), D::Error> {
    let mut screen = Screen::new(display, view(), rgb);
    screen.clear();
    slider_crank.draw(&mut screen);
    screen.finish()
}

/// Paints in memory and sends the rectangles in which something has moved.
fn send<D: DrawTarget<Color = Rgb565>>(
    slider_crank: &SliderCrank,
    stage: &mut Stage<240, 240>,
    display: &mut D,
) -> Result<(), D::Error> {
    stage.show(|canvas| slider_crank.draw(canvas));
    for area in stage.changed() {
        stage.frame().show_part(display, &area.into(), rgb)?;
    }
    Ok(())
}

#[entry]
fn main() -> ! {
    let wired = St7789::new();
    exit(run(&wired).is_some())
}

/// Moves it through a turn and shows it both ways. Whether that is what a frame shows.
fn run(wired: &St7789) -> Option<()> {
    let mut buffer = [0; 512]; // the driver's, for pixels on their way: at least one of two bytes
    let mut display =
        Builder::new(models::ST7789, SpiInterface::new(wired.spi(), wired.data_pin(), &mut buffer))
            .reset_pin(Quiet)
            .display_size(240, 240) // the controller has memory for 240 × 320
            .invert_colors(ColorInversion::Inverted) // as most of these panels want it
            .init(&mut Quiet)
            .ok()?;

    let mut slider_crank = SliderCrank::new();
    let mut stage = Stage::new();
    stage.look_at(view());
    let mut frame = Frame::<240, 240>::new();
    frame.look_at(view());

    let mut right = true;
    let (mut painted, mut sent) = (0, 0);
    for degrees in (0..360_u16).step_by(5) {
        slider_crank.move_to([f32::from(degrees).to_radians()]).ok()?;
        frame.clear();
        slider_crank.draw(&mut frame);

        wired.sent_bytes();
        if degrees % 90 == 0 {
            paint(&slider_crank, &mut display).ok()?;
            right &= shows(wired, &frame);
            painted += wired.sent_bytes();
        }
        send(&slider_crank, &mut stage, &mut display).ok()?;
        right &= shows(wired, &frame);
        sent += wired.sent_bytes();
    }
    let mut line = Line::new();
    line.text("painted").number(painted / 4).text(" sent").number(sent / 72);
    line.print().ok()?;
    wired.print();
    right.then_some(())
}

/// Whether the display shows the frame.
fn shows(wired: &St7789, frame: &Frame<240, 240>) -> bool {
    (0..240).all(|y| {
        (0..240).all(|x| {
            let color = frame.rgb(x, y).map(rgb::<Rgb565>);
            color.is_some_and(|color| {
                let bits =
                    u16::from(color.r()) << 11 | u16::from(color.g()) << 5 | u16::from(color.b());
                wired.pixel(x, y) == bits
            })
        })
    })
}
