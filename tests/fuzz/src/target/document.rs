//! A file with mechanisms: messages stand at places of it, and what is offered keeps its promise.

use crate::finding::{DETAILS, Finding};
use mech_compiler::structure::Diagnosis;
use mech_studio::{Declaration, Document, Failure, Message, Reading, Remainder, Source, mendings};

/// So many repairs of a text are made.
const REPAIRS: usize = 3;

pub(super) fn examine(text: &str) -> Result<bool, Finding> {
    let is_rust = text.contains("mechanism!") || text.contains("mechanism_part!");
    let path = if is_rust { "a.rs" } else { "a.mech" };
    let document = Document::of(Source::new(path, text));
    are_in(text, &document.faults_of_parts().map_err(internal)?)?;
    let mut is_understood = false;
    for (index, declaration) in document.declarations().iter().enumerate() {
        let reading = document.analyse(declaration).map_err(internal)?;
        is_understood |= document.model(declaration).map_err(internal)?.is_some();
        if let Some(listing) = document.listing(declaration).map_err(internal)? {
            let numbers = listing.numbers.iter().map(|number| &number.place);
            for place in numbers {
                is_in(text, place)?;
            }
        }
        if let Err(faults) = &reading.result {
            are_in(text, &faults.messages)?;
        }
        mend(&document, index, declaration, &reading)?;
    }
    Ok(is_understood)
}

fn internal(failure: Failure) -> Finding {
    Finding::new(failure)
}

fn are_in(text: &str, messages: &[Message]) -> Result<(), Finding> {
    messages.iter().try_for_each(|message| {
        is_in(text, &message.place)
            .map_err(|finding| Finding::new(format!("{finding}{DETAILS}{}", message.text)))
    })
}

fn is_in(text: &str, place: &std::ops::Range<usize>) -> Result<(), Finding> {
    match text.get(place.clone()) {
        Some(_) => Ok(()),
        None => Err(Finding::new(format!("{place:?} is no place of the text"))),
    }
}

/// Makes repairs. What is enough is enough, and what is left is said.
fn mend(
    document: &Document,
    index: usize,
    declaration: &Declaration,
    reading: &Reading,
) -> Result<(), Finding> {
    let mendings = mendings(document, declaration, reading).map_err(internal)?;
    for mending in mendings.iter().take(REPAIRS) {
        let after = Document::of(Source::new(document.source().path(), &*mending.text));
        let words = &mending.words;
        let broken = |what: &str| Err(Finding::new(format!("a repair {what}{DETAILS}{words}")));
        let Some(declaration) = after.declarations().get(index) else {
            return broken("takes its mechanism away");
        };
        let result = after.analyse(declaration).map_err(internal)?.result;
        let is_text = |faults: &mech_studio::Faults| faults.diagnoses.is_empty();
        let is_enough = match &result {
            Err(faults) if is_text(faults) => return broken("makes a text that cannot be read"),
            Ok(_) => true,
            Err(faults) => matches!(
                faults.diagnoses[..],
                [Diagnosis::SeveralAssemblies { .. }
                    | Diagnosis::CannotClose { .. }
                    | Diagnosis::DeadStart { .. }]
            ),
        };
        if let (Remainder::Nothing, false, Err(faults)) = (mending.remainder, is_enough, &result) {
            let said = &faults.messages[0].text;
            let said = said.lines().next().unwrap_or_default();
            return broken(&format!("is not enough, as still {said}"));
        }
    }
    Ok(())
}
