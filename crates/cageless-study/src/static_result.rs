//! The numbers of a static equilibrium and the ratings of the bearing, in the units in which
//! they are shown.

use std::f64::consts::TAU;

use cageless::Assembly;
use cageless::Case;
use cageless::equilibrium::{Equilibrium, RacewayContact};
use cageless::kinematics::{orbit_speed_of_rad_s, rolling_spin_rad_s};
use cageless::rating::{RatedMaterials, Rating};
use serde::Serialize;

/// `static --json`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct StaticResult {
    /// Centre of the inner ring, µm.
    pub ring_x_um: f64,
    /// Centre of the inner ring, µm.
    pub ring_y_um: f64,
    /// Stiffness matrix of the bearing at its operating point, rows x and y, N/m; `None` where
    /// nothing holds the ring in some direction.
    pub stiffness_n_m: Option<[[f64; 2]; 2]>,
    /// Way of assembly, on which Cr depends.
    pub assembly: &'static str,
    /// bm of ISO 281 for it.
    pub rating_factor: f64,
    /// Cr of ISO 281, N.
    pub basic_dynamic_rating_n: f64,
    /// C0r of ISO 76, N.
    pub basic_static_rating_n: f64,
    /// s0 = C0r/Fr of ISO 76; `None` without radial load.
    pub static_safety: Option<f64>,
    /// (4200 MPa/p)³ with the largest contact pressure p; `None` if no ball is loaded.
    pub pressure_safety: Option<f64>,
    /// L10 of ISO 281, million revolutions; `None` without radial load.
    pub l10_mrev: Option<f64>,
    /// L10r of ISO/TS 16281, million revolutions: rigid rings under the radial load, without
    /// weight and centrifugal force; `None` without radial load.
    pub l10r_mrev: Option<f64>,
    /// L10r with the forces of the balls in equilibrium, weight and centrifugal force included,
    /// million revolutions; `None` if no ball is loaded.
    pub l10r_at_speed_mrev: Option<f64>,
    /// L10 at the speed of the case, h.
    pub l10_h: Option<f64>,
    /// L10r at the speed of the case, h.
    pub l10r_h: Option<f64>,
    /// L10r with the forces in equilibrium, at the speed of the case, h.
    pub l10r_at_speed_h: Option<f64>,
    /// Orbital frequency of the balls in rolling, Hz.
    pub ftf_hz: f64,
    /// Balls past a point of the outer ring, Hz.
    pub bpfo_hz: f64,
    /// Balls past a point of the inner ring, Hz.
    pub bpfi_hz: f64,
    /// Rotation of a ball in the frame of its orbit, Hz.
    pub bsf_hz: f64,
    /// Orbital frequency of balls that roll through the discrete raceways as well, Hz.
    pub raceway_ftf_hz: f64,
    /// n·Dpw, mm/min.
    pub speed_parameter_mm_rpm: f64,
    /// ψ of each ball, degrees.
    pub ball_angle_deg: Vec<f64>,
    /// Fi of each ball, N.
    pub inner_force_n: Vec<f64>,
    /// Fo of each ball, N.
    pub outer_force_n: Vec<f64>,
    /// r of each ball, mm.
    pub effective_radius_mm: Vec<f64>,
    /// Largest contact pressure of each ball at the inner raceway, GPa.
    pub inner_pressure_gpa: Vec<f64>,
    /// Largest contact pressure of each ball at the outer raceway, GPa; on a discrete raceway
    /// at one of its two contact points.
    pub outer_pressure_gpa: Vec<f64>,
    /// Semi-axes of each contact ellipse at the inner raceway, along and across the rolling
    /// direction, mm.
    pub inner_semi_axes_mm: Vec<[f64; 2]>,
    /// Semi-axes of each contact ellipse at the outer raceway, along and across the rolling
    /// direction, mm; on a discrete raceway at one of its two contact points.
    pub outer_semi_axes_mm: Vec<[f64; 2]>,
    /// Orbital speed of each ball in rolling, rpm.
    pub ball_orbit_rpm: Vec<f64>,
    /// Absolute rotational speed of each ball in rolling, positive in the rolling sense, rpm.
    pub ball_rotation_rpm: Vec<f64>,
    /// K at the inner raceway, N·m^(−3/2).
    pub inner_stiffness: f64,
    /// K at the outer raceway, N·m^(−3/2).
    pub outer_stiffness: f64,
    /// Largest contact pressure at the inner raceway, GPa.
    pub inner_stress_max_gpa: f64,
    /// Largest contact pressure at the outer raceway, GPa.
    pub outer_stress_max_gpa: f64,
    /// Warnings.
    pub warnings: Vec<String>,
    /// What the numbers do not cover.
    pub notes: Vec<String>,
}

