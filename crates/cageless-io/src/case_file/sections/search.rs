//! The section `[search]`, ranges of `design --search`.

use cageless_design::STEADY_GAP;
use cageless_design::search::{BUDGET, BUDGET_LEAST};

use crate::case_file::declaration::prelude::*;
use crate::case_file::named::SearchedShapes;

section! {
    /// `[search]`: what `design --search` looks at. What is `None` is that of the case, or all
    /// that the geometry allows. More than four raceways leave hardly any plain raceway between
    /// them.
    struct SearchSection {
        inner_speed_rpm => inner_speed_rad_s: Option<[f64; 2]> = Optional, RevolutionPerMinute; Above(0.0),
            "speed, or lowest and highest",
            Commented("[3000.0, 12000.0]", "one number, or lowest and highest;");
        radial_load_n => radial_load_n: Option<[f64; 2]> = Optional, Si("N"); AtLeast(0.0),
            "load, or lowest and highest",
            Commented("[500.0, 1500.0]", "left out: those of the case");
        axial_load_n => axial_load_n: Option<[f64; 2]> = Optional, Si("N"),
            "axial load, or lowest and highest, of a case in space; that of the case unless given",
            Absent;
        axial_span_mm => axial_span_m: Option<[f64; 2]> = Optional, Millimetre; Above(0.0),
            "lC, or narrowest and widest",
            Commented("[4.0, 6.0]", "left out: all that the groove allows");
        half_angle_deg => half_angle_rad: Option<[f64; 2]> = Optional, Degree; Inside(0.0, 90.0),
            "θ, or smallest and largest",
            Commented("[15.0, 30.0]", "left out: all that the bearing allows");
        contact_angle_deg => section_angle_rad: Option<Vec<f64>> = Optional, Degree; Within(-90.0, 90.0),
            "contact angles of the raceway, of a case in space; that of the raceway, or of the bearing, unless given",
            Absent;
        centre_angle_deg => centre_angle_rad: Option<[f64; 2]> = Optional, Degree; Within(-180.0, 180.0),
            "ψ of the middle of one raceway, or first and last",
            Commented("[-90.0, 90.0]", "places of the raceway; left out: its own");
        raceways_max => raceways_max: usize = default(1), Plain; Within(1.0, 4.0),
            "number of raceways at most", Commented("1", "1 to 4");
        shapes => shapes: SearchedShapes = default(SearchedShapes::Own.name()), Plain,
            "shapes of the raceway: \"own\", that of the case, or \"all\", every one that needs no profile, blended as that of the case, and slots if they are that of the case or edge_radius_mm is given",
            Commented("\"own\"", "\"own\": the shape of the case; \"all\": every shape");
        edge_radius_mm => edge_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "radius of the edges of the slots that shapes = \"all\" tries as well, of a case in space; slots of the case keep their own", Absent;
        critical_gap_min_fraction formerly spread_min => critical_gap_min_fraction: f64 = default(STEADY_GAP.limit()), Plain; Inside(0.0, 1.0),
            "smallest accepted critical gap, as a fraction of the steady-state gap; left out with [film], where 1 to 1.1 are sought",
            Commented("0.8", "smallest accepted critical gap, as a fraction of the steady-state gap");
        axial_load_max_n => axial_load_max_n: f64 = default(0.0), Si("N"); AtLeast(0.0),
            "largest axial load, under which a raceway must keep half of its lag: by rolling at the contact angle of the load, then in space; 0: none; only in \"physical\" and in the plane: a case in space has axial_load_n",
            Commented("0.0", "largest axial load under which a raceway keeps half of its lag, N");
        initial_states formerly starts => initial_states: u64 = default(2), Plain; Within(1.0, 64.0),
            "unevenly spaced starts per design",
            Commented("2", "unevenly spaced starts per design, 1 to 64");
        runs_max formerly budget => runs_max: usize = default(BUDGET as i64), Plain; AtLeast(BUDGET_LEAST as f64),
            "largest number of simulations of all balls; more initial_states, operating points and maps need more",
            Commented("400", "largest number of simulations of all balls");
        map_speed_rpm => map_speeds_rad_s: Option<Vec<f64>> = Optional, RevolutionPerMinute; Above(0.0),
            "further speeds to draw maps at",
            Commented("[6000.0, 20000.0]", "further speeds to draw maps at");
    }
}
