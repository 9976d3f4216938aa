//! A worker with which the window shares no memory does what one in the same program does.

use mech_studio::editor::{Editor, Item, Port, Server};
use mech_studio::play::{Control, Layer};
use mech_studio::{Command, Workspace};
use std::cell::RefCell;
use std::rc::Rc;

/// The server at the other end of a wire, and what it has told.
#[derive(Default)]
struct Wire {
    server: Server,
    told: Vec<Vec<u8>>,
}

/// The window's end of the wire.
struct End(Rc<RefCell<Wire>>);

impl Port for End {
    fn post(&mut self, call: Vec<u8>) -> Result<(), String> {
        let wire = &mut *self.0.borrow_mut();
        wire.told.extend(wire.server.take(&call));
        Ok(())
    }

    fn restart(&mut self) -> Result<(), String> {
        self.0.take();
        Ok(())
    }
}

/// Does everything there is to do at the other end.
fn settle(editor: &mut Editor, wire: &RefCell<Wire>) {
    loop {
        let told = {
            let wire = &mut *wire.borrow_mut();
            if !wire.server.is_done() {
                let begun = wire.server.begin();
                let found = wire.server.go_on();
                wire.told.extend(begun.into_iter().chain(found));
            }
            std::mem::take(&mut wire.told)
        };
        if told.is_empty() && wire.borrow().server.is_done() {
            return;
        }
        for reply in told {
            editor.hear(&reply);
        }
        editor.look();
    }
}

const TEXT: &str = "struct A;
link crank { point tip = (1, 1); } link rod; link rocker;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (0, 1);
joint c = revolute(rod, rocker) at (3, 2);
joint d = revolute(ground, rocker) at (3, 0);
motor a;
effects { trace crank.tip 8; }
";

/// Somebody's work, step by step; what is waited for is done between the steps.
const STEPS: [fn(&mut Editor); 17] = [
    |editor| editor.type_text(TEXT),
    |editor| editor.sight_mut().obey(Control::PlayOrPause),
    |editor| editor.sight_mut().obey(Control::Toggle(Layer::Velocities)),
    |editor| editor.sight_mut().scrub(0, 0.4),
    |editor| editor.begin_drag(&Item::Joint("b".to_owned()), false),
    |editor| editor.drag_to([0.1, 1.1]),
    Editor::end_drag,
    |editor| editor.sight_mut().obey(Control::Reset),
    |editor| editor.begin_drag(&Item::Joint("b".to_owned()), false),
    |editor| editor.drag_to([0.1, 1.1]),
    Editor::end_drag,
    |editor| editor.say("check"),
    |editor| editor.say("move d to (3.1, 0.1)"),
    |editor| editor.say("remove joint c"),
    |editor| editor.perform(Command::Repair { number: 1 }),
    Editor::undo,
    |editor| editor.say("nonsense"),
];

fn seen(editor: &Editor) -> String {
    let drawing = editor.drawing().map(|drawing| {
        let handles = drawing.handles();
        handles.map(|one| format!("{one:?}")).collect::<Vec<_>>()
    });
    let player = editor.player();
    let mendings = editor.mendings().iter().map(|mending| &*mending.words);
    format!(
        "{}\n{drawing:?}\n{:?}\n{:?}\n{:?}\n{:?}\n{:?}",
        editor.workspace().text(),
        player.map(|player| player.motors().to_vec()),
        player.map(|player| player.mechanism().bounds()),
        editor.notice(),
        editor.messages(),
        mendings.collect::<Vec<_>>(),
    )
}

#[test]
fn a_remote_worker_does_what_one_here_does() {
    let start = || Workspace::unsaved("a.mech", "");
    let wire = Rc::new(RefCell::new(Wire::default()));
    let mut remote = Editor::remote(start(), Box::new(End(wire.clone())));
    let mut here = Editor::immediate(start());
    for (number, step) in STEPS.into_iter().enumerate() {
        step(&mut here);
        step(&mut remote);
        settle(&mut remote, &wire);
        assert_eq!(seen(&remote), seen(&here), "after step {number}");
    }
    remote.hear(b"nonsense");
    remote.look();
    assert!(remote.notice().is_some_and(|notice| notice.is_refusal));
}
