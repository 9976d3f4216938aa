//! What the compiler says about mechanisms, bad ones and good ones. After a wording was changed on purpose:
//! `TRYBUILD=overwrite cargo test -p mech-ui`.

#[test]
fn mechanisms_that_do_not_compile() {
    trybuild::TestCases::new().compile_fail("fail/*.rs");
}

#[test]
fn mechanisms_that_compile() {
    trybuild::TestCases::new().pass("pass/*.rs");
}
