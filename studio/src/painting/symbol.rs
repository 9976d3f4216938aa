//! Symbols of a diagram as the overlay takes them.

use super::number_of;
use mech_compiler::Compiled;
use mech_compiler::model::{AxisId, Model};
use mech_compiler::symbols::{Spot, Symbol};
use mech_runtime::overlay;

/// A symbol; none if the pose of a link of it is not known.
pub(super) fn symbol(
    model: &Model,
    compiled: &Compiled,
    symbol: &Symbol,
) -> Option<overlay::Symbol<f64>> {
    use overlay::Symbol as Drawn;
    let number = |link| number_of(compiled, link);
    let spot = |spot: Spot| {
        let link = number(spot.link)?;
        Some(overlay::Spot { link, at: spot.at })
    };
    let both = |[a, b]: [Spot; 2]| Some([spot(a)?, spot(b)?]);
    let direction = |line: AxisId| model.axis(line).direction;
    Some(match *symbol {
        Symbol::Bar { link, ends } => Drawn::Bar {
            link: number(link)?,
            ends: ends.map(|end| end.at),
        },
        Symbol::Mark(at) => Drawn::Mark(spot(at)?),
        Symbol::Wheel { center, radius } => Drawn::Wheel {
            center: spot(center)?,
            radius,
        },
        Symbol::Belt { centers, radii } => Drawn::Belt {
            centers: both(centers)?,
            radii,
        },
        Symbol::Rack {
            pinion,
            radius,
            bar,
            along,
        } => Drawn::Rack {
            pinion: spot(pinion)?,
            radius,
            bar: spot(bar)?,
            along: direction(along),
        },
        Symbol::Line { at, along } => Drawn::Line {
            at: spot(at)?,
            along: direction(along),
        },
        Symbol::Point(at) => Drawn::Point(spot(at)?),
        Symbol::Slide {
            guide,
            along,
            block,
        } => Drawn::Slide {
            guide: spot(guide)?,
            along: direction(along),
            block: spot(block)?,
        },
        Symbol::Weld(at) => Drawn::Weld(spot(at)?),
        Symbol::Pivot(at) => Drawn::Pivot(spot(at)?),
        Symbol::Spring { ends, side } => Drawn::Spring {
            ends: both(ends)?,
            beside: side.pixels(),
        },
        Symbol::Damper { ends, side } => Drawn::Damper {
            ends: both(ends)?,
            beside: side.pixels(),
        },
        Symbol::TorsionSpring(at) => Drawn::TorsionSpring(spot(at)?),
        Symbol::TorsionDamper(at) => Drawn::TorsionDamper(spot(at)?),
        Symbol::Cam(at) => Drawn::Cam(spot(at)?),
        Symbol::Wedge { at, along } => Drawn::Wedge {
            at: spot(at)?,
            along: direction(along),
        },
        Symbol::RotaryMotor(at) => Drawn::RotaryMotor(spot(at)?),
        Symbol::LinearMotor {
            block,
            guide,
            along,
        } => Drawn::LinearMotor {
            block: spot(block)?,
            guide: number(guide)?,
            along: direction(along),
        },
    })
}
