//! Every constant of the equations of motion, derived once from a case.

use std::sync::Arc;

use super::layout::Layout;
use super::space::SpaceModel;
use crate::ball::{Ball, PolarMotion};
use crate::bearing::Bearing;
use crate::case::Case;
use crate::contact::FrictionModel;
use crate::contact::creep::Creep;
use crate::contact::friction::{FrictionFault, STICK_FRACTION};
use crate::contact::{
    Friction, InnerRaceway, OuterGeometry, OuterRaceway, RacewayConstants, outer_deflection,
    restitution_damping,
};
use crate::error::InputError;
use crate::film::RollingModel;
use crate::flank_model::FlankModel;
use crate::formulation::Formulation;
use crate::numerics::chebyshev::Polynomial;
use crate::outer_contact_geometry::{flank_section, outer_contact_geometry};
use crate::raceway::{ContactPath, Piece, Raceway};
use crate::step_limits::{self, StepLimits};
use crate::time_table::TimeTable;
use crate::unbalance::UnbalanceForce;
use crate::world::body::inner_ring::InnerRing;
use crate::world::body::outer_ring::OuterRing;
use crate::world::body::rigid_rotor::RigidRotor;
use crate::world::under_rotor::UnderRotor;

/// A stretch of a discrete raceway as the equations use it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct RacewayModel {
    pub constants: RacewayConstants,
    /// Coefficients of r over u.
    pub radius: Vec<f64>,
    /// Coefficients of dr/du over u.
    pub radius_slope: Vec<f64>,
    /// Coefficients of 1/√(1 + y′² + z′²) over u; none but in the `paper` formulation.
    pub direction: Vec<f64>,
    /// 4a and 2b of dy/dx = x(4a x² + 2b), Zhao 2022, Eq. (5).
    pub path_slope: [f64; 2],
    /// Coefficients of (2 cos αc)^(−2/3) over u; none with rigid flanks.
    pub ellipse: Vec<f64>,
}

/// The equations of motion of one case, shared by whatever evaluates them.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    pub(crate) layout: Layout,
    pub(crate) formulation: Formulation,
    pub(crate) law: FrictionModel,
    pub(crate) balls: Vec<Ball>,
    /// J of each ball, kg·m².
    pub(crate) inertia: Vec<f64>,
    /// Angle of each ball and the ball ahead when they touch on the pitch circle, rad.
    pair_angle: Vec<f64>,
    /// Whether outer contacts differ from those of nominal balls in raceways as designed.
    pub(crate) unequal: bool,
    pub(crate) flanks: FlankModel,
    pub(crate) friction: Friction,
    /// Creep of the contacts with the raceways, where it gives the knees of the law.
    pub(crate) creep: Option<Creep>,
    pub(crate) outer: OuterRaceway,
    pub(crate) inner: InnerRaceway,
    pub(crate) ring: InnerRing,
    /// The rings under a rotor, if one falls.
    pub(crate) under_rotor: Option<UnderRotor>,
    /// The rotor, if it has no bearing but this.
    pub(crate) rotor: Option<RigidRotor>,
    pub(crate) outer_ring: OuterRing,
    /// Whether methods that can treat friction implicitly are to do so.
    pub(crate) implicit_friction: bool,
    /// Whether contacts between balls are damped.
    pub(crate) ball_damped: bool,
    pub(crate) raceway_models: Vec<RacewayModel>,
    /// ωi and Fr over time, where they change.
    pub(crate) inner_speed: Option<TimeTable>,
    pub(crate) radial_load: Option<TimeTable>,
    /// The unbalance of the inner ring.
    pub(crate) unbalance: Option<UnbalanceForce>,
    /// Constants of motion in space beyond those of the plane.
    pub(crate) space: Option<SpaceModel>,
    /// Films of the contacts with the raceways.
    pub(crate) film: Option<RollingModel>,
    bearing: Bearing,
    raceways: Vec<Raceway>,
}

