use super::{Cancellation, check};
use crate::bug::{bug, catch};
use std::panic::catch_unwind;

#[test]
fn a_flag_that_is_set_ends_the_work_through_every_guard() {
    let cancellation = Cancellation::default();
    assert_eq!(cancellation.heed(|| 1), Some(1));
    let mut rounds = 0;
    let done: Option<()> = cancellation.heed(|| {
        let caught = catch(|| {
            loop {
                rounds += 1;
                if rounds == 3 {
                    cancellation.set();
                }
                check();
            }
        });
        unreachable!("{caught:?}");
    });
    assert_eq!((done, rounds), (None, 3));
    assert!(cancellation.is_set());
    // Nobody heeds it any longer.
    check();
}

#[test]
fn a_flag_around_others_ends_work_that_heeds_one_of_its_own() {
    let (outer, inner) = (Cancellation::default(), Cancellation::default());
    let done = outer.heed(|| {
        assert_eq!(inner.heed(|| 1), Some(1));
        outer.set();
        assert_eq!(inner.heed(check), None);
        check();
    });
    assert_eq!(done, None);
    assert!(!inner.is_set());
}

#[test]
fn a_broken_invariant_stays_one() {
    let cancellation = Cancellation::default();
    let broken = catch_unwind(|| cancellation.heed(|| bug!("a test")));
    assert!(broken.is_err());
    cancellation.set();
    check();
}
