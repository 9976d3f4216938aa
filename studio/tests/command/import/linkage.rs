//! Documents of Linkage.

use super::moving::{Moving, distance, turn};
use super::{imported, imported_sample, sample};
use crate::run::Folder;
use std::f64::consts::TAU;

#[test]
fn a_four_bar_with_names_colors_and_a_path() {
    let (text, omitted) = imported_sample("four_bar");
    assert_eq!(
        text,
        "/// From four_bar.linkage2.
/// Lengths are in millimetres.
/// Input `pin_0` turns 30 times a minute, clockwise; as a law in seconds `= -2 * PI * 30 / 60 * t`.
struct FourBar;
look machine;

ground { stand (0, 0); stand (60, -5); }
link crank { bar [(0, 0), (8, 14)] width 2.5 on plane 2 color blue dark; }
link coupler { point tip = (25, 52); }
link link_fn;

joint pin_0 = revolute(ground, crank) at (0, 0);
joint pin_1 = revolute(crank, coupler) at (8, 14);
joint elbow = revolute(coupler, link_fn) at (52, 40);
joint pin_3 = revolute(ground, link_fn) at (60, -5);
motor pin_0;
effects { trace coupler.tip 720; }
"
    );
    assert_eq!(
        omitted,
        "not carried over:
  looks: linesize, shapetype, solid, which only change how it is drawn
"
    );
    let moving = Moving::of(&text);
    moving.stands(&[
        ("pin_0", [0.0, 0.0]),
        ("pin_1", [8.0, 14.0]),
        ("elbow", [52.0, 40.0]),
        ("pin_3", [60.0, -5.0]),
        ("coupler.tip", [25.0, 52.0]),
    ]);
    let far = moving.keeps(
        turn(24),
        &[
            [("crank", [8.0, 14.0]), ("link_fn", [52.0, 40.0])],
            [("link_fn", [52.0, 40.0]), ("coupler", [25.0, 52.0])],
        ],
    );
    assert!(far > 10.0, "{far}");
}

#[test]
fn a_slider_between_two_anchors_in_inches() {
    let (text, omitted) = imported_sample("slider_crank");
    assert!(text.contains("/// Lengths are in inches.\n"), "{text}");
    assert!(
        text.contains("slot(link_1, ground) at (4.5, 0.25) along (5, 0);"),
        "{text}"
    );
    assert!(omitted.contains("  sliders: "), "{omitted}");
    let moving = Moving::of(&text);
    moving.stands(&[("pin_1", [1.0, 0.75]), ("slot_2", [4.5, 0.25])]);
    let far = moving.keeps(
        turn(24),
        &[[("link_0", [1.0, 0.75]), ("link_1", [4.5, 0.25])]],
    );
    assert!(far > 1.0, "{far}");
    for value in turn(8) {
        let [_, y] = moving.place_at(value, "link_1", [4.5, 0.25]);
        assert!((y - 0.25).abs() < 1e-9, "{y}");
    }
}

