//! The keys.

use super::Action;
use super::table::{ACTIONS, copy, paste};
use crate::editor::{Editor, Tool};
use eframe::egui::{self, Key, KeyboardShortcut, Modifiers};

pub(in crate::editor) const fn key_of_tool(tool: Tool) -> KeyboardShortcut {
    let key = match tool {
        Tool::Select => Key::V,
        Tool::Bar => Key::B,
        Tool::Pivot => Key::G,
        Tool::Pin => Key::P,
        Tool::Slider => Key::S,
        Tool::Slot => Key::L,
        Tool::Wheel => Key::W,
        Tool::Gear => Key::E,
        Tool::Belt => Key::T,
        Tool::Weld => Key::D,
        Tool::Motor => Key::M,
        Tool::Point => Key::O,
        Tool::Trace => Key::R,
        Tool::Spring => Key::N,
        Tool::Damper => Key::A,
        Tool::Force => Key::F,
        Tool::Disc => Key::C,
    };
    KeyboardShortcut::new(Modifiers::NONE, key)
}

/// Does what the keys say, unless somebody types. The drawing, or something in it, may have the focus.
pub(in crate::editor) fn obey_keys(
    editor: &mut Editor,
    is_canvas_focused: bool,
    context: &egui::Context,
) {
    // While something is asked, keys answer it.
    if context.memory(|memory| memory.top_modal_layer().is_some()) {
        return;
    }
    let types = context.text_edit_focused();
    let has_shift = |action: &Action| action.key.is_some_and(|key| key.modifiers.shift);
    // A key without Shift is also found where Shift is held.
    let (with_shift, others): (Vec<_>, Vec<_>) =
        ACTIONS.iter().partition(|action| has_shift(action));
    for action in with_shift.into_iter().chain(others) {
        let Some(key) = action.key else {
            continue;
        };
        // In a text, its own keys count first.
        if types
            && (key.modifiers.is_none()
                || [Key::A, Key::C, Key::V, Key::Z].contains(&key.logical_key))
        {
            continue;
        }
        // The system makes events of these keys.
        if is_clipboard(key) {
            continue;
        }
        // The Space key on a focused button clicks that button.
        let is_of_button = key.logical_key == Key::Space
            && !is_canvas_focused
            && context.memory(egui::Memory::focused).is_some();
        if !is_of_button
            && context.input_mut(|input| input.consume_shortcut(&key))
            && (action.is_possible)(editor)
        {
            (action.perform)(editor);
        }
    }
    if types {
        return;
    }
    obey_clipboard(editor, context);
    for tool in Tool::all() {
        if context.input_mut(|input| input.consume_shortcut(&key_of_tool(tool))) {
            editor.choose(tool);
        }
    }
}

/// Whether the system makes an event of a key, instead of telling the key.
fn is_clipboard(key: KeyboardShortcut) -> bool {
    key.modifiers == Modifiers::COMMAND && [Key::C, Key::V].contains(&key.logical_key)
}

fn obey_clipboard(editor: &mut Editor, context: &egui::Context) {
    let events = context.input(|input| input.events.clone());
    for event in events {
        match event {
            egui::Event::Copy if !editor.selection().is_empty() => copy(editor),
            egui::Event::Paste(text) => paste(editor, &text),
            _ => {}
        }
    }
}
