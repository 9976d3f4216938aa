//! The named colours of all ready-made palettes.

/// The names and entries of the colours, in the order of the entries.
pub const NAMED: [(&str, u8); 18] = [
    ("paper", 0),
    ("ground", 1),
    ("blue", 2),
    ("orange", 3),
    ("teal", 4),
    ("red", 5),
    ("yellow", 6),
    ("purple", 7),
    ("green", 8),
    ("pink", 9),
    ("sky", 10),
    ("brown", 11),
    ("olive", 12),
    ("slate", 13),
    ("ink", 14),
    ("eye", 15),
    ("hatch", 16),
    ("steel", 17),
];
