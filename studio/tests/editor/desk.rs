//! What stands around the text: a picture to be traced, locks and groups; and the way to another text.

use super::folder::{Folder, TEXT};
use super::user::User;
use eframe::egui::Key;
use std::fs;
use std::path::{Path, PathBuf};

/// A picture twice as wide as it is high.
fn picture(folder: &Path) -> PathBuf {
    let path = folder.join("linkage.png");
    let file = fs::File::create(&path).expect("a file");
    let mut encoder = png::Encoder::new(file, 64, 32);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a header");
    writer
        .write_image_data(&[200; 64 * 32 * 3])
        .expect("its pixels");
    writer.finish().expect("its end");
    path
}

fn notice(user: &User) -> &str {
    user.editor().notice().map_or("", |notice| &notice.text)
}

/// Two pins on the ground, and two bars between them.
const PAIR: &str = "struct Pair;
link crank; link rod;
joint a = revolute(ground, crank) at (0, 0);
joint b = revolute(crank, rod) at (1, 1);
joint c = prismatic(rod, ground) at (3, 0) along (1, 0);
motor a;
";

#[test]
fn a_picture_is_put_behind_scaled_kept_and_removed() {
    let folder = Folder::new();
    let file = folder.file();
    fs::write(&file, PAIR).expect("a file");
    let path = picture(&folder.0);
    let before = folder.names();
    let mut user = User::at_file(&file);
    user.click_on("View");
    user.click_on_beginning("Picture behind");
    user.fill(&path.display().to_string());
    user.key(Key::Enter);
    let (shown, ..) = user.editor().backdrop().expect("a picture");
    assert_eq!(shown, path);

    // Two places of it, a hundred apart in truth.
    user.key(Key::Escape);
    user.click([0.0, 0.0]);
    user.click_with_shift([1.0, 1.0]);
    user.click_on("Properties");
    let width = |user: &User| user.editor().backdrop().expect("a picture").2;
    let first = width(&user);
    user.enter_number("distance in it", "100");
    let factor = 100.0 / f64::sqrt(2.0);
    assert!(
        (width(&user) / first - factor).abs() < 1e-9 * factor,
        "{} became {}",
        first,
        width(&user)
    );
    user.enter_number("width", "12");
    assert!((width(&user) - 12.0).abs() < 1e-12);
    assert_eq!(user.text(), PAIR, "a picture is no part of the text");

    assert!(folder.names().contains(&".crank.mech.desk".to_owned()));
    drop(user);
    let mut user = User::at_file(&file);
    let (shown, _, again) = user.editor().backdrop().expect("it was kept");
    assert_eq!((shown, again), (&*path, 12.0));

    user.click_on("Properties");
    user.click_on("Remove the picture");
    assert!(user.editor().backdrop().is_none());
    user.wait(1);
    assert_eq!(folder.names(), before, "an empty desk needs no file");
}

#[test]
fn what_is_no_picture_is_refused() {
    let folder = Folder::new();
    let path = folder.0.join("broken.png");
    fs::write(&path, "no picture").expect("a file");
    let mut user = User::at_file(&folder.file());
    user.drop_file(&path);
    assert!(
        notice(&user).contains("is not a picture"),
        "{}",
        user.said()
    );
    assert!(user.editor().backdrop().is_none());
    user.drop_file(&picture(&folder.0));
    assert!(user.editor().backdrop().is_some(), "{}", user.said());
}

#[test]
fn a_picture_that_is_gone_is_told() {
    let folder = Folder::new();
    let path = picture(&folder.0);
    let mut user = User::at_file(&folder.file());
    user.drop_file(&path);
    let place = |user: &User| user.editor().backdrop().map(|(_, at, width)| (at, width));
    let before = place(&user);
    drop(user);
    fs::remove_file(&path).expect("it was there");
    let mut user = User::at_file(&folder.file());
    assert!(notice(&user).contains("linkage.png"), "{}", user.said());
    assert_eq!(user.text(), TEXT);

    // When it is there again, it stands where it stood, whatever was kept meanwhile.
    user.click([0.0, 0.0]);
    user.shortcut(Key::L, false);
    drop(user);
    picture(&folder.0);
    assert_eq!(place(&User::at_file(&folder.file())), before);
}

#[test]
fn what_is_locked_stays_where_it_is() {
    let mut user = User::with_text(PAIR);
    user.click([1.0, 1.0]);
    user.shortcut(Key::L, false);
    user.move_handle([1.0, 1.0], [2.0, 1.0]);
    assert_eq!(user.text(), PAIR);
    assert!(notice(&user).contains("locked"), "{}", user.said());
    user.shortcut(Key::L, true);
    user.move_handle([1.0, 1.0], [2.0, 1.0]);
    assert!(user.text().contains("at (2, 1)"), "{}", user.said());
}

#[test]
fn a_group_is_selected_and_dragged_together() {
    let mut user = User::with_text(PAIR);
    user.click([0.0, 0.0]);
    user.click_with_shift([1.0, 1.0]);
    user.shortcut(Key::G, false);
    user.click([3.0, 0.0]);
    assert_eq!(user.editor().selection().len(), 1);
    user.click([1.0, 1.0]);
    assert_eq!(user.editor().selection().len(), 2, "{}", user.said());
    user.move_handle([1.0, 1.0], [1.0, 2.0]);
    assert!(
        user.text().contains("(ground, crank) at (0, 1)"),
        "{}",
        user.said()
    );
    assert!(
        user.text().contains("(crank, rod) at (1, 2)"),
        "{}",
        user.said()
    );
    user.shortcut(Key::G, true);
    user.click([3.0, 0.0]);
    user.click([1.0, 2.0]);
    assert_eq!(user.editor().selection().len(), 1);
}

