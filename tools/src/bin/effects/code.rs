//! Sizes of functions, from the symbols of this program.

use object::{Object, ObjectSymbol};
use std::env;
use std::fs;

/// The size in bytes of all functions of a module except those that measure, if this system's object files contain it.
pub(crate) fn size(module: &str) -> Option<u64> {
    let data = fs::read(env::current_exe().ok()?).ok()?;
    let file = object::File::parse(&*data).ok()?;
    // In symbols every name comes after its length.
    let path = format!("{}{module}", module.len());
    let sizes = file.symbols().filter_map(|symbol| {
        let name = symbol.name().ok()?;
        let measures = ["3run", "7subject"]
            .iter()
            .any(|own| name.contains(&format!("{path}{own}")));
        (name.contains(&path) && !measures).then_some(symbol.size())
    });
    Some(sizes.sum()).filter(|size| *size > 0)
}