impl StaticResult {
    /// Result of the equilibrium of a case.
    pub fn new(case: &Case, e: Equilibrium) -> Self {
        let rating = Rating::new(case, &e);
        let passing = rating.passing;
        let hours = |life: Option<f64>| life.and_then(|l| Rating::hours(case, l));
        let speeds = (0..e.ball_angle_rad.len()).map(|k| {
            let (ball, r) = (case.bearing.ball(k), e.effective_radius_m[k]);
            let inner = case.operation.inner_speed_rad_s;
            let orbit = orbit_speed_of_rad_s(&case.bearing, ball.radius_m, inner, r);
            let rotation = rolling_spin_rad_s(&case.bearing, orbit, r);
            (orbit * 60.0 / TAU, rotation * 60.0 / TAU)
        });
        let (ball_orbit_rpm, ball_rotation_rpm) = speeds.unzip();
        Self {
            warnings: e.overload().into_iter().chain(rating.warnings()).collect(),
            notes: notes(case, &rating, &e),
            ring_x_um: e.ring_x_m * 1e6,
            ring_y_um: e.ring_y_m * 1e6,
            stiffness_n_m: e.stiffness_n_m,
            assembly: case.bearing.assembly().name(),
            rating_factor: case.bearing.assembly().rating_factor(),
            basic_dynamic_rating_n: rating.basic.dynamic_n,
            basic_static_rating_n: rating.basic.static_n,
            static_safety: rating.static_safety,
            pressure_safety: rating.pressure_safety,
            l10_mrev: rating.l10_mrev,
            l10r_mrev: rating.l10r_mrev,
            l10r_at_speed_mrev: rating.l10r_at_speed_mrev,
            l10_h: hours(rating.l10_mrev),
            l10r_h: hours(rating.l10r_mrev),
            l10r_at_speed_h: hours(rating.l10r_at_speed_mrev),
            ftf_hz: passing.ftf_hz,
            bpfo_hz: passing.bpfo_hz,
            bpfi_hz: passing.bpfi_hz,
            bsf_hz: passing.bsf_hz,
            raceway_ftf_hz: passing.raceway_ftf_hz,
            speed_parameter_mm_rpm: rating.speed_parameter_mm_rpm,
            ball_angle_deg: e.ball_angle_rad.iter().map(|a| a.to_degrees()).collect(),
            inner_pressure_gpa: pressures_gpa(&e.inner_contact),
            outer_pressure_gpa: pressures_gpa(&e.outer_contact),
            inner_semi_axes_mm: semi_axes_mm(&e.inner_contact),
            outer_semi_axes_mm: semi_axes_mm(&e.outer_contact),
            ball_orbit_rpm,
            ball_rotation_rpm,
            inner_force_n: e.inner_force_n,
            outer_force_n: e.outer_force_n,
            effective_radius_mm: e.effective_radius_m.iter().map(|r| r * 1e3).collect(),
            inner_stiffness: e.inner_stiffness_n_m1_5,
            outer_stiffness: e.outer_stiffness_n_m1_5,
            inner_stress_max_gpa: e.inner_stress_max_pa * 1e-9,
            outer_stress_max_gpa: e.outer_stress_max_pa * 1e-9,
        }
    }
}

fn pressures_gpa(contacts: &[RacewayContact]) -> Vec<f64> {
    contacts.iter().map(|c| c.pressure_pa * 1e-9).collect()
}

fn semi_axes_mm(contacts: &[RacewayContact]) -> Vec<[f64; 2]> {
    contacts
        .iter()
        .map(|c| c.semi_axes_m.map(|axis| axis * 1e3))
        .collect()
}

/// What ratings and stiffness of this case leave out.
fn notes(case: &Case, rating: &Rating, equilibrium: &Equilibrium) -> Vec<String> {
    let mut notes = vec![
        "ratings and lives are indicative: fatigue of a lubricated, clean bearing with plain \
         grooves"
            .to_owned(),
    ];
    if case.bearing.assembly() == Assembly::FillingSlot {
        notes.push(
            "bearing.assembly is \"filling-slot\": Cr has the factor bm = 1.1 of ISO 281 in place of \
             1.3, which a bearing without slot (fractured or split ring) keeps"
                .to_owned(),
        );
    }
    if !case.raceways.is_empty() {
        notes.push(
            "lives and C0r take the outer raceway as a plain groove; in the discrete raceway two \
             points share the load of a ball, the ends of the raceway are not rated"
                .to_owned(),
        );
    }
    match rating.materials {
        RatedMaterials::Steel => {}
        RatedMaterials::Hybrid => notes.push(
            "hybrid bearing: Cr and lives are those of the bearing with steel balls, which \
             ISO 20056-1 keeps; C0r and s0 are those of ISO 76 for steel balls; the ratings of \
             ISO 20056-2, with another limit of the contact pressure, are not computed"
                .to_owned(),
        ),
        RatedMaterials::Other => notes.push(
            "ISO 281, ISO 76 and ISO 20056 rate balls of bearing steel or silicon nitride in steel \
             rings; this case has other materials"
                .to_owned(),
        ),
    }
    if equilibrium.stiffness_n_m.is_none() {
        notes.push(
            "the stiffness is not defined: without load, or within the clearance, nothing holds \
             the ring in some direction"
                .to_owned(),
        );
    }
    let view = case.operation.view();
    notes.extend((!view.is_empty()).then(|| view.to_owned()));
    notes
}
