//! Loops of every kind, with dead points and change points.

in_both_precisions! {
    {
        /// Three revolute joints; it stops at dead points.
        DoubleRocker {
            link crank; link coupler; link rocker;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (1.8, 0.6);
            joint c = revolute(coupler, rocker) at (3.3, 2.9);
            joint d = revolute(ground, rocker) at (4, 0);
            motor a;
        }
        /// Two revolute joints and a slide.
        SliderCrank {
            link crank; link rod; link block;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, rod) at (1, 0.5);
            joint c = revolute(rod, block) at (4, 0);
            joint x = prismatic(ground, block) at (4, 0) along (1, 0);
            motor a;
        }
        /// The same, driven by its slide.
        Engine {
            link crank; link rod; link block;
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, rod) at (0.1, 1);
            joint c = revolute(rod, block) at (3, 0);
            joint x = prismatic(ground, block) at (3, 0) along (1, 0);
            motor x;
        }
        /// A slide between two revolute joints.
        QuickReturn {
            ground { point crank_shaft = (0, 2); point arm_shaft = (0, 0); }
            link crank { point shaft = (0, 0); point pin = (1, 0); }
            link arm { point shaft = (0, 0); line way = (0, 0) -> (1, 0); }
            joint a = revolute(ground.crank_shaft, crank.shaft);
            joint x = slot(crank.pin, arm.way);
            joint d = revolute(ground.arm_shaft, arm.shaft);
            motor a;
            start { arm near 63 deg; }
        }
        /// A revolute joint between two slides.
        Tangent {
            ground { point shaft = (0, 0); line wall = (2, 0) -> (0, 1); }
            link crank { point shaft = (0, 0); line way = (0, 0) -> (1, 0); }
            link block { point pin = (0, 0); line wall = (0, 0) -> (0, 1); }
            joint a = revolute(ground.shaft, crank.shaft);
            joint x = slot(block.pin, crank.way);
            joint y = prismatic(ground.wall, block.wall);
            motor a;
        }
        /// Two slides and a revolute joint.
        ScotchYoke {
            ground { point shaft = (0, 0); line rail = (0, 0) -> (1, 0); }
            link crank { point shaft = (0, 0); point pin = (1, 0); }
            link yoke { line rail = (0, 0) -> (1, 0); line way = (0, 0) -> (0, 1); }
            joint a = revolute(ground.shaft, crank.shaft);
            joint y = slot(crank.pin, yoke.way);
            joint x = prismatic(ground.rail, yoke.rail);
            motor a;
        }
        /// Slides alone.
        Wedge {
            link wedge;
            link follower { point tip = (2, 3); }
            joint x = prismatic(ground, wedge) at (0, 0) along (1, 0);
            joint face = prismatic(wedge, follower) at (2, 1) along (2, 1);
            joint y = prismatic(ground, follower) at (2, 2) along (0, 1);
            motor x;
        }
        /// It goes on through its change points.
        Parallelogram {
            link left; link right; link rail;
            joint a = revolute(ground, left) at (0, 0);
            joint b = revolute(left, rail) at (0.5, 1);
            joint c = revolute(rail, right) at (2.5, 1);
            joint d = revolute(ground, right) at (2, 0);
            motor a;
        }
        /// It keeps its branch.
        Kite {
            link left; link right; link rail;
            joint a = revolute(ground, left) at (0, 0);
            joint b = revolute(left, rail) at (0.5, 1);
            joint c = revolute(rail, right) at (2.5, 1);
            joint d = revolute(ground, right) at (2, 0);
            motor a;
            at change points keep branch;
        }
        /// It stops there.
        Cautious {
            link left; link right; link rail;
            joint a = revolute(ground, left) at (0, 0);
            joint b = revolute(left, rail) at (0.5, 1);
            joint c = revolute(rail, right) at (2.5, 1);
            joint d = revolute(ground, right) at (2, 0);
            motor a;
            at change points stop;
        }
        /// Two loops in a row, an arm, and a weld.
        Watt {
            link crank; link coupler; link bell; link rod; link rocker;
            link hand { point tip = (6, 5); }
            link arm { point end = (9, 5); }
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (0, 1.2);
            joint c = revolute(coupler, bell) at (3.7, 2.2);
            joint d = revolute(ground, bell) at (4, 0);
            joint e = revolute(bell, rod) at (6.4, 3);
            joint f = revolute(rod, rocker) at (8.6, 0.7);
            joint g = revolute(ground, rocker) at (6.7, 0);
            joint w = weld(rocker, hand) at (7, 1);
            joint s = prismatic(hand, arm) at (8, 4) along (1, 1);
            motor a;
            motor s;
        }
        /// More cranks than it takes.
        ThreeCranks {
            link first; link second; link third;
            link rail { point tip = (5, 2); }
            joint a = revolute(ground, first) at (0, 0);
            joint b = revolute(ground, second) at (2, 0);
            joint c = revolute(ground, third) at (4, 0);
            joint d = revolute(first, rail) at (0.5, 1);
            joint e = revolute(second, rail) at (2.5, 1);
            joint f = revolute(third, rail) at (4.5, 1);
            motor a;
            allow redundant;
        }
    }

    use mech_probes::Listener;
    use crate::recorder::Recorder;
    use crate::moves::all_moves;

    pub(super) fn ask(recorder: &mut Recorder<impl Listener>) {
        all_moves::<DoubleRocker>(recorder, 0.3);
        all_moves::<SliderCrank>(recorder, 0.7);
        all_moves::<Engine>(recorder, 0.3);
        all_moves::<QuickReturn>(recorder, 0.4);
        all_moves::<Tangent>(recorder, 0.2);
        all_moves::<ScotchYoke>(recorder, 0.6);
        all_moves::<Wedge>(recorder, 0.1);
        all_moves::<Parallelogram>(recorder, 0.4);
        all_moves::<Kite>(recorder, 0.4);
        all_moves::<Cautious>(recorder, 0.4);
        all_moves::<Watt>(recorder, 0.3);
        all_moves::<ThreeCranks>(recorder, 0.2);
    }
}
