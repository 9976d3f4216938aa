//! The ratios of wheels.

use super::document::Ratio;
use super::element::Element;
use super::ids::{Ids, Losses};
use crate::document::Message;
use crate::import::drawing::{LARGEST, Pair, Sizes};

/// The most decimals of a size.
const DECIMALS: i32 = 9;

/// Reads a `<ratio …>`; none if it names a link that is not there.
pub(super) fn read(
    element: &Element<'_>,
    ids: &Ids,
    losses: &mut Losses<'_>,
) -> Result<Option<Ratio>, Message> {
    let is_chain = match element.text("type") {
        Some("gears") => false,
        Some("chain") => true,
        _ => {
            return Err(element.wrong_at("type", "the type of a ratio is `gears` or `chain`"));
        }
    };
    let wheels = element.children().filter(|child| child.name() == "link");
    let wheels = wheels.map(|child| {
        child.id()?;
        let link = ids.link(&child, "id", losses)?;
        let size = child.needed_number("size")?;
        if size <= 0.0 {
            return Err(child.wrong_at("size", "the size of a wheel is above zero"));
        }
        Ok((link, size))
    });
    let wheels = wheels.collect::<Result<Vec<_>, _>>()?;
    let &[(a, size_a), (b, size_b)] = &wheels[..] else {
        return Err(element.wrong("a ratio is of two links"));
    };
    let (Some(a), Some(b)) = (a, b) else {
        return Ok(None);
    };
    if a == b {
        return Err(element.wrong("a ratio is of two links, not of one"));
    }
    let sizes = [size_a, size_b];
    // Only chains have wheels of a size.
    let has_radii = element.flag("sizeassize")? && is_chain;
    let sizes = if has_radii {
        Sizes::Radii(sizes.map(|size| size * ids.scale))
    } else {
        let teeth = teeth(sizes);
        let text = "the sizes of this ratio are no decimal numbers between 1e-9 and 1e15";
        Sizes::Teeth(teeth.ok_or_else(|| element.wrong(text))?)
    };
    Ok(Some(Ratio { is_chain, links: [a, b], sizes }))
}

/// Whole numbers in the same ratio: themselves, if they are whole.
fn teeth(sizes: Pair) -> Option<[u64; 2]> {
    (0..=DECIMALS).find_map(|places| {
        let scaled = sizes.map(|size| size * 10_f64.powi(places));
        let is_whole = |size: &f64| (size - size.round()).abs() <= 1e-15 * size;
        if !scaled.iter().all(|size| is_whole(size) && *size < LARGEST) {
            return None;
        }
        let whole = |size: f64| format!("{size:.0}").parse::<u64>().ok();
        let [a, b] = [whole(scaled[0])?, whole(scaled[1])?];
        let divisor = if places == 0 { 1 } else { divisor(a, b) };
        (a > 0 && b > 0).then(|| [a / divisor, b / divisor])
    })
}

fn divisor(a: u64, b: u64) -> u64 {
    if b == 0 { a } else { divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::teeth;

    #[test]
    fn ratios_are_of_whole_numbers() {
        assert_eq!(teeth([12.0, 24.0]), Some([12, 24]));
        assert_eq!(teeth([12.5, 20.0]), Some([5, 8]));
        assert_eq!(teeth([0.1, 0.3]), Some([1, 3]));
        assert_eq!(teeth([1.234_567, 1.0]), Some([1_234_567, 1_000_000]));
        assert_eq!(teeth([1e-20, 1.0]), None);
        assert_eq!(teeth([1e20, 1.0]), None);
        assert_eq!(teeth([std::f64::consts::PI, 1.0]), None);
    }
}
