//! Plays a mechanism of the gallery: `play [NAME]`.

use mech_gallery::{Exhibit, exhibits};
use mech_play::{Medium, Player, Request, Stage, keys, request, terminal, window};
use std::error::Error;
use std::io::{self, BufRead, IsTerminal, Write};
use std::path::PathBuf;
use std::process::ExitCode;

fn main() -> ExitCode {
    match serve() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Does what the command line asks for.
fn serve() -> Result<(), Box<dyn Error>> {
    let exhibits = exhibits();
    match Request::read(std::env::args().skip(1))? {
        Request::Help => {
            say(request::HELP);
            say("\nKeys:");
            for line in keys::help() {
                say(&format!("  {line}"));
            }
            say("\nThere are:");
            list(&exhibits);
        }
        Request::List => list(&exhibits),
        Request::Show { name, medium } => show(exhibits, name, medium)?,
    }
    Ok(())
}

fn list(exhibits: &[Box<dyn Exhibit>]) {
    for exhibit in exhibits {
        say(&format!("  {:24} {}", exhibit.slug(), exhibit.title()));
    }
}

/// Writes a line to the output, and does not mind if nobody reads it to the end.
fn say(line: &str) {
    let _ = writeln!(io::stdout(), "{line}");
}

/// Which exhibit has this name.
fn index(exhibits: &[Box<dyn Exhibit>], name: String) -> Result<usize, mech_gallery::Error> {
    let index = exhibits.iter().position(|exhibit| exhibit.slug() == name);
    index.ok_or_else(|| mech_gallery::Error::Unknown {
        names: vec![name],
        known: exhibits.iter().map(|exhibit| exhibit.slug()).collect(),
    })
}

/// Shows an exhibit there where it is wanted.
fn show(
    exhibits: Vec<Box<dyn Exhibit>>,
    name: Option<String>,
    medium: Medium,
) -> Result<(), Box<dyn Error>> {
    let index = match name {
        None => 0,
        Some(name) => index(&exhibits, name)?,
    };
    let player = Player::new(exhibits, index, window::SIZE)?;
    let mut stage = Stage::new(player, PathBuf::new());
    match medium {
        Medium::Picture(path, seconds) => {
            stage.wait(seconds);
            stage.write(&path)?;
        }
        Medium::Terminal => in_terminal(stage)?,
        Medium::Window => match window::Display::open() {
            Ok(display) => display.play(stage)?,
            Err(error) => in_terminal_instead(stage, &error)?,
        },
    }
    Ok(())
}

/// Plays in the terminal, if this is one.
fn in_terminal(stage: Stage) -> Result<(), Box<dyn Error>> {
    if !is_terminal() {
        return Err("input and output are not a terminal: run `play --terminal` in one, or write a picture \
                    with `play --picture FILE`"
            .into());
    }
    Ok(terminal::play(stage)?)
}

/// Says that there is no window, and offers the terminal if this is one.
fn in_terminal_instead(stage: Stage, error: &window::Error) -> Result<(), Box<dyn Error>> {
    if !is_terminal() {
        return Err(format!(
            "{error}; start it where there is a display, run `play --terminal` in a terminal, or write a \
             picture with `play --picture FILE`"
        )
        .into());
    }
    eprint!("{error}\nplay in this terminal instead (as `--terminal` does)? [Y/n] ");
    let mut answer = String::new();
    io::stdin().lock().read_line(&mut answer)?;
    match answer.trim() {
        "" | "y" | "Y" | "yes" => in_terminal(stage),
        _ => Ok(()),
    }
}

/// Whether there is somebody who sees what is written, and can type.
fn is_terminal() -> bool {
    io::stdout().is_terminal() && io::stdin().is_terminal()
}
