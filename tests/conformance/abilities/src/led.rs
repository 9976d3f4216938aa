//! Points that are led, and motors that follow.

in_both_precisions! {
    {
        /// Two arms that carry a pen along its path.
        Plotter {
            link left; link right; link rod; link pen { point tip = (0, 4); }
            joint l = revolute(ground, left) at (-1, 0);
            joint r = revolute(ground, right) at (1, 0);
            joint lk = revolute(left, pen) at (-2.4, 1.8);
            joint rk = revolute(right, rod) at (2.4, 1.8);
            joint tip = revolute(pen, rod) at (0, 4);
            motor l;
            motor r;
            follow pen.tip by l, r;
            path pen.tip = (cos(t), 3.3 + 0.6 * sin(2 * t));
            effects { velocity; acceleration; }
        }
        /// A link with its angle, on a slide that a wheel drives by its rack.
        Hand {
            link slide; link wheel; link arm; link hand { point tool = (3, 2); }
            joint s = prismatic(ground, slide) at (0, 0) along (1, 0);
            joint w = revolute(ground, wheel) at (0, -1);
            joint g = rack(wheel, slide, radius 1);
            joint a = revolute(slide, arm) at (0, 0);
            joint h = revolute(arm, hand) at (1, 2);
            motor w;
            motor a;
            motor h;
            follow hand.tool by w, a, h;
        }
        /// More motors than needed, one with a range.
        Snake {
            link first; link second; link third { point tip = (4, 1); }
            joint a = revolute(ground, first) at (0, 0);
            joint b = revolute(first, second) at (2, 0);
            joint c = revolute(second, third) at (3, 0);
            motor a;
            motor b in -10 deg ..= 20 deg;
            motor c;
            follow third.tip by a, b, c least;
            effects { velocity; }
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::BAD;
    use core::hint::black_box;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        let (mut plotter, mut hand, mut snake) = (Plotter::new(), Hand::new(), Snake::new());
        for number in [0.0, 0.3, -0.7, 1.6, 40.0].into_iter().chain(BAD) {
            let number = black_box(number);
            recorder.record("path", &(plotter.at_time(number), plotter.motors(), plotter.poses()));
            recorder.record("path", &(plotter.velocities(), plotter.accelerations()));
            #[allow(clippy::cast_possible_truncation, clippy::allow_attributes, reason = "in one of both precisions")]
            let number = number as _;
            recorder.record("plotter", &(plotter.reach([number, 3.1]), plotter.motors(), plotter.poses()));
            let led = plotter.reach_with([0.1, 3.0], [number, 1.0], [1.0, number]);
            recorder.record("plotter", &(led, plotter.velocities(), plotter.accelerations()));
            recorder.record("hand", &(hand.reach([number, 2.0, 0.5 * number]), hand.motors(), hand.poses()));
            recorder.record("snake", &(snake.reach([3.5, number]), snake.motors(), snake.poses()));
            let led = snake.reach_with([3.5, 1.0], [number, 1.0]);
            recorder.record("snake", &(led, snake.motors(), snake.velocities()));
        }
    }
}
