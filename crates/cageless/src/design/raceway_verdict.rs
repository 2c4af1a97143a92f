//! Verdicts on a raceway.

crate::named_enum! {
    /// Verdict on a raceway, the worst last.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub enum RacewayVerdict {
        /// There is no discrete raceway to judge.
        NotJudged = "not-judged",
        /// Balls pass without sliding and without being hit from both sides.
        Smooth = "smooth",
        /// Balls are hit by both neighbours in one passage.
        DoubleCollision = "double-collision",
        /// Balls slide so much that the separation suffers.
        Slips = "slips",
        /// Load, contact angle and sliding leave too little of the lag, in space.
        LosesLag = "loses-lag",
        /// Balls press a raceway at rest with more than ISO 76 allows.
        Overloaded = "overloaded",
        /// The raceway does not work at all.
        Infeasible = "infeasible",
    }
}

impl RacewayVerdict {
    /// Whether the raceway passes; `None` where there is none to judge.
    pub fn passes(self) -> Option<bool> {
        match self {
            Self::NotJudged => None,
            Self::Smooth => Some(true),
            Self::DoubleCollision
            | Self::Slips
            | Self::LosesLag
            | Self::Overloaded
            | Self::Infeasible => Some(false),
        }
    }

    /// Wording for readers.
    pub fn label(self) -> &'static str {
        match self {
            Self::NotJudged => "not judged",
            Self::Smooth => "smooth",
            Self::DoubleCollision => "double collision",
            Self::Slips => "excessive sliding",
            Self::LosesLag => "lag lost",
            Self::Overloaded => "overloaded",
            Self::Infeasible => "no solution",
        }
    }
}
