//! The editor's state, without a window and without a clock.

use super::bounds_of;
use super::dragging::Dragging;
use super::drawing::Drawing;
use super::ghost::Ghost;
use super::journal::Journal;
use super::path::Path;
use super::plotted::Plotted;
use super::range::MotorRange;
use super::settings::{Settings, View};
use super::snapshot::Snapshot;
use super::tool::{Pick, Tool};
use super::worker::{Finding, Task, Worker};
use super::{Gesture, Item};
use crate::dialogue::{Session, Turn};
use crate::document::{Document, Source};
use crate::edit::{Applied, Command, Kind, Refusal, Workspace};
use crate::failure::Failure;
use crate::mend::Mending;
use crate::play::{Camera, Control, Mechanism, Player, SIZE};
use std::collections::{BTreeSet, VecDeque};
use std::sync::Arc;

/// What is told at the foot of the window.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Notice {
    /// What is told.
    pub text: String,
    /// Whether something was refused.
    pub is_refusal: bool,
}

/// The editor: a text, what the compiler makes of it, and what the user is about.
pub struct Editor {
    pub(super) session: Session,
    pub(super) journal: Journal,
    worker: Worker,
    /// Gestures that wait for the one that is being tried.
    waiting: VecDeque<Gesture>,
    pub(super) is_trying: bool,
    /// What the compiler makes of the present text; of an earlier one, while it works.
    pub(super) snapshot: Arc<Snapshot>,
    /// What the compiler made of the last text that could be read, and how that is drawn.
    drawn: Option<Arc<Snapshot>>,
    pub(super) drawing: Option<Drawing>,
    /// What the compiler made of the text of the mechanism that the player has.
    played: Option<Arc<Snapshot>>,
    /// What moves, if the text that is drawn moves.
    pub(super) player: Option<Player>,
    pub(super) ranges: Vec<MotorRange>,
    pub(super) paths: Vec<Path>,
    pub(super) mendings: Vec<Mending>,
    /// Whether repairs are still looked for.
    pub(super) is_mending: bool,
    pub(super) selection: BTreeSet<Item>,
    pub(super) tool: Tool,
    pub(super) picks: Vec<Pick>,
    pub(super) dragging: Option<Dragging>,
    pub(super) camera: Camera,
    pub(super) notice: Option<Notice>,
    pub(super) settings: Settings,
    /// The text as somebody types it, until it is taken over.
    pub(super) typed: Option<String>,
    /// What was copied: links.
    pub(super) copied: Vec<String>,
    /// A line that is to be completed and said.
    pub(super) proposed: Option<String>,
    /// Whether keys go to the drawing, or to something in it.
    pub(super) is_canvas_focused: bool,
    /// What is under the mouse, in the drawing or in the text.
    pub(super) hovered: Option<Item>,
    /// What is under the mouse or the cursor in the text.
    pub(super) under_text: Option<Item>,
    /// What a repair would make of the mechanism.
    pub(super) ghost: Option<Ghost>,
    /// What is plotted.
    pub(super) plotted: Plotted,
}

impl Editor {
    /// An editor of this text, which analyses in a thread of its own and calls `wake` when there is something new to show.
    #[must_use]
    pub fn new(workspace: Workspace, wake: impl Fn() + Send + 'static) -> Self {
        #[cfg(not(target_arch = "wasm32"))]
        let worker = Worker::beside(wake);
        #[cfg(target_arch = "wasm32")]
        let worker = {
            drop(wake);
            Worker::immediate()
        };
        Self::with(workspace, worker)
    }

    /// One that does everything at once, so that nothing has to be waited for.
    #[must_use]
    pub fn immediate(workspace: Workspace) -> Self {
        Self::with(workspace, Worker::immediate())
    }

