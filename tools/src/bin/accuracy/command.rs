//! The command line.

/// A command.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Command {
    /// Measures, and renews the page in `docs`.
    Full,
    /// Measures briefly, and writes to `target` only.
    Quick,
    /// Prints a list of all subjects.
    Help,
}

/// The help.
pub(crate) const HELP: &str = "\
Measures what each method costs and how exact it is: the price list.

Usage: accuracy [--quick]

Without arguments, it takes about a minute and renews docs/accuracy.md with its table and
picture. With --quick it measures briefly and writes into target/accuracy only.";

impl Command {
    /// Reads the arguments.
    ///
    /// # Errors
    /// If an argument is unknown.
    pub(crate) fn read(arguments: impl IntoIterator<Item = String>) -> Result<Self, String> {
        let mut command = Self::Full;
        for argument in arguments {
            match argument.as_str() {
                "--quick" => command = Self::Quick,
                "-h" | "--help" => return Ok(Self::Help),
                _ => {
                    return Err(format!(
                        "`{argument}` means nothing here; there are `--quick` and `--help`"
                    ));
                }
            }
        }
        Ok(command)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arguments() {
        let read = |text: &str| Command::read(text.split_whitespace().map(str::to_owned));
        assert_eq!(read(""), Ok(Command::Full));
        assert_eq!(read("--quick"), Ok(Command::Quick));
        assert_eq!(read("--quick --help"), Ok(Command::Help));
        assert!(read("--fast").is_err_and(|error| error.contains("`--fast`")));
    }
}
