//! What mechanisms cost on microcontrollers.

use crate::Figured;
use crate::board::Board;
use crate::error::Error;
use crate::image::flash;
use crate::image_of;
use crate::row::{COLUMNS, Row};
use std::fs;
use std::path::Path;

/// The image that has nothing in it.
const NOTHING: &str = "nothing";
/// The image that starts and does nothing.
const EMPTY: &str = "empty";
/// The image that only moves a four-bar in `f32`.
const LEAST: &str = "least";

/// What the exact four-bar in `f32` is promised to cost at most on a Cortex-M4F.
const LEAST_FLASH: u64 = 2048;
const LEAST_STATE: u64 = 64;
const LEAST_INSTRUCTIONS: u64 = 400;

/// So many parts in a hundred figures may be off.
const PERCENT: u64 = 5;
/// What is less than this off is not worth a word: bytes, or instructions.
const SMALL: u64 = 8;

/// What every image costs, and by which compiler.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Figures {
    pub(crate) compiler: String,
    pub(crate) rows: Vec<Row>,
}

impl Figures {
    /// Those of the images in a folder.
    pub(crate) fn measured(folder: &Path) -> Result<Self, Error> {
        let path = folder.join("compiler");
        let compiler = fs::read_to_string(&path).map_err(|source| Error::File { path, source })?;
        let mut rows = Vec::new();
        for board in Board::ALL {
            let nothing = Row::measured(folder, board, NOTHING)?;
            for image in images(&folder.join(board.target()))? {
                let row = Row::measured(folder, board, &image)?.less(&nothing);
                rows.push(if is_drawn(&image) { row } else { row.without_drawing() });
            }
            let [least, empty] = [LEAST, EMPTY].map(|image| flash(&image_of(folder, board, image)));
            rows.push(Row {
                board: board.name().to_owned(),
                image: LEAST.to_owned(),
                values: [least?.saturating_sub(empty?), 0, 0, 0, 0, 0],
            });
        }
        Ok(Self { compiler: compiler.trim().replace(',', ";"), rows })
    }

    /// Those of a table, of each compiler apart.
    pub(crate) fn read(path: &Path) -> Result<Vec<Self>, Error> {
        let text = fs::read_to_string(path)
            .map_err(|source| Error::File { path: path.to_owned(), source })?;
        let mut all: Vec<Self> = Vec::new();
        for line in text.lines().skip(1) {
            let (compiler, line) = line.split_once(',').unwrap_or_default();
            let row = Row::read(line)?;
            match all.iter_mut().find(|figures| figures.compiler == compiler) {
                Some(figures) => figures.rows.push(row),
                None => all.push(Self { compiler: compiler.to_owned(), rows: vec![row] }),
            }
        }
        Ok(all)
    }

    /// The table of several.
    pub(crate) fn table(all: &[Self]) -> String {
        let mut text = format!("compiler,processor,image,{}\n", COLUMNS.join(","));
        for figures in all {
            for row in &figures.rows {
                text.push_str(&format!("{},{}\n", figures.compiler, row.line()));
            }
        }
        text
    }

    /// That of an image on a board.
    pub(crate) fn row(&self, board: Board, image: &str) -> Option<&Row> {
        let mut rows = self.rows.iter();
        rows.find(|row| row.board == board.name() && row.image == image)
    }

    /// Tests that they are those that are known of the same compiler: another one writes other code.
    pub(crate) fn hold_against(&self, known: &[Self], figured: Figured) -> Result<(), Error> {
        let Some(known) = known.iter().find(|known| known.compiler == self.compiler) else {
            println!("figures: none are known by {}", self.compiler);
            return Ok(());
        };
        let differences = self.differences(known, figured);
        if differences.is_empty() {
            println!("figures: as they are known by {}", self.compiler);
            Ok(())
        } else {
            Err(Error::Figures(differences))
        }
    }

