//! Nothing is lost: not by a crash, not by another program, not by a window that is closed, not by a full disk.

use super::folder::{Folder, TEXT};
use super::user::User;
use eframe::egui::Key;
use std::fs;
use std::path::Path;

const THEIRS: &str = "// By somebody else.\nstruct Arm;\nlink arm;\njoint b = revolute(ground, arm) at (1, 0);\nmotor b;\n";

/// Draws a bar.
fn draw(user: &mut User) {
    user.key(Key::B);
    user.drag([1.0, 1.0], [3.0, 2.0]);
}

fn tells(user: &User, words: &str) -> bool {
    let notice = user.editor().notice();
    notice.is_some_and(|notice| notice.text.contains(words))
}

/// Puts another file in the place of one, as many editors do.
fn put_in_place(file: &Path, text: &str) {
    let draft = file.with_extension("new");
    fs::write(&draft, text).expect("a draft");
    fs::rename(&draft, file).expect("it replaces the file");
}

#[test]
fn a_crash_loses_nothing_that_was_drawn() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    draw(&mut user);
    let drawn = user.text().to_owned();
    assert_ne!(drawn, TEXT, "{}", user.said());
    drop(user);
    assert_eq!(folder.text(), TEXT);

    let mut user = User::at_file(&folder.file());
    assert_eq!(user.text(), TEXT);
    user.click_on("Restore");
    assert_eq!(user.text(), drawn);
    assert!(!user.sees("Restore"));
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), TEXT);
    user.shortcut(Key::Z, true);
    assert_eq!(user.text(), drawn);
    user.shortcut(Key::S, false);
    assert_eq!(folder.text(), drawn);
    assert_eq!(folder.names(), ["crank.mech"]);
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

#[test]
fn what_a_crash_has_left_can_be_discarded() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    draw(&mut user);
    drop(user);
    let mut user = User::at_file(&folder.file());
    user.click_on("Discard");
    assert!(!user.sees("Discard"));
    assert_eq!(user.text(), TEXT);
    assert_eq!(folder.names(), ["crank.mech"]);
}

#[test]
fn drawing_on_before_an_answer_loses_neither_text() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    draw(&mut user);
    let first = user.text().to_owned();
    drop(user);
    let mut user = User::at_file(&folder.file());
    user.key(Key::B);
    user.drag([-1.0, 1.0], [-3.0, 2.0]);
    let second = user.text().to_owned();
    drop(user);

    let mut user = User::at_file(&folder.file());
    user.click_on("Restore");
    user.click_on("Restore");
    assert!(!user.sees("Restore"));
    let texts = user.editor().workspace().history().made().iter();
    let texts: Vec<&str> = texts.map(|step| &*step.text).collect();
    assert_eq!(texts, [first, second]);
    user.shortcut(Key::S, false);
    assert_eq!(folder.names(), ["crank.mech"]);
}

#[test]
fn that_nothing_can_be_kept_is_told_once() {
    let folder = Folder::new();
    // Its parent is a file.
    let mut user = User::at_file(&folder.file().join("new.mech"));
    user.key(Key::B);
    user.drag([1.0, 1.0], [3.0, 2.0]);
    assert!(tells(&user, "a crash would lose"), "{}", user.said());
    assert!(tells(&user, "is a file, not a folder"), "{}", user.said());
    user.drag([3.0, 2.0], [4.0, 1.0]);
    assert!(!tells(&user, "a crash would lose"), "{}", user.said());
}

#[test]
fn what_cannot_be_saved_stays_unsaved() {
    let folder = Folder::new();
    let path = folder.file().join("new.mech");
    let mut user = User::at_file(&path);
    draw(&mut user);
    user.shortcut(Key::S, false);
    let name = path.display().to_string();
    assert!(tells(&user, &name), "{}", user.said());
    assert!(tells(&user, "is a file, not a folder"), "{}", user.said());
    assert!(user.editor().workspace().is_changed());
    assert_eq!(folder.text(), TEXT);
}

#[test]
fn a_window_without_changes_is_closed_at_once() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    assert!(user.close());
}

#[test]
fn a_window_with_changes_asks_before_it_is_closed() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    draw(&mut user);
    let drawn = user.text().to_owned();
    assert!(!user.close());
    assert!(!user.closes_by("Cancel"));
    assert!(!user.sees("Save the changes?"));
    assert_eq!(user.text(), drawn);

    assert!(!user.close());
    user.key(Key::Escape);
    assert!(!user.sees("Save the changes?"));

    assert!(!user.close());
    assert!(user.closes_by("Save"));
    assert_eq!(folder.text(), drawn);
    assert_eq!(folder.names(), ["crank.mech"]);
}

