//! Players of exhibits.

use mech_gallery::exhibits;
use mech_play::Player;

/// Of the picture.
pub(crate) const SIZE: [usize; 2] = [480, 360];

/// Which exhibit it is.
pub(crate) fn index(slug: &str) -> usize {
    let exhibits = exhibits();
    let index = exhibits.iter().position(|exhibit| exhibit.slug() == slug);
    index.expect("it is in the gallery")
}

/// A player of an exhibit.
pub(crate) fn player(slug: &str) -> Player {
    Player::new(exhibits(), index(slug), SIZE).expect("it moves")
}

/// Whether no number is farther from the other than that.
pub(crate) fn near(one: &[f64], other: &[f64], tolerance: f64) -> bool {
    one.len() == other.len()
        && one
            .iter()
            .zip(other)
            .all(|(a, b)| (a - b).abs() <= tolerance)
}
