//! The studio in a canvas of a page.

use crate::worker::PageWorker;
use eframe::egui::{Context, Ui};
use eframe::{App, Frame, web_sys};
use mech_studio::editor::{Editor, Studio, first_example};
use mech_studio::{Failure, Source, Workspace};
use std::any::Any;
use std::path::Path;

pub(crate) struct Page {
    studio: Studio,
    context: Context,
    /// Whether the page knows that a mechanism is seen.
    is_announced: bool,
    /// The work that the page knows of.
    announced: Option<String>,
}

impl Page {
    /// With a text that has this name; without a name with an example.
    ///
    /// # Errors
    /// If the example cannot be read.
    pub(crate) fn new(
        name: Option<&str>,
        text: &str,
        worker: PageWorker,
        context: Context,
    ) -> Result<Self, Failure> {
        let workspace = match name {
            Some(name) => Workspace::of(Source::new(name, text)),
            None => first_example()?,
        };
        let editor = Editor::remote(workspace, Box::new(worker));
        Ok(Self { studio: Studio::new(editor), context, is_announced: false, announced: None })
    }

    /// Gives the editor a file that the user has chosen.
    pub(crate) fn take(&mut self, name: &str, bytes: Vec<u8>) {
        self.studio.editor_mut().take_file(Path::new(name), bytes);
        self.context.request_repaint();
    }

    pub(crate) fn refuse(&mut self, why: &str) {
        self.studio.editor_mut().refuse(why);
        self.context.request_repaint();
    }

    /// Takes what the worker tells.
    pub(crate) fn hear(&mut self, reply: &[u8]) {
        self.studio.editor_mut().hear(reply);
        self.context.request_repaint();
    }

    /// Goes on without the worker, which broke: this is why.
    pub(crate) fn lose_worker(&mut self, why: &str) {
        self.studio.editor_mut().lose_worker(why);
        self.context.request_repaint();
    }

    /// Whether something is lost if the page is left.
    pub(crate) fn has_work(&self) -> bool {
        self.studio.editor().has_work()
    }

    /// Tells the page what is seen and done, so that a program that looks at the page knows it.
    fn announce(&mut self, context: &Context) {
        let work = self.studio.editor().work();
        if work != self.announced {
            let told = work.as_deref().unwrap_or_default();
            if set_on_body("data-work", told) {
                self.announced = work;
            }
        }
        if self.is_announced || self.studio.editor().drawing().is_none() {
            return;
        }
        // The first frame with it is shown when the next one is made.
        if context.cumulative_frame_nr() > 0 {
            self.is_announced = set_on_body("data-ready", "1");
        } else {
            context.request_repaint();
        }
    }
}

/// Sets an attribute of the page's body. Returns whether that is done.
fn set_on_body(name: &str, value: &str) -> bool {
    let document = web_sys::window().and_then(|window| window.document());
    let body = document.and_then(|document| document.body());
    body.is_some_and(|body| body.set_attribute(name, value).is_ok())
}

impl App for Page {
    fn as_any_mut(&mut self) -> Option<&mut dyn Any> {
        Some(self)
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut Frame) {
        self.studio.ui(ui, frame);
        self.announce(&ui.ctx().clone());
    }
}
