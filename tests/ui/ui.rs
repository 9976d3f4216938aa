//! What a user reads where a mechanism does not compile: a folder for each rule, and one for what Rust adds. After a wording was changed on
//! purpose: `TRYBUILD=overwrite cargo test -p mech-ui`, and read it.

#[test]
fn mechanisms_that_do_not_compile() {
    trybuild::TestCases::new().compile_fail("*/*.rs");
}
