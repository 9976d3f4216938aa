//! What an image takes that has no mechanism in it.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

firmware::measure!(firmware::Nothing);
