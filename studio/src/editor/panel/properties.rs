//! The numbers of what is selected.

use super::behind::behind;
use super::field::field;
use super::motor::motor;
use super::shapes::shapes;
use crate::document::Listing;
use crate::edit::{Command, Kind};
use crate::editor::pending::Waiting;
use crate::editor::snapshot::Snapshot;
use crate::editor::{Editor, Item};
use eframe::egui;

/// The numbers of what is selected, with what can be done to it.
pub(in crate::editor) fn properties(editor: &mut Editor, ui: &mut egui::Ui) {
    let selected: Vec<Item> = editor.selection.items.iter().cloned().collect();
    let mut commands = Vec::new();
    if selected.is_empty() {
        ui.weak("Nothing is selected. Click a link, a joint or a point.");
        whole(&editor.analysis.snapshot, ui, &mut commands);
        behind(editor, ui);
    } else {
        egui::ScrollArea::vertical()
            .auto_shrink(false)
            .show(ui, |ui| {
                for item in &selected {
                    ui.heading(item.to_string());
                    buttons(editor, item, ui, &mut commands);
                    numbers(&editor.analysis.snapshot, item.name(), ui, &mut commands);
                    match item {
                        Item::Link(name) => {
                            mass(&editor.analysis.snapshot.listing, name, ui, &mut commands);
                            shapes(editor.drawing(), name, ui, &mut commands);
                        }
                        Item::Joint(name) => {
                            let listing = &editor.analysis.snapshot.listing;
                            motor(&editor.sight, listing, name, ui, &mut commands);
                        }
                        Item::Axis(_) | Item::Action(_) => {}
                    }
                    ui.separator();
                }
                behind(editor, ui);
            });
    }
    for command in commands {
        editor.perform(command);
    }
}

/// Shows the properties of the whole mechanism.
fn whole(snapshot: &Snapshot, ui: &mut egui::Ui, commands: &mut Vec<Command>) {
    ui.separator();
    for constant in snapshot.listing.constants() {
        ui.label(constant);
        numbers(snapshot, constant, ui, commands);
    }
    ui.horizontal_wrapped(|ui| {
        ui.label("Look");
        for look in ["machine", "diagram", "none"] {
            if ui.button(look).clicked() {
                commands.push(Command::Setting {
                    statement: format!("look {look}"),
                });
            }
        }
    });
}

fn buttons(editor: &mut Editor, item: &Item, ui: &mut egui::Ui, commands: &mut Vec<Command>) {
    let name = item.name().to_owned();
    ui.horizontal_wrapped(|ui| {
        let (kind, word) = match item {
            Item::Link(_) => (Kind::Link, "link"),
            Item::Joint(_) => (Kind::Joint, "joint"),
            Item::Axis(_) => (Kind::Axis, "point"),
            Item::Action(_) => (Kind::Action, "action"),
        };
        if button("Delete", &format!("removes the {word}"), ui) {
            commands.push(Command::Remove {
                kind,
                name: name.clone(),
            });
        }
        match item {
            Item::Link(_) => {
                if button("Mirror", "mirrors what is fixed to it", ui) {
                    commands.push(Command::Mirror { name: name.clone() });
                }
                if button("Duplicate", "declares it once more", ui) {
                    editor.wait(Waiting::Copies(vec![name.clone()]));
                }
            }
            Item::Joint(_) => {
                if editor.sight.has_motor(&name) {
                    if ui.button("Take the motor away").clicked() {
                        commands.push(Command::Remove {
                            kind: Kind::Motor,
                            name: name.clone(),
                        });
                    }
                } else if ui.button("Put a motor on it").clicked() {
                    commands.push(Command::Motor {
                        joint: name.clone(),
                        law: None,
                        range: None,
                        step: None,
                    });
                }
            }
            Item::Axis(_) => {
                if button("Trace", "records its path", ui) {
                    commands.push(Command::Trace {
                        point: name.clone(),
                        length: "256".to_owned(),
                    });
                }
            }
            Item::Action(_) => {}
        }
    });
    let last = name.rsplit('.').next().unwrap_or_default().to_owned();
    field(ui, &format!("name of {name}"), "name", &last, |typed| {
        commands.push(Command::Rename {
            path: name.clone(),
            name: typed,
        });
    });
}

/// A button with its help. Returns whether it is clicked.
fn button(text: &str, help: &str, ui: &mut egui::Ui) -> bool {
    ui.button(text).on_hover_text(help).clicked()
}

/// The numbers of something, each as it stands in the text.
fn numbers(snapshot: &Snapshot, owner: &str, ui: &mut egui::Ui, commands: &mut Vec<Command>) {
    let text = snapshot.document.source().text();
    let numbers = snapshot.listing.numbers_of(owner);
    let numbers: Vec<(String, String)> = numbers
        .filter(|one| !one.is_pair)
        .filter_map(|one| Some((one.role.clone(), text.get(one.place.clone())?.to_owned())))
        .collect();
    for (role, value) in numbers {
        field(ui, &format!("{role} of {owner}"), &role, &value, |typed| {
            commands.push(Command::Set {
                owner: owner.to_owned(),
                role: role.clone(),
                value: typed,
            });
        });
    }
}

/// The mass of a link, if it has none yet; else that is among its numbers.
fn mass(listing: &Listing, link: &str, ui: &mut egui::Ui, commands: &mut Vec<Command>) {
    if listing.number(link, "mass").is_some() {
        return;
    }
    field(ui, &format!("mass of {link}"), "mass", "", |typed| {
        commands.push(Command::Mass {
            link: link.to_owned(),
            mass: typed,
            at: None,
            inertia: None,
        });
    });
}
