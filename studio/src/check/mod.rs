//! The check of the mechanisms of a document, and its messages.

mod json;
mod rendering;
mod verdict;

pub(crate) use json::to_json;
pub(crate) use rendering::render;
pub(crate) use verdict::{Verdict, Witness, verdict_line, verdicts};
