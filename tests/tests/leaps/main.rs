//! Whether a leap is where its own small steps lead, whatever the mechanism; whether what was proved to be free is; and whether
//! what compiles moves. Between a leap and its steps an independent judge decides.
//!
//! `MECH_CASES=1000` for a thousand mechanisms a test, `MECH_SEED=7` for others; the tables are printed with `--nocapture`.

mod coupled;
mod journeys;
mod named;
mod narrow;
mod parallel;
mod proved;
mod shown;
mod sound;
mod starts;
