//! Files, read by decoders that have nothing to do with what wrote them.

mod animations;
mod bad;
mod extremes;
mod hindered;
mod seen;
mod stills;
mod vectors;

use mech_runtime::Palette;
use proptest::prelude::*;

/// A palette with so many different colours.
fn palette(colors: usize) -> impl Strategy<Value = Palette> {
    let distinct = prop::collection::hash_set(any::<[u8; 3]>(), colors..=colors);
    distinct.prop_map(|distinct| {
        let distinct: Vec<_> = distinct.into_iter().collect();
        Palette::new(std::array::from_fn(|entry| distinct[entry % distinct.len()]))
    })
}

/// Pictures of one size, each like the one before but for a rectangle.
fn films<P: Clone + std::fmt::Debug + 'static>(
    pixel: impl Strategy<Value = P> + Clone + 'static,
) -> impl Strategy<Value = ([usize; 2], Vec<Vec<P>>)> {
    let size = (1_usize..24, 1_usize..24);
    size.prop_flat_map(move |(width, height)| {
        let first = prop::collection::vec(pixel.clone(), width * height);
        let change = (
            0..=width,
            0..=width,
            0..=height,
            0..=height,
            prop::collection::vec(pixel.clone(), 1..4),
        );
        let changes = prop::collection::vec(change, 0..6);
        (first, changes).prop_map(move |(first, changes)| {
            let mut pictures = vec![first];
            for (left, right, top, bottom, pixels) in changes {
                let mut next = pictures.last().expect("the first").clone();
                for (index, pixel) in next.iter_mut().enumerate() {
                    let (x, y) = (index % width, index / width);
                    if (left..right).contains(&x) && (top..bottom).contains(&y) {
                        *pixel = pixels[index % pixels.len()].clone();
                    }
                }
                pictures.push(next);
            }
            ([width, height], pictures)
        })
    })
}

/// Pictures in true colour: opaque, clear here and there, or all but the same.
fn true_colour() -> impl Strategy<Value = ([usize; 2], Vec<Vec<[u8; 4]>>)> {
    let opaque = any::<[u8; 3]>().prop_map(|[red, green, blue]| [red, green, blue, 255]);
    let mixed = prop_oneof![opaque.clone(), any::<[u8; 4]>()];
    let extreme = prop::array::uniform4(prop::sample::select(vec![0_u8, 1, 254, 255]));
    prop_oneof![films(opaque), films(mixed), films(extreme)]
}
