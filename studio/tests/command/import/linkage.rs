//! Documents of Linkage: where what they hold stands and goes. Their texts are in `tests/cases/commands/import_linkage.txt`.

use super::moving::{Moving, distance, turn};
use super::{imported, imported_sample, sample};
use crate::run::Folder;
use std::f64::consts::TAU;

#[test]
fn a_four_bar_keeps_its_lengths() {
    let moving = Moving::of(&imported_sample("four_bar"));
    moving.stands(&[
        ("pin_0", [0.0, 0.0]),
        ("pin_1", [8.0, 14.0]),
        ("elbow", [52.0, 40.0]),
        ("pin_3", [60.0, -5.0]),
        ("coupler.tip", [25.0, 52.0]),
    ]);
    let bars = [
        [("crank", [8.0, 14.0]), ("link_fn", [52.0, 40.0])],
        [("link_fn", [52.0, 40.0]), ("coupler", [25.0, 52.0])],
    ];
    let far = moving.keeps(turn(24), &bars);
    assert!(far > 10.0, "{far}");
}

#[test]
fn a_slider_stays_between_two_anchors() {
    let moving = Moving::of(&imported_sample("slider_crank"));
    moving.stands(&[("pin_1", [1.0, 0.75]), ("slot_2", [4.5, 0.25])]);
    let bar = [("link_0", [1.0, 0.75]), ("link_1", [4.5, 0.25])];
    let far = moving.keeps(turn(24), &[bar]);
    assert!(far > 1.0, "{far}");
    for value in turn(8) {
        let [_, y] = moving.place_at(value, "link_1", [4.5, 0.25]);
        assert!((y - 0.25).abs() < 1e-9, "{y}");
    }
}

#[test]
fn a_cylinder_lifts() {
    let moving = Moving::of(&imported_sample("lift"));
    moving.stands(&[
        ("pin_1", [30.0, 5.0]),
        ("pin_3", [30.0, -25.0]),
        ("boom.point_2", [80.0, 40.0]),
    ]);
    for extension in [0.0, 5.0, 18.0] {
        let end = moving.place_at(extension, "boom", [30.0, 5.0]);
        assert!(distance(moving.place_at(extension, "ram_rod", [30.0, 5.0]), end) < 1e-9);
        assert!((distance(end, [30.0, -25.0]) - 30.0 - extension).abs() < 1e-6);
    }
}

#[test]
fn a_cylinder_that_goes_backwards_becomes_shorter() {
    let text = sample("lift").replace("cpm=\"6", "cpm=\"-6");
    let (text, _) = imported("lift.linkage2", &text);
    assert!(text.contains("motor ram_stroke in -18 ..= 0;"), "{text}");
    let moving = Moving::of(&text);
    let end = moving.place_at(-18.0, "boom", [30.0, 5.0]);
    assert!((distance(end, [30.0, -25.0]) - 12.0).abs() < 1e-6);
}

#[test]
fn a_mesh_and_a_chain() {
    // Sizes that are not whole are in the ratio of whole numbers.
    let halves = sample("gears").replace("size=\"12.0", "size=\"1.5");
    let (halves, _) = imported("gears.linkage2", &halves);
    assert!(halves.contains("= gear(pinion, wheel, 1 : 16);"), "{halves}");
    let moving = Moving::of(&imported_sample("gears"));
    moving.stands(&[("pin_2", [36.0, 50.0]), ("arm.point_3", [46.0, 60.0])]);
    for value in turn(12) {
        // The mesh reverses and halves; the chain makes it half as fast again.
        let angle = std::f64::consts::FRAC_PI_4 - value / 2.0 * 1.5;
        let length = 10.0 * std::f64::consts::SQRT_2;
        let expected = [36.0 + length * angle.cos(), 50.0 + length * angle.sin()];
        let found = moving.place_at(value, "arm", [46.0, 60.0]);
        assert!(distance(found, expected) < 1e-6, "{found:?}");
    }
}

#[test]
fn a_planet_rolls_on_a_sun_that_is_fastened_to_the_ground() {
    let moving = Moving::of(&imported_sample("planet"));
    moving.stands(&[("pin_2", [101.6, 0.0]), ("planet.point_3", [101.6, 25.4])]);
    for value in turn(12) {
        // For each turn of the carrier the planet turns four times.
        let (sin, cos) = value.sin_cos();
        let (sine, cosine) = (4.0 * value).sin_cos();
        let expected = [101.6 * cos - 25.4 * sine, 101.6 * sin + 25.4 * cosine];
        let found = moving.place_at(value, "planet", [101.6, 25.4]);
        assert!(distance(found, expected) < 1e-6, "{found:?}");
    }
}

