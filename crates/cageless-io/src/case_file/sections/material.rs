//! `[material]`.

use crate::case_file::declaration::Line::Shown;
use crate::case_file::declaration::Presence::Default;
use crate::case_file::declaration::section;
use crate::case_file::unit::Unit::{Gigapascal, None as Plain, Si};

section! {
    /// `[material]`: bearing steel by default.
    MaterialDocument => Material {
        density_kg_m3 => density_kg_m3: f64 = Default(7850.0), Si("kg/m^3"),
            "density of the balls", Shown("7850.0", "");
        youngs_modulus_gpa => youngs_modulus_pa: f64 = Default(206.0), Gigapascal,
            "E of balls and rings", Shown("206.0", "");
        poisson_ratio => poisson_ratio: f64 = Default(0.3), Plain,
            "Poisson's ratio of balls and rings", Shown("0.3", "0 to below 0.5");
    }
}
