//! `[support]`: what carries the outer ring under a falling rotor.

use crate::case_file::declaration::prelude::*;

section! {
    /// `[support]`: the support of the outer ring and housing under a falling rotor; without it
    /// they are fixed.
    struct SupportSection {
        mass_kg => support_mass_kg: f64 = Required, Si("kg"); Above(0.0),
            "mass of outer ring and housing", Shown("0.5", "outer ring and housing");
        stiffness_n_m => support_stiffness_n_m: f64 = Required, Si("N/m"); Above(0.0),
            "stiffness of the support", Shown("2.0e7", "ribbon or O-ring: 1e6 to 5e7");
        damping_n_s_m => support_damping_n_s_m: f64 = Required, Si("N s/m"); AtLeast(0.0),
            "damping of the support", Shown("4.0e3", "");
        stop_gap_um => stop_gap_m: Option<f64> = Optional, Micrometre; Above(0.0),
            "way of the outer ring to a hard stop; none unless given", Absent;
        stop_stiffness_n_m => stop_stiffness_n_m: Option<f64> = Optional, Si("N/m"); Above(0.0),
            "stiffness of the hard stop", Absent;
    }
}
