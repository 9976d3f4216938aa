//! The curator, who hangs the exhibits.

use super::animation::DELAY;
use super::html;
use crate::{Easel, Error, Exhibit, Film, Graphs, Picture, Scene, animation};
use indicatif::{HumanBytes, ProgressBar, ProgressStyle};
use mech_runtime::files::{AnimatedSvg, Svg};
use std::io::Write;
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{env, fmt, fs, io, thread};

const HELP: &str = "\
Paints the gallery: for each mechanism a picture (PNG, SVG), an animation (GIF, SVG that moves)
and its graphs (DOT), and a page that shows them all.

Usage: gallery [NAME]...

Without names, everything is painted. There are:";

/// Some exhibits, and the folder where they hang.
pub struct Curator {
    exhibits: Vec<Box<dyn Exhibit>>,
    folder: PathBuf,
}

impl Curator {
    /// A curator of these exhibits and this folder.
    #[must_use]
    pub fn new(exhibits: Vec<Box<dyn Exhibit>>, folder: PathBuf) -> Self {
        Self { exhibits, folder }
    }

    /// `target/gallery` in the workspace, or in the current folder if the workspace does not exist.
    #[must_use]
    pub fn usual_folder() -> PathBuf {
        let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
        let root = workspace.filter(|workspace| workspace.is_dir());
        root.unwrap_or(Path::new(".")).join("target/gallery")
    }

    /// Obeys a command line.
    ///
    /// # Errors
    /// [`Error::Unknown`] if it names an exhibit that does not exist; else as [`hang`](Self::hang).
    pub fn serve(&self, arguments: impl IntoIterator<Item = String>) -> Result<(), Error> {
        let arguments: Vec<_> = arguments.into_iter().collect();
        if arguments.iter().any(|a| a == "-h" || a == "--help") {
            say(format_args!("{HELP}"));
            for exhibit in &self.exhibits {
                say(format_args!("  {:24} {}", exhibit.slug(), exhibit.title()));
            }
            return Ok(());
        }
        let known: Vec<_> = self.exhibits.iter().map(|exhibit| exhibit.slug()).collect();
        let (wanted, unknown): (Vec<_>, Vec<_>) =
            arguments.into_iter().partition(|argument| known.contains(&argument.as_str()));
        if !unknown.is_empty() {
            let names = unknown;
            return Err(Error::Unknown { names, known });
        }
        let all = wanted.is_empty();
        self.hang(|slug| all || wanted.iter().any(|name| name == slug))
    }

    /// Paints the wanted exhibits, and writes the page. One that fails does not prevent the others.
    ///
    /// # Errors
    /// [`Error::File`] if the folder or page cannot be written, [`Error::Missing`] if an exhibit could not be shown.
    pub fn hang(&self, wanted: impl Fn(&str) -> bool) -> Result<(), Error> {
        fs::create_dir_all(&self.folder)
            .map_err(|source| Error::File { path: self.folder.clone(), source })?;
        let mut names = Vec::new();
        for exhibit in self.exhibits.iter().filter(|exhibit| wanted(exhibit.slug())) {
            say(format_args!("\n{}\n\n{}\n", exhibit.title(), exhibit.report().trim_end()));
            if let Err(error) = self.show(exhibit.as_ref()) {
                eprintln!("error: exhibit `{}`: {error}", exhibit.slug());
                names.push(exhibit.slug());
            }
        }
        let shown = self.exhibits.iter().map(AsRef::as_ref);
        let shown = shown
            .filter(|exhibit| self.folder.join(exhibit.slug()).with_extension("gif").is_file());
        for exhibit in shown.clone() {
            self.write_graphs(exhibit)?;
        }
        let has_studio = self.folder.join("..").join(html::STUDIO).is_file();
        let page = html::page(shown, has_studio);
        let (path, _) = self.write("index.html", page.as_bytes())?;
        let path = path.canonicalize().unwrap_or(path);
        say(format_args!("\n{}", path.display()));
        if names.is_empty() { Ok(()) } else { Err(Error::Missing { names }) }
    }

