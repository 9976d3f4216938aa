//! `TRYBUILD=overwrite cargo test -p mech-locked` writes what the compiler says. Read it: it must be refused for the right reason.

#[test]
fn the_lock_holds_the_table() {
    trybuild::TestCases::new().compile_fail("tests/refused/*.rs");
}

#[test]
fn without_its_lock_the_table_folds() {
    let mut table = mech_locked::Table::new();
    let [hinge] = table.motors();
    table.move_to([hinge + 0.3]).expect("it folds");
}