#[test]
fn a_cylinder_lifts() {
    let (text, omitted) = imported_sample("lift");
    assert!(
        text.contains("motor ram_stroke in 0 ..= 18;"),
        "a stroke of 18 mm: {text}"
    );
    assert!(!omitted.contains("a minute"), "{omitted}");
    assert!(
        text.contains(
            "/// Input `ram_stroke` goes to its end and back 6 times a minute; as a law in seconds"
        ),
        "{text}"
    );
    let moving = Moving::of(&text);
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
    let (text, _) = imported_sample("gears");
    assert!(
        text.contains("= gear(pinion, wheel, 12 : 24);"),
        "teeth: {text}"
    );
    assert!(
        text.contains("= belt(wheel, arm, 9.0 : 6.0);"),
        "radii: {text}"
    );
    // Sizes that are not whole are in the ratio of whole numbers.
    let halves = sample("gears").replace("size=\"12.0", "size=\"1.5");
    let (halves, _) = imported("gears.linkage2", &halves);
    assert!(
        halves.contains("= gear(pinion, wheel, 1 : 16);"),
        "{halves}"
    );
    let moving = Moving::of(&text);
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
    let text = "<linkage2>
<program units=\"Millimeters\" scalefactor=\"2\"/>
<connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\"/>
<connector id=\"1\" x=\"-96\" y=\"0\" anchor=\"true\"/>
<connector id=\"2\" x=\"192\" y=\"0\"/>
<connector id=\"3\" x=\"192\" y=\"48\" draw=\"true\"/>
<Link id=\"0\" name=\"Carrier\"><connector id=\"0\"/><connector id=\"2\"/></Link>
<Link id=\"1\" gear=\"true\" fastenconnector=\"1\"><connector id=\"0\"/></Link>
<Link id=\"2\" gear=\"true\" name=\"Planet\" usercolor=\"true\" color=\"255\"><connector id=\"2\"/><fastenconnector id=\"3\"/></Link>
<ratios><ratio type=\"gears\"><link id=\"1\" size=\"30\"/><link id=\"2\" size=\"10\"/></ratio></ratios>
</linkage2>";
    let (text, omitted) = imported("planet.linkage2", text);
    assert!(text.contains("= gear(ground, planet, 30 : 10);"), "{text}");
    assert!(
        omitted.contains("link `Planet`: its colour is lost"),
        "{omitted}"
    );
    let moving = Moving::of(&text);
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
    let (text, omitted) = imported_sample("six_bar");
    // The links 2 and 3 are one, the bar between the anchors 0 and 3 is ground, and the pin 1 has three links.
    for absent in ["link link_3", "link link_6;", "link link_9"] {
        assert!(!text.contains(absent), "{text}");
    }
    assert!(
        text.contains("joint pin_1_2 = revolute(link_0, link_7) at (0, 12);"),
        "{text}"
    );
    assert!(
        omitted.contains("  link 9: it has one connector and is no wheel, so it carries nothing\n"),
        "{omitted}"
    );
    let moving = Moving::of(&text);
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
    let (text, omitted) = imported_sample("quick_return");
    for line in [
        "joint slot_1 = slot(link_0, arm) at (15, 0) along (30, 80);",
        "joint guide_4 = prismatic(ground, ram) at (70, 40) along (90, 0);",
        "joint arc_9_center = revolute(ground, arc_9) at (100, 50);",
    ] {
        assert!(text.contains(line), "{text}");
    }
    assert!(omitted.contains("connector 9: it slides on an arc"));
    let moving = Moving::of(&text);
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
    let (text, _) = imported_sample("quick_return");
    let turned = sample("quick_return").replace("slideradius=\"", "slideradius=\"-");
    assert_eq!(imported("quick_return.linkage2", &turned).0, text);
    let below = sample("quick_return").replace(
        "x=\"377.952756\" y=\"377.952756\"",
        "x=\"377.952756\" y=\"302.362205\"",
    );
    let (text, _) = imported("quick_return.linkage2", &below);
    assert!(
        text.contains("joint arc_9_center = revolute(ground, arc_9) at (100, 130);"),
        "{text}"
    );
}

