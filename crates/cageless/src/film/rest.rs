//! Films of a bearing in static equilibrium, and what they take from its balls.

use std::f64::consts::{PI, TAU};

use super::Film;
use super::contact::LubricatedContact;
use super::free_arc::{FreeArc, FreeBall};
use super::hysteresis::{Hysteresis, moment_n_m};
use super::range::RangeExceeded;
use super::rolling_force::Rolling;
use super::spacing::{MAY_QUEUE, QUEUE, free_share, opening_gap_rad};
use super::thickness::{FilmThickness, asperity_share};
use crate::case::Case;
use crate::equilibrium::Equilibrium;
use crate::raceway_contact::RacewayPoint;

/// Film of one contact of a ball.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactFilm {
    /// Thickness; zero without load.
    pub(crate) thickness: FilmThickness,
    /// F_R of the contact, with heat and supply, N.
    pub force_n: f64,
    /// u, m/s.
    pub speed_m_s: f64,
    /// Contacts of the ball with the raceway: two on a discrete one, else one.
    pub contacts: f64,
    /// Parameter furthest outside the range of the fit.
    pub(crate) exceeded: Option<RangeExceeded>,
}

impl ContactFilm {
    fn new(film: &Film, contact: &LubricatedContact, rolling: Rolling) -> Self {
        Self {
            thickness: contact.film_thickness(&film.oil, rolling),
            force_n: film.rolling_force_n(contact, rolling),
            speed_m_s: rolling.speed_m_s,
            contacts: 1.0,
            exceeded: contact.range_exceeded(&film.oil, rolling),
        }
    }

    /// Whether it carries load.
    pub(crate) fn is_loaded(&self) -> bool {
        self.thickness.central_m > 0.0
    }

    /// Power of the rolling resistance, W.
    fn power_w(&self) -> f64 {
        2.0 * self.contacts * self.force_n * self.speed_m_s
    }
}

/// Films of a case in static equilibrium, balls rolling.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmAtRest {
    /// At the inner raceway, of every ball.
    pub inner: Vec<ContactFilm>,
    /// At the outer raceway, of every ball; on a discrete raceway either of two.
    pub outer: Vec<ContactFilm>,
    /// Power of the rolling resistance, W.
    pub power_w: f64,
    /// That over the speed of the inner ring, N·m.
    pub torque_n_m: f64,
    /// Torque of the hysteresis of the steel, N·m; `None` where it does not count.
    pub hysteresis_torque_n_m: Option<f64>,
    /// Angle over which the outer raceway alone carries a ball, rad.
    pub free_arc_rad: f64,
    /// What the film takes from a ball there.
    pub arc: FreeArc,
    /// g_f, gap that opens behind a ball that enters the load zone, rad.
    pub opening_gap_rad: f64,
    /// s, share of the pitch circle that balls leave free.
    pub free_share: f64,
    roughness_m: f64,
}

impl FilmAtRest {
    /// Films of a case in its equilibrium in the plane; `None` without a film, and at standstill.
    pub fn new(case: &Case, rest: &Equilibrium) -> Option<Self> {
        let film = case.film.as_ref()?;
        let inner_speed_rad_s = case.operation.inner_speed_rad_s;
        if inner_speed_rad_s == 0.0 {
            return None;
        }
        let bearing = &case.bearing;
        let radii = bearing.dimensions();
        let (ri, rw) = (radii.inner_groove_bottom_radius_m, bearing.ball_radius_m());
        let surface_m_s = inner_speed_rad_s * ri;
        let inner_contact = LubricatedContact::inner(bearing);
        let (mut inner, mut outer) = (vec![], vec![]);
        for ball in 0..rest.ball_angle_rad.len() {
            let (r, distance_m) = (rest.effective_radius_m[ball], rest.ball_distance_m[ball]);
            // Rolling on both raceways: vt = ω r and vt + ω Rw = ωi Ri.
            let speed_m_s = surface_m_s * r / (r + rw);
            let rotation_m_s = surface_m_s * rw / (r + rw);
            let cosine = (r / rw).min(1.0);
            let point = RacewayPoint::of_outer(cosine, rest.outer_force_n[ball]);
            let at_outer = Rolling {
                load_n: point.force_n,
                speed_m_s: speed_m_s * (distance_m + r) / distance_m,
            };
            let at_inner = Rolling {
                load_n: rest.inner_force_n[ball],
                speed_m_s: 0.5 * (surface_m_s + rotation_m_s - speed_m_s * (ri - rw) / (ri + rw)),
            };
            inner.push(ContactFilm::new(film, &inner_contact, at_inner));
            outer.push(ContactFilm {
                contacts: if cosine < 1.0 { 2.0 } else { 1.0 },
                ..ContactFilm::new(film, &LubricatedContact::outer(bearing, cosine), at_outer)
            });
        }
        let power_w = inner.iter().chain(&outer).map(ContactFilm::power_w).sum();
        let free_arc_rad = free_arc_rad(case, rest);
        let ball = FreeBall::new(bearing, film);
        let arc = ball.over(free_arc_rad, 0.5 * surface_m_s);
        Some(Self {
            inner,
            outer,
            power_w,
            torque_n_m: power_w / inner_speed_rad_s,
            hysteresis_torque_n_m: (film.hysteresis)
                .then(|| hysteresis_power_w(case, rest) / inner_speed_rad_s),
            free_arc_rad,
            opening_gap_rad: opening_gap_rad(bearing, arc.speed_deficit),
            arc,
            free_share: free_share(bearing),
            roughness_m: film.roughness_m,
        })
    }

