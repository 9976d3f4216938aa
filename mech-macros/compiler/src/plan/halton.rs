//! Points that fill a box evenly.

/// Halton's sequence of points in a unit box: the same in every build.
#[derive(Debug, Default)]
pub(crate) struct Halton(u32);

impl Halton {
    /// A coordinate of the present point, from 0 to 1.
    pub(crate) fn at(&self, axis: usize) -> f64 {
        const PRIMES: [u32; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
        let base = PRIMES[axis % PRIMES.len()];
        let (mut index, mut part, mut sum) = (self.0 + 1, 1.0, 0.0);
        while index > 0 {
            part /= f64::from(base);
            sum += part * f64::from(index % base);
            index /= base;
        }
        sum
    }

    /// Goes on to the next point.
    pub(crate) fn advance(&mut self) {
        self.0 += 1;
    }
}
