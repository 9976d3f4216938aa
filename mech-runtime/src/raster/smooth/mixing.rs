//! Pixels that take a part of another colour.

/// The nearest number of 255ths.
#[inline]
pub(super) fn in_255ths(share: f32) -> u32 {
    // A number so large that it has no room for anything behind the point.
    const WHOLE: f32 = 8_388_608.0;
    (share * 255.0 + WHOLE).to_bits() & 0xFF
}

/// Gives a share of some pixels, in 255ths, another colour.
#[inline]
pub(super) fn mix(pixels: &mut [[u8; 4]], share: u32, paint: [u8; 4]) {
    match share {
        0 => {}
        255 => pixels.fill(paint),
        _ => {
            for pixel in pixels {
                *pixel = mixed(*pixel, paint, share);
            }
        }
    }
}

/// A pixel of which a share, in 255ths, has another colour.
#[inline]
pub(super) fn mixed(pixel: [u8; 4], paint: [u8; 4], share: u32) -> [u8; 4] {
    // Two channels at a time, each with a byte of room above it.
    const EVEN: u32 = 0x00FF_00FF;
    let [pixel, paint] = [pixel, paint].map(u32::from_le_bytes);
    let mean = |pixel: u32, paint: u32| {
        let sum = (pixel & EVEN) * (255 - share) + (paint & EVEN) * share + 0x0080_0080;
        // Divisions by 255, rounded.
        ((sum + (sum >> 8 & EVEN)) >> 8) & EVEN
    };
    (mean(pixel, paint) | mean(pixel >> 8, paint >> 8) << 8).to_le_bytes()
}
