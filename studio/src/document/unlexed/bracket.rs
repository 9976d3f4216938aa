//! Brackets without their partners.

use super::{Body, Unlexed};
use crate::text::keyword::{CALLED, is_keyword};
use crate::text::{Kind, Replacement, closing, is_of_word};
use mech_compiler::syntax::STATEMENTS;
use std::ops::Range;

/// So many brackets are looked at, in all, to find changes after which each has its partner.
const MOST: usize = 1 << 22;

#[derive(Clone, Copy)]
struct Open {
    index: usize,
    /// Whether statements stand in it.
    is_part: bool,
}

/// Where the text shows that a bracket is wrong.
struct Clash {
    open: Option<Open>,
    /// The lexeme that cannot stand there; the number of all at the end of the text.
    at: usize,
    /// The first lexeme of its statement.
    begin: usize,
    /// The first closing brace before it that is indented unlike what it closes.
    suspect: Option<usize>,
}

/// A change of one bracket, by the numbers of lexemes.
#[derive(Clone, Copy)]
enum Edit {
    /// Before a lexeme, or at the end.
    Insert(usize, char),
    /// An opening bracket within a word, after so many of its bytes.
    Split(usize, usize, char),
    Remove(usize),
    Exchange(usize, char),
}

/// The lines of a text, by the numbers of lexemes.
struct Lines {
    /// The first lexeme in the line of each, and how far that is indented.
    firsts: Vec<(usize, usize)>,
}

impl Lines {
    fn of(body: &Body<'_>) -> Self {
        let mut firsts: Vec<(usize, usize)> = Vec::new();
        let mut end = 0;
        for (index, lexeme) in body.lexemes.iter().enumerate() {
            let between = &body.text[end..lexeme.start];
            let first = match (between.rfind('\n'), firsts.last()) {
                (None, Some(first)) => *first,
                (newline, _) => (index, newline.map_or(0, |at| between.len() - at - 1)),
            };
            firsts.push(first);
            end = lexeme.end;
        }
        Self { firsts }
    }

    fn begins(&self, index: usize) -> bool {
        self.firsts[index].0 == index
    }

    fn are_same(&self, a: usize, b: usize) -> bool {
        self.firsts[a].0 == self.firsts[b].0
    }

    fn indent(&self, index: usize) -> usize {
        self.firsts[index].1
    }
}

/// The first bracket that is wrong; none if each has its partner.
pub(super) fn slip(body: &Body<'_>) -> Option<Unlexed> {
    let lines = Lines::of(body);
    let clash = clash(body, &lines)?;
    let edits = edits(body, &lines, &clash);
    let most = (MOST / body.lexemes.len().max(1)).clamp(8, 1024);
    let edits = edits.into_iter().take(most);
    let edits = edits.filter(|&edit| is_balanced(body, edit));
    let edits = edits.map(|edit| (edit, replacement(body, &lines, edit)));
    let (edit, change) = match body.best(edits) {
        Some((edit, change)) => (edit, Some(change)),
        None => match clash.open {
            Some(open) => (Edit::Insert(clash.at, partner(body.bracket(open.index)?)), None),
            None => (Edit::Remove(clash.at), None),
        },
    };
    told(body, &lines, edit, change)
}

