//! The state of a player, without a window, a terminal or a clock.

use super::camera::Bounds;
use super::{
    Camera, Control, Derived, Driver, Grip, Held, Layer, Layers, Limit, Mechanism, Obstacle, Pace,
    Rates, Selection, Style, marks,
};
use mech_compiler::Compiled;
use mech_runtime::Canvas;
use mech_runtime::overlay::Spot;
use std::collections::VecDeque;
use std::f64::consts::TAU;
use std::sync::atomic::{AtomicU64, Ordering};

/// The number of single steps in 1 of the phase. Playing never moves farther at once.
const STEPS: f64 = 120.0;
/// The longest time by which playing advances at once, in seconds.
const LONGEST: f64 = 0.1;
/// The greatest distance from a link at which a press holds it, in pixels of a picture of usual size.
const NEAR: f64 = 14.0;
/// The length of arrows, relative to the crank: for a point that turns round its crank once in 1 of the phase.
const ARROW: f64 = 0.5;

/// Plays with mechanisms, one at a time.
pub struct Player {
    mechanism: Mechanism,
    /// Those that wait, from the next to the previous.
    others: VecDeque<Mechanism>,
    driver: Driver,
    /// The direction of the last move, if that was a step that arrived: then the motors have rates.
    direction: Option<f64>,
    pace: Pace,
    plays: bool,
    limit: Option<Limit>,
    held: Option<Held>,
    layers: Layers,
    is_night: bool,
    camera: Camera,
    notice: Option<String>,
    revision: Revision,
}

impl Player {
    /// A player that shows the first of these mechanisms in a picture of this size.
    #[must_use]
    pub fn new(first: Mechanism, others: Vec<Mechanism>, size: [usize; 2]) -> Self {
        Self {
            driver: Driver::new(&first),
            direction: None,
            layers: first.layers(),
            camera: Camera::new(first.bounds(), size),
            mechanism: first,
            others: others.into(),
            pace: Pace::default(),
            plays: true,
            limit: None,
            held: None,
            is_night: false,
            notice: None,
            revision: Revision::next(),
        }
    }

    /// Obeys a control. The front end obeys those for help, saving and stopping.
    pub fn obey(&mut self, control: Control) {
        self.revision = Revision::next();
        if !matches!(control, Control::Point(_) | Control::Resize(_)) {
            self.notice = None;
        }
        match control {
            Control::PlayOrPause => self.plays = !self.plays,
            Control::Step(steps) => {
                self.plays = false;
                if steps.is_finite() {
                    self.travel((steps / STEPS).clamp(-1.0, 1.0));
                }
            }
            Control::Reverse => self.pace.reverse(),
            Control::Faster => self.pace.faster(),
            Control::Slower => self.pace.slower(),
            Control::NextMotor => self.driver.next(),
            Control::PreviousMotor => self.driver.previous(),
            Control::Toggle(layer) if self.mechanism.offers(layer) => self.layers.toggle(layer),
            Control::Toggle(layer) => self.miss(layer),
            Control::DayOrNight => self.is_night = !self.is_night,
            Control::NextMechanism => self.show_next(),
            Control::PreviousMechanism => self.show_previous(),
            Control::Reset => self.reset(),
            Control::Fit => self.camera.fit(),
            Control::Press([x, y]) | Control::Point([x, y])
                if !(x.is_finite() && y.is_finite()) => {}
            Control::Press(pixel) => self.press(pixel),
            Control::Point(pixel) => self.point(pixel),
            Control::Release => self.held = None,
            Control::Zoom(pixel, factor) => self.camera.zoom(pixel, factor),
            Control::Resize(size) => self.camera.resize(size),
            Control::Help | Control::Save | Control::Quit => {}
        }
        self.keep_in_view();
    }

    /// Goes on with another mechanism, which stands for the one that is shown: motors of the same name keep their values, as far as they
    /// can come there.
    pub fn replace(&mut self, mechanism: Mechanism) {
        let before = std::mem::replace(&mut self.mechanism, mechanism);
        self.driver = Driver::new(&self.mechanism);
        self.direction = None;
        self.limit = None;
        self.held = None;
        self.stand_as(&before);
    }

    /// Moves the motors to the values that those of the same name have in another mechanism, as far as they can come there.
    pub(crate) fn stand_as(&mut self, before: &Mechanism) {
        self.revision = Revision::next();
        if before.is_at_start() {
            return;
        }
        let from = self.mechanism.motors().to_vec();
        let mut target = from.clone();
        for (motor, value) in target.iter_mut().enumerate() {
            if let Some(known) =
                self.mechanism.motor_name(motor).and_then(|name| before.value_of(name))
            {
                *value = known;
            }
        }
        let obstacle = self.mechanism.move_toward(&target);
        self.settle(obstacle, &from, &target);
    }

