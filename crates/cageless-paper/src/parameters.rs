//! Table 1 and the figures that need no simulation.

use cageless::closed_forms::span_angle_curve;
use cageless::raceway::axial_span_limit_m;
use cageless::{Case, RacewayForm};
use cageless_io::case_file::CaseFile;
use cageless_report::{
    ContactTrack, DesignCurve, DesignLimit, LimitedQuantity, Parameter, Provenance, RacewaySurface,
};

use crate::cases::{self, READINGS, label};

/// Structure (d), the one that the authors had made.
const SAMPLE: usize = 3;

/// Parameters as text, by their source: `"name" "symbol" = value, "unit";`.
macro_rules! parameters {
    ($(from $source:literal: $($name:literal $symbol:literal = $value:expr, $unit:literal;)*)*) => {
        vec![$($(Parameter {
            name: $name.to_owned(),
            symbol: $symbol.to_owned(),
            value: $value.to_string(),
            unit: $unit.to_owned(),
            source: $source.to_owned(),
        },)*)*]
    };
}

/// Table 1, then what the paper leaves out.
pub fn table1(case: &Case) -> Vec<Parameter> {
    let d = case.bearing.dimensions();
    let m = case.bearing.materials().ball;
    let c = &case.contact;
    let mm = |v: f64| format!("{}", (v * 1e9).round() / 1e6);
    let rpm = case.operation.inner_speed_rad_s * 60.0 / std::f64::consts::TAU;
    parameters! {
        from "Table 1":
        "ball radius" "Rw" = mm(d.ball_radius_m), "mm";
        "outer groove bottom radius" "Ro" = mm(d.outer_groove_bottom_radius_m), "mm";
        "inner groove bottom radius" "Ri" = mm(d.inner_groove_bottom_radius_m), "mm";
        "outer shoulder radius" "Ros" = mm(d.outer_shoulder_radius_m), "mm";
        "balls" "N" = d.balls.to_string(), "";
        "inner ring speed" "ωi" = format!("{rpm:.0}"), "rpm";
        "radial load" "Fr" = case.operation.radial_load_n, "N";
        from "Section 3.3":
        "friction coefficient" "μ" = c.friction.coefficient, "";
        from "not in the paper":
        "groove curvature radii (0.52 ball diameters)" "Re" = mm(d.outer_groove_curvature_radius_m), "mm";
        "inner ring mass" "mi" = d.inner_ring_mass_kg, "kg";
        "inner ring drag" "C" = d.inner_ring_damping_n_s_m, "N·s/m";
        "density" "" = m.density_kg_m3, "kg/m³";
        "Young's modulus" "E" = m.youngs_modulus_pa * 1e-9, "GPa";
        "Poisson's ratio" "ν" = m.poisson_ratio, "";
        "raceway damping" "c" = format!("{:e}", c.damping_n_s_m1_5), "N·s/m^1.5";
        "restitution between balls" "e" = c.ball_restitution, "";
        "knee of the smooth law" "" = c.friction.regularisation_speed_m_s, "m/s";
    }
}

/// Fig. 1b.
pub fn contact_track(case: &Case) -> ContactTrack {
    ContactTrack::sample(&case.raceways[0], &case.bearing, label(SAMPLE, case))
}

/// Fig. 2.
pub fn surface(case: &Case) -> RacewaySurface {
    RacewaySurface::sample(&case.raceways[0], &case.bearing, label(SAMPLE, case))
}

/// Fig. 5.
pub fn design_curve(file: &CaseFile) -> DesignCurve {
    let bearing = &file.case().bearing;
    let curve = span_angle_curve(bearing, RacewayForm::default(), 240);
    let (epsilon, gap) = (bearing.ball_angle_rad(), bearing.nominal_gap_rad());
    let three_balls_deg = (epsilon + gap).to_degrees();
    let span_mm = axial_span_limit_m(bearing) * 1e3;
    let paper = (0..10).filter_map(|k| {
        let case = cases::structure(k, READINGS[0], &[]).ok()?;
        Some(label(k, &case))
    });
    DesignCurve {
        paper: paper.collect(),
        limits: vec![
            DesignLimit::new(LimitedQuantity::AxialSpan, span_mm, "Eq. (8)"),
            DesignLimit::new(
                LimitedQuantity::HalfAngle,
                three_balls_deg,
                "three balls inside",
            ),
            DesignLimit::new(LimitedQuantity::HalfAngle, 22.0, "sliding, Section 4.3"),
        ],
        provenance: Provenance {
            case: file.particulars().title.clone(),
            ..Provenance::default()
        },
        ..DesignCurve::new(&curve, gap.to_degrees())
    }
}
