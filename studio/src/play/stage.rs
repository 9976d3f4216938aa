//! A player and its painter: what both front ends stand before.

use super::caption::{plain, wrap};
use super::painter::ADVANCE;
use super::{Control, Painter, Player, keys};
use crate::failure::Failure;
use crate::output::{self, Output, OutputKind, Over};
use mech_runtime::{HeapSmooth, Palette, files};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// The shorter side of a picture that has words in it, in pixels; twice as much, and they are twice as large.
const LEAST: usize = 240;
/// From one line to the next, in dots of letters.
const LINE: usize = 11;

/// A player and its painter, with help for whoever looks on.
pub struct Stage {
    /// The player.
    pub player: Player,
    painter: Painter,
    helps: bool,
    folder: PathBuf,
}

impl Stage {
    /// With this player; pictures are saved into this folder.
    ///
    /// # Errors
    /// If there is no memory for a picture.
    pub fn new(player: Player, folder: PathBuf) -> Result<Self, Failure> {
        Ok(Self { painter: Painter::new(player.camera().size())?, player, helps: false, folder })
    }

    /// Obeys a control. `Break` if it is the one to stop.
    pub fn obey(&mut self, control: Control) -> ControlFlow<()> {
        if let Control::Toggle(layer) = control {
            self.player.prepare(layer);
        }
        self.player.obey(control);
        match control {
            Control::Help => self.helps = !self.helps,
            Control::Save => self.save(),
            Control::Quit => return ControlFlow::Break(()),
            _ => {}
        }
        ControlFlow::Continue(())
    }

    /// Lets so many seconds pass, picture by picture.
    pub fn wait(&mut self, seconds: f64) {
        const FRAME: f64 = 1.0 / 60.0;
        let mut left = seconds;
        while left > 0.0 {
            self.player.advance(left.min(FRAME));
            left -= FRAME;
        }
    }

    /// The present picture.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub fn picture(&mut self) -> Result<&HeapSmooth, Failure> {
        self.painter.paint(&self.player)
    }

    /// The present picture with the title, the status and, if wanted, what the keys do. In a picture too small for letters they are left
    /// out.
    ///
    /// # Errors
    /// If there is no memory for it.
    pub fn caption(&mut self) -> Result<&HeapSmooth, Failure> {
        self.painter.paint(&self.player)?;
        let [width, height] = self.player.camera().size();
        let size = (width.min(height) / LEAST).min(2);
        if size == 0 {
            return Ok(self.painter.picture());
        }
        let columns = width / (ADVANCE * size) - 2;
        let ink = Palette::INK;
        let status = match self.player.limit() {
            Some(_) => Palette::RED,
            None => ink,
        };
        let help = self.help().unwrap_or_else(|| vec!["h help".to_owned()]);
        let paragraphs = [
            (vec![self.player.title().to_owned()], ink),
            (vec![self.player.status()], status),
            (help, ink),
        ];
        let margin = ADVANCE * size;
        let mut top = margin;
        for (phrases, color) in paragraphs {
            let phrases: Vec<String> = phrases.iter().map(|phrase| plain(phrase)).collect();
            for line in wrap(&phrases, columns) {
                self.painter.write([margin, top], &line, size, color)?;
                top += LINE * size;
            }
        }
        Ok(self.painter.picture())
    }

    /// Returns the help on the keys, if it was asked for.
    #[must_use]
    pub fn help(&self) -> Option<Vec<String>> {
        self.helps.then(keys::help)
    }

    /// Returns the picture that is seen now as a PNG file.
    ///
    /// # Errors
    /// If it has no size.
    pub fn png(&mut self) -> Result<Vec<u8>, Failure> {
        Ok(files::Picture::from(self.picture()?).png()?)
    }

    fn write(&mut self, path: &Path) -> Result<(), Failure> {
        let output = Output::new(path, OutputKind::Png, self.png()?);
        output::write(output.over(Over::Nothing("press the key once more")))
    }

    /// Saves the present picture under a new name, and shows the name.
    fn save(&mut self) {
        let names = (1..).map(|number| format!("{}-{number}.png", self.player.title()));
        let mut paths = names.map(|name| self.folder.join(name));
        let Some(path) = paths.find(|path| !path.exists()) else {
            return;
        };
        let notice = match self.write(&path) {
            Ok(()) => format!("saved as {}", path.display()),
            Err(error) => error.to_string(),
        };
        self.player.notify(notice);
    }
}
