//! The numbers of what is selected.

use super::field::field;
use super::shapes::shapes;
use crate::document::Listing;
use crate::edit::{Command, Kind};
use crate::editor::pending::Waiting;
use crate::editor::sight::Sight;
use crate::editor::snapshot::Snapshot;
use crate::editor::{Editor, Item};
use crate::motion::Basis;
use crate::text::masked;
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
        egui::ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
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
                commands.push(Command::Setting { statement: format!("look {look}") });
            }
        }
    });
}

fn buttons(editor: &mut Editor, item: &Item, ui: &mut egui::Ui, commands: &mut Vec<Command>) {
    let name = item.name().to_owned();
    ui.horizontal_wrapped(|ui| {
        if button("Delete", &format!("removes the {}", item.word()), ui) {
            commands.push(item.removal());
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
                        commands.push(Command::Remove { kind: Kind::Motor, name: name.clone() });
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
                    commands.push(Command::Trace { point: name.clone(), length: "256".to_owned() });
                }
            }
            Item::Action(_) => {}
        }
    });
    let last = name.rsplit('.').next().unwrap_or_default().to_owned();
    field(ui, &format!("name of {name}"), "name", &last, |typed| {
        commands.push(Command::Rename { path: name.clone(), name: typed });
    });
}

/// A button with its help. Returns whether it is clicked.
fn button(text: &str, help: &str, ui: &mut egui::Ui) -> bool {
    ui.button(text).on_hover_text(help).clicked()
}

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

/// The motor of a joint: how far it goes, by how much at once, and its law.
pub(super) fn motor(
    sight: &Sight,
    listing: &Listing,
    joint: &str,
    ui: &mut egui::Ui,
    commands: &mut Vec<Command>,
) {
    if !sight.has_motor(joint) {
        start(listing, joint, ui, commands);
        return;
    }
    ui.strong("Motor");
    if listing.number(joint, "low").is_none() {
        let mut ranges = sight.playing.ranges.iter();
        let range = ranges.find(|range| range.name == joint);
        let walked = range.filter(|range| range.basis == Basis::Walked);
        let hint = walked.map_or_else(
            || "0 deg ..= 90 deg".to_owned(),
            |range| {
                let shown = |end| crate::text::shortest(range.shown(end), 0.5);
                let unit = if range.turns { " deg" } else { "" };
                let [low, high] = range.ends.map(shown);
                format!("{low}{unit} ..= {high}{unit}")
            },
        );
        field(ui, &format!("range of {joint}"), "range", "", |typed| {
            let (low, high) = typed.split_once("..=").unwrap_or((&typed, ""));
            commands.push(Command::Motor {
                joint: joint.to_owned(),
                law: None,
                range: Some([low.trim().to_owned(), high.trim().to_owned()]),
                step: None,
            });
        });
        ui.weak(format!("to be proved free, for example: {hint}"));
    }
    field(ui, &format!("law of {joint}"), "law", "", |typed| {
        commands.push(Command::Motor {
            joint: joint.to_owned(),
            law: Some(typed),
            range: None,
            step: None,
        });
    });
    ui.weak("its value by the time t, for example: 0.5 * sin(2 * PI * t)");
    start(listing, joint, ui, commands);
}

/// Where a joint starts, if the text does not say it yet; else that is among its numbers.
fn start(listing: &Listing, joint: &str, ui: &mut egui::Ui, commands: &mut Vec<Command>) {
    if listing.number(joint, "start").is_some() {
        return;
    }
    field(ui, &format!("start of {joint}"), "start", "", |typed| {
        commands.push(Command::Start { name: joint.to_owned(), is_near: false, value: typed });
    });
}

/// The picture behind the drawing, if there is one.
pub(super) fn behind(editor: &mut Editor, ui: &mut egui::Ui) {
    let places = editor.selection.places(editor.sight.drawing());
    let Some(backdrop) = &mut editor.desk.backdrop else {
        return;
    };
    let name = backdrop.path.file_name().unwrap_or_default();
    ui.separator();
    ui.heading(masked(&format!("picture {}", name.display())));
    let before = backdrop.place;
    let place = &mut backdrop.place;
    let step = 0.005 * place.width;
    egui::Grid::new("picture behind").num_columns(2).show(ui, |ui| {
        let [x, y] = &mut place.center;
        for (name, value) in [("x", x), ("y", y), ("width", &mut place.width)] {
            let least = if name == "width" { f64::MIN_POSITIVE } else { f64::MIN };
            let field = egui::DragValue::new(value).speed(step).range(least..=f64::MAX);
            number(name, field, ui);
        }
        let angle = egui::DragValue::new(&mut place.angle).suffix("°").speed(0.2);
        number("angle", angle, ui);
        let opacity = egui::DragValue::new(&mut place.opacity);
        number("opacity", opacity.range(0.0..=1.0).speed(0.01), ui);
    });
    if !backdrop.place.is_sound() {
        backdrop.place = before;
    }
    if let Some([from, to]) = places
        && let Some(factor) = factor_of(from, to, ui)
    {
        backdrop.place.scale_about(from, factor);
    }
    if ui.button("Remove the picture").clicked() {
        editor.desk.backdrop = None;
    }
}

fn number(name: &str, field: egui::DragValue<'_>, ui: &mut egui::Ui) {
    let label = ui.label(name);
    ui.add(field).labelled_by(label.id);
    ui.end_row();
}

/// Asks how far apart two places are in truth. Returns by which factor they are farther apart.
fn factor_of([x, y]: [f64; 2], [u, v]: [f64; 2], ui: &mut egui::Ui) -> Option<f64> {
    let drawn = (u - x).hypot(v - y);
    let mut value = drawn;
    ui.horizontal(|ui| {
        let label = ui.label("distance in it");
        let field = egui::DragValue::new(&mut value)
            .range(f64::MIN_POSITIVE..=f64::MAX)
            .update_while_editing(false)
            .max_decimals(6)
            .speed(0.0);
        ui.add(field)
            .labelled_by(label.id)
            .on_hover_text("how far apart the two selected places of the picture are in truth");
    });
    let factor = value / drawn;
    let is_changed = (value - drawn).abs() > 1e-6 * drawn;
    (is_changed && factor.is_finite() && factor > 0.0).then_some(factor)
}
