//! The editor's state, without a window and without a clock.

mod editing;
mod findings;
mod pending;

use super::Item;
use super::desk::Desk;
use super::drawing::Drawing;
use super::ghost::Ghost;
use super::journal::Journal;
use super::plotted::Plotted;
use super::question::{Dialog, Ending};
use super::scene::Scene;
use super::settings::Settings;
use super::snapshot::Snapshot;
use super::tool::{Pick, Tool};
use super::worker::Worker;
use crate::check::verdict_line;
use crate::dialogue::Session;
use crate::document::{Document, Source};
use crate::edit::Workspace;
use crate::failure::Failure;
use crate::mend::Mending;
use crate::play::Player;
use pending::Pending;
pub(super) use pending::Waiting;
use std::collections::BTreeSet;
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
    pub(in crate::editor) session: Session,
    pub(in crate::editor) journal: Journal,
    worker: Worker,
    pub(in crate::editor) pending: Pending,
    /// What the compiler makes of the present text; of an earlier one, while it works.
    pub(in crate::editor) snapshot: Arc<Snapshot>,
    pub(in crate::editor) scene: Scene,
    pub(in crate::editor) mendings: Vec<Mending>,
    /// Whether repairs are still looked for.
    pub(in crate::editor) is_mending: bool,
    pub(in crate::editor) selection: BTreeSet<Item>,
    pub(in crate::editor) tool: Tool,
    pub(in crate::editor) picks: Vec<Pick>,
    pub(in crate::editor) notice: Option<Notice>,
    pub(in crate::editor) settings: Settings,
    /// What is asked in a window of its own.
    pub(in crate::editor) dialog: Option<Dialog>,
    /// What was copied: statements.
    pub(in crate::editor) copied: String,
    /// A line that is to be completed and said.
    pub(in crate::editor) proposed: Option<String>,
    /// Whether the drawing, or something in it, has the focus of keys.
    pub(in crate::editor) is_canvas_focused: bool,
    /// What is under the mouse, in the drawing or in the text.
    pub(in crate::editor) hovered: Option<Item>,
    /// What is under the mouse or the cursor in the text.
    pub(in crate::editor) under_text: Option<Item>,
    /// What a repair would make of the mechanism.
    pub(in crate::editor) ghost: Option<Ghost>,
    /// What is plotted.
    pub(in crate::editor) plotted: Plotted,
    /// What stands around the text.
    pub(in crate::editor) desk: Desk,
    /// Whether the window stays.
    pub(in crate::editor) ending: Ending,
    /// What goes to the clipboard next.
    pub(in crate::editor) to_clipboard: Option<String>,
}

impl Editor {
    /// An editor of this text, which analyses in a thread of its own and calls `wake` when there is something new to show.
    #[must_use]
    pub fn new(workspace: Workspace, wake: impl Fn() + Send + Sync + 'static) -> Self {
        #[cfg(not(target_arch = "wasm32"))]
        let worker = Worker::beside(wake).unwrap_or_else(|_| Worker::in_pieces());
        #[cfg(target_arch = "wasm32")]
        let worker = {
            drop(wake);
            Worker::in_pieces()
        };
        Self::with(workspace, worker, Pending::default())
    }

    /// One that analyses in pieces, one after each picture, as in a browser.
    #[must_use]
    pub fn in_pieces(workspace: Workspace) -> Self {
        Self::with(workspace, Worker::in_pieces(), Pending::default())
    }

    /// One that does everything at once, so that nothing has to be waited for.
    #[must_use]
    pub fn immediate(workspace: Workspace) -> Self {
        Self::with(workspace, Worker::immediate(), Pending::default())
    }

    fn with(workspace: Workspace, worker: Worker, pending: Pending) -> Self {
        let workspace_is_empty = workspace.text().trim().is_empty();
        let empty = Document::of(Source::new(workspace.path(), ""));
        let mut editor = Self {
            snapshot: Arc::new(Snapshot::of(empty, workspace.index())),
            session: Session::of(workspace),
            journal: Journal::default(),
            worker,
            pending,
            scene: Scene::new(!workspace_is_empty),
            mendings: Vec::new(),
            is_mending: false,
            selection: BTreeSet::new(),
            tool: Tool::Select,
            picks: Vec::new(),
            notice: None,
            settings: Settings::default(),
            dialog: None,
            copied: String::new(),
            proposed: None,
            is_canvas_focused: false,
            hovered: None,
            under_text: None,
            ghost: None,
            plotted: Plotted::default(),
            desk: Desk::default(),
            ending: Ending::Stays,
            to_clipboard: None,
        };
        editor.read();
        #[cfg(not(target_arch = "wasm32"))]
        editor.lay_desk();
        editor
    }

    /// The file that is edited.
    #[must_use]
    pub const fn workspace(&self) -> &Workspace {
        &self.session.workspace
    }

    /// What is drawn, if anything is.
    #[must_use]
    pub fn drawing(&self) -> Option<&Drawing> {
        self.scene.drawing()
    }

    /// What moves, if the mechanism does.
    #[must_use]
    pub const fn player(&self) -> Option<&Player> {
        self.scene.player()
    }

    /// What is seen, and how.
    #[must_use]
    pub const fn scene(&self) -> &Scene {
        &self.scene
    }

    /// What is seen, to be looked at and moved otherwise.
    pub const fn scene_mut(&mut self) -> &mut Scene {
        &mut self.scene
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
        let is_let_go = !self.scene.drag.is_nothing() && self.scene.drag.held().is_none();
        let is_unread = !self.is_present(&self.snapshot);
        is_let_go || is_unread || !self.pending.is_empty() || self.is_mending
    }

    /// Whether nothing is under way that would be lost if the text became another one.
    pub(in crate::editor) fn is_at_rest(&self) -> bool {
        self.scene.drag.is_nothing() && self.pending.is_empty()
    }

    /// Whether something is lost if the text is left as it is.
    #[must_use]
    pub fn has_work(&self) -> bool {
        !self.scene.drag.is_nothing() || !self.pending.is_empty() || self.workspace().has_work()
    }

    /// Tells something.
    pub(in crate::editor) fn tell(&mut self, text: impl Into<String>) {
        self.notice = Some(Notice {
            text: text.into(),
            is_refusal: false,
        });
    }

    /// Tells why something was refused.
    #[expect(clippy::needless_pass_by_value, reason = "nobody needs it any more")]
    pub(in crate::editor) fn refuse(&mut self, why: impl ToString) {
        self.notice = Some(Notice {
            text: why.to_string(),
            is_refusal: true,
        });
    }

    /// Whether the mechanism moves, in a line.
    pub(in crate::editor) fn verdict(&self) -> String {
        match (&self.snapshot.reading, self.snapshot.compiled()) {
            (Some(reading), Some(compiled)) => verdict_line(&reading.model, compiled),
            (Some(_), None) => {
                let first = self.snapshot.messages().first();
                let line = first.and_then(|message| message.text.lines().next());
                format!("not yet: {}", line.unwrap_or_default())
            }
            (None, _) => "Draw a bar, or open a file.".to_owned(),
        }
    }

    /// Tells why something could not be done.
    pub(in crate::editor) fn refuse_failed(&mut self, done: Result<(), Failure>) {
        if let Err(failure) = done {
            self.refuse(failure);
        }
    }
}
