//! A walker of twelve legs: one leg of the library, used twelve times.
//!
//! Run it with `cargo run --example walker`, then open `target/walker.png`.

use mech_runtime::{HeapSmooth, Overlay, mechanism};
use std::error::Error;
use std::fs;

mechanism! {
    /// Six legs to the left of the axle and six to the right, whose pins are evenly spaced.
    struct Walker;
    use mech_runtime::parts::JansenLeg;
    ground { point shaft = (0, 0); }
    link axle { point shaft = (0, 0); }
    joint main = revolute(ground.shaft, axle.shaft);
    motor main;
    use left[6]: JansenLeg(phase = k * 60 deg) { frame = ground, crank = axle };
    use right[6]: JansenLeg(phase = k * 60 deg) mirrored { frame = ground, crank = axle };
    effects { overlay; trace left[0].foot.tip 360; trace right[0].foot.tip 360; }
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut walker = Walker::new();
    println!("{}", Walker::REPORT);
    for degrees in 0..=360 {
        walker.move_to([f64::from(degrees).to_radians()])?;
    }
    println!("  leg     foot");
    for k in 0..6 {
        let (left, right) = (walker.left(k).foot_tip(), walker.right(k).foot_tip());
        println!(
            "    {k}     ({:7.2}, {:7.2})   ({:7.2}, {:7.2})",
            left.x, left.y, right.x, right.y
        );
    }
    let mut picture = HeapSmooth::of::<Walker>(960, 640)?;
    walker.draw(&mut picture);
    walker.draw_overlay(&mut picture, &Overlay::new());
    fs::create_dir_all("target")?;
    fs::write("target/walker.png", picture.png()?)?;
    println!("open target/walker.png");
    Ok(())
}