    fn with(workspace: Workspace, worker: Worker) -> Self {
        let workspace_is_empty = workspace.text().trim().is_empty();
        let empty = Document::of(Source::new(workspace.path(), ""));
        let mut editor = Self {
            snapshot: Arc::new(Snapshot::of(empty, workspace.index())),
            session: Session::of(workspace),
            journal: Journal::default(),
            worker,
            waiting: VecDeque::new(),
            is_trying: false,
            drawn: None,
            drawing: None,
            played: None,
            player: None,
            ranges: Vec::new(),
            paths: Vec::new(),
            mendings: Vec::new(),
            is_mending: false,
            selection: BTreeSet::new(),
            tool: Tool::Select,
            picks: Vec::new(),
            dragging: None,
            camera: Camera::new(bounds_of(None), SIZE),
            notice: None,
            settings: Settings {
                view: if workspace_is_empty {
                    View::Users
                } else {
                    View::Ours
                },
                ..Settings::default()
            },
            typed: None,
            copied: Vec::new(),
            proposed: None,
            is_canvas_focused: false,
            hovered: None,
            under_text: None,
            ghost: None,
            plotted: Plotted::default(),
        };
        editor.read();
        editor
    }

    /// The file that is edited.
    #[must_use]
    pub const fn workspace(&self) -> &Workspace {
        &self.session.workspace
    }

    /// What is drawn, if anything is.
    #[must_use]
    pub const fn drawing(&self) -> Option<&Drawing> {
        self.drawing.as_ref()
    }

    /// What moves, if the mechanism does.
    #[must_use]
    pub const fn player(&self) -> Option<&Player> {
        self.player.as_ref()
    }

    /// How the scene is seen.
    #[must_use]
    pub const fn camera(&self) -> &Camera {
        &self.camera
    }

    /// What is selected.
    #[must_use]
    pub const fn selection(&self) -> &BTreeSet<Item> {
        &self.selection
    }

    /// The repairs that are offered.
    #[must_use]
    pub fn mendings(&self) -> &[Mending] {
        &self.mendings
    }

    /// What is told at the foot of the window.
    #[must_use]
    pub const fn notice(&self) -> Option<&Notice> {
        self.notice.as_ref()
    }

    /// What is wrong, in the compiler's words.
    #[must_use]
    pub fn messages(&self) -> Vec<&str> {
        let messages = self.snapshot.messages().iter();
        messages.map(|message| &*message.text).collect()
    }

    /// Whether the text can be read; if not, what is drawn is of an earlier one.
    #[must_use]
    pub fn is_readable(&self) -> bool {
        self.snapshot.is_readable()
    }

