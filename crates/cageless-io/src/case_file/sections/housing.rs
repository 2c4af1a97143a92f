//! `[housing]`.

use crate::case_file::declaration::prelude::*;

section! {
    /// `[housing]`: support of the outer ring, for its vibration.
    impl cageless::Housing {
        mass_kg => mass_kg: f64 = Required, Si("kg"); Above(0.0),
            "mass of housing and outer ring", Commented("1.0", "housing and outer ring");
        stiffness_n_m => stiffness_n_m: f64 = Required, Si("N/m"); Above(0.0),
            "stiffness of the support", Commented("1.0e8", "");
        damping_n_s_m => damping_n_s_m: f64 = Required, Si("N s/m"); AtLeast(0.0),
            "damping of the support", Commented("500.0", "");
    }
}
