//! The sight: a mechanism as it is drawn, as it plays, and as it is while it is dragged.

use super::drag::Drag;
use super::drawing::Drawing;
use super::playing::{Hand, Playing};
use super::range::{MotorRange, Path};
use super::settings::{Settings, Visible};
use super::snapshot::Snapshot;
use super::worker::Previewed;
use crate::play::{Camera, Control, Mechanism, Player, SIZE};
use std::sync::Arc;

/// The largest number of bodies that are painted while something is dragged.
const MOST_BODIES: usize = 200;

/// The sight: the mechanism that is seen, and its view.
pub struct Sight {
    /// The snapshot of the last text that could be read, and its drawing.
    drawn: Option<(Arc<Snapshot>, Drawing)>,
    pub(super) playing: Playing,
    pub(super) drag: Drag,
    pub(super) camera: Camera,
    view: View,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum View {
    /// It is to show everything that will be there.
    Ours,
    /// It shows everything as it starts, and is to show all of its motion when that is known.
    Started,
    /// It stays as the user has it.
    Users,
}

impl Sight {
    /// An empty one. Whether everything that comes is to be seen, or what the user looks at.
    pub(super) fn new(is_ours: bool) -> Self {
        Self {
            drawn: None,
            playing: Playing::default(),
            drag: Drag::default(),
            camera: Camera::new(bounds_of(None), SIZE),
            view: if is_ours { View::Ours } else { View::Users },
        }
    }

    pub(super) fn drawing(&self) -> Option<&Drawing> {
        self.drawn.as_ref().map(|(_, drawing)| drawing)
    }

    pub(super) fn has_motor(&self, joint: &str) -> bool {
        let drawing = self.drawing();
        drawing.is_some_and(|drawing| drawing.has_motor(joint))
    }

    /// Returns the player, if the mechanism moves.
    pub(super) const fn player(&self) -> Option<&Player> {
        self.playing.player.as_ref()
    }

    /// Returns the camera.
    #[must_use]
    pub const fn camera(&self) -> &Camera {
        &self.camera
    }

    /// Pixels in a scene unit.
    pub(super) fn scale(&self) -> f64 {
        self.camera.view().scale()
    }

    /// Shows what can be read of a text. It goes on to move when its mechanism is there.
    pub(super) fn draw(&mut self, snapshot: &Arc<Snapshot>) {
        let was_empty = self.drawn.is_none();
        if snapshot.compiled().is_none() {
            self.playing.stop();
        }
        let is_moved = self.playing.seen_at().is_some();
        let drawing = snapshot.drawing(self.drawing(), is_moved);
        self.drawn = drawing.map(|drawing| (snapshot.clone(), drawing));
        if was_empty && self.view == View::Ours {
            self.view = View::Started;
            self.fit();
        }
    }

    /// Shows nothing: the text is empty.
    pub(super) fn clear(&mut self) {
        self.drawn = None;
        self.playing.stop();
    }

    /// Shows nothing until another mechanism is known, and all of that.
    pub(super) fn make_way(&mut self) {
        self.drawn = None;
        self.playing.player = None;
        self.view = View::Ours;
    }

    /// Plays the mechanism of the present text, with its motors where they were.
    pub(super) fn play(
        &mut self,
        snapshot: Arc<Snapshot>,
        (mechanism, ranges, paths): (Mechanism, Vec<MotorRange>, Vec<Path>),
    ) {
        let playing = &mut self.playing;
        if let Some(player) = &mut playing.player {
            player.replace(mechanism);
        } else {
            let mut player = Player::new(mechanism, Vec::new(), self.camera.size());
            player.obey(Control::PlayOrPause);
            playing.player = Some(player);
        }
        playing.snapshot = Some(snapshot);
        playing.asked.clear();
        (playing.ranges, playing.paths) = (ranges, paths);
        self.pose();
        if self.view == View::Started {
            self.view = View::Users;
            self.fit();
        }
    }

    /// Takes the link under a pixel of the canvas, so that it follows the pointer.
    pub(super) fn hold(&mut self, pixel: [f64; 2]) {
        self.playing.note(Hand::Link);
        if let Some(player) = &mut self.playing.player {
            player.look(&self.camera);
        }
        self.obey(Control::Press(pixel));
    }

    /// Takes back the last motion by hand since the text changed. Returns whether there was one.
    pub(super) fn take_back_motion(&mut self) -> bool {
        self.obey(Control::Release);
        let is_taken_back = self.playing.take_back();
        self.pose();
        is_taken_back
    }

    /// Puts the links of the drawing where the player has them.
    fn pose(&mut self) {
        if let (Some(player), Some((snapshot, drawing))) = (&self.playing.player, &mut self.drawn)
            && self.playing.is_of(snapshot)
        {
            drawing.set_poses(player.mechanism().poses());
        }
    }