impl Body<'_> {
    fn bracket(&self, index: usize) -> Option<char> {
        self.word(index).chars().next()
    }

    /// A lexeme with those that are one mark or one number with it.
    fn whole(&self, index: usize) -> Range<usize> {
        let place = self.place(index);
        let rest = &self.text[place.start..];
        let marks = ["->", "..="].into_iter().find(|mark| rest.starts_with(mark));
        let is_number = rest.starts_with(|first: char| first.is_ascii_digit());
        let length = match marks {
            Some(marks) => marks.len(),
            None if is_number && !rest[place.len()..].starts_with("..") => {
                let end = rest.find(|letter| letter != '.' && !is_of_word(letter));
                end.unwrap_or(rest.len())
            }
            None => place.len(),
        };
        place.start..place.start + length
    }

    fn is_closing(&self, index: usize) -> bool {
        self.lexemes.get(index).is_some_and(|lexeme| lexeme.kind == Kind::Close)
    }

    /// Whether a bracket stands beside one of its own kind.
    fn is_doubled(&self, index: usize) -> bool {
        let bracket = self.word(index);
        let touches = |a: usize, b: usize| {
            let ends = (self.lexemes.get(a), self.lexemes.get(b));
            matches!(ends, (Some(a), Some(b)) if a.end == b.start) && self.word(a) == self.word(b)
        };
        !bracket.is_empty() && (touches(index, index + 1) || index > 0 && touches(index - 1, index))
    }

    /// Whether a statement of a mechanism begins with this lexeme, as far as one sees.
    fn begins_statement(&self, index: usize) -> bool {
        let (word, next) = (self.word(index), self.word(index + 1));
        STATEMENTS.contains(&word)
            && match word {
                "at" => next == "change",
                "ground" | "start" | "effects" => next == "{",
                "gravity" => next == "(",
                _ => next != "near" && next.starts_with(is_of_word),
            }
    }
}

fn partner(bracket: char) -> char {
    match bracket {
        '(' => ')',
        ')' => '(',
        '[' => ']',
        ']' => '[',
        '{' => '}',
        _ => '{',
    }
}

fn clash(body: &Body<'_>, lines: &Lines) -> Option<Clash> {
    let mut waiting: Vec<Open> = Vec::new();
    // So many of these are no parts.
    let mut others = 0_usize;
    let mut begin = 0;
    let mut suspect = None;
    for (index, lexeme) in body.lexemes.iter().enumerate() {
        let word = body.word(index);
        let open = waiting.last().copied();
        let is_round = open.is_some_and(|open| body.word(open.index) != "{");
        let is_clash = match lexeme.kind {
            Kind::Open => {
                let is_part = word == "{" && !is_round && body.word(begin) == "part";
                waiting.push(Open { index, is_part });
                others += usize::from(!is_part);
                false
            }
            Kind::Close => {
                let opened = open.and_then(|open| body.bracket(open.index));
                let is_partner = opened.map(partner) == body.bracket(index);
                if let Some(open) = waiting.pop_if(|_| is_partner) {
                    others -= usize::from(!open.is_part);
                    let is_strange = !lines.are_same(open.index, index)
                        && lines.indent(open.index) != lines.indent(index);
                    if word == "}" && is_strange {
                        suspect = suspect.or(Some(index));
                    }
                }
                !is_partner
            }
            Kind::Mark => word == ";" && is_round,
            Kind::Word if others > 0 => {
                let is_begin = lines.begins(index) || begin == index && !is_round;
                is_begin && body.begins_statement(index)
            }
            Kind::Word => false,
        };
        if is_clash {
            return Some(Clash { open, at: index, begin, suspect });
        }
        if !is_round && (word == ";" || word == "{") || word == "}" {
            begin = index + 1;
        }
    }
    waiting.last().map(|&open| Clash { open: Some(open), at: body.lexemes.len(), begin, suspect })
}

