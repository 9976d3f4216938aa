//! The command line of `mech play`, where no window and no terminal are needed.

use crate::pictures::pixels;
use crate::run::{FOUR_BAR, Folder, mech_in, repository, rust};

#[test]
fn a_picture_of_what_is_played() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let mut seen = Vec::new();
    for (number, how) in ["", "--after 0.5", "--after 1", "--night"]
        .iter()
        .enumerate()
    {
        let name = format!("{number}.png");
        folder
            .mech(&format!("play a.mech --picture {name} {how}"))
            .done();
        let (size, picture) = pixels(&folder.path(&name));
        assert_eq!(size, [960, 720]);
        assert!(!seen.contains(&picture), "{how}");
        seen.push(picture);
    }
}

/// The crank turns once in 4 s, as fast in every picture.
#[test]
fn time_passes_evenly() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    folder.mech("play a.mech --picture a.png --after 4").done();
    folder.mech("play a.mech --picture b.png --after 8").done();
    assert!(pixels(&folder.path("a.png")) == pixels(&folder.path("b.png")));
}

#[test]
fn what_is_wrong_is_told_as_by_check() {
    let folder = Folder::new().with("a.rs", rust()).with("b.mech", FOUR_BAR);
    let told = folder.mech("check a.rs -m Loose").refused(1);
    for words in [
        "play a.rs -m Loose --picture a.png",
        "play a.rs --picture a.png",
        "play b.mech a.rs --picture a.png",
    ] {
        assert_eq!(folder.mech(words).refused(1), told, "{words}");
    }
    assert_eq!(folder.names(), ["a.rs", "b.mech"]);
    folder.mech("play a.rs -m FourBar --picture a.png").done();
}

#[test]
fn files_without_a_mechanism_are_left_out_of_several() {
    let folder = Folder::new()
        .with("a.rs", "fn main() {}")
        .with("b.mech", FOUR_BAR)
        .with("c.rs", "struct S;");
    folder.mech("play a.rs b.mech c.rs --picture a.png").done();
    let none = folder.mech("play a.rs c.rs --picture b.png").refused(3);
    assert_eq!(none, "error: none of these files has a mechanism\n");
    let none = folder.mech("play a.rs --picture b.png").refused(3);
    assert!(none.contains("`a.rs` has no mechanism"), "{none}");
    let missing = folder.mech("play b.mech d.rs --picture b.png").refused(3);
    assert!(
        missing.starts_with("error: cannot read `d.rs`"),
        "{missing}"
    );
}

#[test]
fn lines_that_make_no_sense() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let refusals = [
        ("play", "required"),
        ("play a.mech --wat", "--wat"),
        (
            "play a.mech --picture a.png --terminal",
            "cannot be used with",
        ),
        ("play a.mech --after 1", "--picture"),
        (
            "play a.mech --picture a.gif",
            "its name has to end in `.png`",
        ),
        (
            "play a.mech --terminal",
            "input and output are none; write a picture with `--picture FILE`",
        ),
        (
            "play a.mech --picture a.png --after NaN",
            "is not a number of seconds",
        ),
        ("play a.mech --picture a.png --after -1", "-1"),
        (
            "play a.mech -m Four --picture a.png",
            "has no mechanism `Four`; it has `FourBar`",
        ),
        (
            "play a.mech a.mech -m Four --picture a.png",
            "none of these files has a mechanism `Four`",
        ),
    ];
    for (words, text) in refusals {
        let refusal = folder.mech(words).refused(2);
        assert!(refusal.contains(text), "{words}: {refusal}");
    }
    let refusal = folder.mech("play a.mech --picture b/a.png").refused(3);
    assert!(refusal.contains("cannot write `b/a.png`"), "{refusal}");
    assert_eq!(folder.names(), ["a.mech"]);
}

/// As a shell writes them out: some files of the folder have no mechanism.
#[test]
fn the_whole_gallery_is_played() {
    let gallery = repository("examples/gallery/src/mechanisms");
    let folder = Folder::new();
    let output = folder.path("a.png");
    let mut words = vec![
        "play".into(),
        "--picture".into(),
        output.clone().into_os_string(),
    ];
    let files = std::fs::read_dir(&gallery).expect("the gallery");
    words.extend(files.map(|file| file.expect("a file").file_name()));
    assert!(words.len() > 15);
    mech_in(&gallery, &words).done();
    assert!(output.is_file());
}

#[test]
fn help_tells_the_keys() {
    let help = Folder::new().mech("play --help").done();
    for key in ["space play or pause", "drag a link", "wheel zoom", "q quit"] {
        assert!(help.contains(key), "{help}");
    }
}
