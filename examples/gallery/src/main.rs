//! Paints the gallery: `gallery [NAME]…`.

use mech_gallery::{Curator, exhibits};
use std::process::ExitCode;

fn main() -> ExitCode {
    let curator = Curator::new(exhibits(), Curator::usual_folder());
    match curator.serve(std::env::args().skip(1)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