/// The changes that may mend a clash, the likely ones first.
fn edits(body: &Body<'_>, lines: &Lines, clash: &Clash) -> Vec<Edit> {
    let at = clash.at;
    let open = clash.open.and_then(|open| Some((open.index, body.bracket(open.index)?)));
    let close = body.bracket(at).filter(|_| body.is_closing(at));
    let mut edits = Vec::new();
    let doubled = [open.map(|open| open.0), close.map(|_| at)];
    let doubled = doubled.into_iter().flatten().filter(|&index| body.is_doubled(index));
    edits.extend(doubled.map(Edit::Remove));
    // Braces of parts and links over several lines are told by what is indented.
    if let Some(suspect) = clash.suspect {
        edits.extend([Edit::Remove(suspect), Edit::Insert(suspect, '}')]);
    }
    if let Some((index, '{')) = open {
        let mut after = index + 1..at;
        let end =
            after.find(|&next| lines.begins(next) && lines.indent(next) <= lines.indent(index));
        edits.extend(end.map(|end| Edit::Insert(end, '}')));
    }
    if let (Some((index, open)), Some(close)) = (open, close) {
        edits.push(Edit::Exchange(at, partner(open)));
        edits.push(Edit::Exchange(index, partner(close)));
    }
    if let Some((index, open)) = open {
        let gaps = (index + 1..=at).rev();
        edits.extend(gaps.map(|gap| Edit::Insert(gap, partner(open))));
        edits.push(Edit::Remove(index));
    }
    match close {
        Some('}') => {
            const WORDS: [&str; 7] = ["link", "ground", "port", "part", "start", "effects", "use"];
            let mut before = (0..at).rev();
            let begin = before.find(|&index| WORDS.contains(&body.word(index))).unwrap_or(0);
            edits.extend((begin..=at).map(|gap| Edit::Insert(gap, '{')));
        }
        Some(close) => {
            let words = clash.begin..at;
            let splits = words.filter_map(|index| {
                Some(Edit::Split(index, split(body, index, close)?, partner(close)))
            });
            edits.extend(splits);
            // Brackets around one word are the last that one would write.
            let alone = at.saturating_sub(1).max(clash.begin);
            let gaps = (clash.begin..alone).rev().chain([alone]);
            edits.extend(gaps.map(|gap| Edit::Insert(gap, partner(close))));
        }
        None => {}
    }
    edits.extend(close.map(|_| Edit::Remove(at)));
    if let Some((index, open)) = open {
        let others = ['{', '(', '['].into_iter().filter(|&other| other != open);
        edits.extend(others.map(|other| Edit::Exchange(index, other)));
    }
    edits
}

/// After how many bytes of a word a bracket may be lost that stood in it: `revolutecrank, arm)`, `leg3]`.
fn split(body: &Body<'_>, index: usize, close: char) -> Option<usize> {
    let word = body.word(index);
    let length = match close {
        ')' if is_keyword(word) => return None,
        ')' => {
            let called = CALLED.iter().filter(|called| word.starts_with(**called));
            called.map(|called| called.len()).max()?
        }
        _ => word.trim_end_matches(|letter: char| letter.is_ascii_digit()).len(),
    };
    (0 < length && length < word.len()).then_some(length)
}

/// Whether each bracket has its partner after a change.
fn is_balanced(body: &Body<'_>, edit: Edit) -> bool {
    let mut waiting = Vec::new();
    let mut take = |bracket: char| match bracket {
        '(' | '[' | '{' => {
            waiting.push(bracket);
            true
        }
        _ => waiting.pop() == Some(partner(bracket)),
    };
    for (index, lexeme) in body.lexemes.iter().enumerate() {
        if let Edit::Insert(gap, bracket) = edit
            && gap == index
            && !take(bracket)
        {
            return false;
        }
        if let Edit::Split(word, _, bracket) = edit
            && word == index
        {
            take(bracket);
        }
        let bracket = match edit {
            Edit::Remove(gone) if gone == index => None,
            Edit::Exchange(changed, by) if changed == index => Some(by),
            _ if matches!(lexeme.kind, Kind::Open | Kind::Close) => body.bracket(index),
            _ => None,
        };
        if bracket.is_some_and(|bracket| !take(bracket)) {
            return false;
        }
    }
    let is_at_end = |gap: usize| gap >= body.lexemes.len();
    matches!(edit, Edit::Insert(gap, bracket) if is_at_end(gap) && !take(bracket))
        || waiting.is_empty()
}

