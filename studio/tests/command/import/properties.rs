//! Random drawings: what is imported stands where it was drawn, from either program.

use super::encoder::{Encoder, GROUNDED, INPUT, checked};
use super::moving::{Moving, Place, distance, place_of, reading};
use super::sample;
use crate::run::{Folder, mech_in};
use proptest::prelude::*;
use proptest::sample::Index;

/// Pixels in a millimetre.
const PIXELS: f64 = 96.0 / 25.4;

/// A crank, and pairs of links: each pair goes from a pin of an earlier link to a new pivot on the ground.
#[derive(Clone, Debug)]
struct Chain {
    crank: [Place; 2],
    pairs: Vec<Pair>,
}

#[derive(Clone, Debug)]
struct Pair {
    /// The joint from which it goes.
    from: Index,
    knee: Place,
    pivot: Place,
}

/// A joint of a chain: its id, where it is, and whether it is on the ground.
struct Joint {
    id: String,
    at: Place,
    is_grounded: bool,
}

/// Places as a link can hold them.
fn place() -> impl Strategy<Value = Place> {
    let part = (-9000..9000_i32).prop_map(|thousandths| f64::from(thousandths) / 1000.0);
    [part.clone(), part]
}

fn chain() -> impl Strategy<Value = Chain> {
    let pair = (any::<Index>(), place(), place()).prop_map(|(from, knee, pivot)| Pair {
        from,
        knee,
        pivot,
    });
    let pairs = prop::collection::vec(pair, 1..4);
    ([place(), place()], pairs).prop_map(|(crank, pairs)| Chain { crank, pairs })
}

impl Chain {
    /// Its joints, and the two joints of each link.
    fn parts(&self) -> (Vec<Joint>, Vec<[usize; 2]>) {
        let mut joints = Vec::new();
        let mut add = |at: Place, is_grounded| {
            let id = char::from(b'A' + u8::try_from(joints.len()).expect("few"));
            joints.push(Joint { id: id.to_string(), at, is_grounded });
            joints.len() - 1
        };
        let shaft = add(self.crank[0], true);
        let mut pins = vec![add(self.crank[1], false)];
        let mut links = vec![[shaft, pins[0]]];
        for pair in &self.pairs {
            let from = pins[pair.from.index(pins.len())];
            let knee = add(pair.knee, false);
            let pivot = add(pair.pivot, true);
            links.push([from, knee]);
            links.push([knee, pivot]);
            pins.push(knee);
        }
        (joints, links)
    }

    fn encoder(&self) -> Encoder {
        let (joints, links) = self.parts();
        let mut encoder = Encoder::default();
        for (number, joint) in joints.iter().enumerate() {
            let input = if number == 0 { INPUT } else { 0 };
            let grounded = if joint.is_grounded { GROUNDED } else { 0 };
            encoder = encoder.joint(input | grounded, &joint.id, joint.at, 0.0);
        }
        for ends in links {
            let ids = ends.map(|end| &*joints[end].id);
            encoder = encoder.link(&ids.concat(), &ids);
        }
        encoder
    }

    fn to_document(&self) -> String {
        let (joints, links) = self.parts();
        let mut text = "<linkage2>\n<program units=\"Millimeters\"/>\n".to_owned();
        for (number, joint) in joints.iter().enumerate() {
            let [x, y] = joint.at.map(|part| part * PIXELS);
            let (id, is_grounded, is_input) = (&joint.id, joint.is_grounded, number == 0);
            text += &format!(
                "<connector id=\"{number}\" name=\"{id}\" x=\"{x:.6}\" y=\"{y:.6}\" anchor=\"{is_grounded}\" input=\"{is_input}\"/>\n"
            );
        }
        for (number, ends) in links.iter().enumerate() {
            let ends = ends.map(|end| format!("<connector id=\"{end}\"/>")).concat();
            text += &format!("<Link id=\"{number}\">{ends}</Link>\n");
        }
        text + "</linkage2>\n"
    }

    /// All joints stand where they were drawn; where the mechanism moves, no link changes its length.
    fn is_kept(&self, text: &str) -> Result<(), TestCaseError> {
        let (joints, links) = self.parts();
        let read = reading(text);
        prop_assert_eq!(read.model.motors.len(), 1);
        for joint in &joints {
            let found = place_of(&read.model, &joint.id.to_lowercase());
            let found = found.ok_or_else(|| TestCaseError::fail(text.to_owned()))?;
            prop_assert!(distance(found, joint.at) < 1e-6, "{:?}\n{}", found, text);
        }
        prop_assert_eq!(read.model.links.len(), links.len() + 1);
        // A mechanism that moves at all was assembled as drawn.
        if read.result.is_ok() {
            Moving::of(text).stands(&[("a", self.crank[0])]);
        }
        Ok(())
    }
}

/// The text of what is imported, whether it moves or not.
fn text_of(folder: &Folder, word: &str) -> Result<String, TestCaseError> {
    let answer = mech_in(&folder.path("."), &["import", word]);
    prop_assert!(matches!(answer.code, Some(0 | 1)), "{}", answer.err);
    Ok(answer.out)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn chains_stand_where_they_were_drawn(chain in chain()) {
        let folder = Folder::new().with("chain.linkage2", chain.to_document());
        chain.is_kept(&text_of(&folder, &chain.encoder().url())?)?;
        chain.is_kept(&text_of(&folder, "chain.linkage2")?)?;
    }

    /// Documents and links of which something was changed are read or refused, and nothing breaks.
    #[test]
    fn nothing_breaks(
        which in any::<Index>(),
        at in any::<Index>(),
        length in 0..12_usize,
        by in "[ -~]{0,6}",
        chain in chain(),
    ) {
        const NAMES: [&str; 4] = ["quick_return", "gears", "six_bar", "lift"];
        let number = which.index(NAMES.len() + 1);
        let text = NAMES.get(number).map(|name| sample(name));
        let is_link = text.is_none();
        let text = text.unwrap_or_else(|| chain.encoder().body());
        let start = at.index(text.len());
        let end = (start + length).min(text.len());
        let changed = format!("{}{by}{}", &text[..start], &text[end..]);
        // A link that does not pass its check would not be read any further.
        let changed = if is_link { format!("?{}", checked(&changed)) } else { changed };
        let folder = Folder::new().with("a.linkage2", changed);
        let answer = folder.mech("import a.linkage2");
        prop_assert!(matches!(answer.code, Some(0 | 1 | 3)), "{:?}", answer);
    }
}
