//! What the struct of a mechanism has more if forces were asked for.

use super::added::Added;
use super::block::scalar;
use super::costs::literal;
use super::items::{pose, user_ident};
use super::motion::{found, given, suffix};
use super::scope::number;
use super::step::{step, takes_sines};
use crate::Forced;
use crate::cost;
use crate::model::{Between, JointKind, Load, LoadKind, Model};
use crate::program::Program;
use crate::syntax::Places;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

/// What there is to write it with.
struct Writer<'w> {
    places: &'w Places,
    model: &'w Model,
    program: &'w Program,
    visibility: &'w syn::Visibility,
    scalar: TokenStream,
    motors: Literal,
    has_loads: bool,
    /// What a move without rates leaves behind.
    rest: TokenStream,
    /// What every move ends with.
    record: &'w TokenStream,
}

/// What forces add to a mechanism. `rest` is what velocities leave behind when it is held.
pub(super) fn added(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    (program, forced): (&Program, &Forced),
    visibility: &syn::Visibility,
    (rest, record): (&TokenStream, &TokenStream),
) -> Added {
    if !model.effects.needs_actions() {
        return Added::default();
    }
    let motors = Literal::usize_unsuffixed(program.motors.len());
    let unmoved = if model.effects.dynamics {
        quote!(self.rates = [0.0; #motors];)
    } else {
        TokenStream::new()
    };
    let loads = model.actions.load_names().len();
    let writer = Writer {
        places,
        model,
        program,
        visibility,
        scalar: scalar(program),
        motors,
        has_loads: loads > 0,
        rest: quote!(#rest #unmoved #record),
        record,
    };
    let mut items = Added {
        imports: imports(krate, model),
        ..Added::default()
    };
    let Writer { scalar, motors, .. } = &writer;
    if loads > 0 {
        let count = Literal::usize_unsuffixed(loads);
        items.fields = quote!(loads: [::core::primitive::#scalar; #count],);
        items.at_rest = quote!(loads: [0.0; #count],);
        items.methods.extend(writer.loads());
    }
    items.methods.extend(writer.springs());
    if let Some(holding) = &forced.holding {
        items.methods.extend(writer.holding(holding));
        items.methods.extend(writer.cost(
            krate,
            holding,
            "TORQUES_COST",
            "the torques that hold it",
        ));
        items.steps.extend(step(holding));
    }
    if let Some(acting) = &forced.acting {
        items.methods.extend(writer.acting(acting));
        items
            .methods
            .extend(writer.cost(krate, acting, "FORCES_COST", "all forces in it"));
        items.steps.extend(step(acting));
    }
    if let Some(inertia) = &forced.inertia {
        items
            .fields
            .extend(quote!(rates: [::core::primitive::#scalar; #motors],));
        items.at_rest.extend(quote!(rates: [0.0; #motors],));
        items.rest = unmoved;
        items
            .instance_rest
            .extend(quote!(instance.rates = [0.0; #motors];));
        items.methods.extend(writer.dynamics(inertia));
        items.methods.extend(writer.cost(
            krate,
            inertia,
            "INERTIA_COST",
            "its inertia and what drives it",
        ));
        items.steps.extend(step(inertia));
    }
    items
}

/// What they use, besides what velocities import already.
fn imports(krate: &TokenStream, model: &Model) -> TokenStream {
    let shared = if model.effects.velocity {
        TokenStream::new()
    } else {
        quote!(advance_with, determined, finite, rates_at,)
    };
    quote! {
        #[allow(unused_imports, reason = "which of them a mechanism needs depends on its effects")]
        use #krate::generated::{Forces, Gauss, Holding, Inertia, Moment, Reaction, not_finite, pull, simulate, #shared};
    }
}

impl Writer<'_> {
    /// The functions of a program for motor values within reach, and for any.
    fn steps(&self, program: &Program) -> [Ident; 2] {
        let suffix = suffix(program);
        let near = if takes_sines(self.program) && takes_sines(program) {
            "near"
        } else {
            "step"
        };
        [near, "step"].map(|name| format_ident!("{}{}", name, suffix))
    }

    /// The present loads as a variable, where a step takes them.
    fn given_loads(&self) -> TokenStream {
        if self.has_loads {
            quote!(let loads = self.loads;)
        } else {
            TokenStream::new()
        }
    }

    /// How many operations more something takes.
    fn cost(&self, krate: &TokenStream, program: &Program, name: &str, what: &str) -> TokenStream {
        let (visibility, name) = (self.visibility, format_ident!("{}", name));
        let cost = literal(krate, cost::of_rates(self.program, program));
        let doc = format!(" How many operations more it takes to find {what} with a position.");
        quote! {
            #[doc = #doc]
            #visibility const #name: #krate::Cost = #cost;
        }
    }

    fn blocked(&self) -> TokenStream {
        let Self { scalar, motors, .. } = self;
        quote!(Blocked<[#scalar; #motors]>)
    }

    /// The methods that set and tell the loads.
    fn loads(&self) -> TokenStream {
        let loads = self.model.actions.numbered_loads();
        loads.map(|(first, load)| self.load(first, load)).collect()
    }

    fn load(&self, first: usize, load: &Load) -> TokenStream {
        let Self {
            scalar, visibility, ..
        } = self;
        let (name, blocked) = (&load.name, self.blocked());
        let get = user_ident(name, self.places, load.origin);
        let set = user_ident(&format!("set_{name}"), self.places, load.origin);
        let index = Literal::usize_unsuffixed(first);
        let (kind, told, test, put, what) = match load.kind {
            LoadKind::Torque(link) => (
                quote!(#scalar),
                quote!(self.loads[#index]),
                quote!(Real::is_finite(load)),
                quote!(self.loads[#index] = load;),
                format!("the torque on link `{}`", self.model.link(link).name),
            ),
            LoadKind::Force(point) => {
                let next = Literal::usize_unsuffixed(first + 1);
                let axis = self.model.axis(point);
                let (link, point) = (&self.model.link(axis.link).name, axis.name.as_deref());
                let point = point.unwrap_or_default();
                (
                    quote!([#scalar; 2]),
                    quote!([self.loads[#index], self.loads[#next]]),
                    quote!(Real::is_finite(load[0]) && Real::is_finite(load[1])),
                    quote!([self.loads[#index], self.loads[#next]] = load;),
                    format!(
                        "the force at point `{point}` of link `{link}`, along the scene's x and y"
                    ),
                )
            }
        };
        let (tell, give) = (
            format!(" Load `{name}`: {what}."),
            format!(" Sets load `{name}`: {what}."),
        );
        quote! {
            #[doc = #tell]
            #[must_use]
            #visibility const fn #get(&self) -> #kind {
                #told
            }

            #[doc = #give]
            ///
            /// # Errors
            /// If it is not finite; the load then stays what it was.
            #visibility fn #set(&mut self, load: #kind) -> Result<(), #blocked> {
                let is_finite = #test;
                if !is_finite {
                    return Err(self.position.refuse(not_finite(#name)));
                }
                #put
                Ok(())
            }
        }
    }

    /// The methods that tell the forces of springs between points.
    fn springs(&self) -> TokenStream {
        let Self {
            scalar, visibility, ..
        } = self;
        let n = |value: f64| number(self.model.precision, value);
        let springs = self.model.actions.springs.iter().filter_map(|spring| {
            let Between::Points(a, b) = spring.between else {
                return None;
            };
            let end = |axis| {
                let axis = self.model.axis(axis);
                let ([x, y], pose) = (axis.at.map(n), pose(self.program, axis.link));
                quote!(#pose.apply([#x, #y]))
            };
            let (from, to) = (end(a), end(b));
            let (stiffness, rest) = (n(spring.stiffness), n(spring.rest));
            let name = user_ident(&spring.name, self.places, spring.origin);
            let doc = format!(
                " The force with which spring `{}` pulls its ends together; negative if it pushes them apart.",
                spring.name
            );
            Some(quote! {
                #[doc = #doc]
                #[must_use]
                #visibility fn #name(&self) -> #scalar {
                    pull(#from, #to, #stiffness, #rest)
                }
            })
        });
        springs.collect()
    }

    /// The methods that tell what holds it at rest.
    fn holding(&self, holding: &Program) -> TokenStream {
        let Self {
            scalar,
            motors,
            visibility,
            rest,
            ..
        } = self;
        let [_, arguments] = given(holding);
        let ([near, far], loads, blocked) =
            (self.steps(holding), self.given_loads(), self.blocked());
        quote! {
            /// Moves there as `move_to` does, and gives the torques of the motors (the forces of those that slide) that hold it
            /// there at rest, in the order of their declaration: against gravity, springs and loads.
            ///
            /// # Errors
            /// If a value is not finite, a loop cannot be closed on the way there, or it is at a dead point or a change point
            /// there, where torques are not determined; the mechanism then stays where it was.
            #[inline]
            #visibility fn hold_at(&mut self, motors: [#scalar; #motors]) -> Result<[#scalar; #motors], #blocked> {
                #loads
                let held = advance_with(
                    &mut self.position,
                    Motors::new(motors),
                    &COURSE,
                    |last, motors| #near(last, motors #arguments),
                    |last, motors| #far(last, motors #arguments),
                    step,
                )?;
                #rest
                Ok(held.torques)
            }

            /// The torques of the motors (the forces of those that slide) that hold it at rest where it is.
            ///
            /// # Errors
            /// If the mechanism is at a dead point or a change point, where these are not determined.
            #visibility fn torques(&self) -> Result<[#scalar; #motors], #blocked> {
                #loads
                match rates_at(&self.position, |last, motors| #far(last, motors #arguments)) {
                    Ok(held) => Ok(held.torques),
                    Err(stop) => Err(self.position.refuse(stop)),
                }
            }
        }
    }

    /// The methods that tell what it takes to move.
    fn acting(&self, acting: &Program) -> TokenStream {
        let Self {
            scalar,
            motors,
            visibility,
            model,
            ..
        } = self;
        let [_, arguments] = given(acting);
        let ([_, far], loads, blocked) = (self.steps(acting), self.given_loads(), self.blocked());
        let names: Vec<&String> = model
            .told_joints()
            .map(|joint| &model.joint(joint).name)
            .collect();
        let (found, _) = found(acting);
        let joints = Literal::usize_unsuffixed(names.len());
        let mut tokens = quote! {
            /// The joints, in the order in which `forces` tells their reactions.
            #visibility const JOINTS: [&'static str; #joints] = [#(#names),*];

            /// What it takes to move at these rates and second rates of the motors from where it is: the torques of the motors,
            /// the reaction in each joint, the transmission angles.
            ///
            /// # Errors
            /// If a rate is not finite, or the mechanism is at a dead point or a change point, where forces are not determined.
            #visibility fn forces(&self, rates: [#scalar; #motors], accelerations: [#scalar; #motors]) -> Result<#found, #blocked> {
                #loads
                let found = finite(rates, &COURSE.names)
                    .and_then(|()| finite(accelerations, &COURSE.names))
                    .and_then(|()| rates_at(&self.position, |last, motors| #far(last, motors #arguments)));
                match found {
                    Ok(forces) => Ok(forces),
                    Err(stop) => Err(self.position.refuse(stop)),
                }
            }
        };
        for (first, load) in model.actions.numbered_loads() {
            tokens.extend(self.advantage(first, load));
        }
        tokens
    }

    /// The method that tells the mechanical advantage over a load.
    fn advantage(&self, first: usize, load: &Load) -> TokenStream {
        let Self {
            scalar,
            motors,
            visibility,
            ..
        } = self;
        let name = user_ident(
            &format!("{}_advantage", load.name),
            self.places,
            load.origin,
        );
        let blocked = self.blocked();
        let index = Literal::usize_unsuffixed(first);
        let (direction, test, follows) = match load.kind {
            LoadKind::Torque(_) => (quote!(), quote!(), quote!(response[#index])),
            LoadKind::Force(_) => {
                let (next, place) = (Literal::usize_unsuffixed(first + 1), &load.name);
                (
                    quote!(, along: [#scalar; 2]),
                    quote! {
                        let [x, y] = along;
                        let length = sqrt(x * x + y * y);
                        let is_direction = length > 0.0 && Real::is_finite(length);
                        if !is_direction {
                            return Err(self.position.refuse(not_finite(#place)));
                        }
                    },
                    quote!((response[#index] * x + response[#next] * y) / length),
                )
            }
        };
        let what = match load.kind {
            LoadKind::Torque(_) => "",
            LoadKind::Force(_) => ", for forces in this direction",
        };
        let doc = format!(
            " The mechanical advantage of each motor over load `{}`{what}: how much of it a torque of one (a force, where it slides)",
            load.name
        );
        quote! {
            #[doc = #doc]
            /// balances, if there is nothing else. It is infinite where the load stands still while the motor moves.
            ///
            /// # Errors
            /// If the mechanism is at a dead point or a change point, where this is not determined, or a direction is zero.
            #visibility fn #name(&self #direction) -> Result<[#scalar; #motors], #blocked> {
                #test
                let forces = self.forces([0.0; #motors], [0.0; #motors])?;
                Ok(forces.responses.map(|response| -1.0 / (#follows)))
            }
        }
    }

    /// The methods that move it by forces.
    fn dynamics(&self, inertia: &Program) -> TokenStream {
        let Self {
            scalar,
            motors,
            visibility,
            ..
        } = self;
        let [_, arguments] = given(inertia);
        let ([near, far], loads, blocked) =
            (self.steps(inertia), self.given_loads(), self.blocked());
        let turning = self.model.motors.iter().map(|motor| {
            let turns = matches!(self.model.joint(motor.joint).kind, JointKind::Revolute(..));
            turns && motor.range.is_none()
        });
        let (velocities, record) = (self.velocities(), self.record);
        quote! {
            /// The rates of the motors: how fast they move, in radians or scene units a unit of time.
            #[must_use]
            #visibility const fn rates(&self) -> [#scalar; #motors] {
                self.rates
            }

            /// Sets how fast the motors move.
            ///
            /// # Errors
            /// If a rate is not finite; all of them then stay what they were.
            #visibility fn set_rates(&mut self, rates: [#scalar; #motors]) -> Result<(), #blocked> {
                match finite(rates, &COURSE.names) {
                    Ok(()) => {
                        self.rates = rates;
                        Ok(())
                    }
                    Err(stop) => Err(self.position.refuse(stop)),
                }
            }

            /// The second rates of the motors under these torques (forces for those that slide), gravity, springs, dampers and
            /// loads.
            ///
            /// # Errors
            /// If a torque is not finite, no mass resists a motor, or the mechanism is at a dead point or a change point.
            #visibility fn second_rates(&self, torques: [#scalar; #motors]) -> Result<[#scalar; #motors], #blocked> {
                #loads
                let rates = self.rates;
                let found = finite(torques, &COURSE.names)
                    .and_then(|()| rates_at(&self.position, |last, motors| #far(last, motors #arguments)))
                    .and_then(|inertia| inertia.accelerations(torques, &COURSE.names));
                match found {
                    Ok(accelerations) => Ok(accelerations),
                    Err(stop) => Err(self.position.refuse(stop)),
                }
            }

            /// The kinetic energy, and the potential energy of gravity and springs.
            ///
            /// # Errors
            /// If the mechanism is at a dead point or a change point, where velocities are not determined.
            #visibility fn energy(&self) -> Result<[#scalar; 2], #blocked> {
                #loads
                let rates = self.rates;
                match rates_at(&self.position, |last, motors| #far(last, motors #arguments)) {
                    Ok(inertia) => Ok([inertia.kinetic, inertia.potential]),
                    Err(stop) => Err(self.position.refuse(stop)),
                }
            }

            /// Lets it move for a step of time under these torques of the motors (forces for those that slide): a step of
            /// [`Gauss::default`].
            ///
            /// # Errors
            /// As for `simulate_by`.
            #visibility fn simulate(&mut self, time: #scalar, torques: [#scalar; #motors]) -> Result<(), #blocked> {
                self.simulate_by(Gauss::Four, time, torques)
            }

            /// The same by a method of one's choice: what is more exact takes longer.
            ///
            /// # Errors
            /// If something given is not finite, a loop cannot be closed on the way, the mechanism is at a dead point or a change
            /// point, no mass resists a motor, or the step is too long to be followed; everything then stays as it was.
            #visibility fn simulate_by(&mut self, method: Gauss, time: #scalar, torques: [#scalar; #motors]) -> Result<(), #blocked> {
                #loads
                let moment = Moment {
                    rates: self.rates,
                    torques,
                    time,
                    names: &COURSE.names,
                    turning: &[#(#turning),*],
                };
                let simulated = simulate(&self.position, &moment, method, |position, motors, rates| {
                    advance_with(
                        position,
                        motors,
                        &COURSE,
                        |last, motors| #near(last, motors #arguments),
                        |last, motors| #far(last, motors #arguments),
                        step,
                    )
                })?;
                #velocities
                self.position = simulated.position;
                self.rates = simulated.rates;
                #record
                Ok(())
            }
        }
    }

    /// What velocities are after a step of time, if they were asked for.
    fn velocities(&self) -> TokenStream {
        let effects = self.model.effects;
        if !effects.velocity {
            return TokenStream::new();
        }
        let (given, found, keep) = if effects.acceleration {
            (
                quote!(, simulated.rates, simulated.accelerations),
                quote!((velocities, accelerations)),
                quote!(self.accelerations = accelerations;),
            )
        } else {
            (
                quote!(, simulated.rates),
                quote!(velocities),
                TokenStream::new(),
            )
        };
        quote! {
            match rates_at(&simulated.position, |last, motors| step_with(last, motors #given)) {
                Ok(#found) => {
                    self.velocities = velocities;
                    #keep
                }
                Err(stop) => return Err(self.position.refuse(stop)),
            }
        }
    }
}

/// The same methods for a mechanism that has errors: never run.
pub(super) fn stub(
    krate: &TokenStream,
    places: &Places,
    model: &Model,
    visibility: &syn::Visibility,
    (scalar, motors): (&TokenStream, &Literal),
) -> TokenStream {
    let mut tokens = TokenStream::new();
    if !model.effects.needs_actions() {
        return tokens;
    }
    let blocked = quote!(#krate::Blocked<[#scalar; #motors]>);
    let result = |what: TokenStream| quote!(::core::result::Result<#what, #blocked>);
    let done = result(quote!(()));
    let all = result(quote!([#scalar; #motors]));
    for load in &model.actions.loads {
        let get = user_ident(&load.name, places, load.origin);
        let set = user_ident(&format!("set_{}", load.name), places, load.origin);
        let kind = match load.kind {
            LoadKind::Force(_) => quote!([#scalar; 2]),
            LoadKind::Torque(_) => quote!(#scalar),
        };
        tokens.extend(quote! {
            #visibility fn #get(&self) -> #kind { loop {} }
            #visibility fn #set(&mut self, load: #kind) -> #done { loop {} }
        });
    }
    for spring in &model.actions.springs {
        if let Between::Points(..) = spring.between {
            let name = user_ident(&spring.name, places, spring.origin);
            tokens.extend(quote!(#visibility fn #name(&self) -> #scalar { loop {} }));
        }
    }
    if model.effects.force {
        tokens.extend(quote! {
            #visibility fn hold_at(&mut self, motors: [#scalar; #motors]) -> #all { loop {} }
            #visibility fn torques(&self) -> #all { loop {} }
        });
        let [joints, loads] = [
            model.told_joints().count(),
            model.actions.load_names().len(),
        ]
        .map(Literal::usize_unsuffixed);
        // How many loops are dyads is not known; there are no more of them than joints.
        let forces = result(quote!(#krate::Forces<#scalar, #motors, #joints, #loads, #joints>));
        tokens.extend(quote! {
            #visibility const JOINTS: [&'static ::core::primitive::str; #joints] = [""; #joints];
            #visibility fn forces(&self, rates: [#scalar; #motors], accelerations: [#scalar; #motors]) -> #forces { loop {} }
        });
        for load in &model.actions.loads {
            let name = user_ident(&format!("{}_advantage", load.name), places, load.origin);
            let along = match load.kind {
                LoadKind::Force(_) => quote!(, along: [#scalar; 2]),
                LoadKind::Torque(_) => quote!(),
            };
            tokens.extend(quote!(#visibility fn #name(&self #along) -> #all { loop {} }));
        }
    }
    if model.effects.dynamics {
        let energy = result(quote!([#scalar; 2]));
        tokens.extend(quote! {
            #visibility fn rates(&self) -> [#scalar; #motors] { loop {} }
            #visibility fn set_rates(&mut self, rates: [#scalar; #motors]) -> #done { loop {} }
            #visibility fn second_rates(&self, torques: [#scalar; #motors]) -> #all { loop {} }
            #visibility fn energy(&self) -> #energy { loop {} }
            #visibility fn simulate(&mut self, time: #scalar, torques: [#scalar; #motors]) -> #done { loop {} }
            #visibility fn simulate_by(&mut self, method: #krate::Gauss, time: #scalar, torques: [#scalar; #motors]) -> #done {
                loop {}
            }
        });
    }
    tokens
}
