//! Rates of a mechanism: methods are there when they were asked for.

use mech_runtime::{Acceleration, Vector2, Velocity, mechanism};

mechanism! {
    pub struct Crank: f32;

    ground { point o = (0.0, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (2.0, 0.0); }
    joint a = revolute(ground.o, crank.shaft);
    motor a;
    start { a = 0 deg; }
    effects { velocity; acceleration; }
}

fn main() {
    let mut crank = Crank::new();
    crank.move_with([0.0], [3.0], [1.0]).expect("it turns");
    let velocity: Velocity<f32> = crank.crank_velocity();
    let acceleration: Acceleration<f32> = crank.crank_acceleration();
    assert_eq!((velocity.angular, acceleration.angular), (3.0, 1.0));
    let pin: Vector2<f32> = crank.crank_pin_velocity();
    assert_eq!(pin, Vector2::new(0.0, 6.0));
    assert_eq!(crank.crank_pin_acceleration(), Vector2::new(-18.0, 2.0));
    assert_eq!((crank.a_rate(), crank.a_acceleration()), (3.0, 1.0));
    assert!(Crank::REPORT.contains("velocity and acceleration"));
}
