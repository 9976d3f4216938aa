//! What can be done besides drawing: one table, from which come menus, keys, tooltips and help.

use super::example::EXAMPLES;
use super::export::Export;
use super::panel::Panel;
use super::settings::Visible;
use super::{Editor, Tool};
use crate::document::PartOffer;
use crate::edit::Workspace;
use crate::play::Control;
use eframe::egui;
use eframe::egui::{Key, KeyboardShortcut, Modifiers};
use std::path::Path;

/// The menus, from left to right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Menu {
    File,
    Edit,
    View,
    Play,
}

impl Menu {
    const ALL: [(Self, &'static str); 4] = [
        (Self::File, "File"),
        (Self::Edit, "Edit"),
        (Self::View, "View"),
        (Self::Play, "Motion"),
    ];
}

/// A thing that can be done.
struct Action {
    menu: Menu,
    name: &'static str,
    help: &'static str,
    key: Option<KeyboardShortcut>,
    is_possible: fn(&Editor) -> bool,
    perform: fn(&mut Editor),
}

const fn with_command(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND, key)
}

const fn alone(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

const ALWAYS: fn(&Editor) -> bool = |_| true;
const MOVES: fn(&Editor) -> bool = |editor| editor.player().is_some();
const SELECTED: fn(&Editor) -> bool = |editor| !editor.selection().is_empty();

const ACTIONS: &[Action] = &[
    Action {
        menu: Menu::File,
        name: "New",
        help: "begins with an empty text",
        key: Some(with_command(Key::N)),
        is_possible: ALWAYS,
        perform: |editor| {
            if editor.may_leave() {
                editor.open(Workspace::default());
            }
        },
    },
    Action {
        menu: Menu::File,
        name: "Open",
        help: "reads a file: of the language, of Linkage, or a link of PMKS+",
        key: Some(with_command(Key::O)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.dialog = Some(Dialog::Open(String::new())),
    },
    Action {
        menu: Menu::File,
        name: "Save",
        help: "writes the text",
        key: Some(with_command(Key::S)),
        is_possible: ALWAYS,
        perform: |editor| {
            if editor.workspace().is_named() {
                let saved = editor.save(None);
                editor.refuse_failed(saved);
            } else {
                editor.settings.dialog = Some(Dialog::Save(String::new()));
            }
        },
    },
    Action {
        menu: Menu::File,
        name: "Save as",
        help: "writes the text to a new file",
        key: Some(KeyboardShortcut::new(
            Modifiers::COMMAND.plus(Modifiers::SHIFT),
            Key::S,
        )),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.dialog = Some(Dialog::Save(String::new())),
    },
    Action {
        menu: Menu::Edit,
        name: "Undo",
        help: "undoes the last step",
        key: Some(with_command(Key::Z)),
        is_possible: |editor| !editor.workspace().history().made().is_empty(),
        perform: Editor::undo,
    },
    Action {
        menu: Menu::Edit,
        name: "Redo",
        help: "makes it again",
        key: Some(KeyboardShortcut::new(
            Modifiers::COMMAND.plus(Modifiers::SHIFT),
            Key::Z,
        )),
        is_possible: |editor| !editor.workspace().history().undone().is_empty(),
        perform: Editor::redo,
    },
    Action {
        menu: Menu::Edit,
        name: "Delete",
        help: "removes what is selected",
        key: Some(alone(Key::Delete)),
        is_possible: SELECTED,
        perform: Editor::remove_selected,
    },
    Action {
        menu: Menu::Edit,
        name: "Select all",
        help: "selects all links",
        key: Some(with_command(Key::A)),
        is_possible: |editor| editor.drawing().is_some(),
        perform: Editor::select_all,
    },
    Action {
        menu: Menu::Edit,
        name: "Copy",
        help: "notes the selected links, to be pasted",
        key: Some(with_command(Key::C)),
        is_possible: SELECTED,
        perform: Editor::copy,
    },
    Action {
        menu: Menu::Edit,
        name: "Paste",
        help: "declares the copied links once more",
        key: Some(with_command(Key::V)),
        is_possible: |editor| !editor.copied.is_empty(),
        perform: Editor::paste,
    },
    Action {
        menu: Menu::Edit,
        name: "Stop the tool",
        help: "forgets what was picked, and selects again",
        key: Some(alone(Key::Escape)),
        is_possible: ALWAYS,
        perform: |editor| {
            editor.choose(Tool::Select);
            editor.selection.clear();
        },
    },
    Action {
        menu: Menu::View,
        name: "See everything",
        help: "fits the whole motion into the window",
        key: Some(alone(Key::Home)),
        is_possible: ALWAYS,
        perform: Editor::fit,
    },
    Action {
        menu: Menu::View,
        name: "Snap",
        help: "lets places snap to the grid and to what is near; Alt does the other",
        key: Some(alone(Key::Num1)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.snaps ^= true,
    },
    Action {
        menu: Menu::View,
        name: "Grid",
        help: "shows the grid",
        key: Some(alone(Key::Num2)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.toggle(Visible::Grid),
    },
    Action {
        menu: Menu::View,
        name: "Names",
        help: "shows the names of joints and links",
        key: Some(alone(Key::Num3)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.toggle(Visible::Names),
    },
    Action {
        menu: Menu::View,
        name: "Bodies",
        help: "shows the bodies of links; without, the schematic",
        key: Some(alone(Key::Num4)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.toggle(Visible::Bodies),
    },
    Action {
        menu: Menu::View,
        name: "Paths",
        help: "shows the whole paths of traced points",
        key: Some(alone(Key::Num5)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.toggle(Visible::Paths),
    },
    Action {
        menu: Menu::View,
        name: "Velocities",
        help: "shows the velocities of points as arrows, at 1 rad or unit per second of the plotted motor",
        key: Some(alone(Key::Num7)),
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::Velocities),
    },
    Action {
        menu: Menu::View,
        name: "Accelerations",
        help: "shows the accelerations of points as arrows, at the same rate",
        key: Some(alone(Key::Num8)),
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::Accelerations),
    },
    Action {
        menu: Menu::View,
        name: "Forces",
        help: "shows the forces in joints as arrows; masses, springs and gravity act",
        key: Some(alone(Key::Num9)),
        is_possible: MOVES,
        perform: |editor| editor.settings.toggle(Visible::Forces),
    },
    Action {
        menu: Menu::View,
        name: "Day or night",
        help: "dark on light, or light on dark",
        key: Some(alone(Key::Num6)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.is_dark ^= true,
    },
    Action {
        menu: Menu::View,
        name: "Help",
        help: "shows what can be done",
        key: Some(alone(Key::F1)),
        is_possible: ALWAYS,
        perform: |editor| editor.settings.panel = Some(Panel::Help),
    },
    Action {
        menu: Menu::Play,
        name: "Play or pause",
        help: "lets the motors move",
        key: Some(alone(Key::Space)),
        is_possible: MOVES,
        perform: |editor| editor.obey(Control::PlayOrPause),
    },
    Action {
        menu: Menu::Play,
        name: "Step forward",
        help: "moves by one step",
        key: Some(alone(Key::Period)),
        is_possible: MOVES,
        perform: |editor| editor.obey(Control::Step(1.0)),
    },
    Action {
        menu: Menu::Play,
        name: "Step back",
        help: "moves back by one step",
        key: Some(alone(Key::Comma)),
        is_possible: MOVES,
        perform: |editor| editor.obey(Control::Step(-1.0)),
    },
    Action {
        menu: Menu::Play,
        name: "Reverse",
        help: "plays the other way",
        key: Some(alone(Key::Backspace)),
        is_possible: MOVES,
        perform: |editor| editor.obey(Control::Reverse),
    },
    Action {
        menu: Menu::Play,
        name: "Next motor",
        help: "plays the next motor alone; after the last, all",
        key: Some(alone(Key::Plus)),
        is_possible: MOVES,
        perform: |editor| editor.obey(Control::NextMotor),
    },
    Action {
        menu: Menu::Play,
        name: "Back to the start",
        help: "puts all motors where they start",
        key: Some(alone(Key::Num0)),
        is_possible: MOVES,
        perform: |editor| editor.obey(Control::Reset),
    },
];

/// The key of a tool.
pub(super) const fn key_of_tool(tool: Tool) -> KeyboardShortcut {
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

/// Does what the keys say, unless somebody types.
pub(super) fn obey_keys(editor: &mut Editor, context: &egui::Context) {
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
        // What a focused button does is its own affair.
        let is_of_button = key.logical_key == Key::Space
            && !editor.is_canvas_focused
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
    for tool in Tool::all() {
        if context.input_mut(|input| input.consume_shortcut(&key_of_tool(tool))) {
            editor.choose(tool);
        }
    }
}

/// The row of menus.
pub(super) fn menu(editor: &mut Editor, ui: &mut egui::Ui) {
    egui::MenuBar::new().ui(ui, |ui| {
        for (menu, name) in Menu::ALL {
            ui.menu_button(name, |ui| {
                for action in ACTIONS.iter().filter(|action| action.menu == menu) {
                    entry(editor, action, ui);
                }
                if menu == Menu::Edit {
                    ui.menu_button("Use a part", |ui| parts(editor, ui));
                }
                if menu == Menu::File {
                    files(editor, ui);
                }
            });
        }
        for action in ACTIONS
            .iter()
            .filter(|action| ["Undo", "Redo"].contains(&action.name))
        {
            entry(editor, action, ui);
        }
        mechanisms(editor, ui);
        let mark = if editor.workspace().is_changed() {
            " •"
        } else {
            ""
        };
        ui.weak(format!("{}{mark}", editor.workspace().path().display()));
    });
}

/// The parts of the library. What one needs is written into the line, to be completed there.
fn parts(editor: &mut Editor, ui: &mut egui::Ui) {
    for offer in PartOffer::all() {
        let ports = offer.ports.join(", ");
        let response = ui.button(&offer.name);
        if response
            .on_hover_text(format!("is lent: {ports}"))
            .clicked()
        {
            editor.propose_part(&offer);
            ui.close();
        }
    }
}

/// The mechanisms of the file, if there are several, to choose one.
fn mechanisms(editor: &mut Editor, ui: &mut egui::Ui) {
    let declarations = editor.snapshot.document.declarations();
    if declarations.len() < 2 {
        return;
    }
    let names = declarations.iter().map(|one| {
        one.name
            .clone()
            .unwrap_or_else(|| "without a name".to_owned())
    });
    let names: Vec<String> = names.collect();
    let index = editor.workspace().index();
    let mut chosen = index;
    egui::ComboBox::from_label("mechanism")
        .selected_text(names.get(index).cloned().unwrap_or_default())
        .show_index(ui, &mut chosen, names.len(), |index| names[index].clone());
    if chosen != index {
        editor.choose_mechanism(chosen);
    }
}

/// What the menu of files offers besides: examples, and all kinds of files that can be written.
fn files(editor: &mut Editor, ui: &mut egui::Ui) {
    ui.menu_button("Examples", |ui| {
        for example in &EXAMPLES {
            if ui
                .button(example.name)
                .on_hover_text(example.help)
                .clicked()
            {
                editor.open_example(example);
                ui.close();
            }
        }
    });
    ui.menu_button("Export", |ui| {
        for kind in Export::ALL {
            if ui.button(kind.name()).clicked() {
                editor.settings.dialog = Some(Dialog::Export(kind, editor.export_path(kind)));
                ui.close();
            }
        }
    });
}

fn entry(editor: &mut Editor, action: &Action, ui: &mut egui::Ui) {
    let mut button = egui::Button::new(action.name);
    if let Some(key) = action
        .key
        .filter(|_| egui::containers::menu::is_in_menu(ui))
    {
        button = button.shortcut_text(ui.ctx().format_shortcut(&key));
    }
    let response = ui.add_enabled((action.is_possible)(editor), button);
    if response.on_hover_text(action.help).clicked() {
        (action.perform)(editor);
        ui.close();
    }
}

/// All tools and actions, with their keys.
pub(super) fn help(ui: &mut egui::Ui) {
    ui.heading("Tools");
    egui::Grid::new("tools")
        .num_columns(3)
        .striped(true)
        .show(ui, |ui| {
            for tool in Tool::all() {
                ui.strong(tool.name());
                ui.monospace(ui.ctx().format_shortcut(&key_of_tool(tool)));
                ui.label(tool.help());
                ui.end_row();
            }
        });
    ui.heading("Actions");
    egui::Grid::new("actions")
        .num_columns(3)
        .striped(true)
        .show(ui, |ui| {
            for action in ACTIONS {
                ui.strong(action.name);
                ui.monospace(
                    action
                        .key
                        .map(|key| ui.ctx().format_shortcut(&key))
                        .unwrap_or_default(),
                );
                ui.label(action.help);
                ui.end_row();
            }
        });
}

/// Something that is asked in a window of its own.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Dialog {
    /// Which file is read.
    Open(String),
    /// Where the text is written.
    Save(String),
    /// Where something of this kind is written.
    Export(Export, String),
}

/// Asks what has to be asked.
pub(super) fn dialogs(editor: &mut Editor, context: &egui::Context) {
    let Some(mut dialog) = editor.settings.dialog.take() else {
        return;
    };
    let (title, verb) = match dialog {
        Dialog::Open(_) => ("Open a file", "Open"),
        Dialog::Save(_) => ("Save to a file", "Save"),
        Dialog::Export(kind, _) => (kind.name(), "Write"),
    };
    #[cfg(not(target_arch = "wasm32"))]
    let beside = editor.workspace().path().parent().map(Path::to_owned);
    let (mut is_done, mut is_given_up) = (false, false);
    egui::Modal::new(egui::Id::unique("dialog")).show(context, |ui| {
        ui.heading(title);
        let label = ui.label("File");
        let (Dialog::Open(path) | Dialog::Save(path) | Dialog::Export(_, path)) = &mut dialog;
        let edit = egui::TextEdit::singleline(path)
            .hint_text("four_bar.mech")
            .desired_width(320.0);
        let response = ui.add(edit).labelled_by(label.id);
        if !response.lost_focus() && !is_focus_in(ui) {
            response.request_focus();
        }
        is_done = response.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        #[cfg(not(target_arch = "wasm32"))]
        {
            let is_saved = !matches!(dialog, Dialog::Open(_));
            let is_chosen = super::files::choose(&mut dialog, &beside.unwrap_or_default(), ui);
            // A file that is there is not written over by a slip.
            is_done |= is_chosen && !is_saved;
        }
        ui.horizontal(|ui| {
            is_done |= ui.button(verb).clicked();
            is_given_up =
                ui.button("Cancel").clicked() || ui.input(|input| input.key_pressed(Key::Escape));
        });
    });
    if is_done {
        editor.finish(&dialog);
    } else if !is_given_up {
        editor.settings.dialog = Some(dialog);
    }
}

/// Whether the keys go to something in this window of its own.
fn is_focus_in(ui: &egui::Ui) -> bool {
    let focused = ui.memory(egui::Memory::focused);
    let focused = focused.and_then(|focused| ui.ctx().read_response(focused));
    focused.is_some_and(|focused| focused.layer_id == ui.layer_id())
}

impl Editor {
    /// Does what was asked for.
    fn finish(&mut self, dialog: &Dialog) {
        match dialog {
            Dialog::Open(path) => self.open_named(path),
            Dialog::Export(kind, path) => self.export(*kind, path),
            Dialog::Save(path) => {
                let saved = self.save(Some(Path::new(path)));
                self.refuse_failed(saved);
            }
        }
    }
}
