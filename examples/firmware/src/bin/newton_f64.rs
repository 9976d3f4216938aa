//! The four-bar by `method newton`, in `f64`.
#![no_std]
#![no_main]
#![forbid(unsafe_code)]

firmware::measure!(firmware::Moved<mech_probes::four_bar::NewtonDouble>);
