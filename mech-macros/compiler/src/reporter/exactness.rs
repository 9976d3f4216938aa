//! What is said about accuracy.

use super::Words;
use crate::model::Precision;

impl Words<'_> {
    pub(super) fn too_accurate(&self, accuracy: f64, best: f64) -> String {
        let single = self.model.precision == Precision::F32;
        let scalar = if single { "f32" } else { "f64" };
        let in_double = best / Precision::F32.epsilon() * Precision::F64.epsilon();
        let best = upwards(best);
        let or_double = if single && in_double <= accuracy {
            ", or compute in `f64`"
        } else {
            ""
        };
        format!(
            "this accuracy is beyond `{scalar}`: positions of `{}` may be off by {best:.1e}, however its loops are solved\nhelp: \
             write `accuracy {best:.1e};` or more{or_double}",
            self.model.name
        )
    }
}

/// The next number of two digits that is not less.
fn upwards(value: f64) -> f64 {
    let unit = 10.0_f64.powf(value.log10().floor() - 1.0);
    // A little more, because what is printed is rounded.
    let up = (value / unit + 1e-9).ceil() * unit;
    if up.is_finite() { up } else { value }
}
