//! Computations.

/// Computation of a case, in the order in which a sweep does them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Computation {
    /// Static equilibrium with ratings.
    Static,
    /// Closed forms of the design: limits, β0, gaps.
    Design,
    /// Critical gap and verdict, from the motion.
    Verdict,
    /// A run of the case.
    Run,
    /// The drop of the rotor of the case, or of the rotor file.
    Drop,
}

impl Computation {
    /// Names in plans and columns.
    pub const NAMES: &'static [(&'static str, Self)] = &[
        ("static", Self::Static),
        ("design", Self::Design),
        ("verdict", Self::Verdict),
        ("run", Self::Run),
        ("drop", Self::Drop),
    ];

    /// Name in plans and columns.
    pub fn name(self) -> &'static str {
        Self::NAMES[self as usize].0
    }
}
