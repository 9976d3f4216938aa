//! The studio, as somebody uses it: through its window's accessible nodes, by mouse and by keys.

mod copying;
mod dead_ends;
mod desk;
mod dragging;
mod drawing;
mod exhibits;
mod features;
mod figure_1;
mod folder;
mod keyboard;
mod mistakes;
mod pieces;
mod plots;
mod properties;
mod properties_panel;
mod safety;
mod touch;
mod user;
