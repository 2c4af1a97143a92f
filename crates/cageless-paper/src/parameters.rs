//! Table 1 and the figures that need no simulation.

use cageless::Case;
use cageless::design::span_angle_curve;
use cageless::raceway::axial_span_limit_m;
use cageless_report::{
    ContactTrack, DesignCurve, DesignLimit, LimitedQuantity, Parameter, Provenance, RacewaySurface,
};

use crate::cases::READINGS;
use crate::cases::{self, label};

/// Structure (d), the one that the authors had made.
const SAMPLE: usize = 3;

/// Table 1, then what the paper leaves out.
pub fn table1(case: &Case) -> Vec<Parameter> {
    let d = case.bearing.dimensions();
    let m = case.bearing.materials().ball;
    let c = &case.contact;
    let line = |name: &str, symbol: &str, value: String, unit: &str, source: &str| Parameter {
        name: name.to_owned(),
        symbol: symbol.to_owned(),
        value,
        unit: unit.to_owned(),
        source: source.to_owned(),
    };
    let mm = |v: f64| format!("{}", (v * 1e9).round() / 1e6);
    let rpm = case.operation.inner_speed_rad_s * 60.0 / std::f64::consts::TAU;
    let given = "Table 1";
    let chosen = "not in the paper";
    vec![
        line("ball radius", "Rw", mm(d.ball_radius_m), "mm", given),
        line(
            "outer groove bottom radius",
            "Ro",
            mm(d.outer_groove_bottom_radius_m),
            "mm",
            given,
        ),
        line(
            "inner groove bottom radius",
            "Ri",
            mm(d.inner_groove_bottom_radius_m),
            "mm",
            given,
        ),
        line(
            "outer shoulder radius",
            "Ros",
            mm(d.outer_shoulder_radius_m),
            "mm",
            given,
        ),
        line("balls", "N", d.balls.to_string(), "", given),
        line("inner ring speed", "ωi", format!("{rpm:.0}"), "rpm", given),
        line(
            "radial load",
            "Fr",
            format!("{}", case.operation.radial_load_n),
            "N",
            given,
        ),
        line(
            "friction coefficient",
            "μ",
            format!("{}", c.friction_coefficient),
            "",
            "Section 3.3",
        ),
        line(
            "groove curvature radii (0.52 ball diameters)",
            "Re",
            mm(d.outer_groove_curvature_radius_m),
            "mm",
            chosen,
        ),
        line(
            "inner ring mass",
            "mi",
            format!("{}", d.inner_ring_mass_kg),
            "kg",
            chosen,
        ),
        line(
            "inner ring drag",
            "C",
            format!("{}", d.inner_ring_drag_n_s_m),
            "N·s/m",
            chosen,
        ),
        line(
            "density",
            "",
            format!("{}", m.density_kg_m3),
            "kg/m³",
            chosen,
        ),
        line(
            "Young's modulus",
            "E",
            format!("{}", m.youngs_modulus_pa * 1e-9),
            "GPa",
            chosen,
        ),
        line(
            "Poisson's ratio",
            "ν",
            format!("{}", m.poisson_ratio),
            "",
            chosen,
        ),
        line(
            "raceway damping",
            "c",
            format!("{:e}", c.damping_n_s_m1_5),
            "N·s/m^1.5",
            chosen,
        ),
        line(
            "restitution between balls",
            "e",
            format!("{}", c.ball_restitution),
            "",
            chosen,
        ),
        line(
            "knee of the smooth law",
            "",
            format!("{}", c.slip_scale_m_s),
            "m/s",
            chosen,
        ),
    ]
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
pub fn design_curve(case: &Case) -> DesignCurve {
    let bearing = &case.bearing;
    let curve = span_angle_curve(bearing, 240);
    let (epsilon, gap) = (bearing.ball_angle_rad(), bearing.nominal_gap_rad());
    DesignCurve {
        paper: (0..10)
            .filter_map(|k| {
                cases::structure(k, READINGS[0], &[])
                    .ok()
                    .map(|c| label(k, &c))
            })
            .collect(),
        limits: vec![
            DesignLimit {
                quantity: LimitedQuantity::AxialSpan,
                value: axial_span_limit_m(bearing) * 1e3,
                label: "Eq. (8)".to_owned(),
            },
            DesignLimit {
                quantity: LimitedQuantity::HalfAngle,
                value: (epsilon + gap).to_degrees(),
                label: "three balls inside".to_owned(),
            },
            DesignLimit {
                quantity: LimitedQuantity::HalfAngle,
                value: 22.0,
                label: "slip, Section 4.3".to_owned(),
            },
        ],
        provenance: Provenance {
            case: case.title.clone(),
            ..Provenance::default()
        },
        ..DesignCurve::new(&curve, gap.to_degrees())
    }
}
