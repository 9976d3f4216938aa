//! The same chains as one system: Newton over all loops at once, with a dense matrix, as a general solver does it that
//! knows nothing of the order in which loops can be solved.

use mech_compiler::model::JointKind;
use mech_test_support::chain;
use nalgebra::{DMatrix, DVector};

/// A closed polygon: vectors, each fixed to a link that is driven or has an unknown direction, and one fixed to the ground.
struct Loop {
    driven: Vec<[f64; 2]>,
    unknown: Vec<(usize, [f64; 2])>,
    ground: [f64; 2],
}

pub(crate) struct Dense {
    loops: Vec<Loop>,
    /// By how much each link of unknown direction has turned since the start: cosine and sine.
    turned: Vec<[f64; 2]>,
    matrix: DMatrix<f64>,
    right: DVector<f64>,
}

fn rotate([c, s]: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    [c * x - s * y, s * x + c * y]
}

fn from([ax, ay]: [f64; 2], [bx, by]: [f64; 2]) -> [f64; 2] {
    [bx - ax, by - ay]
}

impl Dense {
    /// The chain as it is drawn: pins in the order crank's shaft, then for each loop crank or rocker to coupler, coupler to
    /// rocker, rocker to ground. The unknowns are the couplers and rockers in turn.
    pub(crate) fn chain(loops: usize) -> Self {
        let model = chain(loops);
        let pin = |joint: usize| match model.joints[joint].kind {
            JointKind::Revolute(axis, _) => model.axis(axis).at,
            _ => unreachable!("a chain has revolute joints only"),
        };
        let mut shaft = pin(0);
        let loops: Vec<Loop> = (0..loops)
            .map(|number| {
                let [input, top, next] = [1, 2, 3].map(|joint| pin(3 * number + joint));
                let mut unknown =
                    vec![(2 * number, from(input, top)), (2 * number + 1, from(top, next))];
                let mut driven = Vec::new();
                match number.checked_sub(1) {
                    None => driven.push(from(shaft, input)),
                    Some(last) => unknown.push((2 * last + 1, from(shaft, input))),
                }
                let ground = from(next, shaft);
                shaft = next;
                Loop { driven, unknown, ground }
            })
            .collect();
        let size = 2 * loops.len();
        Self {
            loops,
            turned: vec![[1.0, 0.0]; size],
            matrix: DMatrix::zeros(size, size),
            right: DVector::zeros(size),
        }
    }

    pub(crate) fn turned(&self) -> &[[f64; 2]] {
        &self.turned
    }

    /// Turns the crank to this angle from the start.
    pub(crate) fn move_to(&mut self, angle: f64) -> bool {
        let (sin, cos) = angle.sin_cos();
        for _ in 0..20 {
            self.matrix.fill(0.0);
            let mut worst = 0.0_f64;
            for (row, one) in self.loops.iter().enumerate() {
                let mut gap = one.ground;
                for vector in &one.driven {
                    let [x, y] = rotate([cos, sin], *vector);
                    gap = [gap[0] + x, gap[1] + y];
                }
                for (unknown, vector) in &one.unknown {
                    let [x, y] = rotate(self.turned[*unknown], *vector);
                    gap = [gap[0] + x, gap[1] + y];
                    self.matrix[(2 * row, *unknown)] -= y;
                    self.matrix[(2 * row + 1, *unknown)] += x;
                }
                (self.right[2 * row], self.right[2 * row + 1]) = (-gap[0], -gap[1]);
                worst = worst.max(gap[0].abs()).max(gap[1].abs());
            }
            if worst <= 1e-13 * self.loops.len() as f64 {
                return true;
            }
            let matrix = std::mem::replace(&mut self.matrix, DMatrix::zeros(0, 0));
            let lu = matrix.lu();
            let solved = lu.solve_mut(&mut self.right);
            let size = self.turned.len();
            self.matrix = DMatrix::zeros(size, size);
            if !solved {
                return false;
            }
            for (direction, turn) in self.turned.iter_mut().zip(&self.right) {
                let half = 0.5 * turn;
                let factor = 2.0 / (1.0 + half * half);
                *direction = rotate([factor - 1.0, half * factor], *direction);
            }
        }
        false
    }
}
