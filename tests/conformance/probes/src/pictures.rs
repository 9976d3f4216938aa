//! What a mechanism looks like.

use crate::panel::sum;
use crate::{Listener, Panel, Probed, STEPS, phase, precision};
use mech_runtime::raster::embedded::{Screen, rgb};
use mech_runtime::{Frame, Stage};

/// A picture is looked at after every so many steps.
const STRIDE: u16 = 60;

/// Moves a mechanism through its motion and tells check sums of some pictures of it: on a frame, on a display that it is painted on
/// itself, on one that shows the frame, and on one that is sent what has changed.
pub fn pictures<M: Probed>(listener: &mut impl Listener) {
    let mut mechanism = M::new();
    let view = M::view(Panel::SIDE, Panel::SIDE);
    let mut frame = Frame::<{ Panel::SIDE }, { Panel::SIDE }>::new();
    let mut panel = Panel::new();
    let mut stage = Stage::<{ Panel::SIDE }, { Panel::SIDE }>::new();
    let mut sent = Panel::new();
    frame.look_at(view);
    stage.look_at(view);
    for step in 0..STEPS {
        let moved = mechanism.move_to(M::motion(phase(step)));
        if moved.is_err() || !step.is_multiple_of(STRIDE) {
            continue;
        }
        listener.begin("picture", M::LABEL, precision::<M>());

        frame.clear();
        mechanism.draw(&mut frame);
        listener.word(sum(frame.pixels().iter().flatten().copied().map(u16::from)));

        let mut screen = Screen::new(&mut panel, view, rgb);
        screen.clear();
        mechanism.draw(&mut screen);
        let Ok(()) = screen.finish();
        listener.word(panel.sum());

        let Ok(()) = frame.show(&mut panel, rgb);
        listener.word(panel.sum());

        stage.show(|canvas| mechanism.draw(canvas));
        for area in stage.changed() {
            let Ok(()) = stage.frame().show_part(&mut sent, &area.into(), rgb);
        }
        listener.word(sent.sum());
        listener.end();
    }
}
