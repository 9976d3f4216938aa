//! Periodic motions as SVG.

use super::Sheet;
use super::drawing::write_group;
use super::figure::Figure;
use super::figure::Seen;
use super::layers::{Layer, Layers};
use super::number::Number;
use super::place::Place;
use super::track::{Track, percent, share};
use crate::{Canvas, Outline, Pose, Real, Scalar};
use core::fmt::Write;
use std::sync::Arc;
use std::time::Duration;
use std::{format, string::String, vec::Vec};

/// A periodic motion as SVG that moves for ever, without a script. Every figure is in the file once, and key frames of CSS move its link.
///
/// It is painted moment by moment. The moments are equidistant, and the first follows the last. A rigid figure moves as a whole, also if
/// it is painted in the scene. Where the moments are near enough together, its error is below a tenth of a pixel. A figure that changes
/// its form (an arrow, a spring) or is not always visible is shown at most thirty times a second. A trace shows its whole
/// path. Readers who prefer reduced motion see the first moment, and so do those whose viewer cannot move it.
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
    sheet: Sheet,
    period: Duration,
    moments: Vec<Vec<Seen>>,
}

/// The number of times per second at which changing figures are shown.
const CHANGES: f64 = 30.0;

impl AnimatedSvg {
    /// A motion of this period, without moments.
    #[must_use]
    pub const fn new(sheet: Sheet, period: Duration) -> Self {
        Self {
            sheet,
            period,
            moments: Vec::new(),
        }
    }

    /// Adds a moment, which `paint` paints.
    pub fn add(&mut self, paint: impl FnOnce(&mut Moment<'_>)) {
        let mut moment = Moment {
            sheet: &self.sheet,
            before: self.moments.last().map_or(&[], Vec::as_slice),
            seen: Vec::new(),
        };
        paint(&mut moment);
        let seen = moment.seen;
        self.moments.push(seen);
    }

    /// The text of the file.
    #[must_use]
    pub fn finish(self) -> String {
        let layers = self.layers();
        self.document(&layers)
    }

    pub(super) fn layers(&self) -> Layers {
        Layers::of(&self.moments)
    }

    pub(super) fn document(&self, Layers { tracks, layers }: &Layers) -> String {
        let is_moving: Vec<_> = tracks.iter().map(|track| !track.is_still()).collect();
        let mut style = String::new();
        for (index, track) in tracks.iter().enumerate() {
            if is_moving.get(index) == Some(&true) {
                track.write_keyframes(&mut style, &format!("track{index}"));
                // Writing to a `String` cannot fail.
                let _ = writeln!(style, ".track{index}{{animation-name:track{index}}}");
            }
        }
        let shown = self.change_moments();
        if layers
            .iter()
            .any(|layer| matches!(layer, Layer::Changing(_)))
        {
            let end = percent(1, shown.len());
            let _ = writeln!(
                style,
                "@keyframes show{{0%{{visibility:visible}}{end}%,to{{visibility:hidden}}}}\n\
                 .show{{animation-name:show;animation-timing-function:step-end}}"
            );
        }
        let mut body = String::new();
        for layer in layers {
            match layer {
                Layer::Rigid { track, figures } => {
                    let first = tracks.get(*track).map_or(Place::PICTURE, Track::first);
                    let class = if is_moving.get(*track) == Some(&true) {
                        format!(" class=\"move track{track}\"")
                    } else {
                        String::new()
                    };
                    write_group(&mut body, &class, first, figures, &self.sheet.palette);
                }
                Layer::Changing(moments) => self.write_changing(&mut body, moments, &shown),
            }
        }
        let head = if style.is_empty() {
            style
        } else {
            let period = self.seconds(1.0);
            format!(
                "<style>\n.move{{animation:linear {period}s infinite}}\n{style}\
                 @media (prefers-reduced-motion:reduce){{.move{{animation:none!important}}}}\n</style>\n"
            )
        };
        self.sheet.document(&head, &body)
    }

    /// The moments at which changing figures are shown.
    fn change_moments(&self) -> Vec<usize> {
        let count = self.moments.len();
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "saturates"
        )]
        let wanted = (self.period.as_secs_f64() * CHANGES).ceil() as usize;
        let wanted = wanted.clamp(1, count.max(1));
        (0..wanted).map(|index| index * count / wanted).collect()
    }

    fn write_changing(&self, text: &mut String, moments: &[Vec<Figure>], shown: &[usize]) {
        for (index, moment) in shown.iter().enumerate() {
            let Some(figures) = moments.get(*moment).filter(|figures| !figures.is_empty()) else {
                continue;
            };
            // A beginning in the past, so that each has its turn from the first period on.
            let begin = self.seconds(share(index, shown.len()) - 1.0);
            let hidden = if index == 0 {
                ""
            } else {
                " visibility=\"hidden\""
            };
            // Writing to a `String` cannot fail.
            let _ = writeln!(
                text,
                "<g class=\"move show\" style=\"animation-delay:{begin}s\"{hidden}>"
            );
            for figure in figures {
                figure.write(text, &self.sheet.palette);
            }
            text.push_str("</g>\n");
        }
    }

    /// A part of the period in seconds.
    fn seconds(&self, share: f64) -> Number {
        Number(self.period.as_secs_f64() * share, 5)
    }
}

/// The canvas of one moment of an [`AnimatedSvg`].
#[derive(Debug)]
pub struct Moment<'a> {
    sheet: &'a Sheet,
    before: &'a [Seen],
    seen: Vec<Seen>,
}

impl Moment<'_> {
    fn see<T: Scalar>(&mut self, figure: Option<Figure>, pose: Pose<T>) {
        let (Some(figure), Some(place)) = (figure, Place::of(pose, self.sheet)) else {
            return;
        };
        // Parts of a trace. Two bars that meet are not one line, because they may move apart.
        if let Some(last) = self.seen.last_mut()
            && last.place == place
            && last.figure.line().is_some_and(|points| points.len() > 2)
            && Arc::make_mut(&mut last.figure).join(&figure)
        {
            return;
        }
        // Most figures are those of the moment before, at another place.
        let known = self.before.get(self.seen.len());
        let known = known.filter(|known| *known.figure == figure);
        let figure = known.map_or_else(|| Arc::new(figure), |known| Arc::clone(&known.figure));
        self.seen.push(Seen { figure, place });
    }
}

impl<T: Scalar> Canvas<T> for Moment<'_> {
    fn fill(&mut self, outline: Outline<'_, T>, pose: Pose<T>, color: u8) {
        let scale = self.sheet.view.scale();
        self.see(Figure::of(outline, scale, color), pose);
    }

    fn text(&mut self, place: [T; 2], text: &str, color: u8) {
        let scale = self.sheet.view.scale();
        let figure = Figure::text(place, text, scale, color);
        self.see(figure, Pose::<T>::identity());
    }

    fn scale(&self) -> T {
        Real::from_f64(self.sheet.view.scale())
    }
}
