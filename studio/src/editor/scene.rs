//! The mechanism in motion, and how it is seen.

use super::Editor;
use crate::editor::bounds_of;
use crate::editor::by_hand::Hand;
use crate::editor::drawing::Drawing;
use crate::editor::path::Path;
use crate::editor::range::MotorRange;
use crate::editor::settings::View;
use crate::play::{Camera, Control, Mechanism, Player};
use std::sync::Arc;

impl Editor {
    /// Plays the mechanism of the present text, with its motors where they were.
    pub(super) fn play(&mut self, mechanism: Mechanism, ranges: Vec<MotorRange>, paths: Vec<Path>) {
        if let Some(player) = &mut self.player {
            player.replace(mechanism);
        } else {
            let mut player = Player::new(mechanism, Vec::new(), self.camera.size());
            player.obey(Control::PlayOrPause);
            self.player = Some(player);
        }
        self.ranges = ranges;
        self.paths = paths;
        self.pose();
        if self.settings.view == View::Started {
            self.settings.view = View::Users;
            self.fit();
        }
    }

    /// Plays no more.
    pub(super) fn stop(&mut self) {
        self.player = None;
        self.ranges.clear();
        self.paths.clear();
        self.by_hand.clear();
    }

    /// Notes where the motors are, before somebody moves them by hand.
    fn note_motors(&mut self, hand: Hand) {
        if let Some(player) = &self.player {
            self.by_hand.note(hand, player.motors());
        }
    }

    /// Takes the link under a pixel of the canvas, so that it follows the pointer.
    pub(in crate::editor) fn hold(&mut self, pixel: [f64; 2]) {
        self.note_motors(Hand::Link);
        if let Some(player) = &mut self.player {
            player.look(&self.camera);
        }
        self.obey(Control::Press(pixel));
    }

    /// Whether something was moved by hand since the text changed.
    pub(in crate::editor) fn is_moved_by_hand(&self) -> bool {
        !self.by_hand.is_empty()
    }

    /// Takes back the last motion by hand since the text changed. Returns whether there was one.
    pub(super) fn take_back_motion(&mut self) -> bool {
        self.obey(Control::Release);
        while let (Some(before), Some(player)) = (self.by_hand.pop(), &mut self.player) {
            if before == player.motors() {
                continue;
            }
            for (motor, value) in before.into_iter().enumerate() {
                player.drive(motor, value);
            }
            self.pose();
            return true;
        }
        false
    }

    /// Whether the player has the mechanism of the present text.
    pub(in crate::editor) fn is_played_present(&self) -> bool {
        self.played
            .as_ref()
            .is_some_and(|played| Arc::ptr_eq(played, &self.snapshot))
    }

    /// Puts the links of the drawing where the player has them.
    pub(in crate::editor) fn pose(&mut self) {
        let is_played = |drawn| {
            self.played
                .as_ref()
                .is_some_and(|played| Arc::ptr_eq(played, drawn))
        };
        if let (Some(player), Some(drawing)) = (&self.player, &mut self.drawing)
            && self.drawn.as_ref().is_some_and(is_played)
        {
            drawing.set_poses(player.mechanism().poses());
        }
    }

    /// Lets time pass, in seconds.
    pub fn advance(&mut self, seconds: f64) {
        if self.drag.is_nothing()
            && let Some(player) = &mut self.player
        {
            player.advance(seconds);
            self.pose();
        }
    }

    /// Gives the player a control.
    pub fn obey(&mut self, control: Control) {
        if let Some(player) = &mut self.player {
            player.obey(control);
            self.pose();
        }
    }

    /// Moves a motor, by its number, to a value in radians or scene units.
    pub fn scrub(&mut self, motor: usize, value: f64) {
        self.note_motors(Hand::Motor(motor));
        if let Some(player) = &mut self.player {
            player.drive(motor, value);
            self.pose();
        }
    }

    /// The values of motors at which the mechanism is seen, in degrees or scene units; none at the start.
    pub(in crate::editor) fn seen_at(&self) -> Option<Vec<(String, f64)>> {
        let mechanism = self.player.as_ref()?.mechanism();
        if mechanism.is_at_start() {
            return None;
        }
        Some(mechanism.shown_motors())
    }

    /// Sees everything.
    pub fn fit(&mut self) {
        let moving = self
            .player
            .as_ref()
            .map(|player| player.mechanism().bounds());
        // A single pivot is seen with room around it.
        let mut places = self
            .drawing
            .iter()
            .flat_map(Drawing::handles)
            .map(|handle| handle.place);
        let first = places.next();
        let moving = moving.filter(|_| places.any(|place| Some(place) != first));
        let bounds = moving.unwrap_or_else(|| bounds_of(self.drawing.as_ref()));
        self.camera = Camera::new(bounds, self.camera.size());
    }
}
