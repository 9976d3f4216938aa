//! Mechanisms in which anything may have any name. Between them they have all effects and methods, and one is wrong.

/// What a name is for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Role {
    /// The struct.
    Struct,
    /// A link that moves.
    Link,
    /// A point of that link.
    Point,
    /// A joint with a motor that turns.
    Joint,
    /// A joint with a motor that slides.
    Slide,
    /// A constant.
    Constant,
    /// A param.
    Param,
    /// A load.
    Load,
    /// A spring between points.
    Spring,
    /// A joint of a loop.
    Pin,
}

/// Where each role stands in the text of a subject, and what it is called as long as nothing else is said.
const ROLES: [(Role, &str, &str); 10] = [
    (Role::Struct, "@struct", "Subject"),
    (Role::Link, "@link", "arm"),
    (Role::Point, "@point", "elbow"),
    (Role::Joint, "@joint", "sway"),
    (Role::Slide, "@slide", "reach"),
    (Role::Constant, "@const", "HEIGHT"),
    (Role::Param, "@param", "stretch"),
    (Role::Load, "@load", "push"),
    (Role::Spring, "@spring", "coil"),
    (Role::Pin, "@pin", "small_end"),
];

/// A mechanism.
pub(crate) struct Subject {
    name: &'static str,
    text: &'static str,
    roles: &'static [Role],
    is_wrong: bool,
}

impl Subject {
    /// Its text with these names in these roles.
    pub(crate) fn with(&self, given: &[(Role, &str)]) -> String {
        let mut text = self.text.to_owned();
        for (role, place, plain) in ROLES {
            let plain = if role == Role::Struct {
                self.name
            } else {
                plain
            };
            let mut given = given.iter();
            let name = given
                .find(|(given, _)| *given == role)
                .map_or(plain, |(_, name)| name);
            text = text.replace(place, name);
        }
        text
    }

    /// Its text with the names it has by itself.
    pub(crate) fn plain(&self) -> String {
        self.with(&[])
    }

    /// What may have another name.
    pub(crate) fn roles(&self) -> &'static [Role] {
        self.roles
    }

    /// Whether it has errors whatever the names.
    pub(crate) fn is_wrong(&self) -> bool {
        self.is_wrong
    }

    /// Whether its struct is called so.
    pub(crate) fn declares(&self, name: &str) -> bool {
        self.name == name
    }
}

/// A crank, a rod and a ram, on which an arm turns; on the arm slides a cart.
macro_rules! press {
    ($start:literal, $end:literal) => {
        concat!(
            $start,
            "ground { point shaft = (0, 0); line bed = (0, 0) -> (1, 0); circle (0, 0) radius 0.2; polygon [(0, 0), (1, 0), (0, 1)]; }
            link crank { point shaft = (0, 0); point pin = (0.5, 0); mass 2 at (0.1, 0) inertia 0.1; }
            link ram { point pin = (0, 0); line axis = (0, 0) -> (1, 0); point hook = (0.5, @const); mass 1; }
            link @link { point @point = (0, 0); point tip = (1, 0); line rail = (0, 0) -> (1, 0); mass 1 at (0.5, 0); }
            link cart { line rail = (0, 0) -> (1, 0); point load = (0, 0); mass 1; }
            joint turn = revolute(ground.shaft, crank.shaft);
            joint big_end = revolute(crank.pin, rod.big);
            joint @pin = revolute(rod.small, ram.pin);
            joint bed = prismatic(ground.bed, ram.axis);
            joint @joint = revolute(ram.hook, @link.@point);
            joint @slide = prismatic(@link.rail, cart.rail);
            motor turn;
            start { turn = 60 deg; rod near -10 deg; }",
            $end
        )
    };
}

