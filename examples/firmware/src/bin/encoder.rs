//! A mechanism that follows an encoder on its crank.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

use firmware::wiring::Counter;
use firmware::{Line, entry, exit};
use mech_runtime::{Blocked, Phase, mechanism};
use panic_never as _;

mechanism! {
    /// A crank-rocker.
    struct FourBar: f32;
    ground { point crank_shaft = (0, 0); point rocker_shaft = (4, 0); }
    link crank { point shaft = (0, 0); point pin = (1, 0); }
    link coupler { point crank_pin = (0, 0); point rocker_pin = (3.5, 0); point tip = (1.75, 1.5); }
    link rocker { point shaft = (0, 0); point pin = (3, 0); }
    joint a = revolute(ground.crank_shaft, crank.shaft);
    joint b = revolute(crank.pin, coupler.crank_pin);
    joint c = revolute(coupler.rocker_pin, rocker.pin);
    joint d = revolute(ground.rocker_shaft, rocker.shaft);
    motor a;
    start { a = 0 deg; rocker near 110 deg; }
    show coupler.tip, d;
}

/// A quadrature encoder, read by a counter of sixteen bits.
struct Encoder {
    counter: u16,
    counts: i64,
}

impl Encoder {
    /// Counts in a turn: four edges for each of a thousand lines.
    const TURN: i64 = 4 * 1000;
    /// What one of them is, computed by the compiler.
    const COUNT: Phase = Phase::of_turn(1, Self::TURN.unsigned_abs()).unwrap();

    /// Begins to count where the counter is: at the encoder's index mark, or wherever the crank is at the angle zero.
    const fn new(counter: u16) -> Self {
        Self { counter, counts: 0 }
    }

    /// Takes a reading: at least one in 32,767 counts, so that it is seen which way the counter has gone around.
    fn take(&mut self, counter: u16) {
        let moved = counter.wrapping_sub(self.counter).cast_signed();
        self.counter = counter;
        self.counts = self.counts.wrapping_add(moved.into());
    }

    /// Where the crank is, in whole numbers: nothing is lost however far it has turned.
    fn phase(&self) -> Phase {
        let turns = self.counts.div_euclid(Self::TURN);
        let remainder = self.counts.rem_euclid(Self::TURN);
        Phase::new(turns, 0) + Self::COUNT * remainder
    }
}

/// The same for a count in 4,096ths of a turn: shifts suffice.
const fn of_4096ths(counts: i64) -> Phase {
    Phase::new(counts >> 12, counts.cast_unsigned() << 52)
}

/// Follows the encoder.
fn follow(
    four_bar: &mut FourBar,
    encoder: &mut Encoder,
    counter: u16,
) -> Result<(), Blocked<[f32; 1]>> {
    encoder.take(counter);
    four_bar.turn_to([encoder.phase()])
}

#[entry]
fn main() -> ! {
    exit(run().is_some())
}

/// Two hundred thousand readings of a crank that turns backwards, fast: more than a million turns. Whether it is then where a mechanism is
/// that was turned by the remainder of a turn only.
fn run() -> Option<()> {
    const READINGS: u32 = 200_000;
    const SPEED: i16 = -27_001;
    let mut counter = Counter::new(SPEED);
    let mut encoder = Encoder::new(0);
    let mut four_bar = FourBar::new();
    for _ in 0..READINGS {
        follow(&mut four_bar, &mut encoder, counter.read()).ok()?;
    }

    let remainder = (i64::from(READINGS) * i64::from(SPEED)).rem_euclid(4000);
    let mut there = FourBar::new();
    there.turn_to([Phase::of_turn(remainder, Encoder::TURN.unsigned_abs())?]).ok()?;
    let turns = encoder.phase().turns().unsigned_abs();
    let micro = |length: f32| (length * 1e6) as i32 as u32;
    let tip = four_bar.coupler_tip();
    let mut line = Line::new();
    line.text("turns").number(turns as u32);
    line.text(" tip").number(micro(tip.x)).number(micro(tip.y));
    line.print().ok()?;
    let right = Phase::of_turn(-5000, 4096)? == of_4096ths(-5000);
    (right && tip == there.coupler_tip() && four_bar.d() == there.d()).then_some(())
}
