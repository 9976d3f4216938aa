//! `mech import`: documents of Linkage and links of PMKS+.

mod encoder;
mod faults;
mod linkage;
mod moving;
mod pmks;
mod properties;

use crate::run::{Folder, repository};
use std::fs;

/// A document of Linkage that the tests have.
fn sample(name: &str) -> String {
    let path = repository("studio/tests/samples").join(format!("{name}.linkage2"));
    fs::read_to_string(path).expect("a sample")
}

/// Imports a text: returns the text of the language, and the omissions.
#[track_caller]
fn imported(name: &str, text: &str) -> (String, String) {
    let folder = Folder::new().with(name, text);
    let answer = folder.mech(&format!("import {name}"));
    assert_eq!(answer.code, Some(0), "{}\n{}", answer.err, answer.out);
    (answer.out, answer.err)
}

#[track_caller]
fn imported_sample(name: &str) -> String {
    imported(&format!("{name}.linkage2"), &sample(name)).0
}
