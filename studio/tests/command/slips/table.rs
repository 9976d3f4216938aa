//! What is true of all answers, as a table.

use super::judge::{Answer, Said};
use std::time::Duration;

/// A kind of slip, and the answers to it.
type Row<'a> = (&'a str, Vec<Answer>);

/// The measures over all kinds, in percent.
#[derive(Debug)]
pub(super) struct Total {
    pub(super) placed: usize,
    pub(super) single: usize,
    pub(super) mended: usize,
    pub(super) dishonest: usize,
}

/// Prints the table, and returns its last row.
pub(super) fn print(rows: &[Row<'_>]) -> Total {
    println!(
        "| slip | texts | refused | placed % | single % | mended % | dishonest | check ms | fix ms |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for (name, answers) in rows {
        print_row(name, &answers.iter().collect::<Vec<_>>());
    }
    let all: Vec<&Answer> = rows.iter().flat_map(|(_, answers)| answers).collect();
    print_row("**all**", &all)
}

fn print_row(name: &str, answers: &[&Answer]) -> Total {
    let said: Vec<&Said> = answers.iter().filter_map(|one| one.said.as_ref()).collect();
    let percent = |count: usize| count * 100 / said.len().max(1);
    let share = |is: fn(&Said) -> bool| percent(said.iter().filter(|one| is(one)).count());
    let dishonest: usize = said.iter().map(|one| one.dishonest).sum();
    let slowest = |time: fn(&Answer) -> Duration| {
        let times = answers.iter().map(|one| time(one).as_millis());
        times.max().unwrap_or(0)
    };
    let total = Total {
        placed: share(|one| one.is_placed),
        single: share(|one| one.is_single),
        mended: share(|one| one.is_mended),
        dishonest: (dishonest * 100).div_ceil(said.len().max(1)),
    };
    println!(
        "| {name} | {} | {} | {} | {} | {} | {dishonest} | {} | {} |",
        answers.len(),
        said.len(),
        total.placed,
        total.single,
        total.mended,
        slowest(|one| one.check),
        slowest(|one| one.fix),
    );
    total
}

/// Prints the three worst answers to each kind.
pub(super) fn print_worst(rows: &[Row<'_>], most: usize) {
    for (name, answers) in rows {
        let mut worst: Vec<&Answer> = answers.iter().collect();
        worst.sort_by_key(|one| one.said.as_ref().map_or(ACCEPTED, worth));
        println!("\n{name}:");
        for answer in worst.into_iter().take(most) {
            let words = answer.said.as_ref().map_or("accepted", |said| &said.words);
            println!("  {}\n      {words}", answer.line);
        }
    }
}

/// How good it is to accept a slip: many make another mechanism that moves.
const ACCEPTED: i32 = 4;

/// How good an answer is: no promise is broken, then its place, its number, its repair.
fn worth(said: &Said) -> i32 {
    match said {
        Said { dishonest: 1.., .. } => -1,
        Said { is_placed: false, .. } => 1,
        Said { is_single: false, .. } => 2,
        Said { is_mended: false, .. } => 3,
        _ => ACCEPTED + 1,
    }
}
