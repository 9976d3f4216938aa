//! What is copied and pasted.

use crate::editor::Editor;
use crate::editor::pending::Waiting;

/// Notes the selected links, with what is between them.
pub(super) fn copy(editor: &mut Editor) {
    let links = editor.selection.links().collect();
    let copied = editor.clipboard.copy(&links, &editor.session.workspace);
    editor.talk.tell_done(copied);
}

/// Declares what was copied, here or elsewhere.
pub(super) fn paste(editor: &mut Editor, text: &str) {
    if let Some(text) = editor.clipboard.to_paste(text) {
        editor.wait(Waiting::Paste(text));
    } else {
        let why = "nothing was copied that can be pasted; select links and copy them";
        editor.talk.refuse(why);
    }
}
