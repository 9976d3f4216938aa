//! Who may read and write a file.

use std::fs::{File, OpenOptions, Permissions};
use std::io;
use std::path::Path;
use tempfile::Builder;

/// Lets a file have these rights when it is made, so that nobody reads it before. Without, they are as usual.
#[cfg(unix)]
pub(super) fn give(rights: Option<&Permissions>, builder: &mut Builder<'_, '_>) {
    use std::os::unix::fs::PermissionsExt;
    // The system takes away from the latter what the user's mask says.
    let usual = Permissions::from_mode(0o666);
    builder.permissions(rights.unwrap_or(&usual).clone());
}

/// Elsewhere a folder says who may read its files.
#[cfg(not(unix))]
pub(super) fn give(_: Option<&Permissions>, _: &mut Builder<'_, '_>) {}

/// The rights of a file. What belongs to none that is there is for the user alone.
#[cfg(feature = "editor")]
pub(super) fn like(path: &Path) -> Option<Permissions> {
    let known = std::fs::metadata(path);
    let known = known.ok().map(|known| known.permissions());
    #[cfg(unix)]
    let known = {
        use std::os::unix::fs::PermissionsExt;
        known.or_else(|| Some(Permissions::from_mode(0o600)))
    };
    known
}

/// Makes a file with these rights. One that is there is not opened.
pub(super) fn create(path: &Path, rights: Option<&Permissions>) -> io::Result<File> {
    let mut options = OpenOptions::new();
    options.write(true).create_new(true);
    #[cfg(unix)]
    {
        use std::os::unix::fs::{OpenOptionsExt, PermissionsExt};
        options.mode(rights.map_or(0o666, PermissionsExt::mode));
    }
    #[cfg(not(unix))]
    let _ = rights;
    options.open(path)
}