    fn show(&self, exhibit: &dyn Exhibit) -> Result<(), Error> {
        let slug = exhibit.slug();
        let film = exhibit.film()?;
        let easel = Easel::for_film(&film).ok_or(Error::Invisible)?;
        let pictures = paint_all(&easel, &film);
        let scenes = film.scenes();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "of a few frames, one"
        )]
        let still = (exhibit.still() * scenes.len() as f64) as usize;
        let still = still.min(scenes.len().saturating_sub(1));
        let (Some(scene), Some(picture)) = (scenes.get(still), pictures.get(still)) else {
            return Err(Error::Invisible);
        };
        let sheet = easel.sheet().title(exhibit.title());
        let size = format!("{} × {}", picture.width, picture.height);
        self.write_and_announce(&format!("{slug}.png"), &picture.png()?, &size)?;
        let mut svg = Svg::new(sheet.clone());
        scene.draw(&mut svg);
        self.write_and_announce(&format!("{slug}.svg"), svg.finish().as_bytes(), &size)?;
        let frames = format!("{} frames", scenes.len());
        self.write_and_announce(&format!("{slug}.gif"), &animation(&pictures)?, &frames)?;
        let moving = moving(AnimatedSvg::new(sheet, period(scenes)), scenes);
        self.write_and_announce(&html::moving_file(slug), moving.as_bytes(), "in motion")
    }

    /// Writes a file and announces it.
    fn write_and_announce(&self, name: &str, bytes: &[u8], what: &str) -> Result<(), Error> {
        let (path, size) = self.write(name, bytes)?;
        let size = HumanBytes(size);
        say(format_args!("  {}  {what}, {size}", path.display()));
        Ok(())
    }

    /// Writes the graphs of an exhibit, if it has any, as text for Graphviz.
    fn write_graphs(&self, exhibit: &dyn Exhibit) -> Result<(), Error> {
        if let Some(Graphs { links, loops }) = exhibit.graphs() {
            for (file, graph) in html::graph_files(exhibit.slug()).iter().zip([links, loops]) {
                self.write(file, graph.to_dot().as_bytes())?;
            }
        }
        Ok(())
    }

    fn write(&self, name: &str, bytes: &[u8]) -> Result<(PathBuf, u64), Error> {
        let path = self.folder.join(name);
        match fs::write(&path, bytes) {
            Ok(()) => Ok((path, bytes.len() as u64)),
            Err(source) => Err(Error::File { path, source }),
        }
    }
}

/// Writes a line to the output. It is no error if nobody reads it.
fn say(line: fmt::Arguments<'_>) {
    let _ = writeln!(io::stdout(), "{line}");
}

/// The duration of all scenes.
fn period(scenes: &[Scene]) -> Duration {
    DELAY * u32::try_from(scenes.len()).unwrap_or(u32::MAX)
}

/// The text of an SVG that repeats the scenes.
fn moving(mut svg: AnimatedSvg, scenes: &[Scene]) -> String {
    for scene in scenes {
        svg.add(|moment| scene.draw(moment));
    }
    svg.finish()
}

/// Paints all scenes of a film, on all processors.
fn paint_all(easel: &Easel, film: &Film) -> Vec<Picture> {
    let scenes = film.scenes();
    let bar = ProgressBar::new(scenes.len() as u64);
    // Written to the terminal's error stream, and nowhere at all if that is not a terminal.
    if let Ok(style) =
        ProgressStyle::with_template("  {bar:48} {pos:>3} of {len} frames, {elapsed}")
    {
        bar.set_style(style);
    }
    let painters = thread::available_parallelism().map_or(1, NonZero::get);
    let share = scenes.len().div_ceil(painters).max(1);
    let paint = |scenes| {
        let mut easel = easel.clone();
        let paint = |scene| {
            let picture = easel.paint(scene);
            bar.inc(1);
            picture
        };
        <[_]>::iter(scenes).map(paint).collect::<Vec<_>>()
    };
    let pictures = thread::scope(|scope| {
        let work = scenes.chunks(share).map(|scenes| scope.spawn(move || paint(scenes)));
        let work: Vec<_> = work.collect();
        let done = work.into_iter().map(thread::ScopedJoinHandle::join);
        done.flat_map(|pictures| pictures.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    });
    bar.finish_and_clear();
    pictures
}
