//! Mechanisms to begin with. Each is what `mechanism!` is given in a file of the project, so that it is also built and tested there.

use crate::document::{Document, Source};
use crate::edit::Workspace;
use crate::failure::Failure;

#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Example {
    /// The name in the menu.
    pub(super) name: &'static str,
    /// The description, for a reader.
    pub(super) help: &'static str,
    pub(super) file: &'static str,
    /// The text of a file in which it stands: Rust, or the inside of a mechanism.
    source: &'static str,
}

/// All examples, the simplest first.
pub(super) const EXAMPLES: [Example; 12] = [
    Example {
        name: "Four-bar linkage",
        help: "a crank lets a rocker swing",
        file: "four_bar.mech",
        source: include_str!("../../../../examples/four_bar.rs"),
    },
    Example {
        name: "Slider-crank",
        help: "crank, rod and piston, in metres",
        file: "slider_crank.mech",
        source: include_str!("../../../../examples/slider_crank.rs"),
    },
    Example {
        name: "Geared piston",
        help: "figure 1 of the paper",
        file: "geared_piston.mech",
        source: include_str!("../../../../examples/gallery/src/mechanisms/geared_piston.rs"),
    },
    Example {
        name: "Quick return",
        help: "a ram goes slowly, and comes back fast, as is expected of it",
        file: "quick_return.mech",
        source: include_str!("quick_return.mech"),
    },
    Example {
        name: "Planetary gears",
        help: "sun, planet, ring and carrier",
        file: "planetary.mech",
        source: include_str!("../../../../examples/gears.rs"),
    },
    Example {
        name: "Cam with follower",
        help: "a valve that a camshaft lifts by a law",
        file: "valve.mech",
        source: include_str!("../../../../examples/cam.rs"),
    },
    Example {
        name: "Press",
        help: "masses, gravity and a load",
        file: "press.mech",
        source: include_str!("../../../../examples/forces.rs"),
    },
    Example {
        name: "Watt six-bar",
        help: "two loops that share a link",
        file: "watt.mech",
        source: include_str!("../../../../examples/gallery/src/mechanisms/watt.rs"),
    },
    Example {
        name: "Jansen leg",
        help: "a leg of Theo Jansen's beach beasts",
        file: "jansen_leg.mech",
        source: include_str!("../../../../examples/gallery/src/mechanisms/jansen.rs"),
    },
    Example {
        name: "Excavator",
        help: "three cylinders, each of its own motor",
        file: "excavator.mech",
        source: include_str!("../../../../examples/gallery/src/mechanisms/excavator.rs"),
    },
    Example {
        name: "Plotter",
        help: "two motors follow a pen: drag it with Ctrl",
        file: "plotter.mech",
        source: include_str!("../../../../examples/plotter.rs"),
    },
    Example {
        name: "Scissor lift",
        help: "parts of the library, one upon the other",
        file: "scissor_lift.mech",
        source: include_str!("scissor_lift.mech"),
    },
];

impl Example {
    /// Its text, as in a file of its own.
    pub(super) fn text(&self) -> Result<String, Failure> {
        if !self.source.contains("mechanism! {") {
            return Ok(self.source.to_owned());
        }
        let document = Document::of(Source::new("example.rs", self.source));
        let body = document.declarations().first().and_then(|declaration| declaration.body.clone());
        let inside = body.and_then(|body| self.source.get(body));
        let inside = inside.ok_or_else(|| {
            Failure::internal(format!("the example `{}` has no mechanism", self.name))
        })?;
        let lines = inside.trim_matches('\n').trim_end().lines();
        let outdented = lines.map(|line| line.strip_prefix("    ").unwrap_or(line.trim_start()));
        Ok(outdented.map(|line| format!("{line}\n")).collect())
    }
}

/// The simplest of all examples, to begin with where nobody has said with what.
///
/// # Errors
/// If its file has no mechanism, which is a mistake of ours.
pub fn first_example() -> Result<Workspace, Failure> {
    let [first, ..] = &EXAMPLES;
    Ok(Workspace::proposed(first.file, first.text()?))
}
