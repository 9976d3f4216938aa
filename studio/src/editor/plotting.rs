//! What the window plots: quantities are chosen, measured beside it, and shown.

use super::Editor;
use super::curves::{Curves, Wanted};
use super::plotted::read_load;
use super::worker::Task;
use crate::quantity::{self, Load, Offer};
use std::sync::Arc;

impl Editor {
    /// Plots a quantity too, as `mech plot` calls it.
    pub(super) fn plot(&mut self, name: &str) {
        let names = name.split_whitespace().map(ToOwned::to_owned);
        for name in names {
            if !self.plotted.names.contains(&name) {
                self.plotted.names.push(name);
            }
        }
    }

    /// Everything that can be measured of the mechanism that moves.
    pub(super) fn offers(&self) -> Vec<Offer> {
        let (Some(reading), Some(compiled)) = (&self.snapshot.reading, self.snapshot.compiled())
        else {
            return Vec::new();
        };
        let dyads = quantity::dyads(&reading.model, &compiled.plan);
        quantity::offers(&reading.model, &dyads)
    }

    /// The motor that moves through its range in plots, by its number and its name.
    pub(super) fn plotted_motor(&self) -> Option<(usize, &str)> {
        let names = || {
            self.scene
                .playing
                .ranges
                .iter()
                .map(|range| range.name.as_str())
                .enumerate()
        };
        let chosen = self.plotted.motor.as_deref();
        names()
            .find(|(_, name)| Some(*name) == chosen)
            .or_else(|| names().next())
    }

    /// The loads that somebody has given numbers, as far as these can be read. The others are zero.
    pub(super) fn loads(&self) -> Vec<Load> {
        let declared = self.snapshot.reading.iter();
        let declared = declared.flat_map(|reading| &reading.model.actions.loads);
        let given = declared.filter_map(|load| {
            let typed = self.plotted.loads.get(&load.name)?;
            read_load(&load.name, load.kind, typed).ok().flatten()
        });
        given.collect()
    }

    /// What has to be measured so that the plots fit what is seen.
    pub(super) fn wanted_curves(&self) -> Option<Wanted> {
        let mechanism = self.scene.player()?.mechanism();
        let (_, motor) = self.plotted_motor()?;
        let others = mechanism
            .shown_motors()
            .into_iter()
            .filter(|(name, _)| name != motor);
        Some(Wanted {
            names: self.plotted.names.clone(),
            over: self.plotted.over.clone(),
            motor: Some(motor.to_owned()),
            others: others.collect(),
            loads: self.loads(),
        })
    }

    /// Lets the plots be measured anew, if they do not fit any more. While several motors play, they wait.
    pub(super) fn renew_curves(&mut self) {
        let Some(wanted) = self
            .wanted_curves()
            .filter(|wanted| !wanted.names.is_empty())
        else {
            return;
        };
        let is_known = self
            .plotted
            .curves
            .as_ref()
            .is_some_and(|known| self.fit_curves(known, &wanted));
        let plays = self.scene.player().is_some_and(crate::play::Player::plays);
        let waits = plays && !wanted.others.is_empty() && self.plotted.curves.is_some();
        if is_known
            || waits
            || self.plotted.asked.is_some()
            || !self.scene.playing.is_of(&self.snapshot)
        {
            return;
        }
        let snapshot = self.snapshot.clone();
        self.plotted.asked = Some((snapshot.clone(), wanted.clone()));
        self.give(Task::Measure { snapshot, wanted });
    }

    fn fit_curves(&self, curves: &Curves, wanted: &Wanted) -> bool {
        Arc::ptr_eq(&curves.snapshot, &self.snapshot) && curves.wanted == *wanted
    }

    /// Takes over what was measured.
    pub(super) fn take_curves(&mut self, curves: Curves) {
        self.plotted.asked = None;
        self.plotted.curves = Some(curves);
    }

    /// Whether what was measured last is of what is seen.
    pub(super) fn are_curves_present(&self) -> bool {
        let curves = self.plotted.curves.as_ref();
        let wanted = self.wanted_curves();
        curves
            .zip(wanted)
            .is_some_and(|(curves, wanted)| self.fit_curves(curves, &wanted))
    }
}
