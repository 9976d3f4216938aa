//! Many joints as a table: the compiler reads rows of numbers in half the time that it takes for as many structs.

use crate::{Anchor, Coordinate, JointInfo, JointKind};

/// A pin in a table: its name, its links, and its anchor on each of them.
type PinRow<T> = (&'static str, [usize; 2], [[T; 2]; 2]);

/// Pins whose angles no motor gives. A row has the name of a joint, the numbers of its links, and its place on each of them. `links`
/// are the names of links by their numbers, and `along` is the direction of all frames.
///
/// # Panics
/// A number is that of no link: no macro writes that.
#[must_use]
pub const fn pins<T: Copy, const N: usize>(
    rows: [PinRow<T>; N],
    links: &[&'static str],
    along: [T; 2],
) -> [JointInfo<T>; N] {
    let nothing = JointInfo::new("", JointKind::Revolute, [""; 2], None, None, None);
    let mut joints = [nothing; N];
    let mut row = 0;
    while row < N {
        let (name, [a, b], [at, other]) = rows[row];
        let anchors = [Anchor::new(Some(a), at, along), Anchor::new(Some(b), other, along)];
        joints[row] = JointInfo::new(
            name,
            JointKind::Revolute,
            [links[a], links[b]],
            Some(anchors),
            None,
            Some(Coordinate::Angle),
        );
        row += 1;
    }
    joints
}
