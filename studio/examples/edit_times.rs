//! What changes of large mechanisms cost in time: `cargo run --release -p mech-studio --example edit_times`.

mod chain;

use chain::{chain, count};
use mech_studio::{Assembly, Command, Document, Drag, JointForm, Source, apply};
use std::hint::black_box;
use std::time::Instant;

/// The middle of some times of the same, in milliseconds.
fn milliseconds(times: usize, mut what: impl FnMut()) -> f64 {
    let mut all: Vec<f64> = (0..times)
        .map(|_| {
            let start = Instant::now();
            what();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    all.sort_by(f64::total_cmp);
    all[all.len() / 2]
}

fn main() {
    for loops in [10, 100, 333] {
        let document = Document::of(Source::new("a.mech", chain(loops)));
        let declaration = &document.declarations()[0];
        let joints = 3 * loops + 1;
        let read = milliseconds(9, || {
            let model = document.model(declaration).expect("the compiler works");
            black_box(model.expect("it can be read"));
        });
        let listing = milliseconds(9, || {
            black_box(document.listing(declaration).expect("the compiler works"));
        });
        let analysis = milliseconds(5, || {
            let reading = document.analyse(declaration).expect("the compiler works");
            assert!(reading.result.is_ok());
        });
        let drag = Command::Move {
            path: format!("d{loops}"),
            to: [4.0 * count(loops) + 0.1, 0.1],
            pose: None,
        };
        let dragged = milliseconds(5, || {
            let applied = apply(&document, 0, &drag).expect("it can be there");
            black_box(applied);
        });
        let drag = Drag::begin(&document, 0, &format!("d{loops}"), None).expect("it has a place");
        let mut to = [4.0 * count(loops) + 0.1, 0.1];
        let followed = milliseconds(99, || {
            to[0] += 1e-4;
            let dragged = drag.move_to(to).expect("it can be there");
            assert!(dragged.poses.iter().all(Option::is_some));
            black_box(dragged);
        });
        let join = Command::Join(Assembly {
            name: "extra".to_owned(),
            kind: JointForm::Revolute,
            ends: ["r1".to_owned(), format!("r{loops}")],
            at: Some(["1".to_owned(), "1".to_owned()]),
            along: None,
        });
        let refused = milliseconds(3, || {
            let refusal = apply(&document, 0, &join).expect_err("nothing can move then");
            black_box(refusal);
        });
        println!(
            "{joints} joints, {loops} loops: reading {read:.2} ms, listing {listing:.2} ms, analysis {analysis:.1} ms, a move {dragged:.1} ms, in a drag {followed:.2} ms, a joint too many {refused:.1} ms"
        );
    }
}
