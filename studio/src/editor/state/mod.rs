//! The editor's state, without a window and without a clock.

mod dragging;
mod editing;
mod findings;

use super::analysis::Analysis;
use super::arrow::{Arrow, arrows};
use super::clipboard::Clipboard;
use super::constructed::board;
use super::desk::Desk;
use super::drawing::Drawing;
use super::item::Item;
use super::pending::Pending;
use super::plotted::Plotted;
use super::selection::Selection;
use super::settings::Settings;
use super::sight::Sight;
use super::talk::{Notice, Talk};
use super::tool::Picking;
use super::worker::Worker;
#[cfg(feature = "transfer")]
use super::worker::{Port, Remote};
use crate::construction::Board;
use crate::dialogue::Session;
use crate::edit::Workspace;
use crate::mend::Mending;
use crate::play::Player;
use std::collections::BTreeSet;
use std::path::Path;

/// The editor: a text, what the compiler makes of it, and what the user is about.
pub struct Editor {
    pub(in crate::editor) session: Session,
    pub(in crate::editor) analysis: Analysis,
    pub(in crate::editor) sight: Sight,
    pub(in crate::editor) selection: Selection,
    pub(in crate::editor) picking: Picking,
    pub(in crate::editor) settings: Settings,
    pub(in crate::editor) talk: Talk,
    pub(in crate::editor) clipboard: Clipboard,
    pub(in crate::editor) plotted: Plotted,
    pub(in crate::editor) desk: Desk,
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

    /// An editor of this text that has it analysed by a worker with which it shares no memory.
    #[cfg(feature = "transfer")]
    #[must_use]
    pub fn remote(workspace: Workspace, port: Box<dyn Port>) -> Self {
        let worker = Worker::Remote(Box::new(Remote::new(port)));
        Self::with(workspace, worker, Pending::default())
    }

    /// Takes what such a worker tells.
    #[cfg(feature = "transfer")]
    pub fn hear(&mut self, reply: &[u8]) {
        if let Some(remote) = self.analysis.remote() {
            remote.hear(reply);
        }
    }

    /// Goes on with another worker after such a one has broken: this is why.
    #[cfg(feature = "transfer")]
    pub fn lose_worker(&mut self, why: &str) {
        if let Some(remote) = self.analysis.remote() {
            remote.lose(why);
        }
    }

    /// One that analyses in pieces, one after each picture, as in a browser without workers.
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
        let has_text = !workspace.text().trim().is_empty();
        let mut editor = Self {
            analysis: Analysis::new(&workspace, worker, pending),
            session: Session::of(workspace),
            sight: Sight::new(has_text),
            selection: Selection::default(),
            picking: Picking::default(),
            settings: Settings::default(),
            talk: Talk::default(),
            clipboard: Clipboard::default(),
            plotted: Plotted::default(),
            desk: Desk::default(),
        };
        editor.read();
        #[cfg(not(target_arch = "wasm32"))]
        if editor.workspace().is_named() {
            let (desk, done) = Desk::of(editor.workspace().path());
            editor.desk = desk;
            editor.talk.refuse_failed(done);
        }
        editor
    }

    /// The file that is edited.
    #[must_use]
    pub const fn workspace(&self) -> &Workspace {
        &self.session.workspace
    }

    /// Returns the drawing, if there is one.
    #[must_use]
    pub fn drawing(&self) -> Option<&Drawing> {
        self.sight.drawing()
    }

    /// Returns the player, if the mechanism moves.
    #[must_use]
    pub const fn player(&self) -> Option<&Player> {
        self.sight.player()
    }

    /// Returns the sight.
    #[must_use]
    pub const fn sight(&self) -> &Sight {
        &self.sight
    }

    /// Returns the sight, to change how it is seen and moved.
    pub const fn sight_mut(&mut self) -> &mut Sight {
        &mut self.sight
    }

    /// Returns the selected items.
    #[must_use]
    pub const fn selection(&self) -> &BTreeSet<Item> {
        &self.selection.items
    }

    /// The repairs that are offered.
    #[must_use]
    pub fn mendings(&self) -> &[Mending] {
        self.analysis.mendings()
    }

    /// Returns the notice at the foot of the window.
    #[must_use]
    pub const fn notice(&self) -> Option<&Notice> {
        self.talk.notice.as_ref()
    }

    /// The arrows that are wanted, at the present pose.
    #[must_use]
    pub fn arrows(&self) -> Vec<Arrow> {
        let snapshot = &self.analysis.snapshot;
        arrows(&self.sight, snapshot, &self.plotted, &self.settings)
    }

    /// What is constructed at the present pose, if anything is wanted.
    pub(in crate::editor) fn board(&self) -> Option<Board> {
        let snapshot = &self.analysis.snapshot;
        let (plotted, settings) = (&self.plotted, &self.settings);
        board(&self.sight, snapshot, plotted, settings, &self.selection)
    }

    /// The texts of what is constructed at the present pose.
    #[must_use]
    pub fn constructed(&self) -> Vec<String> {
        self.board().as_ref().map(Board::texts).unwrap_or_default()
    }

    /// The picture behind the drawing, if there is one: its file, its centre and its width in scene units.
    #[must_use]
    pub fn backdrop(&self) -> Option<(&Path, [f64; 2], f64)> {
        let backdrop = self.desk.backdrop.as_ref()?;
        Some((&backdrop.path, backdrop.place.center, backdrop.place.width))
    }

    /// Returns the compiler's messages on the faults.
    #[must_use]
    pub fn messages(&self) -> Vec<&str> {
        let messages = self.analysis.snapshot.messages().iter();
        messages.map(|message| &*message.text).collect()
    }

    /// Whether the text can be read; if not, the drawing is of an earlier one.
    #[must_use]
    pub fn is_readable(&self) -> bool {
        self.analysis.snapshot.is_readable()
    }

    /// Whether the analysis is not done yet.
    #[must_use]
    pub fn is_busy(&self) -> bool {
        let drag = &self.sight.drag;
        let is_let_go = !drag.is_nothing() && drag.held().is_none();
        let is_known = self.analysis.is_stopped() || self.analysis.is_present(self.workspace());
        is_let_go || !is_known || self.analysis.is_mending()
    }

    /// What is done beside the window, in words; none if nothing is.
    #[must_use]
    pub fn work(&self) -> Option<String> {
        self.analysis.works.last().map(ToString::to_string)
    }

    /// Whether no drag is under way, and no gesture is tried or waits.
    pub(in crate::editor) fn is_at_rest(&self) -> bool {
        self.sight.drag.is_nothing() && self.analysis.pending.is_empty()
    }

    /// Whether leaving the text would lose work.
    #[must_use]
    pub fn has_work(&self) -> bool {
        !self.is_at_rest() || self.workspace().has_work()
    }
}
