//! The row of menus.

use super::dialog::ask_for;
use super::table::ACTIONS;
use super::{Action, Menu};
use crate::document::PartOffer;
use crate::edit::Command;
use crate::editor::Editor;
use crate::editor::example::EXAMPLES;
use crate::editor::names::Names;
use crate::editor::order::Export;
use crate::editor::question::{Destination, FileUse};
use crate::text::masked;
use eframe::egui;

pub(in crate::editor) fn menu(editor: &mut Editor, ui: &mut egui::Ui) {
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
        for action in ACTIONS.iter().filter(|action| ["Undo", "Redo"].contains(&action.name)) {
            entry(editor, action, ui);
        }
        mechanisms(editor, ui);
        let mark = if editor.workspace().has_work() { " •" } else { "" };
        let path = editor.workspace().path().display();
        ui.weak(masked(&format!("{path}{mark}")));
    });
}

/// The parts of the library. What one needs is written into the line, to be completed there.
fn parts(editor: &mut Editor, ui: &mut egui::Ui) {
    for offer in PartOffer::all() {
        let ports = offer.ports.join(", ");
        let response = ui.button(&offer.name);
        if response.on_hover_text(format!("needs links for: {ports}")).clicked() {
            propose_part(editor, &offer);
            ui.close();
        }
    }
}

/// Writes a use of a part into the line, with the links that are selected, to be completed there.
fn propose_part(editor: &mut Editor, offer: &PartOffer) {
    let path = format!("mech_runtime::parts::{}", offer.name);
    if !editor.workspace().text().contains(&path) {
        editor.perform(Command::Use { body: path });
    }
    let ground = std::iter::once("ground".to_owned());
    let links: Vec<String> = ground.chain(editor.selection.links()).collect();
    let name = Names::of(editor.drawing()).numbered(&offer.name.to_lowercase());
    editor.talk.proposed = Some(format!("use {}", offer.use_as(&name, &links)));
}

/// The mechanisms of the file, if there are several, to choose one.
fn mechanisms(editor: &mut Editor, ui: &mut egui::Ui) {
    let declarations = editor.analysis.snapshot.document.declarations();
    if declarations.len() < 2 {
        return;
    }
    let names = declarations
        .iter()
        .map(|one| one.name.clone().unwrap_or_else(|| "without a name".to_owned()));
    let names: Vec<String> = names.collect();
    let index = editor.workspace().index();
    let mut chosen = index;
    egui::ComboBox::from_label("mechanism")
        .selected_text(names.get(index).cloned().unwrap_or_default())
        .show_index(ui, &mut chosen, names.len(), |index| {
            names.get(index).cloned().unwrap_or_default()
        });
    if chosen != index {
        editor.choose_mechanism(chosen);
    }
}

/// Shows the examples, and all kinds of files that can be written.
fn files(editor: &mut Editor, ui: &mut egui::Ui) {
    ui.menu_button("Examples", |ui| {
        for example in &EXAMPLES {
            if ui.button(example.name).on_hover_text(example.help).clicked() {
                editor.leave_for(Destination::Example(example));
                ui.close();
            }
        }
    });
    ui.menu_button("Export", |ui| {
        for kind in Export::ALL {
            if ui.button(kind.name()).clicked() {
                ask_for(editor, FileUse::Export(kind));
                ui.close();
            }
        }
    });
}

fn entry(editor: &mut Editor, action: &Action, ui: &mut egui::Ui) {
    let mut button = egui::Button::new(action.name);
    if let Some(key) = action.key.filter(|_| egui::containers::menu::is_in_menu(ui)) {
        button = button.shortcut_text(ui.ctx().format_shortcut(&key));
    }
    let response = ui.add_enabled((action.is_possible)(editor), button);
    if response.on_hover_text(action.help).clicked() {
        (action.perform)(editor);
        ui.close();
    }
}
