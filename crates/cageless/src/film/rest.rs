//! Films of a bearing in static equilibrium, and what they take from its balls.

use super::Film;
use super::contact::LubricatedContact;
use super::free_arc::FreeBall;
use super::hysteresis::{Hysteresis, moment_n_m};
use super::range::RangeExceeded;
use super::rolling_ball::{RollingBall, RollingFlank};
use super::rolling_force::Rolling;
use super::spacing::{MAY_QUEUE, QUEUE, free_share, opening_gap_rad};
use super::thickness::{FilmThickness, asperity_share};
use super::traction_at_rest::{BallContacts, mixed_friction_coefficient};
use super::unreached_arc::unreached_arc_rad;
use crate::case::Case;
use crate::equilibrium::space::{SpatialEquilibrium, slot};

/// Share of the load on asperities above which a contact is not that of a lubricated bearing: Λ below some 1.1.
const ASPERITIES: f64 = 0.1;

/// Film of one contact of a ball.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct ContactFilm {
    /// Thickness; zero without load.
    pub(crate) thickness: FilmThickness,
    /// F_R of the contact, with heat and supply, N.
    pub force_n: f64,
    /// u, m/s.
    pub speed_m_s: f64,
    /// Parameter furthest outside the range of the fit.
    pub(crate) exceeded: Option<RangeExceeded>,
}

impl ContactFilm {
    fn new(film: &Film, contact: &LubricatedContact, rolling: Rolling) -> Self {
        Self {
            thickness: contact.film_thickness(&film.oil, rolling),
            force_n: film.rolling_force_n(contact, rolling),
            speed_m_s: rolling.speed_m_s,
            exceeded: (film.has_oil())
                .then(|| contact.range_exceeded(&film.oil, rolling))
                .flatten(),
        }
    }

    /// Whether it carries load.
    pub(crate) fn is_loaded(&self) -> bool {
        self.thickness.central_m > 0.0
    }

    /// Λ, h_c over the roughness.
    fn parameter(&self, roughness_m: f64) -> f64 {
        self.thickness.central_m / roughness_m
    }

    /// Power of the rolling resistance, W.
    fn power_w(&self) -> f64 {
        2.0 * self.force_n * self.speed_m_s
    }
}

/// Films of all contacts.
struct ContactFilms {
    /// At the inner raceway, of every ball.
    inner: Vec<ContactFilm>,
    /// At the outer raceway, of every ball: at the plain one the first is all.
    outer: Vec<[ContactFilm; 2]>,
}

impl ContactFilms {
    fn new(film: &Film, balls: &[RollingBall], contacts: &[BallContacts]) -> Self {
        let of_balls = || balls.iter().zip(contacts);
        let inner = of_balls().map(|(ball, of)| ContactFilm::new(film, &of.inner, ball.inner));
        let outer = of_balls().map(|(ball, of)| {
            [0, 1].map(|k| ContactFilm::new(film, &of.outer[k], ball.outer[k].rolling))
        });
        Self {
            inner: inner.collect(),
            outer: outer.collect(),
        }
    }

    fn all(&self) -> impl Iterator<Item = &ContactFilm> {
        self.inner.iter().chain(self.outer.iter().flatten())
    }

    /// Films of the contacts under load.
    fn loaded(&self) -> impl Iterator<Item = &ContactFilm> {
        self.all().filter(|film| film.is_loaded())
    }

    /// Least h_min, and mean of h_c under load.
    fn thickness_min_and_mean_m(&self) -> [f64; 2] {
        let least = self.loaded().map(|film| film.thickness.least_m);
        let central_m: f64 = self.loaded().map(|film| film.thickness.central_m).sum();
        [
            least.fold(f64::INFINITY, f64::min),
            central_m / self.loaded().count() as f64,
        ]
    }

    /// Λ at the inner raceway.
    fn inner_parameters(&self, roughness_m: f64) -> Vec<f64> {
        let films = self.inner.iter();
        films.map(|film| film.parameter(roughness_m)).collect()
    }

