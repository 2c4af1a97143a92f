//! Groups of results by subject.

/// Group under whose heading readers find a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// Motion of a rotor that drops.
    Rotor,
    /// Forces of a drop.
    Forces,
    /// Lives and what they follow from.
    Life,
    /// Safety against permanent deformation and sliding.
    Safety,
    /// Contact pressures and forces.
    Pressure,
    /// Clearance in operation and what makes it.
    Clearance,
    /// Place of the inner ring.
    Displacement,
    /// Stiffness of the bearing.
    Stiffness,
    /// Frequencies of the balls.
    Frequencies,
    /// Frequencies of the balls as multiples of that of the shaft.
    Orders,
    /// Orbital speeds around the bearing and between balls.
    BallAdvance,
    /// Friction torque, losses and what bounds the speed.
    Friction,
    /// Oil film and rolling resistance.
    Film,
    /// Contacts between balls.
    Contacts,
    /// Gaps between balls.
    Spacing,
    /// Passages through discrete raceways.
    Passages,
    /// Losses and the heat that they make.
    Heat,
    /// Temperatures.
    Temperature,
    /// How the result was computed.
    Computation,
    /// No group.
    Other,
}

impl Group {
    /// The heading; empty without a group.
    pub fn heading(self) -> &'static str {
        match self {
            Self::Rotor => "Motion of the rotor",
            Self::Forces => "Forces",
            Self::Life => "Life",
            Self::Safety => "Safety",
            Self::Pressure => "Pressure",
            Self::Clearance => "Clearance",
            Self::Displacement => "Displacement of the inner ring",
            Self::Stiffness => "Stiffness",
            Self::Frequencies => "Frequencies",
            Self::Orders => "Frequencies, multiples of that of the shaft",
            Self::BallAdvance => "Ball advance",
            Self::Friction => "Friction and speed",
            Self::Film => "Oil film",
            Self::Contacts => "Contacts between balls",
            Self::Spacing => "Spacing of the balls",
            Self::Passages => "Passages through the discrete raceway",
            Self::Heat => "Losses and heat",
            Self::Temperature => "Temperatures",
            Self::Computation => "Computation",
            Self::Other => "",
        }
    }
}
