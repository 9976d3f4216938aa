//! Drags: what they show while the pointer moves.

use super::{NAMED, document, done_to};
use mech_studio::{Command, Drag, Dragged, Refusal};

fn begin(text: &str, path: &str, pose: Option<Vec<(String, f64)>>) -> Result<Drag, Refusal> {
    Drag::begin(&document(text), 0, path, pose)
}

#[track_caller]
fn dragged(text: &str, path: &str, to: [f64; 2]) -> Dragged {
    let drag = begin(text, path, None).expect("it has a place");
    drag.move_to(to).expect("it can be there")
}

fn place(dragged: &Dragged, link: &str, point: &str) -> [f64; 2] {
    let model = &dragged.model;
    let id = model.link_ids().find(|id| model.link(*id).name == link);
    let id = id.expect("a link");
    let mut axes = model.axes.iter();
    let axis = axes.find(|axis| axis.link == id && axis.name.as_deref() == Some(point));
    let [x, y] = axis.expect("a point").at;
    let [cos, sin, left, up] = dragged.poses[id.index()].expect("a pose");
    [left + cos * x - sin * y, up + sin * x + cos * y]
}

#[track_caller]
fn is_near(a: [f64; 2], b: [f64; 2]) {
    assert!((a[0] - b[0]).hypot(a[1] - b[1]) < 1e-9, "{a:?} {b:?}");
}

#[test]
fn joints_stay_closed_while_a_pivot_is_dragged() {
    let drag = begin(NAMED, "ground.p", None).expect("it has a place");
    for step in 0..20 {
        let to = [4.0 + 0.05 * f64::from(step), 0.02 * f64::from(step)];
        let dragged = drag.move_to(to).expect("it can be there");
        is_near(place(&dragged, "rocker", "p"), to);
        is_near(place(&dragged, "rocker", "c"), place(&dragged, "coupler", "c"));
        is_near(place(&dragged, "crank", "b"), place(&dragged, "coupler", "b"));
    }
}

#[test]
fn a_drag_solves_for_the_constant_as_the_command_does() {
    let dragged = dragged(NAMED, "crank.b", [1.25, 0.0]);
    assert_eq!(dragged.notes, ["THROW = 1.25"]);
    let command = Command::Move { path: "crank.b".to_owned(), to: [1.25, 0.0], pose: None };
    assert_eq!(dragged.edits, done_to(NAMED, &command).edits);
    let tip = place(&dragged, "coupler", "tip");
    let b = place(&dragged, "coupler", "b");
    // The point by the same constant comes along.
    let away = (tip[0] - b[0]).hypot(tip[1] - b[1]);
    assert!((away - 2.5_f64.hypot(1.0)).abs() < 1e-9, "{away}");
}

#[test]
fn where_nothing_closes_the_text_follows_and_no_link_has_a_pose() {
    let dragged = dragged(NAMED, "ground.p", [40.0, 0.0]);
    assert_eq!(dragged.edits.len(), 1);
    assert!(dragged.poses.iter().all(Option::is_none));
}

#[test]
fn at_a_pose_the_point_is_where_the_pointer_is() {
    let pose = vec![("a".to_owned(), 80.0)];
    let text = NAMED.replace("2 * THROW", "2");
    let drag = begin(&text, "coupler.tip", Some(pose)).expect("it has a place");
    for to in [[2.0, 2.0], [2.5, 1.5]] {
        let dragged = drag.move_to(to).expect("it can be there");
        is_near(place(&dragged, "coupler", "tip"), to);
        // The motor is at its value.
        let (sin, cos) = 80_f64.to_radians().sin_cos();
        is_near(place(&dragged, "crank", "b"), [cos, sin]);
    }
}

#[test]
fn a_parallelogram_with_a_bar_too_many_is_analysed_at_each_move() {
    let text = "struct Three;
ground { point o = (0, 0); point p = (2, 0); point q = (4, 0); }
link a; link b; link c; link top;
joint oa = revolute(ground.o, a) at (0, 0);
joint pb = revolute(ground.p, b) at (2, 0);
joint qc = revolute(ground.q, c) at (4, 0);
joint ta = revolute(a, top) at (0, 1);
joint tb = revolute(b, top) at (2, 1);
joint tc = revolute(c, top) at (4, 1);
motor oa;
allow redundant;
";
    let text = text
        .replace("ground.o", "ground")
        .replace("ground.p", "ground")
        .replace("ground.q", "ground");
    // With other lengths it does not move.
    let off = dragged(&text, "tb", [2.1, 1.1]);
    assert!(off.poses.iter().all(Option::is_none));
    let same = dragged(&text, "tb", [2.0, 1.0]);
    assert!(same.poses.iter().all(Option::is_some));
}

#[test]
fn what_has_no_place_or_cannot_be_read_is_not_taken_hold_of() {
    let why = |text: &str, path: &str| begin(text, path, None).err().map(|why| why.to_string());
    assert_eq!(
        why(NAMED, "nothing").as_deref(),
        Some("there is no point, line or joint `nothing` in this text")
    );
    assert_eq!(
        why(&NAMED.replace("motor a", "motor zz"), "ground.p").as_deref(),
        Some("the text has mistakes; mend them before anything is dragged")
    );
    let drag = begin(NAMED, "ground.p", None).expect("it has a place");
    let refusal = drag.move_to([f64::NAN, 0.0]).expect_err("a refusal");
    assert_eq!(refusal.to_string(), "a place has two finite numbers");
}