    /// Λ at the outer raceway, of two flanks the lesser; 0 without load.
    fn outer_parameters(&self, roughness_m: f64) -> Vec<f64> {
        let of_ball = |flanks: &[ContactFilm; 2]| {
            let loaded = flanks.iter().filter(|film| film.is_loaded());
            let parameters = loaded.map(|film| film.parameter(roughness_m));
            parameters.reduce(f64::min).unwrap_or(0.0)
        };
        self.outer.iter().map(of_ball).collect()
    }

    /// Largest share of the load of a contact that asperities carry.
    fn asperity_share_max(&self, roughness_m: f64) -> f64 {
        let parameters = self.loaded().map(|film| film.parameter(roughness_m));
        parameters.map(asperity_share).fold(0.0, f64::max)
    }

    /// Parameter furthest outside the range of the fit.
    fn exceeded(&self) -> Option<RangeExceeded> {
        let all = self.loaded().filter_map(|film| film.exceeded);
        all.max_by(|a, b| a.distance().total_cmp(&b.distance()))
    }
}

/// Films of a case in static equilibrium, balls rolling.
#[derive(Debug, Clone, PartialEq)]
pub struct FilmAtRest {
    /// At the inner raceway, of every ball.
    pub(crate) inner: Vec<ContactFilm>,
    /// At the outer raceway, of every ball: at the plain one the first is all.
    pub(crate) outer: Vec<[ContactFilm; 2]>,
    /// Power of the rolling resistance, that of hysteresis included where it counts, W.
    pub power_w: f64,
    /// That over the speed of the inner ring, N·m.
    pub torque_n_m: f64,
    /// Part of the hysteresis of the steel in that torque, N·m; `None` where it does not count.
    pub hysteresis_torque_n_m: Option<f64>,
    /// Friction over load of the contacts where the film is their friction, sliding at 1 % of the speed of rolling.
    pub mixed_friction_coefficient: Option<f64>,
    /// Balls under load at the inner raceway whose friction there is too weak to keep them rolling against the film.
    pub overcome_balls: usize,
    /// Angle over which the outer raceway alone carries a ball, rad, of the row where it is largest.
    pub free_arc_rad: f64,
    /// Angle by which a ball falls behind there by the film, rad; infinite where it stops.
    pub lag_rad: f64,
    /// d, share of its speed that it loses there; 1 of a ball that stops.
    pub speed_deficit: f64,
    /// g_f, gap that opens behind a ball that enters the load zone, rad; NaN of a ball that stops, and without a load
    /// zone.
    pub opening_gap_rad: f64,
    /// s, share of the pitch circle that balls leave free.
    pub free_share: f64,
    /// gρ/v², weight of a rolling ball over its centrifugal force, which lag, deficit and gap leave out.
    pub weight_share: f64,
    /// Least h_min of all contacts, m.
    pub thickness_min_m: f64,
    /// Mean of h_c over the contacts under load, m.
    pub thickness_mean_m: f64,
    /// Λ at the inner raceway, of every ball.
    pub inner_film_parameters: Vec<f64>,
    /// Λ at the outer raceway, of every ball; of two flanks the lesser, that of the more loaded one.
    pub outer_film_parameters: Vec<f64>,
    /// Least h_min over the roughness.
    pub film_parameter_min: f64,
    /// Mean Λ of the contacts under load.
    pub film_parameter_mean: f64,
    /// Largest share of the load of a contact that asperities carry.
    pub asperity_share_max: f64,
    /// Whether a ball has inner contact.
    pub has_load_zone: bool,
    /// Speed deficits below which balls never queue, and from which they do as a rule.
    pub queue_deficits: [f64; 2],
    /// Parameter of any contact furthest outside the range of the fit.
    pub(crate) exceeded: Option<RangeExceeded>,
}

/// Weight of a ball over its centrifugal force above which it moves the ball as much as a film does.
pub const WEIGHT_MAX: f64 = 0.2;

