//! `[lubrication]`.

use cageless::{Lubricant, SkfSeries};

use crate::case_file::declaration::prelude::*;

section! {
    /// `[lubrication]`: the lubricant, for ratings; the motion does not take it.
    impl cageless::Lubrication {
        viscosity_mm2_s => viscosity_m2_s: f64 = Derived, SquareMillimetrePerSecond; Above(0.0),
            "ν, kinematic viscosity at the temperature of operation, of a grease that of its base oil; required, but with [film], whose oil gives it",
            Commented("13.0", "at the temperature of operation; left out with [film]");
        contamination_factor => contamination_factor: f64 = Required, Plain; Within(0.0, 1.0),
            "eC of ISO 281: 1 extreme cleanliness, 0.8 to 0.6 high, 0.6 to 0.5 normal, 0.5 to 0.3 slight and 0.3 to 0.1 typical contamination, 0.1 to 0 severe, below a pitch diameter of 100 mm",
            Commented("0.5", "eC of ISO 281: 1 clean, 0 very severe");
        fatigue_load_limit_n => fatigue_load_limit_n: Option<f64> = Optional, Si("N"); Above(0.0),
            "Cu (SKF: Pu) of the catalogue; from a contact pressure of 1500 MPa unless given",
            Commented("500.0", "Cu (SKF: Pu) of the catalogue");
        minimum_load_factor => minimum_load_factor: Option<f64> = Optional, Plain; Above(0.0),
            "kr of SKF's catalogue, for the minimum load; none unless given",
            Commented("0.025", "kr of SKF, for the minimum load");
        skf_series => skf_series: Option<SkfSeries> = Optional, Plain,
            "series of the bearing for SKF's friction model: \"62\" for 62 and 622 and so on; not computed unless given; SKF has no constants for a full complement of balls",
            Commented("\"62\"", "for SKF's friction model, of bearings with a cage");
        lubricant => lubricant: Lubricant = default("oil"), Plain,
            "for SKF's friction model: \"oil\", a low bath or a jet, or \"grease\", or oil with air",
            Commented("\"oil\"", "or \"grease\"");
        film_friction_coefficient => film_friction_coefficient: f64 = default(0.05), Plain; AtLeast(0.0),
            "μEHL of SKF's friction model, in a full film: 0.05 mineral oil, 0.04 synthetic oil, 0.1 transmission fluid",
            Commented("0.05", "in a full film of mineral oil; synthetic: 0.04");
    }
}
