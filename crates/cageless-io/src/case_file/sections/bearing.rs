//! `[bearing]`: radii, or what a bearing engineer has, diameters, conformities and clearance.

use cageless::{Assembly, Bearing, BearingDimensions};
use cageless::{BALLS_MIN, CONFORMITY, SHOULDER_HEIGHT};
use serde::Serialize;

use crate::case_file::declaration::prelude::*;
use crate::case_file::spanned_toml::Tree;
use crate::case_file::unit::{Side, round};

section! {
    /// `[bearing]`: dimensions and masses of rings and balls.
    struct BearingSection {
        balls => balls: usize = Required, Plain; AtLeast(BALLS_MIN as f64),
            "N, number of balls", Shown("14", "number of balls, 3 or more (paper)");
        ball_radius_mm => ball_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "Rw, radius of a ball", Shown("4.7625", "Rw, or ball_diameter_mm (paper)");
        ball_diameter_mm => ball_diameter_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "Dw = 2 Rw, diameter of a ball, in place of ball_radius_mm", Absent;
        inner_groove_bottom_radius_mm => inner_groove_bottom_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "Ri, radius of the inner ring at the bottom of its groove",
            Shown("18.24", "Ri, where the balls run on the inner ring (paper)");
        outer_groove_bottom_radius_mm => outer_groove_bottom_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "Ro, radius of the outer ring at the bottom of its groove",
            Shown("27.765", "Ro, where the balls run on the outer ring (paper);\n\
                Ro - Ri - 2 Rw is half the radial internal clearance\n\
                Gr of ISO 5753-1; below 0: preload. In place of Ri and Ro:\n\
                pitch_diameter_mm and radial_internal_clearance_um");
        pitch_diameter_mm => pitch_diameter_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "Dpw = Ri + Ro, pitch diameter, in place of Ri and Ro", Absent;
        radial_internal_clearance_um => radial_internal_clearance_m: Option<f64> = Optional, Micrometre,
            "Gr = 2 (Ro - Ri - 2 Rw) of ISO 5753-1, in place of Ri and Ro; below 0: preload by interference, half of it at each ball", Absent;
        contact_angle_deg => contact_angle_rad: Option<f64> = Optional, Degree; AtLeast(0.0),
            "α0, free contact angle of an angular-contact bearing: grooves without clearance are opened about the pitch circle until unloaded balls touch them there; 0, a radial bearing, unless given", Absent;
        outer_shoulder_radius_mm => outer_shoulder_radius_m: Option<f64> = Derived, Millimetre; Above(0.0),
            "Ros, shoulder bore radius of the outer ring; Ro - 0.2 Dw unless given",
            Shown("26.0", "Ros, shoulder bore radius of the outer ring (paper)");
        inner_shoulder_radius_mm => inner_shoulder_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "Ris, radius of the shoulders of the inner ring; Ri + 0.2 Dw unless given", Absent;
        inner_groove_curvature_radius_mm => inner_groove_curvature_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "radius of the inner groove in the meridian plane",
            Shown("4.953", "groove radius in the axial section, usually 1.02 to 1.08 Rw;\n\
                or inner_conformity and outer_conformity");
        outer_groove_curvature_radius_mm => outer_groove_curvature_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "Re, radius of the outer groove in the meridian plane",
            Shown("4.953", "Re, the same for the outer ring");
        inner_conformity => inner_conformity: Option<f64> = Optional, Plain,
            "fi, radius of the inner groove over Dw, in place of that radius; 0.52 unless one is given", Absent;
        outer_conformity => outer_conformity: Option<f64> = Optional, Plain,
            "fo = Re/Dw, in place of that radius; 0.52 unless one is given", Absent;
        inner_ring_mass_kg => inner_ring_mass_kg: Option<f64> = Derived, Si("kg"); Above(0.0),
            "mass of the inner ring and attached rotating parts; that of a steel ring with its shoulders, 0.3 Dw thick below its groove and 1.6 Dw wide for each row unless given",
            Shown("0.2", "inner ring and attached rotating parts");
        inner_ring_damping_n_s_m formerly inner_ring_drag_n_s_m => inner_ring_damping_n_s_m: Option<f64> = Derived, Si("N s/m"); AtLeast(0.0),
            "C of Zhao 2022, Eq. (14), viscous damping of inner-ring translation; 2000 unless given, 0 under a [rotor]",
            Shown("2000.0", "viscous damping of inner-ring translation (not drag\n\
                torque), usually 0 to 1e4");
        inner_ring_polar_inertia_kg_m2 => inner_ring_polar_inertia_kg_m2: Option<f64> = Optional, Si("kg m^2"); Above(0.0),
            "Ji of the inner ring with what turns with it, needed under a [rotor]", Absent;
        inner_ring_bore_radius_mm => inner_ring_bore_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "Rb, radius of the bore of the inner ring, needed under a [rotor], and d/2 of SKF's rules of friction", Absent;
        assembly => assembly: Option<Assembly> = Derived, Plain,
            "way of assembly, for the load ratings: \"filling-slot\" if the balls of a bearing without a contact angle fill more than 205° (N - 1 times ε), else \"without-slot\"",
            Commented("\"filling-slot\"", "bm of ISO 281: 1.1 with a filling slot, 1.3 \"without-slot\"\n\
                (eccentric rings, a fractured or split ring, or a\n\
                contact angle: counterbored shoulder)");
        ball_radius_deviation_um => ball_radius_deviation_m: Option<Vec<f64>> = Optional, Micrometre,
            "deviation of each ball's radius, the same in every [[row]]", Absent;
        outer_ring_outer_radius_mm => outer_ring_outer_radius_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "outer radius of the outer ring, for `export`, and D/2 of SKF's model of friction",
            Shown("31.0", "outer ring, only for the export to CAD");
        outer_ring_width_mm => outer_ring_width_m: Option<f64> = Optional, Millimetre; Above(0.0),
            "width of the outer ring", Shown("16.0", "width, only for the export to CAD");
    }
}

