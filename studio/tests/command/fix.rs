//! Where `mech fix` writes. What it shows and makes is in `tests/cases/commands/fix.txt`.

use crate::run::{FOUR_BAR, Folder};

#[test]
#[cfg(unix)]
fn a_file_that_may_not_be_written_stays() {
    use std::fs::{Permissions, set_permissions};
    use std::os::unix::fs::PermissionsExt;
    let loose = FOUR_BAR.replace("motor a;\n", "");
    let folder = Folder::new().with("a.mech", &loose);
    set_permissions(folder.path("a.mech"), Permissions::from_mode(0o640)).expect("it is ours");
    folder.mech("fix a.mech --pick 1").done();
    let mode = std::fs::metadata(folder.path("a.mech"))
        .expect("a file")
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o640);
    // A link stays one.
    let folder = Folder::new().with("b.mech", &loose);
    std::os::unix::fs::symlink("b.mech", folder.path("c.mech")).expect("a link");
    folder.mech("fix c.mech --pick 1").done();
    assert!(folder.path("c.mech").is_symlink());
    assert_eq!(folder.text("b.mech"), FOUR_BAR);
}
