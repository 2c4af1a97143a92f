//! Sets of equations.

crate::named_enum! {
    /// Set of equations that is integrated.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Formulation {
        /// Consistent mechanics: inertial frame, absolute spin, friction along the
        /// sliding velocity.
        Physical = "physical",
        /// As published: centrifugal force added in Zhao 2022, Eq. (12), spin of
        /// Eq. (13) taken relative to the frame that turns with the ball's orbit,
        /// friction on the discrete raceway along the contact path.
        Paper = "paper",
    }
}
