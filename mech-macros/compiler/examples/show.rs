//! Prints the plan and the program of a mechanism: `cargo run -p mech-compiler --example show < four_bar.txt`.

use mech_compiler::compile;
use mech_compiler::syntax::parse;
use std::error::Error;
use std::io::{self, Read as _};

fn main() -> Result<(), Box<dyn Error>> {
    let mut text = String::new();
    io::stdin().read_to_string(&mut text)?;
    let parsed = parse(text.parse()?);
    if !parsed.errors.is_empty() {
        return Err(format!("{:?}", parsed.errors).into());
    }
    let compiled = compile(&parsed.model).map_err(|found| format!("{found:?}"))?;
    println!("{}", compiled.plan.display(&parsed.model));
    print!("{}", compiled.program);
    Ok(())
}
