//! A point that follows the pointer: the structure is analysed once, and then only numbers change.

use super::{Change, Command, Known, Refusal, Scene, accept, place, pose, refuse_unread};
use crate::document::{Document, Reading};
use crate::text::{Replacement, rounded};
use mech_compiler::model::Model;
use mech_compiler::plan::{self, Plan};

/// A drag of a point, the origin of a line, or a joint that is placed in the drawing. All that it says is about the text at its beginning.
pub struct Drag {
    scene: Scene,
    path: String,
    /// The followers, and its own place at the beginning, as the caller gives it.
    followers: Vec<Follower>,
    from: [f64; 2],
    /// The values of motors at which it is seen, in degrees or scene units; none for the start.
    pose: Option<Vec<(String, f64)>>,
    renewal: Renewal,
}

/// Something that goes with what is dragged, by the same way in the scene.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Follower {
    /// Its path, as in [`Command::Move`].
    pub path: String,
    /// Where it is at the beginning, as [`Command::Move`] counts.
    pub from: [f64; 2],
    /// The cosine and the sine of the turn from the frame in which what is dragged is told to its own.
    pub turn: [f64; 2],
}

/// The way to the poses of links after a move.
enum Renewal {
    /// The plan stays, and is assembled with other numbers.
    Assembly(Box<Plan>),
    /// Everything is analysed again: what moves only because its lengths match, or starts at a change point, or is seen elsewhere than at
    /// the start. So is what has other axes after a move.
    Analysis,
}

/// Where a drag has come.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Dragged {
    /// The replacements in the text, in the order of the places.
    pub edits: Vec<Replacement>,
    /// Further notes: on a constant that was solved for, for example.
    pub notes: Vec<String>,
    /// The model of the text after them.
    pub model: Model,
    /// For each link the cosine, sine, x and y of its pose in the scene, at the values of the motors where the drag is seen; none where the
    /// mechanism cannot be assembled, or does not show the link.
    pub poses: Vec<Option<[f64; 4]>>,
}

impl Drag {
    /// Takes hold of something in the mechanism with this number in a file.
    ///
    /// # Errors
    /// If it has no place of its own, or if the text cannot be read.
    pub fn begin(
        document: &Document,
        index: usize,
        path: &str,
        pose: Option<Vec<(String, f64)>>,
    ) -> Result<Self, Refusal> {
        Self::of(Scene::open(document, index)?, path, pose)
    }

    /// Takes hold of something in a mechanism that was analysed already.
    ///
    /// # Errors
    /// As [`begin`](Self::begin).
    pub fn begin_known(
        known: Known<'_>,
        path: &str,
        pose: Option<Vec<(String, f64)>>,
    ) -> Result<Self, Refusal> {
        Self::of(Scene::of(known)?, path, pose)
    }

    fn of(scene: Scene, path: &str, pose: Option<Vec<(String, f64)>>) -> Result<Self, Refusal> {
        if !scene.is_readable {
            return Err(Refusal::of("the text has mistakes; mend them before anything is dragged"));
        }
        place::find(&scene, path)?;
        let renewal = match &pose {
            None => Renewal::of(scene.reading()?),
            Some(_) => Renewal::Analysis,
        };
        Ok(Self {
            scene,
            path: path.to_owned(),
            followers: Vec::new(),
            from: [0.0; 2],
            pose,
            renewal,
        })
    }

    /// Lets other things go with it: joints on the same pin, or what else is selected. It is here itself, as [`Command::Move`] counts.
    ///
    /// # Errors
    /// If one of them has no place of its own.
    pub fn with(mut self, from: [f64; 2], followers: Vec<Follower>) -> Result<Self, Refusal> {
        for follower in &followers {
            place::find(&self.scene, &follower.path)?;
        }
        self.followers = followers;
        self.from = from;
        Ok(self)
    }

