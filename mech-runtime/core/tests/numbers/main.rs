//! Accuracy and exactness, against a reference of twice the precision. `--nocapture` shows what was measured.

mod beyond;
mod motion_law;
mod motors;
mod phase;
mod reference;
mod remainder;
mod root;
mod trig;
