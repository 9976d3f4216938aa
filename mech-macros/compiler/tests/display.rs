//! The printed plan and program of each text in `displayed`. Renew them with
//! `INSTA_UPDATE=always cargo test -p mech-compiler --test display`, and read them.

use mech_compiler::compile;
use mech_compiler::syntax::parse;
use std::fs;
use std::path::Path;

/// The plan and the program of a mechanism, and that of its laws, if it has any.
fn printed(text: &str) -> String {
    let parsed = parse(text.parse().expect("tokens"));
    assert!(parsed.errors.is_empty(), "{:?}", parsed.errors);
    let compiled = compile(&parsed.model).expect("a coherent mechanism");
    let plan = compiled.plan.display(&parsed.model);
    let mut all = format!("{plan}\n{}", compiled.program);
    if let Some(timing) = compiled.timing {
        all += &format!("\nlaws\n{}", timing.program);
    }
    all
}

/// Together the texts of the folder have every kind of step and block.
#[test]
fn small_mechanisms() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/displayed");
    let mut count = 0;
    for file in fs::read_dir(folder).expect("the folder of the texts") {
        let file = file.expect("a file").path();
        let name = file.file_stem().expect("a name").to_string_lossy();
        let text = fs::read_to_string(&file).expect("a text");
        insta::assert_snapshot!(&*name, printed(&text));
        count += 1;
    }
    assert!(count >= 10, "{count}");
}