    /// Pauses, and moves a motor, by its number, to a value in radians or scene units, as far as possible.
    pub fn drive(&mut self, motor: usize, value: f64) {
        self.revision = Revision::next();
        self.plays = false;
        self.direction = None;
        let from = self.mechanism.motors().to_vec();
        let mut target = from.clone();
        if let Some(known) = target.get_mut(motor).filter(|_| value.is_finite()) {
            *known = value;
            let obstacle = self.mechanism.move_toward(&target);
            self.settle(obstacle, &from, &target);
        }
    }

    /// Has its mechanism compute what a layer shows, which takes its time once.
    pub fn prepare(&mut self, layer: Layer) {
        if let Some(what) = layer.derived() {
            self.mechanism.prepare(what);
        }
    }

    /// Takes over what its mechanism was compiled to once more. Layers that it cannot show are hidden.
    pub fn take(&mut self, what: Derived, found: Option<Box<Compiled>>) {
        self.revision = Revision::next();
        self.mechanism.take(what, found);
        for layer in self.layers.shown() {
            if layer.derived() == Some(what) && !self.mechanism.offers(layer) {
                self.layers.toggle(layer);
                self.miss(layer);
            }
        }
    }

    /// Tells that its mechanism has no such layer.
    fn miss(&mut self, layer: Layer) {
        self.notice = Some(format!("{} has no {}", self.title(), layer.name()));
    }

    /// Shows these layers.
    pub fn show_layers(&mut self, layers: Layers) {
        self.revision = Revision::next();
        self.layers = layers;
    }

    /// Looks through another camera.
    pub fn look(&mut self, camera: &Camera) {
        self.revision = Revision::next();
        self.camera.clone_from(camera);
    }

    /// Plays for a time in seconds.
    pub fn advance(&mut self, seconds: f64) {
        let is_held = matches!(self.held, Some(Held::Link { .. }));
        if !self.plays || is_held || !seconds.is_finite() {
            return;
        }
        self.revision = Revision::next();
        let seconds = seconds.clamp(0.0, LONGEST);
        let share = self.pace.direction() * self.pace.speed() * seconds / self.driver.seconds();
        if !self.travel(share) {
            self.plays = false;
        }
        self.keep_in_view();
    }

    pub(crate) fn draw(&self, canvas: &mut impl Canvas<f64>) {
        let size = self.camera.symbol_size();
        self.mechanism.draw(canvas, &self.style(), &self.rates());
        if let Some(limit) = &self.limit {
            for (place, is_motor) in limit.places(&self.mechanism) {
                marks::ring(canvas, place, size);
                if is_motor {
                    marks::ring(canvas, place, 1.6 * size);
                }
            }
        }
        if let Some(Held::Link { grip, aim }) = self.held
            && let Some(place) = self.mechanism.place(grip.spot)
        {
            marks::band(canvas, [place, aim], size);
        }
    }

    /// Which of all its pictures it shows: another after each change.
    #[must_use]
    pub const fn revision(&self) -> Revision {
        self.revision
    }

    /// The mechanism that is shown.
    #[must_use]
    pub const fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    /// Its name.
    #[must_use]
    pub fn title(&self) -> &str {
        self.mechanism.title()
    }

    /// The motors' values, what is driven, and the speed; or the limit.
    #[must_use]
    pub fn status(&self) -> String {
        if let Some(notice) = &self.notice {
            return notice.clone();
        }
        let mechanism = &self.mechanism;
        if let Some(limit) = &self.limit {
            return limit.sentence(mechanism);
        }
        let values = mechanism.motors().iter().enumerate();
        let values = values.filter_map(|(motor, &value)| {
            let name = mechanism.motor_name(motor)?;
            Some(format!("{name} {}", mechanism.shown(motor, value)?))
        });
        let values: Vec<_> = values.collect();
        let driven = match self.driver.selection() {
            Selection::Motion => "own motion",
            Selection::Motor(motor) => mechanism.motor_name(motor).unwrap_or_default(),
        };
        let state = match (self.plays, self.pace.direction() < 0.0) {
            (false, _) => "paused",
            (true, false) => "playing",
            (true, true) => "playing backwards",
        };
        let speed = self.pace.speed();
        format!("{} · {state} {driven} ×{speed}", values.join(", "))
    }

    /// Shows a notice in place of the status until the next control.
    pub(crate) fn notify(&mut self, notice: String) {
        self.notice = Some(notice);
    }

    /// The values of the motors, in the order of their declaration, in radians or scene units.
    #[must_use]
    pub fn motors(&self) -> &[f64] {
        self.mechanism.motors()
    }

    /// The pixel at which a place on a link is seen.
    #[must_use]
    pub fn pixel(&self, spot: Spot<f64>) -> Option<[f64; 2]> {
        Some(self.camera.pixel(self.mechanism.place(spot)?))
    }

