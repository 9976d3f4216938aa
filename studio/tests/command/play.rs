//! The command line of `mech play`, where no window and no terminal are needed.

use crate::pictures::pixels;
use crate::run::{FOUR_BAR, Folder, mech_in, repository};

#[test]
fn a_picture_of_what_is_played() {
    let folder = Folder::new().with("a.mech", FOUR_BAR);
    let mut seen = Vec::new();
    for (number, how) in ["", "--after 0.5", "--after 1", "--night"].iter().enumerate() {
        let name = format!("{number}.png");
        folder.mech(&format!("play a.mech --picture {name} {how}")).done();
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

/// As a shell writes them out: some files of the folder have no mechanism.
#[test]
fn the_whole_gallery_is_played() {
    let gallery = repository("examples/gallery/src/mechanisms");
    let folder = Folder::new();
    let output = folder.path("a.png");
    let mut words = vec!["play".into(), "--picture".into(), output.clone().into_os_string()];
    let files = std::fs::read_dir(&gallery).expect("the gallery");
    words.extend(files.map(|file| file.expect("a file").file_name()));
    assert!(words.len() > 15);
    mech_in(&gallery, &words).done();
    assert!(output.is_file());
}
