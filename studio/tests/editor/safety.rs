//! Nothing is lost where two windows are open. What one window keeps is `scripts/safety.txt`.

use super::folder::Folder;
use super::user::User;
use eframe::egui::Key;

fn draw(user: &mut User) {
    user.key(Key::B);
    user.drag([1.0, 1.0], [3.0, 2.0]);
}

#[test]
fn another_window_of_the_same_file_keeps_its_own_text() {
    let folder = Folder::new();
    let mut one = User::at_file(&folder.file());
    draw(&mut one);
    // It has not crashed: the other window does not offer what it keeps.
    let mut other = User::at_file(&folder.file());
    assert!(!other.sees("Restore"));
    draw(&mut other);
    other.wait(2);
    let kept = folder.names().into_iter();
    assert_eq!(kept.filter(|name| name.ends_with(".autosave")).count(), 2);
    drop((one, other));
    assert!(User::at_file(&folder.file()).sees("Restore"));
}