impl FilmAtRest {
    /// Films of a case in its equilibrium; `None` without a film, and at standstill.
    pub fn new(case: &Case, settled: &SpatialEquilibrium) -> Option<Self> {
        let film = case.film.as_ref()?;
        let inner_speed_rad_s = case.operation.inner_speed_rad_s;
        if inner_speed_rad_s == 0.0 {
            return None;
        }
        let bearing = &case.bearing;
        let balls = (0..settled.row.len()).map(|ball| RollingBall::new(case, settled, ball));
        let balls: Vec<RollingBall> = balls.collect();
        let places = balls.iter().zip(&settled.rest.ball_angle_rad);
        let contacts: Vec<BallContacts> = places
            .map(|(ball, angle_rad)| contacts(case, ball, *angle_rad))
            .collect();
        let films = ContactFilms::new(film, &balls, &contacts);
        let film_w: f64 = films.all().map(ContactFilm::power_w).sum();
        let hysteresis_w = film.hysteresis.then(|| hysteresis_power_w(case, &balls));
        let power_w = film_w + hysteresis_w.unwrap_or(0.0);
        let mixed_friction_coefficient = mixed_friction_coefficient(case, &balls, &contacts);
        let friction = mixed_friction_coefficient.unwrap_or(case.contact.friction.coefficient);
        let overcome_balls = overcome_balls(&balls, &films, friction);
        let free_arc_rad = unreached_arc_rad(case, settled);
        let groove_m = bearing.dimensions().inner_groove_bottom_radius_m;
        let ball = FreeBall::new(bearing, film);
        let speed_m_s = 0.5 * inner_speed_rad_s * groove_m;
        let arc = ball.over(free_arc_rad, speed_m_s);
        let centrifugal_m_s2 = speed_m_s * speed_m_s / bearing.pitch_radius_m();
        let has_load_zone = films.inner.iter().any(ContactFilm::is_loaded);
        let opening_gap_rad = match arc.speed_deficit < 1.0 && has_load_zone {
            true => opening_gap_rad(bearing, arc.speed_deficit),
            false => f64::NAN,
        };
        let (free_share, roughness_m) = (free_share(bearing), film.roughness_m);
        let [thickness_min_m, thickness_mean_m] = films.thickness_min_and_mean_m();
        Some(Self {
            thickness_min_m,
            thickness_mean_m,
            inner_film_parameters: films.inner_parameters(roughness_m),
            outer_film_parameters: films.outer_parameters(roughness_m),
            film_parameter_min: thickness_min_m / roughness_m,
            film_parameter_mean: thickness_mean_m / roughness_m,
            asperity_share_max: films.asperity_share_max(roughness_m),
            exceeded: films.exceeded(),
            has_load_zone,
            queue_deficits: [MAY_QUEUE, QUEUE].map(|factor| factor * free_share),
            inner: films.inner,
            outer: films.outer,
            power_w,
            torque_n_m: power_w / inner_speed_rad_s,
            hysteresis_torque_n_m: hysteresis_w.map(|power_w| power_w / inner_speed_rad_s),
            mixed_friction_coefficient,
            overcome_balls,
            free_arc_rad,
            opening_gap_rad,
            lag_rad: arc.lag_rad,
            speed_deficit: arc.speed_deficit,
            free_share,
            weight_share: case.operation.gravity_m_s2 / centrifugal_m_s2,
        })
    }

    /// Parameter of the contact furthest outside the range of the fit with its factor, such as `U × 2.600`; `None`
    /// within.
    pub fn range_exceeded(&self) -> Option<String> {
        self.exceeded.map(|exceeded| exceeded.to_string())
    }

    /// Warning if a contact is outside the range of the fit of the rolling force.
    fn range_warning(&self) -> Option<String> {
        let exceeded = self.exceeded?;
        let RangeExceeded { parameter, factor } = exceeded;
        let end = if factor > 1.0 { "upper" } else { "lower" };
        Some(format!(
            "film: the rolling force is extrapolated: {} of a contact is {} times the {end} end of the range of its fit",
            parameter_text(parameter),
            exceeded.factor_text()
        ))
    }

