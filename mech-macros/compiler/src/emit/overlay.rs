//! The methods that draw a mechanism's diagram and arrows.

use super::Parts;
use super::emitter::Emitter;
use super::expression::{Expression, expressions};
use super::step::outcome_type;
use super::tokens::{integer, option};
use crate::model::{Axis, JointId, JointKind, LoadKind};
use crate::program::Program;
use crate::symbols::{self, Spot, Symbol, spot};
use proc_macro2::TokenStream;
use quote::{format_ident, quote};

/// `draw_overlay`, and a method for each kind of arrows; nothing if no overlay is asked for.
pub(super) fn emit(emitter: &Emitter<'_>) -> Parts {
    let effects = emitter.model.effects;
    if !effects.overlay {
        return Parts::default();
    }
    let inverse_dynamics = emitter.compiled.forced.inverse_dynamics.as_ref();
    [
        Some(diagram(emitter)),
        effects.velocity.then(|| rates(emitter)),
        inverse_dynamics.map(|program| forces(emitter, program)),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// `draw_overlay`.
fn diagram(emitter: &Emitter<'_>) -> Parts {
    let (visibility, scalar) = (emitter.visibility, &emitter.scalar);
    let table = symbols_table(emitter);
    let symbols = table.path(emitter);
    Parts {
        known: table.constant(emitter),
        methods: quote! {
            /// Draws joints, motors and whatever else the overlay wants, as textbooks do.
            #visibility fn draw_overlay(&self, canvas: &mut impl Canvas<#scalar>, overlay: &Overlay) {
                Overlay::draw(overlay, #symbols, &self.position.poses, canvas);
            }
        },
        ..Parts::default()
    }
}

/// The symbols of the whole diagram.
pub(super) fn symbols_table(emitter: &Emitter<'_>) -> Table {
    let has_pose = |link| emitter.has_pose(link);
    let symbols = symbols::symbols(emitter.model, &emitter.compiled.structure, has_pose);
    let doc = " What is drawn of joints, links, motors and axes.";
    Table::of_symbols(emitter, ("SYMBOLS", doc), &symbols)
}

/// The symbols of springs and dampers.
pub(super) fn elastic_table(emitter: &Emitter<'_>, symbols: &[symbols::Symbol]) -> Table {
    let doc = " Springs and dampers, which are drawn over all shapes.";
    Table::of_symbols(emitter, ("ELASTIC", doc), symbols)
}

/// `draw_velocities` and `draw_accelerations`.
fn rates(emitter: &Emitter<'_>) -> Parts {
    let (visibility, scalar) = (emitter.visibility, &emitter.scalar);
    let has_pose = |link| emitter.has_pose(link);
    let points = symbols::moving_points(emitter.model, &emitter.compiled.structure, has_pose);
    let points = points.iter().map(|point| point.expression(emitter));
    let table = Table {
        name: "MOVING_POINTS",
        doc: " The points whose velocities are drawn.",
        kind: quote!(&[Spot<#scalar>]),
        value: quote!(&[#(#points),*]),
    };
    let points = table.path(emitter);
    let draw_accelerations = emitter.model.effects.acceleration.then(|| {
        quote! {
            /// Draws the accelerations of all named points and revolute joints that move.
            #visibility fn draw_accelerations(&self, canvas: &mut impl Canvas<#scalar>, arrows: &Arrows<#scalar>) {
                let rates = (&self.velocities, &self.accelerations);
                generated::draw_accelerations(#points, &self.position.poses, rates, arrows, canvas);
            }
        }
    });
    Parts {
        known: table.constant(emitter),
        methods: quote! {
            /// Draws the velocities of all named points and revolute joints that move.
            #visibility fn draw_velocities(&self, canvas: &mut impl Canvas<#scalar>, arrows: &Arrows<#scalar>) {
                generated::draw_velocities(#points, &self.position.poses, &self.velocities, arrows, canvas);
            }

            #draw_accelerations
        },
        ..Parts::default()
    }
}

/// `draw_reactions`, and `draw_loads` if a load is a force.
fn forces(emitter: &Emitter<'_>, inverse_dynamics: &Program) -> Parts {
    let (visibility, scalar, model) = (emitter.visibility, &emitter.scalar, emitter.model);
    let points = model.declared_joints().map(|joint| {
        let point = joint_spot(emitter, joint);
        option(point.map(|point| point.expression(emitter)))
    });
    let points: Vec<TokenStream> = points.collect();
    let count = integer(points.len());
    let table = Table {
        name: "REACTION_POINTS",
        doc: " Where the reactions are drawn.",
        kind: quote!([Option<Spot<#scalar>>; #count]),
        value: quote!([#(#points),*]),
    };
    let (points, kind) = (table.path(emitter), outcome_type(inverse_dynamics));
    let loads = model.actions.numbered_loads().filter_map(|(first, load)| {
        let LoadKind::Force(point) = load.kind else {
            return None;
        };
        let point = spot(model, point).expression(emitter);
        let [x, y] = [first, first + 1].map(integer);
        Some(quote!(generated::draw_force(&#point, &self.position.poses, [self.loads[#x], self.loads[#y]], arrows, canvas);))
    });
    let loads: Vec<TokenStream> = loads.collect();
    let draw_loads = (!loads.is_empty()).then(|| {
        quote! {
            /// Draws the loads that are forces.
            #visibility fn draw_loads(&self, canvas: &mut impl Canvas<#scalar>, arrows: &Arrows<#scalar>) {
                #(#loads)*
            }
        }
    });
    Parts {
        known: table.constant(emitter),
        methods: quote! {
            /// Draws the forces that the first link of each joint exerts on the second, as `forces` found them.
            #visibility fn draw_reactions(&self, canvas: &mut impl Canvas<#scalar>, arrows: &Arrows<#scalar>, forces: &#kind) {
                generated::draw_reactions(&#points, &self.position.poses, &forces.reactions, arrows, canvas);
            }

            #draw_loads
        },
        ..Parts::default()
    }
}

/// The place of a joint; none of gears, belts, racks and cams.
fn joint_spot(emitter: &Emitter<'_>, joint: JointId) -> Option<Spot> {
    let model = emitter.model;
    let axis = match model.joint(joint).kind {
        JointKind::Revolute(a, _) | JointKind::Weld(a, _) => a,
        JointKind::Prismatic(_, b) => b,
        _ => return None,
    };
    let spot = spot(model, model.seen_axis(axis));
    emitter.has_pose(spot.link).then_some(spot)
}

/// A table of what is drawn: a constant, or an expression in a method where params move places.
pub(super) struct Table {
    name: &'static str,
    doc: &'static str,
    kind: TokenStream,
    value: TokenStream,
}

impl Table {
    fn of_symbols(
        emitter: &Emitter<'_>,
        (name, doc): (&'static str, &'static str),
        symbols: &[symbols::Symbol],
    ) -> Self {
        let symbols = symbols.iter().map(|symbol| symbol.expression(emitter));
        let scalar = &emitter.scalar;
        Self { name, doc, kind: quote!(&[Symbol<#scalar>]), value: quote!(&[#(#symbols),*]) }
    }

    /// The constant; nothing if there is none.
    pub(super) fn constant(&self, emitter: &Emitter<'_>) -> TokenStream {
        if varies(emitter) {
            return TokenStream::new();
        }
        let Self { name, doc, kind, value } = self;
        let name = format_ident!("{name}");
        quote! {
            #[doc = #doc]
            pub(super) const #name: #kind = #value;
        }
    }

    /// The table in a method.
    pub(super) fn path(&self, emitter: &Emitter<'_>) -> TokenStream {
        if varies(emitter) {
            return self.value.clone();
        }
        let name = format_ident!("{}", self.name);
        quote!(known::#name)
    }
}

/// Whether params move places.
fn varies(emitter: &Emitter<'_>) -> bool {
    emitter.model.axes.iter().any(Axis::varies)
}

expressions! {
    Symbol:
    Bar { link, ends },
    Mark(at),
    Wheel { center, radius },
    Belt { centers, radii },
    Rack { pinion, radius, bar, along },
    Line { at, along },
    Point(at),
    Slide { guide, along, block },
    Weld(at),
    Pivot(at),
    Spring { ends, beside },
    Damper { ends, beside },
    TorsionSpring(at),
    TorsionDamper(at),
    Cam(at),
    Wedge { at, along },
    RotaryMotor(at),
    LinearMotor { block, guide, along }
}
