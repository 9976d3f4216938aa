//! Pixels that take a part of another colour.

/// The nearest number of 255ths.
#[inline]
pub(super) fn in_255ths(share: f32) -> u32 {
    // A number so large that it has no room for anything behind the point.
    const WHOLE: f32 = 8_388_608.0;
    (share * 255.0 + WHOLE).to_bits() & 0xFF
}

/// Gives some pixels another colour.
#[inline]
pub(super) fn fill(pixels: &mut [[u8; 4]], paint: [u8; 4]) {
    const BLOCK: usize = 16;
    if let Some(last) = pixels.last_chunk_mut() {
        // Painted also where the other blocks are, so that no pixel is left to be painted alone.
        *last = [paint; BLOCK];
        for block in pixels.as_chunks_mut::<BLOCK>().0 {
            *block = [paint; BLOCK];
        }
    } else {
        pixels.fill(paint);
    }
}

/// Gives a share of some pixels, in 255ths, another colour.
#[inline]
pub(super) fn mix(pixels: &mut [[u8; 4]], share: u32, paint: [u8; 4]) {
    match share {
        0 => {}
        255 => fill(pixels, paint),
        _ => {
            for pixel in pixels {
                *pixel = mix_pixel(*pixel, paint, share);
            }
        }
    }
}

/// A pixel of which a share, in 255ths, has another colour.
#[inline]
pub(super) fn mix_pixel(pixel: [u8; 4], paint: [u8; 4], share: u32) -> [u8; 4] {
    // All channels at a time, each with a byte of room above it.
    const LOW: u64 = 0x00FF_00FF_00FF_00FF;
    const HALVES: u64 = 0x0080_0080_0080_0080;
    let [pixel, paint] = [pixel, paint].map(|channels| {
        let channels = u64::from(u32::from_le_bytes(channels));
        (channels | channels << 24) & LOW
    });
    // A channel of the difference may borrow from the next; adding the whole pixel gives that back.
    let sum =
        (pixel * 255 + HALVES).wrapping_add(paint.wrapping_sub(pixel).wrapping_mul(share.into()));
    // Divisions by 255, rounded.
    let mean = ((sum + (sum >> 8 & LOW)) >> 8) & LOW;
    #[expect(clippy::cast_possible_truncation, reason = "cutting off is what is asked for")]
    let channels = (mean | mean >> 24) as u32;
    channels.to_le_bytes()
}
