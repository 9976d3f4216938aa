//! The worker that analyses, so that the page never waits: both of its sides.

use eframe::web_sys::js_sys::{Function, Uint8Array};
use mech_studio::editor::{Port, Server};
use std::cell::RefCell;
use wasm_bindgen::JsValue;
use wasm_bindgen::prelude::wasm_bindgen;

/// The page's side: functions of the page.
pub(crate) struct PageWorker {
    pub(crate) post: Function,
    pub(crate) restart: Function,
}

impl Port for PageWorker {
    fn post(&mut self, call: Vec<u8>) -> Result<(), String> {
        let call = Uint8Array::from(&*call);
        called(self.post.call1(&JsValue::NULL, &call))
    }

    fn restart(&mut self) -> Result<(), String> {
        called(self.restart.call0(&JsValue::NULL))
    }
}

fn called(done: Result<JsValue, JsValue>) -> Result<(), String> {
    done.map(drop).map_err(|error| format!("{error:?}"))
}

thread_local! {
    /// What broke in the worker.
    static BROKEN: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// The worker's side.
#[wasm_bindgen]
#[derive(Default)]
pub struct Analyst(Server);

#[wasm_bindgen]
impl Analyst {
    /// One that has nothing to do yet.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        std::panic::set_hook(Box::new(|panic| {
            BROKEN.set(Some(panic.to_string()));
        }));
        Self::default()
    }

    /// Takes a task. Gives what the page is to be told, if it cannot be read.
    pub fn take(&mut self, call: &[u8]) -> Option<Vec<u8>> {
        self.0.take(call)
    }

    /// Takes up the next piece. Gives what the page is to be told before it is done; nothing if there is nothing to do.
    pub fn begin(&mut self) -> Option<Vec<u8>> {
        self.0.begin()
    }

    /// Does the piece that was taken up. Gives what the page is to be told.
    pub fn go_on(&mut self) -> Vec<Uint8Array> {
        let replies = self.0.go_on();
        replies.iter().map(|reply| Uint8Array::from(&**reply)).collect()
    }
}

/// What broke in the worker, if something did.
#[wasm_bindgen]
#[must_use]
pub fn broken() -> Option<String> {
    BROKEN.take()
}
