//! A picture of times over numbers of loops, both logarithmic, as SVG.

use std::fmt::Write;

/// What was measured of one way to solve chains.
pub(crate) struct Line {
    pub(crate) name: String,
    /// Numbers of loops, and nanoseconds a position.
    pub(crate) points: Vec<(f64, f64)>,
}

impl Line {
    /// The exponent of the power of the number of loops that fits best: least squares of the logarithms, from 10 loops on.
    pub(crate) fn exponent(&self) -> f64 {
        let points: Vec<(f64, f64)> = self
            .points
            .iter()
            .filter(|point| point.0 >= 10.0)
            .map(|(loops, time)| (loops.ln(), time.ln()))
            .collect();
        let count = points.len() as f64;
        let mean = |part: fn(&(f64, f64)) -> f64| points.iter().map(part).sum::<f64>() / count;
        let (x, y) = (mean(|point| point.0), mean(|point| point.1));
        let (up, across) = points.iter().fold((0.0, 0.0), |(up, across), point| {
            let off = point.0 - x;
            (up + off * (point.1 - y), across + off * off)
        });
        up / across
    }
}

const SIZE: [f64; 2] = [640.0, 420.0];
const MARGIN: [f64; 2] = [70.0, 40.0];
const COLORS: [&str; 3] = ["#1b6ca8", "#2a9d5c", "#c8501e"];

/// The picture.
pub(crate) fn svg(lines: &[Line]) -> String {
    let all = || lines.iter().flat_map(|line| &line.points);
    let decades = |part: fn(&(f64, f64)) -> f64| {
        let logs = || all().map(part).map(f64::log10);
        [logs().fold(f64::INFINITY, f64::min).floor(), logs().fold(0.0, f64::max).ceil()]
    };
    let (across, up) = (decades(|point| point.0), decades(|point| point.1));
    let x = |loops: f64| {
        MARGIN[0]
            + (loops.log10() - across[0]) / (across[1] - across[0]) * (SIZE[0] - 2.0 * MARGIN[0])
    };
    let y = |time: f64| {
        SIZE[1] - MARGIN[1] - (time.log10() - up[0]) / (up[1] - up[0]) * (SIZE[1] - 2.0 * MARGIN[1])
    };
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"13\">\n\
         <rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n",
        SIZE[0], SIZE[1]
    );
    let grid = |text: &mut String, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]| {
        let _ = writeln!(text, "<path d=\"M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}\" stroke=\"#ddd\"/>");
    };
    let label = |text: &mut String, [x, y]: [f64; 2], anchor: &str, words: &str| {
        let _ = writeln!(
            text,
            "<text x=\"{x:.1}\" y=\"{y:.1}\" text-anchor=\"{anchor}\">{words}</text>"
        );
    };
    let (left, right) = (MARGIN[0], SIZE[0] - MARGIN[0]);
    let (top, bottom) = (MARGIN[1], SIZE[1] - MARGIN[1]);
    for decade in across[0] as i32..=across[1] as i32 {
        let at = x(10_f64.powi(decade));
        grid(&mut text, [at, top], [at, bottom]);
        let words = format!("{}", 10_f64.powi(decade));
        label(&mut text, [at, bottom + 18.0], "middle", &words);
    }
    for decade in up[0] as i32..=up[1] as i32 {
        let at = y(10_f64.powi(decade));
        grid(&mut text, [left, at], [right, at]);
        let words = match decade {
            ..3 => format!("{} ns", 10_f64.powi(decade)),
            3..6 => format!("{} µs", 10_f64.powi(decade - 3)),
            6..9 => format!("{} ms", 10_f64.powi(decade - 6)),
            _ => format!("{} s", 10_f64.powi(decade - 9)),
        };
        label(&mut text, [left - 8.0, at + 4.0], "end", &words);
    }
    label(&mut text, [SIZE[0] / 2.0, SIZE[1] - 6.0], "middle", "loops");
    label(&mut text, [left, top - 14.0], "start", "a position");
    for (line, color) in lines.iter().zip(COLORS) {
        let mut path = String::new();
        for (index, &(loops, time)) in line.points.iter().enumerate() {
            let command = if index == 0 { 'M' } else { 'L' };
            let _ = write!(path, "{command}{:.1} {:.1}", x(loops), y(time));
            let _ = writeln!(
                text,
                "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"3.5\" fill=\"{color}\"/>",
                x(loops),
                y(time)
            );
        }
        let _ = writeln!(
            text,
            "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>"
        );
        if let Some(&(loops, time)) = line.points.last() {
            let words = format!("{}: loops^{:.2}", line.name, line.exponent());
            let _ = write!(text, "<g fill=\"{color}\">");
            label(&mut text, [x(loops) - 8.0, y(time) - 8.0], "end", &words);
            let _ = writeln!(text, "</g>");
        }
    }
    text.push_str("</svg>\n");
    text
}
