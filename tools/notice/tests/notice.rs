//! What goes with the command has every text that has to.

use std::process::Command;

#[test]
fn the_notice_of_the_command_has_every_text() {
    let made =
        Command::new(env!("CARGO_BIN_EXE_notice")).arg("mech-studio").output().expect("it runs");
    let complaint = String::from_utf8_lossy(&made.stderr);
    assert!(made.status.success(), "{complaint}");
    let notice = String::from_utf8(made.stdout).expect("a text");
    let (crates, texts) = notice.split_once("\n\n---").expect("texts after the crates");
    let mut count = 0;
    for line in crates.lines().filter(|line| line.contains(": ")) {
        let (name, _) = line.split_once(": ").expect("a name");
        if name.split(' ').count() == 2 {
            count += 1;
            assert!(texts.contains(name), "{name} has no text");
        }
    }
    assert!(count > 200, "{count}");
    // The letters.
    for font in [
        "UBUNTU FONT LICENCE Version 1.0",
        "SIL OPEN FONT LICENSE Version 1.1",
        "BITSTREAM VERA LICENSE",
        "Copyright (c) 2014 John Slegers",
    ] {
        assert!(texts.contains(font), "{font}");
    }
    let apache = texts.matches("TERMS AND CONDITIONS FOR USE, REPRODUCTION").count();
    assert!(apache < 30, "each text stands there once, but {apache} of Apache-2.0");
    assert!(!crates.contains("mech-compiler"), "our own");
}
