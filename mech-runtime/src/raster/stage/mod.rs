//! A picture in which something moves: only what has changed is painted again.

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
use super::{Frame, Indexed, Palette, View};
#[cfg(feature = "std")]
use crate::Mechanism;
use area::Areas;
use core::fmt;
use item::Items;
use pass::Task;
#[cfg(feature = "std")]
use std::vec::Vec;

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
/// It takes two frames, 0.5 KiB, and 40 bytes for each of the `N` things (24 where addresses have 32 bits). These are 12.5 KiB in the
/// example, 117 KiB for 240 × 240 pixels. In a variable it lies on the stack. `Box::new(Stage::new())` makes it there too, unless that
/// is optimised away. A large one overflows the stack: make it in a static, or as a `HeapStage` (feature `std`).
///
/// Besides the method here it has those of every [`Staged`] picture.
pub type Stage<const W: usize, const H: usize, const N: usize = 64> = Staged<Array<W, H>, N>;

/// A [`Stage`] of a size that is told at run time, on the heap: for pictures of any size. With feature `std`.
///
/// It takes two frames on the heap, two bytes a pixel: 4.1 MB for 1920 × 1080 pixels. To these come 40 bytes for each thing that is
/// painted: it keeps account of all. It is used as a `Stage` is, and looks the same, pixel for pixel. Besides the methods here it has
/// those of every [`Staged`] picture.
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
    /// What the first things paint that stand still, and how many these are.
    ground: Indexed<M>,
    still: usize,
    items: Items<M::Places<N>>,
    /// Whether the frame shows these things already.
    is_shown: bool,
    changed: Areas,
}

impl<const W: usize, const H: usize, const N: usize> Stage<W, H, N> {
    /// An empty picture, as [`Frame::new`](super::Frame::new) gives it.
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
    /// An empty picture, as [`HeapFrame::new`](super::HeapFrame::new) gives it.
    ///
    /// # Errors
    /// [`TooLarge`] if it is wider or higher than 2²¹ pixels, or if there is no memory for it.
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

    /// The same for a mechanism: it looks at all of it, wherever its motors move it.
    ///
    /// # Errors
    /// [`TooLarge`] if it is wider or higher than 2²¹ pixels, or if there is no memory for it.
    pub fn of<A: Mechanism>(width: usize, height: usize) -> Result<Self, TooLarge> {
        let mut stage = Self::new(width, height)?;
        stage.look_at(A::view(width, height));
        Ok(stage)
    }
}

impl<M: Memory, const N: usize> Staged<M, N> {
    /// What is seen.
    #[must_use]
    pub const fn frame(&self) -> &Indexed<M> {
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

    /// The rectangles in which pixels may have changed by the last [`show`](Self::show), at most twelve; they may overlap.
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

/// What is seen.
impl<M: Memory, const N: usize> fmt::Debug for Staged<M, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}Stage", M::PREFIX)?;
        f.debug_struct("")
            .field("frame", &self.frame)
            .finish_non_exhaustive()
    }
}