    /// The held place on a link.
    #[must_use]
    pub const fn held_spot(&self) -> Option<Spot<f64>> {
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
    pub const fn selection(&self) -> Selection {
        self.driver.selection()
    }

    /// The visible layers.
    #[must_use]
    pub const fn layers(&self) -> Layers {
        self.layers
    }

    /// Whether it is painted in the colours of the night.
    pub(crate) const fn is_night(&self) -> bool {
        self.is_night
    }

    /// The camera.
    #[must_use]
    pub const fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Shows the next mechanism; the first follows the last.
    fn show_next(&mut self) {
        if let Some(next) = self.others.pop_front() {
            let shown = std::mem::replace(&mut self.mechanism, next);
            self.others.push_back(shown);
        }
        self.begin();
    }

    fn show_previous(&mut self) {
        if let Some(previous) = self.others.pop_back() {
            let shown = std::mem::replace(&mut self.mechanism, previous);
            self.others.push_front(shown);
        }
        self.begin();
    }

    /// Begins with the mechanism that is shown.
    fn begin(&mut self) {
        self.driver = Driver::new(&self.mechanism);
        self.layers = self.mechanism.layers();
        self.camera = Camera::new(self.mechanism.bounds(), self.camera.size());
        self.plays = true;
        self.reset();
    }

    fn reset(&mut self) {
        self.mechanism.reset();
        self.driver.reset();
        self.direction = None;
        self.pace = Pace::default();
        self.limit = None;
        self.held = None;
    }

    /// Moves by a share of the phase in single steps. Returns whether it arrived.
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

    /// Moves by a share of the phase at once. Returns whether it arrived.
    fn step(&mut self, share: f64) -> bool {
        let from = self.mechanism.motors().to_vec();
        let target = self.driver.target(&self.mechanism, share);
        let obstacle = self.mechanism.move_toward(&target);
        let has_arrived = obstacle.is_none();
        if has_arrived {
            self.driver.note_progress(share);
        }
        self.direction = has_arrived.then(|| share.signum());
        self.settle(obstacle, &from, &target);
        has_arrived
    }

    /// Notes the limit at which a move ended, or that there is none any more.
    fn settle(&mut self, obstacle: Option<Obstacle>, from: &[f64], target: &[f64]) {
        let Some(obstacle) = obstacle else {
            // A mechanism that does not move stays at the limit.
            if self.mechanism.motors() != from {
                self.limit = None;
            }
            return;
        };
        let pairs = from.iter().zip(target).enumerate();
        let moved = pairs.filter(|(_, (from, target))| from != target);
        let motors = moved.map(|(motor, _)| motor).collect();
        self.limit = Some(Limit { obstacle, motors });
    }

    /// Takes hold of the link or the paper at a pixel.
    fn press(&mut self, pixel: [f64; 2]) {
        let aim = self.camera.place(pixel);
        let near =
            (NEAR * f64::from(self.camera.symbol_size()).max(0.5)) / self.camera.view().scale();
        // What `follow` leads is taken rather than what is beside it.
        let led = self.mechanism.led_spot().filter(|spot| {
            let place = self.mechanism.place(*spot);
            place.is_some_and(|[x, y]| (x - aim[0]).hypot(y - aim[1]) <= near)
        });
        self.held = Some(match led.or_else(|| self.mechanism.spot_at(aim, near)) {
            Some(spot) => Held::Link { grip: Grip { spot }, aim },
            None => Held::Paper(pixel),
        });
    }

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

    fn drag(&mut self, grip: Grip, aim: [f64; 2]) {
        let free = self.driver.free();
        let from = self.mechanism.motors().to_vec();
        let may_move: Vec<usize> = free.iter().map(|free| free.motor).collect();
        let obstacle = if self.mechanism.lead(grip.spot, aim, &may_move) {
            None
        } else {
            grip.follow(&mut self.mechanism, &free, aim)
        };
        self.direction = None;
        // The limit names all motors that could have moved.
        let target = vec![f64::NAN; from.len()];
        self.settle(obstacle, &from, &target);
        if let Some(limit) = &mut self.limit {
            limit.motors.retain(|motor| free.iter().any(|free| free.motor == *motor));
        }
    }

    /// Zooms out where the mechanism would leave the picture, but not while a link is held, which must stay at the pointer.
    fn keep_in_view(&mut self) {
        if self.held.is_some() {
            return;
        }
        let mut bounds = Bounds::default();
        self.mechanism.draw(&mut bounds, &self.style(), &self.rates());
        if let Some(corners) = bounds.corners() {
            self.camera.include(corners);
        }
    }

    /// The rates of the motors, if they are seen.
    fn rates(&self) -> Rates {
        let is_seen = |layer| self.layers.has(layer);
        match self.direction {
            Some(direction) if is_seen(Layer::Velocities) || is_seen(Layer::Accelerations) => {
                self.driver.rates(&self.mechanism, direction)
            }
            _ => Rates::default(),
        }
    }

    /// The layers, and the sizes of symbols and arrows.
    fn style(&self) -> Style {
        // 1 of the phase counts as one turn.
        let rate = TAU / self.driver.seconds();
        Style {
            layers: self.layers,
            size: self.camera.symbol_size(),
            velocity: ARROW / rate,
            acceleration: ARROW / (rate * rate),
        }
    }
}

/// A number that is given once: two players that show different things never have the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Revision(u64);

impl Revision {
    /// One that was never given before.
    pub(super) fn next() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}