    fn differences(&self, known: &Self, figured: Figured) -> Vec<String> {
        let mut lines = Vec::new();
        let key = |row: &Row| (row.board.clone(), row.image.clone());
        for row in &known.rows {
            if figured == Figured::All && !self.rows.iter().any(|other| key(other) == key(row)) {
                lines.push(format!("{} {}: is no more", row.board, row.image));
            }
        }
        for row in &self.rows {
            let Some(before) = known.rows.iter().find(|other| key(other) == key(row)) else {
                lines.push(format!("{} {}: is new", row.board, row.image));
                continue;
            };
            for ((column, now), before) in COLUMNS.iter().zip(row.values).zip(before.values) {
                if now.abs_diff(before) * 100 > PERCENT * before && now.abs_diff(before) > SMALL {
                    lines
                        .push(format!("{} {}: {column} {now}, was {before}", row.board, row.image));
                }
            }
        }
        lines
    }

    /// Tests that the figures are as promised.
    pub(crate) fn keep_promises(&self) -> Result<(), Error> {
        let row = |image| {
            self.row(Board::CortexM4F, image)
                .ok_or_else(|| Error::Line { text: format!("no {image}") })
        };
        let [_, state, _, instructions, ..] = row("exact_f32")?.values;
        let [flash, ..] = row(LEAST)?.values;
        let mut broken = Vec::new();
        for (what, value, most) in [
            ("flash", flash, LEAST_FLASH),
            ("state", state, LEAST_STATE),
            ("instructions", instructions, LEAST_INSTRUCTIONS),
        ] {
            if value >= most {
                broken.push(format!(
                    "the exact four-bar in f32: {what} {value}, promised less than {most}"
                ));
            }
        }
        if broken.is_empty() { Ok(()) } else { Err(Error::Figures(broken)) }
    }
}

/// Whether an image is that of a four-bar by some method.
pub(crate) fn is_method(image: &str) -> bool {
    let methods = ["exact", "linear", "newton"];
    methods.iter().any(|method| image.starts_with(method))
}

/// Whether an image draws too.
fn is_drawn(image: &str) -> bool {
    !is_method(image) && !image.starts_with("diagram")
}

/// The images that were run and reported figures, in alphabetical order.
fn images(folder: &Path) -> Result<Vec<String>, Error> {
    let wrong = |source| Error::File { path: folder.to_owned(), source };
    let mut images = Vec::new();
    for entry in fs::read_dir(folder).map_err(wrong)? {
        let path = entry.map_err(wrong)?.path();
        let text = fs::read_to_string(&path).map_err(wrong)?;
        let name = path.file_stem().and_then(|name| name.to_str()).unwrap_or_default();
        if name != NOTHING && text.starts_with("state ") {
            images.push(name.to_owned());
        }
    }
    images.sort();
    Ok(images)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn figures(flash: u64, instructions: u64) -> Figures {
        let row = |image: &str, values| Row {
            board: Board::CortexM4F.name().to_owned(),
            image: image.to_owned(),
            values,
        };
        Figures {
            compiler: "rustc 1".to_owned(),
            rows: vec![
                row("exact_f32", [3000, 56, 100, instructions, 0, 0]),
                row("least", [flash, 0, 0, 0, 0, 0]),
            ],
        }
    }

    #[test]
    fn a_table_is_what_it_was_written_from() {
        let mut all = vec![figures(1900, 250), figures(2000, 300)];
        all[1].compiler = "rustc 2".to_owned();
        let path = std::env::temp_dir().join(format!("embedded-{}.csv", std::process::id()));
        fs::write(&path, Figures::table(&all)).expect("it can be written");
        let read = Figures::read(&path);
        fs::remove_file(&path).expect("it was written");
        assert_eq!(read.expect("it can be read"), all);
    }

    #[test]
    fn five_percent_are_let_pass() {
        let known = [figures(2000, 250)];
        let holds = |figures: &Figures| figures.hold_against(&known, Figured::All).is_ok();
        assert!(holds(&figures(2100, 258)));
        assert!(!holds(&figures(2101, 250)));
        assert!(!holds(&figures(2000, 236)));
        let mut other = figures(4000, 250);
        other.compiler = "rustc 2".to_owned();
        assert!(holds(&other));
        let mut fewer = figures(2000, 250);
        fewer.rows.pop();
        assert!(!holds(&fewer));
        assert!(fewer.hold_against(&known, Figured::Some).is_ok());
        assert!(known[0].hold_against(&[fewer], Figured::Some).is_err());
    }

    #[test]
    fn promises_hold() {
        assert!(figures(2047, 399).keep_promises().is_ok());
        assert!(figures(2048, 250).keep_promises().is_err());
        assert!(figures(1900, 400).keep_promises().is_err());
    }
}
