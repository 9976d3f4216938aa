//! Signs of printed texts that stand for those of the keyboard.

use super::{Body, Unlexed};
use crate::text::{Kind, Replacement, is_of_word};

/// The first sign that no keyboard has. Its change mends all of them.
pub(super) fn slip(body: &Body<'_>, at: usize) -> Option<Unlexed> {
    let mut signs = Vec::new();
    let mut first = None;
    for lexeme in &body.lexemes {
        for (byte, sign) in body.text[lexeme.start..lexeme.end].char_indices() {
            let start = lexeme.start + byte;
            let Some(plain) = plain(sign) else {
                continue;
            };
            // A word of wide letters is a name.
            if first.is_none() && (lexeme.kind == Kind::Mark || start == at) {
                first = Some(signs.len());
            }
            signs.push((start, sign, plain));
        }
    }
    let (start, sign, plain) = &signs[first?];
    let shown = match &**plain {
        "" => format!("a sign without width stands here, U+{:04X}; remove it", u32::from(*sign)),
        "-" => format!("`{sign}` is not the minus of the keyboard; write `-`"),
        plain => format!("`{sign}` is no sign of the keyboard; write `{plain}`"),
    };
    let others = match signs.len() - 1 {
        0 => String::new(),
        1 => "\n\nnote: one more sign of this text is not on the keyboard".to_owned(),
        count => format!("\n\nnote: {count} more signs of this text are not on the keyboard"),
    };
    Some(Unlexed {
        place: *start..start + sign.len_utf8(),
        text: shown + &others,
        change: change(body.text, &signs),
    })
}

/// All of them as the keyboard has them.
fn change(text: &str, signs: &[(usize, char, String)]) -> Option<Replacement> {
    let (first, (last, sign, _)) = (signs.first()?.0, signs.last()?);
    let range = first..last + sign.len_utf8();
    let mut by = String::new();
    let mut from = first;
    for (start, sign, plain) in signs {
        by += &text[from..*start];
        from = start + sign.len_utf8();
        let is_word = plain == "deg";
        if is_word && text[..*start].ends_with(is_of_word) {
            by.push(' ');
        }
        by += plain;
        if is_word && text[from..].starts_with(is_of_word) {
            by.push(' ');
        }
    }
    Some(Replacement { range, text: by })
}

/// How the keyboard writes a sign.
fn plain(sign: char) -> Option<String> {
    let plain = match sign {
        '−' | '‐' | '‑' | '‒' | '–' | '—' | '―' => "-",
        '→' | '⟶' | '⇒' => "->",
        '×' | '·' | '⋅' | '∙' | '∗' => "*",
        '÷' | '∕' | '⁄' => "/",
        '°' | '˚' => "deg",
        '…' => "..",
        '“' | '”' | '„' | '‟' => "\"",
        '‘' | '’' | '‚' | '‛' => "'",
        '\u{ad}' | '\u{200b}'..='\u{200d}' | '\u{2060}' | '\u{feff}' => "",
        // Wide forms.
        '\u{ff01}'..='\u{ff5e}' => {
            return char::from_u32(u32::from(sign) - 0xfee0).map(String::from);
        }
        _ => return None,
    };
    Some(plain.to_owned())
}
