//! `mech edit`.

use super::CODES;
use crate::console::Console;
use crate::document::Source;
use crate::edit::Workspace;
use crate::editor::{Editor, Studio};
use crate::failure::Failure;
use crate::play::window::reason;
use clap::Args;
use eframe::egui;
use std::path::PathBuf;

/// Opens the studio: a window in which mechanisms are drawn, mended and played.
///
/// The text stands beside the drawing, and is the file itself. Without a file it begins with an empty drawing.
#[derive(Args, Clone, Debug)]
#[command(after_help = EXAMPLES, after_long_help = [EXAMPLES, "\n\n", CODES].concat())]
pub(super) struct Edit {
    /// A Rust file with `mechanism!` in it, or a file `.mech` with the inside of one. One that is not there yet is made when it is saved.
    file: Option<PathBuf>,
    /// The mechanism at first, where the file has several: the name of its type.
    #[arg(short, long, value_name = "NAME")]
    mechanism: Option<String>,
}

const EXAMPLES: &str = "\
Examples:
  mech edit
  mech edit four_bar.mech
  mech edit src/main.rs --mechanism FourBar";

/// The size of the window at first.
const SIZE: [f32; 2] = [1280.0, 800.0];

impl Edit {
    pub(super) fn run(&self, _: &mut Console) -> Result<(), Failure> {
        let workspace = match &self.file {
            None => Workspace::default(),
            Some(path) if !path.exists() => Workspace::unsaved(path, ""),
            Some(path) if self.mechanism.is_none() => Workspace::of(Source::read_plain(path)?),
            Some(path) => Workspace::open(path, self.mechanism.as_deref())?,
        };
        let options = eframe::NativeOptions {
            viewport: egui::ViewportBuilder::default()
                .with_title("mech edit")
                .with_inner_size(SIZE),
            ..eframe::NativeOptions::default()
        };
        let opened = eframe::run_native(
            "mech",
            options,
            Box::new(|context| {
                let window = context.egui_ctx.clone();
                let wake = move || window.request_repaint();
                let editor = Editor::new(workspace, wake.clone());
                Ok(Box::new(Studio::guarded(editor, unnamed(), wake)))
            }),
        );
        opened.map_err(|error| Failure::usage(reason(&error)))
    }
}

/// The folder in which texts without a file are kept: in the user's folder for what can be lost, or that for temporary files.
fn unnamed() -> PathBuf {
    let folder = |name: &str| {
        let folder = PathBuf::from(std::env::var_os(name)?);
        folder.is_absolute().then_some(folder)
    };
    let home = |within: &str| Some(folder("HOME")?.join(within));
    let cache = if cfg!(windows) {
        folder("LOCALAPPDATA")
    } else if cfg!(target_os = "macos") {
        home("Library/Caches")
    } else {
        folder("XDG_CACHE_HOME").or_else(|| home(".cache"))
    };
    cache.unwrap_or_else(std::env::temp_dir).join("mech")
}
