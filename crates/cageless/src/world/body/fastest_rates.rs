//! Share of the bodies in the fastest rates of a case.

/// Largest stiffness and damping of the contacts of the bodies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactStiffness {
    /// Balls that together carry the inner ring.
    pub carrying: f64,
    /// dF/dδ of a ball at the inner raceway, N/m.
    pub inner_n_m: f64,
    /// dF/dδ of a ball at the outer raceway, N/m.
    pub outer_n_m: f64,
    /// dF/dδ of journal and bore, N/m.
    pub journal_n_m: f64,
    /// Damping of a ball at the inner raceway, N·s/m.
    pub inner_n_s_m: f64,
    /// Damping of a ball at the outer raceway, N·s/m.
    pub outer_n_s_m: f64,
    /// Damping of journal and bore, N·s/m.
    pub journal_n_s_m: f64,
}

/// Contribution of a body to the fastest rates of a case.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct FastestRates {
    /// To ω², 1/s².
    pub square_1_s2: f64,
    /// To the decay of oscillations, 1/s.
    pub decay_1_s: f64,
}
