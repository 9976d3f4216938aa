//! Instances of parts as values: `beast.left(2).foot_tip()`.
//!
//! The methods of what belongs to an instance stand in the struct of the mechanism under hidden names. A view knows its instance and
//! calls them. Where those of all instances differ in numbers only, the view has a table of these, and nothing is hidden: a mechanism with
//! many alike parts would have as many methods to be compiled.

use super::instance_methods::{Owned, Owners, Shared, drop_uncalled, shared};
use super::method::{Item, items};
use super::tokens::integer;
use crate::bug::bug;
use crate::model::Model;
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};
use syn::{Attribute, Expr, ExprLit, FnArg, Lit, Meta, Pat, ReturnType, Type, Visibility};

/// The methods of a mechanism, and the views that they return.
pub(super) struct Views {
    pub(super) methods: TokenStream,
    pub(super) items: TokenStream,
}

/// Where views stand.
pub(super) struct Site<'a> {
    /// The path of the runtime crate.
    pub(super) krate: &'a TokenStream,
    pub(super) visibility: &'a Visibility,
    /// The name of the struct there.
    pub(super) this: &'a Ident,
}

/// The views of all instances, by the methods of the mechanism. Nothing but these methods calls hidden ones.
pub(super) fn views(site: &Site<'_>, model: &Model, methods: TokenStream) -> Views {
    if model.instances.is_empty() {
        let items = TokenStream::new();
        return Views { methods, items };
    }
    let mut methods = items(methods);
    let owners = Owners::of(model);
    let mut owned: Vec<Owned> = Vec::new();
    for item in &mut methods {
        let Item::Method(method) = item else {
            continue;
        };
        if let Some((instance, local)) = owners.owner(&method.name) {
            method.hide();
            let method = method.clone();
            owned.push(Owned { instance, local, method });
        }
    }
    let mut kinds = kinds(model);
    for kind in &mut kinds {
        kind.methods = shared(&kind.instances, &owned);
    }
    drop_uncalled(&mut methods, kinds.iter().flat_map(|kind| &kind.methods));
    let mut items = TokenStream::new();
    for kind in &kinds {
        items.extend(view(site, model, &kinds, kind));
    }
    let roots = kinds.iter().filter(|kind| kind.parent.is_none());
    let getters = roots.map(|kind| {
        let getter = getter(site, model, kind, &kinds, &Holder::Mechanism);
        let setter = setter(site, model, kind, &kinds, &Holder::Mechanism);
        quote!(#getter #setter)
    });
    Views { methods: quote!(#(#methods)* #(#getters)*), items }
}

/// The instances that one use has, in all instances of the part that uses it.
struct Kind<'o> {
    /// The name of the view's type.
    name: Ident,
    /// The name of the use.
    of: String,
    is_array: bool,
    /// The kind of view to which it belongs; none for uses of the mechanism itself.
    parent: Option<usize>,
    /// The path without brackets.
    path: String,
    instances: Vec<usize>,
    /// The methods that its instances have.
    methods: Vec<Shared<'o>>,
}

impl<'o> Kind<'o> {
    /// The kinds of the views that one of this kind returns.
    fn inner<'k>(&'k self, kinds: &'k [Self]) -> impl Iterator<Item = &'k Kind<'o>> {
        let is_this = |parent: usize| kinds[parent].path == self.path;
        kinds.iter().filter(move |inner| inner.parent.is_some_and(is_this))
    }
}

/// The kinds of instances, without their methods.
fn kinds<'o>(model: &Model) -> Vec<Kind<'o>> {
    let mut kinds: Vec<Kind<'o>> = Vec::new();
    for (number, instance) in model.instances.iter().enumerate() {
        let parent = instance.parent.map(|parent| {
            let mut kinds = kinds.iter();
            let kind = kinds.position(|kind| kind.instances.contains(&parent));
            kind.unwrap_or_else(|| bug!("an instance stands before the one that it is in"))
        });
        let beginning =
            parent.map_or_else(String::new, |parent| format!("{}.", kinds[parent].path));
        let path = format!("{beginning}{}", instance.name);
        match kinds.iter_mut().find(|kind| kind.path == path) {
            Some(kind) => kind.instances.push(number),
            None => kinds.push(Kind {
                name: format_ident!("ViewOf{}", camel_case(&path)),
                of: instance.name.clone(),
                is_array: instance.index.is_some(),
                parent,
                path,
                instances: vec![number],
                methods: Vec::new(),
            }),
        }
    }
    kinds
}

/// `left.first_finger` as `LeftFirstFinger`.
fn camel_case(path: &str) -> String {
    let words = path.split(['.', '_']);
    let capital = |word: &str| {
        let mut letters = word.chars();
        let first = letters.next().into_iter().flat_map(char::to_uppercase);
        first.chain(letters).collect::<String>()
    };
    words.map(capital).collect()
}

/// The type from which a view is taken.
enum Holder {
    Mechanism,
    View,
}

/// The types of the views of a kind, and their methods.
fn view(site: &Site<'_>, model: &Model, kinds: &[Kind<'_>], kind: &Kind<'_>) -> TokenStream {
    let Site { visibility, this, .. } = site;
    let (name, mutable) = (&kind.name, mutable(kind));
    let [reads, changes] = [false, true].map(|changes| -> TokenStream {
        let all = kind.methods.iter().filter(|all| all.takes_mutable() == changes);
        all.map(|all| method(site, model, all)).collect()
    });
    let inner = kind.inner(kinds);
    let inner: TokenStream =
        inner.map(|inner| getter(site, model, inner, kinds, &Holder::View)).collect();
    let inner_mut = kind.inner(kinds);
    let inner_mut: TokenStream =
        inner_mut.filter_map(|inner| setter(site, model, inner, kinds, &Holder::View)).collect();
    let doc = format!(" An instance of `{}`.", kind.path);
    let mutable = has_changes(kind, kinds).then(|| {
        quote! {
            #[doc = #doc]
            #visibility struct #mutable<'a> {
                mechanism: &'a mut #this,
                instance: usize,
            }

            #[allow(dead_code, reason = "nobody has to ask for everything of an instance")]
            impl<'a> #mutable<'a> {
                #changes
                #inner_mut
            }
        }
    });
    quote! {
        #[doc = #doc]
        #[derive(Clone, Copy)]
        #visibility struct #name<'a> {
            mechanism: &'a #this,
            instance: usize,
        }

        #[allow(dead_code, reason = "nobody has to ask for everything of an instance")]
        impl<'a> #name<'a> {
            #reads
            #inner
        }

        #mutable
    }
}

