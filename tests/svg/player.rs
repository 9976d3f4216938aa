//! A player of animated SVG: just what the standards say of key frames of `transform` and `visibility`.

use resvg::usvg::roxmltree::{Document, Node};
use std::collections::HashMap;

/// A transform of CSS: a shift in pixels, then a turn in degrees.
type Key = (f64, [f64; 3]);

/// All that moves in a document.
pub(crate) struct Player<'a> {
    document: &'a Document<'a>,
    tracks: HashMap<&'a str, Vec<Key>>,
    pub(crate) period: f64,
}

impl<'a> Player<'a> {
    pub(crate) fn new(document: &'a Document<'a>) -> Self {
        let style = document
            .descendants()
            .find(|node| node.has_tag_name("style"));
        let style = style.and_then(|style| style.text()).unwrap_or_default();
        assert!(
            style.is_empty()
                || style.contains(
                    "@media (prefers-reduced-motion:reduce){.move{animation:none!important}}"
                )
        );
        let mut tracks = HashMap::new();
        let mut period = f64::NAN;
        for line in style.lines() {
            if let Some(remainder) = line.strip_prefix(".move{animation:linear ") {
                period = remainder
                    .strip_suffix("s infinite}")
                    .expect("a period")
                    .parse()
                    .expect("a number");
            } else if let Some((name, remainder)) = line
                .strip_prefix("@keyframes track")
                .and_then(|remainder| remainder.split_once('{'))
            {
                tracks.insert(name, keys(remainder.strip_suffix('}').expect("an end")));
            }
        }
        Self {
            document,
            tracks,
            period,
        }
    }

    /// The figures that are seen at a phase in `0.0..1.0`, from back to front, each with the transform of its group.
    pub(crate) fn seen(&self, phase: f64) -> Vec<(Node<'a, 'a>, [f64; 6])> {
        let groups = self
            .document
            .root_element()
            .children()
            .filter(|node| node.has_tag_name("g"));
        let mut seen = Vec::new();
        for group in groups {
            let classes: Vec<_> = group
                .attribute("class")
                .unwrap_or_default()
                .split(' ')
                .collect();
            let track = classes.iter().find_map(|class| class.strip_prefix("track"));
            let transform = match track {
                Some(track) => at(&self.tracks[track], phase),
                None => group
                    .attribute("transform")
                    .map_or([1.0, 0.0, 0.0, 1.0, 0.0, 0.0], matrix),
            };
            if classes.contains(&"show") && !self.is_shown(&group, phase) {
                continue;
            }
            let figures = group.children().filter(Node::is_element);
            seen.extend(figures.map(|figure| (figure, transform)));
        }
        seen
    }

    fn is_shown(&self, group: &Node<'_, '_>, phase: f64) -> bool {
        let delay = group.attribute("style").expect("a delay");
        let delay = delay
            .strip_prefix("animation-delay:")
            .and_then(|delay| delay.strip_suffix('s'));
        let delay: f64 = delay.expect("a delay").parse().expect("a number");
        let style = self
            .document
            .descendants()
            .find(|node| node.has_tag_name("style"));
        let text = style.and_then(|style| style.text()).expect("a style");
        let end = text
            .split_once("@keyframes show{0%{visibility:visible}")
            .expect("key frames")
            .1;
        let end: f64 = end
            .split_once('%')
            .expect("an end")
            .0
            .parse()
            .expect("a number");
        (phase - delay / self.period).rem_euclid(1.0) * 100.0 < end
    }
}

fn keys(mut text: &str) -> Vec<Key> {
    let mut keys = Vec::new();
    while let Some((time, remainder)) = text.split_once('{') {
        let (transform, remainder) = remainder.split_once('}').expect("an end");
        let time = if time == "to" {
            100.0
        } else {
            time.strip_suffix('%')
                .expect("percent")
                .parse()
                .expect("a number")
        };
        let transform = transform
            .strip_prefix("transform:translate(")
            .expect("a shift");
        let (shift, turn) = transform.split_once(')').expect("an end");
        let (x, y) = shift.split_once(',').expect("two numbers");
        let [x, y] = [x, y].map(|pixels| {
            pixels
                .strip_suffix("px")
                .expect("pixels")
                .parse()
                .expect("a number")
        });
        let turn = turn.trim().strip_prefix("rotate(").map_or(0.0, |turn| {
            turn.strip_suffix("deg)")
                .expect("degrees")
                .parse()
                .expect("a number")
        });
        keys.push((time / 100.0, [x, y, turn]));
        text = remainder;
    }
    assert_eq!((keys[0].0, keys[keys.len() - 1].0), (0.0, 1.0));
    assert!(keys.is_sorted_by(|one, next| one.0 < next.0));
    keys
}

/// The transform on a straight line from key to key.
fn at(keys: &[Key], phase: f64) -> [f64; 6] {
    let next = keys
        .partition_point(|(time, _)| *time <= phase)
        .clamp(1, keys.len() - 1);
    let ((start, one), (end, other)) = (keys[next - 1], keys[next]);
    let share = (phase - start) / (end - start);
    let [x, y, turn] = std::array::from_fn(|part| one[part] + (other[part] - one[part]) * share);
    let (sin, cos) = turn.to_radians().sin_cos();
    [cos, sin, -sin, cos, x, y]
}

fn matrix(transform: &str) -> [f64; 6] {
    let (kind, numbers) = transform
        .trim_end_matches(')')
        .split_once('(')
        .expect("a transform");
    let numbers: Vec<f64> = numbers
        .split(' ')
        .map(|number| number.parse().expect("a number"))
        .collect();
    match (kind, numbers.as_slice()) {
        ("matrix", numbers) => numbers.try_into().expect("six"),
        ("translate", &[x, y]) => [1.0, 0.0, 0.0, 1.0, x, y],
        _ => panic!("a transform `{transform}`"),
    }
}

/// Where a transform carries a point.
pub(crate) fn carried([a, b, c, d, e, f]: [f64; 6], [x, y]: [f64; 2]) -> [f64; 2] {
    [a * x + c * y + e, b * x + d * y + f]
}