#[test]
fn a_slot_runs_over_fixed_pins() {
    let text = "<linkage2>
<connector id=\"0\" name=\" \" x=\"0\" y=\"0\"/>
<connector id=\"1\" x=\"96\" y=\"0\"/>
<connector id=\"2\" x=\"96\" y=\"96\"/>
<connector id=\"3\" x=\"30\" y=\"0\" anchor=\"true\" slider=\"true\"><slidelimit id=\"0\"/><slidelimit id=\"1\"/></connector>
<connector id=\"4\" x=\"60\" y=\"0\" anchor=\"true\" slider=\"true\"><slidelimit id=\"1\"/><slidelimit id=\"0\"/></connector>
<connector id=\"5\" x=\"192\" y=\"192\" anchor=\"true\" input=\"true\"/>
<connector id=\"6\" x=\"192\" y=\"144\"/>
<connector id=\"7\" layer=\"1\" x=\"7\" y=\"7\" fastenlink=\"0\"/>
<Link id=\"0\" name=\" \"><connector id=\"0\"/><connector id=\"1\"/><connector id=\"2\"/></Link>
<Link id=\"1\"><connector id=\"3\"/></Link>
<Link id=\"2\"><connector id=\"5\"/><connector id=\"6\"/></Link>
<Link id=\"3\"><connector id=\"2\"/><connector id=\"6\"/></Link>
</linkage2>";
    let (text, _) = imported("fork.linkage2", text);
    assert!(
        text.contains("link link_0 { point point_0 = (0, 0); point point_1 = (25.4, 0); }\n"),
        "spaces are no name, and what is drawn is no point: {text}"
    );
    assert!(
        text.contains("joint guide_3 = prismatic(ground, link_0) at (7.9375, 0) along (25.4, 0);"),
        "{text}"
    );
    let bar = [("link_0", [25.4, 25.4]), ("link_2", [50.8, 38.1])];
    let moving = Moving::of(&text);
    let rocked = (0..=10).map(|step| f64::from(step) * 0.05);
    assert!(moving.keeps(rocked, &[bar]) > 1.0);
    let [_, y] = moving.place_at(0.3, "link_0", [25.4, 0.0]);
    assert!(y.abs() < 1e-9, "{y}");
}

#[test]
fn what_is_only_drawn_is_listed() {
    let drawn = "\t<connector id=\"20\" layer=\"1\" x=\"5\" y=\"5\"/>
\t<connector id=\"21\" layer=\"1\" x=\"9\" y=\"5\" drawcircle=\"3\" glow=\"7\"/>
\t<Link id=\"30\" layer=\"1\" linesize=\"3\"><connector id=\"20\"/><connector id=\"21\"/></Link>
\t<Link id=\"31\" layer=\"16\" measurementelement=\"true\"><connector id=\"0\"/><connector id=\"2\"/></Link>
\t<sparkle/>
\t<background>aGVsbG8=</background>
</linkage2>";
    let text = sample("four_bar").replace("</linkage2>", drawn);
    let (text, omitted) = imported("four_bar.linkage2", &text);
    let (plain, _) = imported_sample("four_bar");
    assert_eq!(text, plain);
    assert_eq!(
        omitted,
        "not carried over:
  background: a picture behind the mechanism has no place in the language
  looks: drawcircle, linesize, shapetype, solid, which only change how it is drawn
  `glow` of 1 <connector>: this attribute is not known
  1 <sparkle>: this element is not known
  links 30, 31: drawings and measures are no parts of a mechanism
"
    );
}

#[test]
fn older_documents_say_less() {
    // No `<program>`, no layers, `<element>` in place of `<Link>`; lengths are pixels.
    let text = "<linkage2>
<connector anchor=\"true\" input=\"true\" x=\"0\" y=\"0\" id=\"0\"/>
<connector x=\"0\" y=\"96\" id=\"1\"/>
<element id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></element>
</linkage2>";
    let (text, omitted) = imported("old.linkage2", text);
    assert_eq!(omitted, "");
    Moving::of(&text).stands(&[("link_0.point_1", [0.0, 25.4])]);
}

/// The document of a crank-rocker with something more; its rocker has the id 2.
fn crank_rocker(more: &str) -> String {
    let connector = |id: u32, x: f64, y: f64, more: &str| {
        format!("<connector id=\"{id}\" x=\"{x}\" y=\"{y}\"{more}/>\n")
    };
    let link = |id: u32, a: u32, b: u32| {
        format!("<Link id=\"{id}\"><connector id=\"{a}\"/><connector id=\"{b}\"/></Link>\n")
    };
    [
        "<linkage2>\n",
        &connector(0, 0.0, 0.0, " anchor=\"true\" input=\"true\" rpm=\"15\""),
        &connector(1, 0.0, 100.0, ""),
        &connector(2, 300.0, 300.0, ""),
        &connector(3, 300.0, 0.0, " anchor=\"true\""),
        &link(0, 0, 1),
        &link(1, 1, 2),
        &link(2, 2, 3),
        more,
        "</linkage2>\n",
    ]
    .concat()
}

