//! Mechanisms in which anything may have any name. Between them they have all effects and methods, and one is wrong.

/// What a name is for: how it stands in the texts of `tests/cases/names`, and what is called so as long as nothing else is said.
const ROLES: [(Role, &str); 10] = [
    ("@struct", "Subject"),
    ("@link", "arm"),
    ("@point", "elbow"),
    // A joint with a motor that turns, and one that slides.
    ("@joint", "sway"),
    ("@slide", "reach"),
    ("@const", "HEIGHT"),
    ("@param", "stretch"),
    ("@load", "push"),
    ("@spring", "coil"),
    // A joint of a loop.
    ("@pin", "small_end"),
];

/// What a name is for.
pub(crate) type Role = &'static str;

/// A mechanism: what its struct is called, and its text, whose comments end, as it comes to stand on one line.
pub(crate) struct Subject(&'static str, &'static str);

impl Subject {
    /// Its text with these names in these roles.
    pub(crate) fn with(&self, given: &[(Role, &str)]) -> String {
        let mut text = self.1.to_owned();
        for (role, plain) in ROLES {
            let plain = if role == "@struct" { self.0 } else { plain };
            let mut given = given.iter();
            let name = given.find(|(given, _)| *given == role).map_or(plain, |(_, name)| name);
            text = text.replace(role, name);
        }
        text
    }

    /// Its text with the names it has by itself.
    pub(crate) fn plain(&self) -> String {
        self.with(&[])
    }

    /// What may have another name.
    pub(crate) fn roles(&self) -> impl Iterator<Item = Role> {
        let all = ROLES.into_iter().map(|(role, _)| role);
        all.filter(|role| self.1.contains(role))
    }

    /// Whether it has errors whatever the names.
    pub(crate) fn is_wrong(&self) -> bool {
        self.declares("Wrong")
    }

    /// Whether its struct is called so.
    pub(crate) fn declares(&self, name: &str) -> bool {
        self.0 == name
    }
}

/// All of them.
pub(crate) const SUBJECTS: &[Subject] = &[
    Subject("Varied", include_str!("../../cases/names/varied.mech")),
    Subject("Loaded", include_str!("../../cases/names/loaded.mech")),
    Subject("Lawful", include_str!("../../cases/names/lawful.mech")),
    Subject("Bounded", include_str!("../../cases/names/bounded.mech")),
    Subject("Coupled", include_str!("../../cases/names/coupled.mech")),
    Subject("Led", include_str!("../../cases/names/led.mech")),
    Subject("Wrong", include_str!("../../cases/names/wrong.mech")),
];
