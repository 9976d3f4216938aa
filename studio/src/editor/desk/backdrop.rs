//! A picture behind the drawing, to be traced.

use crate::failure::Failure;
use crate::output::ends_in;
use eframe::egui::{self, Color32, ColorImage, Mesh, Pos2, TextureHandle, TextureOptions};
use image::{DynamicImage, ImageReader, ImageResult, Limits};
use serde::{Deserialize, Serialize};
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The endings of the names of pictures that can be read.
pub(in crate::editor) const ENDINGS: [&str; 3] = ["png", "jpg", "jpeg"];

/// The longest file of a picture, in bytes.
pub(in crate::editor) const LONGEST_FILE: u64 = 64 << 20;

/// The most pixels of a picture. More would take too much memory before they are made fewer.
const MOST: u64 = 64 << 20;

/// The longest side of a picture, in pixels: what all graphics cards can show. A larger one is made smaller.
const LONGEST: u32 = 4096;

pub(in crate::editor) struct Backdrop {
    pub(in crate::editor) path: PathBuf,
    pub(in crate::editor) place: PicturePlace,
    pixels: Arc<ColorImage>,
    /// The picture as the graphics card has it, once it was painted.
    texture: Option<TextureHandle>,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(in crate::editor) struct PicturePlace {
    /// Its centre in the scene.
    pub(in crate::editor) center: [f64; 2],
    /// Its width in scene units.
    pub(in crate::editor) width: f64,
    /// By how much it is turned against the clock, in degrees.
    pub(in crate::editor) angle: f64,
    /// The opacity of the picture, from 0 to 1.
    pub(in crate::editor) opacity: f32,
}

impl PicturePlace {
    /// Whether all numbers are finite, and the width is positive.
    pub(in crate::editor) fn is_sound(&self) -> bool {
        let [x, y] = self.center;
        let numbers = [x, y, self.width, self.angle, f64::from(self.opacity)];
        numbers.iter().all(|number| number.is_finite()) && self.width > 0.0
    }

    /// Makes it larger about a place that stays where it is.
    pub(in crate::editor) fn scale_about(&mut self, [x, y]: [f64; 2], factor: f64) {
        let [at, above] = self.center;
        self.center = [x + factor * (at - x), y + factor * (above - y)];
        self.width *= factor;
    }
}

/// Whether a file is a picture, by its name.
pub(in crate::editor) fn is_picture(path: &Path) -> bool {
    ends_in(path, &ENDINGS)
}

/// The bytes of a picture's file.
///
/// # Errors
/// If it cannot be read, is too long, or is a pipe or a device.
pub(in crate::editor) fn read_file(path: &Path) -> io::Result<Vec<u8>> {
    crate::input::read(path, LONGEST_FILE)
}

/// The pixels of a picture. How many they are is known before they are made.
fn decode(bytes: &[u8]) -> ImageResult<DynamicImage> {
    let reader = || ImageReader::new(Cursor::new(bytes)).with_guessed_format();
    let (width, height) = reader()?.into_dimensions()?;
    if u64::from(width) * u64::from(height) > MOST {
        let most = MOST >> 20;
        let why = format!("it is {width} x {height} pixels, and {most} Mi are the most");
        return Err(io::Error::other(why).into());
    }
    let mut limits = Limits::default();
    // The longest pixels have four numbers of two bytes.
    limits.max_alloc = Some(8 * MOST);
    let mut reader = reader()?;
    reader.limits(limits);
    reader.decode()
}

impl Backdrop {
    /// The picture in a file, one scene unit wide.
    pub(in crate::editor) fn read(path: &Path, bytes: &[u8]) -> Result<Self, Failure> {
        let picture = decode(bytes).map_err(|error| {
            let path = path.display();
            Failure::file(format!("`{path}` is not a picture that can be read: {error}"))
        })?;
        let picture = if picture.width().max(picture.height()) > LONGEST {
            picture.thumbnail(LONGEST, LONGEST)
        } else {
            picture
        };
        let pixels = picture.to_rgba8();
        let [width, height] = [pixels.width(), pixels.height()];
        let (Ok(width), Ok(height)) = (usize::try_from(width), usize::try_from(height)) else {
            return Err(Failure::internal("a picture of 4,096 pixels has no size"));
        };
        let size = [width, height];
        let pixels = ColorImage::from_rgba_unmultiplied(size, pixels.as_raw());
        Ok(Self {
            path: path.to_owned(),
            place: PicturePlace { center: [0.0; 2], width: 1.0, angle: 0.0, opacity: 0.5 },
            pixels: Arc::new(pixels),
            texture: None,
        })
    }

    /// The picture, placed into a box of the scene with this centre and extent.
    pub(in crate::editor) fn within(mut self, center: [f64; 2], [width, height]: [f64; 2]) -> Self {
        self.place.center = center;
        self.place.width = width.min(height / self.height_to_width());
        self
    }

    #[expect(clippy::cast_precision_loss, reason = "a few thousand pixels")]
    fn height_to_width(&self) -> f64 {
        let [width, height] = self.pixels.size.map(|side| side as f64);
        height / width
    }

    /// Paints it. `pixel` tells where a place of the scene is seen.
    pub(in crate::editor) fn paint(
        &mut self,
        painter: &egui::Painter,
        pixel: impl Fn([f64; 2]) -> Pos2,
    ) {
        let place = self.place;
        let half = [0.5 * place.width, 0.5 * place.width * self.height_to_width()];
        let (sin, cos) = place.angle.to_radians().sin_cos();
        let corner = |[x, y]: [f64; 2]| {
            let [x, y] = [x * half[0], y * half[1]];
            pixel([place.center[0] + cos * x - sin * y, place.center[1] + sin * x + cos * y])
        };
        let texture = self.texture.get_or_insert_with(|| {
            let pixels = Arc::clone(&self.pixels);
            let context = painter.ctx();
            context.load_texture("picture behind", pixels, TextureOptions::LINEAR)
        });
        let mut mesh = Mesh::with_texture(texture.id());
        let tint = Color32::WHITE.gamma_multiply(place.opacity);
        // From the upper left corner, with the clock. In a picture, y points down.
        for (at, uv) in [
            ([-1.0, 1.0], [0.0, 0.0]),
            ([1.0, 1.0], [1.0, 0.0]),
            ([1.0, -1.0], [1.0, 1.0]),
            ([-1.0, -1.0], [0.0, 1.0]),
        ] {
            mesh.vertices.push(egui::epaint::Vertex {
                pos: corner(at),
                uv: uv.into(),
                color: tint,
            });
        }
        mesh.add_triangle(0, 1, 2);
        mesh.add_triangle(0, 2, 3);
        painter.add(mesh);
    }
}
