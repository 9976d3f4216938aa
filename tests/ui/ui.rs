//! What Rust adds where a mechanism does not compile. What a user reads of a text is in `tests/cases/refused`. After a wording was changed on
//! purpose: `TRYBUILD=overwrite cargo test -p mech-ui`, and read it.

#[test]
fn mechanisms_that_do_not_compile() {
    trybuild::TestCases::new().compile_fail("*/*.rs");
}
