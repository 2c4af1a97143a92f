//! Flanks of a discrete raceway under load.

crate::named_enum! {
    /// What the load of a ball does to its contacts with the two flanks of a discrete raceway.
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
