//! The gallery's exhibits, as its page opens them.

use crate::user::User;
use eframe::egui::Key;
use mech_gallery::{Exhibited, Visitor, visit_f64};
use mech_studio::editor::Drawing;

/// Opens every exhibit by its file.
struct Opener(Vec<&'static str>);

impl Visitor for Opener {
    fn visit<M: Exhibited>(&mut self) {
        let mut user = User::with_file(M::FILE, M::SOURCE);
        let editor = user.editor();
        assert!(editor.messages().is_empty(), "{}", user.said());
        assert_eq!(editor.notice(), None, "{}", M::FILE);
        assert!(editor.player().is_some(), "{} does not move", M::FILE);
        let before = places(&user);
        user.wait(3);
        assert_eq!(places(&user), before, "{} moves unasked", M::FILE);
        user.key(Key::Space);
        user.wait(5);
        assert_ne!(places(&user), before, "{} stands still", M::FILE);
        self.0.push(M::FILE);
    }
}

/// Where everything is that can be grasped.
fn places(user: &User) -> Vec<[f64; 2]> {
    let drawing = user.editor().drawing();
    let handles = drawing.into_iter().flat_map(Drawing::handles);
    handles.map(|handle| handle.place).collect()
}

#[test]
fn every_exhibit_opens_and_moves() {
    let mut opened = Opener(Vec::new());
    visit_f64(&mut opened);
    assert!(opened.0.contains(&"four_bar.rs"));
}
