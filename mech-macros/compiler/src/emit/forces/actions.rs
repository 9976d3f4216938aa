//! The methods that set and tell loads, and tell the forces of springs.

use super::Writer;
use crate::emit::items::{pose, user_ident};
use crate::emit::scope::number;
use crate::model::{Between, Load, LoadKind};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

impl Writer<'_> {
    /// The methods that set and tell the loads.
    pub(super) fn loads(&self) -> TokenStream {
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
                let (link, point) = (&self.model.link(axis.link).name, axis.own_name());
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
                    return Result::Err(Position::refuse(&self.position, generated::not_finite(#name), known::COURSE.inputs));
                }
                #put
                Result::Ok(())
            }
        }
    }

    /// The methods that tell the forces of springs between points.
    pub(super) fn springs(&self) -> TokenStream {
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
                    generated::pull(#from, #to, #stiffness, #rest)
                }
            })
        });
        springs.collect()
    }
}
