//! Prints the generated code of a mechanism: `cargo run -p mech-compiler --example expand < four_bar.txt | rustfmt`.

use quote::quote;
use std::error::Error;
use std::io::{self, Read as _};

fn main() -> Result<(), Box<dyn Error>> {
    let mut text = String::new();
    io::stdin().read_to_string(&mut text)?;
    let tokens: proc_macro2::TokenStream = text.parse()?;
    println!("{}", mech_compiler::expand(quote!(::mech_runtime; #tokens)));
    Ok(())
}
