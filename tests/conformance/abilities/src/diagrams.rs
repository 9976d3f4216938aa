//! Diagrams: the symbols of everything there is, arrows, traces.

in_both_precisions! {
    {
        /// With a joint of each kind, and a shape of each.
        Everything {
            ground {
                point m = (-3, 0); point o = (0, 0); line bore = (0, 0) -> (1, 0); line guide = (0, 3) -> (0, 1); point v = (6, 2);
                line bed = (0, -1) -> (1, 0);
                polygon [(-4, -3), (8, -3), (8, -2.5), (-4, -2.5)] on plane 0 color 1;
            }
            link pinion { point o = (0, 0); ring (0, 0) radius 0.6 hole 0.3 on plane 3; }
            link wheel { point o = (0, 0); point pin = (1, 0); circle (0, 0) radius 1.4 on plane 1 color 3; }
            link rod { point big = (0, 0); point small = (4, 0); point mark = (2, 0.5); bar [(0, 0), (4, 0)] width 0.3 on plane 2; mass 1; }
            link piston {
                point pin = (0, 0); point peg = (0.5, 0.3); line axis = (0, 0) -> (1, 0); line cross = (0, 0) -> (0, 1); mass 2;
            }
            link valve { line stem = (0, 0) -> (0, 1); }
            link lever { point v = (0, 0); line way = (0, 0) -> (-1, 0); }
            link bar { line bed = (0, 0) -> (1, 0); }
            link pulley { point v = (0, 0); }
            link plate { point v = (0, 0); point tip = (1, 1); }
            link slide { line cross = (0, 0) -> (0, 1); }
            joint d = revolute(ground.m, pinion.o);
            joint e = revolute(ground.o, wheel.o);
            joint mesh = gear(pinion, wheel, 20 : 40);
            joint f = revolute(wheel.pin, rod.big);
            joint g = revolute(rod.small, piston.pin);
            joint h = prismatic(ground.bore, piston.axis);
            joint i = prismatic(ground.guide, valve.stem);
            joint k = cam(e, i, 0.3 * sin(q) * sin(q));
            joint l = revolute(ground.v, lever.v);
            joint n = slot(piston.peg, lever.way);
            joint p = prismatic(ground.bed, bar.bed);
            joint r = rack(wheel, bar, radius 1);
            joint s = revolute(ground.v, pulley.v);
            joint t = belt(wheel, pulley, 1 : 2);
            joint w = weld(pulley.v, plate.v);
            joint y = prismatic(piston.cross, slide.cross);
            motor d;
            motor y;
            start { rod near 0 deg; lever near 45 deg; }
            gravity (0, -9.81);
            load push = force(rod.mark);
            load twist = torque(rod);
            effects { velocity; acceleration; force; overlay; trace rod.mark 40 on plane 1 color 5; }
            quality smooth;
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use mech_probes::{Panel, sum};
    use core::hint::black_box;
    use mech_runtime::overlay::Arrows;
    use mech_runtime::raster::embedded::{Screen, rgb};
    use mech_runtime::{Canvas, Frame, Mechanism, Overlay, Palette, Real, Stage, View};

    /// A number of the mechanism's.
    type Number = <Everything as Mechanism>::Scalar;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        let mut m = Everything::new();
        for value in [0.3, 0.6, 0.9, 1.2, 1.5, 1.8] {
            let value = Real::from_f64(black_box(value));
            let moved = m.move_with([value, value], [1.0, 0.5].map(black_box), [0.5, -0.5]);
            recorder.record("diagram", &(moved, m.set_push([value, -value]), m.set_twist(value)));
        }
        let mut frame = Frame::<160, 120>::new();
        let mut smooth = Everything::picture::<120, 90>();
        let mut stage = Stage::<160, 120>::new();
        let mut panel = Panel::new();
        let view = Everything::view(black_box(160), black_box(120));
        for size in [1.0, 2.5, -1.0, 1e9, f64::NAN] {
            let size = black_box(size);
            frame.look_at(View::new(view.center(), size * view.scale()));
            frame.clear();
            drawn(&m, size, &mut frame);
            let frame = sum(frame.pixels().iter().flatten().copied().map(u16::from));

            smooth.clear();
            drawn(&m, size, &mut smooth);
            let smooth = sum(smooth.pixels().iter().flatten().flatten().copied().map(u16::from));

            stage.look_at(view);
            stage.show(|pass| drawn(&m, size, pass));
            let pixels = stage.frame().pixels().iter().flatten();
            let stage = sum(pixels.copied().map(u16::from));

            let mut screen = Screen::new(&mut panel, view, rgb);
            screen.clear();
            drawn(&m, size, &mut screen);
            let Ok(()) = screen.finish();
            recorder.record("diagram", &((frame, smooth), (stage, panel.sum())));
        }
    }

    /// Draws all that there is to be drawn.
    fn drawn(m: &Everything, size: f64, canvas: &mut impl Canvas<Number>) {
        let (size, thickness) = (Number::from_f64(size), f32::from_f64(size));
        let overlay = Overlay::new().links(true).axes(true).joints(true).motors(true);
        m.draw(canvas);
        m.draw_overlay(canvas, &overlay.size(thickness).colors(Palette::INK, Palette::EYE));
        m.draw_velocities(canvas, &Arrows::new(size, Palette::BLUE).size(thickness));
        m.draw_accelerations(canvas, &Arrows::new(size, Palette::RED));
        m.draw_loads(canvas, &Arrows::new(size, Palette::ORANGE));
        if let Ok(forces) = m.forces([1.0, 0.5].map(black_box), [0.5, 1.0]) {
            m.draw_reactions(canvas, &Arrows::new(size, Palette::TEAL), &forces);
        }
    }
}
