//! The computer of Antikythera.

use crate::antikythera::Antikythera;
use crate::{Exhibit, Showcase};

/// A year forwards and back.
pub(super) fn exhibit() -> Box<dyn Exhibit> {
    Box::new(Showcase::<Antikythera> {
        title: "The computer of Antikythera",
        caption: "A Greek computer of the sky, about 2,100 years old, with the teeth that Freeth and \
                  others counted in 2006. A turn of the input is a year; the moon makes 254/19 turns \
                  in it. The report has the periods as exact fractions: 5/19 for the calendar of \
                  Meton, 1/76 for that of Callippus, 1/4 for the games, 940/4237 for the eclipses. On \
                  the large wheel, two wheels turn about axles 1.1 mm apart, and a pin in a slot makes \
                  the moon faster and slower, by up to 6.58°.",
        frames: 150,
        still: 0.3,
        ..Showcase::untitled()
    })
}
