//! Periodic motions as SVG.

use super::drawing::{begin_group, write_groups};
use super::layers::{Change, Layers};
use super::number::{Number, share};
use super::track::Track;
use super::{Sheet, Svg};
use core::fmt::Write;
use core::mem;
use std::time::Duration;
use std::{format, string::String, vec::Vec};

/// A periodic motion as SVG that moves for ever, without a script. Every figure is in the file once, and key frames of CSS move its link.
///
/// It is painted moment by moment. The moments are equidistant, and the first follows the last. A figure that is painted at each moment,
/// alike in the frame of its link, moves with its pose. Where the moments are near enough together, its error is below a tenth of a pixel.
/// A figure that changes in its frame (an arrow, a spring) or is not always visible is shown at most thirty times a second. A
/// [trace](crate::Canvas::trace) shows its whole path. Readers who prefer reduced motion see the first moment, and so do those whose viewer
/// cannot move it.
///
/// The names in the file are its own as long as an `<img>` shows it.
///
/// ```
/// use mech_runtime::files::{AnimatedSvg, Sheet};
/// use mech_runtime::{Canvas, Outline, Palette, Pose};
/// use std::time::Duration;
///
/// let mut svg = AnimatedSvg::new(Sheet::new(64, 48), Duration::from_secs(2));
/// for degrees in 0..360 {
///     let (sin, cos) = f64::from(degrees).to_radians().sin_cos();
///     let pose = Pose { cos, sin, x: 0.0, y: 0.0 };
///     let circle = Outline::Circle { center: [12.0, 0.0], radius: 5.0 };
///     svg.add(|canvas| canvas.fill(circle, pose, Palette::BLUE));
/// }
/// let text = svg.finish(); // for `std::fs::write("circle.svg", text)`
/// assert_eq!(text.matches("<circle").count(), 1);
/// assert!(text.contains("to{transform:translate(32px,24px) rotate(-360deg)}"));
/// ```
#[derive(Clone, Debug)]
pub struct AnimatedSvg {
    /// The canvas of the next moment.
    canvas: Svg,
    period: Duration,
    /// The number of moments.
    moments: usize,
    layers: Layers,
}

/// The number of times per second at which changing figures are shown.
const CHANGES: f64 = 30.0;

impl AnimatedSvg {
    /// A motion of this period, without moments.
    #[must_use]
    pub const fn new(sheet: Sheet, period: Duration) -> Self {
        Self { canvas: Svg::new(sheet), period, moments: 0, layers: Layers::new() }
    }

    /// Adds a moment, which `paint` paints.
    pub fn add(&mut self, paint: impl FnOnce(&mut Svg)) {
        paint(&mut self.canvas);
        let parts = mem::take(&mut self.canvas.parts);
        self.layers.add(self.moments, parts);
        self.moments += 1;
    }

    /// The text of the file.
    #[must_use]
    pub fn finish(self) -> String {
        let mut tracks: Vec<Track<'_>> = Vec::new();
        let tracks_of_layers = self.layers.all.iter().map(|layer| {
            let known = tracks.iter().position(|track| track.places == layer.places);
            let number = known.unwrap_or(tracks.len());
            if known.is_none() {
                tracks.push(Track::new(&layer.places));
            }
            if let Some(track) = tracks.get_mut(number) {
                track.reach = track.reach.max(layer.figure.reach);
            }
            number
        });
        let tracks_of_layers: Vec<_> = tracks_of_layers.collect();

        let mut style = String::new();
        for (number, track) in tracks.iter_mut().enumerate() {
            if !track.is_still() {
                track.class = format!(" class=\"move track{number}\"");
                track.write_keyframes(&mut style, &format!("track{number}"));
                // Writing to a `String` cannot fail.
                let _ = writeln!(style, ".track{number}{{animation-name:track{number}}}");
            }
        }
        let mut body = String::new();
        let mut last = None;
        for (layer, number) in self.layers.all.iter().zip(tracks_of_layers) {
            if last != Some(number) || !layer.behind.is_empty() {
                if last.replace(number).is_some() {
                    body.push_str("</g>\n");
                }
                self.write_changes(&mut body, &layer.behind);
                if let Some((track, place)) = tracks.get(number).zip(layer.places.first()) {
                    begin_group(&mut body, &track.class, *place, track.reach);
                }
            }
            layer.figure.clone().closed().write(&mut body);
        }
        if last.is_some() {
            body.push_str("</g>\n");
        }
        self.write_changes(&mut body, &self.layers.front);
        let mut changes = self.layers.all.iter().map(|layer| &layer.behind);
        if !self.layers.front.is_empty() || changes.any(|changes| !changes.is_empty()) {
            let end = Number(100.0 * share(1, self.count_of_changes()), 4);
            let _ = writeln!(
                style,
                "@keyframes show{{0%{{visibility:visible}}{end}%,to{{visibility:hidden}}}}\n\
                 .show{{animation-name:show;animation-timing-function:step-end}}"
            );
        }
        if !style.is_empty() {
            let period = self.seconds(1.0);
            style = format!(
                "<style>\n.move{{animation:linear {period}s infinite}}\n{style}\
                 @media (prefers-reduced-motion:reduce){{.move{{animation:none!important}}}}\n</style>\n"
            );
        }
        self.canvas.sheet.document(&style, &body)
    }

    /// Returns the number of times in a period at which changing figures are shown.
    fn count_of_changes(&self) -> usize {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates")]
        let wanted = (self.period.as_secs_f64() * CHANGES).ceil() as usize;
        wanted.clamp(1, self.moments.max(1))
    }

    /// Writes what changes: a group for each moment that is shown.
    fn write_changes(&self, text: &mut String, changes: &[Change]) {
        let count = self.count_of_changes();
        for index in 0..count {
            let shown = index * self.moments / count;
            let parts = changes.iter().filter(|(moment, _)| *moment == shown);
            let parts: Vec<_> = parts.map(|(_, part)| part).collect();
            if parts.is_empty() {
                continue;
            }
            // A beginning in the past, so that each has its turn from the first period on.
            let begin = self.seconds(share(index, count) - 1.0);
            let hidden = match index {
                0 => "",
                _ => " visibility=\"hidden\"",
            };
            // Writing to a `String` cannot fail.
            let _ = writeln!(
                text,
                "<g class=\"move show\" style=\"animation-delay:{begin}s\"{hidden}>"
            );
            write_groups(text, &parts);
            text.push_str("</g>\n");
        }
    }

    /// A part of the period in seconds.
    fn seconds(&self, share: f64) -> Number {
        Number(self.period.as_secs_f64() * share, 5)
    }
}
