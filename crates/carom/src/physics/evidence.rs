//! What a number rests on.

/// What a value rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Evidence {
    /// Measured on real equipment; the source has this value, or a range that contains it.
    Measured,
    /// Fitted to measurements with this engine.
    Fit,
    /// Set by a rule book, a convention or a definition, or chosen among the published models.
    Specified,
    /// No source that we could verify.
    Estimate,
}

impl Evidence {
    /// The word that lists and JSON have.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Measured => "measured",
            Self::Fit => "fit",
            Self::Specified => "specified",
            Self::Estimate => "estimate",
        }
    }
}
