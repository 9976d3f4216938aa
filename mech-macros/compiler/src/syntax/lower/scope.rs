//! The scopes: the names and numbers of the mechanism itself, and of each instance of a part.

use super::constant::Constants;
use super::similarity::Similarity;
use proc_macro2::Ident;

/// The mechanism, or an instance of a part in it.
pub(super) struct Scope {
    /// The prefix of the names of its links and joints: empty, or `left[2].`
    pub(super) prefix: String,
    /// The name of the part of which it is an instance.
    pub(super) part: Option<String>,
    /// The scope that uses it.
    parent: Option<usize>,
    /// Its numbers.
    pub(super) constants: Constants,
    /// The similarity of its own links, lengths and angles.
    pub(super) similarity: Similarity,
    /// The angle of the frame of its first port, in radians: angles of links are counted from there.
    pub(super) angle: f64,
    /// The statements that there may be only one of, as far as they have come.
    pub(super) singles: Vec<&'static str>,
    /// The parts it uses.
    pub(super) uses: Vec<UsedPart>,
}

/// A part in use.
#[derive(Clone)]
pub(super) struct UsedPart {
    /// The name of the use.
    pub(super) name: String,
    /// Whether it was declared with brackets.
    pub(super) is_array: bool,
    /// The similarity by which it mirrors and scales its instances.
    pub(super) own: Similarity,
    /// The numbers of its scopes.
    pub(super) instances: Vec<usize>,
}

impl Scope {
    fn new(parent: Option<usize>, prefix: String, constants: Constants) -> Self {
        Self {
            prefix,
            part: None,
            parent,
            constants,
            similarity: Similarity::IDENTITY,
            angle: 0.0,
            singles: Vec::new(),
            uses: Vec::new(),
        }
    }

    /// The path of the instance: `left[2]`; none for the mechanism.
    pub(super) fn instance(&self) -> Option<String> {
        self.part.as_ref()?;
        Some(self.prefix.trim_end_matches('.').to_owned())
    }

    /// The name of something that is declared here, with the path to it.
    pub(super) fn key_of(&self, name: &Ident) -> String {
        format!("{}{name}", self.prefix)
    }

    /// The use of a part that has this name.
    pub(super) fn used(&self, name: &Ident) -> Option<&UsedPart> {
        self.uses.iter().find(|used| name == &used.name)
    }

    /// Takes its place: that of its first port. Own links are drawn in the frame of the ports if any joint is.
    pub(super) fn place(&mut self, first: Option<&Similarity>, is_drawn: bool) {
        let Some(first) = first else {
            return;
        };
        self.angle = first.angle();
        if is_drawn {
            self.similarity = *first;
        }
    }
}

/// All scopes.
pub(super) struct Scopes(Vec<Scope>);

impl Scopes {
    /// The scope of a mechanism.
    pub(super) fn new(constants: Constants) -> Self {
        Self(vec![Scope::new(None, String::new(), constants)])
    }

    /// Adds an instance of a part that a scope uses; its number.
    pub(super) fn add(&mut self, parent: usize, name: &str, part: &str, own: Constants) -> usize {
        let prefix = format!("{}{name}.", self.0[parent].prefix);
        let mut scope = Scope::new(Some(parent), prefix, own);
        scope.part = Some(part.to_owned());
        self.0.push(scope);
        self.0.len() - 1
    }

    /// The scope of this number.
    pub(super) fn get(&self, scope: usize) -> &Scope {
        &self.0[scope]
    }

    /// The scope to which this path leads: `left[2]`.
    pub(super) fn find(&self, path: &str) -> Option<&Scope> {
        let mut scopes = self.0.iter();
        scopes.find(|scope| scope.prefix.trim_end_matches('.') == path)
    }

    /// The same, to be changed.
    pub(super) fn get_mut(&mut self, scope: usize) -> &mut Scope {
        &mut self.0[scope]
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether a scope is within an instance of this part.
    pub(super) fn is_within(&self, scope: usize, part: &str) -> bool {
        let mut scopes = std::iter::successors(Some(&self.0[scope]), |scope| {
            scope.parent.map(|parent| &self.0[parent])
        });
        scopes.any(|scope| scope.part.as_deref() == Some(part))
    }
}
