//! Files that a browser downloads from its page.

use crate::failure::Failure;
use std::path::Path;
use web_sys::js_sys::{Array, Uint8Array};
use web_sys::wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, HtmlElement, Url};

/// Lets the browser download a file of this name.
///
/// # Errors
/// If it does not.
pub(crate) fn replace(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    download(path, bytes).map_err(|error| {
        let path = path.display();
        Failure::file(format!("the browser cannot download `{path}`: {error:?}"))
    })
}

/// Clicks a link to the bytes.
fn download(path: &Path, bytes: &[u8]) -> Result<(), JsValue> {
    let parts = Array::of1(&Uint8Array::from(bytes));
    let blob = Blob::new_with_u8_array_sequence(&parts)?;
    let address = Url::create_object_url_with_blob(&blob)?;
    let document = web_sys::window().and_then(|window| window.document());
    let document = document.ok_or("there is no page")?;
    let link = document.create_element("a")?;
    link.set_attribute("href", &address)?;
    let name = path.file_name().unwrap_or_default();
    link.set_attribute("download", &name.to_string_lossy())?;
    link.dyn_into::<HtmlElement>()?.click();
    // The browser may read the bytes later: they go with the page.
    Ok(())
}
