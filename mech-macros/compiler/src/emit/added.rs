//! What effects add to the generated code; nothing without them.

use proc_macro2::TokenStream;

/// The parts of the generated code that an effect adds.
#[derive(Default)]
pub(super) struct Added {
    /// Fields of the struct.
    pub(super) fields: TokenStream,
    /// The same in its constructor.
    pub(super) at_rest: TokenStream,
    /// What a move without rates leaves behind.
    pub(super) standstill: TokenStream,
    /// The same for another instance.
    pub(super) instance_standstill: TokenStream,
    /// What every move ends with.
    pub(super) record: TokenStream,
    /// The same for another instance.
    pub(super) instance_record: TokenStream,
    /// Tables of what is known at compile time.
    pub(super) known: TokenStream,
    /// Methods.
    pub(super) methods: TokenStream,
    /// Items of the trait.
    pub(super) trait_methods: TokenStream,
    /// How traces are recorded.
    pub(super) records: TokenStream,
    /// Modules of the programs that go on from positions.
    pub(super) steps: TokenStream,
}

impl Added {
    /// With what another effect adds.
    pub(super) fn and(mut self, other: Self) -> Self {
        self.fields.extend(other.fields);
        self.at_rest.extend(other.at_rest);
        self.standstill.extend(other.standstill);
        self.instance_standstill.extend(other.instance_standstill);
        self.record.extend(other.record);
        self.instance_record.extend(other.instance_record);
        self.trait_methods.extend(other.trait_methods);
        self.known.extend(other.known);
        self.methods.extend(other.methods);
        self.records.extend(other.records);
        self.steps.extend(other.steps);
        self
    }
}