impl Model {
    /// Derives the constants.
    ///
    /// # Errors
    /// The [`InputError`] of [`Case::check`].
    pub fn new(case: &Case) -> Result<Arc<Self>, InputError> {
        Self::of_case(case).map(Arc::new)
    }

    /// [`Self::new`], not yet shared.
    pub(crate) fn of_case(case: &Case) -> Result<Self, InputError> {
        step_limits::check(case)?;
        let bearing = &case.bearing;
        let d = bearing.dimensions();
        let c = &case.contact;
        let in_row = |k: usize| k % d.balls;
        let balls = balls(case);
        // 2/7 m is the mass that a force at the surface of a free ball feels.
        let lightest = balls.iter().map(|b| b.mass).fold(f64::INFINITY, f64::min);
        let stick_gain = STICK_FRACTION * 2.0 / 7.0 * lightest / case.solver.step_s;
        let friction = Friction::new(c.friction_law, &c.friction, stick_gain);
        let space = SpaceModel::new(case);
        let ring = InnerRing {
            mass: d.inner_ring_mass_kg,
            polar_inertia: 0.0,
            drag: d.inner_ring_damping_n_s_m,
            radial_load: case.operation.radial_load_n,
            gravity: case.operation.gravity_m_s2,
            unbalance_x: 0.0,
            unbalance_y: 0.0,
        };
        let sliding_kg = space.as_ref().map_or(0.0, SpaceModel::sliding_kg);
        let outer_ring = OuterRing::new(case.support.as_ref(), sliding_kg);
        Ok(Self {
            layout: Layout::of_case(case),
            under_rotor: UnderRotor::of_case(case, ring, outer_ring),
            rotor: (case.rotor.as_ref()).map(|rotor| RigidRotor::of_case(rotor, case)),
            outer_ring,
            formulation: case.formulation,
            law: c.friction_law,
            inertia: (0..case.balls())
                .map(|k| bearing.ball(in_row(k)).inertia_kg_m2)
                .collect(),
            pair_angle: (0..case.balls())
                .map(|k| bearing.pair_angle_rad(in_row(k)))
                .collect(),
            balls,
            unequal: !case.has_nominal_geometry(),
            flanks: case.flanks,
            friction: match case.mixes_friction() {
                true => friction.mixed(),
                false => friction,
            },
            creep: case.creep(),
            outer: outer_raceway(case),
            inner: inner_raceway(case),
            ring,
            implicit_friction: space.is_some() || StepLimits::friction_is_stiff(case),
            ball_damped: restitution_damping(c.ball_restitution) > 0.0,
            raceway_models: RacewayModel::of_case(case),
            inner_speed: case.operation.inner_speed_table.clone(),
            radial_load: case.operation.radial_load_table.clone(),
            unbalance: case.operation.unbalance_force(),
            space,
            film: RollingModel::new(case),
            bearing: bearing.clone(),
            raceways: case.raceways.clone(),
        })
    }

    /// Radial load and unbalance at a time, N.
    pub(crate) fn load_n(&self, time_s: f64) -> [f64; 2] {
        let table = self.radial_load.as_ref();
        let down = table.map_or(self.ring.radial_load, |load| load.value(time_s));
        let turning = self.unbalance.as_ref();
        let [x, y] = turning.map_or([0.0; 2], |unbalance| unbalance.at(time_s));
        [x, y - down]
    }

    /// Bearing of a rotor that rests in others as well, whose Z in this one is `seat_z_m` beyond its own: friction is
    /// implicit, as no rotor of its own limits the step.
    pub(crate) fn of_common_rotor(self, seat_z_m: f64) -> Self {
        let seated = |mut under: UnderRotor| {
            under.joint.seat.z = seat_z_m;
            under
        };
        Self {
            under_rotor: self.under_rotor.map(seated),
            rotor: None,
            implicit_friction: true,
            ..self
        }
    }

    /// Layout of the state vector.
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// Rings and balls.
    pub(crate) fn bearing(&self) -> &Bearing {
        &self.bearing
    }