/// The bracket that is open before a lexeme.
fn open_before(body: &Body<'_>, gap: usize) -> Option<usize> {
    let mut waiting = Vec::new();
    for index in 0..gap.min(body.lexemes.len()) {
        match body.lexemes[index].kind {
            Kind::Open => waiting.push(index),
            Kind::Close => drop(waiting.pop()),
            Kind::Word | Kind::Mark => {}
        }
    }
    waiting.pop()
}

fn replacement(body: &Body<'_>, lines: &Lines, edit: Edit) -> Replacement {
    match edit {
        Edit::Remove(index) => Replacement::new(body.place(index), ""),
        Edit::Exchange(index, by) => Replacement::new(body.place(index), by),
        Edit::Split(index, length, bracket) => {
            let at = body.lexemes[index].start + length;
            Replacement::new(at..at, bracket)
        }
        Edit::Insert(gap, '{') if gap > 0 => {
            let at = body.lexemes[gap - 1].end;
            Replacement::new(at..at, " {")
        }
        Edit::Insert(gap, bracket @ ('(' | '[' | '{')) => {
            let at = body.lexemes.get(gap).map_or(body.text.len(), |next| next.start);
            Replacement::new(at..at, bracket)
        }
        Edit::Insert(gap, bracket) => {
            let last = gap.saturating_sub(1);
            let mut at = body.lexemes.get(last).map_or(body.start, |last| last.end);
            let open = open_before(body, gap).filter(|_| bracket == '}');
            let text = match open {
                // Over several lines, it has one of its own.
                Some(open) if !lines.are_same(open, last) => {
                    let end = body.text[at..].find('\n');
                    at = end.map_or(body.text.len(), |end| at + end);
                    format!("\n{}}}", " ".repeat(lines.indent(open)))
                }
                Some(_) => " }".to_owned(),
                None => bracket.to_string(),
            };
            Replacement::new(at..at, text)
        }
    }
}

/// A change in words.
fn told(
    body: &Body<'_>,
    lines: &Lines,
    edit: Edit,
    change: Option<Replacement>,
) -> Option<Unlexed> {
    let of = |index: usize| {
        let spot = body.source.spot(body.lexemes[index].start);
        let bracket = body.word(index);
        format!("the `{bracket}` in line {}, column {},", spot.line, spot.column)
    };
    let shown = |index: usize| &body.text[body.whole(index)];
    let (at, text) = match edit {
        Edit::Split(index, length, bracket) => {
            let (word, close) = (&body.word(index)[..length], partner(bracket));
            (
                index,
                format!(
                    "expected `{bracket}` after `{word}`: the `{close}` after it closes nothing"
                ),
            )
        }
        Edit::Insert(gap, bracket) => {
            let last = gap.checked_sub(1)?;
            let is_end = gap >= body.lexemes.len() || !lines.are_same(last, gap);
            let (at, side) =
                if is_end || bracket == '}' { (last, "after") } else { (gap, "before") };
            let why = match bracket {
                '(' | '[' | '{' => format!("the `{}` after it closes nothing", partner(bracket)),
                _ => format!("{} is still open", open_before(body, gap).map(of)?),
            };
            (at, format!("expected `{bracket}` {side} `{}`: {why}", shown(at)))
        }
        Edit::Remove(index) if body.is_closing(index) => {
            (index, format!("this `{}` closes nothing; remove it", body.word(index)))
        }
        Edit::Remove(index) => {
            (index, format!("nothing closes this `{}`; remove it", body.word(index)))
        }
        Edit::Exchange(index, by) if body.is_closing(index) => {
            let open = open_before(body, index).map(of)?;
            (
                index,
                format!(
                    "`{}` does not close {open} which is open here; write `{by}`",
                    body.word(index)
                ),
            )
        }
        Edit::Exchange(index, by) => {
            let close = closing(&body.lexemes, index).map_or("what follows".to_owned(), of);
            (
                index,
                format!(
                    "`{}` is not the bracket that {close} closes; write `{by}`",
                    body.word(index)
                ),
            )
        }
    };
    Some(Unlexed { place: body.whole(at), text, change })
}
