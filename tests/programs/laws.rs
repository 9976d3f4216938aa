//! Motors that follow laws, in a crate without `std`'s prelude in the way.

mech_runtime::mechanism! {
    pub struct Wheel;
    ground { point o = (0, 0); }
    link wheel { point o = (0, 0); }
    joint a = revolute(ground.o, wheel.o);
    motor a = min(t * t, 2 * t - 1) by 1 deg;
    effects { acceleration; }
}

fn main() {
    let mut wheel = Wheel::new();
    assert!(wheel.at_time(3.0).is_ok());
    assert_eq!(wheel.motors(), [5.0]);
    assert_eq!((wheel.a_rate(), wheel.a_acceleration()), (2.0, 0.0));
    assert!(wheel.move_to([0.5]).is_ok());
}
