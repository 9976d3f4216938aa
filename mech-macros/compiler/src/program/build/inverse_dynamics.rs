//! Inverse dynamics: the equilibrium of each link, inertia included (d'Alembert), for the reactions in all joints and the torques of all
//! motors.

use super::Positions;
use super::equilibrium::{EquationSet, choose_balances};
use super::lowering::Lowering;
use super::rates::LoopRates;
use super::reaction::{Along, Part, Place, Push, Unknown};
use super::tangent::Seed;
use super::wrench::Wrench;
use crate::bug::bug;
use crate::model::{AxisId, AxisKind, JointId, JointKind, LinkId};
use crate::plan::{Algebra, Arithmetic};
use crate::program::node::{Op, Value};
use crate::program::{InverseDynamics, LinearEquations};
use crate::structure::Structure;
use std::collections::BTreeSet;

/// Moments are taken about one of so many points of a link; a shaft may have a thousand.
const POINTS: usize = 50;

/// The unknowns, by their numbers, and the known forces and torques that act on a link.
#[derive(Clone, Default)]
struct Acting<'a> {
    unknowns: Vec<(usize, &'a Unknown)>,
    wrenches: Vec<&'a Wrench>,
}

impl<'a> Acting<'a> {
    /// What acts on each link.
    fn on_all(links: usize, unknowns: &'a [Unknown], wrenches: &'a [Wrench]) -> Vec<Self> {
        let mut all = vec![Self::default(); links];
        for (number, unknown) in unknowns.iter().enumerate() {
            let links: BTreeSet<LinkId> = unknown.pushes.iter().map(Push::link).collect();
            for link in links {
                all[link.index()].unknowns.push((number, unknown));
            }
        }
        for wrench in wrenches {
            all[wrench.link().index()].wrenches.push(wrench);
        }
        all
    }
}

/// The form of a link's equations: about which point moments are taken, and along which directions forces are summed.
#[derive(Clone, Copy, Debug)]
struct Balance {
    /// An axis of the link, or else its origin.
    about: Option<AxisId>,
    along: Option<JointId>,
}

/// The three equations of a link: for each unknown what it adds, and the known part.
struct Rows {
    unknown: [Vec<(usize, Value)>; 3],
    known: [Value; 3],
}

