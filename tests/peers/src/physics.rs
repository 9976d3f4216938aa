//! The four-bar in the physics engine: rigid bodies, revolute joints and a motor that holds a speed, 60 steps a second.

use crate::{GROUND, exact};
use rapier2d::prelude::*;

/// How the bodies are joined.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Joints {
    /// Four joints, all of them solved by impulses.
    Impulse,
    /// A tree in reduced coordinates, and one impulse joint that closes the loop.
    Multibody,
}

pub(crate) struct World {
    world: PhysicsWorld,
    crank: RigidBodyHandle,
    coupler: RigidBodyHandle,
    /// From the coupler's origin to its other pin.
    along_coupler: [f64; 2],
    steps: f64,
    step: f64,
}

impl World {
    /// At a crank angle of zero, with a motor that turns it by so many degrees a step.
    pub(crate) fn new(joints: Joints, degrees: f64) -> Self {
        let mut world = PhysicsWorld { gravity: Vector::new(0.0, 0.0), ..PhysicsWorld::default() };
        assert_eq!(world.integration_parameters.dt, 1.0 / 60.0);
        let end = exact(0.0);
        // Every link is a thin rod, its origin at the pin nearer to its driver, its frame parallel to the ground's at the
        // start: from there the joints of a multibody count their angles.
        let mut rod = |x: f64, [end_x, end_y]: [f64; 2]| {
            let (middle, length) = (point([end_x / 2.0, end_y / 2.0]), end_x.hypot(end_y));
            let inertia = length * length * length / 12.0;
            let mass = MassProperties::new(middle, length as f32, inertia as f32);
            let body = RigidBodyBuilder::dynamic()
                .translation(point([x, 0.0]))
                .additional_mass_properties(mass)
                .can_sleep(false);
            world.bodies.insert(body)
        };
        let (along_coupler, along_rocker) = ([end[0] - 1.0, end[1]], [end[0] - GROUND, end[1]]);
        let crank = rod(0.0, [1.0, 0.0]);
        let coupler = rod(1.0, along_coupler);
        let rocker = rod(GROUND, along_rocker);
        let ground = world.bodies.insert(RigidBodyBuilder::fixed());
        let pin = |a: [f64; 2], b: [f64; 2]| {
            RevoluteJointBuilder::new()
                .local_anchor1(point(a))
                .local_anchor2(point(b))
                .contacts_enabled(false)
        };
        let speed = (degrees * 60.0).to_radians() as f32;
        let shaft = pin([0.0; 2], [0.0; 2]).motor_velocity(speed, 1e6);
        let pairs = [
            (ground, crank, shaft),
            (crank, coupler, pin([1.0, 0.0], [0.0; 2])),
            (ground, rocker, pin([GROUND, 0.0], [0.0; 2])),
        ];
        for (a, b, joint) in pairs {
            match joints {
                Joints::Impulse => {
                    world.impulse_joints.insert(a, b, joint, true);
                }
                Joints::Multibody => {
                    world.multibody_joints.insert(a, b, joint, true).expect("it is a tree");
                }
            }
        }
        world.impulse_joints.insert(coupler, rocker, pin(along_coupler, along_rocker), true);
        Self { world, crank, coupler, along_coupler, steps: 0.0, step: degrees.to_radians() }
    }

    pub(crate) fn step(&mut self) {
        self.world.step();
        self.steps += 1.0;
    }

    /// The crank's angle.
    pub(crate) fn crank(&self) -> f64 {
        f64::from(self.world.bodies[self.crank].rotation().angle())
    }

    /// By how much the crank is off.
    pub(crate) fn off(&self) -> f64 {
        let off = self.crank() - self.steps * self.step;
        off.sin().atan2(off.cos()).abs()
    }

    /// Where the coupler is pinned to the rocker.
    pub(crate) fn end(&self) -> [f64; 2] {
        let body = &self.world.bodies[self.coupler];
        let (at, angle) = (body.translation(), f64::from(body.rotation().angle()));
        let ((sin, cos), [x, y]) = (angle.sin_cos(), self.along_coupler);
        [f64::from(at.x) + cos * x - sin * y, f64::from(at.y) + sin * x + cos * y]
    }
}

fn point([x, y]: [f64; 2]) -> Vector {
    Vector::new(x as f32, y as f32)
}
