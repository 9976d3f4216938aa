//! Stands in for the editor until there is one: shows a text, and plays its first mechanism.

use eframe::egui::{self, CentralPanel, ColorImage, ScrollArea, TextureHandle, TextureOptions};
use eframe::{App, CreationContext, Frame};
use mech_studio::play::{Mechanism, Player, SIZE, Stage};
use mech_studio::{Document, Source};
use std::path::PathBuf;

/// A text, and its mechanism if it has one.
pub(crate) struct StandIn {
    text: String,
    verdict: String,
    stage: Option<Stage>,
    seen: Option<TextureHandle>,
}

impl StandIn {
    /// With a text that has this name.
    pub(crate) fn new(_: &CreationContext<'_>, name: &str, text: &str) -> Self {
        let document = Document::of(Source::new(name, text));
        let made = stage(&document);
        Self {
            text: text.to_owned(),
            verdict: made.as_ref().err().cloned().unwrap_or_default(),
            stage: made.ok(),
            seen: None,
        }
    }
}

fn stage(document: &Document) -> Result<Stage, String> {
    let declaration = document.declarations().first();
    let declaration = declaration.ok_or("there is no mechanism")?;
    let reading = document.analyse(declaration);
    let reading = reading.map_err(|why| why.to_string())?;
    let compiled = reading
        .result
        .map_err(|faults| faults.messages[0].text.clone())?;
    let mechanism = Mechanism::new(reading.model, *compiled).map_err(|why| why.to_string())?;
    let player = Player::new(mechanism, Vec::new(), SIZE);
    Stage::new(player, PathBuf::new()).map_err(|why| why.to_string())
}

impl App for StandIn {
    fn ui(&mut self, ui: &mut egui::Ui, _: &mut Frame) {
        CentralPanel::default().show(ui, |ui| {
            ui.label(&self.verdict);
            if let Some(stage) = &mut self.stage {
                stage.wait(f64::from(ui.input(|input| input.stable_dt.min(0.1))));
                if let Ok(picture) = stage.caption() {
                    let bytes: Vec<u8> = picture.pixels().iter().flatten().copied().collect();
                    let image = ColorImage::from_rgba_unmultiplied(SIZE, &bytes);
                    let options = TextureOptions::NEAREST;
                    self.seen = Some(ui.ctx().load_texture("picture", image, options));
                }
                ui.ctx().request_repaint();
            }
            if let Some(seen) = &self.seen {
                ui.image(seen);
            }
            ScrollArea::vertical().show(ui, |ui| ui.monospace(&self.text));
        });
    }
}
