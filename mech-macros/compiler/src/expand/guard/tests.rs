use super::guard;
use crate::bug::bug;
use crate::expand::stub;
use proc_macro2::TokenStream;
use std::panic::catch_unwind;

const CRANK: &str =
    "struct Crank; link arm; joint hinge = revolute(ground, arm) at (0, 0); motor hinge;";

fn tokens(text: &str) -> TokenStream {
    text.parse().expect("tokens")
}

fn krate() -> TokenStream {
    tokens("::mech_runtime")
}

/// The text of the first compile error, as the user reads it.
fn message(expansion: TokenStream) -> String {
    let file: syn::File = syn::parse2(expansion).expect("items");
    let error = file.items.iter().find_map(|item| match item {
        syn::Item::Macro(item) => syn::parse2::<syn::LitStr>(item.mac.tokens.clone()).ok(),
        _ => None,
    });
    error.expect("an error").value()
}

/// The result for a mechanism with this expansion.
fn provoke(expansion: impl FnOnce() -> TokenStream) -> TokenStream {
    let mechanism = tokens(CRANK);
    guard(&mechanism, expansion, || stub(&krate(), mechanism.clone()))
}

#[test]
fn an_internal_error_quotes_the_mechanism_and_asks_to_be_reported() {
    let expansion = provoke(|| bug!("link {} has no pose", 7));
    let said = message(expansion.clone());
    assert_eq!(
        said,
        format!(
            "internal error: link 7 has no pose. Please report it, with this text:\n{}",
            tokens(CRANK)
        )
    );
    assert!(said.contains("struct Crank"), "{said}");
    // The type is there all the same, so that no other error hides this one.
    let text = expansion.to_string();
    assert!(text.contains("struct Crank"), "{text}");
    assert!(text.contains("impl Crank"), "{text}");
}

#[test]
fn any_panic_of_ours_is_an_internal_error() {
    let list = tokens(CRANK).into_iter().collect::<Vec<_>>();
    let beyond = list.len();
    let said = message(provoke(|| list[beyond].clone().into()));
    assert!(said.starts_with("internal error: index out of bounds"), "{said}");
    assert!(said.contains("Please report it"), "{said}");
}

#[test]
fn a_stub_that_fails_too_does_not_hide_the_error() {
    let mechanism = tokens(CRANK);
    let expansion = guard(&mechanism, || bug!("this"), || bug!("and that"));
    let said = message(expansion);
    assert!(said.starts_with("internal error: this."), "{said}");
    assert!(!said.contains("and that"), "{said}");
}

#[test]
fn outside_the_macro_the_panic_names_itself() {
    let panic = catch_unwind(|| bug!("{} motors", 0)).expect_err("a panic");
    let text = panic.downcast_ref::<String>().expect("a text");
    assert_eq!(text, "internal error in mech: 0 motors; please report this with the mechanism");
}
