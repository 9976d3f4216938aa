//! The state of a player, without a window, a terminal or a clock.

use crate::limit::coordinate;
use crate::{Camera, Command, Drive, Driver, Grip, Limit, Pace, marks};
use mech_gallery::{Error, Exhibit, Film, Layers, Look, Playable, Scene, Spot};
use mech_runtime::{Blocked, Reached};
use std::f64::consts::TAU;

/// The number of single steps in a whole motion. Playing never moves farther at once.
const STEPS: f64 = 120.0;
/// The longest time by which playing advances at once, in seconds.
const LONGEST: f64 = 0.1;
/// The greatest distance from a link at which a press holds it, in pixels of a picture of usual size.
const NEAR: f64 = 14.0;
/// The shorter side of a picture of usual size.
const USUAL: f64 = 560.0;
/// The length of arrows, relative to the crank: for a point that turns round its crank once in a whole motion.
const ARROW: f64 = 0.5;

/// Plays with the exhibits of a gallery, one at a time.
pub struct Player {
    exhibits: Vec<Box<dyn Exhibit>>,
    index: usize,
    mechanism: Box<dyn Playable>,
    driver: Driver,
    pace: Pace,
    plays: bool,
    limit: Option<Limit>,
    held: Option<Held>,
    layers: Layers,
    is_night: bool,
    camera: Camera,
    notice: Option<String>,
}

/// The thing that the pointer holds.
#[derive(Clone, Copy)]
enum Held {
    /// A link.
    Link { grip: Grip, aim: [f64; 2] },
    /// The paper, at the last pixel of the pointer.
    Paper([f64; 2]),
}

impl Player {
    /// A player that shows one of the exhibits in a picture of this size.
    ///
    /// # Errors
    /// [`Error::Stuck`] if it cannot make its own motion. [`Error::Invisible`] if it is never visible, or if there is no such exhibit.
    pub fn new(
        exhibits: Vec<Box<dyn Exhibit>>,
        index: usize,
        size: [usize; 2],
    ) -> Result<Self, Error> {
        let exhibit = exhibits.get(index).ok_or(Error::Invisible)?;
        let mechanism = exhibit.playable();
        let bounds = exhibit.film()?.bounds().ok_or(Error::Invisible)?;
        Ok(Self {
            driver: Driver::new(mechanism.as_ref(), exhibit.seconds()),
            layers: exhibit.layers(),
            camera: Camera::new(bounds, size),
            mechanism,
            exhibits,
            index,
            pace: Pace::default(),
            plays: true,
            limit: None,
            held: None,
            is_night: false,
            notice: None,
        })
    }

    /// Obeys a command. The front end obeys those for help, saving and stopping.
    pub fn obey(&mut self, command: Command) {
        if !matches!(command, Command::Point(_) | Command::Resize(_)) {
            self.notice = None;
        }
        match command {
            Command::PlayOrPause => self.plays = !self.plays,
            Command::Step(steps) => {
                self.plays = false;
                if steps.is_finite() {
                    self.travel((steps / STEPS).clamp(-1.0, 1.0));
                }
            }
            Command::Reverse => self.pace.reverse(),
            Command::Faster => self.pace.faster(),
            Command::Slower => self.pace.slower(),
            Command::NextMotor => self.driver.next(),
            Command::PreviousMotor => self.driver.previous(),
            Command::Toggle(layer) if self.mechanism.offers(layer) => self.layers.toggle(layer),
            Command::Toggle(layer) => {
                self.notice = Some(format!("{} has no {}", self.title(), layer.name()));
            }
            Command::DayOrNight => self.is_night = !self.is_night,
            Command::NextExhibit => self.show(self.index + 1),
            Command::PreviousExhibit => self.show(self.index + self.exhibits.len() - 1),
            Command::Reset => self.reset(),
            Command::Fit => self.camera.fit(),
            Command::Press([x, y]) | Command::Point([x, y])
                if !(x.is_finite() && y.is_finite()) => {}
            Command::Press(pixel) => self.press(pixel),
            Command::Point(pixel) => self.point(pixel),
            Command::Release => self.held = None,
            Command::Zoom(pixel, factor) => self.camera.zoom(pixel, factor),
            Command::Resize(size) => self.camera.resize(size),
            Command::Help | Command::Save | Command::Quit => {}
        }
        self.keep_in_view();
    }

    /// Plays for a time in seconds.
    pub fn advance(&mut self, seconds: f64) {
        let is_held = matches!(self.held, Some(Held::Link { .. }));
        if !self.plays || is_held || !seconds.is_finite() {
            return;
        }
        let seconds = seconds.clamp(0.0, LONGEST);
        let share = self.pace.direction() * self.pace.speed() * seconds / self.driver.seconds();
        if !self.travel(share) {
            self.plays = false;
        }
        self.keep_in_view();
    }

