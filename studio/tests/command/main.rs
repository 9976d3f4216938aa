//! The command `mech`, run as a user runs it.

mod bad_input;
mod blocks;
mod check;
mod constructions;
mod dialogue;
mod edit;
mod import;
mod led;
mod listing;
mod mend;
mod numbers;
mod outputs;
mod pictures;
mod play;
mod properties;
mod rest;
mod run;
mod script;
mod slips;
mod summaries;
mod terminal;
mod transcripts;
