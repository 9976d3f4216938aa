//! The legs of a folding table. Without its lock the table folds: it compiles, so it moves. With the lock it must not move, and that is tested
//! as well: `tests/refused/` has the locked table, which has to stay refused.

mech_runtime::mechanism! {
    /// A leg that a stay of two bars folds in.
    pub struct Table;

    link leg;
    link upper;
    link lower;
    joint hinge = revolute(ground, leg) at (0, 0);
    joint pivot = revolute(ground, upper) at (4, 0);
    joint knee = revolute(upper, lower) at (2.6, -1.9);
    joint foot = revolute(lower, leg) at (0, -3);
    motor hinge;
}
