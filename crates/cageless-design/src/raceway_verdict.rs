//! Verdicts on a raceway.

cageless::named_enum! {
    /// Verdict on a raceway, the worst last.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub enum RacewayVerdict {
        /// Balls pass without sliding and without being hit from both sides.
        Smooth = "smooth",
        /// There is no discrete raceway to judge, or too little to judge it by.
        NotJudged = "not-judged",
        /// Balls are hit by both neighbours in one passage.
        DoubleCollision = "double-collision",
        /// The critical gap is so small that the raceway hardly spreads the balls.
        TooShallow = "too-shallow",
        /// The critical gap exceeds the steady-state gap: evenly spaced balls collide.
        TooDeep = "too-deep",
        /// An oil film spaces the balls more than the raceway.
        FilmOutweighs = "film-outweighs",
        /// Balls slowed by an oil film queue.
        FilmQueue = "film-queue",
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
    /// Whether the raceway passes; `None` where it is not judged.
    pub fn passes(self) -> Option<bool> {
        match self {
            Self::NotJudged => None,
            Self::Smooth => Some(true),
            Self::DoubleCollision
            | Self::TooShallow
            | Self::TooDeep
            | Self::FilmOutweighs
            | Self::FilmQueue
            | Self::Slips
            | Self::LosesLag
            | Self::Overloaded
            | Self::Infeasible => Some(false),
        }
    }

    /// Whether single balls are slowed as intended, in a word: what a raceway needs to help, and no more.
    pub fn works(passes: Option<bool>) -> &'static str {
        match passes {
            Some(true) => "works",
            Some(false) => "does not work",
            None => "not judged",
        }
    }

    /// Wording for readers.
    pub fn label(self) -> &'static str {
        match self {
            Self::NotJudged => "not judged",
            Self::Smooth => "smooth",
            Self::DoubleCollision => "double collision",
            Self::TooShallow => "too shallow",
            Self::TooDeep => "too deep",
            Self::FilmOutweighs => "film outweighs raceway",
            Self::FilmQueue => "balls queue in oil",
            Self::Slips => "excessive sliding",
            Self::LosesLag => "lag lost",
            Self::Overloaded => "overloaded",
            Self::Infeasible => "no solution",
        }
    }
}