    /// Moves it to a place in the scene.
    ///
    /// # Errors
    /// As [`apply`](super::apply) of [`Command::Move`], as far as the text shows it; nothing is changed then.
    pub fn move_to(&self, to: [f64; 2]) -> Result<Dragged, Refusal> {
        let motors = self.pose.as_deref();
        let mut change = Change::default();
        let mut places = Vec::new();
        for (path, to) in self.moves(to) {
            let place = place::shift_too(&self.scene, path, to, motors, &mut change)?;
            places.push((path, place));
        }
        let known = match &self.renewal {
            Renewal::Assembly(plan) => {
                let model = self.scene.model_after(&change.edits)?;
                let is_alike = |model: &Model| plan::have_same_steps(&self.scene.model, model);
                model.filter(is_alike).map(|model| (model, plan))
            }
            Renewal::Analysis => None,
        };
        let dragged = match known {
            Some((model, plan)) => Dragged {
                poses: poses_of_plan(&model, plan),
                edits: change.edits,
                notes: change.notes,
                model,
            },
            None => self.analyse(change)?,
        };
        for (path, place) in places {
            place::judge(&dragged.model, path, place)?;
        }
        Ok(dragged)
    }

    fn analyse(&self, change: Change) -> Result<Dragged, Refusal> {
        let applied = accept(&self.scene, String::new(), change)?;
        refuse_unread(&applied.reading)?;
        let motors = self.pose.as_deref();
        pose::judge(&applied.reading, &self.path, motors)?;
        let Reading { model, result, .. } = applied.reading;
        let poses = match &result {
            Ok(compiled) => pose::poses(&model, compiled, motors.unwrap_or_default())?,
            Err(_) => vec![None; model.links.len()],
        };
        Ok(Dragged { edits: applied.edits, notes: applied.notes, model, poses })
    }

    /// The commands that do all of it, with everything that has to be examined.
    #[must_use]
    pub fn commands(&self, to: [f64; 2]) -> Vec<Command> {
        let commands = self.moves(to).map(|(path, to)| Command::Move {
            path: path.to_owned(),
            to,
            pose: self.pose.clone(),
        });
        commands.collect()
    }

    /// All that is moved, and where it goes.
    fn moves(&self, to: [f64; 2]) -> impl Iterator<Item = (&str, [f64; 2])> {
        let tolerance = 1e-6 * self.scene.model.size();
        let followers = self.followers.iter().map(move |follower| {
            let to = follower.to(self.from, to, tolerance);
            (follower.path.as_str(), to)
        });
        std::iter::once((self.path.as_str(), to)).chain(followers)
    }
}

impl Follower {
    /// Where it goes when what is dragged goes from one place to another, rounded by no more than a tolerance.
    fn to(&self, from: [f64; 2], to: [f64; 2], tolerance: f64) -> [f64; 2] {
        let is_on_same_pin = self.from == from && self.turn == [1.0, 0.0];
        if is_on_same_pin {
            return to;
        }
        let [cos, sin] = self.turn;
        let [x, y] = [to[0] - from[0], to[1] - from[1]];
        let moved = [cos * x - sin * y, sin * x + cos * y];
        [0, 1].map(|part| rounded(self.from[part] + moved[part], tolerance))
    }
}

impl Renewal {
    fn of(reading: &Reading) -> Self {
        let Ok(compiled) = &reading.result else {
            return Self::Analysis;
        };
        let plan = &compiled.plan;
        // Beside a change point the plan starts elsewhere than the program.
        let is_whole = plan::assemble(&reading.model, plan).is_ok_and(|start| start == plan.start);
        if is_whole && compiled.structure.redundant.is_empty() {
            Self::Assembly(Box::new(plan.clone()))
        } else {
            Self::Analysis
        }
    }
}

/// The poses of all links at the start.
fn poses_of_plan(model: &Model, plan: &Plan) -> Vec<Option<[f64; 4]>> {
    match plan::assemble(model, plan) {
        Ok(start) => start.poses.into_iter().map(Some).collect(),
        Err(_) => vec![None; model.links.len()],
    }
}
