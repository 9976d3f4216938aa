//! Plots: the quantities that the user wants to see, and the last measurement.

use super::curves::Curves;
use super::playing::Playing;
use super::range::MotorRange;
use super::selection::Selection;
use super::settings::{Settings, Visible};
use super::snapshot::Snapshot;
use super::worker::{Task, Undone, Use};
use crate::construction::{Centrodes, Rolling};
use crate::job::Measure;
use crate::motion::Setting;
use crate::play::Player;
use crate::quantity::Load;
use mech_compiler::model::LoadKind;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The plotted quantities, and the last measurement.
#[derive(Default)]
pub(super) struct Plotted {
    /// The quantities, as `mech plot` calls them.
    pub(super) names: Vec<String>,
    /// The quantity over which they are shown, if not over the motor.
    pub(super) over: Option<String>,
    /// The motor that moves through its range; without, the first.
    pub(super) motor: Option<String>,
    /// The text that was typed for each load, by the load's name.
    pub(super) loads: BTreeMap<String, String>,
    is_asked: bool,
    pub(super) curves: Option<Curves>,
    /// The centrodes that were asked for last.
    rolled: Option<Rolled>,
}

/// Centrodes of a mechanism, by the number of their task.
struct Rolled {
    number: u64,
    snapshot: Arc<Snapshot>,
    wanted: Rolling,
    /// Empty until they are known.
    found: Vec<Centrodes>,
}

impl Plotted {
    /// Plots quantities too, as `mech plot` calls them.
    pub(super) fn plot(&mut self, names: &str) {
        for name in names.split_whitespace().map(ToOwned::to_owned) {
            if !self.names.contains(&name) {
                self.names.push(name);
            }
        }
    }

