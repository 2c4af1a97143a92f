//! Properties of a set of equations.

/// A part of a case that not every set of equations has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum CasePart {
    /// Flanks of discrete raceways that yield under load.
    ElasticFlanks,
    /// A rotor that falls onto the inner ring.
    Rotor,
    /// Motion in space.
    Space,
    /// An unbalance of the inner ring.
    Unbalance,
}

/// Properties of a set of equations on which starts, equilibria, balances and checks of a case depend.
#[derive(Debug)]
pub(crate) struct Equations {
    /// Whether the centrifugal force is added to the forces on a ball, Zhao 2022, Eq. (12).
    pub centrifugal_force: bool,
    /// Whether the orbital speed of a ball is its tangential speed over Rm, Zhao 2022, Eq. (1) and (2); else over its
    /// distance from the axis.
    pub orbits_on_pitch_circle: bool,
    /// Whether the spin of a ball is taken relative to its orbit, Zhao 2022, Eq. (13).
    pub spin_relative_to_orbit: bool,
    /// Whether friction on a discrete raceway acts along the contact path, else against the sliding velocity.
    pub friction_along_path: bool,
    /// Parts of a case that they do not have, each with the reason.
    pub refusals: &'static [(CasePart, &'static str)],
}

impl Equations {
    /// The reason why they do not have a part of a case; `None` of one that they have.
    pub(crate) fn refusal(&self, part: CasePart) -> Option<&'static str> {
        let refused = self.refusals.iter().find(|(refused, _)| *refused == part);
        refused.map(|(_, why)| *why)
    }
}
