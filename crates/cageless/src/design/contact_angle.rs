//! What a contact angle leaves of the effect of a discrete raceway, by kinematics alone.
//!
//! A ring displaced along the axis, so that balls on the plain raceway have the contact angle α,
//! puts the centre of the inner groove at (A cos α − g, A sin α) from where the ball rests, with
//! g = Re − Rw and A = Re + ri − 2Rw. A ball that sits on both flanks has the inner contact
//! angle αi, one on a single flank has α′ at both contacts,
//!
//!   tan αi = A sin α/(A cos α − g),   tan α′ = (A sin α + g sin αc)/(A cos α − g + g cos αc),
//!
//! and it sits on both where αi < αc(ψ). Rolling then gives, with γ = Rw/Rm,
//!
//!   Ω = ωi (1 − γ cos αi) cos αc/(cos αc + cos αi)   or   Ω = ½ ωi (1 − γ cos α′),
//!
//! against Ω0 = ½ ωi (1 − γ cos α) outside: slower on both flanks, faster on one. A ball that the
//! load presses in by u sees the flanks at tan αc′ = g sin αc/(u + g cos αc).
//!
//! A section turned by αg has all of this about the direction αg: α, αi and α′ above are relative to it,
//! but those in γ cos, the distance from the axis of the bearing, count from the radius.

use crate::bearing::Bearing;
use crate::case::{Case, Row};
use crate::equilibrium::{EquilibriumError, space};
use crate::numerics::{quadrature, root};
use crate::raceway::Raceway;

/// Contact angles up to which a raceway keeps its effect, without sliding: those above the angle by which
/// its section is turned.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactAngleEstimate {
    /// Lag of a ball per pass, behind one on the plain raceway, at the contact angle of its section.
    pub lag_rad: f64,
    /// Plain contact angle at which three quarters of it are left.
    pub three_quarters_rad: Option<f64>,
    /// Plain contact angle at which half of it is left.
    pub half_rad: Option<f64>,
    /// Plain contact angle at which none of it is left.
    pub none_rad: Option<f64>,
}

/// Largest plain contact angle above that of the section that is looked at, rad.
const ANGLE_MAX_RAD: f64 = 0.7;
const PANELS: usize = 6;

impl ContactAngleEstimate {
    /// Estimate for a raceway whose balls the load presses in by `pressed_in_m`.
    pub fn new(bearing: &Bearing, raceway: &Raceway, pressed_in_m: f64) -> Self {
        let turned = raceway.section_angle_rad();
        let lag = |angle: f64| kinematic_lag_rad(bearing, raceway, angle, pressed_in_m);
        let lag_rad = lag(turned);
        let most = turned + ANGLE_MAX_RAD;
        let keeps = |share: f64| root::brent(|a| lag(a) - share * lag_rad, turned, most, 1e-9);
        Self {
            lag_rad,
            three_quarters_rad: keeps(0.75),
            half_rad: keeps(0.5),
            none_rad: keeps(0.0),
        }
    }
}

/// Contact angle and deflection at the outer raceway of the most loaded ball of each row on a plain outer
/// ring, in static equilibrium in space. The contact angle is that of the line through the centres of both
/// grooves, the mean of both contacts: centrifugal force makes that at the inner raceway larger.
///
/// # Errors
/// Those of [`space::solve`].
pub fn seats(case: &Case) -> Result<Vec<[f64; 2]>, EquilibriumError> {
    let solved = space::solve(&case.conventional())?;
    let stiffness = solved.rest.outer_stiffness_n_m1_5;
    let forces = || solved.rest.outer_force_n.iter().copied().enumerate();
    let seat = |row: usize| {
        let of_row = forces().filter(|(k, _)| solved.row[*k] == row);
        let (most, force) = of_row.fold((0, 0.0), |most, at| if at.1 > most.1 { at } else { most });
        let angle_rad =
            0.5 * (solved.inner_contact_angle_rad[most] + solved.outer_contact_angle_rad[most]);
        [angle_rad, (force / stiffness).powf(2.0 / 3.0)]
    };
    Ok((0..case.all_rows().len()).map(seat).collect())
}