    /// The contacts that carry load.
    fn loaded(&self) -> impl Iterator<Item = &ContactFilm> {
        let all = self.inner.iter().chain(&self.outer);
        all.filter(|film| film.is_loaded())
    }

    /// Least h_min of all contacts, m.
    pub fn thickness_min_m(&self) -> f64 {
        self.loaded()
            .map(|film| film.thickness.least_m)
            .fold(f64::INFINITY, f64::min)
    }

    /// Mean of h_c over the contacts under load, m.
    pub fn thickness_mean_m(&self) -> f64 {
        let sum: f64 = self.loaded().map(|film| film.thickness.central_m).sum();
        sum / self.loaded().count() as f64
    }

    /// Λ, h_c over the roughness, of a contact.
    pub fn film_parameter(&self, film: &ContactFilm) -> f64 {
        film.thickness.central_m / self.roughness_m
    }

    /// Least h_min over the roughness.
    pub fn film_parameter_min(&self) -> f64 {
        self.thickness_min_m() / self.roughness_m
    }

    /// Mean Λ of the contacts under load.
    pub fn film_parameter_mean(&self) -> f64 {
        self.thickness_mean_m() / self.roughness_m
    }

    /// Largest share of the load of a contact that asperities carry.
    pub fn asperity_share_max(&self) -> f64 {
        let shares = self
            .loaded()
            .map(|film| asperity_share(self.film_parameter(film)));
        shares.fold(0.0, f64::max)
    }

    /// Parameter of any contact furthest outside the range of the fit.
    pub fn exceeded(&self) -> Option<RangeExceeded> {
        let all = self.loaded().filter_map(|film| film.exceeded);
        all.max_by(|a, b| a.distance().total_cmp(&b.distance()))
    }

    /// Warning if a contact is outside the range of the fit of the rolling force.
    pub fn range_warning(&self) -> Option<String> {
        let RangeExceeded { parameter, factor } = self.exceeded()?;
        let end = if factor > 1.0 { "upper" } else { "lower" };
        Some(format!(
            "film: {parameter} of a contact is {factor:.3} times the {end} end of the range that the rolling force was \
             fitted in; nothing is cut off"
        ))
    }

    /// Whether slowed balls may queue.
    pub fn may_queue(&self) -> bool {
        self.arc.speed_deficit > MAY_QUEUE * self.free_share
    }

    /// Speed deficit from which balls queue as a rule.
    pub fn queue_deficit(&self) -> f64 {
        QUEUE * self.free_share
    }
}

/// Power of the hysteresis of the steel, W, balls rolling at ω = ωi Ri/(r + Rw).
fn hysteresis_power_w(case: &Case, rest: &Equilibrium) -> f64 {
    let (bearing, inner_rad_s) = (&case.bearing, case.operation.inner_speed_rad_s);
    let (factors, rw) = (Hysteresis::new(bearing), bearing.ball_radius_m());
    let surface_m_s = inner_rad_s * bearing.dimensions().inner_groove_bottom_radius_m;
    let of_ball = |ball: usize| {
        let r = rest.effective_radius_m[ball];
        let (cosine, spin_rad_s) = ((r / rw).min(1.0), surface_m_s / (r + rw));
        let contacts = if cosine < 1.0 { 2.0 } else { 1.0 };
        let point = RacewayPoint::of_outer(cosine, rest.outer_force_n[ball]);
        let outer_n_m = contacts * cosine * moment_n_m(factors.outer, point.force_n);
        let inner_n_m = moment_n_m(factors.inner, rest.inner_force_n[ball]);
        outer_n_m * spin_rad_s + inner_n_m * (spin_rad_s + inner_rad_s)
    };
    (0..rest.ball_angle_rad.len()).map(of_ball).sum()
}

/// Angle over which the inner ring, displaced by e, does not reach balls that lie on the plain outer raceway by their
/// centrifugal force: those of cos ψ below (ρ² + e² − (Ri + Rw)²)/(2ρe) from the direction of e.
fn free_arc_rad(case: &Case, rest: &Equilibrium) -> f64 {
    let bearing = &case.bearing;
    let pressed_m = (case.centrifugal_force_n() / rest.outer_stiffness_n_m1_5).powf(2.0 / 3.0);
    let distance_m = bearing.outer_orbit_radius_m() + pressed_m;
    let shift_m = rest.ring_x_m.hypot(rest.ring_y_m);
    let reach_m = bearing.dimensions().inner_groove_bottom_radius_m + bearing.ball_radius_m();
    let square = distance_m.powi(2) + shift_m.powi(2) - reach_m.powi(2);
    let cosine = square / (2.0 * distance_m * shift_m);
    match cosine {
        _ if cosine >= 1.0 || cosine.is_nan() => TAU,
        _ if cosine <= -1.0 => 0.0,
        _ => 2.0 * (PI - cosine.acos()),
    }
}
