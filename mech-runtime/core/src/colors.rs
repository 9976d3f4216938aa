//! The numbers of the colours that every ready-made palette has, by name.

/// Names and numbers, in the order of the numbers.
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
