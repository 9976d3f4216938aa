//! The `struct` line.

use super::parsed;

#[test]
fn the_struct_line_comes_first() {
    let missing = "expected `struct Name;` first; it names the type that the mechanism becomes";
    assert_eq!(parsed("").errors[0].text, missing);
    assert_eq!(parsed("struct M; struct N;").model.name, "M");
}
