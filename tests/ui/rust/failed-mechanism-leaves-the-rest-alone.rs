//! A mechanism with an error is the only error: code that uses it is not red.

use mech_runtime::{Blocked, Frame, Mechanism, View, mechanism};

mechanism! {
    /// A linkage.
    #[must_use]
    pub struct FourBar;

    ground { point o = (0.0, 0.0); point p = (3.5, 0.0); }
    link crank { point shaft = (0.0, 0.0); point pin = (1.0, 0.0); }
    link coupler { point left = (0.0, 0.0); point right = (3.0, 0.0); }
    link rocker { point shaft = (0.0, 0.0); point pin = (2.5, 0.0); }

    joint a = revolute(ground.o, crank.shaft);
    joint b = revolute(crank.pin, coupler.left);
    joint c = revolute(coupler.right, rocker.pin);
    joint d = revolute(ground.p, rocker.shaft);

    motor e;
    start { a = 60 deg; coupler near 30 deg; }
}

fn trace<M: Mechanism<Motors = [f64; 1]>>(mechanism: &mut M) -> Result<usize, Blocked> {
    mechanism.move_to([0.5])?;
    Ok(mechanism.poses().len() + M::LINKS.len() + M::SHAPES.len())
}

fn main() -> Result<(), Blocked> {
    let mut four_bar = FourBar::new();
    let [angle] = four_bar.motors();
    four_bar.move_to([angle + 0.1])?;
    let coupler = four_bar.coupler();
    let tip = four_bar.coupler_right();
    let turned: f64 = four_bar.b() + four_bar.crank().rotation.angle();
    println!("{coupler} {tip} {turned} {:?} {}", four_bar.poses(), FourBar::REPORT);
    let mut frame = Frame::<64, 48>::new();
    frame.look_at(View::new([0.0, 0.0], 8.0));
    four_bar.draw(&mut frame);
    let copy = four_bar;
    assert_eq!(copy, FourBar::default());
    trace(&mut four_bar)?;
    Ok(())
}