    /// The motor that moves through its range, by its number and its name.
    pub(super) fn motor_of<'r>(&self, ranges: &'r [MotorRange]) -> Option<(usize, &'r str)> {
        let names = ranges.iter().map(|range| range.name.as_str()).enumerate();
        let chosen = self.motor.as_deref();
        let mut all = names.clone();
        all.find(|(_, name)| Some(*name) == chosen).or_else(|| names.into_iter().next())
    }

    /// The loads that somebody has given numbers, as far as these can be read. The others are zero.
    pub(super) fn loads(&self, snapshot: &Snapshot) -> Vec<Load> {
        let declared = snapshot.reading.iter();
        let declared = declared.flat_map(|reading| &reading.model.actions.loads);
        let given = declared.filter_map(|load| {
            let typed = self.loads.get(&load.name)?;
            read_load(&load.name, load.kind, typed).ok().flatten()
        });
        given.collect()
    }

    /// Returns the quantities to measure so that the plots fit the mechanism that is seen.
    fn wanted(&self, playing: &Playing, snapshot: &Snapshot) -> Option<Measure> {
        let mechanism = playing.player.as_ref()?.mechanism();
        let (_, motor) = self.motor_of(&playing.ranges)?;
        let others = mechanism.shown_motors().into_iter();
        let others = others.filter(|(name, _)| name != motor);
        Some(Measure {
            quantities: self.names.clone(),
            over: self.over.clone(),
            motor: Some(motor.to_owned()),
            at: others.map(Setting::from).collect(),
            loads: self.loads(snapshot),
            ..Measure::default()
        })
    }

    /// Measures the plots anew, if they do not fit any more. While several motors play, they wait.
    pub(super) fn renew(&mut self, playing: &Playing, snapshot: &Arc<Snapshot>) -> Option<Task> {
        let wanted = self.wanted(playing, snapshot)?;
        let plays = playing.player.as_ref().is_some_and(Player::plays);
        let waits = plays && !wanted.at.is_empty() && self.curves.is_some();
        let is_idle = wanted.quantities.is_empty() || waits || self.is_asked;
        if is_idle || self.fits(&wanted, snapshot) || !playing.is_of(snapshot) {
            return None;
        }
        self.is_asked = true;
        Some(Task::Of(snapshot.clone(), Use::Measure(Box::new(wanted))))
    }

    /// Whether the last measurement fits the mechanism that is seen.
    pub(super) fn is_present(&self, playing: &Playing, snapshot: &Arc<Snapshot>) -> bool {
        let wanted = self.wanted(playing, snapshot);
        wanted.is_some_and(|wanted| self.fits(&wanted, snapshot))
    }

    fn fits(&self, wanted: &Measure, snapshot: &Arc<Snapshot>) -> bool {
        let curves = self.curves.as_ref();
        curves.is_some_and(|curves| {
            let known = &curves.wanted;
            Arc::ptr_eq(&curves.snapshot, snapshot)
                && (&known.quantities, &known.over, &known.motor)
                    == (&wanted.quantities, &wanted.over, &wanted.motor)
                && (&known.at, &known.loads) == (&wanted.at, &wanted.loads)
        })
    }

    /// Takes over what was measured.
    pub(super) fn take(&mut self, curves: Curves) {
        self.is_asked = false;
        self.curves = Some(curves);
    }

    /// Waits no more for what was not measured.
    pub(super) fn take_undone(&mut self, undone: Undone) {
        if let Undone::Measure | Undone::All = undone {
            self.is_asked = false;
        }
    }

    /// Asks for the centrodes of the selected links, if they are shown and others than before. While something plays, others wait.
    pub(super) fn roll(
        &mut self,
        playing: &Playing,
        (snapshot, settings, selection): (&Arc<Snapshot>, &Settings, &Selection),
        number: impl FnOnce() -> u64,
    ) -> Option<Task> {
        let player = playing.player.as_ref().filter(|player| !player.plays())?;
        let (_, motor) = self.motor_of(&playing.ranges)?;
        let others = player.mechanism().shown_motors().into_iter();
        let others = others.filter(|(name, _)| name != motor);
        let wanted = Rolling {
            links: selection.links().collect(),
            motor: motor.to_owned(),
            others: others.map(Setting::from).collect(),
            extent: player.mechanism().bounds(),
        };
        let is_wanted = settings.shows(Visible::Centrodes) && !wanted.links.is_empty();
        let is_known = self
            .rolled
            .as_ref()
            .is_some_and(|known| Arc::ptr_eq(&known.snapshot, snapshot) && known.wanted == wanted);
        if !is_wanted || is_known || !playing.is_of(snapshot) {
            return None;
        }
        let number = number();
        self.rolled = Some(Rolled {
            number,
            snapshot: snapshot.clone(),
            wanted: wanted.clone(),
            found: Vec::new(),
        });
        Some(Task::Of(snapshot.clone(), Use::Roll(number, Box::new(wanted))))
    }

    /// Takes over centrodes, if nobody has asked for others since.
    pub(super) fn take_centrodes(&mut self, number: u64, found: Vec<Centrodes>) {
        let asked = self.rolled.as_mut();
        if let Some(asked) = asked.filter(|asked| asked.number == number) {
            asked.found = found;
        }
    }

    /// The centrodes of the selected links, if they are shown and known.
    pub(super) fn centrodes(
        &self,
        snapshot: &Arc<Snapshot>,
        settings: &Settings,
        selection: &Selection,
    ) -> &[Centrodes] {
        let known = self.rolled.as_ref().filter(|known| {
            settings.shows(Visible::Centrodes)
                && Arc::ptr_eq(&known.snapshot, snapshot)
                && known.wanted.links.iter().cloned().eq(selection.links())
        });
        known.map_or(&[], |known| &known.found)
    }

    /// Returns the plotted quantities as a measurement for a file.
    pub(super) fn measure(&self, playing: &Playing, snapshot: &Snapshot) -> Measure {
        let wanted = self.wanted(playing, snapshot);
        let wanted = wanted.filter(|wanted| !wanted.quantities.is_empty());
        wanted.unwrap_or_else(|| Measure { quantities: self.names.clone(), ..Measure::default() })
    }
}

/// Reads the numbers that were typed for a load; nothing for zero.
pub(super) fn read_load(name: &str, kind: LoadKind, typed: &str) -> Result<Option<Load>, String> {
    if typed.trim().is_empty() {
        return Ok(None);
    }
    let count = typed.split(',').count();
    match (kind, count) {
        (LoadKind::Force(_), 2) | (LoadKind::Torque(_), 1) => {
            format!("{name}={typed}").parse().map(Some)
        }
        (LoadKind::Force(_), _) => Err("a force has two parts: `x, y`".to_owned()),
        (LoadKind::Torque(_), _) => Err("a torque is one number".to_owned()),
    }
}
