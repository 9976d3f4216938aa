//! One mechanism for each kind of loop, and some that use what the gallery does not.

include!(concat!(env!("OUT_DIR"), "/zoo.rs"));
