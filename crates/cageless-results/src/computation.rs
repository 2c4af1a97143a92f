//! Computations.

cageless::named_enum! {
    /// Computation of a case, in the order in which a sweep does them.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Computation {
        /// Static equilibrium with ratings.
        Static = "static",
        /// Closed forms of the design: limits, β0, gaps.
        Design = "design",
        /// Critical gap and verdict, from the motion.
        Verdict = "verdict",
        /// A run of the case.
        Run = "run",
        /// The drop of the rotor of the case, or of the rotor file.
        Drop = "drop",
    }
}
