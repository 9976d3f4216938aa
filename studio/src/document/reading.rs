//! A mechanism of a document, read and analysed.
//!
//! The compiler tells places by spans, which are worth something only until the next text is read. So everything that leaves this file
//! has its place as a range of bytes in the file.

use super::unlexed::{self, Unlexed};
use super::{Declaration, Document, scanner};
use crate::failure::Failure;
use crate::text::Replacement;
use mech_compiler::model::{Model, Origin};
use mech_compiler::repair::Offers;
use mech_compiler::structure::Diagnosis;
use mech_compiler::syntax::{self, ListedName, ListedNumber, Place};
use mech_compiler::{Analysis, Compiled, Import, PartText, catch, limits};
use mech_runtime::parts;
use proc_macro2::{Group, Ident, LexError, Span, TokenStream, TokenTree};
use std::ops::Range;

/// A mechanism of a document, read and analysed.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Reading {
    /// The mechanism; where the text is wrong, as much of it as could be understood.
    pub model: Model,
    /// The compiled mechanism, or what is wrong.
    pub result: Result<Box<Compiled>, Faults>,
    /// Where everything in the model was declared, by [`Origin`].
    places: Vec<Range<usize>>,
    /// The whole call of the macro.
    whole: Range<usize>,
}

/// The faults of a mechanism.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Faults {
    /// All of it in words, at its places; never empty.
    pub messages: Vec<Message>,
    /// The diagnoses of the analysis; empty if the text itself is wrong.
    pub diagnoses: Vec<Diagnosis>,
    /// The repairs that each diagnosis offers.
    pub offers: Vec<Offers>,
}

/// A fault at a place. Lines that begin with `note:` or `help:` may follow its first line.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "transfer", derive(serde::Serialize, serde::Deserialize))]
pub struct Message {
    /// Where it stands in the file, in bytes.
    pub place: Range<usize>,
    /// The text for the user.
    pub text: String,
}

impl Reading {
    /// Where something was declared, in bytes; the whole mechanism if no text declared it.
    #[must_use]
    pub fn place(&self, origin: Origin) -> Range<usize> {
        let index = (origin.0 as usize).checked_sub(1);
        let place = index.and_then(|index| self.places.get(index));
        place.unwrap_or(&self.whole).clone()
    }
}

impl Document {
    /// Reads and analyses one of its mechanisms.
    ///
    /// # Errors
    /// If the compiler itself fails, which is a mistake of ours.
    pub fn analyse(&self, declaration: &Declaration) -> Result<Reading, Failure> {
        self.read_by(declaration, mech_compiler::analyse)
    }

    /// The same, with requirements proved.
    pub(crate) fn prove(&self, declaration: &Declaration) -> Result<Reading, Failure> {
        self.read_by(declaration, |text| mech_compiler::analyse(text).prove())
    }

    /// The same as far as the macro goes: requirements are proved, and its code is written, too, and thrown away.
    pub(crate) fn check(&self, declaration: &Declaration) -> Result<Reading, Failure> {
        self.read_by(declaration, |text| {
            let analysis = mech_compiler::analyse(text).prove();
            drop(mech_compiler::write(&TokenStream::new(), &analysis));
            analysis
        })
    }

    fn read_by(
        &self,
        declaration: &Declaration,
        analyse: impl FnOnce(TokenStream) -> Analysis,
    ) -> Result<Reading, Failure> {
        proc_macro2::extra::invalidate_current_thread_spans();
        let whole = &declaration.whole;
        let (text, instances) = match self
            .tokens_of(declaration)
            .map_err(|message| vec![message])
            .and_then(|tokens| Ok((self.with_parts(declaration, tokens.clone())?, tokens)))
        {
            Ok((text, tokens)) => (text, instances(tokens)),
            Err(messages) => {
                return Ok(Reading {
                    model: Model::new("", Origin::default()),
                    result: Err(Faults { messages, diagnoses: Vec::new(), offers: Vec::new() }),
                    places: Vec::new(),
                    whole: whole.clone(),
                });
            }
        };
        let analysis = catch(|| analyse(text)).map_err(Failure::internal)?;
        let Analysis { parsed, result } = analysis;
        let result = result.map_err(|faults| Faults {
            messages: at_instances(in_bytes(&faults.messages, whole), &instances),
            diagnoses: faults.diagnoses,
            offers: faults.offers,
        });
        let places = parsed.places.all().map(|place| range_of(place, whole));
        Ok(Reading { places: places.collect(), model: parsed.model, result, whole: whole.clone() })
    }

