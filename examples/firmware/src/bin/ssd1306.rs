//! A mechanism on a two-tone display of 128 × 64 pixels with an SSD1306, by the driver `ssd1306`.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use display_interface::DisplayError;
use firmware::wiring::Ssd1306 as Wired;
use firmware::{Line, entry, exit};
use mech_runtime::raster::embedded::{Screen, rgb};
use mech_runtime::{Frame, Mechanism, Palette, mechanism};
use panic_halt as _;
use ssd1306::mode::BufferedGraphicsMode;
use ssd1306::prelude::*;
use ssd1306::{I2CDisplayInterface, Ssd1306};

mechanism! {
    /// A crank-rocker in two tones: what is of the colour of paper stays dark, and keeps apart what is lit.
    struct FourBar: f32;
    const LIT = 14; const DARK = 0; // ink and paper
    ground {
        point crank_shaft = (0, 0); point rocker_shaft = (4, 0);
        polygon [(-0.5, -0.7), (0.5, -0.7), (0, 0)] color LIT;
        polygon [(3.5, -0.7), (4.5, -0.7), (4, 0)] color LIT;
    }
    link crank {
        point shaft = (0, 0); point pin = (1, 0);
        bar [(0, 0), (1, 0)] width 0.7 on plane 5 color DARK;
        bar [(0, 0), (1, 0)] width 0.4 on plane 6 color LIT;
    }
    link coupler {
        point crank_pin = (0, 0); point rocker_pin = (3.5, 0);
        bar [(0, 0), (3.5, 0)] width 0.7 on plane 3 color DARK;
        bar [(0, 0), (3.5, 0)] width 0.4 on plane 4 color LIT;
    }
    link rocker {
        point shaft = (0, 0); point pin = (3, 0);
        bar [(0, 0), (3, 0)] width 0.7 on plane 1 color DARK;
        bar [(0, 0), (3, 0)] width 0.4 on plane 2 color LIT;
    }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);
    motor a;
    start { a = 0 deg; rocker near 110 deg; }
}

/// The driver with its picture: a bit a pixel.
type Display<I> = Ssd1306<I, DisplaySize128x64, BufferedGraphicsMode<DisplaySize128x64>>;

/// Paints in the driver's memory, and then sends that.
fn show<I: WriteOnlyDataCommand>(
    four_bar: &FourBar,
    display: &mut Display<I>,
) -> Result<(), DisplayError> {
    let mut screen = Screen::new(display, FourBar::view(128, 64), rgb);
    screen.set_palette(const { &Palette::NIGHT }); // light on dark: `rgb` lights what is light
    screen.clear();
    four_bar.draw(&mut screen);
    screen.finish()?;
    display.flush()
}

#[entry]
fn main() -> ! {
    let wired = Wired::new();
    exit(run(&wired).is_some())
}

/// Moves it through a turn and shows it. Whether that is what a frame shows.
fn run(wired: &Wired) -> Option<()> {
    let interface = I2CDisplayInterface::new(wired.i2c());
    let mut display = Ssd1306::new(interface, DisplaySize128x64, DisplayRotation::Rotate0)
        .into_buffered_graphics_mode();
    display.init().ok()?;

    let mut four_bar = FourBar::new();
    let mut frame = Frame::<128, 64>::new();
    frame.look_at(FourBar::view(128, 64));
    frame.set_palette(Palette::NIGHT);
    let mut right = true;
    for degrees in (0..360_u16).step_by(5) {
        four_bar.move_to([f32::from(degrees).to_radians()]).ok()?;
        wired.sent_bytes();
        show(&four_bar, &mut display).ok()?;

        frame.clear();
        four_bar.draw(&mut frame);
        right &= (0..64).all(|y| (0..128).all(|x| wired.is_lit(x, y) == is_ink(&frame, x, y)));
    }
    Line::new().text("sent").number(wired.sent_bytes()).print().ok()?;
    wired.print();
    right.then_some(())
}

fn is_ink(frame: &Frame<128, 64>, x: usize, y: usize) -> bool {
    frame.pixel(x, y) == Some(Palette::INK)
}
