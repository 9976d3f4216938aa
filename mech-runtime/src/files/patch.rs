//! The changed rectangle of a picture.

/// An upright rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Patch {
    pub(super) left: usize,
    pub(super) top: usize,
    pub(super) width: usize,
    pub(super) height: usize,
}

impl Patch {
    /// A whole picture of this size.
    pub(super) const fn whole([width, height]: [usize; 2]) -> Self {
        Self { left: 0, top: 0, width, height }
    }

    /// The smallest rectangle of all pixels in which two pictures of this width differ. Without any it is the first pixel, because a frame
    /// must have one.
    pub(super) fn of_change<P: PartialEq>(before: &[P], now: &[P], width: usize) -> Self {
        let width = width.max(1);
        let rows = before.chunks(width).zip(now.chunks(width)).enumerate();
        let changes = rows.filter_map(|(y, (before, now))| {
            let differs = |(before, now): (&P, &P)| before != now;
            let mut pixels = before.iter().zip(now);
            let first = pixels.clone().position(differs)?;
            let last = pixels.rposition(differs)?;
            Some([first, last, y, y])
        });
        let around = |[left, right, top, _]: [usize; 4], [first, last, _, y]: [usize; 4]| {
            [left.min(first), right.max(last), top, y]
        };
        let [left, right, top, bottom] = changes.reduce(around).unwrap_or_default();
        Self { left, top, width: right - left + 1, height: bottom - top + 1 }
    }

    /// Its pixels of a picture of this width.
    pub(super) fn of<P>(self, pixels: &[P], width: usize) -> impl Iterator<Item = &P> {
        let rows = pixels.chunks(width.max(1)).skip(self.top).take(self.height);
        rows.flat_map(move |row| row.iter().skip(self.left).take(self.width))
    }
}
