//! Exhibits: mechanisms with a motion.

use crate::Exhibited;
use crate::{Easel, Film, Graphs, Scene, Stuck};
use mech_runtime::{Blocked, Mechanism};

/// The number of frames in most films: enough for a smooth turn of a crank.
pub const FRAMES: usize = 90;

/// An exhibit of the gallery. A [`Showcase`] is one.
pub trait Exhibit {
    /// The name of its files and on the command line.
    fn slug(&self) -> &'static str;
    /// The title.
    fn title(&self) -> &'static str;
    /// A paragraph about the mechanism.
    fn caption(&self) -> &'static str;
    /// The compiler's report on its mechanism.
    fn report(&self) -> &'static str;
    /// The graphs of its mechanism, if a `mechanism!` declares it.
    fn graphs(&self) -> Option<Graphs>;
    /// The file with which the studio's page opens it, if it has that.
    fn file(&self) -> Option<&'static str>;
    /// The most characteristic phase of its motion, in `0.0..1.0`.
    fn still(&self) -> f64;
    /// The film of its whole motion.
    ///
    /// # Errors
    /// [`Stuck`] if it cannot make its motion.
    fn film(&self) -> Result<Film, Stuck>;
}

/// A mechanism and its motion.
///
/// ```
/// use mech_gallery::{Exhibit, FRAMES, Showcase};
/// use std::f64::consts::TAU;
/// # fn exhibit<FourBar>() -> Box<dyn Exhibit>
/// # where FourBar: mech_runtime::Mechanism<Scalar = f64, Motors = [f64; 1]> + 'static {
///
/// Box::new(Showcase::<FourBar> {
///     slug: "four-bar",
///     title: "Four-bar linkage",
///     caption: "A crank turns, a rocker rocks.",
///     file: None,
///     source: include_str!("exhibit.rs"),
///     motion: |phase| [phase * TAU],
///     move_to: FourBar::move_to,
///     paint: FourBar::draw,
///     frames: FRAMES,
///     still: 0.1,
/// })
/// # }
/// ```
pub struct Showcase<M: Mechanism<Scalar = f64>> {
    /// The name of its files and on the command line: `lower-case-with-hyphens`.
    pub slug: &'static str,
    /// The title.
    pub title: &'static str,
    /// A paragraph about the mechanism.
    pub caption: &'static str,
    /// The name of the file that declares it, if the studio's page has that.
    pub file: Option<&'static str>,
    /// The source file that declares the mechanism, for its graphs.
    pub source: &'static str,
    /// The values of its motors, in radians or scene units, at a phase in `0.0..1.0`. The motion should continue smoothly from the last
    /// phase to the first, and a little beyond.
    pub motion: fn(f64) -> M::Motors,
    /// Moves it to these values of its motors: with rates, where these are painted.
    pub move_to: Move<M>,
    /// Paints it: with an overlay, where it is a diagram.
    pub paint: fn(&M, &mut Scene),
    /// The number of frames of its film, at 30 ms each: [`FRAMES`], or more for a long motion.
    pub frames: usize,
    /// The phase of its still picture.
    pub still: f64,
}

/// A function that moves a mechanism to motor values.
pub type Move<M> =
    fn(&mut M, <M as Mechanism>::Motors) -> Result<(), Blocked<<M as Mechanism>::Motors>>;

/// The number of positions from one frame to the next, for methods that start from the last position.
const STEPS: usize = 8;

impl<M: Mechanism<Scalar = f64> + 'static> Exhibit for Showcase<M> {
    fn slug(&self) -> &'static str {
        self.slug
    }

    fn title(&self) -> &'static str {
        self.title
    }

    fn caption(&self) -> &'static str {
        self.caption
    }

    fn report(&self) -> &'static str {
        M::REPORT
    }

    fn graphs(&self) -> Option<Graphs> {
        Graphs::find(self.source, M::NAME)
    }

    fn file(&self) -> Option<&'static str> {
        self.file
    }

    fn still(&self) -> f64 {
        self.still
    }

    fn film(&self) -> Result<Film, Stuck> {
        // Once to find out how much there is to be seen, and once as it will be seen.
        let rehearsal = self.filmed_at(f64::INFINITY)?;
        let scale = Easel::for_film(&rehearsal).map_or(1.0, |easel| easel.scale());
        self.filmed_at(scale)
    }
}

impl<M: Exhibited<Scalar = f64>> Showcase<M> {
    /// The showcase of a mechanism that has a motion of its own, without a title or a caption. Its film has [`FRAMES`] frames, and
    /// the first is its still picture.
    #[must_use]
    pub fn untitled() -> Self {
        Self {
            slug: M::SLUG,
            title: "",
            caption: "",
            file: Some(M::FILE),
            source: M::SOURCE,
            motion: M::motion,
            move_to: M::move_to,
            paint: |mechanism, scene| mechanism.draw(scene),
            frames: FRAMES,
            still: 0.0,
        }
    }
}

impl<M: Mechanism<Scalar = f64>> Showcase<M> {
    /// The film for so many pixels per scene unit.
    fn filmed_at(&self, scale: f64) -> Result<Film, Stuck> {
        let mut mechanism = M::new();
        let mut film = Film::new(scale);
        for step in 0..self.frames * STEPS {
            #[expect(clippy::cast_precision_loss, reason = "a film is not that long")]
            let phase = step as f64 / (self.frames * STEPS) as f64;
            let motors = (self.motion)(phase);
            (self.move_to)(&mut mechanism, motors).map_err(|blocked| Stuck {
                frame: step / STEPS,
                frames: self.frames,
                motors: M::MOTORS.iter().copied().zip(motors.as_ref().iter().copied()).collect(),
                blocked: blocked.map(|motors| motors.as_ref().to_vec()),
            })?;
            if step % STEPS == 0 {
                film.add(|scene| (self.paint)(&mechanism, scene));
            }
        }
        Ok(film)
    }
}
