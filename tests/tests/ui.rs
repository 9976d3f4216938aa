//! What the compiler says about mechanisms, bad ones and good ones. After a wording was changed on purpose:
//! `TRYBUILD=overwrite cargo test -p mech-tests --test ui`.

#[test]
fn mechanisms_that_do_not_compile() {
    trybuild::TestCases::new().compile_fail("ui/fail/*.rs");
}

#[test]
fn mechanisms_that_compile() {
    trybuild::TestCases::new().pass("ui/pass/*.rs");
}