    /// First answer of a law of friction of one's own that cannot be.
    pub(crate) fn friction_fault(&self) -> Option<&FrictionFault> {
        let journal = (self.under_rotor.as_ref()).map(|under| &under.joint.friction);
        self.friction.fault().or(journal.and_then(Friction::fault))
    }

    /// N.
    pub(crate) fn balls(&self) -> usize {
        self.layout.balls
    }

    /// Properties that bearings side by side must have in common.
    pub(crate) fn kind(&self) -> impl PartialEq + use<> {
        (
            self.balls(),
            self.formulation,
            self.law,
            self.unequal,
            self.flanks,
            self.implicit_friction,
            self.layout,
            self.film.is_some(),
            matches!(self.friction, Friction::Mixed(_)),
            self.creep.is_some(),
        )
    }

    /// Angle between ball `k` and the ball ahead when they touch on the pitch circle.
    pub(crate) fn pair_angle_rad(&self, k: usize) -> f64 {
        self.pair_angle[k]
    }

    /// Distance of the centres of ball `k` and the ball ahead when they touch.
    pub(crate) fn pair_distance_m(&self, k: usize) -> f64 {
        self.balls[k].pair_distance
    }

    /// Geometry of the outer contact of ball `k`, with r and |rb| of [`outer_contact_geometry`].
    fn outer_geometry(&self, k: usize, polar: &PolarMotion) -> OuterGeometry {
        let plain = OuterGeometry::plain(&self.balls[k]);
        if !self.unequal {
            return plain;
        }
        let angle = polar.ex.atan2(-polar.ey);
        let geometry =
            outer_contact_geometry(&self.bearing, &self.raceways, angle, self.balls[k].radius);
        OuterGeometry {
            orbit_radius: geometry.outer_orbit_radius_m,
            effective_radius: geometry.effective_radius_m,
            ..plain
        }
    }

    /// Deflection of the outer contact of ball `k`, m: δo, or δe on elastic flanks.
    pub(crate) fn outer_deflection_m(&self, k: usize, polar: &PolarMotion) -> f64 {
        let beyond = outer_deflection(polar.distance, &self.outer_geometry(k, polar));
        if !self.flanks.yields() {
            return beyond;
        }
        let angle = polar.ex.atan2(-polar.ey);
        let radius = self.balls[k].radius;
        let flanks = flank_section(&self.bearing, &self.raceways, angle, radius);
        flanks.map_or(beyond, |flanks| flanks.press(beyond).deflection)
    }
}

/// The balls of all rows of a case: every row has those of the bearing.
fn balls(case: &Case) -> Vec<Ball> {
    let bearing = &case.bearing;
    let (d, contact) = (bearing.dimensions(), &case.contact);
    let alpha = restitution_damping(contact.ball_restitution);
    let of_row = (0..d.balls).map(|k| {
        let (ball, next) = (bearing.ball(k), bearing.ball((k + 1) % d.balls));
        let [
            inner_stiffness_n_m1_5,
            outer_stiffness_n_m1_5,
            pair_stiffness,
        ] = case.ball_stiffness_n_m1_5(k);
        let reduced = ball.mass_kg * next.mass_kg / (ball.mass_kg + next.mass_kg);
        Ball {
            radius: ball.radius_m,
            mass: ball.mass_kg,
            inverse_mass: 1.0 / ball.mass_kg,
            inverse_inertia: 1.0 / ball.inertia_kg_m2,
            outer_orbit_radius: d.outer_groove_bottom_radius_m - ball.radius_m,
            inner_contact_distance: d.inner_groove_bottom_radius_m + ball.radius_m,
            inner_stiffness_n_m1_5,
            outer_stiffness_n_m1_5,
            raceway_damping: contact.damping_n_s_m1_5,
            pair_distance: ball.radius_m + next.radius_m,
            pair_stiffness,
            pair_damping: alpha * (reduced * pair_stiffness).sqrt(),
            next_radius: next.radius_m,
            pair_friction_factor: contact.ball_friction_factor,
        }
    });
    let of_row: Vec<Ball> = of_row.collect();
    of_row.repeat(case.balls() / d.balls)
}