    pub(super) fn advance(&mut self, seconds: f64) {
        if self.drag.is_nothing()
            && let Some(player) = &mut self.playing.player
        {
            player.advance(seconds);
            self.pose();
        }
    }

    /// Gives the player a control.
    pub fn obey(&mut self, control: Control) {
        if let Some(player) = &mut self.playing.player {
            player.obey(control);
            self.pose();
        }
    }

    /// Moves a motor, by its number, to a value in radians or scene units.
    pub fn scrub(&mut self, motor: usize, value: f64) {
        self.playing.note(Hand::Motor(motor));
        if let Some(player) = &mut self.playing.player {
            player.drive(motor, value);
            self.pose();
        }
    }

    /// Moves motors, by their numbers, to values in radians or scene units, one after the other.
    pub(super) fn scrub_to(&mut self, place: &[(usize, f64)]) {
        for &(motor, value) in place {
            self.scrub(motor, value);
        }
    }

    /// Sees everything.
    pub fn fit(&mut self) {
        self.fit_with(None);
    }

    /// Sees everything, and what is within this box.
    pub(super) fn fit_with(&mut self, beside: Option<[[f64; 2]; 2]>) {
        let [mut low, mut high] = self.bounds();
        if let Some([lower, higher]) = beside {
            low = [0, 1].map(|part| low[part].min(lower[part]));
            high = [0, 1].map(|part| high[part].max(higher[part]));
        }
        self.camera = Camera::new([low, high], self.camera.size());
    }

    fn bounds(&self) -> [[f64; 2]; 2] {
        let moving = self.player().map(|player| player.mechanism().bounds());
        // A single pivot is seen with room around it.
        let handles = self.drawing().into_iter().flat_map(Drawing::handles);
        let mut places = handles.map(|handle| handle.place);
        let first = places.next();
        let moving = moving.filter(|_| places.any(|place| Some(place) != first));
        moving.unwrap_or_else(|| bounds_of(self.drawing()))
    }

    /// Returns the drawing that is seen: while something is dragged, that of the drag.
    pub(super) fn seen_drawing(&self) -> Option<&Drawing> {
        let stay = self.drag.stay().map(|stay| &stay.drawing);
        stay.or(self.drawing())
    }

    /// Returns the player that is painted: while something is dragged, that of the drag, as soon as it is known.
    pub(super) fn seen_player(&self) -> Option<&Player> {
        match self.drag.stay() {
            Some(stay) => stay.preview.player.as_ref(),
            None => self.player(),
        }
    }

    /// The whole paths of traced points, as they are known.
    pub(super) fn seen_paths(&self) -> &[Path] {
        let stay = self.drag.stay().map(|stay| &stay.preview.paths);
        stay.unwrap_or(&self.playing.paths)
    }

    /// Takes over what the compiler makes of a text while something is dragged.
    pub(super) fn take_preview(&mut self, previewed: Previewed) {
        let Some(preview) = self.drag.preview_mut(previewed.number) else {
            return;
        };
        preview.is_awaited = false;
        preview.fault = previewed.fault;
        preview.paths = previewed.paths;
        preview.player = previewed.mechanism.map(|mechanism| {
            let mut player = Player::new(mechanism, Vec::new(), self.camera.size());
            if let Some(before) = &self.playing.player {
                player.stand_as(before.mechanism());
                player.show_layers(before.layers());
            }
            player
        });
    }

    /// Whether the bodies of links are seen, and not the schematic.
    pub(super) fn shows_bodies(&self, settings: &Settings) -> bool {
        (self.drag.held().is_none() || self.shows_bodies_of_drag())
            && settings.shows(Visible::Bodies)
            && self.seen_player().is_some()
    }

    /// Whether bodies are seen while something is dragged: very many take longer to be painted than a frame may.
    pub(super) fn shows_bodies_of_drag(&self) -> bool {
        let drawing = self.drawing();
        drawing.is_some_and(|drawing| drawing.model.links.len() <= MOST_BODIES)
    }
}

/// The box in which something is seen: of the drawing, or of what may become one.
fn bounds_of(drawing: Option<&Drawing>) -> [[f64; 2]; 2] {
    const EMPTY: [[f64; 2]; 2] = [[-5.0, -4.0], [5.0, 4.0]];
    let places = drawing.into_iter().flat_map(Drawing::handles);
    let bounds = places.fold(None, |bounds: Option<[[f64; 2]; 2]>, handle| {
        let [x, y] = handle.place;
        let [low, high] = bounds.unwrap_or([[x, y]; 2]);
        Some([[low[0].min(x), low[1].min(y)], [high[0].max(x), high[1].max(y)]])
    });
    match bounds {
        Some([low, high]) if low[0] < high[0] || low[1] < high[1] => [low, high],
        Some([[x, y], _]) => [[x - 5.0, y - 4.0], [x + 5.0, y + 4.0]],
        None => EMPTY,
    }
}
