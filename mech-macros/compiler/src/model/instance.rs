//! Instances of parts.

/// An instance of a part. What belongs to it has names that begin with its path.
#[derive(Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Instance {
    /// The name of the use.
    pub name: String,
    /// Its number among the instances of the use, if that has several.
    pub index: Option<usize>,
    /// The name of the part.
    pub part: String,
    /// The path to it: `left[2]`.
    pub path: String,
    /// The instance that uses it; none if the mechanism itself does.
    pub parent: Option<usize>,
}
