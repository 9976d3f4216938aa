//! Colours of links and of curves.

use eframe::egui::Color32;

/// Colours that all readers can tell apart, by day and by night.
const COLORS: [Color32; 7] = [
    Color32::from_rgb(0, 114, 178),
    Color32::from_rgb(213, 94, 0),
    Color32::from_rgb(0, 158, 115),
    Color32::from_rgb(204, 121, 167),
    Color32::from_rgb(230, 159, 0),
    Color32::from_rgb(86, 180, 233),
    Color32::from_rgb(120, 120, 60),
];

/// The colour of the one with this number: that of its neighbours is another.
pub(super) fn distinct(number: usize) -> Color32 {
    COLORS[number % COLORS.len()]
}