/// The outer raceway with nominal balls.
fn outer_raceway(case: &Case) -> OuterRaceway {
    let d = case.bearing.dimensions();
    OuterRaceway {
        pitch_radius: case.bearing.pitch_radius_m(),
        orbit_radius: d.outer_groove_bottom_radius_m - d.ball_radius_m,
        curvature_offset: d.outer_groove_curvature_radius_m - d.ball_radius_m,
        curvature: d.outer_groove_curvature_radius_m,
        ball_radius: d.ball_radius_m,
        friction_factor: case.contact.outer_friction_factor,
        axis_square_per_m: axis_square_per_m(case),
    }
}

/// The inner raceway at the speed of the start.
fn inner_raceway(case: &Case) -> InnerRaceway {
    let radius = case.bearing.dimensions().inner_groove_bottom_radius_m;
    InnerRaceway {
        radius,
        surface_speed: case.operation.inner_speed_rad_s * radius,
        following: following_1_kg(&case.bearing),
    }
}

/// Mass of all balls over that of the inner ring beyond which it follows them.
const HEAVY_BALLS: f64 = 1.5;

/// Mobility that an inner ring lighter than its balls adds to that of each: the tangents of bunched ones are almost
/// parallel.
fn following_1_kg(bearing: &Bearing) -> f64 {
    let (balls, ring_kg) = (
        bearing.balls() as f64,
        bearing.dimensions().inner_ring_mass_kg,
    );
    match balls * bearing.ball_mass_kg() > HEAVY_BALLS * ring_kg {
        true => balls / ring_kg,
        false => 0.0,
    }
}

/// a² of the contact of a nominal ball at the plain outer raceway over its deflection, m: a is
/// proportional to F^(1/3), F = K δ^(3/2).
fn axis_square_per_m(case: &Case) -> f64 {
    let [_, outer, _] = case.stiffness_n_m1_5();
    let [_, across] = case.bearing.outer_contact().semi_axes_m(outer);
    across * across
}

/// Error of (2 cos αc)^(−2/3).
const ELLIPSE_TOLERANCE: f64 = 1e-12;

impl RacewayModel {
    /// The stretches of all raceways of a case.
    fn of_case(case: &Case) -> Vec<Self> {
        let of_raceway = |raceway: &Raceway| -> Vec<Self> {
            let pieces = raceway.pieces().iter();
            let models = pieces.map(|piece| Self::new(raceway, piece, case));
            models.collect()
        };
        case.raceways.iter().flat_map(of_raceway).collect()
    }

    fn new(raceway: &Raceway, piece: &Piece, case: &Case) -> Self {
        let path = raceway.contact_path();
        let path = path.filter(|_| case.formulation.equations().friction_along_path);
        let [a, b, _] = path.map_or([0.0; 3], ContactPath::coefficients);
        let (sin_centre, cos_centre) = raceway.dimensions().centre_angle_rad.sin_cos();
        let radius = piece.radius();
        let [begin, end] = piece.squares();
        let [lo, hi] = piece.domain();
        let whole = raceway.half_angle_rad().sin().powi(2);
        let ellipse = |square: f64| {
            let cosine = radius.value(square) / case.bearing.ball_radius_m();
            (2.0 * cosine).powf(-2.0 / 3.0)
        };
        Self {
            constants: RacewayConstants {
                sin_centre,
                cos_centre,
                begin,
                end,
                inverse_end: 1.0 / whole,
                scale: radius.scale,
                shift: radius.shift,
                depth_error: raceway.depth_error_m(),
                depth: raceway.form().depth_m,
            },
            radius: radius.coefficients.clone(),
            radius_slope: (1..radius.coefficients.len())
                .map(|k| k as f64 * radius.coefficients[k])
                .collect(),
            direction: path.map_or(vec![], |path| path.direction_polynomial().coefficients),
            path_slope: [4.0 * a, 2.0 * b],
            ellipse: match case.flanks.yields() {
                true => Polynomial::fit(ellipse, lo, hi, ELLIPSE_TOLERANCE).coefficients,
                false => vec![],
            },
        }
    }
}
