//! Links, points, lines and shapes.

use super::assert_messages;

#[test]
fn a_line_has_a_direction() {
    assert_messages(
        "link a { line l = (0, 0)«;» }",
        &["expected `-> (dx, dy)`, found `;`; a line has a direction"],
    );
    assert_messages(
        "link a { point p = (0, 0) «(»1, 0); }",
        &["expected `;`, or `-> (dx, dy)`, found `(`"],
    );
    assert_messages(
        "link a { point p = (0, 0) -> «(0, 1 - 1)»; }",
        &["a direction cannot be (0, 0); give it a length"],
    );
}

#[test]
fn a_direction_may_be_an_angle() {
    let direction = |text: &str| {
        let text = format!("struct M; const TILT = 15; link a {{ line l = (0, 0) -> {text}; }}");
        super::good(&text).model.axes[0].direction
    };
    for (text, expected) in [
        ("0", [1.0, 0.0]),
        ("90 deg", [0.0, 1.0]),
        ("PI", [-1.0, 0.0]),
        ("-90 deg", [0.0, -1.0]),
        ("(360 + 270) deg", [0.0, -1.0]),
        (
            "(90 + TILT) deg",
            [
                libm::cos(105_f64.to_radians()),
                libm::sin(105_f64.to_radians()),
            ],
        ),
        ("atan2(3, 4)", [0.8, 0.6]),
        ("(cos(0), sin(0))", [1.0, 0.0]),
    ] {
        let found = direction(text);
        let off = (found[0] - expected[0])
            .abs()
            .max((found[1] - expected[1]).abs());
        assert!(off <= f64::EPSILON, "{text}: {found:?}");
        let is_exact = expected.contains(&0.0);
        assert!(!is_exact || found == expected, "{text}: {found:?}");
    }
    let text = "struct M; link a; joint j = prismatic(ground, a) at (0, 0) along 30 deg;";
    let axis = &super::good(text).model.axes[0];
    assert!((axis.direction[1] - 0.5).abs() < 1e-15);
    assert_messages(
        "link a { line l = (0, 0) -> «;» }",
        &["expected `(dx, dy)`, or an angle such as `30 deg`, found `;`"],
    );
    assert_messages("link a { line l = (0, 0) -> (1«)»; }", &["expected `,`"]);
}

#[test]
fn a_place_has_two_coordinates() {
    assert_messages("link a { point p = (1«)»; }", &["expected `,`"]);
    assert_messages(
        "link a { point p = (1, 2, «3»); }",
        &["expected `)`, found `3`"],
    );
    assert_messages(
        "link a { point p = «1»; }",
        &["expected `(x, y)`, found `1`"],
    );
    assert_messages("link a { point p «(»0, 0); }", &["expected `=`, found `(`"]);
}

#[test]
fn a_circle_has_a_size() {
    assert_messages(
        "link a { circle (0, 0) radius «0»; }",
        &["a radius must be greater than zero, not 0"],
    );
    assert_messages(
        "link a { circle (0, 0) radius «1 - 3»; }",
        &["a radius must be greater than zero, not -2"],
    );
    assert_messages(
        "link a { circle (0, 0)«;» }",
        &["expected `radius`, found `;`"],
    );
}

#[test]
fn a_ring_has_a_hole_within_it() {
    assert_messages(
        "link a { ring (0, 0) radius 2 hole «2»; }",
        &["the hole of a ring is smaller than the ring, whose radius is 2"],
    );
    assert_messages(
        "link a { ring (0, 0) radius 2 hole «-1»; }",
        &["the radius of a hole must be greater than zero, not -1"],
    );
    assert_messages(
        "link a { ring (0, 0) radius 2«;» }",
        &["expected `hole`, found `;`"],
    );
}

#[test]
fn a_bar_has_two_pins() {
    assert_messages(
        "link a { bar «[(0, 0)]» width 1; }",
        &["a bar has at least two pins, not 1"],
    );
    assert_messages(
        "link a { bar [(0, 0), (1, 0)] width «0»; }",
        &["a width must be greater than zero, not 0"],
    );
    assert_messages(
        "link a { bar [(0, 0), (1, 0)] «radius» 1; }",
        &["expected `width`, found `radius`"],
    );
}

