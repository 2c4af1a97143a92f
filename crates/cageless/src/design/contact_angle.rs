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

use crate::bearing::Bearing;
use crate::case::{Case, Row};
use crate::equilibrium::{EquilibriumError, space};
use crate::numerics::{quadrature, root};
use crate::raceway::Raceway;

/// Contact angles up to which a raceway keeps its effect, without sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactAngleEstimate {
    /// Lag of a ball per pass at a contact angle of 0, behind one on the plain raceway.
    pub lag_rad: f64,
    /// Plain contact angle at which three quarters of it are left.
    pub three_quarters_rad: Option<f64>,
    /// Plain contact angle at which half of it is left.
    pub half_rad: Option<f64>,
    /// Plain contact angle at which none of it is left.
    pub none_rad: Option<f64>,
}

/// Largest plain contact angle that is looked at, rad.
const ANGLE_MAX_RAD: f64 = 0.7;
const PANELS: usize = 6;

impl ContactAngleEstimate {
    /// Estimate for a raceway whose balls the load presses in by `pressed_in_m`.
    pub fn new(bearing: &Bearing, raceway: &Raceway, pressed_in_m: f64) -> Self {
        let lag = |angle: f64| kinematic_lag_rad(bearing, raceway, angle, pressed_in_m);
        let lag_rad = lag(0.0);
        let keeps =
            |share: f64| root::brent(|a| lag(a) - share * lag_rad, 0.0, ANGLE_MAX_RAD, 1e-9);
        Self {
            lag_rad,
            three_quarters_rad: keeps(0.75),
            half_rad: keeps(0.5),
            none_rad: keeps(0.0),
        }
    }
}

/// Contact angle and deflection at the outer raceway of the most loaded ball of each row on a plain outer
/// ring, in static equilibrium in space.
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
        let angle_rad = solved.inner_contact_angle_rad[most];
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
            let beside = (row.contact_sign * angle_rad - raceway.section_angle_rad()).abs();
            let lag = |angle| kinematic_lag_rad(&case.bearing, raceway, angle, *pressed_in_m);
            lag(beside) / lag(0.0)
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
    let d = bearing.dimensions();
    let gap = d.outer_groove_curvature_radius_m - d.ball_radius_m;
    let gamma = d.ball_radius_m / bearing.pitch_radius_m();
    let room = d.groove_distance_m();
    let centre = [room * angle_rad.cos() - gap, room * angle_rad.sin()];
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
    let outside = 0.5 * (1.0 - gamma * angle_rad.cos());
    let on_both = |psi: f64| {
        let (flank, inner) = (flank(psi).cos(), seated.cos());
        outside * (flank + inner) / ((1.0 - gamma * inner) * flank) - 1.0
    };
    let on_one = |psi: f64| {
        let (sin, cos) = nominal(psi).sin_cos();
        let angle = (centre[1] + gap * sin).atan2(centre[0] + gap * cos);
        outside / (0.5 * (1.0 - gamma * angle.cos())) - 1.0
    };
    let end = raceway.half_angle_rad() * (1.0 - 1e-12);
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
