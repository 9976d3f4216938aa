//! What is local to the mechanism itself, and to each instance of a part.

use super::constant::Constants;
use super::similarity::Similarity;

/// The mechanism, or an instance of a part in it.
pub(super) struct Scope {
    /// What stands before the names of its links and joints: nothing, or `left[2].`
    pub(super) prefix: String,
    /// The name of the part of which it is an instance.
    pub(super) part: Option<String>,
    /// The scope that uses it.
    parent: Option<usize>,
    /// Its numbers.
    pub(super) constants: Constants,
    /// What its own links, lengths and angles undergo.
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
    /// How it mirrors and scales its instances.
    pub(super) own: Similarity,
    /// The numbers of its scopes.
    pub(super) instances: Vec<usize>,
}

impl Scope {
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

/// All scopes, and the one that is read.
pub(super) struct Scopes {
    all: Vec<Scope>,
    current: usize,
}

impl Scopes {
    /// The scope of a mechanism.
    pub(super) fn new(constants: Constants) -> Self {
        let mechanism = Scope {
            prefix: String::new(),
            part: None,
            parent: None,
            constants,
            similarity: Similarity::IDENTITY,
            angle: 0.0,
            singles: Vec::new(),
            uses: Vec::new(),
        };
        Self {
            all: vec![mechanism],
            current: 0,
        }
    }

    /// Adds an instance of a part that the scope now read uses; its number.
    pub(super) fn add(&mut self, name: &str, part: &str, constants: Constants) -> usize {
        self.all.push(Scope {
            prefix: format!("{}{name}.", self.here().prefix),
            part: Some(part.to_owned()),
            parent: Some(self.current),
            constants,
            similarity: Similarity::IDENTITY,
            angle: 0.0,
            singles: Vec::new(),
            uses: Vec::new(),
        });
        self.all.len() - 1
    }

    /// The number of the scope that is read.
    pub(super) fn current(&self) -> usize {
        self.current
    }

    /// Goes to another scope.
    pub(super) fn enter(&mut self, scope: usize) {
        self.current = scope;
    }

    /// The scope that is read.
    pub(super) fn here(&self) -> &Scope {
        &self.all[self.current]
    }

    /// The same, to be changed.
    pub(super) fn here_mut(&mut self) -> &mut Scope {
        &mut self.all[self.current]
    }

    /// The scope of this number.
    pub(super) fn get(&self, scope: usize) -> &Scope {
        &self.all[scope]
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.all.len()
    }

    /// Whether the scope that is read is within an instance of this part.
    pub(super) fn is_within(&self, part: &str) -> bool {
        let mut scopes = std::iter::successors(Some(self.here()), |scope| {
            scope.parent.map(|parent| &self.all[parent])
        });
        scopes.any(|scope| scope.part.as_deref() == Some(part))
    }
}
