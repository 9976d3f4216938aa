//! Sheets: the size, view and colours of an SVG.

use crate::raster::{Indexed, Memory, Soft};
use crate::{Palette, View};
use core::fmt::Write;
use std::{format, string::String};

/// The size of letters: the runtime's own are six pixels apart and seven high, as those of most fonts are that have all one width.
const FONT: u8 = 10;

/// A sheet of paper: its size in pixels, its view of the scene, and its colours.
///
/// ```
/// use mech_runtime::files::Sheet;
/// use mech_runtime::{Frame, Palette, View};
///
/// let sheet = Sheet::new(320, 240).look_at(View::new([0.0, 1.0], 40.0)).palette(Palette::NIGHT).title("By night");
/// let like_a_frame = Sheet::from(&Frame::<320, 240>::new());
/// ```
#[derive(Clone, Debug)]
pub struct Sheet {
    size: [usize; 2],
    pub(super) view: View,
    pub(super) palette: Palette,
    title: String,
}

impl Sheet {
    /// A sheet of this width and height in pixels with the [textbook](Palette::TEXTBOOK) palette. It looks at the scene's origin, with one
    /// pixel per scene unit.
    #[must_use]
    pub fn new(width: usize, height: usize) -> Self {
        Self {
            size: [width, height],
            view: View::default(),
            palette: Palette::default(),
            title: String::new(),
        }
    }

    /// Sets the view of the scene.
    #[must_use]
    pub const fn look_at(mut self, view: View) -> Self {
        self.view = view;
        self
    }

    /// Sets the colours.
    #[must_use]
    pub fn palette(mut self, palette: Palette) -> Self {
        self.palette = palette;
        self
    }

    /// Sets the title, for readers who cannot see the picture.
    #[must_use]
    pub fn title(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// The centre in pixels from the upper left corner.
    #[expect(clippy::cast_precision_loss, reason = "no picture is 2⁵² pixels wide")]
    pub(super) fn middle(&self) -> [f64; 2] {
        self.size.map(|pixels| pixels as f64 / 2.0)
    }

    /// A document with this head and body.
    pub(super) fn document(&self, head: &str, body: &str) -> String {
        let [width, height] = self.size;
        let paper = hex(&self.palette, Palette::PAPER);
        let mut text = String::with_capacity(head.len() + body.len() + 300);
        // Writing to a `String` cannot fail.
        let _ = writeln!(
            text,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" viewBox=\"0 0 {width} {height}\" role=\"img\" \
             stroke-linecap=\"round\" stroke-linejoin=\"round\" font-family=\"monospace\" font-size=\"{FONT}\">"
        );
        if !self.title.is_empty() {
            let _ = writeln!(text, "<title>{}</title>", escape(&self.title));
        }
        text.push_str(head);
        let _ = writeln!(text, "<rect width=\"{width}\" height=\"{height}\" fill=\"{paper}\"/>");
        text.push_str(body);
        text.push_str("</svg>\n");
        text
    }
}

macro_rules! sheet_of_picture {
    ($($Picture:ident)*) => {
        $(
            /// A sheet with the size, the view and the colours of a picture.
            impl<M: Memory> From<&$Picture<M>> for Sheet {
                fn from(picture: &$Picture<M>) -> Self {
                    Self::new(picture.width(), picture.height())
                        .look_at(picture.view())
                        .palette(picture.palette().clone())
                }
            }
        )*
    };
}

sheet_of_picture!(Indexed Soft);

/// The colour of an entry as SVG writes it.
pub(super) fn hex(palette: &Palette, entry: u8) -> String {
    let [red, green, blue] = palette.rgb(entry);
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// The text with the escapes of XML. Characters that XML forbids are replaced.
pub(super) fn escape(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\t' | '\n' | '\r' => escaped.push(' '),
            other if other.is_control() || matches!(other, '\u{FFFE}' | '\u{FFFF}') => {
                escaped.push(char::REPLACEMENT_CHARACTER);
            }
            other => escaped.push(other),
        }
    }
    escaped
}