    /// The present scene.
    #[must_use]
    pub fn scene(&self) -> Scene {
        let mut scene = Scene::new(self.camera.view().scale());
        let size = self.symbol_size();
        self.mechanism.draw(&mut scene, &self.look());
        if let Some(limit) = &self.limit {
            for (place, is_motor) in limit.places(self.mechanism.as_ref()) {
                marks::ring(&mut scene, place, size);
                if is_motor {
                    marks::ring(&mut scene, place, 1.6 * size);
                }
            }
        }
        if let Some(Held::Link { grip, aim }) = self.held
            && let Some(place) = self.mechanism.place(grip.spot)
        {
            marks::band(&mut scene, [place, aim], size);
        }
        scene
    }

    /// The name of the exhibit on the command line.
    #[must_use]
    pub fn slug(&self) -> &'static str {
        self.exhibit().map_or("", |exhibit| exhibit.slug())
    }

    /// The title of the exhibit.
    #[must_use]
    pub fn title(&self) -> &'static str {
        self.exhibit().map_or("", |exhibit| exhibit.title())
    }

    /// The motors' values, what is driven, and the speed; or the limit.
    #[must_use]
    pub fn status(&self) -> String {
        if let Some(notice) = &self.notice {
            return notice.clone();
        }
        let mechanism = self.mechanism.as_ref();
        if let Some(limit) = &self.limit {
            return limit.sentence(mechanism);
        }
        let values = self.mechanism.motors();
        let values = self.mechanism.motor_names().iter().zip(values);
        let values = values.map(|(name, value)| {
            let value = coordinate(mechanism, name, value);
            format!("{name} {value}")
        });
        let values: Vec<_> = values.collect();
        let drive = match self.driver.drive() {
            Drive::Motion => "own motion",
            Drive::Motor(motor) => mechanism.motor_names().get(motor).copied().unwrap_or(""),
        };
        let state = match (self.plays, self.pace.direction() < 0.0) {
            (false, _) => "paused",
            (true, false) => "playing",
            (true, true) => "playing backwards",
        };
        let speed = self.pace.speed();
        format!("{} · {state} {drive} ×{speed}", values.join(", "))
    }

    /// Shows a notice in place of the status until the next command.
    pub fn notify(&mut self, notice: String) {
        self.notice = Some(notice);
    }

    /// The values of the motors, in the order of their declaration, in radians or scene units.
    #[must_use]
    pub fn motors(&self) -> Vec<f64> {
        self.mechanism.motors()
    }

    /// The pixel at which a place on a link is seen.
    #[must_use]
    pub fn pixel(&self, spot: Spot) -> Option<[f64; 2]> {
        Some(self.camera.pixel(self.mechanism.place(spot)?))
    }

    /// The held place on a link.
    #[must_use]
    pub const fn held_spot(&self) -> Option<Spot> {
        match self.held {
            Some(Held::Link { grip, .. }) => Some(grip.spot),
            _ => None,
        }
    }

    /// Whether it plays.
    #[must_use]
    pub const fn plays(&self) -> bool {
        self.plays
    }

    /// The limit at which it is.
    #[must_use]
    pub const fn limit(&self) -> Option<&Limit> {
        self.limit.as_ref()
    }

    /// The motors that are driven.
    #[must_use]
    pub const fn drive(&self) -> Drive {
        self.driver.drive()
    }

    /// The visible layers.
    #[must_use]
    pub const fn layers(&self) -> Layers {
        self.layers
    }

    /// Whether it is painted in the colours of the night.
    #[must_use]
    pub const fn is_night(&self) -> bool {
        self.is_night
    }

    /// The camera.
    #[must_use]
    pub const fn camera(&self) -> &Camera {
        &self.camera
    }

    /// The present exhibit. There is always one.
    fn exhibit(&self) -> Option<&dyn Exhibit> {
        self.exhibits.get(self.index).map(AsRef::as_ref)
    }

    /// Shows another exhibit; the first follows the last. If it cannot be shown, the present one stays.
    fn show(&mut self, index: usize) {
        let index = index % self.exhibits.len().max(1);
        let exhibits = std::mem::take(&mut self.exhibits);
        let other = exhibits.get(index).map(|exhibit| {
            let bounds = exhibit.film()?.bounds().ok_or(Error::Invisible)?;
            Ok((
                exhibit.playable(),
                exhibit.seconds(),
                exhibit.layers(),
                bounds,
            ))
        });
        self.exhibits = exhibits;
        match other {
            Some(Ok((mechanism, seconds, layers, bounds))) => {
                self.driver = Driver::new(mechanism.as_ref(), seconds);
                self.mechanism = mechanism;
                self.layers = layers;
                self.camera = Camera::new(bounds, self.camera.size());
                self.index = index;
                self.plays = true;
                self.reset();
            }
            Some(Err(error)) => self.notice = Some(Error::to_string(&error)),
            None => {}
        }
    }

    /// Returns everything to the start.
    fn reset(&mut self) {
        self.mechanism.reset();
        self.driver.reset();
        self.pace = Pace::default();
        self.limit = None;
        self.held = None;
    }

    /// Moves by a share of a whole motion in single steps. Returns whether it arrived.
    fn travel(&mut self, share: f64) -> bool {
        let steps = (share.abs() * STEPS).ceil().max(1.0);
        let mut left = steps;
        while left > 0.0 {
            if !self.step(share / steps) {
                return false;
            }
            left -= 1.0;
        }
        true
    }

    /// Moves by a share of a whole motion at once. Returns whether it arrived.
    fn step(&mut self, share: f64) -> bool {
        let motors = self.mechanism.motors();
        let target = self.driver.target(self.mechanism.as_ref(), share);
        let rates = self.driver.rates(self.mechanism.as_ref(), share.signum());
        let result = self.mechanism.move_toward(&target, &rates);
        if matches!(result, Ok(Reached::Target)) {
            self.driver.note_progress(share);
        }
        !self.settle(result, &motors, &target)
    }

    /// Notes the limit at which a move ended. Returns whether there is one.
    fn settle(
        &mut self,
        result: Result<Reached<Vec<f64>>, Blocked<Vec<f64>>>,
        from: &[f64],
        target: &[f64],
    ) -> bool {
        let blocked = match result {
            Ok(Reached::Target) => {
                // A mechanism that does not move stays at the limit.
                if self.mechanism.motors() != from {
                    self.limit = None;
                }
                return false;
            }
            Ok(Reached::Limit(blocked)) | Err(blocked) => blocked,
        };
        let pairs = from.iter().zip(target).enumerate();
        let moved = pairs.filter(|(_, (from, target))| from != target);
        let motors = moved.map(|(motor, _)| motor).collect();
        self.limit = Some(Limit { blocked, motors });
        true
    }

    /// Takes hold of the link or the paper at a pixel.
    fn press(&mut self, pixel: [f64; 2]) {
        let aim = self.camera.place(pixel);
        let near = (NEAR * f64::from(self.symbol_size()).max(0.5)) / self.camera.view().scale();
        self.held = Some(match self.mechanism.spot_at(aim, near) {
            Some(spot) => Held::Link {
                grip: Grip { spot },
                aim,
            },
            None => Held::Paper(pixel),
        });
    }

    /// Moves the held link or paper.
    fn point(&mut self, pixel: [f64; 2]) {
        match self.held {
            Some(Held::Link { grip, .. }) => {
                let aim = self.camera.place(pixel);
                self.held = Some(Held::Link { grip, aim });
                self.drag(grip, aim);
            }
            Some(Held::Paper(last)) => {
                self.camera.pan([pixel[0] - last[0], pixel[1] - last[1]]);
                self.held = Some(Held::Paper(pixel));
            }
            None => {}
        }
    }

    /// Lets a link follow the pointer.
    fn drag(&mut self, grip: Grip, aim: [f64; 2]) {
        let free = self.driver.free();
        let from = self.mechanism.motors();
        let result = grip.follow(self.mechanism.as_mut(), &free, aim);
        // The limit names all motors that could have moved.
        let target = vec![f64::NAN; from.len()];
        let _ = self.settle(result, &from, &target);
        if let Some(limit) = &mut self.limit {
            limit
                .motors
                .retain(|motor| free.iter().any(|free| free.motor == *motor));
        }
    }

    /// Zooms out where the mechanism would leave the picture, but not while a link is held, which must stay at the pointer.
    fn keep_in_view(&mut self) {
        if self.held.is_some() {
            return;
        }
        // In a scene of infinite scale, symbols have no size.
        let mut film = Film::new(f64::INFINITY);
        film.add(|scene| self.mechanism.draw(scene, &self.look()));
        if let Some(bounds) = film.bounds() {
            self.camera.include(bounds);
        }
    }

    /// The layers, and the sizes of symbols and arrows.
    fn look(&self) -> Look {
        // One motion per second counts as a rate of one turn per second.
        let rate = TAU / self.driver.seconds();
        Look {
            layers: self.layers,
            size: self.symbol_size(),
            velocity: ARROW / rate,
            acceleration: ARROW / (rate * rate),
        }
    }

    /// The size of symbols relative to the usual one.
    fn symbol_size(&self) -> f32 {
        let [width, height] = self.camera.extent();
        #[expect(clippy::cast_possible_truncation, reason = "between 0.2 and 2")]
        let size = (1.3 * width.min(height) / USUAL).clamp(0.2, 2.0) as f32;
        size
    }
}
