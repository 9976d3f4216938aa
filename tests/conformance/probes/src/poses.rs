//! Where the links of a mechanism are.

use crate::{Listener, Probed, STEPS, phase, precision};
use mech_runtime::Real;

/// Moves a mechanism through its motion and tells its poses after each step: of each link the cosine, the sine, x and y, as the bits of
/// an `f64`. What is blocked tells nothing.
pub fn poses<M: Probed>(listener: &mut impl Listener) {
    let mut mechanism = M::new();
    for step in 0..STEPS {
        listener.begin("pose", M::LABEL, precision::<M>());
        if mechanism.move_to(M::motion(phase(step))).is_ok() {
            for pose in mechanism.poses() {
                for value in [pose.cos, pose.sin, pose.x, pose.y] {
                    listener.word(value.to_f64().to_bits());
                }
            }
        }
        listener.end();
    }
}
