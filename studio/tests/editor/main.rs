//! The studio, as somebody uses it: through its window's accessible nodes, by mouse and by keys.

mod drawing;
mod user;