#[test]
fn groups_and_locks_are_kept_with_the_file() {
    let folder = Folder::new();
    fs::write(folder.file(), PAIR).expect("a file");
    let mut user = User::at_file(&folder.file());
    user.click([0.0, 0.0]);
    user.click_with_shift([1.0, 1.0]);
    user.shortcut(Key::G, false);
    user.shortcut(Key::L, false);
    drop(user);
    let mut user = User::at_file(&folder.file());
    user.click([1.0, 1.0]);
    assert_eq!(user.editor().selection().len(), 2);
    user.move_handle([0.0, 0.0], [0.0, 1.0]);
    assert_eq!(user.text(), PAIR);
}

#[test]
fn a_text_with_changes_is_left_only_after_an_answer() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    let new = |user: &mut User| user.shortcut(Key::N, false);
    user.move_handle([0.0, 0.0], [1.0, 0.0]);
    let changed = user.text().to_owned();
    assert_ne!(changed, TEXT, "{}", user.said());
    new(&mut user);
    assert_eq!(user.text(), changed);
    user.click_on("Cancel");
    assert_eq!(user.text(), changed);

    new(&mut user);
    user.click_on("Save");
    assert_eq!(folder.text(), changed);
    assert_eq!(user.text(), "", "{}", user.said());
}

#[test]
fn changes_can_be_given_up_for_an_example() {
    let mut user = User::with_text("");
    user.key(Key::B);
    user.drag([1.0, 1.0], [3.0, 2.0]);
    user.click_on("File");
    user.click_on_beginning("Examples");
    user.click_on("Watt six-bar");
    user.click_on("Discard");
    assert!(user.text().contains("Watt"), "{}", user.said());
}

#[test]
fn a_text_without_a_name_gets_one_before_it_is_left() {
    let folder = Folder::new();
    let path = folder.0.join("drawn.mech");
    let mut user = User::at_file(&path);
    fs::remove_file(folder.file()).expect("it was there");
    user.key(Key::B);
    user.drag([1.0, 1.0], [3.0, 2.0]);
    let drawn = user.text().to_owned();
    user.shortcut(Key::N, false);
    user.click_on("Save");
    assert_eq!(fs::read_to_string(&path).expect("it is written"), drawn);
    assert_eq!(user.text(), "");
}

#[test]
fn a_line_opens_with_the_desk() {
    let folder = Folder::new();
    fs::write(folder.file(), PAIR).expect("a file");
    let other = folder.0.join("other.mech");
    fs::write(&other, TEXT).expect("a file");
    let mut user = User::at_file(&folder.file());
    user.click([1.0, 1.0]);
    user.shortcut(Key::L, false);
    assert!(folder.names().contains(&".crank.mech.desk".to_owned()));
    let open = |user: &mut User, path: &Path| {
        user.enter("Line", &format!("open \"{}\"", path.display()));
    };
    open(&mut user, &other);
    assert_eq!(user.text(), TEXT, "{}", user.said());
    open(&mut user, &folder.file());
    user.move_handle([1.0, 1.0], [2.0, 1.0]);
    assert_eq!(user.text(), PAIR, "what was locked there is so again");
    assert!(!folder.names().contains(&".other.mech.desk".to_owned()));
}

#[test]
fn lines_play_and_quit() {
    let mut user = User::with_text(TEXT);
    let plays = |user: &User| user.editor().player().expect("it moves").plays();
    let before = plays(&user);
    user.enter("Line", "play");
    assert_ne!(plays(&user), before);
    assert!(user.ends_by("quit"));
}

#[test]
fn a_desk_that_cannot_be_read_is_left_as_it_is() {
    let folder = Folder::new();
    let desk = folder.0.join(".crank.mech.desk");
    fs::write(&desk, "{ \"later\": 1 }").expect("a file");
    let mut user = User::at_file(&folder.file());
    assert!(
        notice(&user).contains(".crank.mech.desk"),
        "{}",
        user.said()
    );
    user.click([0.0, 0.0]);
    user.shortcut(Key::L, false);
    assert_eq!(
        fs::read_to_string(&desk).expect("a file"),
        "{ \"later\": 1 }"
    );
}

#[test]
fn locks_go_with_the_text_to_another_file() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    user.click([0.0, 0.0]);
    user.shortcut(Key::L, false);
    let other = folder.0.join("other.mech");
    user.shortcut(Key::S, true);
    user.fill(&other.display().to_string());
    user.key(Key::Enter);
    user.wait(2);
    drop(user);
    let mut user = User::at_file(&other);
    user.move_handle([0.0, 0.0], [1.0, 0.0]);
    assert_eq!(user.text(), TEXT, "{}", user.said());
}

#[test]
fn an_untouched_example_is_left_by_a_line() {
    let folder = Folder::new();
    let mut user = User::without_file();
    user.click_on("File");
    user.click_on_beginning("Examples");
    user.click_on("Watt six-bar");
    let path = folder.file().display().to_string();
    user.enter("Line", &format!("open \"{path}\""));
    assert_eq!(user.text(), TEXT, "{}", user.said());
}
