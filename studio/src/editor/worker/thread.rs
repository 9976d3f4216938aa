//! Threads beside the window.

use super::agenda::Agenda;
use super::{Finding, Task, Undone, Work};
use crate::failure::Failure;
use mech_compiler::cancel::Cancellation;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

/// A task, and the flag that ends it.
type Order = (Task, Cancellation);

/// Threads beside the window, and what they have found out.
pub(in crate::editor) struct Threads {
    tasks: Sender<Order>,
    /// The tasks that hold and lead, for a thread of their own: they do not wait for the analysis of earlier texts.
    drags: Sender<Order>,
    findings: Receiver<Finding>,
    /// For what is done beside both threads.
    outbox: Outbox,
    /// The flag that ends all that was given since the last stop.
    stop: Cancellation,
}

/// Where findings go: to the window, which is woken.
#[derive(Clone)]
struct Outbox {
    found: Sender<Finding>,
    wake: Arc<dyn Fn() + Send + Sync>,
}

impl Outbox {
    /// Sends it. Returns whether anybody listens: nobody does any more when the window is closed.
    fn send(&self, finding: Finding) -> bool {
        let is_heard = self.found.send(finding).is_ok();
        if is_heard {
            (self.wake)();
        }
        is_heard
    }
}

/// The stack of a thread, in bytes: the compiler goes as deep as the text that it reads.
const STACK: usize = 16 << 20;

impl Threads {
    /// Threads that call `wake` when they have found something out.
    pub(super) fn new(wake: impl Fn() + Send + Sync + 'static) -> std::io::Result<Self> {
        let (found, findings) = channel();
        let wake = Arc::new(wake);
        let outbox = Outbox { found, wake };
        let serve_in = |name: &str| {
            let (tasks, to_do) = channel();
            let outbox = outbox.clone();
            let thread = thread::Builder::new().name(name.to_owned());
            thread.stack_size(STACK).spawn(move || serve(&to_do, &outbox))?;
            std::io::Result::Ok(tasks)
        };
        Ok(Self {
            tasks: serve_in("analysis")?,
            drags: serve_in("drag")?,
            findings,
            outbox,
            stop: Cancellation::default(),
        })
    }

    pub(super) fn give(&self, task: Task) -> Result<(), Failure> {
        let order = (task, self.stop.clone());
        let to = match &order.0 {
            Task::Hold(..) | Task::Lead(..) => &self.drags,
            // A film takes its time, and nothing else waits for it.
            Task::Export(_) | Task::Ask(..) => {
                self.do_apart(order);
                return Ok(());
            }
            _ => &self.tasks,
        };
        let ended = |_| Failure::internal("the analysis beside the window has ended");
        to.send(order).map_err(ended)
    }

    /// Does a task in a thread of its own.
    fn do_apart(&self, order: Order) {
        let outbox = self.outbox.clone();
        let serve = move || {
            let mut agenda = Agenda::default();
            let (task, stop) = order;
            agenda.add(task);
            work_off(&mut agenda, &stop, &outbox);
        };
        let thread = thread::Builder::new().name("apart".to_owned());
        if let Err(error) = thread.stack_size(STACK).spawn(serve) {
            let failure = Failure::file(format!("nothing is done: {error}"));
            self.outbox.send(Finding::Undone(Undone::Else, failure));
        }
    }

    pub(super) fn stop(&mut self) {
        std::mem::take(&mut self.stop).set();
    }

    /// The next of what was found out. The window itself can tell, so that the channel never ends.
    pub(super) fn next(&self) -> Option<Finding> {
        self.findings.try_recv().ok()
    }
}

/// Does what comes, until nobody listens any more.
fn serve(to_do: &Receiver<Order>, outbox: &Outbox) {
    let mut agenda = Agenda::default();
    let mut stop = Cancellation::default();
    loop {
        if agenda.is_done() {
            match to_do.recv() {
                Ok(order) => take(order, &mut agenda, &mut stop),
                Err(_) => return,
            }
        }
        while let Ok(order) = to_do.try_recv() {
            take(order, &mut agenda, &mut stop);
        }
        if !work_off(&mut agenda, &stop, outbox) {
            return;
        }
    }
}

/// Notes a task. What was given before the last stop is not done any more.
fn take((task, its_stop): Order, agenda: &mut Agenda, stop: &mut Cancellation) {
    if its_stop.is_set() {
        return;
    }
    if stop.is_set() {
        agenda.clear();
    }
    *stop = its_stop;
    agenda.add(task);
}

/// Does the next piece. Returns whether anybody listens.
fn work_off(agenda: &mut Agenda, stop: &Cancellation, outbox: &Outbox) -> bool {
    let Some(work) = agenda.begin() else {
        return true;
    };
    // Nobody asks what a drag is doing: it is seen.
    let is_told = work != Work::Dragging;
    if is_told && !outbox.send(Finding::Begun(work.clone())) {
        return false;
    }
    let done = stop.heed(|| agenda.go_on());
    if stop.is_set() {
        agenda.clear();
    }
    let found = done.flatten().filter(|_| !stop.is_set());
    let found = found.map(|finding| match finding {
        Finding::Made(path, made) => Finding::Exported(made.and_then(|made| made.write(&path))),
        other => other,
    });
    let is_heard = found.is_none_or(|finding| outbox.send(finding));
    is_heard && (!is_told || outbox.send(Finding::Ended(work)))
}
