//! The studio in a canvas of a page.

use eframe::egui::{Context, Ui};
use eframe::{App, Frame, web_sys};
use mech_studio::editor::{Editor, Studio, first_example};
use mech_studio::{Failure, Source, Workspace};
use std::any::Any;
use std::path::Path;

/// The studio in a canvas of a page.
pub(crate) struct Page {
    studio: Studio,
    context: Context,
    /// Whether the page knows that a mechanism is seen.
    is_announced: bool,
}

impl Page {
    /// With a text that has this name; without a name with an example.
    ///
    /// # Errors
    /// If the example cannot be read.
    pub(crate) fn new(name: Option<&str>, text: &str, context: Context) -> Result<Self, Failure> {
        let workspace = match name {
            Some(name) => Workspace::of(Source::new(name, text)),
            None => first_example()?,
        };
        // There is no thread that could have something new to show.
        let editor = Editor::new(workspace, || {});
        Ok(Self {
            studio: Studio::new(editor),
            context,
            is_announced: false,
        })
    }

    /// Gives the editor a file that the user has chosen.
    pub(crate) fn take(&mut self, name: &str, bytes: Vec<u8>) {
        self.studio.editor_mut().take_file(Path::new(name), bytes);
        self.context.request_repaint();
    }

    /// Whether something is lost if the page is left.
    pub(crate) fn has_work(&self) -> bool {
        self.studio.editor().has_work()
    }

    /// Tells the page that a mechanism is seen, so that a program that looks at the page knows when to.
    fn announce(&mut self) {
        let document = web_sys::window().and_then(|window| window.document());
        let body = document.and_then(|document| document.body());
        let told = body.map(|body| body.set_attribute("data-ready", "1"));
        self.is_announced = matches!(told, Some(Ok(())));
    }
}

impl App for Page {
    fn as_any_mut(&mut self) -> Option<&mut dyn Any> {
        Some(self)
    }

    fn ui(&mut self, ui: &mut Ui, frame: &mut Frame) {
        self.studio.ui(ui, frame);
        if self.is_announced || self.studio.editor().drawing().is_none() {
            return;
        }
        // The first frame with it is shown when the next one is made.
        if ui.ctx().cumulative_frame_nr() > 0 {
            self.announce();
        } else {
            ui.ctx().request_repaint();
        }
    }
}