/// All of them.
pub(crate) const SUBJECTS: &[Subject] = &[
    Subject {
        name: "Varied",
        text: press!(
            "struct @struct; const @const = 1.5; param @param = 2.0;
            link rod { point big = (0, 0); point small = (@param, 0); mass 1 at (0.5, 0); }",
            "motor @joint; motor @slide; effects { velocity; acceleration; sensitivity; trace @link.@point 8; }"
        ),
        roles: &[
            Role::Struct,
            Role::Link,
            Role::Point,
            Role::Joint,
            Role::Slide,
            Role::Constant,
            Role::Param,
            Role::Pin,
        ],
        is_wrong: false,
    },
    Subject {
        name: "Loaded",
        text: press!(
            "struct @struct; const @const = 1.5;
            link rod { point big = (0, 0); point small = (2, 0); mass 1 at (0.5, 0); }",
            "motor @joint; motor @slide; gravity (0, -9.81); load @load = force(@link.tip); load twist = torque(cart);
            spring @spring = linear(crank.pin, ram.hook) stiffness 2 rest 0.5;
            damper brake = torsional(big_end) damping 0.1;
            effects { velocity; acceleration; force; dynamics; overlay; trace @link.@point 8; }"
        ),
        roles: &[
            Role::Struct,
            Role::Link,
            Role::Point,
            Role::Joint,
            Role::Slide,
            Role::Constant,
            Role::Load,
            Role::Spring,
            Role::Pin,
        ],
        is_wrong: false,
    },
    Subject {
        name: "Lawful",
        text: press!(
            "struct @struct: f32; const @const = 1.5;
            link rod { point big = (0, 0); point small = (2, 0); }",
            "motor @joint = 0.3 * sin(t); motor @slide = exp(-t) - 1; method newton(2); effects { velocity; acceleration; }"
        ),
        roles: &[Role::Struct, Role::Link, Role::Point, Role::Joint, Role::Slide, Role::Constant, Role::Pin],
        is_wrong: false,
    },
    Subject {
        name: "Bounded",
        text: "struct @struct;
            link @link { point @point = (0.5, 0); }
            link crank { point pin = (1, 0); }
            joint turn = revolute(ground, crank) at (0, 0);
            joint @joint = revolute(crank, @link) at (1, 0);
            motor turn in 0 deg ..= 90 deg;
            motor @joint in -45 deg ..= 45 deg;",
        roles: &[Role::Struct, Role::Link, Role::Point, Role::Joint],
        is_wrong: false,
    },
    Subject {
        name: "Coupled",
        text: "struct @struct;
            link crank; link coupler { point tip = (2.2, 3.6); } link rocker; link rod; link @link { point @point = (1, 0); }
            joint a = revolute(ground, crank) at (0, 0);
            joint b = revolute(crank, coupler) at (0.7, 1.2);
            joint c = revolute(coupler, rocker) at (3.6, 2.4);
            joint @pin = revolute(ground, rocker) at (4, 0);
            joint e = revolute(coupler, rod) at (2.2, 3.6);
            joint f = revolute(rod, @link) at (5.6, 4.6);
            joint @joint = revolute(ground, @link) at (6.4, 1.6);
            motor @joint; allow coupled; effects { velocity; }",
        roles: &[Role::Struct, Role::Link, Role::Point, Role::Joint, Role::Pin],
        is_wrong: false,
    },
    Subject {
        name: "Wrong",
        text: press!(
            "struct @struct; const @const = 1.5;
            link rod { point big = (0, 0); point small = (2, 0); mass 1 at (0.5, 0); }
            joint lost = revolute(ground.nothing, crank.shaft);",
            "motor @joint; motor @slide; gravity (0, -9.81); load @load = force(@link.tip); load twist = torque(cart);
            spring @spring = linear(crank.pin, ram.hook) stiffness 2 rest 0.5;
            effects { velocity; acceleration; force; dynamics; overlay; trace @link.@point 8; }"
        ),
        roles: &[
            Role::Struct,
            Role::Link,
            Role::Point,
            Role::Joint,
            Role::Slide,
            Role::Load,
            Role::Spring,
            Role::Pin,
        ],
        is_wrong: true,
    },
];
