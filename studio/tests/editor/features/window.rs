//! The studio's window: what can be clicked, and typed into.

use super::repository;
use crate::folder::Folder;
use crate::user::User;

const CRANK: &str = "struct Crank; param size = 1; gravity (0, -1);
link crank { point tip = (size, 0); circle (0, 0) radius 0.2; mass 1; }
joint a = revolute(ground, crank) at (0, 0); motor a;
load push = force(crank.tip); effects { force; trace crank.tip 9; }";

/// The controls of the window, and what comes with each click.
pub(super) fn controls() -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    let mut note = |way: &str, user: &User, before: &[String]| {
        let mut others = before.to_vec();
        for name in user.names() {
            let line = format!("{way}: {name}");
            match others.iter().position(|other| *other == name) {
                Some(at) => drop(others.remove(at)),
                // Folders are those of this computer.
                None if name.ends_with('/') || found.contains(&line) => {}
                None => found.push(line),
            }
        }
        user.names()
    };
    let at_first = note("window", &User::with_text(CRANK), &[]);
    // Each way lists the controls to click, one after the other; after `/`, a control's own menu is opened.
    for way in include_str!("ways.txt").lines() {
        let (mut user, mut before) = (User::with_text(CRANK), at_first.clone());
        let mut done = Vec::new();
        for step in way.split(" > ") {
            match step.strip_prefix('/') {
                Some(name) => user.open_menu_of(name),
                None => user.click_on_beginning(step),
            }
            done.push(step);
            before = note(&done.join(" > "), &user, &before);
        }
    }
    let mut user = User::with_text(CRANK);
    user.drop_file(&repository("docs/studio/opened.png"));
    user.wait(20);
    user.click_on("Properties");
    let before = note("with a picture", &user, &at_first);
    user.type_all(&CRANK.replace("motor a;", ""));
    user.click_on("joint a");
    let before = note("without a motor", &user, &before);
    user.close();
    note("closed with changes", &user, &before);
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    user.type_all(CRANK);
    drop(user);
    note("after a crash", &User::at_file(&folder.file()), &at_first);
    found
}