/// Share of the lag without a contact angle that rolling leaves at the [`seats`] of a case, of the worst
/// row and raceway, 0 of a row that carries nothing; the angle counts from that by which the section is
/// turned.
pub fn rolling_lag_fraction(case: &Case, seats: &[[f64; 2]]) -> f64 {
    let of_row = |(row, [angle_rad, pressed_in_m]): (Row, &[f64; 2])| {
        // A row without load.
        if angle_rad.is_nan() {
            return 0.0;
        }
        let fraction = |raceway: &Raceway| {
            let lag = |angle| kinematic_lag_rad(&case.bearing, raceway, angle, *pressed_in_m);
            lag(row.contact_sign * angle_rad) / lag(raceway.section_angle_rad())
        };
        case.raceways.iter().map(fraction).fold(f64::NAN, f64::min)
    };
    let rows = case.all_rows().into_iter().zip(seats);
    rows.map(of_row).fold(f64::NAN, f64::min)
}

/// Λ = ∫ (Ω0/Ω − 1) dψ through the raceway at the plain contact angle `angle_rad`: the angle by which
/// a ball lags, per pass, behind one on the plain raceway.
pub fn kinematic_lag_rad(
    bearing: &Bearing,
    raceway: &Raceway,
    angle_rad: f64,
    pressed_in_m: f64,
) -> f64 {
    let whole = raceway.half_angle_rad();
    lag_within_rad(bearing, raceway, [angle_rad, pressed_in_m], whole)
}

/// β0 in space: [`kinematic_lag_rad`] over the middle ε of the raceway, by which a pair that rolls
/// comes closer. On flanks that do not yield and without a contact angle it is β0 of Zhao 2022, Eq. (11), with
/// the polar angle.
pub fn kinematic_gap_rad(
    bearing: &Bearing,
    raceway: &Raceway,
    angle_rad: f64,
    pressed_in_m: f64,
) -> f64 {
    let middle = 0.5 * bearing.ball_angle_rad();
    lag_within_rad(bearing, raceway, [angle_rad, pressed_in_m], middle)
}

/// ∫ (Ω0/Ω − 1) dψ up to ±`half_width_rad` from the middle of the raceway, or to its ends.
fn lag_within_rad(
    bearing: &Bearing,
    raceway: &Raceway,
    [angle_rad, pressed_in_m]: [f64; 2],
    half_width_rad: f64,
) -> f64 {
    let d = bearing.dimensions();
    let gap = d.outer_groove_curvature_radius_m - d.ball_radius_m;
    let gamma = d.ball_radius_m / bearing.pitch_radius_m();
    let room = d.groove_distance_m();
    let turned = raceway.section_angle_rad();
    let beside = angle_rad - turned;
    // On the other side of the section all is mirrored but the distance from the axis.
    let from_radius = |angle: f64| turned + angle * 1f64.copysign(beside);
    let (sin, cos) = beside.abs().sin_cos();
    let centre = [room * cos - gap, room * sin];
    let seated = centre[1].atan2(centre[0]);
    let middle = raceway.dimensions().centre_angle_rad;
    let nominal = |psi: f64| {
        let cosine = raceway.effective_radius_m(middle + psi) / d.ball_radius_m;
        cosine.min(1.0).acos()
    };
    let flank = |psi: f64| {
        let (sin, cos) = nominal(psi).sin_cos();
        (gap * sin).atan2(pressed_in_m + gap * cos)
    };
    let along = |angle: f64| 1.0 - gamma * from_radius(angle).cos();
    let outside = 0.5 * along(beside.abs());
    let on_both = |psi: f64| {
        let (flank, inner) = (flank(psi).cos(), seated.cos());
        outside * (flank + inner) / (along(seated) * flank) - 1.0
    };
    let on_one = |psi: f64| {
        let (sin, cos) = nominal(psi).sin_cos();
        let angle = (centre[1] + gap * sin).atan2(centre[0] + gap * cos);
        outside / (0.5 * along(angle)) - 1.0
    };
    let end = half_width_rad.min(raceway.half_angle_rad() * (1.0 - 1e-12));
    // αc falls from the middle to the ends.
    let leaves = match flank(0.0) > seated {
        true => root::brent(|psi| flank(psi) - seated, 0.0, end, 0.0).unwrap_or(end),
        false => 0.0,
    };
    let mut half = 0.0;
    for [a, b] in raceway.pieces().iter().map(|piece| piece.range_rad()) {
        let (a, leaves, b) = (a.min(end), leaves.clamp(a.min(end), b.min(end)), b.min(end));
        half += quadrature::gauss(on_both, a, leaves, PANELS)
            + quadrature::gauss(on_one, leaves, b, PANELS);
    }
    2.0 * half
}
