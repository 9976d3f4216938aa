//! Requests of the page to its browser.

use crate::failure::Failure;
use web_sys::js_sys::encode_uri_component;
use web_sys::wasm_bindgen::JsCast;
use web_sys::{HtmlElement, Window};

/// Lets the user choose a file. The page hands it to the editor when it is read.
///
/// # Errors
/// If the page has no element `file`, by which files are chosen.
pub(crate) fn ask_for_file() -> Result<(), Failure> {
    let document = window()?.document();
    let element = document.and_then(|document| document.get_element_by_id("file"));
    let element = element.and_then(|element| element.dyn_into::<HtmlElement>().ok());
    let element = element.ok_or_else(|| Failure::internal("the page has no element `file`"))?;
    element.click();
    Ok(())
}

/// The address of this page with a text that it is to open.
///
/// # Errors
/// If the page has no address.
pub(crate) fn link_to(text: &str) -> Result<String, Failure> {
    let address = window()?.location().href();
    let address = address.map_err(|_| Failure::internal("the page has no address"))?;
    let page = address.split(['#', '?']).next().unwrap_or_default();
    let text = String::from(encode_uri_component(text));
    Ok(format!("{page}#text={text}"))
}

fn window() -> Result<Window, Failure> {
    web_sys::window().ok_or_else(|| Failure::internal("there is no page"))
}
