//! The section `[search]`, from the document to what the library is asked.

use crate::case_file::declaration::section;
use crate::case_file::fields::RangeDocument;
use crate::case_file::key::Line::Commented;
use crate::case_file::key::Presence::{Default, Optional};
use crate::case_file::unit::Unit::{
    Degree, Millimetre, None as Plain, RevolutionPerMinute, Si, Whole,
};

section! {
    /// `[search]`: what `design --search` looks at. What is `None` is that of the case, or all
    /// that the geometry allows. More than four raceways leave hardly any plain raceway between
    /// them.
    SearchDocument {
        inner_speed_rpm: Option<RangeDocument> = Optional, RevolutionPerMinute,
            "speed, or lowest and highest",
            Commented("[3000.0, 12000.0]", "one number, or lowest and highest;");
        radial_load_n: Option<RangeDocument> = Optional, Si("N"),
            "load, or lowest and highest",
            Commented("[500.0, 1500.0]", "left out: those of the case");
        axial_span_mm: Option<RangeDocument> = Optional, Millimetre,
            "lC, or narrowest and widest",
            Commented("[4.0, 6.0]", "left out: all that the groove allows");
        half_angle_deg: Option<RangeDocument> = Optional, Degree,
            "θ, or smallest and largest",
            Commented("[15.0, 30.0]", "left out: all that the bearing allows");
        centre_angle_deg: Option<RangeDocument> = Optional, Degree,
            "ψ of the middle of one raceway, or first and last",
            Commented("[-90.0, 90.0]", "places of the raceway; left out: its own");
        raceways_max: usize = Default(1), Whole(1, Some(4)),
            "number of raceways at most", Commented("1", "1 to 4");
        critical_gap_min_fraction formerly spread_min: f64 = Default(cageless::design::search::CRITICAL_GAP_MIN_FRACTION), Plain,
            "smallest accepted critical gap, as a fraction of the steady-state gap",
            Commented("0.8", "smallest accepted critical gap, as a fraction of the steady-state gap");
        initial_states formerly starts: u64 = Default(2), Whole(1, Some(64)),
            "unevenly spaced starts per design",
            Commented("2", "unevenly spaced starts per design, 1 to 64");
        runs_max formerly budget: usize = Default(cageless::design::search::BUDGET), Whole(1, None),
            "largest number of simulations of all balls",
            Commented("400", "largest number of simulations of all balls");
        map_speed_rpm: Option<Vec<f64>> = Optional, RevolutionPerMinute,
            "further speeds to draw maps at",
            Commented("[6000.0, 20000.0]", "further speeds to draw maps at");
    }
}
