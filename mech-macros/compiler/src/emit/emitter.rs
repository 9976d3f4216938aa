//! The mechanism as every file of this room reads it.

use super::tokens::{integer, number, scalar, user_ident};
use crate::compiled::{Compiled, InverseMechanism};
use crate::looks::{Looks, looks};
use crate::model::{AxisId, FormulaId, LinkId, Model, MotorId, Origin};
use crate::program::Program;
use crate::syntax::{Header, Parsed, Places};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

/// Where the code of a mechanism will stand.
struct Declared<'a> {
    krate: &'a TokenStream,
    header: &'a Header,
    places: &'a Places,
}

/// A coherent mechanism, where its code will stand, and tokens that most methods quote.
pub(super) struct Emitter<'a> {
    /// The path of the runtime crate.
    pub(super) krate: &'a TokenStream,
    pub(super) header: &'a Header,
    pub(super) visibility: &'a syn::Visibility,
    places: &'a Places,
    pub(super) model: &'a Model,
    pub(super) compiled: &'a Compiled,
    pub(super) looks: Looks,
    pub(super) program: &'a Program,
    /// The scalar type.
    pub(super) scalar: TokenStream,
    /// The number of motors.
    pub(super) motors: Literal,
    /// The number of links whose poses are computed.
    pub(super) links: Literal,
    /// The number of params.
    pub(super) params: Literal,
    /// The type of a value for each motor.
    pub(super) values: TokenStream,
    /// The error type of most methods.
    pub(super) blocked: TokenStream,
    /// The position, as an expression where coordinates are read.
    at: TokenStream,
}

impl<'a> Emitter<'a> {
    pub(super) fn new(
        krate: &'a TokenStream,
        header: &'a Header,
        parsed: &'a Parsed,
        compiled: &'a Compiled,
    ) -> Self {
        let of = Declared { krate, header, places: &parsed.places };
        let looks = looks(&parsed.model, compiled);
        Self::of(of, &parsed.model, compiled, looks, quote!(self.position))
    }

    /// The mechanism in which a point is given. Nothing of it is seen, and `at` is its position.
    pub(super) fn of_inverse(&self, inverse: &'a InverseMechanism) -> Self {
        self.unseen(&inverse.model, &inverse.compiled, quote!(at))
    }

    /// The same mechanism where a variable is its position. Nothing of it is seen.
    pub(super) fn at(&self, position: TokenStream) -> Self {
        self.unseen(self.model, self.compiled, position)
    }

    fn unseen(&self, model: &'a Model, compiled: &'a Compiled, at: TokenStream) -> Self {
        let of = Declared { krate: self.krate, header: self.header, places: self.places };
        let looks = Looks { painted: Vec::new(), symbols: None };
        Self::of(of, model, compiled, looks, at)
    }

