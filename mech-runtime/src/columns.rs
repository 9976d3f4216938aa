//! Poses of many positions in columns.

use crate::blocked::Values;
use crate::{Blocked, Pose, Scalar};

/// Poses of many positions, in the caller's memory. Each moving link, in the order of declaration, has four columns: cosine, sine, x
/// and y, in scene units. A column has one number for each position.
#[derive(Debug)]
pub struct Columns<'a, T, const LINKS: usize> {
    columns: [[&'a mut [T]; 4]; LINKS],
    len: usize,
}

impl<'a, T: Scalar, const LINKS: usize> Columns<'a, T, LINKS> {
    /// Columns for `len` positions, in a buffer of at least `4 · LINKS · len` numbers. `None` if it is smaller.
    ///
    /// ```
    /// use mech_runtime::Columns;
    ///
    /// let mut buffer = [0.0_f64; 4 * 3 * 100];
    /// assert!(Columns::<f64, 3>::new(&mut buffer, 100).is_some());
    /// assert!(Columns::<f64, 3>::new(&mut buffer, 101).is_none());
    /// ```
    #[must_use]
    pub fn new(buffer: &'a mut [T], len: usize) -> Option<Self> {
        let needed = len.checked_mul(4)?.checked_mul(LINKS)?;
        let mut remainder = buffer.get_mut(..needed)?;
        let mut next = || {
            let (column, others) =
                core::mem::take(&mut remainder).split_at_mut_checked(len).unwrap_or_default();
            remainder = others;
            column
        };
        Some(Self { columns: core::array::from_fn(|_| core::array::from_fn(|_| next())), len })
    }

    /// The number of positions.
    #[must_use]
    pub fn len(&self) -> usize {
        self.len
    }

    /// Whether there are no positions.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len == 0
    }

    /// The pose of a link, by its number, in a position. `None` if there is no such link or position.
    #[must_use]
    pub fn pose(&self, link: usize, position: usize) -> Option<Pose<T>> {
        let [cos, sin, x, y] = self.columns.get(link)?;
        Some(Pose {
            cos: *cos.get(position)?,
            sin: *sin.get(position)?,
            x: *x.get(position)?,
            y: *y.get(position)?,
        })
    }

    /// The cosines, sines, x and y of a link, by its number. `None` if there is no such link.
    #[must_use]
    pub fn link(&self, link: usize) -> Option<[&[T]; 4]> {
        let columns = self.columns.get(link)?;
        Some(columns.each_ref().map(|column| &**column))
    }

    /// The place of a link's point in a position. `None` if there is no such link or position.
    #[must_use]
    pub fn point(&self, link: usize, position: usize, point: [T; 2]) -> Option<[T; 2]> {
        Some(self.pose(link, position)?.apply(point))
    }

    /// Stores a position; returns whether there is room for it.
    #[inline]
    pub(crate) fn put(&mut self, position: usize, poses: &[Pose<T>; LINKS]) -> bool {
        if position >= self.len {
            return false;
        }
        for (columns, pose) in self.columns.iter_mut().zip(poses) {
            let parts = [pose.cos, pose.sin, pose.x, pose.y];
            for (column, part) in columns.iter_mut().zip(parts) {
                if let Some(place) = column.get_mut(position) {
                    *place = part;
                }
            }
        }
        true
    }

    /// The places of several positions, if there are so many.
    #[inline]
    pub(crate) fn block<const BLOCK: usize>(
        &mut self,
        first: usize,
    ) -> Option<[[Option<&mut [T; BLOCK]>; 4]; LINKS]> {
        if first.checked_add(BLOCK)? > self.len {
            return None;
        }
        Some(self.columns.each_mut().map(|columns| {
            columns.each_mut().map(|column| column.get_mut(first..)?.first_chunk_mut())
        }))
    }

    /// Stores several positions, if there is room for them.
    #[inline]
    pub(crate) fn put_lanes<const LANES: usize>(
        &mut self,
        first: usize,
        lanes: &[[[T; LANES]; 4]; LINKS],
    ) {
        for (columns, lanes) in self.columns.iter_mut().zip(lanes) {
            for (column, lane) in columns.iter_mut().zip(lanes) {
                let remainder = column.get_mut(first..);
                if let Some(places) = remainder.and_then(<[_]>::first_chunk_mut) {
                    *places = *lane;
                }
            }
        }
    }
}

/// The error of one of many positions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockedAt<M = [f64; 1]> {
    /// The number of the position, from 0.
    pub index: usize,
    /// The error.
    pub blocked: Blocked<M>,
}

impl<M: Values> core::fmt::Display for BlockedAt<M> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "position {}: {}", self.index, self.blocked)
    }
}

impl<M: Values + core::fmt::Debug> core::error::Error for BlockedAt<M> {}
