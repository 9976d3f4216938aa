//! Formats that are not read, by what their files begin with.

use crate::document::Message;

const READ: &str = "`mech import` reads documents of Linkage (`.linkage2`) and links of PMKS+";

/// The beginnings of files, and the formats that they tell.
const BEGINNINGS: [(&str, &str); 14] = [
    ("±²³SolveSpace", "a drawing of SolveSpace"),
    ("ISO-10303-21", "a STEP file"),
    ("AutoCAD Binary DXF", "a DXF file"),
    ("AC10", "a DWG file"),
    ("PK\u{3}\u{4}", "a ZIP archive, as FreeCAD, GeoGebra and others write"),
    ("%PDF", "a PDF file"),
    ("\u{89}PNG", "a picture (PNG)"),
    ("GIF8", "a picture (GIF)"),
    ("ÿØÿ", "a picture (JPEG)"),
    ("{", "JSON"),
    ("[", "JSON"),
    ("struct ", "a text of the language, which `mech check` reads"),
    ("///", "a text of the language, which `mech check` reads"),
    ("use ", "a text of Rust, which `mech check` reads"),
];

/// The names of roots of XML, and what has them.
const ROOTS: [(&str, &str); 4] = [
    ("svg", "a picture (SVG)"),
    ("html", "a page of the web"),
    ("collada", "a COLLADA file"),
    ("linkage", "a document of Linkage 1"),
];

/// Makes the message on a text that is neither a link nor a document of Linkage, at its beginning.
pub(super) fn unknown_format(text: &str) -> Message {
    let start = text.len() - plain(text).len();
    let length = text[start..].chars().next().map_or(0, char::len_utf8);
    Message { place: start..start + length, text: format!("{}; {READ}", kind(plain(text))) }
}

/// Whether a text may be a document of Linkage, whole or not.
pub(super) fn is_of_linkage(text: &str) -> bool {
    plain(text).starts_with('<') && text.contains("<linkage2")
}

/// The link in a file that browsers make of it, and where it begins.
pub(super) fn shortcut(text: &str) -> Option<(usize, &str)> {
    const KEY: &str = "\nURL=";
    if !plain(text).starts_with("[InternetShortcut]") {
        return None;
    }
    let start = text.find(KEY)? + KEY.len();
    let link = text[start..].lines().next()?;
    Some((start, link))
}

/// A text without a mark of its encoding, and without blanks before it.
fn plain(text: &str) -> &str {
    text.trim_start_matches(['\u{feff}']).trim_start()
}

fn kind(text: &str) -> String {
    if text.is_empty() {
        return "this file is empty".to_owned();
    }
    let mut beginnings = BEGINNINGS.iter();
    if let Some((_, what)) = beginnings.find(|(beginning, _)| text.starts_with(beginning)) {
        return format!("this is {what}");
    }
    // Pairs of lines: a number, and what it says.
    let mut lines = text.lines().map(str::trim);
    if lines.next() == Some("0") && lines.next() == Some("SECTION") {
        return "this is a DXF file".to_owned();
    }
    match root(text) {
        Some(root) => {
            let lower = root.to_lowercase();
            let known = ROOTS.iter().find(|(name, _)| *name == lower);
            let what = known.map_or("XML of another program", |(_, what)| what);
            format!("this is {what}: its root is <{root}>")
        }
        None => "the format of this file is not known".to_owned(),
    }
}

/// The name of the first element, if there is any.
fn root(text: &str) -> Option<&str> {
    let mut rest = text;
    while let Some(inside) = rest.strip_prefix('<') {
        let name = inside.split(|letter: char| !letter.is_alphanumeric() && letter != '_');
        let name = name.into_iter().next().filter(|name| !name.is_empty());
        if name.is_some() {
            return name;
        }
        // A declaration, a comment, a document type.
        rest = inside.split_once('>')?.1.trim_start();
    }
    None
}