    /// Reads the model from the text of one of its mechanisms, even if that is no mechanism; none if the text is wrong.
    ///
    /// # Errors
    /// If the compiler itself fails, which is a mistake of ours.
    pub fn model(&self, declaration: &Declaration) -> Result<Option<Model>, Failure> {
        proc_macro2::extra::invalidate_current_thread_spans();
        let Ok(text) = self.text_of(declaration) else {
            return Ok(None);
        };
        let parsed = catch(|| syntax::parse(text)).map_err(Failure::internal)?;
        let is_right = parsed.errors.is_empty() && parsed.header.is_some();
        Ok(is_right.then_some(parsed.model))
    }

    /// Finds the faults in the texts of the parts that are kept for other mechanisms.
    ///
    /// # Errors
    /// If the compiler itself fails, which is a mistake of ours.
    pub fn faults_of_parts(&self) -> Result<Vec<Message>, Failure> {
        let mut found = Vec::new();
        for part in &self.parts {
            proc_macro2::extra::invalidate_current_thread_spans();
            match self.tokens_of(part) {
                Ok(tokens) => {
                    let read = catch(|| PartText::read(&tokens)).map_err(Failure::internal)?;
                    let errors = read.err().unwrap_or_default();
                    found.extend(in_bytes(&errors, &part.whole));
                }
                Err(message) => found.push(message),
            }
        }
        Ok(found)
    }

    /// The tokens of a mechanism, with all parts that it takes from elsewhere.
    pub(super) fn text_of(&self, declaration: &Declaration) -> Result<TokenStream, Vec<Message>> {
        let text = self.tokens_of(declaration).map_err(|message| vec![message])?;
        self.with_parts(declaration, text)
    }

    /// The same tokens with the parts written out that they take from elsewhere.
    fn with_parts(
        &self,
        declaration: &Declaration,
        text: TokenStream,
    ) -> Result<TokenStream, Vec<Message>> {
        Import::write_out(text, |import| self.imported(import)).map_err(|unknown| {
        if let Some(fault) = unknown.fault() {
            return in_bytes(&[fault], &declaration.whole);
        }
        let place = range_of(Place::of(&unknown.path), &declaration.whole);
        let name = unknown.name().map(|name| name.to_string());
        let text = format!(
            "part `{}` is not known here\n\nnote: parts are taken from the same file, and from `mech_runtime::parts`",
            name.unwrap_or_default()
        );
        vec![Message { place, text }]
    })
    }

    /// The text of a part that a mechanism takes from elsewhere: from its own file, or from the runtime.
    fn imported(&self, import: &Import) -> Option<TokenStream> {
        if import.fault().is_some() {
            return None;
        }
        let name = import.name()?;
        let here = self.parts.iter().find_map(|part| {
            let body = part.body.as_ref()?;
            if self.excess(body).is_some() {
                return None;
            }
            let tokens = self.tokens(body).ok()?;
            let part = PartText::read(&tokens).ok()?;
            (part.name == name).then_some(part.body)
        });
        here.or_else(|| library_part(&name))
    }

    pub(super) fn tokens_of(&self, declaration: &Declaration) -> Result<TokenStream, Message> {
        self.lexed(declaration).map_err(|Unlexed { place, text, .. }| Message { place, text })
    }

