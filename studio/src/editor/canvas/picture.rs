//! The bodies of links, as the mechanism itself paints them.

use super::{Shown, size_of};
use crate::editor::Editor;
use crate::play::Revision;
use eframe::egui::{self, Color32, ColorImage, Rect, TextureHandle, TextureOptions};
use mech_runtime::{HeapSmooth, Palette, View};

/// The bodies of links, painted by the runtime's own rasteriser.
#[derive(Default)]
pub(super) struct Picture {
    painted: Option<HeapSmooth>,
    texture: Option<TextureHandle>,
    subject: Option<Subject>,
}

#[derive(Clone, Copy, PartialEq)]
struct Subject {
    revision: Revision,
    view: View,
    size: [usize; 2],
    is_dark: bool,
    /// Whether the picture is transparent where there are no bodies.
    is_glass: bool,
}

impl Picture {
    /// Shows the paper, the picture that is traced, and the bodies, if the mechanism moves and they are wanted.
    pub(super) fn show(&mut self, editor: &mut Editor, shown: &Shown, ui: &egui::Ui) {
        let rect = shown.rect;
        let paper = palette(editor).rgba(Palette::PAPER);
        ui.painter().rect_filled(rect, 0.0, color(paper));
        if let Some(backdrop) = &mut editor.desk.backdrop {
            let painter = ui.painter().with_clip_rect(rect);
            backdrop.paint(&painter, |place| shown.pixel(place));
        }
        if editor.sight.shows_bodies(&editor.settings)
            && self.paint(editor, rect, ui.ctx()).is_some()
            && let Some(texture) = &self.texture
        {
            let whole = Rect::from_min_max(egui::pos2(0.0, 0.0), egui::pos2(1.0, 1.0));
            ui.painter().image(texture.id(), rect, whole, Color32::WHITE);
        }
    }

    fn paint(&mut self, editor: &mut Editor, rect: Rect, context: &egui::Context) -> Option<()> {
        let ratio = f64::from(context.pixels_per_point());
        let points = size_of(rect);
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "a number of pixels"
        )]
        let size = points.map(|side| (side as f64 * ratio).round().max(1.0) as usize);
        let view = editor.sight.camera.view();
        let subject = Subject {
            revision: editor.sight.seen_player()?.revision(),
            view: View::new(view.center(), view.scale() * ratio),
            size,
            is_dark: editor.settings.is_dark,
            is_glass: editor.desk.backdrop.is_some(),
        };
        if self.subject == Some(subject) {
            return Some(());
        }
        let is_fit =
            self.painted.as_ref().is_some_and(|known| [known.width(), known.height()] == size);
        if !is_fit {
            self.painted = HeapSmooth::new(size[0], size[1]).ok();
        }
        let picture = self.painted.as_mut()?;
        picture.set_palette(palette(editor));
        picture.look_at(subject.view);
        picture.clear();
        editor.sight.seen_player()?.draw(picture);
        let pixels = picture.pixels().as_flattened();
        let mut image = ColorImage::from_rgba_unmultiplied(size, pixels);
        if subject.is_glass {
            let paper = color(palette(editor).rgba(Palette::PAPER));
            let papers = image.pixels.iter_mut().filter(|pixel| **pixel == paper);
            papers.for_each(|pixel| *pixel = Color32::TRANSPARENT);
        }
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => {
                self.texture = Some(context.load_texture("bodies", image, TextureOptions::LINEAR));
            }
        }
        self.subject = Some(subject);
        Some(())
    }
}

fn palette(editor: &Editor) -> Palette {
    if editor.settings.is_dark { Palette::NIGHT } else { Palette::TEXTBOOK }
}

fn color([red, green, blue, _]: [u8; 4]) -> Color32 {
    Color32::from_rgb(red, green, blue)
}
