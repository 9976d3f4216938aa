//! What changes of large mechanisms cost in time: `cargo run --release -p mech-studio --example edit_times`.

mod timing;

use mech_studio::{Command, Document, Drag, Source, apply};
use std::hint::black_box;
use timing::{chain, count, joint_too_many, middle};

fn main() {
    for loops in [10, 100, 333] {
        let document = Document::of(Source::new("a.mech", chain(loops)));
        let declaration = &document.declarations()[0];
        let joints = 3 * loops + 1;
        let read = middle(9, || {
            let model = document.model(declaration).expect("the compiler works");
            black_box(model.expect("it can be read"));
        });
        let listing = middle(9, || {
            black_box(document.listing(declaration).expect("the compiler works"));
        });
        let analysis = middle(5, || {
            let reading = document.analyse(declaration).expect("the compiler works");
            assert!(reading.result.is_ok());
        });
        let drag = Command::Move {
            path: format!("d{loops}"),
            to: [4.0 * count(loops) + 0.1, 0.1],
            pose: None,
        };
        let dragged = middle(5, || {
            let applied = apply(&document, 0, &drag).expect("it can be there");
            black_box(applied);
        });
        let drag = Drag::begin(&document, 0, &format!("d{loops}"), None).expect("it has a place");
        let mut to = [4.0 * count(loops) + 0.1, 0.1];
        let followed = middle(99, || {
            to[0] += 1e-4;
            let dragged = drag.move_to(to).expect("it can be there");
            assert!(dragged.poses.iter().all(Option::is_some));
            black_box(dragged);
        });
        let join = joint_too_many(loops);
        let refused = middle(3, || {
            let refusal = apply(&document, 0, &join).expect_err("nothing can move then");
            black_box(refusal);
        });
        println!(
            "{joints} joints, {loops} loops: reading {read:.2} ms, listing {listing:.2} ms, analysis {analysis:.1} ms, a move {dragged:.1} ms, in a drag {followed:.2} ms, a joint too many {refused:.1} ms"
        );
    }
}
