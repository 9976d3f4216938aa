//! A player that is told anything, in any order, with any numbers: it plays on, and shows numbers only.

use crate::gallery::{FILES, SIZE, mechanism};
use mech_studio::play::{Control, Layer, Painter, Player};
use std::ops::Range;

/// Random numbers that are the same in every run.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> u64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        self.0 >> 33
    }

    fn below(&mut self, count: u64) -> usize {
        usize::try_from(self.next() % count).unwrap_or(0)
    }

    fn number(&mut self) -> f64 {
        const BAD: [f64; 10] = [
            f64::NAN,
            f64::INFINITY,
            f64::NEG_INFINITY,
            f64::MAX,
            -1e300,
            1e19,
            1e9,
            -1e5,
            f64::MIN_POSITIVE,
            0.0,
        ];
        match self.below(4) {
            0 => BAD[self.below(10)],
            _ => f64::from(u32::try_from(self.next() % 100_000).unwrap_or(0)) / 100.0 - 300.0,
        }
    }

    fn control(&mut self) -> Control {
        const SIDES: [usize; 5] = [0, 1, 37, 480, 5000];

        let pixel = [self.number(), self.number()];
        match self.below(18) {
            0 => Control::PlayOrPause,
            1 => Control::Step(self.number()),
            2 => Control::Reverse,
            3 => Control::Faster,
            4 => Control::Slower,
            5 => Control::NextMotor,
            6 => Control::PreviousMotor,
            7 => Control::Toggle(Layer::ALL[self.below(7)]),
            8 => Control::DayOrNight,
            9 if self.below(8) == 0 => Control::NextMechanism,
            10 if self.below(8) == 0 => Control::PreviousMechanism,
            11 if self.below(8) == 0 => Control::Reset,
            12 => Control::Fit,
            13 => Control::Press(pixel),
            14 => Control::Point(pixel),
            15 => Control::Release,
            16 => Control::Zoom(pixel, self.number()),
            17 => Control::Resize([SIDES[self.below(5)], SIDES[self.below(5)]]),
            _ => Control::Press([240.0 + self.number() / 10.0, 180.0 + self.number() / 10.0]),
        }
    }
}

#[test]
fn a_player_takes_any_command_and_plays_on() {
    take_anything(0..12);
}

/// A test of its own, so that both run at once.
#[test]
fn another_player_does_too() {
    take_anything(12..24);
}

fn take_anything(seeds: Range<u64>) {
    let mut painter = Painter::new(SIZE).expect("it is small");
    for seed in seeds {
        let mut dice = Dice(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15));
        // Three of the gallery, one of which may be large.
        let mut some = (0..3).map(|_| mechanism(FILES[dice.below(FILES.len() as u64)]));
        let first = some.next().expect("there are three");
        let mut player = Player::new(first, some.collect(), SIZE);
        for turn in 0..60 {
            let control = dice.control();
            let title = player.title().to_owned();
            let before = player.motors().to_vec();
            if let Control::Toggle(layer) = control {
                player.prepare(layer);
            }
            player.obey(control);
            if let Control::Step(steps) = control {
                // As far as a whole motion, however many steps are wanted.
                let far =
                    player.motors().iter().zip(&before).any(|(to, from)| (to - from).abs() > 1e3);
                assert!(!far, "{steps} steps: {:?}", player.motors());
            }
            player.advance(dice.number());
            let motors = player.motors();
            assert!(
                motors.iter().all(|motor| motor.is_finite()),
                "{title}, {control:?}: {motors:?}"
            );
            let view = player.camera().view();
            assert!(view.scale().is_finite() && view.center().iter().all(|part| part.is_finite()));
            assert!(!player.status().contains("NaN"), "{}", player.status());
            if turn % 6 == 0 {
                let picture = painter.paint(&player).expect("there is memory");
                let [width, height] = player.camera().size();
                assert_eq!(picture.pixels().len(), width * height);
            }
        }
        // Whatever was, it goes on from its start.
        player.obey(Control::Release);
        player.obey(Control::Resize(SIZE));
        player.obey(Control::Reset);
        player.obey(Control::Fit);
        let start = player.motors().to_vec();
        if !player.plays() {
            player.obey(Control::PlayOrPause);
        }
        player.advance(0.05);
        assert_ne!(player.motors(), start, "seed {seed}");
    }
}