#[test]
fn a_quality_is_one_of_two() {
    assert_messages(
        "quality «smoth»;",
        &["unknown quality `smoth`; did you mean `smooth`?"],
    );
    assert_messages(
        "quality smooth; «quality» hard;",
        &["a mechanism has one `quality`; remove one of the two"],
    );
    assert_messages("quality«;»", &["expected `hard` or `smooth`, found `;`"]);
}

#[test]
fn a_look_is_one_of_three() {
    assert_messages(
        "look «diagramm»;",
        &["unknown look `diagramm`; did you mean `diagram`?"],
    );
    assert_messages(
        "look none; «look» machine;",
        &["a mechanism has one `look`; remove one of the two"],
    );
    assert_messages(
        "look«;»",
        &["expected `machine`, `diagram` or `none`, found `;`"],
    );
}

#[test]
fn a_gear_has_teeth_and_a_size() {
    assert_messages("link a { gear (0, 0) radius 1 teeth 20; }", &[]);
    assert_messages(
        "link a { gear (0, 0) radius 1«;» }",
        &["expected `teeth`, found `;`"],
    );
    assert_messages(
        "link a { gear (0, 0) radius 1 teeth «2»; }",
        &["a number of teeth is a whole number from 3 to 2000, not 2"],
    );
    assert_messages(
        "link a { «gear» (0, 0) teeth 20; }",
        &[
            "`a` has no mesh with 20 teeth that would give this gear its size; write `radius r` before `teeth 20`",
        ],
    );
    assert_messages(
        "link a { gear (0, 0) teeth 20; } link b { gear (0, 0) teeth 30; } joint g = gear(a, b, 20 : 30);",
        &[],
    );
    assert_messages(
        "link a { gear (0, 0) radius 1 teeth 20 turned «90»; }",
        &[
            "`90` is an angle in radians, more than a turn; write `90 deg`\n\nhelp: or give the number a name with `const`, if radians are meant",
        ],
    );
    assert_messages(
        "param r = 1; link a { gear (0, 0) radius «r» teeth 20; }",
        &[
            "`r` is a param: it may change while the mechanism runs; `circle`, `ring`, `polygon` and `bar` may depend on one, this shape may not; use a `const` here",
        ],
    );
}

#[test]
fn other_parts_of_a_machine_can_be_drawn() {
    assert_messages(
        "ground { stand (0, 0); stand (1, 0) height 2 turned 90 deg color teal; rail [(0, 0), (1, 0)]; spring [(0, 0), (1, 0)] width 0.2; text (0, 0) \"up\" height 1; }",
        &[],
    );
    assert_messages(
        "ground { rail «[(0, 0), (1, 0), (2, 0)]»; }",
        &["a rail has two ends, not 3"],
    );
    assert_messages(
        "ground { spring «[(0, 1), (0, 1)]» width 1; }",
        &["both ends of this spring are in one place"],
    );
    assert_messages(
        "ground { text (0, 0) «up» height 1; }",
        &["expected a text in quotes, found `up`"],
    );
    assert_messages(
        "ground { «spring» s = linear(a.p, b.q) stiffness 1; }",
        &["`spring` is a statement of its own; write it after the braces of the link"],
    );
}

#[test]
fn a_polygon_has_three_corners() {
    assert_messages(
        "link a { polygon «[(0, 0), (1, 0),]»; }",
        &["a polygon has at least three corners, not 2"],
    );
    assert_messages(
        "link a { polygon «[]»; }",
        &["a polygon has at least three corners, not 0"],
    );
    assert_messages(
        "link a { polygon [(0, 0) «(»1, 0)]; }",
        &["expected `]`, found `(`"],
    );
    assert_messages(
        "link a { polygon «(»0, 0); }",
        &["expected `[(x, y), ...]`, found `(`"],
    );
}

