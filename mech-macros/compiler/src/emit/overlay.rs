//! What the struct of a mechanism has more if it can draw its diagram.

use super::added::Added;
use super::block::scalar;
use super::motion::found;
use super::params;
use super::scope::number;
use crate::compiled::Compiled;
use crate::model::{Axis, JointId, JointKind, LinkId, LoadKind, Model, Precision};
use crate::program::Program;
use crate::symbols::{self, Spot, Symbol};
use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// What overlays add to a mechanism.
pub(super) fn added(model: &Model, compiled: &Compiled, visibility: &syn::Visibility) -> Added {
    let Compiled {
        structure,
        program,
        forced,
        ..
    } = compiled;
    if !model.effects.overlay {
        return Added::default();
    }
    let scalar = scalar(program);
    let is_kept = |link| program.place_of(link).is_some();
    let mut moving = TokenStream::new();
    let writer = Writer { model, program };
    let symbols = symbols::symbols(model, structure, is_kept);
    let symbols = symbols.iter().map(|symbol| writer.symbol(symbol));
    let (known, symbols) = writer.table(
        "SYMBOLS",
        "What is drawn of joints, links, motors and axes.",
        (&quote!(&[Symbol<#scalar>]), &quote!(&[#(#symbols),*])),
    );
    let mut items = Added {
        known,
        methods: quote! {
            /// Draws joints, motors and whatever else the overlay wants, as textbooks do.
            #visibility fn draw_overlay(&self, canvas: &mut impl Canvas<#scalar>, overlay: &Overlay) {
                Overlay::draw(overlay, #symbols, &self.position.poses, canvas);
            }
        },
        ..Added::default()
    };
    if model.effects.velocity {
        let points = symbols::moving_points(model, structure, is_kept);
        let points = points.iter().map(|&point| writer.spot(point));
        let (known, points) = writer.table(
            "MOVING_POINTS",
            "The points whose velocities are drawn.",
            (&quote!(&[Spot<#scalar>]), &quote!(&[#(#points),*])),
        );
        moving = points;
        items.known.extend(known);
        items.methods.extend(quote! {
            /// Draws the velocities of all named points and revolute joints that move.
            #visibility fn draw_velocities(&self, canvas: &mut impl Canvas<#scalar>, arrows: &Arrows<#scalar>) {
                generated::draw_velocities(#moving, &self.position.poses, &self.velocities, arrows, canvas);
            }
        });
    }
    if model.effects.acceleration {
        items.methods.extend(quote! {
            /// Draws the accelerations of all named points and revolute joints that move.
            #visibility fn draw_accelerations(&self, canvas: &mut impl Canvas<#scalar>, arrows: &Arrows<#scalar>) {
                let rates = (&self.velocities, &self.accelerations);
                generated::draw_accelerations(#moving, &self.position.poses, rates, arrows, canvas);
            }
        });
    }
    if let Some(inverse_dynamics) = &forced.inverse_dynamics {
        items = items.and(forces(model, (program, inverse_dynamics), visibility));
    }
    items
}

/// The arrows of forces.
fn forces(
    model: &Model,
    (program, inverse_dynamics): (&Program, &Program),
    visibility: &syn::Visibility,
) -> Added {
    let scalar = scalar(program);
    let writer = Writer { model, program };
    let points = model
        .declared_joints()
        .map(|joint| match writer.place_of(joint) {
            None => quote!(Option::None),
            Some(point) => {
                let point = writer.spot(point);
                quote!(Option::Some(#point))
            }
        });
    let points: Vec<TokenStream> = points.collect();
    let count = Literal::usize_unsuffixed(points.len());
    let (found, _) = found(inverse_dynamics);
    let loads = model.actions.numbered_loads().filter_map(|(first, load)| {
        let LoadKind::Force(point) = load.kind else {
            return None;
        };
        let point = writer.spot(symbols::Spot::of(model, point));
        let [x, y] = [first, first + 1].map(Literal::usize_unsuffixed);
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
    let (known, points) = writer.table(
        "REACTION_POINTS",
        "Where the reactions are drawn.",
        (
            &quote!([Option<Spot<#scalar>>; #count]),
            &quote!([#(#points),*]),
        ),
    );
    Added {
        known,
        methods: quote! {
            /// Draws the forces that the first link of each joint exerts on the second, as `forces` found them.
            #visibility fn draw_reactions(&self, canvas: &mut impl Canvas<#scalar>, arrows: &Arrows<#scalar>, forces: &#found) {
                generated::draw_reactions(&#points, &self.position.poses, &forces.reactions, arrows, canvas);
            }

            #draw_loads
        },
        ..Added::default()
    }
}

/// Writes symbols as Rust.
struct Writer<'p> {
    model: &'p Model,
    program: &'p Program,
}

impl Writer<'_> {
    /// A table: the constant that holds it, and how it is called. Where params move what is in it, it is made where it is used.
    fn table(
        &self,
        name: &str,
        what: &str,
        (kind, entries): (&TokenStream, &TokenStream),
    ) -> (TokenStream, TokenStream) {
        if self.model.axes.iter().any(Axis::varies) {
            return (TokenStream::new(), entries.clone());
        }
        let (name, doc) = (format_ident!("{name}"), format!(" {what}"));
        let table = quote! {
            #[doc = #doc]
            pub(super) const #name: #kind = #entries;
        };
        (table, quote!(known::#name))
    }

    /// Where a joint is; what rolls has no place of its own.
    fn place_of(&self, joint: JointId) -> Option<symbols::Spot> {
        let model = self.model;
        let axis = match model.joint(joint).kind {
            JointKind::Revolute(a, _) | JointKind::Weld(a, _) => a,
            JointKind::Prismatic(_, b) => b,
            _ => return None,
        };
        let spot = symbols::Spot::of(model, model.seen_axis(axis));
        let is_kept = spot.link == LinkId::GROUND || self.program.place_of(spot.link).is_some();
        is_kept.then_some(spot)
    }

    fn precision(&self) -> Precision {
        self.program.precision
    }

    fn number(&self, value: f64) -> TokenStream {
        number(self.precision(), value)
    }

    fn pair(&self, [x, y]: [f64; 2]) -> TokenStream {
        let (x, y) = (self.number(x), self.number(y));
        quote!([#x, #y])
    }

    /// The number of a link in a table: that of its pose and one, or 0 for the ground.
    fn link(&self, link: LinkId) -> Literal {
        Literal::usize_unsuffixed(match link {
            LinkId::GROUND => 0,
            link => self.program.pose_index(link) + 1,
        })
    }

    fn place(&self, spot: Spot) -> TokenStream {
        params::place(self.model, self.program, spot.axis)
    }

    fn spot(&self, spot: Spot) -> TokenStream {
        let (link, at) = (self.link(spot.link), self.place(spot));
        quote!(Spot { link: #link, at: #at })
    }

    fn symbol(&self, symbol: &Symbol) -> TokenStream {
        match *symbol {
            Symbol::Bar { link, ends } => {
                let (link, [from, to]) = (self.link(link), ends.map(|end| self.place(end)));
                quote!(Symbol::Bar { link: #link, ends: [#from, #to] })
            }
            Symbol::Mark(spot) => {
                let spot = self.spot(spot);
                quote!(Symbol::Mark(#spot))
            }
            Symbol::Wheel { center, radius } => {
                let (center, radius) = (self.spot(center), self.number(radius));
                quote!(Symbol::Wheel { center: #center, radius: #radius })
            }
            Symbol::Belt { centers, radii } => {
                let [a, b] = centers.map(|center| self.spot(center));
                let radii = self.pair(radii);
                quote!(Symbol::Belt { centers: [#a, #b], radii: #radii })
            }
            Symbol::Rack {
                pinion,
                radius,
                bar,
                along,
            } => {
                let (pinion, bar) = (self.spot(pinion), self.spot(bar));
                let (radius, along) = (self.number(radius), self.pair(along));
                quote!(Symbol::Rack { pinion: #pinion, radius: #radius, bar: #bar, along: #along })
            }
            Symbol::Line { at, along } => {
                let (at, along) = (self.spot(at), self.pair(along));
                quote!(Symbol::Line { at: #at, along: #along })
            }
            Symbol::Point(spot) => {
                let spot = self.spot(spot);
                quote!(Symbol::Point(#spot))
            }
            Symbol::Slide {
                guide,
                along,
                block,
            } => {
                let (guide, along) = (self.spot(guide), self.pair(along));
                let block = self.spot(block);
                quote!(Symbol::Slide { guide: #guide, along: #along, block: #block })
            }
            Symbol::Weld(spot) => {
                let spot = self.spot(spot);
                quote!(Symbol::Weld(#spot))
            }
            Symbol::Pivot(spot) => {
                let spot = self.spot(spot);
                quote!(Symbol::Pivot(#spot))
            }
            Symbol::Turned(spot) => {
                let spot = self.spot(spot);
                quote!(Symbol::Turned(#spot))
            }
            Symbol::Pushed {
                block,
                guide,
                along,
            } => {
                let (block, guide) = (self.spot(block), self.link(guide));
                let along = self.pair(along);
                quote!(Symbol::Pushed { block: #block, guide: #guide, along: #along })
            }
        }
    }
}
