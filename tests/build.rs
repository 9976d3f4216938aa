//! Expands the mechanisms of the tests of generated code, which are texts: those of a folder are a file of Rust.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// Every text of a folder as `mechanism!`, in the order of their names.
fn expand(folder: &Path) -> io::Result<String> {
    let files = fs::read_dir(folder)?.map(|file| file.map(|file| file.path()));
    let mut files = files.collect::<io::Result<Vec<PathBuf>>>()?;
    files.retain(|path| path.extension().is_some_and(|end| end == "mech"));
    files.sort();
    let mut code = String::new();
    for path in files {
        let text = fs::read_to_string(&path)?;
        // What it is, is the documentation of the struct.
        let text = match text.strip_prefix("// ") {
            Some(about) => format!("/// {about}"),
            None => text,
        };
        let expanded = format!("mech_runtime::mechanism! {{\n{text}}}\n");
        code += &expanded.replacen("\nstruct ", "\npub struct ", 1);
    }
    Ok(code)
}

fn main() -> io::Result<()> {
    let out = PathBuf::from(std::env::var_os("OUT_DIR").expect("cargo says where"));
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=tests/subjects");
    for folder in fs::read_dir("tests/subjects")? {
        let folder = folder?.path();
        let name = folder.file_name().expect("a folder").to_string_lossy();
        fs::write(out.join(format!("{name}.rs")), expand(&folder)?)?;
    }
    Ok(())
}
