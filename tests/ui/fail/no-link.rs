//! There is nothing but a name.

use mech_runtime::mechanism;

mechanism! {
    struct S;
}

fn main() {}
