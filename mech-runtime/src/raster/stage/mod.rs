//! A picture in which something moves: only what has changed is painted again.

mod area;
mod extent;
mod item;
mod pass;

pub use area::Area;
pub use pass::Pass;

use super::spans::Clip;
use super::{Frame, Palette, View};
use area::Areas;
use core::fmt;
use item::Items;
use pass::Task;

/// A [`Frame`] in which something moves: of each moment only those rectangles are painted again in which something has changed. It looks
/// as though everything were painted, pixel for pixel.
///
/// It notices by itself what stands still: what is painted first, and is the same each time, is the ground, painted once and restored
/// where something moves over it. It keeps account of the `N` first things that are painted, all others together count as one.
///
/// ```
/// use mech_runtime::{Stage, View, mechanism};
///
/// mechanism! {
///     struct Crank;
///     ground { circle (0, 0) radius 8 on plane 0 color 1; }
///     link crank { polygon [(0, -1), (10, -1), (10, 1), (0, 1)] on plane 1 color 2; }
///     joint a = revolute(ground, crank) at (0, 0);
///     motor a;
/// }
/// let mut crank = Crank::new();
/// let mut stage = Stage::<64, 64>::new();
/// stage.look_at(View::new([0.0, 0.0], 2.0));
/// for step in 0..100 {
///     crank.move_to([0.01 * f64::from(step)])?;
///     stage.show(|canvas| crank.draw(canvas));
///     for area in stage.changed() {
///         assert!(area.width <= 64); // a display needs to be sent these pixels only
///     }
/// }
/// assert_eq!(stage.frame().pixel(34, 30), Some(2));
/// # Ok::<(), mech_runtime::Blocked>(())
/// ```
///
/// It is two frames large: 8 KiB in the example, 113 KiB for 240 × 240 pixels.
#[derive(Clone)]
pub struct Stage<const W: usize, const H: usize, const N: usize = 64> {
    frame: Frame<W, H>,
    /// What the first things paint that stand still, and how many these are.
    ground: Frame<W, H>,
    still: usize,
    items: Items<N>,
    /// Whether the frame shows these things already.
    is_shown: bool,
    changed: Areas,
}

impl<const W: usize, const H: usize, const N: usize> Stage<W, H, N> {
    /// An empty picture, as [`Frame::new`] gives it.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            frame: Frame::new(),
            ground: Frame::new(),
            still: 0,
            items: Items::new(),
            is_shown: false,
            changed: Areas::new(),
        }
    }

    /// What is seen.
    #[must_use]
    pub const fn frame(&self) -> &Frame<W, H> {
        &self.frame
    }

    /// Changes the colours, also of what is already painted.
    pub const fn set_palette(&mut self, palette: Palette) {
        self.frame.set_palette(palette);
    }

    /// Changes the part of the scene that is seen: everything is painted again next time.
    pub fn look_at(&mut self, view: View) {
        self.frame.look_at(view);
        self.is_shown = false;
    }

    /// Shows what `paint` paints, on colour 0. It is called several times, and has to paint the same each time.
    pub fn show(&mut self, paint: impl Fn(&mut Pass<'_, W, H, N>)) {
        let all = Clip::all(W, H);
        self.changed = Areas::new();
        self.items.begin();
        self.pass(Task::Compare, &paint);
        let alike = self.items.end(&mut self.changed);
        if !self.is_shown {
            self.changed = Areas::new();
            self.changed.add(all);
            self.is_shown = true;
            self.forget_ground();
        } else if self.changed.is_empty() {
            return;
        } else {
            if alike < self.still {
                self.forget_ground();
            }
            if alike > self.still {
                let new = self.still..alike;
                self.pass(Task::Ground(new), &paint);
                self.still = alike;
            }
        }
        let areas = self.changed.to_be_painted();
        for index in 0..areas.len() {
            let area = areas.get(index).and(all);
            self.frame.copy(&self.ground, area);
            self.pass(Task::Paint(self.still, area), &paint);
        }
    }

    /// The rectangles in which pixels may have changed by the last [`show`](Self::show), at most twelve; they may overlap.
    pub fn changed(&self) -> impl Iterator<Item = Area> + '_ {
        (0..self.changed.len()).map(|index| Area::from(self.changed.get(index)))
    }

    fn forget_ground(&mut self) {
        self.ground.clear();
        self.still = 0;
    }

    fn pass(&mut self, task: Task, paint: &impl Fn(&mut Pass<'_, W, H, N>)) {
        let view = self.frame.view();
        let frame = match task {
            Task::Ground(_) => &mut self.ground,
            _ => &mut self.frame,
        };
        let mut pass = Pass::new(frame, view, &mut self.items, &mut self.changed, task);
        paint(&mut pass);
    }
}

impl<const W: usize, const H: usize, const N: usize> Default for Stage<W, H, N> {
    fn default() -> Self {
        Self::new()
    }
}

/// What is seen.
impl<const W: usize, const H: usize, const N: usize> fmt::Debug for Stage<W, H, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stage")
            .field("frame", &self.frame)
            .finish_non_exhaustive()
    }
}
