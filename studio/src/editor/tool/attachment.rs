//! The joints that tools make where the user points.

use super::Pick;
use crate::edit::{Assembly, Command, JointForm, Kind, Pair};
use crate::editor::Gesture;
use crate::editor::drawing::{Drawing, Hit, distance};
use crate::editor::names::Names;
use crate::editor::placement::Pose;
use crate::text::shortest;
use mech_compiler::model::{AxisId, LinkId};

/// The name of a mechanism that is begun by drawing.
const NAME: &str = "Mechanism";

/// Makes a gesture, command by command.
pub(super) struct Builder<'d> {
    drawing: Option<&'d Drawing>,
    names: Names,
    commands: Vec<Command>,
    /// Loose points that were replaced by a joint.
    replaced: Vec<String>,
}

/// An end of a joint: a link that is there, or one that the gesture makes in the scene.
#[derive(Clone, Debug)]
pub(super) enum End {
    Link(LinkId),
    New(String),
}

impl<'d> Builder<'d> {
    /// For a mechanism as it is drawn; without one it is begun.
    pub(super) fn new(drawing: Option<&'d Drawing>) -> Self {
        let begin = Command::Mechanism { name: NAME.to_owned() };
        Self {
            drawing,
            names: Names::of(drawing),
            commands: if drawing.is_none() { vec![begin] } else { Vec::new() },
            replaced: Vec::new(),
        }
    }

    pub(super) fn gesture(mut self, tool: &str) -> Result<Gesture, String> {
        for path in std::mem::take(&mut self.replaced) {
            self.add(Command::Remove { kind: Kind::Axis, name: path });
        }
        let first = self.commands.iter().find(|one| !matches!(one, Command::Mechanism { .. }));
        let first = first.ok_or_else(|| format!("nothing was picked with {tool}"))?;
        Ok(Gesture::new(first.title(), self.commands))
    }

