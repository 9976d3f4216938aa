//! What stands beside a text may be a stranger's: it is read if it is a plain file of ours, and short.

use super::folder::{Folder, TEXT};
use super::user::User;
use eframe::egui::Key;
use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::Path;
use std::process::Command;

/// A pipe that nobody writes into: who opens it waits for ever.
fn pipe(path: &Path) {
    let done = Command::new("mkfifo").arg(path).status();
    assert!(done.expect("there are pipes").success());
}

/// Puts something where a file is expected.
type Trap = fn(&Path);

/// What a stranger may put where a file of ours is expected.
const TRAPS: [(&str, Trap); 4] = [
    ("a pipe", pipe),
    ("a device", |path| {
        symlink("/dev/zero", path).expect("a link");
    }),
    ("a link", |path| {
        let real = path.with_file_name("real");
        fs::write(&real, "{}").expect("a file");
        symlink(real, path).expect("a link");
    }),
    ("a long file", |path| {
        let file = fs::File::create(path).expect("a file");
        file.set_len(17 << 20).expect("a disk");
    }),
];

fn lock(user: &mut User) {
    user.click([0.0, 0.0]);
    user.shortcut(Key::L, false);
    user.wait(1);
}

#[test]
fn a_desk_that_is_none_of_ours_is_told_and_left_alone() {
    for (name, trap) in TRAPS {
        let folder = Folder::new();
        let desk = folder.0.join(".crank.mech.desk");
        trap(&desk);
        let before = desk.symlink_metadata().expect("it is there");
        let mut user = User::at_file(&folder.file());
        assert!(user.tells(".crank.mech.desk"), "{name}: {}", user.said());
        assert_eq!(user.text(), TEXT);
        lock(&mut user);
        let after = desk.symlink_metadata().expect("it is there");
        assert_eq!(after.modified().ok(), before.modified().ok(), "{name}");
        assert_eq!(after.file_type(), before.file_type(), "{name}");
    }
}

#[test]
fn a_desk_names_no_picture_without_an_end() {
    let traps = [TRAPS[0], TRAPS[1]];
    for (name, trap) in traps {
        let folder = Folder::new();
        let picture = folder.0.join("picture.png");
        trap(&picture);
        let place = r#"{"center": [0, 0], "width": 1, "angle": 0, "opacity": 0.5}"#;
        let desk = format!("{{\"picture\": [{picture:?}, {place}]}}");
        fs::write(folder.0.join(".crank.mech.desk"), desk).expect("a file");
        let user = User::at_file(&folder.file());
        assert!(user.tells("picture.png"), "{name}: {}", user.said());
        assert!(user.editor().backdrop().is_none(), "{name}");
    }
}

#[test]
fn a_text_that_was_left_is_a_plain_file() {
    for (name, trap) in [TRAPS[0], TRAPS[1], TRAPS[2]] {
        let folder = Folder::new();
        let left = folder.0.join(".crank.mech.autosave");
        trap(&left);
        let mut user = User::at_file(&folder.file());
        assert!(!user.sees("Restore"), "{name}");
        lock(&mut user);
        user.key(Key::B);
        user.drag([1.0, 1.0], [3.0, 2.0]);
        // It is kept under the next name.
        let names = folder.names();
        assert!(names.contains(&".crank.mech.2.autosave".to_owned()), "{name}: {names:?}");
        assert!(left.symlink_metadata().is_ok(), "{name}");
    }
}

#[test]
fn a_file_that_has_no_end_is_not_opened() {
    let folder = Folder::new();
    for (number, (name, trap)) in TRAPS.into_iter().enumerate() {
        if name == "a link" {
            // A text may stand behind one.
            continue;
        }
        for ending in ["mech", "linkage2", "png"] {
            let path = folder.0.join(format!("trap{number}.{ending}"));
            trap(&path);
            let mut user = User::at_file(&folder.file());
            user.drop_file(&path);
            assert!(user.tells("trap"), "{name}: {}", user.said());
            assert_eq!(user.text(), TEXT);
            assert!(user.editor().backdrop().is_none());
        }
    }
}

/// What is kept of a text that others may not read is not read by them either.
#[test]
fn what_is_kept_of_a_private_text_is_private() {
    let folder = Folder::new();
    let private = fs::Permissions::from_mode(0o600);
    fs::set_permissions(folder.file(), private).expect("rights");
    let mut user = User::at_file(&folder.file());
    lock(&mut user);
    user.key(Key::B);
    user.drag([1.0, 1.0], [3.0, 2.0]);
    user.wait(1);
    for name in [".crank.mech.desk", ".crank.mech.autosave"] {
        let known = fs::metadata(folder.0.join(name)).expect("it is kept");
        assert_eq!(known.permissions().mode() & 0o777, 0o600, "{name}");
    }
}

/// A few bytes that claim to be a large picture.
#[test]
fn a_picture_of_too_many_pixels_is_refused() {
    let folder = Folder::new();
    let path = folder.0.join("bomb.png");
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, 60_000, 60_000);
    encoder.set_color(png::ColorType::Rgba);
    let mut writer = encoder.write_header().expect("a header");
    let chunk = writer.write_chunk(png::chunk::IDAT, &[0x78, 0x9c]);
    chunk.expect("a chunk");
    drop(writer);
    fs::write(&path, bytes).expect("a file");
    let mut user = User::at_file(&folder.file());
    user.drop_file(&path);
    assert!(user.tells("60000 x 60000 pixels"), "{}", user.said());
    assert!(user.editor().backdrop().is_none());
}

#[test]
fn names_are_shown_without_what_turns_them() {
    let folder = Folder::new();
    let path = folder.0.join("a\u{202e}hcem.mech");
    fs::write(&path, TEXT).expect("a file");
    let mut user = User::at_file(&path);
    user.key(Key::B);
    user.drag([1.0, 1.0], [3.0, 2.0]);
    assert!(!user.ends_by("save"));
    assert!(!user.labels().contains('\u{202e}'), "{}", user.labels());
    assert!(user.tells("a?hcem.mech"), "{}", user.said());
}

/// A picture that is traced is no place for another.
#[test]
fn an_export_replaces_nothing_that_is_shown() {
    let folder = Folder::new();
    let path = folder.0.join("traced.png");
    let file = fs::File::create(&path).expect("a file");
    let mut writer = png::Encoder::new(file, 2, 2).write_header().expect("a header");
    writer.write_image_data(&[200; 4]).expect("its pixels");
    writer.finish().expect("its end");
    let before = fs::read(&path).expect("a file");
    symlink("crank.mech", folder.0.join("text.svg")).expect("a link");
    fs::write(folder.0.join("notes.svg"), "mine").expect("a file");
    let mut user = User::at_file(&folder.file());
    user.drop_file(&path);
    assert!(user.editor().backdrop().is_some(), "{}", user.said());
    for (item, name, told) in [
        ("Picture as PNG", "traced.png", "is the file that is read"),
        ("Picture as SVG", "text.svg", "is the file that is read"),
        ("Picture as SVG", "notes.svg", "is not an SVG picture"),
    ] {
        user.click_on("File");
        user.click_on_beginning("Export");
        user.click_on(item);
        user.fill(&folder.0.join(name).display().to_string());
        user.click_on("Replace");
        user.wait(1);
        assert!(user.tells(told), "{name}: {}", user.said());
    }
    assert_eq!(fs::read(&path).expect("a file"), before);
    assert_eq!(fs::read_to_string(folder.file()).expect("a text"), TEXT);
}
