//! A large mechanism to be measured.

/// A chain of four-bars, each driven by the rocker of the one before: three joints a loop, and the motor's.
pub(crate) fn chain(loops: usize) -> String {
    let mut text =
        "struct Chain;\nlink r0;\njoint a = revolute(ground, r0) at (0, 0);\n".to_owned();
    for number in 1..=loops {
        let before = number - 1;
        let x = 4.0 * count(before);
        text += &format!(
            "link c{number}; link r{number};\n\
             joint b{number} = revolute(r{before}, c{number}) at ({}, 0.6);\n\
             joint k{number} = revolute(c{number}, r{number}) at ({}, 2.9);\n\
             joint d{number} = revolute(ground, r{number}) at ({}, 0);\n",
            x + 0.8,
            x + 3.3,
            x + 4.0
        );
    }
    text + "motor a;\n"
}

/// A small number.
pub(crate) fn count(number: usize) -> f64 {
    u32::try_from(number).map_or(f64::NAN, f64::from)
}
