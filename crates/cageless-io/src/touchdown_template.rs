//! A case of a touch-down bearing by its designation: inner ring, rotor and support are assumed.

use std::f64::consts::{PI, TAU};

use crate::designation::{BoundaryDimensions, InternalGeometry};

const STEEL_KG_M3: f64 = 7850.0;
const GRAVITY_M_S2: f64 = 9.81;
/// Rotor weight over the basic static load rating C0r, about 12 N/mm²·Z·Dw².
const LOAD_SHARE: f64 = 0.01;
/// Speed times bore, rpm·mm.
const SPEED_BORE: f64 = 9e5;

/// A value to two digits: it is to be replaced.
fn rounded(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

/// An inner ring, or a pair of them, as a steel cylinder from the bore to a tenth of the ball diameter above the
/// groove.
struct AssumedRing {
    mass_kg: f64,
    polar_inertia_kg_m2: f64,
    /// Description in a comment.
    of: &'static str,
}

impl AssumedRing {
    fn new(bearing: &BoundaryDimensions, geometry: &InternalGeometry, bore_m: f64) -> Self {
        let ball_m = 1e-3 * geometry.ball_diameter_mm;
        let outer_m = (1e-3 * geometry.pitch_diameter_mm - ball_m) / 2.0 + 0.1 * ball_m;
        let bore_radius_m = bore_m / 2.0;
        let area_m2 = PI * (outer_m.powi(2) - bore_radius_m.powi(2));
        // Angular contact bearings come in pairs.
        let (rings, of) = match bearing.contact_angle_deg > 0.0 {
            true => (2.0, "steel rings"),
            false => (1.0, "steel ring"),
        };
        let mass_kg = rings * STEEL_KG_M3 * area_m2 * 1e-3 * bearing.width_mm;
        Self {
            mass_kg,
            polar_inertia_kg_m2: 0.5 * mass_kg * (outer_m.powi(2) + bore_radius_m.powi(2)),
            of,
        }
    }

    /// Head of `[bearing]`.
    fn keys(&self) -> String {
        let ring_kg = rounded(self.mass_kg);
        let ring_inertia = rounded(self.polar_inertia_kg_m2);
        format!(
            "\
[bearing]
inner_ring_mass_kg = {ring_kg:<25} # (assumed) {of} of width B
inner_ring_polar_inertia_kg_m2 = {ring_inertia:<13e} # (assumed) of that ring; it decides the spin-up
",
            of = self.of
        )
    }
}

/// The case file `text` of a bearing with a rotor that drops onto it, in place of its operation.
pub fn touchdown_case(bearing: &BoundaryDimensions, full_complement: bool, text: &str) -> String {
    let geometry = bearing.internal_geometry(full_complement);
    let bore_m = 1e-3 * bearing.bore_mm;
    let inner_ring = AssumedRing::new(bearing, &geometry, bore_m);
    let static_n = 12.0 * geometry.balls as f64 * geometry.ball_diameter_mm.powi(2);
    let rotor_kg = rounded(LOAD_SHARE * static_n / GRAVITY_M_S2);
    let rotor_inertia = rounded(rotor_kg * bore_m * bore_m);
    let speed_rpm = rounded(SPEED_BORE / bearing.bore_mm);
    let support_n_m = 2e7;
    let support_kg = rounded(2.5 * inner_ring.mass_kg);
    // A fifth of 2·√(k·m).
    let damping = rounded(0.4 * (support_n_m * rotor_kg).sqrt());
    let drop_m_s = (2.0 * GRAVITY_M_S2 * 200e-6).sqrt();
    let surface_m_s = speed_rpm * TAU / 60.0 * bore_m / 2.0;
    let head = text.split("[operation]").next().unwrap_or(text);
    let head = head.replacen("[bearing]\n", &inner_ring.keys(), 1);
    format!(
        "\
{head}[contact]
friction_coefficient = 0.1                     # (assumed) balls: dry steel 0.1 to 0.3, MoS2 or WS2
                                               # in vacuum 0.02 to 0.1, lubricated 0.007

# The rotor that drops when the active magnetic bearing (AMB) loses power.
[rotor]
mass_kg = {rotor_kg:<36} # (assumed) share of this bearing: a little below 1 % of C0r of a row
polar_inertia_kg_m2 = {rotor_inertia:<24e} # (assumed) about its axis, m·d²
speed_rpm = {speed_rpm:<34} # (assumed) at the start; surface speed {surface_m_s:.0} m/s
radial_clearance_um = 200.0                             # (assumed) radial touch-down clearance: half the gap of
                                               # the AMB, 100 to 500
clearance_limit_um = 400.0                     # (assumed) gap of the AMB, or the nearest seal: a drop
                                               # that displaces the rotor further fails
friction_coefficient = 0.15                    # (assumed) journal in bore: dry steel 0.1 to 0.3,
                                               # lubricated 0.05 to 0.1; much of it drives whirl
contact_stiffness_n_mp = 1.0e9                      # (assumed) journal in bore, N/m: 1e8 (thin sleeve) to 1e10
                                               # (solid); on a soft support it matters little
contact_damping_s_m = 0.3                      # (assumed) α of Hunt and Crossley: restitution about
                                               # 1 - α·v, {restitution:.2} at the {drop_m_s:.3} m/s of this fall;
                                               # steel on steel 0.1 to 0.5

# The mount of the outer ring; without this section it is fixed.
[support]
mass_kg = {support_kg:<36} # (assumed) outer ring and housing
stiffness_n_m = 2.0e7                          # (assumed) tolerance ring (ribbon) or O-ring: 1e6 to 5e7
damping_n_s_m = {damping:<30} # (assumed) 0.2 of critical damping of the rotor on it;
                                               # damping prevents backward whirl

[solver]
duration_s = 0.5
",
        restitution = 1.0 - 0.3 * drop_m_s,
    )
}
