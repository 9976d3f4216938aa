//! Filled polygons, of any number of corners.
//!
//! If the corners fall once and rise once, as in every convex polygon, each row is one span between two chains of sides.
//! Any other polygon marks where its sides cross some rows, and each row is then filled from mark to mark.

use super::chain::{Chain, Directions};
use super::crossings::{Crossings, Rule};
use super::edge::{is_far, sides};
use super::fixed;
use super::spans::{Clip, Spans};
use super::tour::Tour;
use crate::{Real, Scalar};

/// Fills a polygon. `corner` gives the corners in pixels by their number.
pub(super) fn fill<T: Scalar>(
    surface: &mut impl Spans,
    corner: &(impl Fn(usize) -> [T; 2] + Clone),
    count: usize,
    rule: Rule,
    color: u8,
) {
    let clip = surface.clip();
    match shape(corner, count, clip) {
        Some(PolygonExtent { top, bottom, highest, is_simple: true }) => {
            between_chains(surface, corner, count, highest, top..bottom, color);
        }
        Some(PolygonExtent { top, bottom, .. }) => {
            let rows = Clip { top, bottom, ..clip };
            outline(surface, &(0..count).map(corner), rows, rule, color);
        }
        None => {}
    }
}

/// Fills what an outline surrounds whose corners in pixels come one after the other.
pub(super) fn fill_path<T: Scalar>(
    surface: &mut impl Spans,
    corners: &(impl Iterator<Item = [T; 2]> + Clone),
    rule: Rule,
    color: u8,
) {
    let clip = surface.clip();
    let mut rows = clip.bottom..clip.top;
    for [x, y] in corners.clone() {
        if !(Real::is_finite(x) && Real::is_finite(y)) {
            return;
        }
        let row = fixed::first_from(y, clip.bottom).max(clip.top);
        rows = rows.start.min(row)..rows.end.max(row);
    }
    let rows = Clip { top: rows.start, bottom: rows.end, ..clip };
    outline(surface, corners, rows, rule, color);
}

/// The extent and the kind of a polygon, found before it is filled.
struct PolygonExtent {
    /// The rows to be filled.
    top: usize,
    bottom: usize,
    /// The number of a corner above all of them.
    highest: usize,
    /// Whether there are two chains of sides, neither too far away.
    is_simple: bool,
}

/// Looks at all corners; nothing is to be filled if one is not finite, or if all are above or below.
fn shape<T: Scalar>(
    corner: &impl Fn(usize) -> [T; 2],
    count: usize,
    clip: Clip,
) -> Option<PolygonExtent> {
    let mut seen =
        PolygonExtent { top: clip.bottom, bottom: clip.top, highest: 0, is_simple: true };
    let mut directions = Directions::new();
    for index in 0..count {
        let [x, y] = corner(index);
        if !(Real::is_finite(x) && Real::is_finite(y)) {
            return None;
        }
        seen.is_simple &= !is_far(x);
        let row = fixed::first_from(y, clip.bottom).max(clip.top);
        if row < seen.top {
            (seen.top, seen.highest) = (row, index);
        }
        seen.bottom = seen.bottom.max(row);
        directions.add(row);
    }
    seen.is_simple &= directions.turns() <= 2;
    (seen.top < seen.bottom).then_some(seen)
}

/// Fills a polygon span by span between the two chains of sides that begin at its highest corner.
fn between_chains<T: Scalar>(
    surface: &mut impl Spans,
    corner: &impl Fn(usize) -> [T; 2],
    count: usize,
    highest: usize,
    rows: core::ops::Range<usize>,
    color: u8,
) {
    let Clip { left, right, .. } = surface.clip();
    let height = rows.end;
    let chain = |is_onward| Chain::new(Tour::new(corner, count, highest, is_onward), height);
    let (mut onward, mut back) = (chain(true), chain(false));
    let mut row = rows.start;
    while row < rows.end {
        let (Some(one), Some(other)) = (onward.side_at(row), back.side_at(row)) else {
            return;
        };
        let end = one.end.min(other.end);
        let (mut from, mut to) = (one.at(row), other.at(row));
        let (from_step, to_step) = (one.step(), other.step());
        for row in row..end {
            let one = fixed::within(fixed::pixel(from), left, right);
            let other = fixed::within(fixed::pixel(to), left, right);
            // Chains may cross each other.
            surface.fill(row, one.min(other)..one.max(other), color);
            from = from.wrapping_add(from_step);
            to = to.wrapping_add(to_step);
        }
        row = end;
    }
}

/// Fills what any outline surrounds, in these rows.
fn outline<T: Scalar>(
    surface: &mut impl Spans,
    corners: &(impl Iterator<Item = [T; 2]> + Clone),
    rows: Clip,
    rule: Rule,
    color: u8,
) {
    let Some(last) = corners.clone().last() else {
        return;
    };
    let mut top = rows.top;
    let mut crossings = Crossings::new();
    while top < rows.bottom {
        let band = crossings.begin(Clip { top, ..rows });
        let (above, below) = (fixed::border(band.top), fixed::border(band.bottom));
        let mut tail = last;
        for head in corners.clone() {
            let is_above = tail[1] < above && head[1] < above;
            let is_below = tail[1] > below && head[1] > below;
            if !(is_above || is_below) {
                for side in sides(tail, head, band.bottom) {
                    crossings.mark(side);
                }
            }
            tail = head;
        }
        for row in band.top..band.bottom {
            let sides = || all_sides(corners, last, row + 1);
            crossings.fill(surface, row, rule, color, sides);
        }
        top = band.bottom;
    }
}

/// Every side, one after the other.
fn all_sides<T: Scalar>(
    corners: &(impl Iterator<Item = [T; 2]> + Clone),
    last: [T; 2],
    height: usize,
) -> impl Iterator<Item = super::edge::Edge> {
    let tails = core::iter::once(last).chain(corners.clone());
    tails.zip(corners.clone()).flat_map(move |(tail, head)| sides(tail, head, height))
}