    /// The tokens of a mechanism, or what keeps it from having any.
    fn lexed(&self, declaration: &Declaration) -> Result<TokenStream, Unlexed> {
        let Some(body) = &declaration.body else {
            return Err(self.endless(declaration));
        };
        if let Some(excess) = self.excess(body) {
            return Err(excess);
        }
        let tokens = self.tokens(body);
        let (text, start) = (self.source().text(), declaration.whole.start);
        let is_doubtful = scanner::has_doubtful_end(text, start, body.end);
        let tokens = match tokens {
            Ok(tokens) if !is_doubtful => return Ok(tokens),
            tokens => tokens,
        };
        // A brace too many ends it too early, one too few too late.
        let slip_within = self.indented(declaration);
        match slip_within.filter(|slip| tokens.is_ok() || slip.change.is_some()) {
            Some(slip) => Err(slip),
            None => tokens.map_err(|error| self.slip(declaration, body, &error)),
        }
    }

    /// The slip in a mechanism of a file of Rust that ends where it is indented so.
    fn indented(&self, declaration: &Declaration) -> Option<Unlexed> {
        let (text, whole) = (self.source().text(), &declaration.whole);
        if declaration.body.as_ref() == Some(whole) {
            return None;
        }
        let body = scanner::indented_body(text, whole.start)?;
        if self.excess(&body).is_some() {
            return None;
        }
        let error = self.tokens(&body).err()?;
        Some(self.slip(declaration, &body, &error))
    }

    /// The change after which the text of one of its mechanisms lexes, if it does not, and one is known.
    pub(crate) fn change_to_lex(&self, declaration: &Declaration) -> Option<Replacement> {
        self.lexed(declaration).err()?.change
    }

    fn excess(&self, body: &Range<usize>) -> Option<Unlexed> {
        let excess = limits::of_text(&self.source().text()[body.clone()]).err()?;
        let place = body.start + excess.place.start..body.start + excess.place.end;
        Some(Unlexed::new(place, excess.limit.to_string()))
    }

    /// A mechanism whose brackets are not closed.
    fn endless(&self, declaration: &Declaration) -> Unlexed {
        let start = declaration.whole.start;
        self.indented(declaration).unwrap_or_else(|| {
        Unlexed::new(
            start..start + 1,
            "this mechanism has no end: one of its brackets is not closed, or closed by another kind",
        )
    })
    }

    /// A text that does not even consist of words, numbers and marks.
    fn slip(&self, declaration: &Declaration, body: &Range<usize>, error: &LexError) -> Unlexed {
        let at = error.span().byte_range().start;
        unlexed::slip(self.source(), body, at, &|text| {
            let tokens: TokenStream = text.parse().ok()?;
            let text = self.with_parts(declaration, tokens.clone()).unwrap_or(tokens);
            let parsed = catch(|| syntax::parse(text)).ok()?;
            Some(parsed.errors.len())
        })
    }

    /// The names and numbers in the text of one of its mechanisms; none if its brackets do not match.
    ///
    /// # Errors
    /// If the compiler itself fails, which is a mistake of ours.
    pub fn listing(&self, declaration: &Declaration) -> Result<Option<Listing>, Failure> {
        proc_macro2::extra::invalidate_current_thread_spans();
        let Ok(tokens) = self.tokens_of(declaration) else {
            return Ok(None);
        };
        let found = catch(|| syntax::listing(tokens)).map_err(Failure::internal)?;
        Ok(Some(found.map_places(|place| range_of(place, &declaration.whole))))
    }
}

/// An instance of a part from elsewhere.
struct Instance {
    name: String,
    place: Range<usize>,
    /// The word that brings the part in.
    word: Range<usize>,
}