#[test]
fn changes_that_are_given_up_leave_nothing() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    draw(&mut user);
    assert_eq!(folder.names(), [".crank.mech.autosave", "crank.mech"]);
    assert!(!user.close());
    assert!(user.closes_by("Discard"));
    assert_eq!(folder.text(), TEXT);
    assert_eq!(folder.names(), ["crank.mech"]);
}

#[test]
fn what_cannot_be_saved_keeps_the_window_open() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file().join("new.mech"));
    draw(&mut user);
    assert!(!user.close());
    assert!(!user.closes_by("Save"));
    assert!(tells(&user, "cannot write"), "{}", user.said());
}

#[test]
fn a_text_without_a_name_gets_one_before_the_window_is_closed() {
    let folder = Folder::new();
    let mut user = User::without_file();
    draw(&mut user);
    assert!(!user.close());
    assert!(!user.closes_by("Save"));
    let path = folder.0.join("named.mech");
    // What is proposed is selected.
    user.wait(2);
    user.type_text(&path.display().to_string());
    assert!(user.closes_by("Save"), "{}", user.said());
    assert_eq!(fs::read_to_string(path).expect("a file"), user.text());
}

#[test]
fn a_change_on_disk_is_taken_over_as_a_step() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    put_in_place(&folder.file(), THEIRS);
    user.wait_until("it is taken over", |user| user.text() == THEIRS);
    assert!(!user.editor().workspace().is_changed());
    assert!(tells(&user, "changed on disk"), "{}", user.said());
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), TEXT);
    // What undoing gives may be saved.
    user.shortcut(Key::S, false);
    assert_eq!(folder.text(), TEXT);
}

#[test]
fn two_changes_ask_whose_counts_and_theirs_can_be_taken() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    draw(&mut user);
    let mine = user.text().to_owned();
    fs::write(folder.file(), THEIRS).expect("it is written");
    user.wait_until("it asks", |user| user.sees("crank.mech changed on disk"));
    assert_eq!(user.text(), mine);
    // Without an answer nothing is written over.
    user.shortcut(Key::S, false);
    assert_eq!(folder.text(), THEIRS);
    assert!(
        tells(&user, "changed by another program"),
        "{}",
        user.said()
    );
    user.click_on("Take theirs");
    assert_eq!(user.text(), THEIRS);
    assert!(!user.sees("Take theirs"));
    user.shortcut(Key::Z, false);
    assert_eq!(user.text(), mine);
}

#[test]
fn two_changes_ask_whose_counts_and_mine_can_be_kept() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    draw(&mut user);
    let mine = user.text().to_owned();
    put_in_place(&folder.file(), THEIRS);
    user.wait_until("it asks", |user| user.sees("Keep mine"));
    user.click_on("Keep mine");
    assert!(!user.sees("Keep mine"));
    assert_eq!(folder.text(), THEIRS);
    user.shortcut(Key::S, false);
    assert_eq!(folder.text(), mine);
    assert_eq!(user.text(), mine);
}

#[test]
fn a_deleted_file_is_told_and_can_be_saved_again() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    fs::remove_file(folder.file()).expect("it is removed");
    user.wait_until("it is told", |user| tells(user, "was deleted"));
    assert!(user.editor().workspace().is_changed());
    user.shortcut(Key::S, false);
    assert_eq!(folder.text(), TEXT);
}

#[test]
fn a_file_that_comes_back_is_taken_over() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    fs::remove_file(folder.file()).expect("it is removed");
    user.wait_until("it is told", |user| tells(user, "was deleted"));
    fs::write(folder.file(), THEIRS).expect("it is written");
    user.wait_until("it is taken over", |user| user.text() == THEIRS);
    assert!(!user.editor().workspace().is_changed());
}

#[test]
fn a_file_is_chosen_from_the_list_by_keys_alone() {
    let folder = Folder::new();
    fs::write(folder.0.join("arm.mech"), THEIRS).expect("it is written");
    fs::write(folder.0.join("notes.txt"), "").expect("it is written");
    let mut user = User::at_file(&folder.file());
    user.shortcut(Key::O, false);
    assert!(user.sees("arm.mech") && !user.sees("notes.txt"));
    // The system's own dialog, the folder above, and the first file.
    for _ in 0..3 {
        user.key(Key::Tab);
    }
    user.key(Key::Enter);
    assert_eq!(user.text(), THEIRS, "{}", user.said());
    assert!(!user.sees("Open a file"));
}

#[test]
fn a_file_in_another_folder_is_found_by_clicks() {
    let folder = Folder::new();
    let inner = folder.0.join("inner");
    fs::create_dir(&inner).expect("a folder");
    fs::write(inner.join("arm.mech"), THEIRS).expect("it is written");
    let mut user = User::at_file(&folder.file());
    user.shortcut(Key::O, false);
    user.click_on("inner/");
    user.click_on("..");
    user.click_on("inner/");
    user.click_on("arm.mech");
    assert_eq!(user.text(), THEIRS, "{}", user.said());
}

