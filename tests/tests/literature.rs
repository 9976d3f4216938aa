//! Mechanisms of the literature, and its tables in `literature/`: numbers that nobody of this project made.
//! `PMKS_Verification` is a collection of what three independent programs agree on.

include!(concat!(env!("OUT_DIR"), "/literature.rs"));

/// The rows of a table. Lines with `#` say where it is from, and what its columns are.
pub(crate) fn rows<const N: usize>(table: &str) -> Vec<[f64; N]> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    let row = |line: &str| {
        let numbers = line.split_whitespace().map(str::parse);
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>().expect("numbers");
        numbers.try_into().expect("so many columns")
    };
    let rows: Vec<[f64; N]> = lines.map(row).collect();
    assert!(rows.len() > 2, "{} rows are no table", rows.len());
    rows
}
