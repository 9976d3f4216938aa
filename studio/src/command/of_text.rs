//! The commands about a mechanism of a text, which may not be in any file.

use super::check::Check;
use super::draw::Draw;
use super::film::Film;
use super::fix::Fix;
use super::graph::Graph;
use super::play::Play;
use super::plot::Plot;
use super::report::Report;
use super::rest::Rest;
use super::table::Table;
use super::target::Target;
use crate::console::Console;
use crate::document::Document;
use crate::failure::{Failure, FailureKind};
use crate::output::Writer;
use clap::{Parser, Subcommand};
use std::ffi::OsString;

/// A command about a mechanism of a text.
#[derive(Debug, Subcommand)]
pub(super) enum OfText {
    Check(Check),
    Fix(Fix),
    Report(Report),
    Rest(Rest),
    Graph(Graph),
    Draw(Draw),
    Film(Film),
    Table(Table),
    Plot(Plot),
    Play(Play),
}

/// A line with such a command alone.
#[derive(Debug, Parser)]
#[command(name = "mech", disable_help_subcommand = true)]
struct Line {
    #[command(subcommand)]
    command: OfText,
}

/// What a command line says; none if only its help was asked for.
pub(super) fn parse<L: Parser>(
    words: impl IntoIterator<Item = OsString>,
    console: &mut Console,
) -> Result<Option<L>, Failure> {
    match L::try_parse_from(words) {
        Ok(line) => Ok(Some(line)),
        Err(error) if error.use_stderr() => {
            console.complain(&error.to_string());
            Err(Failure::reported(FailureKind::Usage))
        }
        // The user asked for the help, or the version.
        Err(error) => console.answer(error.to_string()).map(|()| None),
    }
}

/// Does what a subcommand does, on the mechanism with this number in a text that may not be in any file. The words are those after
/// `mech`, without the file.
pub(crate) fn obey_within(
    words: &[String],
    document: Document,
    index: usize,
    writer: &mut Writer,
    console: &mut Console,
) -> Result<(), Failure> {
    let mut all: Vec<OsString> = vec!["mech".into()];
    let (name, others) =
        words.split_first().ok_or_else(|| Failure::internal("a command without a word"))?;
    all.push(name.into());
    // The file is given below; this only fills its place.
    all.push("-".into());
    all.extend(others.iter().map(OsString::from));
    let Some(Line { mut command }) = parse(all, console)? else {
        return Ok(());
    };
    command.give(document, index);
    command.run(writer, console)
}

impl OfText {
    pub(super) fn run(self, writer: &mut Writer, console: &mut Console) -> Result<(), Failure> {
        match self {
            Self::Check(check) => check.run(console),
            Self::Fix(fix) => fix.run(writer, console),
            Self::Report(report) => report.run(console),
            Self::Rest(rest) => rest.run(console),
            Self::Graph(graph) => graph.run(writer, console),
            Self::Draw(draw) => draw.run(writer, console),
            Self::Film(film) => film.run(writer, console),
            Self::Table(table) => table.run(writer, console),
            Self::Plot(plot) => plot.run(writer, console),
            Self::Play(play) => play.run(writer, console),
        }
    }

    /// Gives the text itself, and the number of the mechanism in it.
    fn give(&mut self, document: Document, index: usize) {
        let target: &mut Target = match self {
            Self::Check(check) => &mut check.target,
            Self::Fix(fix) => &mut fix.target,
            Self::Report(report) => &mut report.target,
            Self::Rest(rest) => &mut rest.target,
            Self::Graph(graph) => &mut graph.target,
            Self::Draw(draw) => &mut draw.target,
            Self::Film(film) => &mut film.target,
            Self::Table(table) => &mut table.target,
            Self::Plot(plot) => &mut plot.target,
            Self::Play(play) => return play.give(document, index),
        };
        target.give(document, index);
    }
}