#[test]
fn a_file_that_is_dropped_on_the_window_is_opened() {
    let folder = Folder::new();
    let other = folder.0.join("arm.mech");
    fs::write(&other, THEIRS).expect("it is written");
    let mut user = User::at_file(&folder.file());
    user.drop_file(&other);
    assert_eq!(user.text(), THEIRS);
    // What is not saved is not left for it without a question.
    draw(&mut user);
    let drawn = user.text().to_owned();
    user.drop_file(&folder.file());
    assert_eq!(user.text(), drawn);
    user.click_on("Discard");
    assert_eq!(user.text(), TEXT);
}

#[test]
fn a_document_of_linkage_is_opened_as_a_new_text() {
    let folder = Folder::new();
    let sample = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/samples/four_bar.linkage2");
    fs::copy(&sample, folder.0.join("four_bar.linkage2")).expect("it is copied");
    let mut user = User::at_file(&folder.file());
    user.shortcut(Key::O, false);
    user.click_on("four_bar.linkage2");
    assert!(user.editor().drawing().is_some(), "{}", user.said());
    assert!(user.editor().workspace().is_changed());
    // Nobody has said yet which file it is; one beside the other is proposed.
    user.shortcut(Key::S, false);
    user.wait(2);
    user.key(Key::Enter);
    assert!(folder.names().contains(&"four_bar.mech".to_owned()));
    assert_eq!(
        fs::read(&sample).expect("a sample"),
        fs::read(folder.0.join("four_bar.linkage2")).expect("a copy")
    );
}

#[test]
fn an_empty_text_has_nothing_of_the_file_before() {
    let folder = Folder::new();
    let mut user = User::at_file(&folder.file());
    user.shortcut(Key::N, false);
    put_in_place(&folder.file(), THEIRS);
    user.focus_window();
    user.wait(10);
    std::thread::sleep(std::time::Duration::from_millis(150));
    user.wait(10);
    assert_eq!(user.text(), "", "{}", user.said());
    draw(&mut user);
    let drawn = user.text().to_owned();
    user.focus_window();
    user.wait(10);
    assert_eq!(user.text(), drawn);
    assert!(!user.sees("changed on disk"));
    let kept = folder.0.join("unnamed/.untitled.mech.autosave");
    assert_eq!(fs::read_to_string(kept).expect("it is kept"), drawn);
}

#[test]
fn a_file_with_several_mechanisms_is_opened_at_its_first() {
    let folder = Folder::new();
    let path = folder.0.join("two.rs");
    let text = format!("mechanism! {{\n{TEXT}}}\nmechanism! {{\n{THEIRS}}}\n");
    fs::write(&path, &text).expect("it is written");
    fs::write(folder.0.join("empty.mech"), "").expect("it is written");
    let mut user = User::at_file(&folder.file());
    user.open(&path.display().to_string());
    assert_eq!(user.text(), text, "{}", user.said());
    user.open(&folder.0.join("empty.mech").display().to_string());
    assert_eq!(user.text(), "", "{}", user.said());
}

#[test]
fn an_export_writes_over_nothing_by_a_slip() {
    let folder = Folder::new();
    let other = folder.0.join("arm.mech");
    fs::write(&other, THEIRS).expect("it is written");
    let mut user = User::at_file(&folder.file());
    user.click_on("File");
    user.click_on_beginning("Export");
    user.click_on("Picture as PNG");
    user.fill(&other.display().to_string());
    user.click_on("Replace");
    assert_eq!(fs::read_to_string(&other).expect("a file"), THEIRS);
    assert!(tells(&user, ".png"), "{}", user.said());
    let picture = folder.0.join("arm.png");
    fs::write(&picture, "").expect("it is written");
    user.click_on("File");
    user.click_on_beginning("Export");
    user.click_on("Picture as PNG");
    user.fill(&picture.display().to_string());
    user.key(Key::Enter);
    assert_eq!(fs::read(&picture).expect("a file"), b"");
    user.click_on("Replace");
    assert!(!fs::read(&picture).expect("a file").is_empty());
}

#[test]
fn another_file_is_written_over_by_a_click_that_says_so() {
    let folder = Folder::new();
    let other = folder.0.join("arm.mech");
    fs::write(&other, THEIRS).expect("it is written");
    let mut user = User::at_file(&folder.file());
    let save_as = |user: &mut User| {
        user.shortcut(Key::S, true);
        user.fill(&other.display().to_string());
    };
    save_as(&mut user);
    user.key(Key::Enter);
    assert_eq!(fs::read_to_string(&other).expect("a file"), THEIRS);
    user.click_on("Replace");
    assert_eq!(fs::read_to_string(&other).expect("a file"), TEXT);
    assert_eq!(user.editor().workspace().path(), other);
    assert!(!user.editor().workspace().is_changed());
}