impl Lowering<'_> {
    /// The torques, forces and reactions that a given motion takes; none where equilibrium does not determine them.
    pub(super) fn derive_inverse_dynamics(
        &mut self,
        positions: &Positions,
        structure: &Structure,
        equations: &mut LinearEquations,
    ) -> Option<InverseDynamics<Value>> {
        let mut influence_coefficients = self.influence_coefficients(positions, equations);
        let (mut given, rates) = self.all_rates(positions, Seed::Given, equations);
        self.add_second_rates(positions, &rates, &mut given, equations);
        self.ssa.block("forces".to_owned(), "What acts.".to_owned());
        let bodies = self.bodies();
        let mut wrenches = self.wrenches(&bodies);
        wrenches.extend(self.resistances(&mut given));
        for body in &bodies {
            wrenches.extend(self.inertial_wrenches(body, &mut given));
        }
        self.ssa.block("equilibrium".to_owned(), "The equilibrium of each link.".to_owned());
        let unknowns = self.unknown_reactions(positions, structure);
        let found = self.equilibrium(&unknowns, &wrenches, equations)?;
        let velocity_ratios = influence_coefficients
            .iter_mut()
            .map(|tangents| self.velocity_ratios(tangents))
            .collect();
        Some(InverseDynamics {
            torques: self.drives(&unknowns, &found),
            reactions: self.reactions(&unknowns, &found),
            velocity_ratios,
            transmission: self.transmission(&rates),
        })
    }

    /// The unknowns of the equilibrium of all links; none where it does not determine them, as in a loop of slides alone, which hold
    /// each link's direction more than once.
    fn equilibrium(
        &mut self,
        unknowns: &[Unknown],
        wrenches: &[Wrench],
        equations: &mut LinearEquations,
    ) -> Option<Vec<Value>> {
        let links: Vec<LinkId> = self.model.moving_links().collect();
        let mut alternatives: Vec<Vec<Rows>> = Vec::new();
        let acting = Acting::on_all(self.model.links.len(), unknowns, wrenches);
        for &link in &links {
            let balances = self.balances(link);
            let rows =
                balances.into_iter().map(|balance| self.rows(link, balance, &acting[link.index()]));
            alternatives.push(rows.collect());
        }
        let pattern: Vec<Vec<[Vec<usize>; 3]>> = alternatives
            .iter()
            .map(|balances| balances.iter().map(Rows::pattern).collect())
            .collect();
        let (choices, blocks) = choose_balances(&pattern, unknowns.len())?;
        let rows: Vec<(&Vec<(usize, Value)>, Value)> = alternatives
            .iter()
            .zip(choices)
            .flat_map(|(balances, choice)| {
                let Rows { unknown, known } = &balances[choice];
                unknown.iter().zip(known.iter().copied())
            })
            .collect();
        let mut found: Vec<Option<Value>> = vec![None; unknowns.len()];
        for block in &blocks {
            let values = self.solve_block(block, &rows, &found, equations);
            for (&unknown, value) in block.unknowns.iter().zip(values) {
                self.ssa.name(value, unknowns[unknown].name.clone());
                found[unknown] = Some(value);
            }
        }
        let found = found.into_iter().map(|value| {
            value.unwrap_or_else(|| bug!("an unknown of the equilibrium is in none of its systems"))
        });
        Some(found.collect())
    }

    /// Solves a few equations, with the unknowns that others have found.
    fn solve_block(
        &mut self,
        block: &EquationSet,
        rows: &[(&Vec<(usize, Value)>, Value)],
        found: &[Option<Value>],
        equations: &mut LinearEquations,
    ) -> Vec<Value> {
        let zero = self.ssa.constant(0.0);
        let mut columns = vec![vec![zero; block.equations.len()]; block.unknowns.len()];
        let mut right = Vec::new();
        for (row, &equation) in block.equations.iter().enumerate() {
            let (parts, known) = rows[equation];
            let mut sum = known;
            for &(unknown, factor) in parts {
                if let Some(column) = block.unknowns.iter().position(|&other| other == unknown) {
                    columns[column][row] = factor;
                } else {
                    let Some(value) = found[unknown] else {
                        bug!("an equilibrium needs an unknown that is found after it");
                    };
                    let share = self.ssa.mul(factor, value);
                    sum = self.ssa.add(sum, share);
                }
            }
            right.push(sum);
        }
        match (&columns[..], &right[..]) {
            ([column], &[sum]) => {
                let sum = self.ssa.neg(sum);
                vec![self.ssa.div(sum, column[0])]
            }
            _ if columns.len() <= 3 => {
                let block = self.ssa.current();
                self.ssa.solve_linear(block, &columns, &right).0
            }
            _ => self.solve_dense(&columns, &right, equations).0,
        }
    }

    /// The balances that a link's equations can be written for.
    fn balances(&self, link: LinkId) -> Vec<Balance> {
        let mut points: Vec<AxisId> = Vec::new();
        let place = |axis: AxisId| {
            let axis = self.model.axis(axis);
            (axis.at, axis.formulas)
        };
        let mut slides: Vec<Option<JointId>> = vec![None];
        for joint in self.model.joint_ids() {
            let (a, b) = self.model.ends(joint);
            if a != link && b != link {
                continue;
            }
            let own = |axis: AxisId| Some(axis).filter(|&axis| self.link_of(axis) == link);
            match self.model.joint(joint).kind {
                JointKind::Revolute(a, b) | JointKind::Weld(a, b) => {
                    let at = own(a).or(own(b));
                    let is_known = |at: AxisId| points.iter().any(|&one| place(one) == place(at));
                    let is_new = |at: &AxisId| points.len() < POINTS && !is_known(*at);
                    points.extend(at.filter(is_new));
                }
                JointKind::Prismatic(..) => slides.push(Some(joint)),
                _ => {}
            }
        }
        let mut points: Vec<Option<AxisId>> = points.into_iter().map(Some).collect();
        if points.is_empty() {
            let mut axes = (0..self.model.axes.len()).map(AxisId::new);
            let is_line = |&axis: &AxisId| {
                self.link_of(axis) == link && self.model.axis(axis).kind == AxisKind::Line
            };
            // Moments are taken about any point: on a line they are simple, and there may be none.
            points.push(axes.find(is_line));
        }
        let balances = slides
            .into_iter()
            .flat_map(|along| points.iter().map(move |&about| Balance { about, along }));
        balances.collect()
    }

    /// The equations of a link for one balance.
    fn rows(&mut self, link: LinkId, balance: Balance, acting: &Acting<'_>) -> Rows {
        let zero = self.ssa.constant(0.0);
        let mut rows = Rows { unknown: Default::default(), known: [zero; 3] };
        for &(number, unknown) in &acting.unknowns {
            let mut sums = [zero; 3];
            for push in &unknown.pushes {
                let parts = match *push {
                    Push::Force { link: pushed, at, along, size } if pushed == link => {
                        let parts = self.force_terms(link, balance, at, along);
                        parts.map(|part| self.ssa.mul(size, part))
                    }
                    Push::Torque { link: pushed, size } if pushed == link => [zero, zero, size],
                    _ => continue,
                };
                self.ssa.add_to(&mut sums, parts);
            }
            for (row, sum) in rows.unknown.iter_mut().zip(sums) {
                if sum != zero {
                    row.push((number, sum));
                }
            }
        }
        for &wrench in &acting.wrenches {
            let parts = match *wrench {
                Wrench::Force { link: pushed, at, force } if pushed == link => {
                    let arm = self.arm(link, balance, Place::Scene(at));
                    let [along, across] = self.resolve(balance, force);
                    [along, across, self.ssa.cross(arm, force)]
                }
                Wrench::Torque { link: pushed, torque } if pushed == link => [zero, zero, torque],
                _ => continue,
            };
            self.ssa.add_to(&mut rows.known, parts);
        }
        rows
    }

    /// The terms that a force of size one adds to the equations of a link.
    fn force_terms(
        &mut self,
        link: LinkId,
        balance: Balance,
        at: Place,
        along: Along,
    ) -> [Value; 3] {
        let (zero, one) = (self.ssa.constant(0.0), self.ssa.constant(1.0));
        let direction = self.direction(along);
        let arm = self.arm(link, balance, at);
        let moment = self.ssa.cross(arm, direction);
        let [p, q] = match (along, balance.along) {
            (Along::Slide(joint), Some(own)) if joint == own => [one, zero],
            (Along::Across(joint), Some(own)) if joint == own => [zero, one],
            _ => self.resolve(balance, direction),
        };
        [p, q, moment]
    }

    /// A direction in the scene.
    pub(super) fn direction(&mut self, along: Along) -> [Value; 2] {
        match along {
            Along::Scene(direction) => direction,
            Along::Slide(joint) => self.slide(joint),
            Along::Across(joint) => {
                let [x, y] = self.slide(joint);
                [self.ssa.neg(y), x]
            }
        }
    }

    /// The direction of a slide in the scene.
    fn slide(&mut self, joint: JointId) -> [Value; 2] {
        let JointKind::Prismatic(a, _) = self.model.joint(joint).kind else {
            return self.ssa.vector([1.0, 0.0]);
        };
        let axis = self.model.axis(a);
        let pose = self.placement.pose(axis.link);
        pose.heading(&mut self.ssa, axis)
    }

    /// A force, resolved along and across the direction in which the forces of a link are summed.
    fn resolve(&mut self, balance: Balance, force: [Value; 2]) -> [Value; 2] {
        match balance.along {
            None => force,
            Some(joint) => {
                let along = self.slide(joint);
                [self.ssa.dot(along, force), self.ssa.cross(along, force)]
            }
        }
    }

    /// From the point about which moments are taken to another.
    fn arm(&mut self, link: LinkId, balance: Balance, at: Place) -> [Value; 2] {
        let pose = self.placement.pose(link);
        match at {
            Place::Own(axis) => {
                let axis = self.model.axis(axis);
                let arm = match balance.about {
                    Some(about) => self.ssa.between(self.model.axis(about), axis),
                    None => self.ssa.place(axis),
                };
                self.ssa.rotate(pose.direction, arm)
            }
            Place::Scene(at) => {
                let about = match balance.about {
                    Some(about) => pose.carry(&mut self.ssa, self.model.axis(about)),
                    None => pose.origin,
                };
                self.ssa.minus(at, about)
            }
        }
    }

    /// The torques and forces of the motors.
    fn drives(&self, unknowns: &[Unknown], found: &[Value]) -> Vec<Value> {
        let drive = |motor| {
            let mut unknowns = unknowns.iter().zip(found);
            let own = unknowns.find(|(unknown, _)| self.is_drive(unknown, motor));
            own.map(|(_, &value)| value)
        };
        self.model.motor_ids().filter_map(drive).collect()
    }

    /// The reactions in all declared joints.
    fn reactions(&mut self, unknowns: &[Unknown], found: &[Value]) -> Vec<[Value; 3]> {
        let zero = self.ssa.constant(0.0);
        let mut reactions = Vec::new();
        for joint in self.model.declared_joints() {
            let mut sums = [zero; 3];
            for (unknown, &size) in unknowns.iter().zip(found) {
                if unknown.joint != joint {
                    continue;
                }
                let parts = match unknown.part {
                    Part::Torque => [zero, zero, size],
                    Part::Force(along) => {
                        let direction = self.direction(along);
                        let [x, y] = self.ssa.scale(size, direction);
                        [x, y, zero]
                    }
                };
                self.ssa.add_to(&mut sums, parts);
            }
            reactions.push(sums);
        }
        reactions
    }

    /// The transmission angles of dyads: between the directions in which the two unknowns of each move its closure.
    fn transmission(&mut self, rates: &[LoopRates]) -> Vec<Value> {
        let mut angles = Vec::new();
        for rates in rates {
            let [a, b] = &rates.columns[..] else {
                continue;
            };
            let (&[p, q], &[r, s]) = (&a[..], &b[..]) else {
                continue;
            };
            let (across, along) = (self.ssa.cross([p, q], [r, s]), self.ssa.dot([p, q], [r, s]));
            let (across, along) = (self.ssa.abs(across), self.ssa.abs(along));
            angles.push(self.ssa.make(Op::Atan2(across, along)));
        }
        angles
    }
}

impl Rows {
    /// The unknowns that each equation contains.
    fn pattern(&self) -> [Vec<usize>; 3] {
        self.unknown.each_ref().map(|row| row.iter().map(|&(unknown, _)| unknown).collect())
    }
}
