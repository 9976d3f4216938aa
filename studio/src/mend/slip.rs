//! Slips of a hand: changes of a word or a mark near what a message is about. Whether one mends the text is tried, not told.

use super::near::{Near, Slip};
use super::{Mending, Remainder};
use crate::document::{Declaration, Document, Message, Source};
use crate::failure::Failure;
use crate::text::{Replacement, written};
use mech_compiler::model::Model;
use mech_compiler::{catch, compile};
use std::collections::BTreeSet;

/// Changes are looked for near so many messages.
const MESSAGES: usize = 3;
/// So many changes of a text are tried at most. In all, so many bytes are read for that, of which a link or joint counts for some.
const MOST: usize = 600;
const BYTES: usize = 1 << 20;
const EACH: usize = 200;
/// Changes of so many letters are not written out in words.
const LONG: usize = 40;
/// So many that make it move are enough.
const ENOUGH: usize = 3;
/// Of those that leave something else wrong, so many.
const PARTIAL: usize = 2;

/// The changes of one word or mark after which a text can be read that cannot be read now, the likeliest first.
pub(super) fn mendings_of_slips(
    document: &Document,
    declaration: &Declaration,
    messages: &[Message],
    model: &Model,
) -> Result<Vec<Mending>, Failure> {
    let mut trials = Trials::new(document, declaration)?;
    if let Some(change) = document.change_to_lex(declaration) {
        trials.lex(change)?;
        return Ok(trials.mendings());
    }
    let Some(near) = Near::new(document, declaration) else {
        return Ok(Vec::new());
    };
    let most = MOST.min(BYTES / cost(document, model));
    let messages = messages.iter().take(MESSAGES);
    let slips = messages.flat_map(|message| near.slips(message));
    for slip in slips.take(most) {
        if trials.whole.len() == ENOUGH {
            break;
        }
        trials.attempt(slip)?;
    }
    Ok(trials.mendings())
}

/// How much there is to read in a text, in bytes.
fn cost(document: &Document, model: &Model) -> usize {
    document.source().text().len() + EACH * (1 + model.links.len() + model.joints.len())
}

/// The changes that were tried so far.
struct Trials<'d> {
    document: &'d Document,
    /// The number of the mechanism in its file.
    index: usize,
    seen: BTreeSet<String>,
    /// After these it moves.
    whole: Vec<Mending>,
    /// After these its text can be read.
    partial: Vec<Mending>,
}

impl<'d> Trials<'d> {
    fn new(document: &'d Document, declaration: &Declaration) -> Result<Self, Failure> {
        Ok(Self {
            index: document.index_of(declaration)?,
            document,
            seen: BTreeSet::new(),
            whole: Vec::new(),
            partial: Vec::new(),
        })
    }

    /// Makes the change after which the text lexes.
    fn lex(&mut self, change: Replacement) -> Result<(), Failure> {
        let source = self.document.source();
        let (before, range) = (&source.text()[change.range.clone()], &change.range);
        let is_long = before.len().max(change.text.len()) > LONG;
        let follows = source.text()[range.end..].split_whitespace().next();
        let words = match (before, &*change.text) {
            _ if is_long => "write it with the signs of the keyboard".to_owned(),
            ("", text) => {
                format!("write `{}` before `{}`", text.trim(), follows.unwrap_or("the end"))
            }
            (before, "") => format!("remove `{before}`"),
            (before, text) => format!("write `{text}` for `{before}`"),
        };
        self.attempt(Slip { words, edits: vec![change] })
    }

    /// Makes a change, and looks at what comes of it.
    fn attempt(&mut self, slip: Slip) -> Result<(), Failure> {
        let source = self.document.source();
        let text = written(source.text(), &slip.edits);
        let mut known = self.whole.iter().chain(&self.partial);
        if known.any(|known| known.words == slip.words) || !self.seen.insert(text.clone()) {
            return Ok(());
        }
        let changed = Document::of(Source::new(source.path(), text));
        let Some(declaration) = changed.declarations().get(self.index) else {
            return Ok(());
        };
        // It cannot be read.
        let Some(model) = changed.model(declaration)? else {
            return Ok(());
        };
        let compiled = catch(|| compile(&model)).map_err(Failure::internal)?;
        let (found, remainder) = match compiled {
            Ok(_) => (&mut self.whole, Remainder::Nothing),
            Err(_) => (&mut self.partial, Remainder::OtherFaults),
        };
        // What is left out mends nothing if something else is wrong then.
        let adds = slip.edits.iter().any(|edit| !edit.text.is_empty());
        if remainder == Remainder::Nothing || adds && found.len() < PARTIAL {
            found.push(Mending {
                words: slip.words,
                remainder,
                text: changed.source().text().to_owned(),
            });
        }
        Ok(())
    }

    fn mendings(mut self) -> Vec<Mending> {
        self.whole.extend(self.partial);
        self.whole
    }
}
