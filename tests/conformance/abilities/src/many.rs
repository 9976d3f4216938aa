//! Many positions at once.

in_both_precisions! {
    {
        /// A function of its motor, side by side.
        SideBySide {
            link crank; link coupler; link rocker;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (0.8, 0.6);
            joint c = revolute(coupler, rocker) at (3.3, 2.9);
            joint d = revolute(ground, rocker) at (4, 0);
            motor a;
        }
        /// One after the other: through change points.
        OneByOne {
            link left; link right; link rail { point tip = (1, 2); }
            joint a = revolute(ground, left) at (0, 0);
            joint b = revolute(left, rail) at (0.5, 1);
            joint c = revolute(rail, right) at (2.5, 1);
            joint d = revolute(ground, right) at (2, 0);
            motor a;
            effects { velocity; trace rail.tip 4; }
        }
        /// Within a range.
        Within {
            link crank; link rod; link arm;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, rod) at (0, 0.5);
            joint c = revolute(rod, arm) at (3, 1);
            joint d = revolute(ground, arm) at (3, 0);
            motor a in 0 deg ..= 360 deg;
        }
        /// With a param.
        Changing {
            param length = 3.5;
            ground { point a = (0, 0); point d = (4, 0); }
            link crank { point a = (0, 0); point b = (1, 0); }
            link coupler { point b = (0, 0); point c = (length, 0); }
            link rocker { point d = (0, 0); point c = (3, 0); }
            joint a = revolute(ground.a, crank.a);
            joint b = revolute(crank.b, coupler.b);
            joint c = revolute(coupler.c, rocker.c);
            joint d = revolute(ground.d, rocker.d);
            motor a;
            start { coupler near 50 deg; }
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use core::array;
    use core::hint::black_box;
    use mech_runtime::{Columns, Mechanism, Real};

    /// Positions: more than are computed side by side, and a rest.
    const COUNT: usize = 21;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        macro_rules! many {
            ($mechanism:ty) => {
                for worst in [0.1, 1e4, f64::NAN, 1e30] {
                    let motors = motors(black_box(worst));
                    for room in [COUNT, COUNT - 2, 0] {
                        let mut buffer = [Real::from_f64(0.0); 4 * 3 * COUNT];
                        let columns = Columns::new(&mut buffer, black_box(room));
                        if let Some(mut columns) = columns {
                            let outcome = <$mechanism>::new().solve_many(&motors, &mut columns);
                            recorder.record(<$mechanism>::NAME, &outcome);
                            let pose = columns.pose(black_box(2), black_box(17));
                            let point = columns.point(black_box(3), black_box(17), [1.0, 2.0]);
                            recorder.record(<$mechanism>::NAME, &(pose, point));
                            for link in 0..3 {
                                recorder.record(<$mechanism>::NAME, &columns.link(link));
                            }
                        }
                    }
                    let mut instances: [$mechanism; COUNT] = array::from_fn(|_| <$mechanism>::new());
                    let outcome = <$mechanism>::move_many(&mut instances, &motors);
                    recorder.record(<$mechanism>::NAME, &outcome);
                    for instance in &instances {
                        recorder.record(<$mechanism>::NAME, &instance.poses());
                    }
                }
            };
        }
        many!(SideBySide);
        many!(OneByOne);
        many!(Within);
        many!(Changing);
        let mut short = [Real::from_f64(0.0); 5];
        let columns: Option<Columns<'_, f64, 3>> = Columns::new(&mut short, black_box(usize::MAX));
        recorder.record("columns", &columns.is_some());
    }

    /// So many, one of them bad perhaps.
    fn motors<T: Real>(worst: f64) -> [[T; 1]; COUNT] {
        let mut number = 0.0;
        array::from_fn(|index| {
            number += 0.29;
            [T::from_f64(if index == 18 { worst } else { number })]
        })
    }
}