#[test]
fn ids_that_name_nothing_are_left_out() {
    let (plain, _) = imported("a.linkage2", &crank_rocker(""));
    for (more, loss) in [
        (
            "<Link id=\"7\"><connector id=\"3\"/><connector id=\"44\"/></Link>",
            "link 7: it names the connector 44, which is not there",
        ),
        (
            "<Link id=\"7\"><fastenconnector id=\"-1\"/></Link>",
            "link 7: it names the connector -1, which is not there",
        ),
        (
            "<Link id=\"7\" fastenlink=\"9\"/>",
            "link 7: it names the link 9, which is not there",
        ),
        (
            "<connector id=\"8\" layer=\"1\" x=\"0\" y=\"0\" fastenlink=\"9\"/>",
            "connector 8: it names the link 9, which is not there",
        ),
        (
            "<connector id=\"8\" layer=\"1\" x=\"0\" y=\"0\" slider=\"true\"><slidelimit id=\"0\"/><slidelimit id=\"9\"/></connector>",
            "connector 8: it slides, but no two connectors say where",
        ),
        (
            "<Link id=\"7\" actuator=\"true\"><connector id=\"3\"/><connector id=\"44\"/></Link>",
            "link 7: a cylinder has two connectors; this one has 1, so it is none",
        ),
        (
            "<ratios><ratio type=\"gears\"><link id=\"0\" size=\"2\"/><link id=\"9\" size=\"3\"/></ratio></ratios>",
            "ratio 1: it names the link 9, which is not there",
        ),
    ] {
        let (text, omitted) = imported("a.linkage2", &crank_rocker(more));
        assert_eq!(text, plain, "{more}");
        assert!(omitted.contains(loss), "{omitted}");
    }
}

#[test]
fn of_several_with_one_id_the_first_is_meant() {
    let (plain, _) = imported("a.linkage2", &crank_rocker(""));
    // Links of one id are several links.
    let same = crank_rocker("").replace("<Link id=\"2\"", "<Link id=\"0\"");
    let (text, omitted) = imported("a.linkage2", &same);
    assert_eq!(text, plain.replace("link_2", "link_0_2"));
    assert!(
        omitted.contains("link 0: an earlier link has this id, too"),
        "{omitted}"
    );
    // A connector with an earlier id is on nothing.
    for more in ["", " anchor=\"true\" input=\"true\"", " draw=\"true\""] {
        let more = format!("<connector id=\"1\" x=\"7\" y=\"7\"{more}/>\n");
        let (text, omitted) = imported("a.linkage2", &crank_rocker(&more));
        assert_eq!(text, plain);
        assert!(
            omitted.contains("connector 1: an earlier connector has this id"),
            "{omitted}"
        );
        assert!(!omitted.contains("its motor has nothing"), "{omitted}");
    }
    // What is fastened by an id is fastened to the first that has it: the rod carries the plate.
    let plate = "<connector id=\"8\" x=\"9\" y=\"9\"/><connector id=\"9\" x=\"50\" y=\"9\"/>
<Link id=\"1\"><connector id=\"0\"/></Link>
<Link id=\"5\" fastenlink=\"1\"><connector id=\"8\"/><connector id=\"9\"/></Link>";
    let (text, _) = imported("a.linkage2", &crank_rocker(plate));
    assert!(text.contains("link link_1 { point point_8"), "{text}");
}

