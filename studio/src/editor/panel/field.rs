//! A field in which a number or a name is typed.

use eframe::egui;
use std::collections::BTreeMap;

/// The texts that are typed into fields, until they are taken over.
type Typed = BTreeMap<String, String>;

/// A field whose text is taken over when it is left.
pub(super) fn field(
    ui: &mut egui::Ui,
    label: &str,
    shown: &str,
    value: &str,
    done: impl FnOnce(String),
) {
    let id = ui.make_persistent_id(("field", label));
    ui.horizontal(|ui| {
        ui.add_sized([110.0, 18.0], egui::Label::new(shown).truncate());
        let typed = ui.data(|data| data.get_temp::<Typed>(id)).unwrap_or_default();
        let mut text = typed.get(label).cloned().unwrap_or_else(|| value.to_owned());
        let edit = egui::TextEdit::singleline(&mut text)
            .id(id)
            .desired_width(150.0)
            .font(egui::TextStyle::Monospace);
        let response = ui.add(edit);
        response.widget_info(|| {
            let mut info = egui::WidgetInfo::labeled(egui::Role::TextInput, true, label);
            info.current_text_value = Some(text.clone());
            info
        });
        if response.lost_focus() {
            ui.data_mut(|data| data.remove::<Typed>(id));
            let is_given_up = ui.input(|input| input.key_pressed(egui::Key::Escape));
            if text != value && !is_given_up && !text.trim().is_empty() {
                done(text);
            }
        } else if response.changed() {
            let typed = Typed::from([(label.to_owned(), text)]);
            ui.data_mut(|data| data.insert_temp(id, typed));
        }
    });
}
