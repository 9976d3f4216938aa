//! The numbers of what is selected.

use super::behind::behind;
use super::field::field;
use super::motor::motor;
use super::shapes::shapes;
use crate::edit::{Command, Kind};
use crate::editor::pending::Waiting;
use crate::editor::{Editor, Gesture, Item};
use eframe::egui;

/// The numbers of what is selected, with what can be done to it.
pub(in crate::editor) fn properties(editor: &mut Editor, ui: &mut egui::Ui) {
    let selected: Vec<Item> = editor.selection.items.iter().cloned().collect();
    if selected.is_empty() {
        ui.weak("Nothing is selected. Click a link, a joint or a point.");
        whole(editor, ui);
        behind(editor, ui);
        return;
    }
    let mut gestures: Vec<Gesture> = Vec::new();
    egui::ScrollArea::vertical()
        .auto_shrink(false)
        .show(ui, |ui| {
            for item in &selected {
                ui.heading(item.to_string());
                buttons(editor, item, ui, &mut gestures);
                numbers(editor, item.name(), ui, &mut gestures);
                match item {
                    Item::Link(name) => {
                        mass(editor, name, ui, &mut gestures);
                        shapes(editor, name, ui, &mut gestures);
                    }
                    Item::Joint(name) => motor(editor, name, ui, &mut gestures),
                    Item::Axis(_) | Item::Action(_) => {}
                }
                ui.separator();
            }
            behind(editor, ui);
        });
    for gesture in gestures {
        editor.perform(gesture);
    }
}

/// What is said of the whole mechanism.
fn whole(editor: &mut Editor, ui: &mut egui::Ui) {
    let mut gestures = Vec::new();
    ui.separator();
    let constants: Vec<String> = editor
        .analysis
        .snapshot
        .listing
        .constants()
        .map(ToOwned::to_owned)
        .collect();
    for constant in constants {
        ui.label(&constant);
        numbers(editor, &constant, ui, &mut gestures);
    }
    ui.horizontal_wrapped(|ui| {
        ui.label("Look");
        for look in ["machine", "diagram", "none"] {
            if ui.button(look).clicked() {
                gestures.push(
                    Command::Setting {
                        statement: format!("look {look}"),
                    }
                    .into(),
                );
            }
        }
    });
    for gesture in gestures {
        editor.perform(gesture);
    }
}

/// What can be done to something.
fn buttons(editor: &mut Editor, item: &Item, ui: &mut egui::Ui, gestures: &mut Vec<Gesture>) {
    let name = item.name().to_owned();
    ui.horizontal_wrapped(|ui| {
        let (kind, word) = match item {
            Item::Link(_) => (Kind::Link, "link"),
            Item::Joint(_) => (Kind::Joint, "joint"),
            Item::Axis(_) => (Kind::Axis, "point"),
            Item::Action(_) => (Kind::Action, "action"),
        };
        if ui
            .button("Delete")
            .on_hover_text(format!("removes the {word}"))
            .clicked()
        {
            gestures.push(
                Command::Remove {
                    kind,
                    name: name.clone(),
                }
                .into(),
            );
        }
        match item {
            Item::Link(_) => {
                if ui
                    .button("Mirror")
                    .on_hover_text("mirrors what is fixed to it")
                    .clicked()
                {
                    gestures.push(Command::Mirror { name: name.clone() }.into());
                }
                if ui
                    .button("Duplicate")
                    .on_hover_text("declares it once more")
                    .clicked()
                {
                    editor.wait(Waiting::Copies(vec![name.clone()]));
                }
            }
            Item::Joint(_) => {
                let has_motor = editor
                    .drawing()
                    .is_some_and(|drawing| drawing.has_motor(&name));
                if has_motor {
                    if ui.button("Take the motor away").clicked() {
                        gestures.push(
                            Command::Remove {
                                kind: Kind::Motor,
                                name: name.clone(),
                            }
                            .into(),
                        );
                    }
                } else if ui.button("Put a motor on it").clicked() {
                    gestures.push(
                        Command::Motor {
                            joint: name.clone(),
                            law: None,
                            range: None,
                            step: None,
                        }
                        .into(),
                    );
                }
            }
            Item::Axis(_) => {
                if ui
                    .button("Trace")
                    .on_hover_text("records its path")
                    .clicked()
                {
                    gestures.push(
                        Command::Trace {
                            point: name.clone(),
                            length: "256".to_owned(),
                        }
                        .into(),
                    );
                }
            }
            Item::Action(_) => {}
        }
    });
    let last = name.rsplit('.').next().unwrap_or_default().to_owned();
    field(ui, &format!("name of {name}"), "name", &last, |typed| {
        gestures.push(
            Command::Rename {
                path: name.clone(),
                name: typed,
            }
            .into(),
        );
    });
}

/// The numbers of something, each as it stands in the text.
fn numbers(editor: &Editor, owner: &str, ui: &mut egui::Ui, gestures: &mut Vec<Gesture>) {
    let text = editor.analysis.snapshot.document.source().text();
    let numbers = editor.analysis.snapshot.listing.numbers_of(owner);
    let numbers: Vec<(String, String)> = numbers
        .filter(|one| !one.is_pair)
        .filter_map(|one| Some((one.role.clone(), text.get(one.place.clone())?.to_owned())))
        .collect();
    for (role, value) in numbers {
        field(ui, &format!("{role} of {owner}"), &role, &value, |typed| {
            gestures.push(
                Command::Set {
                    owner: owner.to_owned(),
                    role: role.clone(),
                    value: typed,
                }
                .into(),
            );
        });
    }
}

/// The mass of a link, if it has none yet; else that is among its numbers.
fn mass(editor: &Editor, link: &str, ui: &mut egui::Ui, gestures: &mut Vec<Gesture>) {
    if editor
        .analysis
        .snapshot
        .listing
        .number(link, "mass")
        .is_some()
    {
        return;
    }
    field(ui, &format!("mass of {link}"), "mass", "", |typed| {
        gestures.push(
            Command::Mass {
                link: link.to_owned(),
                mass: typed,
                at: None,
                inertia: None,
            }
            .into(),
        );
    });
}
