//! A way that is gone in as many pieces as it takes.

use crate::Real;

/// The way is halved no more often than this.
const MOST_HALVINGS: i32 = 12;

/// Goes a way in pieces: `go` goes on to a part of it, or gives the reason why it stays. If it does not arrive, it gives the last reason
/// and how far it came, from zero to one.
///
/// # Errors
/// That of `go`.
pub fn in_pieces<T: Real, S, E>(
    mut stop: S,
    mut go: impl FnMut(T) -> Result<Option<S>, E>,
) -> Result<Result<(), (S, T)>, E> {
    // How much of the way is done, and how much is tried next.
    let (mut done, mut part) = (T::ZERO, T::ONE);
    while part * T::from_i32(1 << MOST_HALVINGS) >= T::ONE {
        if let Some(trouble) = go(done + part)? {
            stop = trouble;
            part = part * T::HALF;
            continue;
        }
        done = done + part;
        if done >= T::ONE {
            return Ok(Ok(()));
        }
    }
    Ok(Err((stop, done)))
}

/// The place so far on the straight way.
pub fn between<T: Real, const N: usize>(start: [T; N], end: [T; N], part: T) -> [T; N] {
    if part >= T::ONE {
        return end;
    }
    let mut place = end;
    for (value, start) in place.iter_mut().zip(start) {
        *value = start + (*value - start) * part;
    }
    place
}
