//! `mech import`, as it is called.

use crate::finding::Finding;
use mech_studio::Console;
use std::cell::RefCell;
use std::ffi::OsString;
use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;
use std::rc::Rc;

/// The links in dialogues with the command.
pub(super) fn links(dialogues: &[String]) -> Vec<String> {
    let lines = dialogues.iter().flat_map(|dialogue| dialogue.lines());
    let calls = lines.filter(|line| line.starts_with("$ mech import "));
    let links = calls.filter_map(|line| line.split(['"', '\'']).nth(1));
    links.map(str::to_owned).collect()
}

/// A folder of this process.
pub(super) fn folder() -> Result<PathBuf, Finding> {
    let folder = std::env::temp_dir().join(format!("mech-fuzz-{}", std::process::id()));
    fs::create_dir_all(&folder).map_err(Finding::new)?;
    Ok(folder)
}

pub(super) fn examine(text: &str, name: &str) -> Result<bool, Finding> {
    let file = folder()?.join(name);
    fs::write(&file, text).map_err(Finding::new)?;
    let said = Said::default();
    let mut console = Console::to(said.clone(), said.clone());
    let words = ["mech".into(), "import".into(), file.into_os_string()];
    let code = mech_studio::run(words.map(|word: OsString| word), &mut console);
    let said = said.0.borrow();
    let said = String::from_utf8_lossy(&said);
    if code == ExitCode::from(70) || said.contains("internal error") {
        return Err(Finding::new(said));
    }
    // Whatever was wrong was told, and an answer is a text.
    if said.trim().is_empty() {
        return Err(Finding::new("nothing is said"));
    }
    Ok(said.contains("struct "))
}

/// What was said.
#[derive(Clone, Default)]
struct Said(Rc<RefCell<Vec<u8>>>);

impl Write for Said {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.borrow_mut().extend_from_slice(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
