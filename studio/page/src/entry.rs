//! What the page calls.

use crate::page::Page;
use crate::worker::PageWorker;
use eframe::web_sys::HtmlCanvasElement;
use eframe::web_sys::js_sys::Function;
use eframe::{AppCreator, WebOptions, WebRunner};
use mech_studio::LONGEST;
use mech_studio::editor::Editor;
use std::path::Path;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

/// The editor that runs in a canvas.
#[wasm_bindgen]
pub struct Running(WebRunner);

/// Runs the editor in a canvas, with a text that has this name; without a name with an example. Tasks go to a worker by `post`; `restart`
/// puts another in its place.
///
/// # Errors
/// If the browser has no WebGL.
#[wasm_bindgen]
pub async fn start(
    canvas: HtmlCanvasElement,
    name: Option<String>,
    text: String,
    post: Function,
    restart: Function,
) -> Result<Running, JsValue> {
    let runner = WebRunner::new();
    let worker = PageWorker { post, restart };
    let app: AppCreator<'static> = Box::new(move |made| {
        let page = Page::new(name.as_deref(), &text, worker, made.egui_ctx.clone());
        Ok(Box::new(page?))
    });
    runner.start(canvas, WebOptions::default(), app).await?;
    Ok(Running(runner))
}

/// The number of characters of the longest text that is opened.
#[wasm_bindgen]
#[must_use]
pub fn longest_text() -> f64 {
    LONGEST as f64
}

/// Why a file of so many bytes is not opened, if it is not.
#[wasm_bindgen]
#[must_use]
pub fn refusal_of(name: &str, bytes: f64) -> Option<String> {
    Editor::refusal_of(Path::new(name), bytes as u64)
}

#[wasm_bindgen]
impl Running {
    /// Tells the user why something is refused.
    pub fn refuse(&self, why: &str) {
        if let Some(mut page) = self.0.app_mut::<Page>() {
            page.refuse(why);
        }
    }

    /// Gives the editor a file that the user has chosen.
    pub fn take(&self, name: &str, bytes: Vec<u8>) {
        if let Some(mut page) = self.0.app_mut::<Page>() {
            page.take(name, bytes);
        }
    }

    /// Takes what the worker tells.
    pub fn hear(&self, reply: &[u8]) {
        if let Some(mut page) = self.0.app_mut::<Page>() {
            page.hear(reply);
        }
    }

    /// Goes on without the worker, which broke: this is why.
    pub fn lose_worker(&self, why: &str) {
        if let Some(mut page) = self.0.app_mut::<Page>() {
            page.lose_worker(why);
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