/// Keys that say the same: either those of the first column or those of the second.
pub(in crate::case_file) const ALTERNATIVES: &[(&[&str], &[&str])] = &[
    (&["ball_radius_mm"], &["ball_diameter_mm"]),
    (
        &[
            "inner_groove_bottom_radius_mm",
            "outer_groove_bottom_radius_mm",
        ],
        &["pitch_diameter_mm", "radial_internal_clearance_um"],
    ),
    (&["inner_groove_curvature_radius_mm"], &["inner_conformity"]),
    (&["outer_groove_curvature_radius_mm"], &["outer_conformity"]),
];

/// A value of `[bearing]` that is estimated from the other dimensions.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Assumption {
    /// Dotted key.
    pub key: String,
    /// Estimated value, in the unit of the key.
    pub value: f64,
    /// Basis of the estimate.
    pub basis: &'static str,
}

/// Key of each groove's conformity, and whether it follows from no key.
pub(in crate::case_file) fn conformities(tree: &Tree) -> [(&'static str, bool); 2] {
    let assumed = |radius: &str, conformity: &str| {
        tree.find(radius).is_none() && tree.find(conformity).is_none()
    };
    let [inner, outer] = ["bearing.inner_conformity", "bearing.outer_conformity"];
    [
        (
            inner,
            assumed("bearing.inner_groove_curvature_radius_mm", inner),
        ),
        (
            outer,
            assumed("bearing.outer_groove_curvature_radius_mm", outer),
        ),
    ]
}

/// Estimated values of `[bearing]`, in the unit of the file; of `d`, only radii that are
/// given count.
pub(in crate::case_file) fn assumptions(tree: &Tree, d: &BearingDimensions) -> Vec<Assumption> {
    let mm = |m: f64| Millimetre.of_si(m);
    let diameter = 2.0 * mm(d.ball_radius_m);
    let mut list = vec![];
    let mut assume = |assumed: bool, key: &str, value: f64, basis| {
        if assumed {
            let key = key.to_owned();
            list.push(Assumption { key, value, basis });
        }
    };
    let shoulder = mm(d.outer_groove_bottom_radius_m) - SHOULDER_HEIGHT * diameter;
    let key = "bearing.outer_shoulder_radius_mm";
    let basis = "shoulder height of 0.2 ball diameters";
    assume(
        tree.find(key).is_none(),
        key,
        round(shoulder, Side::Nearest),
        basis,
    );
    for (key, assumed) in conformities(tree) {
        assume(
            assumed,
            key,
            CONFORMITY,
            "usual in deep groove ball bearings",
        );
    }
    let key = "bearing.inner_ring_mass_kg";
    let width = tree.number("bearing.outer_ring_width_mm");
    let rings = tree.count("row").max(1) as f64;
    // A bearing keeps the mass with which it was made, though its grooves have moved since to the contact angle.
    let mass = match d.inner_ring_mass_kg {
        made if made > 0.0 => made,
        _ => rings * d.inner_ring_mass_estimate_kg(width.map(|mm| Millimetre.to_si(mm))),
    };
    assume(
        tree.find(key).is_none(),
        key,
        round(mass, Side::Nearest),
        "a steel ring without anything attached, 0.3 ball diameters thick below its groove, \
         1.6 ball diameters wide unless outer_ring_width_mm is given; as many as there are rows",
    );
    list
}

/// Fills in what is estimated.
pub(in crate::case_file) fn fill_in(tree: &mut Tree, bearing: &Bearing) {
    let damping = bearing.dimensions().inner_ring_damping_n_s_m;
    tree.set_missing("bearing.inner_ring_damping_n_s_m", damping);
    tree.set_missing("bearing.assembly", bearing.assembly().name());
    for Assumption { key, value, .. } in assumptions(tree, bearing.dimensions()) {
        tree.set(&key, value);
    }
}
