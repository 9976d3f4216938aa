//! The file of a desk: whatever is in it, the studio opens.

use super::import::folder;
use crate::finding::Finding;
use mech_studio::editor::Editor;
use mech_studio::{Source, Workspace};
use std::fs;

const TEXT: &str = "\
struct Pair;
link crank { point pin = (1, 0); }
link rod;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank.pin, rod);
motor a; motor b;
";

pub(super) fn examine(record: &str) -> Result<bool, Finding> {
    let path = folder()?.join("a.mech");
    let desk = path.with_file_name(".a.mech.desk");
    fs::write(&desk, record)
        .map_err(|error| Finding::new(format!("{}: {error}", desk.display())))?;
    let mut editor = Editor::immediate(Workspace::of(Source::new(&path, TEXT)));
    // The picture that it names is not there.
    let says_nothing = |text: &str| text.contains("linkage.png");
    let is_understood = editor.notice().is_none_or(|notice| says_nothing(&notice.text));
    let items: Vec<_> = editor
        .drawing()
        .into_iter()
        .flat_map(|drawing| drawing.handles().map(|handle| handle.item.clone()))
        .collect();
    for item in items {
        editor.select(Some(item.clone()), false);
        editor.begin_drag(&item, false);
        editor.drag_to([0.5, 0.5]);
        editor.end_drag();
        editor.remove_selected();
    }
    let is_whole = editor.workspace().text().starts_with("struct Pair;");
    match editor.notice() {
        Some(notice) if notice.text.contains("internal error") => Err(Finding::new(&notice.text)),
        _ if is_whole => Ok(is_understood),
        _ => Err(Finding::new("a desk changes the text")),
    }
}