/// The instances of parts that a mechanism takes from elsewhere.
fn instances(mut text: TokenStream) -> Vec<Instance> {
    let mut words = Vec::new();
    while let Some(import) = Import::first(&text) {
        words.extend(import.name());
        text = import.others;
    }
    let trees: Vec<TokenTree> = text.into_iter().collect();
    let mut found = Vec::new();
    for (index, tree) in trees.iter().enumerate() {
        let [TokenTree::Ident(name), others @ ..] = &trees[index + 1..] else {
            continue;
        };
        if !matches!(tree, TokenTree::Ident(word) if word == "use") {
            continue;
        }
        let is_row = matches!(others, [TokenTree::Group(_), ..]);
        let others = &others[usize::from(is_row)..];
        if let [TokenTree::Punct(_), TokenTree::Ident(part), ..] = others
            && let Some(word) = words.iter().find(|word| *word == part)
        {
            found.push(Instance {
                name: name.to_string(),
                place: name.span().byte_range(),
                word: word.span().byte_range(),
            });
        }
    }
    found
}

/// Moves faults within a part from elsewhere to the instance that they name: all of the part stands at the word that brings it in.
fn at_instances(mut messages: Vec<Message>, instances: &[Instance]) -> Vec<Message> {
    for message in &mut messages {
        let mention = |one: &Instance| {
            let endings = ["`", ".", "["].into_iter();
            let names = endings.map(|ending| format!("`{}{ending}", one.name));
            names.filter_map(|name| message.text.find(&name)).min()
        };
        let named = instances
            .iter()
            .filter(|one| one.word == message.place)
            .filter_map(|one| Some((mention(one)?, one)));
        if let Some((_, instance)) = named.min_by_key(|(at, _)| *at) {
            message.place = instance.place.clone();
        }
    }
    messages
}

fn in_bytes(messages: &[syntax::Message], whole: &Range<usize>) -> Vec<Message> {
    let message = |message: &syntax::Message| Message {
        place: range_of(message.place, whole),
        text: message.text.clone(),
    };
    messages.iter().map(message).collect()
}

pub(super) fn range_of(place: Place, whole: &Range<usize>) -> Range<usize> {
    let bytes = |span: Span| Some(span.byte_range()).filter(|range| !range.is_empty());
    match (bytes(place.start), bytes(place.end)) {
        (Some(start), Some(end)) if start.start < end.end => start.start..end.end,
        (Some(start), _) => start,
        // No token stands there: the macro's own call.
        (None, _) => whole.clone(),
    }
}

/// The names and numbers in the text of a mechanism, with their places in the file, in bytes.
pub type Listing = syntax::Listing<Range<usize>>;

/// A name at one place.
pub type NameText = ListedName<Range<usize>>;

/// A number, or a pair of them, at its place.
pub type NumberText = ListedNumber<Range<usize>>;

/// The text of a part of the library, without the word `part`. All its tokens have the place of the name that was given.
fn library_part(name: &Ident) -> Option<TokenStream> {
    let part = PartText::find(parts::SOURCE, name)?;
    Some(placed(part.body, name.span()))
}

fn placed(tokens: TokenStream, place: Span) -> TokenStream {
    let moved = tokens.into_iter().map(|tree| {
        let mut tree = match tree {
            TokenTree::Group(group) => {
                Group::new(group.delimiter(), placed(group.stream(), place)).into()
            }
            other => other,
        };
        tree.set_span(place);
        tree
    });
    moved.collect()
}

#[cfg(test)]
mod tests {
    use super::library_part;
    use mech_runtime::parts;
    use proc_macro2::{Ident, Span};

    #[test]
    fn all_parts_of_the_runtime_are_known() {
        let lines = parts::SOURCE.lines().map(str::trim_start);
        let declared = lines.filter_map(|line| {
            let name = line.strip_prefix("pub ")?;
            name.split(|letter: char| !letter.is_alphanumeric()).next()
        });
        let parts: Vec<&str> = declared.filter(|word| *word != "const").collect();
        assert_eq!(parts.len(), 11);
        for name in parts {
            let text = library_part(&Ident::new(name, Span::call_site())).expect(name).to_string();
            assert!(text.starts_with(name), "{text}");
        }
    }
}
