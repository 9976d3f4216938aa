//! A picture to be traced. Locks and groups, and the way to another text, are `scripts/desk.txt`.

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
    writer.write_image_data(&[200; 64 * 32 * 3]).expect("its pixels");
    writer.finish().expect("its end");
    path
}

const PAIR: &str = include_str!("scripts/slider.mech");

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
    assert!(user.tells("is not a picture"), "{}", user.said());
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
    assert!(user.tells("linkage.png"), "{}", user.said());
    assert_eq!(user.text(), TEXT);

    // When it is there again, it stands where it stood, whatever was kept meanwhile.
    user.click([0.0, 0.0]);
    user.shortcut(Key::L, false);
    drop(user);
    picture(&folder.0);
    assert_eq!(place(&User::at_file(&folder.file())), before);
}
