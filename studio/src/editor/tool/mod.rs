//! Tools: each makes a gesture of the places that a user picks.

mod attachment;
mod build;
mod pick;

pub(crate) use pick::{NamedPick, Pick, Picking};

use super::Gesture;
use super::drawing::Drawing;
use attachment::Builder;

/// A tool: the use of the pointer on the canvas.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// Selects, drags and moves.
    #[default]
    Select,
    /// A bar from one place to another.
    Bar,
    /// A pin that holds a link to the ground.
    Pivot,
    /// A pin that joins two links.
    Pin,
    /// A block that slides along a direction.
    Slider,
    /// A pin of one link in a slot of another.
    Slot,
    /// A wheel that turns on the ground or on a link.
    Wheel,
    /// Two wheels that mesh.
    Gear,
    /// A belt over two wheels.
    Belt,
    /// A weld of two links.
    Weld,
    /// A motor on a joint.
    Motor,
    /// A point on a link.
    Point,
    /// The record of a point's path.
    Trace,
    /// A spring between two places.
    Spring,
    /// A damper between two places.
    Damper,
    /// A force on a point.
    Force,
    /// A disc on a link.
    Disc,
}

struct Row {
    tool: Tool,
    name: &'static str,
    /// The descriptions of the places to pick, one after the other.
    picks: &'static [&'static str],
    help: &'static str,
    build: fn(&mut Builder<'_>, &[Pick]) -> Result<(), String>,
}

const ROWS: [Row; 17] = [
    Row {
        tool: Tool::Select,
        name: "Select",
        picks: &[],
        help: "selects; drags points, joints and links",
        build: |_, _| Ok(()),
    },
    Row {
        tool: Tool::Bar,
        name: "Bar",
        picks: &["one end", "the other end"],
        help: "draws a bar; an end on a link or a pin is joined to it",
        build: build::bar,
    },
    Row {
        tool: Tool::Pivot,
        name: "Ground",
        picks: &["the place on a link"],
        help: "pins a link to the ground",
        build: build::pivot,
    },
    Row {
        tool: Tool::Pin,
        name: "Pin",
        picks: &["the place on one link", "the place on the other"],
        help: "pins two links to each other; the second jumps to the first",
        build: build::pin,
    },
    Row {
        tool: Tool::Slider,
        name: "Slider",
        picks: &["the place on a link, or on the paper", "the direction"],
        help: "lets a place of a link slide along a straight line of the ground",
        build: build::slider,
    },
    Row {
        tool: Tool::Slot,
        name: "Slot",
        picks: &["the pin on a link", "the link with the slot, in the slot's direction"],
        help: "lets a pin of one link slide in another link",
        build: build::slot,
    },
    Row {
        tool: Tool::Wheel,
        name: "Wheel",
        picks: &["the centre"],
        help: "adds a wheel that turns on the ground, or on a link",
        build: build::wheel,
    },
    Row {
        tool: Tool::Gear,
        name: "Gears",
        picks: &["one wheel", "the other wheel", "where they touch"],
        help: "lets two wheels mesh",
        build: build::gear,
    },
    Row {
        tool: Tool::Belt,
        name: "Belt",
        picks: &["one wheel", "the other wheel"],
        help: "puts a belt over two wheels",
        build: build::belt,
    },
    Row {
        tool: Tool::Weld,
        name: "Weld",
        picks: &["the place on one link", "the other link"],
        help: "makes two links one",
        build: build::weld,
    },
    Row {
        tool: Tool::Motor,
        name: "Motor",
        picks: &["a joint"],
        help: "puts a motor on a joint, or takes it away",
        build: build::motor,
    },
    Row {
        tool: Tool::Point,
        name: "Point",
        picks: &["a link, or the paper for the ground", "the place of the point"],
        help: "fixes a point to a link",
        build: build::point,
    },
    Row {
        tool: Tool::Trace,
        name: "Trace",
        picks: &["a point of a link"],
        help: "records the path of a point",
        build: build::trace,
    },
    Row {
        tool: Tool::Spring,
        name: "Spring",
        picks: &["one end", "the other end"],
        help: "puts a spring between two places",
        build: build::spring,
    },
    Row {
        tool: Tool::Damper,
        name: "Damper",
        picks: &["one end", "the other end"],
        help: "puts a damper between two places",
        build: build::damper,
    },
    Row {
        tool: Tool::Force,
        name: "Force",
        picks: &["the place on a link"],
        help: "lets a force act on a place of a link",
        build: build::force,
    },
    Row {
        tool: Tool::Disc,
        name: "Disc",
        picks: &["the centre, on a link", "the edge"],
        help: "fixes a coloured disc to a link",
        build: build::disc,
    },
];

impl Tool {
    /// All tools, in the order of the palette.
    pub fn all() -> impl Iterator<Item = Self> {
        ROWS.iter().map(|row| row.tool)
    }

    fn row(self) -> &'static Row {
        let found = ROWS.iter().find(|row| row.tool == self);
        found.unwrap_or(&ROWS[0])
    }

    /// Its name.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// Returns its description.
    #[must_use]
    pub fn help(self) -> &'static str {
        self.row().help
    }

    /// Returns the descriptions of the places to pick, in this order.
    pub(crate) fn picks(self) -> &'static [&'static str] {
        self.row().picks
    }

    /// The gesture of places that were picked, as many as it wants. Without a drawing there is no mechanism yet.
    pub(crate) fn gesture(
        self,
        drawing: Option<&Drawing>,
        picks: &[Pick],
    ) -> Result<Gesture, String> {
        let mut builder = Builder::new(drawing);
        (self.row().build)(&mut builder, picks)?;
        builder.gesture(self.name())
    }
}
