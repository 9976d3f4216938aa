//! Accuracy and exactness, against a reference of twice the precision. `--nocapture` shows what was measured.

mod phase;
mod reference;
mod trig;
