//! The price list.

mod contestant;
mod double_double;
mod measurement;
mod method;
mod reference;
mod subject;

fn main() {
    for subject in subject::subjects() {
        let m = match measurement::measure(subject, measurement::Effort{rounds: 9, positions: 2000}) { Ok(m) => m, Err(e) => { eprintln!("{e}"); continue } };
        println!("{} size {} doubt {:e}", m.subject.title, m.size, m.doubt);
        for r in &m.rows { match &r.outcome {
            Ok(f) => println!("{:10} {} {:4} {:9.1e} {:8.1}", r.method.to_string(), r.precision, r.step.degrees(), f.error, f.nanoseconds),
            Err(s) => println!("{:10} {} {:4} blocked at {}: {} {}", r.method.to_string(), r.precision, r.step.degrees(), s.degrees, s.place, s.words),
        }}
    }
}
