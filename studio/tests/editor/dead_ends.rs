//! Gestures after which nothing goes on: those that are counted or tried in a row. The others are `scripts/dead_ends.txt`.

use super::user::User;
use eframe::egui::Key;

#[test]
fn a_bar_wins_over_the_grid() {
    let [from, to] = [[-3.0, 0.0], [3.2, 1.4]];
    for tool in [Key::R, Key::G] {
        for x in [-2.1, -0.9, 0.3, 1.9] {
            let mut user = User::new();
            user.key(Key::B);
            user.drag(from, to);
            user.key(tool);
            let y = (x + 3.0) * 1.4 / 6.2;
            user.click_near([x, y + 0.03]);
            let found: Vec<[f64; 2]> = user
                .editor()
                .drawing()
                .expect("it is drawn")
                .handles()
                .map(|handle| handle.place)
                .filter(|place| *place != from && *place != to)
                .collect();
            assert_eq!(found.len(), 1, "{}", user.said());
            let [px, py] = found[0];
            assert!(
                (py - (px + 3.0) * 1.4 / 6.2).abs() < 1e-8 && (px - x).abs() < 0.2,
                "{found:?} {}",
                user.said()
            );
        }
    }
}

#[test]
fn whatever_joins_links_is_copied() {
    let jansen = include_str!("../../../examples/gallery/src/mechanisms/jansen.rs");
    let figure = "struct Figure;
link wheel1; link wheel2; link bar1; link block1; link arm { point tip = (1, 0); }
joint a = revolute(ground, wheel1) at (-3, 0);
joint b = revolute(ground, wheel2) at (0, 0);
joint mesh1 = gear(wheel1, wheel2, 20 : 40);
joint c = revolute(wheel2, bar1) at (1, 0);
joint d = revolute(bar1, block1) at (5, 0);
joint e = prismatic(ground, block1) at (5, 0) along 0 deg;
joint f = weld(arm, bar1) at (3, 0);
motor a;
";
    for (name, text) in [("jansen.rs", jansen), ("figure.mech", figure)] {
        let mut user = User::with_file(name, text);
        let count = |user: &User, word: &str| user.text().matches(word).count();
        let before = ["joint ", "link ", "motor "].map(|word| count(&user, word));
        user.shortcut(Key::A, false);
        user.copy_and_paste();
        let after = ["joint ", "link ", "motor "].map(|word| count(&user, word));
        assert!(user.editor().player().is_some(), "{}", user.said());
        assert!(after.iter().zip(before).all(|(after, before)| *after > before), "{}", user.said());
        let links = user.editor().selection().len();
        assert!(links >= 5, "{}", user.said());
    }
}