#[test]
fn documents_that_are_no_xml_are_read_as_linkage_reads_them() {
    let right = sample("four_bar").replace("name=\"elbow\"", "name=\"R&amp;D\"");
    let (expected, losses) = imported("four_bar.linkage2", &right);
    assert!(expected.contains("joint r_d = "), "{expected}");
    let tight = right.replace("\" ", "\"").replace("&amp;", "&");
    let (text, omitted) = imported("four_bar.linkage2", &tight);
    assert_eq!(text, expected);
    let more = "  document: attributes without a space between them are read all the same\n";
    assert_eq!(omitted.replace(more, ""), losses);
    assert!(omitted.contains(more), "{omitted}");
    // Faults stand where they are, and names may be Latin-1.
    let folder = Folder::new().with(
        "a.linkage2",
        tight.replace("anchor=\"true\"", "anchor=\"yes\""),
    );
    let complaint = folder.mech("import a.linkage2").refused(3);
    let line = tight
        .lines()
        .position(|line| line.contains("anchor"))
        .expect("an anchor");
    let start = tight
        .lines()
        .nth(line)
        .and_then(|line| line.find("anchor=\""))
        .expect("it");
    let place = format!("--> a.linkage2:{}:{}\n", line + 1, start + 9);
    assert!(complaint.contains(&place), "{complaint}: {place}");
    let latin: Vec<u8> = right
        .replace("R&amp;D", "B?R")
        .bytes()
        .map(|byte| if byte == b'?' { 0xC4 } else { byte })
        .collect();
    let folder = Folder::new().with("a.linkage2", latin);
    let answer = folder.mech("import a.linkage2");
    assert!(answer.out.contains("joint bär = "), "{}", answer.out);
}

/// A slot in a link, over a fixed pin and over the pin of a rocker: its loops have to be solved together.
fn slotted(input: &str, driver: &str) -> String {
    let anchored = "anchor=\"true\"";
    let slider = |id: u32, x: f64, more: &str| {
        format!(
            "<connector id=\"{id}\" x=\"{x}\" y=\"-237\" {more} slider=\"true\"><slidelimit id=\"0\"/><slidelimit id=\"2\"/></connector>\n"
        )
    };
    [
        "<linkage2>\n<connector id=\"0\" x=\"238\" y=\"-237\"/>
<connector id=\"1\" x=\"339\" y=\"-192\"/>
<connector id=\"2\" x=\"430\" y=\"-237\"/>\n",
        &slider(3, 298.0, anchored),
        &slider(4, 352.0, ""),
        "<connector id=\"12\" x=\"342\" y=\"-282\" anchor=\"true\"/>
<connector id=\"14\" x=\"394\" y=\"-334\"/>
<connector id=\"15\" x=\"292\" y=\"-348\" anchor=\"true\" input=\"true\" rpm=\"9\"/>
<connector id=\"16\" x=\"299\" y=\"-366\"/>
<Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/><connector id=\"2\"/></Link>
<Link id=\"2\"><connector id=\"4\"/><connector id=\"12\"/><connector id=\"14\"/></Link>
<Link id=\"10\"><connector id=\"15\"/><connector id=\"16\"/></Link>
<Link id=\"11\"><connector id=\"14\"/><connector id=\"16\"/></Link>\n",
        input,
        driver,
        "</linkage2>\n",
    ]
    .concat()
}