#[test]
fn planes_and_colors_are_whole_numbers() {
    let circle = |rest: &str| format!("link a {{ circle (0, 0) radius 1 {rest}; }}");
    assert_messages(
        &circle("on plane «1.5»"),
        &["a plane is a whole number from -2147483648 to 2147483647, not 1.5"],
    );
    assert_messages(
        &circle("on plane «3e9»"),
        &["a plane is a whole number from -2147483648 to 2147483647, not 3000000000"],
    );
    assert_messages(
        &circle("color «256»"),
        &["the number of a color is a whole number from 0 to 255, not 256"],
    );
    assert_messages(
        &circle("color «-1»"),
        &["the number of a color is a whole number from 0 to 255, not -1"],
    );
    assert_messages(
        &circle("color 1 «on» plane 2"),
        &["`on plane` stands before `color`; swap the two"],
    );
    assert_messages(
        &circle("on «color» 2"),
        &["expected `plane`, found `color`"],
    );
    assert_messages(&circle("color 2 «3»"), &["expected `;`, found `3`"]);
}

#[test]
fn other_items_are_unknown() {
    assert_messages(
        "link a { «piont» p = (0, 0); }",
        &["unknown item `piont`; did you mean `point`?"],
    );
    assert_messages(
        "link a { «square» (0, 0); }",
        &[
            "unknown item `square`; what is fixed to a link begins with one of `point`, `line`, `circle`, `ring`, `polygon`, `bar`, `gear`, `stand`, `rail`, `spring`, `text`, `mass`, …",
        ],
    );
    assert_messages(
        "link a { «;» }",
        &["expected `point`, `line`, `circle` or `polygon`, found `;`"],
    );
    assert_messages("link a «(»);", &["expected `{` or `;`, found `(`"]);
    assert_messages("ground«;»", &["expected `{`, found `;`"]);
}

#[test]
fn a_point_with_bad_numbers_is_kept() {
    let parsed = assert_messages("link a { point p = («1 / 0», 0); }", &["division by zero"]);
    assert_eq!(parsed.model.axes.len(), 1);
    let parsed = assert_messages(
        "link a { point p = «oops»; } link b { point q = (0, 0); } joint d = revolute(a.p, b.q);",
        &["expected `(x, y)`, found `oops`"],
    );
    assert_eq!(parsed.model.joints.len(), 1);
}

#[test]
fn there_is_one_ground() {
    let parsed = assert_messages(
        "ground { point p = (0, 0); } «ground» { point q = (0, 0); } link a { point r = (0, 0); } joint d = revolute(ground.q, a.r);",
        &["a mechanism has one `ground`; put everything into the first"],
    );
    assert_eq!(parsed.model.joints.len(), 1);
}

#[test]
fn huge_numbers_are_told_briefly() {
    assert_messages(
        "link a { circle (0, 0) radius 1 on plane «1e300»; }",
        &["a plane is a whole number from -2147483648 to 2147483647, not 1e300"],
    );
}

#[test]
fn an_axis_may_be_turned_about_the_origin_of_its_link() {
    let parsed = super::parsed(
        "struct M; link a {
            point p = (2, 0) turned 90 deg;
            point q = (1, 0) -> (0, 1) turned 180 deg;
            line l = (0, 3) -> 0 deg turned -90 deg;
        }",
    );
    assert!(parsed.errors.is_empty());
    let axes = |index: usize| {
        (
            parsed.model.axes[index].at,
            parsed.model.axes[index].direction,
        )
    };
    assert_eq!(axes(0), ([0.0, 2.0], [1.0, 0.0]));
    assert_eq!(axes(1), ([-1.0, 0.0], [0.0, -1.0]));
    assert_eq!(axes(2), ([3.0, 0.0], [0.0, -1.0]));
}

#[test]
fn what_turns_an_axis_is_an_angle() {
    super::assert_messages(
        "link a { point p = (2, 0) turned «30»; }",
        &[
            "`30` is an angle in radians, more than a turn; write `30 deg`\n\nhelp: or give the number a name with `const`, \
         if radians are meant",
        ],
    );
    super::assert_messages(
        "link a { point p = (2, 0) turned«;» }",
        &["expected a number, found `;`"],
    );
    super::assert_messages(
        "link a { point p = «(1.5e308, -1.5e308)» turned 45 deg; }",
        &["this number is too large; the largest is about 1.8e308"],
    );
    super::assert_messages(
        "param phase = 1; link a { point p = (2, 0) turned phase; point q = (2, 0) -> (1, 0) turned «phase»; }",
        &[
            "`phase` is a param: it may change while the mechanism runs; the joints of a point count angles from its direction; \
         only lines may turn; use a `const` here",
        ],
    );
}
