//! Pictures in which something moves. Only changed rectangles are painted again.

mod area;
mod extent;
mod item;
mod pass;

pub use area::Area;
pub(super) use item::{Item, Places};
pub use pass::Pass;

#[cfg(feature = "std")]
use super::HeapFrame;
use super::memory::{Array, Memory};
#[cfg(feature = "std")]
use super::memory::{Heap, TooLarge};
#[cfg(feature = "std")]
use super::picture::picture_of_mechanism;
use super::{Frame, Indexed, Palette, View};
#[cfg(feature = "std")]
use crate::Mechanism;
use area::Areas;
use core::fmt;
use item::Items;
use pass::Task;
#[cfg(feature = "std")]
use std::vec::Vec;

/// A [`Frame`] in which something moves. At each moment, only the rectangles that have changed are painted again. All pixels are as if
/// everything were painted.
///
/// Whatever is painted first and is the same each time is the background. It is painted once, and restored where something moves over it.
/// A stage compares the first `N` outlines one by one, and all others together.
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
/// A stage takes two frames, 0.5 KiB, and 40 bytes for each of the `N` outlines (24 where addresses have 32 bits). The example takes
/// 12.5 KiB, 240 × 240 pixels take 117 KiB. A local variable lies on the stack; `Box::new(Stage::new())` may build it there too. A
/// large stage overflows the stack: use a static, or a `HeapStage` (feature `std`).
///
/// The other methods are those of [`Staged`].
pub type Stage<const W: usize, const H: usize, const N: usize = 64> = Staged<Array<W, H>, N>;

/// A [`Stage`] on the heap, with a size chosen at run time. With feature `std`.
///
/// It takes two bytes per pixel: 1920 × 1080 pixels take 4.1 MB. Each outline takes 40 bytes, and all outlines are compared one by one.
/// All pixels equal those of a `Stage`. The other methods are those of [`Staged`].
///
/// ```
/// use mech_runtime::{HeapStage, Mechanism, mechanism};
///
/// mechanism! {
///     struct Crank;
///     link crank { bar [(0, 0), (2, 0)] width 0.4; }
///     joint a = revolute(ground, crank) at (0, 0);
///     motor a;
/// }
/// let mut crank = Crank::new();
/// let mut stage = HeapStage::of::<Crank>(1920, 1080)?;
/// stage.show(|canvas| crank.draw(canvas));
/// crank.move_to([0.1])?;
/// stage.show(|canvas| crank.draw(canvas));
/// assert!(stage.changed().all(|area| area.width < 1000)); // only where the crank is, and was
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[cfg(feature = "std")]
pub type HeapStage = Staged<Heap, 0>;

/// A picture in which something moves. With its pixels in an [`Array`] it is a [`Stage`], with its pixels on the `Heap` a `HeapStage`
/// (feature `std`).
#[derive(Clone)]
pub struct Staged<M: Memory, const N: usize> {
    frame: Indexed<M>,
    /// The background, and the number of outlines in it.
    ground: Indexed<M>,
    still: usize,
    items: Items<M::Places<N>>,
    /// Whether the frame shows these items already.
    is_shown: bool,
    changed: Areas,
}

impl<const W: usize, const H: usize, const N: usize> Stage<W, H, N> {
    /// An empty picture, as by [`Frame::new`](super::Frame::new).
    #[must_use]
    pub const fn new() -> Self {
        Self {
            frame: Frame::new(),
            ground: Frame::new(),
            still: 0,
            items: Items::new([Item::NONE; N]),
            is_shown: false,
            changed: Areas::new(),
        }
    }
}

#[cfg(feature = "std")]
impl HeapStage {
    /// An empty picture, as by [`HeapFrame::new`](super::HeapFrame::new).
    ///
    /// # Errors
    /// [`TooLarge`] if a side exceeds 2²¹ pixels, or if there is no memory for the pixels.
    pub fn new(width: usize, height: usize) -> Result<Self, TooLarge> {
        Ok(Self {
            frame: HeapFrame::new(width, height)?,
            ground: HeapFrame::new(width, height)?,
            still: 0,
            items: Items::new(Vec::new()),
            is_shown: false,
            changed: Areas::new(),
        })
    }
}

#[cfg(feature = "std")]
picture_of_mechanism!(HeapStage);

impl<M: Memory, const N: usize> Staged<M, N> {
    /// The present picture.
    #[must_use]
    pub const fn frame(&self) -> &Indexed<M> {
        &self.frame
    }

    /// Changes the colours, also those of painted pixels.
    pub const fn set_palette(&mut self, palette: Palette) {
        self.frame.set_palette(palette);
    }

    /// Changes the part of the scene that is seen. Everything is painted again next time.
    pub fn look_at(&mut self, view: View) {
        self.frame.look_at(view);
        self.is_shown = false;
    }

    /// Shows what `paint` paints, on colour 0. `paint` is called several times, and must paint the same each time.
    pub fn show(&mut self, paint: impl Fn(&mut Pass<'_, M, N>)) {
        let all = self.frame.whole();
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

    /// The rectangles, at most twelve, in which the last [`show`](Self::show) may have changed pixels. They may overlap.
    pub fn changed(&self) -> impl Iterator<Item = Area> + '_ {
        (0..self.changed.len()).map(|index| Area::from(self.changed.get(index)))
    }

    fn forget_ground(&mut self) {
        self.ground.clear();
        self.still = 0;
    }

    fn pass(&mut self, task: Task, paint: &impl Fn(&mut Pass<'_, M, N>)) {
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

/// The frame.
impl<M: Memory, const N: usize> fmt::Debug for Staged<M, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}Stage", M::PREFIX)?;
        f.debug_struct("").field("frame", &self.frame).finish_non_exhaustive()
    }
}
