//! Links of PMKS+, written from what is known of their form.

/// The content of a link. Settings, joints, links and forces are written as they are given.
#[derive(Clone, Debug, Default)]
pub(super) struct Encoder {
    pub(super) joints: Vec<String>,
    pub(super) links: Vec<String>,
    pub(super) forces: Vec<String>,
    /// The flags of the settings and the units, if they are not those of a clockwise input in centimetres.
    pub(super) settings: Option<[&'static str; 2]>,
}

/// The flags of a joint, as bits.
pub(super) const PRISMATIC: usize = 1;
pub(super) const INPUT: usize = 2;
pub(super) const GROUNDED: usize = 4;
pub(super) const WELDED: usize = 8;
pub(super) const TRACED: usize = 16;
pub(super) const SEALED: usize = 32;

const LETTERS: &[u8; 64] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_-";

fn letter(value: usize) -> char {
    char::from(LETTERS[value])
}

/// A number in thousandths to the base 64, below zero with a `0` before it.
pub(super) fn number(value: f64) -> String {
    let thousandths = (value * 1000.0).round();
    let mut rest = thousandths.abs();
    let mut digits = String::new();
    loop {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "a remainder is a digit"
        )]
        digits.insert(0, letter((rest % 64.0) as usize));
        rest = (rest / 64.0).floor();
        if rest == 0.0 {
            break;
        }
    }
    let sign = if thousandths < 0.0 { "0" } else { "" };
    format!("{sign}{digits}")
}

impl Encoder {
    pub(super) fn joint(mut self, flags: usize, id: &str, [x, y]: [f64; 2], angle: f64) -> Self {
        let [x, y, angle] = [x, y, angle].map(number);
        let flags = letter(flags);
        self.joints.push(format!("{flags}{id},{id},{x},{y},{angle}"));
        self
    }

    /// The same with more fields: a slot, a speed, a mass.
    pub(super) fn more(mut self, fields: &str) -> Self {
        let last = self.joints.last_mut().expect("a joint");
        *last += fields;
        self
    }

    /// A link without a mass.
    pub(super) fn link(self, id: &str, joints: &[&str]) -> Self {
        let joints = joints.join(",");
        self.raw_link(format!("YR{id},{id},0,0,0,0,c5cae9,{joints},,"))
    }

    pub(super) fn block(self, id: &str, joints: [&str; 2]) -> Self {
        let joints = joints.join(",");
        self.raw_link(format!("YP{id},{id},0,0,0,0,,{joints},,"))
    }

    pub(super) fn raw_link(mut self, text: impl Into<String>) -> Self {
        self.links.push(text.into());
        self
    }

    /// The query of the link, without its check.
    pub(super) fn body(&self) -> String {
        let section = |all: &[String]| all.iter().map(|one| format!("{one}.")).collect::<String>();
        let [joints, links, forces] = [&self.joints, &self.links, &self.forces];
        let sections = [joints, links, forces].map(|all| section(all));
        let [bits, units] = self.settings.unwrap_or(["0P", "101"]);
        format!("{bits}.SS.K,0.{units}.{}.N_", sections.join("."))
    }

    pub(super) fn query(&self) -> String {
        checked(&self.body())
    }

    pub(super) fn url(&self) -> String {
        format!("https://app.pmksplus.com/?{}", self.query())
    }
}

/// A query with the letter that checks its length.
pub(super) fn checked(query: &str) -> String {
    let length = query.encode_utf16().count();
    format!("{query}{}", letter(length % 62))
}
