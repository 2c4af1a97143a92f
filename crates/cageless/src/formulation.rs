//! Sets of equations.

use crate::equations::{CasePart, Equations};

crate::named_enum! {
    /// Set of equations that is integrated.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Formulation {
        /// Consistent mechanics: inertial frame, absolute spin, friction along the
        /// sliding velocity.
        Physical = "physical",
        /// Published equations: centrifugal force added in Zhao 2022, Eq. (12), and spin of
        /// Eq. (13) relative to the frame that turns with the ball's orbit. Friction on the
        /// discrete raceway acts along the contact path.
        Paper = "paper",
    }
}

static PHYSICAL: Equations = Equations {
    centrifugal_force: false,
    orbits_on_pitch_circle: false,
    spin_relative_to_orbit: false,
    friction_along_path: false,
    refusals: &[],
};

static PUBLISHED: Equations = Equations {
    centrifugal_force: true,
    orbits_on_pitch_circle: true,
    spin_relative_to_orbit: true,
    friction_along_path: true,
    refusals: &[
        (
            CasePart::ElasticFlanks,
            "the published equations have rigid flanks",
        ),
        (CasePart::Rotor, "the published equations have no rotor"),
        (CasePart::Space, "the published equations are planar"),
        (
            CasePart::Unbalance,
            "the published equations have no unbalance",
        ),
    ],
};

impl Formulation {
    /// Properties of its equations.
    pub(crate) fn equations(self) -> &'static Equations {
        match self {
            Self::Physical => &PHYSICAL,
            Self::Paper => &PUBLISHED,
        }
    }

    /// The reason why its equations do not have a part of a case; `None` of one that they have.
    pub(crate) fn refusal(self, part: CasePart) -> Option<&'static str> {
        self.equations().refusal(part)
    }
}
