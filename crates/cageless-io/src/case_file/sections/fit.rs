//! `[fit]`.

use cageless::{BearingClass, HoleClass, ShaftClass};

use crate::case_file::declaration::prelude::*;

section! {
    /// `[fit]`: fits, temperatures and speed, which make the clearance in operation of that of the bearing by itself.
    impl cageless::Fit {
        bore_diameter_mm => bore_diameter_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "d, bore diameter of the inner ring; twice bearing.inner_ring_bore_radius_mm unless given; needed with a fit on the shaft",
            Commented("30.0", "d of the inner ring");
        outside_diameter_mm => outside_diameter_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "D, outside diameter of the outer ring; twice bearing.outer_ring_outer_radius_mm unless given; needed with a fit in the housing",
            Commented("62.0", "D of the outer ring");
        shaft => shaft: Option<ShaftClass> = Optional, Plain,
            "tolerance class of the shaft by ISO 286, \"k5\" say, in place of shaft_interference_um: d, e, f, g, h, js, k, m, n, p or r with grade 4 to 9, j5 to j7; the middles of the tolerances of shaft and bore make the fit, their limits the range of the clearance",
            Commented("\"k5\"", "tolerance class of ISO 286, or shaft_interference_um");
        housing => housing: Option<HoleClass> = Optional, Plain,
            "tolerance class of the bore of the housing by ISO 286, \"H7\" say, in place of housing_interference_um: D, E, F, G, H, JS, M, N, P or R with grade 4 to 9, J6 to J8, K4 to K8",
            Commented("\"H7\"", "or housing_interference_um");
        tolerance_class => tolerance_class: Option<BearingClass> = Optional, Plain,
            "tolerance class of the bearing by ISO 492, for its bore and outside diameter; \"normal\" unless given; with shaft or housing", Absent;
        smoothing_um => smoothing_m: Option<f64> = Optional, Micrometre; AtLeast(0.0),
            "interference lost by smoothing of the surfaces, with shaft or housing; 1.75 unless given, the middle of NTN's 1.0 to 2.5 of ground shafts; turned ones 5 to 7", Absent;
        clearance_tolerance_um => clearance_tolerance_m: f64 = default(0.0), Micrometre; AtLeast(0.0),
            "tolerance of Gr before mounting, ±: half the width of its group of ISO 5753-1",
            Commented("0.0", "of Gr before mounting, ±");
        shaft_interference_um => shaft_interference_m: Option<f64> = Optional, Micrometre,
            "effective interference of shaft and bore on the diameter, smoothing of the surfaces deducted; below 0: a gap; 0 unless given", Absent;
        housing_interference_um => housing_interference_m: Option<f64> = Optional, Micrometre,
            "effective interference of outer ring and housing on the diameter; below 0: a gap; 0 unless given", Absent;
        shaft_bore_diameter_mm => shaft_bore_diameter_m: f64 = default(0.0), Millimetre; AtLeast(0.0),
            "bore of a hollow shaft; 0: a solid one",
            Commented("0.0", "0: a solid shaft");
        housing_outside_diameter_mm => housing_outside_diameter_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "outside diameter of the housing; a thick one unless given", Absent;
        shaft_youngs_modulus_gpa => shaft_youngs_modulus_pa: Option<f64> = Optional, Gigapascal; Above(0.0),
            "modulus of the shaft; that of the rings unless given", Absent;
        shaft_poisson_ratio => shaft_poisson_ratio: Option<f64> = Optional, Plain; Within(0.0, 0.5),
            "Poisson's ratio of the shaft; that of the rings unless given", Absent;
        housing_youngs_modulus_gpa => housing_youngs_modulus_pa: Option<f64> = Optional, Gigapascal; Above(0.0),
            "modulus of the housing; that of the rings unless given", Absent;
        housing_poisson_ratio => housing_poisson_ratio: Option<f64> = Optional, Plain; Within(0.0, 0.5),
            "Poisson's ratio of the housing; that of the rings unless given", Absent;
        inner_ring_temperature_c => inner_ring_temperature_c: Option<f64> = Optional, Si("C"),
            "temperature of the inner ring; 20 °C unless given",
            Commented("60.0", "20 °C unless given");
        outer_ring_temperature_c => outer_ring_temperature_c: Option<f64> = Optional, Si("C"),
            "temperature of the outer ring; 20 °C unless given",
            Commented("55.0", "20 °C unless given");
        ball_temperature_c => ball_temperature_c: Option<f64> = Optional, Si("C"),
            "temperature of the balls; the mean of both rings unless given", Absent;
        shaft_temperature_c => shaft_temperature_c: Option<f64> = Optional, Si("C"),
            "temperature of the shaft; that of the inner ring unless given", Absent;
        housing_temperature_c => housing_temperature_c: Option<f64> = Optional, Si("C"),
            "temperature of the housing; that of the outer ring unless given", Absent;
        ring_expansion_per_k => ring_expansion_per_k: Option<f64> = Optional, Si("1/K"); Within(0.0, 1e-3),
            "coefficient of thermal expansion of the rings; 12.5e-6, bearing steel, unless given; needed of warm rings of another material", Absent;
        ball_expansion_per_k => ball_expansion_per_k: Option<f64> = Optional, Si("1/K"); Within(0.0, 1e-3),
            "coefficient of thermal expansion of the balls; 12.5e-6, bearing steel, unless given; needed of warm balls of another material", Absent;
        shaft_expansion_per_k => shaft_expansion_per_k: Option<f64> = Optional, Si("1/K"); Within(0.0, 1e-3),
            "coefficient of thermal expansion of the shaft; that of the rings unless given", Absent;
        housing_expansion_per_k => housing_expansion_per_k: Option<f64> = Optional, Si("1/K"); Within(0.0, 1e-3),
            "coefficient of thermal expansion of the housing; that of the rings unless given", Absent;
    }
}

/// Keys that say the same: either that of the first column or that of the second.
pub(in crate::case_file) const ALTERNATIVES: &[(&[&str], &[&str])] = &[
    (&["shaft"], &["shaft_interference_um"]),
    (&["housing"], &["housing_interference_um"]),
];