    /// Whether the analysis is not done yet.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        self.is_trying || self.is_mending
    }

    /// Tells something.
    pub(super) fn tell(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice {
            text: text.into(),
            is_refusal: false,
        });
    }

    /// Tells why something was refused.
    #[expect(clippy::needless_pass_by_value, reason = "nobody needs it any more")]
    pub(super) fn refuse(&mut self, why: impl ToString) {
        self.notice = Some(Notice {
            text: why.to_string(),
            is_refusal: true,
        });
    }

    /// Makes a gesture, as soon as those before it are made.
    pub fn perform(&mut self, gesture: impl Into<Gesture>) {
        self.waiting.push_back(gesture.into());
        self.go_on();
    }

    /// Tries the next gesture.
    fn go_on(&mut self) {
        if self.is_trying {
            return;
        }
        if let Some(gesture) = self.waiting.pop_front() {
            self.is_trying = true;
            let task = Task::Try {
                document: self.workspace().document(),
                index: self.workspace().index(),
                gesture,
            };
            self.give(task);
        }
    }

    pub(super) fn give(&mut self, task: Task) {
        if let Err(failure) = self.worker.give(task) {
            self.refuse(failure);
        }
        self.look();
    }

    /// Reads the text anew, after it was changed other than by a gesture.
    pub(super) fn read(&mut self) {
        self.typed = None;
        let task = Task::Read {
            document: self.workspace().document(),
            index: self.workspace().index(),
        };
        self.give(task);
    }

    /// Takes over what was found out since.
    pub fn look(&mut self) {
        loop {
            match self.worker.next() {
                Ok(Some(finding)) => self.take(finding),
                Ok(None) => return,
                Err(failure) => {
                    self.refuse(failure);
                    return;
                }
            }
        }
    }

    fn take(&mut self, finding: Finding) {
        match finding {
            Finding::Tried(tried) => {
                self.is_trying = false;
                match *tried {
                    Ok((applied, snapshot)) => self.accept(&applied, snapshot),
                    Err(refusal) => self.reject(&refusal),
                }
                self.go_on();
            }
            Finding::Read(snapshot) => {
                if self.is_present(&snapshot) {
                    self.show(snapshot);
                }
            }
            Finding::Previewed(snapshot, played) => self.take_preview(&snapshot, *played),
            Finding::Moves(snapshot, made) => {
                if Arc::ptr_eq(&snapshot, &self.snapshot) {
                    match *made {
                        Ok((mechanism, ranges, paths)) => {
                            self.played = Some(snapshot);
                            self.play(mechanism, ranges, paths);
                        }
                        Err(failure) => self.refuse(failure),
                    }
                }
            }
            Finding::Exported(done) => self.take_export(done),
            Finding::Measured(curves) => self.take_curves(*curves),
            Finding::Mended(snapshot, found) => {
                if Arc::ptr_eq(&snapshot, &self.snapshot) {
                    self.is_mending = false;
                    match found {
                        Ok(found) => self.mendings = found,
                        Err(failure) => self.refuse(failure),
                    }
                }
            }
        }
    }

    fn accept(&mut self, applied: &Applied, snapshot: Arc<Snapshot>) {
        let text = applied.document.source().text();
        self.session.workspace.push(applied.title.as_str(), text);
        self.typed = None;
        let notes = applied.notes.join("; ");
        self.tell(if notes.is_empty() {
            applied.title.clone()
        } else {
            format!("{}: {notes}", applied.title)
        });
        self.show(snapshot);
    }

    fn reject(&mut self, refusal: &Refusal) {
        self.waiting.clear();
        self.refuse(refusal);
    }

    /// Whether a snapshot is of the present text.
    pub(super) fn is_present(&self, snapshot: &Snapshot) -> bool {
        snapshot.document.source().text() == self.workspace().text()
    }

    /// Shows what the compiler makes of the present text. Of one that cannot be read, the last drawing stays.
    fn show(&mut self, snapshot: Arc<Snapshot>) {
        self.mendings.clear();
        self.ghost = None;
        self.is_mending = true;
        if snapshot.is_readable() {
            let was_empty = self.drawing.is_none();
            self.drawing = snapshot.drawing(self.drawing.as_ref(), self.seen_at().is_some());
            self.drawn = Some(snapshot.clone());
            if snapshot.compiled().is_none() {
                self.player = None;
                self.ranges.clear();
                self.paths.clear();
            }
            self.forget_what_is_gone();
            if was_empty && self.settings.view == View::Ours {
                self.settings.view = View::Started;
                self.fit();
            }
        } else if self.workspace().text().trim().is_empty() {
            self.drawn = None;
            self.drawing = None;
            self.player = None;
            self.selection.clear();
        }
        if snapshot.reading.is_none() {
            self.is_mending = false;
        }
        if let Some(failure) = &snapshot.failure {
            self.refuse(failure);
        }
        self.snapshot = snapshot;
    }

    /// Plays the mechanism of the present text, with its motors where they were.
    fn play(&mut self, mechanism: Mechanism, ranges: Vec<MotorRange>, paths: Vec<Path>) {
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

    /// Whether the player has the mechanism of the present text.
    pub(super) fn is_played_present(&self) -> bool {
        self.played
            .as_ref()
            .is_some_and(|played| Arc::ptr_eq(played, &self.snapshot))
    }

    /// Puts the links of the drawing where the player has them.
    pub(super) fn pose(&mut self) {
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
        if self.dragging.is_none()
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
        if let Some(player) = &mut self.player {
            player.drive(motor, value);
            self.pose();
        }
    }

    /// The values of motors at which the mechanism is seen, in degrees or scene units; none at the start.
    pub(super) fn seen_at(&self) -> Option<Vec<(String, f64)>> {
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

    /// Takes what is not there any more out of the selection.
    fn forget_what_is_gone(&mut self) {
        let drawing = self.drawing.as_ref();
        let has = |item: &Item| drawing.is_some_and(|drawing| drawing.has(item));
        self.selection.retain(has);
    }

    /// Chooses a tool.
    pub fn choose(&mut self, tool: Tool) {
        self.tool = tool;
        self.picks.clear();
        self.dragging = None;
        self.notice = None;
    }

    /// Picks a place with the tool that is chosen. When all are picked, the gesture is made.
    pub(super) fn pick(&mut self, pick: Pick) {
        self.picks.push(pick);
        if self.picks.len() < self.tool.picks().len() {
            return;
        }
        let picks = std::mem::take(&mut self.picks);
        match self.tool.gesture(self.drawing.as_ref(), &picks) {
            Ok(gesture) => self.perform(gesture),
            Err(why) => self.refuse(why),
        }
    }

    /// Goes back by a step.
    pub fn undo(&mut self) {
        let title = self.session.workspace.undo().map(ToOwned::to_owned);
        self.stepped("undone", title);
    }

    /// Makes the step again that was undone.
    pub fn redo(&mut self) {
        let title = self.session.workspace.redo().map(ToOwned::to_owned);
        self.stepped("done again", title);
    }

    fn stepped(&mut self, word: &str, title: Option<String>) {
        if let Some(title) = title {
            self.picks.clear();
            self.read();
            self.tell(format!("{word}: {title}"));
        }
    }

    /// Takes over a text that was typed, as one step. Typing on is the same step.
    pub fn type_text(&mut self, text: &str) {
        self.session.workspace.retype("text", text);
        self.read();
    }

    /// Makes a repair, by its number from 1.
    pub fn mend(&mut self, number: usize) {
        self.perform(Command::Repair { number });
    }

    /// Takes out what is selected.
    pub fn remove_selected(&mut self) {
        let commands = self.selection.iter().map(|item| Command::Remove {
            kind: match item {
                Item::Link(_) => Kind::Link,
                Item::Joint(_) => Kind::Joint,
                Item::Axis(_) => Kind::Axis,
                Item::Action(_) => Kind::Action,
            },
            name: item.name().to_owned(),
        });
        let commands: Vec<Command> = commands.collect();
        match &commands[..] {
            [] => self.refuse("nothing is selected"),
            [only] => self.perform(only.clone()),
            several => {
                let title = format!("remove {} things", several.len());
                self.perform(Gesture::new(title, commands));
            }
        }
    }

    /// Goes on with another mechanism of the file, by its number.
    pub(super) fn choose_mechanism(&mut self, index: usize) {
        self.session.workspace.choose(index);
        self.player = None;
        self.drawing = None;
        self.selection.clear();
        self.picks.clear();
        self.settings.view = View::Ours;
        self.read();
    }

    /// Does what a line of the dialogue says.
    pub fn say(&mut self, line: &str) {
        let (turn, said) = self.journal.obey(line, &mut self.session);
        match turn {
            Ok(Turn::GoOn | Turn::End) => self.tell(said),
            Err(failure) => self.refuse(failure),
        }
        self.read();
    }

    /// Edits another text.
    pub fn open(&mut self, workspace: Workspace) {
        let worker = std::mem::replace(&mut self.worker, Worker::immediate());
        let (settings, size) = (self.settings.clone(), self.camera.size());
        *self = Self::with(workspace, worker);
        self.settings = Settings {
            view: self.settings.view,
            ..settings
        };
        self.camera.resize(size);
        self.fit();
    }

    /// Writes the text.
    ///
    /// # Errors
    /// If there is no file yet and none is named, or if it cannot be written.
    pub fn save(&mut self, path: Option<&std::path::Path>) -> Result<(), Failure> {
        let before = self.session.workspace.clone();
        let saving = self.session.workspace.save_to(path)?;
        match saving.write() {
            Ok(path) => {
                self.tell(format!("saved `{}`", path.display()));
                Ok(())
            }
            Err(failure) => {
                self.session.workspace = before;
                Err(failure)
            }
        }
    }
}
