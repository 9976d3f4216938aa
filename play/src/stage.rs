//! A player and its painter: what both front ends stand before.

use crate::caption::{plain, wrap};
use crate::painter::ADVANCE;
use crate::{Command, Painter, Player, keys};
use mech_gallery::{Error, Picture};
use mech_runtime::Palette;
use std::fs;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// The shorter side of a picture that has words in it, in pixels; twice as much, and they are twice as large.
const LEAST: usize = 240;
/// From one line to the next, in dots of letters.
const LINE: usize = 11;

/// A player and its painter, with help for whoever looks on.
pub struct Stage {
    /// What is played.
    pub player: Player,
    painter: Painter,
    helps: bool,
    folder: PathBuf,
}

impl Stage {
    /// With this player; pictures are saved into this folder.
    #[must_use]
    pub fn new(player: Player, folder: PathBuf) -> Self {
        Self {
            player,
            painter: Painter::default(),
            helps: false,
            folder,
        }
    }

    /// Obeys a command. `Break` if it is the command to stop.
    pub fn obey(&mut self, command: Command) -> ControlFlow<()> {
        self.player.obey(command);
        match command {
            Command::Help => self.helps = !self.helps,
            Command::Save => self.save(),
            Command::Quit => return ControlFlow::Break(()),
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
    #[must_use]
    pub fn picture(&mut self) -> Picture {
        self.painter.paint(&self.player)
    }

    /// The present picture with the title, the status and, if wanted, what the keys do. In a picture too small for letters they are left
    /// out.
    #[must_use]
    pub fn caption(&mut self) -> Picture {
        let mut picture = self.picture();
        let size = usize::from(picture.width.min(picture.height)) / LEAST;
        let size = size.min(2);
        if size == 0 {
            return picture;
        }
        let columns = usize::from(picture.width) / (ADVANCE * size) - 2;
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
                self.painter
                    .write(&mut picture, [margin, top], &line, size, color);
                top += LINE * size;
            }
        }
        picture
    }

    /// What the keys do, if that was asked for.
    #[must_use]
    pub fn help(&self) -> Option<Vec<String>> {
        self.helps.then(keys::help)
    }

    /// Writes the picture that is seen now.
    ///
    /// # Errors
    /// [`Error::Picture`] if it has no size, [`Error::File`] if it cannot be written.
    pub fn write(&mut self, path: &Path) -> Result<(), Error> {
        let bytes = self.picture().png()?;
        fs::write(path, bytes).map_err(|source| Error::File {
            path: path.to_owned(),
            source,
        })
    }

    /// Saves the present picture under a new name, and shows the name.
    fn save(&mut self) {
        let names = (1..).map(|number| format!("{}-{number}.png", self.player.slug()));
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
