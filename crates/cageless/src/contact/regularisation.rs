//! Regularisation of friction at the raceways.

crate::named_enum! {
    /// Where the regularisation speed of friction at the raceways comes from.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Regularisation {
        /// The speed that the case gives.
        Speed = "speed",
        /// Kalker's creep, contact by contact, see `creep`.
        Kalker = "kalker",
    }
}
