//! Effect of a discrete raceway under a contact angle, by kinematics alone.
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
//! load presses in by u sees the flanks at tan αc′ = g sin αc/(u + g cos αc). On the edges of a slot 1/κg of
//! [`crate::raceway::SlotSection`] is in the place of g, but in A cos α − g.
//!
//! A ball that sits deeper than on the plain raceway, by s, is so much farther from the axis, and Ω smaller by
//! 1 + s/Rm. The inner ring follows it up to a reach that the load gives it; where s is more, the ball is on
//! its own and keeps the orbital speed with which it got there.
//!
//! A section turned by αg has all of this about the direction αg: α, αi and α′ above are relative to it,
//! but those in γ cos, the distance from the axis of the bearing, count from the radius.

use std::f64::consts::TAU;

use crate::bearing::Bearing;
use crate::case::{Case, Row};
use crate::control::Control;
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
/// Steps up to it.
const ANGLES: usize = 14;
const PANELS: usize = 6;

impl ContactAngleEstimate {
    /// Estimate for a raceway whose balls the load presses in by `pressed_in_m`.
    pub fn new(bearing: &Bearing, raceway: &Raceway, pressed_in_m: f64) -> Self {
        let turned = raceway.section_angle_rad();
        let lag = |angle: f64| kinematic_lag_rad(bearing, raceway, angle, pressed_in_m);
        let lag_rad = lag(turned);
        // On one edge of a slot the lag grows again under a large contact angle: the first angle counts.
        let angle = |k: usize| turned + ANGLE_MAX_RAD * k as f64 / ANGLES as f64;
        let lags: Vec<f64> = (0..=ANGLES).map(|k| lag(angle(k))).collect();
        let keeps = |share: f64| {
            let k = lags.iter().position(|lag| *lag < share * lag_rad)?;
            let begin = angle(k.checked_sub(1)?);
            root::brent(|a| lag(a) - share * lag_rad, begin, angle(k), 1e-9)
        };
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
/// grooves, the mean of both contacts: centrifugal force makes that at the inner raceway larger. `control` is called
/// before every place of the ring that is tried.
///
/// # Errors
/// Those of [`space::solve`], or `control` ended the search.
pub fn seats(
    case: &Case,
    control: &mut dyn FnMut() -> Control,
) -> Result<Vec<[f64; 2]>, EquilibriumError> {
    let solved = space::solve_controlled(&case.conventional(), control)?;
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

/// Share of the lag of rigid raceways without a contact angle that rolling leaves at the [`seats`] of a case, of the
/// worst row and raceway, 0 of a row that carries nothing; the angle counts from that by which the section is
/// turned.
pub fn rolling_lag_fraction(case: &Case, seats: &[[f64; 2]]) -> f64 {
    let of_row = |(row, [angle_rad, pressed_in_m]): (Row, &[f64; 2])| {
        // A row without load.
        if angle_rad.is_nan() {
            return 0.0;
        }
        let fraction = |raceway: &Raceway| {
            let lag = |angle, pressed_in_m| {
                kinematic_lag_rad(&case.bearing, raceway, angle, pressed_in_m)
            };
            lag(row.contact_sign * angle_rad, *pressed_in_m) / lag(raceway.section_angle_rad(), 0.0)
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
    let (whole, reach) = (raceway.half_angle_rad(), reach_m(bearing, pressed_in_m));
    let pressed = Pressed {
        angle_rad,
        pressed_in_m,
        reach_m: reach,
    };
    lag_within_rad(bearing, raceway, pressed, whole)
}

/// β0 in space: [`kinematic_lag_rad`] over the middle ε of the raceway, by which a pair that rolls
/// comes closer where the inner ring follows it however deep it sits. On flanks that do not yield and without a
/// contact angle it is β0 of Zhao 2022, Eq. (11), with the polar angle.
pub fn kinematic_gap_rad(
    bearing: &Bearing,
    raceway: &Raceway,
    angle_rad: f64,
    pressed_in_m: f64,
) -> f64 {
    let middle = 0.5 * bearing.ball_angle_rad();
    let pressed = Pressed {
        angle_rad,
        pressed_in_m,
        reach_m: f64::INFINITY,
    };
    lag_within_rad(bearing, raceway, pressed, middle)
}

/// How far the inner ring follows a ball under a radial load that presses it in by `pressed_in_m` on the plain
/// raceway: the approach of both its contacts there, and by how much that grows when the other balls carry all,
/// (S/(S − 1))^⅔ with S = Σ cos^(5/2) ψ of evenly spaced balls without clearance. Rigid parts follow any.
fn reach_m(bearing: &Bearing, pressed_in_m: f64) -> f64 {
    if pressed_in_m == 0.0 {
        return f64::INFINITY;
    }
    let [inner, outer] = [bearing.inner_contact(), bearing.outer_contact()];
    let ratio = outer.stiffness_n_m1_5 / inner.stiffness_n_m1_5;
    let count = bearing.balls();
    let spacing = TAU / count as f64;
    let shares = (1..count).map(|k| (spacing * k as f64).cos().max(0.0).powf(2.5));
    let others = shares.sum::<f64>();
    pressed_in_m * (1.0 + ratio.powf(2.0 / 3.0)) * (1.0 + 1.0 / others).powf(2.0 / 3.0)
}

/// A ball that the inner ring presses into the raceway.
#[derive(Clone, Copy)]
struct Pressed {
    /// Contact angle.
    angle_rad: f64,
    /// Approach of both contacts.
    pressed_in_m: f64,
    /// Depth to which the inner ring follows.
    reach_m: f64,
}

impl Pressed {
    /// Approach that is left where the raceway is so deep.
    fn approach_m(&self, depth_m: f64) -> f64 {
        self.pressed_in_m * (1.0 - depth_m / self.reach_m)
    }
}

/// ∫ (Ω0/Ω − 1) dψ up to ±`half_width_rad` from the middle of the raceway, or to its ends, with an inner ring that
/// follows a ball as deep as its reach.
fn lag_within_rad(
    bearing: &Bearing,
    raceway: &Raceway,
    pressed: Pressed,
    half_width_rad: f64,
) -> f64 {
    let d = bearing.dimensions();
    let gap = d.outer_groove_curvature_radius_m - d.ball_radius_m;
    let gamma = d.ball_radius_m / bearing.pitch_radius_m();
    let room = d.groove_distance_m();
    let turned = raceway.section_angle_rad();
    let beside = pressed.angle_rad - turned;
    // On the other side of the section all is mirrored but the distance from the axis.
    let from_radius = |angle: f64| turned + angle * 1f64.copysign(beside);
    let (sin, cos) = beside.abs().sin_cos();
    let centre = [room * cos - gap, room * sin];
    let seated = centre[1].atan2(centre[0]);
    let middle = raceway.dimensions().centre_angle_rad;
    let depth = |psi: f64| raceway.depth_at_m(middle + psi)[0];
    let nominal = |psi: f64| {
        let cosine = raceway.effective_radius_m(middle + psi) / d.ball_radius_m;
        cosine.min(1.0).acos()
    };
    // Of the normal of a flank at the line through a place, x and y from the ball along and across the section.
    let towards = |psi: f64, x: f64, y: f64| {
        let (sin, cos) = nominal(psi).sin_cos();
        let slot = raceway.slot().map(|slot| slot.at(psi));
        let curvature = slot.map_or(1.0 / gap, |edge| edge.centre_curvature_per_m[0]);
        (sin + curvature * y).atan2(cos + curvature * x)
    };
    let flank = |psi: f64| towards(psi, pressed.approach_m(depth(psi)), 0.0);
    let along = |angle: f64| 1.0 - gamma * from_radius(angle).cos();
    let outside = 0.5 * along(beside.abs());
    let farther = |psi: f64| 1.0 + depth(psi) * turned.cos() / bearing.pitch_radius_m();
    let on_both = |psi: f64| {
        let (flank, inner) = (flank(psi).cos(), seated.cos());
        outside * farther(psi) * (flank + inner) / (along(seated) * flank) - 1.0
    };
    let on_one =
        |psi: f64| outside * farther(psi) / (0.5 * along(towards(psi, centre[0], centre[1]))) - 1.0;
    let end = half_width_rad.min(raceway.half_angle_rad() * (1.0 - 1e-12));
    // αc and the depth fall from the middle to the ends.
    let until = |excess: &dyn Fn(f64) -> f64| match excess(0.0) > 0.0 {
        true => root::brent(excess, 0.0, end, 0.0).unwrap_or(end),
        false => 0.0,
    };
    let alone = until(&|psi| depth(psi) - pressed.reach_m);
    let leaves = until(&|psi| flank(psi) - seated).max(alone);
    let mut half = match flank(alone) >= seated {
        true => alone * on_both(alone),
        false => alone * on_one(alone),
    };
    for piece in raceway.pieces().iter().map(|piece| piece.range_rad()) {
        let [a, b] = [piece.start, piece.end].map(|at| at.min(end).max(alone));
        let leaves = leaves.clamp(a, b);
        half += quadrature::gauss(on_both, a, leaves, PANELS)
            + quadrature::gauss(on_one, leaves, b, PANELS);
    }
    2.0 * half
}
