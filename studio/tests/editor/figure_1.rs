//! Figure 1 of the paper, from an empty canvas, without typing.

use super::user::User;

#[test]
fn figure_1_is_drawn_in_few_gestures() {
    let mut user = User::new();
    // Two wheels, and how they mesh.
    user.click_on("Wheel");
    user.click([-3.0, 0.0]);
    user.click([0.0, 0.0]);
    user.click_on("Gears");
    user.click([-3.0, 0.0]);
    user.click([0.0, 0.0]);
    user.click([-2.0, 0.0]);
    // The rod, from the second wheel.
    user.click_on("Bar");
    user.drag([1.0, 0.0], [5.0, 0.0]);
    // The piston.
    user.click_on("Slider");
    user.drag([5.0, 0.0], [6.0, 0.0]);
    user.click_on("Motor");
    user.click([-3.0, 0.0]);
    user.click_on("Play");
    let said = user.said();
    let player = user.editor().player().expect(&said);
    assert!(player.plays());
    user.wait(60);
    let player = user.editor().player().expect(&said);
    assert!(player.motors()[0] > 1.0, "{said}");
    let expected = "\
struct Mechanism;
link wheel1;
link wheel2;
link bar1;
link block1;
joint a = revolute(ground, wheel1) at (-3, 0);
joint b = revolute(ground, wheel2) at (0, 0);
joint mesh1 = gear(wheel1, wheel2, 20 : 40);
joint c = revolute(wheel2, bar1) at (1, 0);
joint d = revolute(bar1, block1) at (5, 0);
joint e = prismatic(ground, block1) at (5, 0) along 0 deg;
motor a;
";
    assert_eq!(user.text(), expected);
    assert_eq!(user.gestures(), 14);
}