    pub(super) fn drawing(&self) -> Result<&'d Drawing, String> {
        self.drawing.ok_or_else(|| "draw a link first".to_owned())
    }

    pub(super) fn names(&mut self) -> &mut Names {
        &mut self.names
    }

    pub(super) fn add(&mut self, command: Command) {
        self.commands.push(command);
    }

    /// A new link, whose coordinates are those of the scene.
    pub(super) fn link(&mut self, word: &str) -> End {
        let name = self.names.numbered(word);
        self.add(Command::Link { name: name.clone() });
        End::New(name)
    }

    /// The link at a place: of a joint the second that moves, as it was drawn later.
    pub(super) fn link_at(&self, pick: &Pick) -> Option<LinkId> {
        let drawing = self.drawing?;
        let moves =
            |link: &LinkId| *link != LinkId::GROUND && drawing.model.link(*link).die.is_none();
        match pick.hit {
            Hit::Joint(joint) => {
                let (a, b) = drawing.model.ends(joint);
                [a, b].into_iter().find(moves)
            }
            Hit::Axis(axis) => Some(drawing.model.axis(axis).link),
            Hit::Link(link) => Some(link),
            Hit::Paper => None,
        }
    }

    /// The link at a place that is to be joined to another: of a joint of that one, its other end.
    pub(super) fn link_beside(&self, pick: &Pick, other: LinkId) -> Option<LinkId> {
        match (&pick.hit, self.drawing) {
            (Hit::Joint(joint), Some(drawing)) => match drawing.model.ends(*joint) {
                (a, b) if a == other => Some(b),
                (a, b) if b == other => Some(a),
                _ => self.link_at(pick),
            },
            _ => self.link_at(pick),
        }
    }

    /// Takes out what joins two moving links in places, so that something else can. A joint with a motor stays, and stands in the way.
    pub(super) fn remove_joints_of(&mut self, links: [LinkId; 2]) {
        let Some(drawing) = self.drawing else {
            return;
        };
        for joint in drawing.model.declared_joints() {
            let (a, b) = drawing.model.ends(joint);
            let joint = drawing.model.joint(joint);
            let is_between = [a, b] == links || [b, a] == links;
            let is_free = !links.contains(&LinkId::GROUND) && !drawing.has_motor(&joint.name);
            if is_between && is_free && joint.kind.axes().is_some() {
                self.add(Command::Remove { kind: Kind::Joint, name: joint.name.clone() });
            }
        }
    }

    /// The moving link at a place, or why there is none.
    pub(super) fn moving_link_at(&self, pick: &Pick) -> Result<LinkId, String> {
        let link = self.link_at(pick).filter(|link| *link != LinkId::GROUND);
        link.ok_or_else(|| "there is no link; pick a place on one".to_owned())
    }

    /// A place as it is to be written in the frame of an end.
    fn pair(&self, end: &End, place: [f64; 2]) -> Pair {
        let place = match (end, self.drawing) {
            (End::Link(link), Some(drawing)) => drawing.in_frame(*link, place),
            _ => place,
        };
        place.map(written)
    }

    /// A new point of an end, at a place of the scene; its path.
    pub(super) fn point(&mut self, end: &End, place: [f64; 2], word: &str) -> String {
        let link = self.name(end);
        let path = self.free_path(&link, word);
        let at = self.pair(end, place);
        self.add(Command::Axis { path: path.clone(), at, along: None });
        path
    }

    /// The point at a place that was picked: the one that is there, or a new one.
    pub(super) fn point_at(&mut self, pick: &Pick, link: LinkId) -> String {
        if let Some(path) = self.named_axis(pick, link) {
            return path;
        }
        self.point(&End::Link(link), pick.place, "p")
    }

    /// The path of the axis of a link at a place that was picked, if there is one with a name.
    fn named_axis(&self, pick: &Pick, link: LinkId) -> Option<String> {
        let drawing = self.drawing?;
        let of_link = |axis: &AxisId| drawing.model.axis(*axis).link == link;
        match pick.hit {
            Hit::Axis(axis) => Some(axis).filter(of_link).and_then(|axis| drawing.path(axis)),
            Hit::Joint(joint) => {
                let axes = drawing.model.joint(joint).kind.axes()?;
                axes.into_iter().filter(of_link).find_map(|axis| drawing.path(axis))
            }
            _ => None,
        }
    }

    fn free_path(&self, link: &str, word: &str) -> String {
        let is_taken = |path: &String| {
            let is_new = |command: &Command| matches!(command, Command::Axis { path: known, .. } if known == path);
            let is_old = self.drawing.is_some_and(|drawing| drawing.axis(path).is_some());
            is_old || self.commands.iter().any(is_new)
        };
        let paths = (1..).map(|number: u32| format!("{link}.{word}{number}"));
        paths.into_iter().find(|path| !is_taken(path)).unwrap_or_default()
    }

    pub(super) fn name(&self, end: &End) -> String {
        match (end, self.drawing) {
            (End::New(name), _) => name.clone(),
            (End::Link(link), Some(drawing)) => drawing.model.link(*link).name.clone(),
            (End::Link(_), None) => "ground".to_owned(),
        }
    }

    /// Whether the coordinates of an end are those of the scene, so that a joint can be placed in the drawing.
    fn is_in_scene(&self, end: &End) -> bool {
        match (end, self.drawing) {
            (End::Link(link), Some(drawing)) => drawing.is_in_scene(*link),
            _ => true,
        }
    }

    /// Joins two links where one was picked.
    pub(super) fn join(
        &mut self,
        ends: [&End; 2],
        pick: &Pick,
        form: JointForm,
        along: Option<String>,
    ) {
        let name = self.names.joint();
        let is_drawn = ends.iter().all(|end| self.is_in_scene(end));
        let assembly = if is_drawn {
            self.replace_loose_point(ends, pick);
            Assembly {
                name,
                kind: form,
                ends: ends.map(|end| self.name(end)),
                at: Some(pick.place.map(written)),
                along,
            }
        } else {
            Assembly {
                name,
                kind: form,
                ends: ends.map(|end| self.axis_of(end, pick, along.as_deref())),
                at: None,
                along: None,
            }
        };
        self.add(Command::Join(assembly));
    }

    /// The axis of an end where the joint is to be.
    fn axis_of(&mut self, end: &End, pick: &Pick, along: Option<&str>) -> String {
        match (end, along) {
            (End::Link(link), None) => self.point_at(pick, *link),
            (End::New(_), None) => self.point(end, pick.place, "p"),
            (_, Some(along)) => {
                let path = self.free_path(&self.name(end), "line");
                let along = match (end, self.drawing) {
                    (End::Link(link), Some(drawing)) => turned(along, drawing.pose(*link)),
                    _ => along.to_owned(),
                };
                let at = self.pair(end, pick.place);
                self.add(Command::Axis { path: path.clone(), at, along: Some(along) });
                path
            }
        }
    }

    /// A loose point is not needed any more where a joint comes that has a place of its own.
    fn replace_loose_point(&mut self, ends: [&End; 2], pick: &Pick) {
        let (Hit::Axis(axis), Some(drawing)) = (&pick.hit, self.drawing) else {
            return;
        };
        let link = drawing.model.axis(*axis).link;
        let is_of_end = ends.iter().any(|end| matches!(end, End::Link(one) if *one == link));
        let is_there = distance(drawing.place(*axis), pick.place) < 1e-9;
        let is_needed = drawing.model.traces.iter().any(|trace| trace.point == *axis);
        if let Some(path) = drawing.path(*axis).filter(|_| is_of_end && is_there && !is_needed) {
            self.replaced.push(path);
        }
    }

    /// The wheel at a place: a link that turns there.
    pub(super) fn wheel_at(&self, pick: &Pick) -> Result<(LinkId, [f64; 2]), String> {
        let drawing = self.drawing()?;
        let link = self.moving_link_at(pick)?;
        let is_pivot = matches!(pick.hit, Hit::Joint(joint) if drawing.model.turns(joint));
        let center = if is_pivot { Some(pick.place) } else { drawing.pivot(link) };
        let center = center.ok_or_else(|| {
            format!("link `{}` turns about nothing; pin it first", drawing.model.link(link).name)
        })?;
        Ok((link, center))
    }
}

/// A number as it is written, without digits that nobody needs.
pub(super) fn written(value: f64) -> String {
    shortest(value, 1e-9 * value.abs().max(1e-3))
}

/// A direction of the scene, `30 deg`, in the frame of a pose.
fn turned(along: &str, Pose { cos, sin, .. }: Pose) -> String {
    let degrees = along.strip_suffix(" deg").and_then(|text| text.parse::<f64>().ok());
    let turned = degrees.map(|degrees| degrees - sin.atan2(cos).to_degrees());
    turned.map_or_else(|| along.to_owned(), |degrees| format!("{} deg", written(degrees)))
}
