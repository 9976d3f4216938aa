//! Files that a browser downloads from its page.

use super::kind::Output;
use crate::failure::Failure;
use std::path::Path;
use web_sys::js_sys::{Array, Uint8Array};
use web_sys::wasm_bindgen::{JsCast, JsValue};
use web_sys::{Blob, HtmlElement, Url};

/// Lets the browser download files. Each is a new one, whatever its name.
#[derive(Default)]
pub(crate) struct Writer;

impl Writer {
    /// Lets the browser download a file.
    #[expect(clippy::unused_self, reason = "as with files on a disk")]
    pub(crate) fn write(&mut self, output: Output) -> Result<(), Failure> {
        download(&output.path, &output.bytes).map_err(|error| {
            let path = output.path.display();
            Failure::file(format!("the browser cannot download `{path}`: {error:?}"))
        })
    }

    /// Returns false: files are downloaded at once.
    #[expect(clippy::unused_self, reason = "as with files on a disk")]
    pub(crate) const fn is_deferred(&self) -> bool {
        false
    }
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
