//! What the page calls.

use crate::page::Page;
use eframe::web_sys::HtmlCanvasElement;
use eframe::{AppCreator, WebOptions, WebRunner};
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// The editor that runs in a canvas.
#[wasm_bindgen]
pub struct Running(WebRunner);

/// Runs the editor in a canvas, with a text that has this name; without a name with an example.
///
/// # Errors
/// If the browser has no WebGL.
#[wasm_bindgen]
pub async fn start(
    canvas: HtmlCanvasElement,
    name: Option<String>,
    text: String,
) -> Result<Running, JsValue> {
    let runner = WebRunner::new();
    let app: AppCreator<'static> = Box::new(move |made| {
        let page = Page::new(name.as_deref(), &text, made.egui_ctx.clone());
        Ok(Box::new(page?))
    });
    runner.start(canvas, WebOptions::default(), app).await?;
    Ok(Running(runner))
}

#[wasm_bindgen]
impl Running {
    /// Gives the editor a file that the user has chosen.
    pub fn take(&self, name: &str, bytes: Vec<u8>) {
        if let Some(mut page) = self.0.app_mut::<Page>() {
            page.take(name, bytes);
        }
    }

    /// Whether something is lost if the page is left.
    #[must_use]
    pub fn has_work(&self) -> bool {
        self.0.app_mut::<Page>().is_some_and(|page| page.has_work())
    }

    /// What broke the editor, if something did: it does not go on then.
    #[must_use]
    pub fn panic(&self) -> Option<String> {
        self.0.panic_summary().map(|panic| panic.message())
    }
}
