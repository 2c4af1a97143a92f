//! Flanks of a discrete raceway under load.

use crate::raceway::Ends;

crate::named_enum! {
    /// Model of the contacts of a loaded ball with the two flanks of a discrete raceway.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum FlankModel {
        /// The contact angle is that of the ball that just touches, and the flanks neither spin on the
        /// ball nor slide along the groove: the "equivalent stiffness" of Zhao 2022, Eq. (19).
        Rigid = "rigid",
        /// The contact angle yields, the ball slides along the flanks as it moves in and out, and it
        /// spins on them.
        Elastic = "elastic",
    }
}

impl FlankModel {
    /// Whether the contact angle of a ball that is pressed in yields.
    pub(crate) fn yields(self) -> bool {
        match self {
            Self::Rigid => false,
            Self::Elastic => true,
        }
    }

    /// Whether a ball slides along the flanks as it moves in and out, and spins on them.
    pub(crate) fn drags(self) -> bool {
        match self {
            Self::Rigid => false,
            Self::Elastic => true,
        }
    }

    /// Ends of a raceway unless they are given.
    pub(crate) fn usual_ends(self) -> Ends {
        match self {
            Self::Rigid => Ends::default(),
            Self::Elastic => Ends::Machined,
        }
    }
}