    /// Warnings of a computation of the motion: those of [`Self::contact_warnings`], and balls that queue.
    pub fn warnings(&self) -> Vec<String> {
        let [lost, free] = [self.speed_deficit, self.free_share].map(|share| 100.0 * share);
        let [never, as_a_rule] = self.queue_deficits;
        let lags = self.speed_deficit > never && self.weight_share < WEIGHT_MAX;
        let queue = lags.then(|| {
            let will = match self.speed_deficit > as_a_rule {
                true => "will",
                false => "may",
            };
            format!(
                "film: balls {will} queue, as the oil takes {lost:.1} % of the speed of a free ball and they leave \
                 {free:.1} % of the pitch circle free; slowed balls then hit each other all the time"
            )
        });
        self.contact_warnings().into_iter().chain(queue).collect()
    }

    /// Warnings about contacts: one outside the range of the fit of the rolling force, and asperities that carry load.
    pub fn contact_warnings(&self) -> Vec<String> {
        let share = self.asperity_share_max;
        let asperities = (share > ASPERITIES).then(|| {
            let friction = match self.mixed_friction_coefficient {
                Some(_) => "",
                None => {
                    "; contact.friction_coefficient is the friction of all contacts: film.traction = \"film\" has that of \
                     asperities and film"
                }
            };
            format!(
                "film: asperities carry {:.0} % of the load of a contact, where Λ is least: surfaces wear, and lives of a \
                 lubricated bearing do not hold{friction}",
                100.0 * share
            )
        });
        self.range_warning().into_iter().chain(asperities).collect()
    }
}

/// A parameter of the fit by what it is made of.
fn parameter_text(parameter: &str) -> String {
    let made_of = match parameter {
        "U" => "viscosity × speed",
        "κW" => "load",
        "κ" => "contact ellipse",
        _ => "film over ball radius",
    };
    format!("{parameter} ({made_of})")
}

/// Contacts of a ball at an angle; at the edges of a slot those with the edges.
fn contacts(case: &Case, ball: &RollingBall, angle_rad: f64) -> BallContacts {
    let bearing = &case.bearing;
    let of_flank = |flank: RollingFlank| match slot(case, angle_rad) {
        Some((slot, local_rad)) => {
            LubricatedContact::of_ring(bearing, slot.curvatures_at_per_m(local_rad))
        }
        None => LubricatedContact::outer(bearing, flank.cosine),
    };
    BallContacts {
        inner: LubricatedContact::inner_curved(bearing, ball.inner_curvature),
        outer: ball.outer.map(of_flank),
    }
}

/// Balls under load at the inner raceway whose friction there, of this coefficient, is too weak against their films.
fn overcome_balls(balls: &[RollingBall], films: &ContactFilms, friction: f64) -> usize {
    let is_overcome = |ball: &usize| {
        let held_n = friction * balls[*ball].inner.load_n;
        held_n > 0.0 && drag_n(&balls[*ball], &films.inner[*ball], &films.outer[*ball]) > held_n
    };
    (0..balls.len()).filter(is_overcome).count()
}

/// Friction that a ball needs at the inner raceway to keep rolling against its films, N. With the parts g of the orbit
/// in 2u and F_R at both raceways its orbit and its rotation are steady under ½ (F_o (1 + g_o) + F_i (1 − g_i)).
fn drag_n(ball: &RollingBall, inner: &ContactFilm, outer: &[ContactFilm; 2]) -> f64 {
    let flanks = ball.outer.iter().zip(outer);
    let outer_n: f64 = flanks
        .map(|(flank, film)| film.force_n * (1.0 + flank.gear))
        .sum();
    0.5 * (outer_n + inner.force_n * (1.0 - ball.inner_gear))
}

/// Power of the hysteresis of the steel, W.
fn hysteresis_power_w(case: &Case, balls: &[RollingBall]) -> f64 {
    let factors = Hysteresis::new(&case.bearing);
    let of_ball = |ball: &RollingBall| {
        let of_flank = |flank: &RollingFlank| {
            moment_n_m(factors.outer, flank.rolling.load_n) * flank.turn_rad_s
        };
        let outer_w: f64 = ball.outer.iter().map(of_flank).sum();
        outer_w + moment_n_m(factors.inner, ball.inner.load_n) * ball.inner_turn_rad_s
    };
    balls.iter().map(of_ball).sum()
}
