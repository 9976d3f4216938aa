//! What one image costs.

use crate::board::Board;
use crate::error::Error;
use crate::image::flash;
use crate::image_of;
use std::fs;
use std::path::Path;

/// What is measured, in the order of the columns.
pub(crate) const COLUMNS: [&str; 6] =
    ["flash", "state", "stack", "instructions", "stack_drawing", "instructions_frame"];

/// What one image costs: bytes of flash (less what an image with nothing in it takes), of the mechanism's state, of stack to move it;
/// instructions a position; bytes of stack and instructions to move and draw it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Row {
    pub(crate) board: String,
    pub(crate) image: String,
    pub(crate) values: [u64; 6],
}

impl Row {
    /// That of an image which was run.
    pub(crate) fn measured(folder: &Path, board: Board, image: &str) -> Result<Self, Error> {
        let path = folder.join(board.target()).join(format!("{image}.txt"));
        let text = fs::read_to_string(&path).map_err(|source| Error::File { path, source })?;
        let parsed = |name: &str| {
            let value = text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(' '));
            value
                .and_then(|value| value.trim().parse().ok())
                .ok_or_else(|| Error::Line { text: format!("{image}: no {name}") })
        };
        Ok(Self {
            board: board.name().to_owned(),
            image: image.to_owned(),
            values: [
                flash(&image_of(folder, board, image))?,
                parsed("state")?,
                parsed("stack")?,
                parsed("position")?,
                parsed("stack-drawing")?,
                parsed("frame")?,
            ],
        })
    }

    /// The same without what another takes.
    pub(crate) fn less(mut self, other: &Self) -> Self {
        for (value, other) in self.values.iter_mut().zip(other.values) {
            *value = value.saturating_sub(other);
        }
        self
    }

    /// The same, of an image which draws nothing.
    pub(crate) fn without_drawing(mut self) -> Self {
        self.values[4] = 0;
        self.values[5] = 0;
        self
    }

    /// A line of the table.
    pub(crate) fn line(&self) -> String {
        let values: Vec<String> = self.values.iter().map(u64::to_string).collect();
        format!("{},{},{}", self.board, self.image, values.join(","))
    }

    /// That of a line of the table.
    pub(crate) fn read(line: &str) -> Result<Self, Error> {
        let wrong = || Error::Line { text: line.to_owned() };
        let mut cells = line.split(',');
        let (Some(board), Some(image)) = (cells.next(), cells.next()) else {
            return Err(wrong());
        };
        let values: Result<Vec<u64>, _> = cells.map(str::parse).collect();
        let values = values.ok().and_then(|values| values.try_into().ok());
        Ok(Self {
            board: board.to_owned(),
            image: image.to_owned(),
            values: values.ok_or_else(wrong)?,
        })
    }
}
