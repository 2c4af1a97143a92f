//! Verdicts on a raceway.

/// Verdict on a raceway, the worst last.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum RacewayVerdict {
    /// There is no discrete raceway to judge.
    NotJudged,
    /// Balls pass without sliding and without being hit from both sides.
    Smooth,
    /// Balls are hit by both neighbours in one passage.
    DoubleCollision,
    /// Balls slide so much that the separation suffers.
    Slips,
    /// The raceway does not work at all.
    Infeasible,
}

impl RacewayVerdict {
    /// Whether the raceway passes; `None` where there is none to judge.
    pub fn passes(self) -> Option<bool> {
        match self {
            Self::NotJudged => None,
            Self::Smooth => Some(true),
            Self::DoubleCollision | Self::Slips | Self::Infeasible => Some(false),
        }
    }

    /// Wording for readers.
    pub fn label(self) -> &'static str {
        match self {
            Self::NotJudged => "not judged",
            Self::Smooth => "smooth",
            Self::DoubleCollision => "double collision",
            Self::Slips => "excessive sliding",
            Self::Infeasible => "no solution",
        }
    }

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::NotJudged => "not-judged",
            Self::Smooth => "smooth",
            Self::DoubleCollision => "double-collision",
            Self::Slips => "slips",
            Self::Infeasible => "infeasible",
        }
    }
}
