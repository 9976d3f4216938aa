//! The table of the dialogue's lines: reading, help and completion use it.

use super::request::{
    Request, Row, action, ask, constant, edit, join, numbers, pose, rolling, start,
};
use crate::edit::{ActionKind, Command, JointForm, Kind};
use crate::failure::Failure;

const KINDS: [(&str, Kind); 14] = [
    ("link", Kind::Link),
    ("joint", Kind::Joint),
    ("motor", Kind::Motor),
    ("point", Kind::Axis),
    ("line", Kind::Axis),
    ("const", Kind::Constant),
    ("param", Kind::Constant),
    ("spring", Kind::Action),
    ("damper", Kind::Action),
    ("load", Kind::Action),
    ("use", Kind::Use),
    ("start", Kind::Start),
    ("mass", Kind::Mass),
    ("trace", Kind::Trace),
];

/// Everything that can be said. Of rows that begin alike, the first that fits counts.
pub(super) const ROWS: &[Row] = &[
    Row {
        pattern: "mechanism <name:new>",
        help: "begins a mechanism in an empty text",
        request: |mut taken| edit(Command::Mechanism { name: taken.text("name") }),
    },
    Row {
        pattern: "link <name:new>",
        help: "declares a link",
        request: |mut taken| edit(Command::Link { name: taken.text("name") }),
    },
    Row {
        pattern: "point <path:new> at <at:place>",
        help: "fixes a point to a link or to the ground: `point crank.pin at (1, 0)`",
        request: |mut taken| {
            edit(Command::Axis {
                path: taken.text("path"),
                at: taken.given_place("at")?,
                along: None,
            })
        },
    },
    Row {
        pattern: "line <path:new> at <at:place> along <along:value>",
        help: "fixes a line to a link or to the ground: `line ground.bore at (0, 0) along (1, 0)`",
        request: |mut taken| {
            edit(Command::Axis {
                path: taken.text("path"),
                at: taken.given_place("at")?,
                along: taken.optional("along"),
            })
        },
    },
    Row {
        pattern: "shape <link:link> <shape:rest>",
        help: "fixes a shape to a link: `shape crank circle (0, 0) radius 0.2 color teal`",
        request: |mut taken| {
            edit(Command::Shape { link: taken.text("link"), shape: taken.text("shape") })
        },
    },
    Row {
        pattern: "mass <link:link> <mass:value> [at <at:place>] [inertia <inertia:value>]",
        help: "gives a link a mass",
        request: |mut taken| {
            edit(Command::Mass {
                link: taken.text("link"),
                mass: taken.text("mass"),
                at: taken.place("at")?,
                inertia: taken.optional("inertia"),
            })
        },
    },
    Row {
        pattern: "join <name:new> = <kind:revolute|prismatic|slot|weld> <a:end> <b:end> [at <at:place>] [along <along:value>]",
        help: "assembles two links: `join a = revolute crank.pin rod.end`",
        request: |mut taken| {
            let kind = match taken.text("kind").as_str() {
                "prismatic" => JointForm::Prismatic,
                "slot" => JointForm::Slot,
                "weld" => JointForm::Weld,
                _ => JointForm::Revolute,
            };
            join(taken, kind)
        },
    },
    Row {
        pattern: "join <name:new> = <kind:gear|belt> <a:link> <b:link> <first:value> : <second:value> [on <on:link>]",
        help: "lets two wheels roll: `join mesh = gear pinion wheel 20 : 40`",
        request: rolling,
    },
    Row {
        pattern: "join <name:new> = rack <a:link> <b:link> radius <radius:value> [on <on:link>]",
        help: "lets a wheel roll on a toothed bar",
        request: |mut taken| {
            let (radius, on) = (taken.text("radius"), taken.optional("on"));
            join(taken, JointForm::Rack { radius, on })
        },
    },
    Row {
        pattern: "join <name:new> = cam <a:joint> <b:joint> <law:rest>",
        help: "makes the coordinate of the second joint a function of `q`, that of the first",
        request: |mut taken| {
            let law = taken.text("law");
            join(taken, JointForm::Cam { law })
        },
    },
    Row {
        pattern: "motor <joint:joint> [= <law:value>] [in <low:value> ..= <high:value>] [by <step:value>]",
        help: "puts a motor on a joint, or gives the one there a law, a range or a step",
        request: |mut taken| {
            let range = taken.optional("low").zip(taken.optional("high"));
            edit(Command::Motor {
                joint: taken.text("joint"),
                law: taken.optional("law"),
                range: range.map(|(low, high)| [low, high]),
                step: taken.optional("step"),
            })
        },
    },
    Row {
        pattern: "start <name:joint> = <value:value>",
        help: "says where a joint starts",
        request: |taken| start(taken, false),
    },
    Row {
        pattern: "near <name:link> <value:rest>",
        help: "chooses the assembly in which a link is near an angle: `near rod 30 deg`",
        request: |taken| start(taken, true),
    },
    Row {
        pattern: "const <name:new> = <value:value>",
        help: "declares a number, or sets one",
        request: |taken| constant(taken, false),
    },
    Row {
        pattern: "param <name:new> = <value:value>",
        help: "declares a number that can be changed while the mechanism runs",
        request: |taken| constant(taken, true),
    },
    Row {
        pattern: "spring <name:new> = <body:rest>",
        help: "declares a spring: `spring coil = linear(a.p, b.q) stiffness 100`",
        request: |taken| action(taken, ActionKind::Spring),
    },
    Row {
        pattern: "damper <name:new> = <body:rest>",
        help: "declares a damper: `damper d = torsional(a) damping 0.1`",
        request: |taken| action(taken, ActionKind::Damper),
    },
    Row {
        pattern: "load <name:new> = <body:rest>",
        help: "declares a load: `load push = force(rod.end)`",
        request: |taken| action(taken, ActionKind::Load),
    },
    Row {
        pattern: "use <body:rest>",
        help: "uses a part: `use left: Leg(size = 2) { frame = ground }`",
        request: |mut taken| edit(Command::Use { body: taken.text("body") }),
    },
    Row {
        pattern: "trace <point:end> <length:value>",
        help: "records the path of a point",
        request: |mut taken| {
            edit(Command::Trace { point: taken.text("point"), length: taken.text("length") })
        },
    },
    Row {
        pattern: "<word:gravity|look|quality|method|accuracy|cost|allow|show|continuous|follow> <what:rest>",
        help: "says something of the whole mechanism: `gravity (0, -9.81)`, `look diagram`",
        request: |mut taken| {
            let statement = format!("{} {}", taken.text("word"), taken.text("what"));
            edit(Command::Setting { statement })
        },
    },
    Row {
        pattern: "move <path:any> to <to:place> [at <pose:rest>]",
        help: "moves a point; with values of motors, as it is seen there: `move a.p to (1, 2) at d = 30`",
        request: |mut taken| {
            edit(Command::Move {
                path: taken.text("path"),
                to: numbers(taken.given_place("to")?)?,
                pose: taken.optional("pose").map(|text| pose(&text)).transpose()?,
            })
        },
    },
    Row {
        pattern: "set <owner:any> <role:rest> = <value:rest>",
        help: "sets a number by its role; `numbers` lists all",
        request: |mut taken| {
            edit(Command::Set {
                owner: taken.text("owner"),
                role: taken.text("role"),
                value: taken.text("value"),
            })
        },
    },
    Row {
        pattern: "plane <link:link> <shape:number> <plane:value>",
        help: "puts a shape of a link, by its number, on a plane",
        request: |mut taken| {
            edit(Command::Layer {
                link: taken.text("link"),
                shape: taken.number("shape")?,
                plane: taken.text("plane"),
            })
        },
    },
    Row {
        pattern: "color <link:link> <shape:number> <color:rest>",
        help: "gives a shape of a link another colour",
        request: |mut taken| {
            edit(Command::Recolor {
                link: taken.text("link"),
                shape: taken.number("shape")?,
                color: taken.text("color"),
            })
        },
    },
    Row {
        pattern: "reshape <link:link> <shape:number> <outline:rest>",
        help: "gives a shape of a link another outline",
        request: |mut taken| {
            edit(Command::Reshape {
                link: taken.text("link"),
                shape: taken.number("shape")?,
                outline: taken.text("outline"),
            })
        },
    },
    Row {
        pattern: "rename <path:any> <name:new>",
        help: "gives something another name, wherever it is used",
        request: |mut taken| {
            edit(Command::Rename { path: taken.text("path"), name: taken.text("name") })
        },
    },
    Row {
        pattern: "remove shape <link:link> <shape:number>",
        help: "takes a shape of a link out",
        request: |mut taken| {
            edit(Command::RemoveShape { link: taken.text("link"), shape: taken.number("shape")? })
        },
    },
    Row {
        pattern: "remove <kind:link|joint|motor|point|line|const|param|spring|damper|load|use|start|mass|trace> <name:any>",
        help: "takes something out, with what cannot be without it",
        request: |mut taken| {
            let word = taken.text("kind");
            let kind = KINDS.iter().find(|(known, _)| *known == word);
            let (_, kind) = kind.ok_or_else(|| Failure::internal("a kind without a word"))?;
            edit(Command::Remove { kind: *kind, name: taken.text("name") })
        },
    },
    Row {
        pattern: "mirror <name:link>",
        help: "mirrors what is fixed to a link about its x axis; or a use of a part",
        request: |mut taken| edit(Command::Mirror { name: taken.text("name") }),
    },
    Row {
        pattern: "duplicate <name:link> as <copy:new>",
        help: "declares a link or a use once more",
        request: |mut taken| {
            edit(Command::Duplicate { name: taken.text("name"), copy: taken.text("copy") })
        },
    },
    Row {
        pattern: "repairs",
        help: "lists what would mend the mechanism",
        request: |_| Ok(Request::Repairs),
    },
    Row {
        pattern: "repair <number:number>",
        help: "makes one of these repairs",
        request: |mut taken| edit(Command::Repair { number: taken.number("number")? }),
    },
    Row { pattern: "undo", help: "undoes the last step", request: |_| Ok(Request::Undo) },
    Row { pattern: "redo", help: "makes it again", request: |_| Ok(Request::Redo) },
    Row {
        pattern: "steps",
        help: "lists the steps that can be undone",
        request: |_| Ok(Request::Steps),
    },
    Row { pattern: "text", help: "shows the text", request: |_| Ok(Request::Text) },
    Row {
        pattern: "numbers [<owner:any>]",
        help: "lists the numbers of something, with their roles",
        request: |mut taken| Ok(Request::Numbers(taken.optional("owner"))),
    },
    Row {
        pattern: "<command:draw|film> <file:rest> [with <words:rest>]",
        help: "writes a picture, or one that moves: `draw a.png with --overlay`",
        request: |mut taken| {
            let (file, words) = (taken.text("file"), taken.optional("words"));
            ask(&taken.text("command"), Some(file), words)
        },
    },
    Row {
        pattern: "<command:check|report|graph|table|plot|play> [<words:rest>]",
        help: "as `mech check` and the others, on the text as it is now: `table crank.pin --from 0 --to 90`",
        request: |mut taken| {
            let words = taken.optional("words");
            ask(&taken.text("command"), None, words)
        },
    },
    Row {
        pattern: "open <file:rest> [as <mechanism:new>]",
        help: "reads a file; of several mechanisms, the one of this name",
        request: |mut taken| {
            Ok(Request::Open { file: taken.text("file"), mechanism: taken.optional("mechanism") })
        },
    },
    Row {
        pattern: "save [<file:rest>]",
        help: "writes the text: back, or to a file that is not there yet",
        request: |mut taken| Ok(Request::Save(taken.optional("file"))),
    },
    Row {
        pattern: "help [<topic:any>]",
        help: "lists what can be said",
        request: |mut taken| Ok(Request::Help(taken.optional("topic"))),
    },
    Row { pattern: "quit", help: "ends the dialogue", request: |_| Ok(Request::Quit) },
];
