//! A player of animated SVG: just what the standards say of key frames of `transform` and `visibility`.

use std::collections::HashMap;

/// A time as a part of the period; a shift in pixels, then a turn in degrees.
type Key = (f64, [f64; 3]);

/// What a film shows at a phase in `0.0..1.0`, as a still picture; what is hidden is left out.
pub(crate) fn still(film: &str, phase: f64) -> String {
    let reduced = "@media (prefers-reduced-motion:reduce){.move{animation:none!important}}";
    assert_eq!(film.contains("<style"), film.contains(reduced));
    let (mut period, mut shown, mut tracks) = (f64::NAN, f64::NAN, HashMap::new());
    let mut picture = String::new();
    // How many groups are open, and how many when those began that are hidden.
    let (mut depth, mut hidden) = (0, usize::MAX);
    for line in film.lines() {
        if let Some([text]) = between(line, [".move{animation:linear ", "s infinite}"]) {
            period = number(text);
        } else if let Some([end]) = between(line, ["@keyframes show{0%{visibility:visible}", "%"]) {
            shown = number(end) / 100.0;
        } else if let Some([name, keys]) = between(line, ["@keyframes ", "{", "}}"]) {
            tracks.insert(name, place(keys, phase));
        } else if line.starts_with("<g") {
            depth += 1;
            let delay = between(line, ["animation-delay:", "s\""]).map(|[delay]| number(delay));
            if delay.is_some_and(|delay| (phase - delay / period).rem_euclid(1.0) >= shown) {
                hidden = hidden.min(depth);
            }
            if depth < hidden {
                let moved = between(line, ["class=\"move ", "\" transform"]);
                let moved = moved.map(|[track]| {
                    let [x, y, turn] = tracks[track];
                    format!("<g transform=\"translate({x},{y}) rotate({turn})\">")
                });
                let own = delay.map_or(line, |_| "<g>");
                picture.push_str(moved.as_deref().unwrap_or(own));
            }
        } else {
            if depth < hidden {
                picture.push_str(line);
            }
            if line == "</g>" {
                depth -= 1;
                if depth < hidden {
                    hidden = usize::MAX;
                }
            }
        }
        picture.push('\n');
    }
    assert_eq!(depth, 0, "what begins has to end");
    picture
}

/// The texts between marks, if these follow each other.
fn between<'t, const N: usize, const M: usize>(
    mut text: &'t str,
    marks: [&str; M],
) -> Option<[&'t str; N]> {
    let mut parts = Vec::new();
    for mark in marks {
        let (part, remainder) = text.split_once(mark)?;
        parts.push(part);
        text = remainder;
    }
    parts.split_off(1).try_into().ok()
}

fn number(text: &str) -> f64 {
    text.parse().expect("a number")
}

/// The shift and the turn at a phase, on a straight line from key to key.
fn place(text: &str, phase: f64) -> [f64; 3] {
    let keys: Vec<Key> = text.split('}').map(key).collect();
    assert_eq!((keys[0].0, keys[keys.len() - 1].0), (0.0, 1.0));
    assert!(keys.is_sorted_by(|one, next| one.0 < next.0));
    let next = keys.partition_point(|(time, _)| *time <= phase);
    let next = next.clamp(1, keys.len() - 1);
    let ((start, one), (end, other)) = (keys[next - 1], keys[next]);
    let share = (phase - start) / (end - start);
    std::array::from_fn(|part| one[part] + (other[part] - one[part]) * share)
}

fn key(text: &str) -> Key {
    let (time, transform) = text.split_once("{transform:").expect("a transform");
    let time = time.strip_suffix('%').map_or(1.0, |time| number(time) / 100.0);
    let [x, y] = between(transform, ["translate(", "px,", "px)"]).expect("a shift");
    let turn = between(transform, ["rotate(", "deg)"]).map_or(0.0, |[turn]| number(turn));
    (time, [number(x), number(y), turn])
}