    fn of(
        Declared { krate, header, places }: Declared<'a>,
        model: &'a Model,
        compiled: &'a Compiled,
        looks: Looks,
        at: TokenStream,
    ) -> Self {
        let program = &compiled.program;
        let scalar = scalar(program.precision);
        let motors = integer(program.motors.len());
        let values = quote!([#scalar; #motors]);
        Self {
            krate,
            header,
            visibility: &header.visibility,
            places,
            model,
            compiled,
            looks,
            at,
            program,
            links: integer(program.links.len()),
            params: integer(program.params.len()),
            blocked: quote!(Blocked<#values>),
            scalar,
            motors,
            values,
        }
    }

    /// An identifier with the span of the user's declaration.
    pub(super) fn ident(&self, name: &str, origin: Origin) -> Ident {
        user_ident(name, self.places, origin)
    }

    /// The path of the scalar type, which holds wherever the struct stands.
    pub(super) fn scalar_path(&self) -> TokenStream {
        let (krate, scalar) = (self.krate, &self.scalar);
        quote!(#krate::generated::#scalar)
    }

    /// A literal of the mechanism's precision.
    pub(super) fn number(&self, value: f64) -> TokenStream {
        number(self.program.precision, value)
    }

    /// An array of two literals.
    pub(super) fn pair(&self, pair: [f64; 2]) -> TokenStream {
        let [x, y] = pair.map(|value| self.number(value));
        quote!([#x, #y])
    }

    pub(super) fn has_params(&self) -> bool {
        !self.program.params.is_empty()
    }

    /// Whether a motor turns; others slide.
    pub(super) fn turns(&self, motor: MotorId) -> bool {
        self.model.turns(self.model.motor(motor).joint)
    }

    /// Whether the pose of a link is known; the ground's always is.
    pub(super) fn has_pose(&self, link: LinkId) -> bool {
        self.link_number(link).is_some()
    }

    /// The number of a link in a table: one more than the index of its pose, 0 for the ground; none if its pose is not known.
    pub(super) fn link_number(&self, link: LinkId) -> Option<usize> {
        if link == LinkId::GROUND {
            return Some(0);
        }
        self.program.place_of(link).map(|index| index + 1)
    }

    /// The index of a moving link among the poses and rates of a position.
    pub(super) fn index(&self, link: LinkId) -> Literal {
        integer(self.program.pose_index(link))
    }

    /// The state at this index: an expression in a method.
    pub(super) fn state(&self, index: usize) -> TokenStream {
        let (at, index) = (&self.at, integer(index));
        quote!(#at.state[#index])
    }

    /// The pose of a link in the scene, as an expression in a method.
    pub(super) fn pose(&self, link: LinkId) -> TokenStream {
        if link == LinkId::GROUND {
            return quote!(Pose::identity());
        }
        let index = self.index(link);
        let at = &self.at;
        quote!(#at.poses[#index])
    }

    /// The place of an axis in its link, as an array: an expression in a method.
    pub(super) fn place(&self, id: AxisId) -> TokenStream {
        let axis = self.model.axis(id);
        self.present_pair(axis.at, axis.formulas)
    }

    /// The direction of an axis in its link, in the same form.
    pub(super) fn direction(&self, id: AxisId) -> TokenStream {
        let axis = self.model.axis(id);
        self.present_pair(axis.direction, axis.direction_formulas)
    }

    fn present_pair(&self, start: [f64; 2], formulas: [Option<FormulaId>; 2]) -> TokenStream {
        let [x, y] = [0, 1].map(|part| self.present(start[part], formulas[part]));
        quote!([#x, #y])
    }

    /// A number that may depend on params: an expression in a method.
    pub(super) fn present(&self, start: f64, formula: Option<FormulaId>) -> TokenStream {
        match formula.and_then(|formula| self.program.formula_state(formula)) {
            None => self.number(start),
            Some(state) => self.state(state),
        }
    }

    /// The place of an axis in the scene, as an array: an expression in a method.
    pub(super) fn point(&self, id: AxisId) -> TokenStream {
        let (pose, place) = (self.pose(self.model.axis(id).link), self.place(id));
        quote!(#pose.apply(#place))
    }

    /// The pose of an axis's link, its place there and its direction: an expression in a method.
    pub(super) fn axis(&self, id: AxisId) -> TokenStream {
        let (pose, place) = (self.pose(self.model.axis(id).link), self.place(id));
        let direction = self.direction(id);
        quote!((#pose, #place, #direction))
    }

    /// A method that returns `value` and takes nothing else than the mechanism.
    pub(super) fn accessor(
        &self,
        name: &Ident,
        doc: &str,
        kind: &TokenStream,
        value: &TokenStream,
    ) -> TokenStream {
        self.getter(&quote!(fn #name), doc, kind, value)
    }

    /// The same as a `const fn`.
    pub(super) fn constant_accessor(
        &self,
        name: &Ident,
        doc: &str,
        kind: &TokenStream,
        value: &TokenStream,
    ) -> TokenStream {
        self.getter(&quote!(const fn #name), doc, kind, value)
    }

    fn getter(
        &self,
        function: &TokenStream,
        doc: &str,
        kind: &TokenStream,
        value: &TokenStream,
    ) -> TokenStream {
        let visibility = self.visibility;
        quote! {
            #[doc = #doc]
            #[must_use]
            #visibility #function(&self) -> #kind {
                #value
            }
        }
    }
}
