//! The dialogue: a line that is refused changes nothing, and undo gives the very text.

use crate::finding::Finding;
use mech_studio::Workspace;
use mech_studio::editor::Editor;

/// Between a text and the lines that change it.
const BETWEEN: &str = "\n----\n";

/// Lines that read and write files are left out, as are those that never end.
const FILES: [&str; 8] = ["draw", "film", "save", "open", "play", "-o", "--output", "--picture"];

/// The scripts in dialogues, each below a text.
pub(super) fn scripts(dialogues: &[String], mechanisms: &[String]) -> Vec<String> {
    let mut scripts = Vec::new();
    for (number, dialogue) in dialogues.iter().enumerate() {
        for (index, scene) in dialogue.split("\n## ").enumerate() {
            let lines = scene.lines().filter_map(|line| line.strip_prefix("> "));
            let lines: Vec<&str> = lines.collect();
            let text = &mechanisms[(7 * number + index) % mechanisms.len()];
            if !lines.is_empty() && text.len() < 1500 {
                scripts.push(format!("{text}{BETWEEN}{}\n", lines.join("\n")));
            }
        }
    }
    scripts
}

pub(super) fn examine(script: &str) -> Result<bool, Finding> {
    let (text, lines) = script.split_once(BETWEEN).unwrap_or(("", script));
    let mut editor = Editor::immediate(Workspace::proposed("a.mech", text));
    let mut is_understood = false;
    for line in lines.lines() {
        if line.split(' ').any(|word| FILES.iter().any(|file| word.starts_with(file))) {
            continue;
        }
        let before = editor.workspace().text().to_owned();
        editor.say(line);
        let after = editor.workspace().text().to_owned();
        if let Some(notice) = editor.notice() {
            if notice.text.contains("internal error") {
                return Err(Finding::new(&notice.text));
            }
            is_understood |= !notice.is_refusal;
            if notice.is_refusal && after != before {
                return Err(Finding::new("a line that is refused changes the text"));
            }
        }
        let is_way = matches!(line.trim(), "undo" | "redo");
        if after != before && !is_way {
            editor.undo();
            if editor.workspace().text() != before {
                return Err(Finding::new("undo gives another text"));
            }
            editor.redo();
            if editor.workspace().text() != after {
                return Err(Finding::new("redo gives another text"));
            }
        }
    }
    Ok(is_understood)
}
