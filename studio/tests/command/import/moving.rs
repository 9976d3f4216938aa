//! Imported mechanisms, moved by the interpreter.

use mech_compiler::Compiled;
use mech_compiler::evaluate::Machine;
use mech_compiler::model::{LinkId, Model};
use mech_studio::{Document, Reading, Source};

pub(super) type Place = [f64; 2];

pub(super) struct Moving {
    model: Model,
    compiled: Box<Compiled>,
}

/// Two pins of one link, each with another link that has it: `("crank", [8.0, 14.0])`.
pub(super) type Bar<'b> = [(&'b str, Place); 2];

/// Analyses the text of a mechanism.
pub(super) fn reading(text: &str) -> Reading {
    let document = Document::of(Source::new("imported.mech", text));
    let declaration = document.choose(None).expect("a mechanism");
    document.analyse(declaration).expect("an analysis")
}

/// Where a joint or a named point was declared.
pub(super) fn place_of(model: &Model, name: &str) -> Option<Place> {
    if let Some((link, point)) = name.split_once('.') {
        let axes = model.axes.iter();
        let mut axes = axes.filter(|axis| axis.name.as_deref() == Some(point));
        let axis = axes.find(|axis| model.link(axis.link).name == link)?;
        return Some(axis.at);
    }
    let joint = model.joints.iter().find(|joint| joint.name == name)?;
    Some(model.axis(joint.kind.axes()?[0]).at)
}

impl Moving {
    #[track_caller]
    pub(super) fn of(text: &str) -> Self {
        let Reading { model, result, .. } = reading(text);
        match result {
            Ok(compiled) => Self { model, compiled },
            Err(faults) => panic!("{:?}\n{text}", faults.messages),
        }
    }

    /// At the start, joints and points are where the original has them.
    #[track_caller]
    pub(super) fn stands(&self, places: &[(&str, Place)]) {
        let machine = Machine::<f64>::new(&self.compiled.program);
        for pose in &machine.position().poses {
            // The frames are that of the scene.
            let off = [pose[0] - 1.0, pose[1], pose[2], pose[3]];
            assert!(off.iter().all(|part| part.abs() < 1e-9), "{pose:?}");
        }
        for (name, at) in places {
            let found = place_of(&self.model, name);
            let found = found.unwrap_or_else(|| panic!("there is no `{name}`"));
            assert!(distance(found, *at) < 1e-6, "{name}: {found:?}, not {at:?}");
        }
    }

    /// Through these values of its motor, no bar changes its length. Gives how far the last end of the last bar came.
    #[track_caller]
    pub(super) fn keeps(&self, values: impl IntoIterator<Item = f64>, bars: &[Bar<'_>]) -> f64 {
        let mut machine = Machine::<f64>::new(&self.compiled.program);
        let mut farthest = 0.0_f64;
        for value in values {
            let moved = machine.move_to(&[value]);
            moved.unwrap_or_else(|stop| panic!("at {value}: {stop:?}"));
            for bar in bars {
                let [a, b] = bar.map(|(link, at)| self.place(&machine, link, at));
                let [c, d] = bar.map(|(_, at)| at);
                let change = distance(a, b) - distance(c, d);
                assert!(change.abs() < 1e-6, "at {value}: {bar:?} by {change}");
            }
            if let Some([_, (link, at)]) = bars.last() {
                farthest = farthest.max(distance(self.place(&machine, link, *at), *at));
            }
        }
        farthest
    }

    /// Where what was here at the start has come with a link.
    pub(super) fn place_at(&self, value: f64, link: &str, at: Place) -> Place {
        let mut machine = Machine::<f64>::new(&self.compiled.program);
        machine.move_to(&[value]).expect("it goes there");
        self.place(&machine, link, at)
    }

    fn place(&self, machine: &Machine<'_, f64>, link: &str, [x, y]: Place) -> Place {
        let number = self.model.links.iter().position(|one| one.name == link);
        let number = number.unwrap_or_else(|| panic!("there is no link `{link}`"));
        let place = self.compiled.program.place_of(LinkId::new(number));
        let Some(place) = place else {
            assert_eq!(link, "ground");
            return [x, y];
        };
        let [cos, sin, dx, dy] = machine.position().poses[place];
        [cos * x - sin * y + dx, sin * x + cos * y + dy]
    }
}

pub(super) fn distance(a: Place, b: Place) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// A whole turn, in so many steps.
pub(super) fn turn(steps: u32) -> impl Iterator<Item = f64> {
    (0..=steps).map(move |step| f64::from(step) / f64::from(steps) * std::f64::consts::TAU)
}
