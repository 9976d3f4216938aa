//! What the command line asks for.

use std::fmt;
use std::path::PathBuf;

/// How to call it.
pub const HELP: &str = "\
Plays a mechanism of the gallery in a window, or in the terminal where there is no display.

Usage: play [OPTION]... [NAME]

  --terminal         play in the terminal
  --picture FILE     write what is seen as a PNG file, and nothing more
  --after SECONDS    of that picture: how long it has played by then, 0 if left out
  -l, --list         tell which mechanisms there are
  -h, --help         tell this, the keys, and which mechanisms there are";

/// What the command line asks for.
#[derive(Clone, Debug, PartialEq)]
pub enum Request {
    /// Help, with everything.
    Help,
    /// The names of the exhibits.
    List,
    /// An exhibit: the first one, if no name is given.
    Show {
        /// Its name.
        name: Option<String>,
        /// Where it is to be seen.
        medium: Medium,
    },
}

/// Where something is to be seen.
#[derive(Clone, Debug, PartialEq)]
pub enum Medium {
    /// In a window.
    Window,
    /// In the terminal.
    Terminal,
    /// In a file, after so many seconds.
    Picture(PathBuf, f64),
}

/// A command line that cannot be understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Misunderstood(String);

impl fmt::Display for Misunderstood {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}; `play --help` tells what there is", self.0)
    }
}

impl std::error::Error for Misunderstood {}

impl Request {
    /// Reads it.
    ///
    /// # Errors
    /// [`Misunderstood`] if there is an option that does not exist or has no value, or more than one name.
    pub fn read(arguments: impl IntoIterator<Item = String>) -> Result<Self, Misunderstood> {
        let wrong = |what: String| Err(Misunderstood(what));
        let mut arguments = arguments.into_iter();
        let (mut name, mut terminal, mut file, mut seconds) = (None, false, None, None);
        while let Some(argument) = arguments.next() {
            match argument.as_str() {
                "-h" | "--help" => return Ok(Self::Help),
                "-l" | "--list" => return Ok(Self::List),
                "--terminal" => terminal = true,
                "--picture" => match arguments.next() {
                    Some(path) => file = Some(PathBuf::from(path)),
                    None => return wrong("`--picture` needs the name of a file".into()),
                },
                "--after" => match arguments.next().and_then(|text| text.parse::<f64>().ok()) {
                    Some(time) if (0.0..=3600.0).contains(&time) => seconds = Some(time),
                    _ => return wrong("`--after` needs a number of seconds, 0 to 3600".into()),
                },
                option if option.starts_with('-') => {
                    return wrong(format!("there is no option `{option}`"));
                }
                _ if name.is_some() => {
                    return wrong(format!("`{argument}` is one name too many"));
                }
                _ => name = Some(argument),
            }
        }
        let medium = match (file, seconds) {
            (Some(_), _) if terminal => {
                return wrong("`--picture` needs no `--terminal`".into());
            }
            (Some(file), seconds) => Medium::Picture(file, seconds.unwrap_or(0.0)),
            (None, Some(_)) => return wrong("`--after` needs a `--picture`".into()),
            (None, None) if terminal => Medium::Terminal,
            (None, None) => Medium::Window,
        };
        Ok(Self::Show { name, medium })
    }
}