#[test]
fn what_is_written_passes_check() {
    let crank = slotted(
        "<connector id=\"5\" x=\"534\" y=\"-187\" anchor=\"true\" input=\"true\" rpm=\"15\"/>
<connector id=\"6\" x=\"534\" y=\"-150\"/>\n",
        "<Link id=\"3\"><connector id=\"5\"/><connector id=\"6\"/></Link>
<Link id=\"4\"><connector id=\"1\"/><connector id=\"6\"/></Link>\n",
    );
    let ram = slotted(
        "<connector id=\"5\" x=\"538\" y=\"-187\" anchor=\"true\"/>\n",
        "<Link id=\"3\" actuator=\"true\" throw=\"400\" cpm=\"15\"><connector id=\"5\"/><connector id=\"1\"/></Link>\n",
    );
    for (document, is_ram) in [(crank, false), (ram, true)] {
        let folder = Folder::new().with("a.linkage2", document);
        let answer = folder.mech("import a.linkage2 -o a.mech");
        assert_eq!(answer.code, Some(0), "{}", answer.err);
        folder.mech("check a.mech").done();
        let text = folder.text("a.mech");
        assert!(text.contains("\nallow coupled;\n"), "{text}");
        // The range of the ram cannot be proved, but it can follow its law.
        let mut motors = text.lines().filter(|line| line.starts_with("motor"));
        assert!(
            motors.all(|line| line.contains("* t") && !line.contains(" in ")),
            "{text}"
        );
        let told = answer
            .err
            .contains("motor `link_3_stroke`: that its whole stroke is free cannot be proved");
        assert_eq!(told, is_ram, "{}", answer.err);
    }
    // An allowance that nothing needs is not written.
    let (text, _) = imported("a.linkage2", &crank_rocker(""));
    assert!(!text.contains("allow"), "{text}");
    // A third equal crank holds a coupler twice.
    let third = "<connector id=\"4\" x=\"150\" y=\"100\"/><connector id=\"5\" x=\"150\" y=\"0\" anchor=\"true\"/>
<Link id=\"4\"><connector id=\"4\"/><connector id=\"5\"/></Link>";
    let three = crank_rocker(third)
        .replace("y=\"300\"", "y=\"100\"")
        .replace(
            "<connector id=\"1\"/><connector id=\"2\"/>",
            "<connector id=\"1\"/><connector id=\"4\"/><connector id=\"2\"/>",
        );
    let folder = Folder::new().with("a.linkage2", three);
    folder.mech("import a.linkage2 -o a.mech");
    folder.mech("check a.mech").done();
    assert!(folder.text("a.mech").contains("\nallow redundant;\n"));
}

#[test]
fn several_inputs_draw_by_laws() {
    // Two cranks at 15 clockwise and 18 counter-clockwise, and a ram of 60 pixels at 6 times a minute.
    let document = "<linkage2><program units=\"Inches\"/>
<connector id=\"0\" x=\"0\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"15\"/>
<connector id=\"1\" x=\"96\" y=\"0\" draw=\"true\"/>
<connector id=\"2\" x=\"960\" y=\"0\" anchor=\"true\" input=\"true\" rpm=\"-18\"/>
<connector id=\"3\" x=\"960\" y=\"96\"/>
<connector id=\"4\" x=\"0\" y=\"960\" anchor=\"true\"/>
<connector id=\"5\" x=\"0\" y=\"1440\"/>
<connector id=\"6\" x=\"480\" y=\"960\" anchor=\"true\"/>
<Link id=\"0\"><connector id=\"0\"/><connector id=\"1\"/></Link>
<Link id=\"1\"><connector id=\"2\"/><connector id=\"3\"/></Link>
<Link id=\"2\"><connector id=\"4\"/><connector id=\"5\"/></Link>
<Link id=\"3\" actuator=\"true\" throw=\"96\" cpm=\"-6\"><connector id=\"6\"/><connector id=\"5\"/></Link>
</linkage2>";
    let folder = Folder::new().with("a.linkage2", document);
    folder.mech("import a.linkage2 -o a.mech");
    let text = folder.text("a.mech");
    assert!(
        text.contains("After 20 seconds all are back where they started."),
        "{text}"
    );
    let table =
        "table a.mech link_0.point_1 link_1.point_3 link_3_stroke --from 0 --to 20 --steps 80";
    let table = folder.mech(table).done();
    for row in table.lines().skip(1) {
        let row: Vec<f64> = row
            .split(',')
            .map(|cell| cell.parse().expect("a number"))
            .collect();
        let turned = |rate: f64| (rate / 60.0 * TAU * row[0]).sin_cos();
        let (sin, cos) = turned(-15.0);
        assert!(distance([row[1], row[2]], [cos, sin]) < 1e-9, "{row:?}");
        let (sin, cos) = turned(18.0);
        assert!(
            distance([row[3], row[4]], [10.0 - sin, cos]) < 1e-9,
            "{row:?}"
        );
        // To its end and back at one speed, six times a minute; it becomes shorter.
        let part = (row[0] / 10.0).fract();
        let expected = -2.0 * part.min(1.0 - part);
        assert!((row[5] - expected).abs() < 1e-9, "{row:?}");
    }
}
