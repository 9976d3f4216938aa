//! The guides on which connectors slide.

use super::document::{Document, Slide};
use super::unions::Unions;
use crate::import::drawing::{End, Omission, Pair};
use std::collections::{BTreeMap, BTreeSet};

/// The largest distance of a connector from its arc, as a part of the radius.
const OFF: f64 = 1e-3;

/// A guide, which lets a connector slide.
#[derive(Clone, Copy, Debug)]
pub(super) enum Guide {
    /// It turns and slides. The first end has the connector, the second has the slot.
    Slot { ends: [End; 2], along: Pair },
    /// It slides without turning, because two connectors of the link slide on one line.
    Line { ends: [End; 2], along: Pair },
    /// It slides on an arc about this centre. The first end has the connector, the second has the arc.
    Arc { ends: [End; 2], center: Pair },
}

/// A connector that slides, with what has it.
struct Slider {
    connector: usize,
    slide: Slide,
    own: Vec<End>,
    /// The link on which it slides.
    on: End,
}

/// Finds the guide of each connector, and the omissions where there is none.
pub(super) fn guides(
    document: &Document,
    unions: &Unions,
) -> (BTreeMap<usize, Guide>, Vec<Omission>) {
    let mut faults = Vec::new();
    let mut sliders = Vec::new();
    for (number, connector) in document.connectors.iter().enumerate() {
        let Some(slide) = connector.slide else {
            continue;
        };
        match slider(document, unions, number, slide) {
            Ok(slider) => sliders.push(slider),
            Err(what) => faults.push(Omission::new(format!("connector {}", connector.id), what)),
        }
    }
    if !sliders.is_empty() {
        let what = "pins go on beyond the ends of slots, which stop nothing in the language";
        faults.push(Omission::new("sliders", what));
    }
    let mut guides = BTreeMap::new();
    let mut guided = BTreeSet::new();
    for slider in &sliders {
        let connector = &document.connectors[slider.connector];
        let partner = slider.own.iter().find(|end| {
            let mut others = sliders.iter();
            others.any(|other| slider.is_on_line_of(other) && other.own.contains(end))
        });
        let along = along(document, slider.slide.limits);
        let guide = match (slider.slide.radius, partner) {
            (Some(radius), _) => arc(document, slider, radius),
            (None, Some(end)) => {
                let is_first = guided.insert((*end, slider.on));
                // The ground first.
                let ends = [slider.on.min(*end), slider.on.max(*end)];
                Ok(is_first.then_some(Guide::Line { ends, along }))
            }
            (None, None) => {
                let ends = [slider.own[0], slider.on];
                Ok(Some(Guide::Slot { ends, along }))
            }
        };
        match guide {
            Ok(guide) => guides.extend(guide.map(|guide| (slider.connector, guide))),
            Err(what) => faults.push(Omission::new(format!("connector {}", connector.id), what)),
        }
    }
    (guides, faults)
}

impl Slider {
    /// Whether another connector slides on the same line.
    fn is_on_line_of(&self, other: &Self) -> bool {
        let sorted = |[a, b]: [usize; 2]| [a.min(b), a.max(b)];
        self.connector != other.connector
            && self.on == other.on
            && self.slide.radius.is_none()
            && other.slide.radius.is_none()
            && sorted(self.slide.limits) == sorted(other.slide.limits)
    }
}

fn slider(
    document: &Document,
    unions: &Unions,
    connector: usize,
    slide: Slide,
) -> Result<Slider, &'static str> {
    let own = unions.at(document, connector);
    if own.is_empty() {
        return Err("it slides, but is on no link");
    }
    let [first, second] = slide.limits.map(|limit| unions.at(document, limit));
    let mut common = first.iter().filter(|end| second.contains(end));
    let on = common.find(|end| !own.contains(end));
    let on = on.ok_or("the two connectors between which it slides are on no other common link")?;
    if along(document, slide.limits) == [0.0, 0.0] {
        return Err("the two connectors between which it slides are at one place");
    }
    Ok(Slider { connector, slide, own, on: *on })
}

/// The vector from one limit to the other.
fn along(document: &Document, limits: [usize; 2]) -> Pair {
    let [from, to] = limits.map(|limit| document.connectors[limit].at);
    [to[0] - from[0], to[1] - from[1]]
}

/// The arc of this radius through both limits whose centre fits the connector.
fn arc(document: &Document, slider: &Slider, radius: f64) -> Result<Option<Guide>, &'static str> {
    let [from, to] = slider.slide.limits.map(|limit| document.connectors[limit].at);
    let half = [(to[0] - from[0]) / 2.0, (to[1] - from[1]) / 2.0];
    let length = half[0].hypot(half[1]);
    let height = (radius * radius - length * length).max(0.0).sqrt() / length;
    let at = document.connectors[slider.connector].at;
    let off = |center: &Pair| ((at[0] - center[0]).hypot(at[1] - center[1]) - radius).abs();
    let centers = [height, -height]
        .map(|height| [from[0] + half[0] - half[1] * height, from[1] + half[1] + half[0] * height]);
    let center = centers.into_iter().min_by(|a, b| off(a).total_cmp(&off(b)));
    let center = center.filter(|center| off(center) <= OFF * radius);
    let center = center.ok_or("it is not on the arc on which it slides")?;
    let ends = [slider.own[0], slider.on];
    Ok(Some(Guide::Arc { ends, center }))
}