/// The name of the view by which an instance is changed.
fn mutable(kind: &Kind<'_>) -> Ident {
    format_ident!("{}Mut", kind.name)
}

/// A method of a view: that of its instance. What only some instances have, such as a trace, is optional.
fn method(site: &Site<'_>, model: &Model, shared: &Shared<'_>) -> TokenStream {
    let krate = site.krate;
    let first = shared.first;
    let mut signature = shared.read.sig.clone();
    signature.ident = Ident::new(shared.local, first.method.name.span());
    signature.constness = None;
    let is_optional = shared.all.iter().any(Option::is_none);
    if let (true, ReturnType::Type(_, kind)) = (is_optional, &mut signature.output) {
        **kind = Type::Verbatim(quote!(#krate::generated::Option<#kind>));
    }
    let arguments = signature.inputs.iter().filter_map(|input| match input {
        FnArg::Typed(typed) => match &*typed.pat {
            Pat::Ident(name) => Some(name.ident.clone()),
            _ => None,
        },
        FnArg::Receiver(_) => None,
    });
    let arguments: Vec<Ident> = arguments.collect();
    let path = &model.instances[first.instance].path;
    let attributes = shared.read.attrs.iter();
    let attributes = attributes.map(|attribute| in_view(attribute, path));
    let calls = shared.all.iter().map(|one| match one {
        None => quote!(#krate::generated::Option::None),
        Some(one) => {
            let method = &one.method.name;
            let call = quote!(self.mechanism.#method(#(#arguments),*));
            if is_optional { quote!(#krate::generated::Option::Some(#call)) } else { call }
        }
    });
    let body = shared.body.clone();
    let body = body.unwrap_or_else(|| choose(calls.collect()));
    let visibility = site.visibility;
    quote!(#(#attributes)* #visibility #signature { #body })
}

/// One of several expressions, by the number of the instance.
fn choose(all: Vec<TokenStream>) -> TokenStream {
    let mut all = all;
    let Some(last) = all.pop() else {
        bug!("a view has no instance");
    };
    if all.is_empty() {
        return last;
    }
    let numbers = (0..all.len()).map(integer);
    quote!(match self.instance { #(#numbers => #all,)* _ => #last })
}

/// An attribute of a hidden method for a view: documentation names what is meant without the path.
fn in_view(attribute: &Attribute, path: &str) -> TokenStream {
    if let Meta::NameValue(doc) = &attribute.meta
        && doc.path.is_ident("doc")
        && let Expr::Lit(ExprLit { lit: Lit::Str(text), .. }) = &doc.value
    {
        let text = text.value().replace(&format!("{path}."), "");
        return quote!(#[doc = #text]);
    }
    quote!(#attribute)
}

/// Whether anything of an instance can be changed, or of one in it.
fn has_changes(kind: &Kind<'_>, kinds: &[Kind<'_>]) -> bool {
    let mut methods = kind.methods.iter();
    methods.any(Shared::takes_mutable) || kind.inner(kinds).any(|inner| has_changes(inner, kinds))
}

/// The documentation of what returns a view.
fn view_doc(model: &Model, kind: &Kind<'_>) -> TokenStream {
    let (of, part) = (&kind.of, &model.instances[kind.instances[0]].part);
    if !kind.is_array {
        let doc = format!(" The instance `{of}` of part `{part}`.");
        return quote!(#[doc = #doc]);
    }
    let doc = format!(" Instance `k` of `{of}`, of part `{part}`. They are counted from zero.");
    quote! {
        #[doc = #doc]
        ///
        /// # Panics
        /// If there is no such instance, as an array does that has no such element.
    }
}

/// The method that returns the view of an instance.
fn getter(
    site: &Site<'_>,
    model: &Model,
    kind: &Kind<'_>,
    kinds: &[Kind<'_>],
    holder: &Holder,
) -> TokenStream {
    let Site { krate, visibility, .. } = site;
    let (view, of, doc) =
        (&kind.name, Ident::new(&kind.of, Span::call_site()), view_doc(model, kind));
    let index = kind.is_array.then(|| quote!(, k: usize));
    let number = number(krate, model, kinds, kind);
    let (lifetime, mechanism) = match holder {
        Holder::Mechanism => (quote!('_), quote!(self)),
        Holder::View => (quote!('a), quote!(self.mechanism)),
    };
    quote! {
        #doc
        #[must_use]
        #[track_caller]
        #visibility fn #of(&self #index) -> #view<#lifetime> {
            #view { instance: #number, mechanism: #mechanism }
        }
    }
}

/// The method that returns the view by which an instance is changed, if anything of it can be.
fn setter(
    site: &Site<'_>,
    model: &Model,
    kind: &Kind<'_>,
    kinds: &[Kind<'_>],
    holder: &Holder,
) -> Option<TokenStream> {
    if !has_changes(kind, kinds) {
        return None;
    }
    let Site { krate, visibility, .. } = site;
    let (view, of, doc) = (mutable(kind), format_ident!("{}_mut", kind.of), view_doc(model, kind));
    let index = kind.is_array.then(|| quote!(, k: usize));
    let number = number(krate, model, kinds, kind);
    let mechanism = match holder {
        Holder::Mechanism => quote!(self),
        Holder::View => quote!(self.mechanism),
    };
    Some(quote! {
        #doc
        #[must_use]
        #[track_caller]
        #visibility fn #of(&mut self #index) -> #view<'_> {
            #view { instance: #number, mechanism: #mechanism }
        }
    })
}

/// The number of an instance among all of its kind, as an expression of the holder's number and `k`.
fn number(krate: &TokenStream, model: &Model, kinds: &[Kind<'_>], kind: &Kind<'_>) -> TokenStream {
    let holders = match kind.parent {
        None => vec![None],
        Some(parent) => kinds[parent].instances.iter().copied().map(Some).collect(),
    };
    let is_in = |holder: Option<usize>| {
        let instances = kind.instances.iter().enumerate();
        let of: Vec<usize> = instances
            .filter(|(_, instance)| model.instances[**instance].parent == holder)
            .map(|(number, _)| number)
            .collect();
        of
    };
    let choices = holders.into_iter().map(|holder| {
        let of = is_in(holder);
        let Some(&first) = of.first() else { bug!("a part is used without instances") };
        let [first, count] = [first, of.len()].map(integer);
        let name = &kind.of;
        if kind.is_array {
            quote!(#first + #krate::generated::instance_number(#name, k, #count))
        } else {
            quote!(#first)
        }
    });
    choose(choices.collect())
}