#[test]
fn welded_links_and_pins_of_three() {
    let moving = Moving::of(&imported_sample("six_bar"));
    moving.stands(&[("pin_4", [64.0, 30.0]), ("link_5.point_7", [92.0, 20.0])]);
    let far = moving.keeps(
        turn(24),
        &[
            [("link_0", [0.0, 12.0]), ("link_2", [37.0, 22.0])],
            [("link_1", [37.0, 22.0]), ("link_4", [64.0, 30.0])],
            [("link_2", [64.0, 30.0]), ("link_5", [86.0, 7.0])],
            [("link_0", [0.0, 12.0]), ("link_8", [-20.0, 40.0])],
            [("link_4", [86.0, 7.0]), ("link_5", [92.0, 20.0])],
        ],
    );
    assert!(far > 3.0, "{far}");
}

#[test]
fn slots_on_links_guides_and_arcs() {
    let moving = Moving::of(&imported_sample("quick_return"));
    moving.stands(&[("slot_1", [15.0, 0.0]), ("arc_9_end", [100.0, 100.0])]);
    let rocked = (0..=20).map(|step| f64::from(step) / 20.0 * 0.4 - 0.2);
    let far = moving.keeps(
        rocked.clone(),
        &[
            [("arm", [30.0, 40.0]), ("ram", [70.0, 40.0])],
            [("ram", [90.0, 60.0]), ("arc_9", [100.0, 100.0])],
            [("ground", [100.0, 50.0]), ("push_rod", [100.0, 100.0])],
        ],
    );
    assert!(far > 1.0, "{far}");
    for value in rocked {
        // The pin is on the line of the slot, and the ram does not turn.
        let [x, y] = moving.place_at(value, "link_0", [15.0, 0.0]);
        let [u, v] = moving.place_at(value, "arm", [30.0, 40.0]);
        assert!((x * (v + 40.0) - u * (y + 40.0)).abs() < 1e-6);
        let [_, y] = moving.place_at(value, "ram", [90.0, 40.0]);
        assert!((y - 40.0).abs() < 1e-9, "{y}");
    }
}

#[test]
fn arcs_have_their_centre_on_either_side() {
    // The sign of the radius says the same as the place of the connector.
    let text = imported_sample("quick_return");
    let turned = sample("quick_return").replace("slideradius=\"", "slideradius=\"-");
    assert_eq!(imported("quick_return.linkage2", &turned).0, text);
    let below = sample("quick_return")
        .replace("x=\"377.952756\" y=\"377.952756\"", "x=\"377.952756\" y=\"302.362205\"");
    let (text, _) = imported("quick_return.linkage2", &below);
    assert!(text.contains("joint arc_9_center = revolute(ground, arc_9) at (100, 130);"), "{text}");
}

#[test]
fn a_slot_runs_over_fixed_pins() {
    let bar = [("link_0", [25.4, 25.4]), ("link_2", [50.8, 38.1])];
    let moving = Moving::of(&imported_sample("fork"));
    let rocked = (0..=10).map(|step| f64::from(step) * 0.05);
    assert!(moving.keeps(rocked, &[bar]) > 1.0);
    let [_, y] = moving.place_at(0.3, "link_0", [25.4, 0.0]);
    assert!(y.abs() < 1e-9, "{y}");
}

#[test]
fn names_may_be_latin_1() {
    let marked = sample("four_bar").replace("elbow", "B?R");
    let latin: Vec<u8> =
        marked.bytes().map(|byte| if byte == b'?' { 0xC4 } else { byte }).collect();
    let folder = Folder::new().with("a.linkage2", latin);
    let answer = folder.mech("import a.linkage2");
    assert!(answer.out.contains("joint bär = "), "{}", answer.out);
}

#[test]
fn several_inputs_draw_by_laws() {
    // Two cranks at 15 clockwise and 18 counter-clockwise, and a ram of 60 pixels at 6 times a minute.
    let folder = Folder::new().with("a.mech", imported_sample("inputs"));
    let table =
        "table a.mech link_0.point_1 link_1.point_3 link_3_stroke --from 0 --to 20 --steps 80";
    for row in folder.rows(table) {
        let turned = |rate: f64| (rate / 60.0 * TAU * row[0]).sin_cos();
        let (sin, cos) = turned(-15.0);
        assert!(distance([row[1], row[2]], [cos, sin]) < 1e-9, "{row:?}");
        let (sin, cos) = turned(18.0);
        assert!(distance([row[3], row[4]], [10.0 - sin, cos]) < 1e-9, "{row:?}");
        // To its end and back at one speed, six times a minute; it becomes shorter.
        let part = (row[0] / 10.0).fract();
        let expected = -2.0 * part.min(1.0 - part);
        assert!((row[5] - expected).abs() < 1e-9, "{row:?}");
    }
}
