//! A four-bar linkage written by hand, in closed form: what the gallery is tested with.

use mech_runtime::{
    Blocked, Cause, Cost, JointInfo, Mechanism, Outline, Palette, Pose, Reached, Shape,
};

const CRANK: f64 = 1.0;
const COUPLER: f64 = 3.0;
const ROCKER: f64 = 2.5;
const GROUND: f64 = 3.5;

#[derive(Clone)]
pub(crate) struct FourBar {
    motors: [f64; 1],
    poses: [Pose<f64>; 3],
}

const fn disc(link: usize, center: [f64; 2], radius: f64, color: u8) -> Shape<f64> {
    Shape { link, outline: Outline::Circle { center, radius }, color }
}

const fn polygon(link: usize, corners: &'static [[f64; 2]], color: u8) -> Shape<f64> {
    Shape { link, outline: Outline::Polygon(corners), color }
}

impl Mechanism for FourBar {
    type Scalar = f64;
    type Motors = [f64; 1];
    type Joints = [Option<f64>; 0];

    const NAME: &'static str = "FourBar";
    const REPORT: &'static str =
        "mobility 1 = 3 × 3 − 2 × 4\nloop 1: a, b, c, d; closed form <RRR> & \"exact\"\n";
    const COST: Cost = Cost {
        additions: 15,
        multiplications: 10,
        divisions: 6,
        square_roots: 1,
        sine_cosine_pairs: 1,
        arctangents: 0,
        selections: 2,
    };
    const LOOP_COSTS: &'static [Cost] = &[];
    const MOTORS: &'static [&'static str] = &["a"];
    const LINKS: &'static [&'static str] = &["crank", "coupler", "rocker"];
    const JOINTS: &'static [JointInfo<f64>] = &[];
    const SHAPES: &'static [Shape<f64>] = &[
        polygon(0, &[[-0.9, -0.62], [4.4, -0.62], [4.4, -0.5], [-0.9, -0.5]], Palette::HATCH),
        polygon(0, &[[-0.45, -0.5], [0.45, -0.5], [0.2, 0.1], [-0.2, 0.1]], Palette::GROUND),
        polygon(0, &[[3.05, -0.5], [3.95, -0.5], [3.7, 0.1], [3.3, 0.1]], Palette::GROUND),
        polygon(
            2,
            &[[0.0, -0.17], [3.0, -0.17], [3.15, 0.1], [1.85, 1.6], [1.55, 1.6], [-0.15, 0.1]],
            Palette::lighter(Palette::TEAL),
        ),
        polygon(2, &[[0.0, -0.17], [3.0, -0.17], [3.0, 0.17], [0.0, 0.17]], Palette::TEAL),
        disc(2, [0.0, 0.0], 0.17, Palette::TEAL),
        disc(2, [3.0, 0.0], 0.17, Palette::TEAL),
        disc(2, [1.7, 1.5], 0.14, Palette::RED),
        polygon(3, &[[0.0, -0.18], [2.5, -0.18], [2.5, 0.18], [0.0, 0.18]], Palette::ORANGE),
        disc(3, [0.0, 0.0], 0.3, Palette::ORANGE),
        disc(3, [2.5, 0.0], 0.18, Palette::ORANGE),
        disc(1, [0.0, 0.0], 0.42, Palette::darker(Palette::BLUE)),
        polygon(1, &[[0.0, -0.2], [1.0, -0.2], [1.0, 0.2], [0.0, 0.2]], Palette::BLUE),
        disc(1, [0.0, 0.0], 0.3, Palette::BLUE),
        disc(1, [1.0, 0.0], 0.2, Palette::BLUE),
        disc(1, [0.0, 0.0], 0.1, Palette::INK),
        disc(1, [0.0, 0.0], 0.04, Palette::EYE),
        disc(1, [1.0, 0.0], 0.1, Palette::INK),
        disc(1, [1.0, 0.0], 0.04, Palette::EYE),
        disc(3, [2.5, 0.0], 0.1, Palette::INK),
        disc(3, [2.5, 0.0], 0.04, Palette::EYE),
        disc(3, [0.0, 0.0], 0.1, Palette::INK),
        disc(3, [0.0, 0.0], 0.04, Palette::EYE),
    ];
    const EXTENT: [[f64; 2]; 2] = [[-1.0; 2], [1.0; 2]];

    fn new() -> Self {
        let mut new = Self { motors: [0.0], poses: [Pose::identity(); 3] };
        new.move_to([0.0]).expect("it can be assembled");
        new
    }

    fn motors(&self) -> [f64; 1] {
        self.motors
    }

    fn joints(&self) -> [Option<f64>; 0] {
        []
    }

    fn move_toward(&mut self, motors: [f64; 1]) -> Result<Reached<[f64; 1]>, Blocked<[f64; 1]>> {
        self.move_to(motors).map(|()| Reached::Target)
    }

    fn move_to(&mut self, motors: [f64; 1]) -> Result<(), Blocked<[f64; 1]>> {
        let [angle] = motors;
        if !angle.is_finite() {
            return Err(Blocked::new("a", Cause::NotFinite, self.motors));
        }
        let (sin, cos) = angle.sin_cos();
        let [x, y] = [CRANK * cos, CRANK * sin];
        let [to_x, to_y] = [GROUND - x, -y];
        let square = to_x * to_x + to_y * to_y;
        let along = (COUPLER * COUPLER - ROCKER * ROCKER + square) / (2.0 * square);
        let aside = COUPLER * COUPLER / square - along * along;
        // One turn only, so that it can be blocked in a test.
        if aside < 0.0 || angle.abs() > 7.0 {
            return Err(Blocked::new("a, b, c, d", Cause::Open, self.motors));
        }
        let aside = aside.sqrt();
        let pin = [x + along * to_x - aside * to_y, y + along * to_y + aside * to_x];
        self.motors = motors;
        self.poses = [
            Pose { cos, sin, x: 0.0, y: 0.0 },
            Pose { cos: (pin[0] - x) / COUPLER, sin: (pin[1] - y) / COUPLER, x, y },
            Pose { cos: (pin[0] - GROUND) / ROCKER, sin: pin[1] / ROCKER, x: GROUND, y: 0.0 },
        ];
        Ok(())
    }

    fn poses(&self) -> &[Pose<f64>] {
        &self.poses
    }
}
