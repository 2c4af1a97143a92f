//! Dimensions of a bearing, and whether its parts fit together.

use std::f64::consts::TAU;

use crate::contact::hertz::{PointContact, STRESS_LIMIT_PA};
use crate::error::{Allowed, InputError};
use crate::limits::{not_negative, positive};
use crate::material::Materials;

/// Dimensions and inertia of the bearing, as a designer states them.
#[derive(Debug, Clone, PartialEq)]
pub struct BearingDimensions {
    /// N, number of balls; 3 or more.
    pub balls: usize,
    /// Rw.
    pub ball_radius_m: f64,
    /// Ri, radius of the inner ring at the bottom of its groove.
    pub inner_groove_bottom_radius_m: f64,
    /// Ro, radius of the outer ring at the bottom of its groove.
    pub outer_groove_bottom_radius_m: f64,
    /// Ros, radius of the outer ring's shoulder.
    pub outer_shoulder_radius_m: f64,
    /// Ris, radius of the shoulders of the inner ring; [`SHOULDER_HEIGHT`] above Ri if `None`.
    pub inner_shoulder_radius_m: Option<f64>,
    /// Radius of curvature of the inner groove in the meridian plane.
    pub inner_groove_curvature_radius_m: f64,
    /// Re, radius of curvature of the outer groove in the meridian plane.
    pub outer_groove_curvature_radius_m: f64,
    /// mi, the inner ring with what turns with it.
    pub inner_ring_mass_kg: f64,
    /// C of Zhao 2022, Eq. (14).
    pub inner_ring_damping_n_s_m: f64,
}

/// Height of the shoulders of either ring over the diameter of the ball unless it is given.
pub const SHOULDER_HEIGHT: f64 = 0.2;

/// Thickness of the inner ring below its groove over the diameter of the ball, unless the bore is given.
const WALL: f64 = 0.3;

/// Largest radius of a groove in the meridian plane over the diameter of the ball. Grooves of
/// bearings have 0.51 to 0.58.
const CONFORMITY_MAX: f64 = 1.0;

/// Least number of balls: two cannot carry a load from every side.
pub const BALLS_MIN: usize = 3;

/// Largest number of balls.
pub(crate) const BALLS_MAX: usize = 256;

/// Below this a difference of dimensions is rounding: a thousandth of a nanometre.
pub(super) const ROUNDING_M: f64 = 1e-12;

impl BearingDimensions {
    /// Bore radius of an inner ring of which none is given, m: 0.3 ball diameters below the groove.
    pub(crate) fn bore_radius_estimate_m(&self) -> f64 {
        let bottom = self.inner_groove_bottom_radius_m;
        (bottom - WALL * (2.0 * self.ball_radius_m)).max(0.5 * bottom)
    }

    /// Largest interference 2Rw − (Ro − Ri), m: it presses the balls between the unloaded rings
    /// with [`STRESS_LIMIT_PA`]. 0 where the ball does not fit into the grooves.
    pub fn interference_max_m(&self, materials: &Materials) -> f64 {
        let radii = [
            self.outer_groove_bottom_radius_m,
            self.inner_groove_curvature_radius_m,
            self.outer_groove_curvature_radius_m,
        ];
        let positive = self.ball_radius_m.min(self.inner_groove_bottom_radius_m) > 0.0;
        if !(positive && radii.iter().all(|r| *r > self.ball_radius_m)) {
            return 0.0;
        }
        let contacts = self.raceway_contacts(materials);
        // Hertz: p ∝ F^(1/3), and both raceways bear the same force.
        let force = contacts
            .each_ref()
            .map(|c| (STRESS_LIMIT_PA / c.peak_pressure_pa(1.0)).powi(3));
        let force = force[0].min(force[1]);
        let deflections = contacts.map(|c| (force / c.stiffness_n_m1_5).powf(2.0 / 3.0));
        deflections[0] + deflections[1]
    }

    /// Checks that the parts fit together.
    pub(super) fn check(&self, materials: &Materials) -> Result<(), InputError> {
        let d = self;
        positive("ball_radius_m", d.ball_radius_m)?;
        let (grooves, bottoms) = (d.grooves(), d.bottoms());
        let shoulder = ("outer_shoulder_radius_m", d.outer_shoulder_radius_m);
        for (field, radius_m) in bottoms.into_iter().chain([shoulder]).chain(grooves) {
            positive(field, radius_m)?;
        }
        positive("inner_ring_mass_kg", d.inner_ring_mass_kg)?;
        not_negative("inner_ring_damping_n_s_m", d.inner_ring_damping_n_s_m)?;
        materials.ball.check()?;
        materials.ring.check()?;
        let balls = d.balls as f64;
        Allowed::AtLeast(BALLS_MIN as f64, "").check("balls", balls)?;
        d.check_interference(materials)?;
        Allowed::AtMost(BALLS_MAX as f64, "room in the vectors").check("balls", balls)?;
        let most = (TAU / (2.0 * (d.ball_radius_m / d.pitch_radius_m()).asin())).floor();
        Allowed::AtMost(most, "more do not fit on the pitch circle").check("balls", balls)?;
        let most = d.inner_groove_bottom_radius_m + 4.0 * d.ball_radius_m;
        let why = "with more room than that between the rings a ball passes another";
        Allowed::AtMost(most, why).check(bottoms[1].0, bottoms[1].1)?;
        for (field, radius) in grooves {
            Allowed::Above(d.ball_radius_m, "the radius of the ball").check(field, radius)?;
            let flattest = CONFORMITY_MAX * 2.0 * d.ball_radius_m;
            let why = "the diameter of the ball; grooves have 0.51 to 0.58 of it";
            Allowed::AtMost(flattest, why).check(field, radius)?;
        }
        d.check_shoulders()
    }

    /// Radii of curvature of the grooves, with their fields: inner, outer.
    fn grooves(&self) -> [(&'static str, f64); 2] {
        let inner_m = self.inner_groove_curvature_radius_m;
        let outer_m = self.outer_groove_curvature_radius_m;
        [
            ("inner_groove_curvature_radius_m", inner_m),
            ("outer_groove_curvature_radius_m", outer_m),
        ]
    }

    /// Radii of the groove bottoms, with their fields: inner, outer.
    fn bottoms(&self) -> [(&'static str, f64); 2] {
        let inner_m = self.inner_groove_bottom_radius_m;
        let outer_m = self.outer_groove_bottom_radius_m;
        [
            ("inner_groove_bottom_radius_m", inner_m),
            ("outer_groove_bottom_radius_m", outer_m),
        ]
    }

    /// Refuses rings that press the balls beyond any contact.
    fn check_interference(&self, materials: &Materials) -> Result<(), InputError> {
        let clearance = self.play_m();
        // Dimensions given in millimetres do not add up to zero exactly.
        let pressed = clearance < -ROUNDING_M && -clearance > self.interference_max_m(materials);
        if !pressed {
            return Ok(());
        }
        let [(field, inner_m), (_, outer_m)] = self.bottoms();
        if inner_m >= outer_m {
            let why = "the radius of the outer groove bottom Ro, as the balls are between both";
            let allowed = Allowed::Below(outer_m, why);
            return Err(InputError::new(field, inner_m, allowed));
        }
        let mut largest = self.clone();
        // The limit is in proportion to the radius of the ball, a hundredth of it or less.
        for _ in 0..4 {
            largest.ball_radius_m = (outer_m - inner_m) / 2.0;
            largest.ball_radius_m += largest.interference_max_m(materials) / 2.0;
        }
        let why = "with more interference, a radial clearance Ro - Ri - 2 Rw below zero, the \
                   unloaded rings press the balls with over 4200 MPa, the limit of ISO 76";
        let allowed = Allowed::AtMost(largest.ball_radius_m, why);
        let given_m = self.ball_radius_m;
        Err(InputError::new("ball_radius_m", given_m, allowed))
    }

    /// Checks the shoulders of both rings.
    fn check_shoulders(&self) -> Result<(), InputError> {
        let d = self;
        let bottom = d.outer_groove_bottom_radius_m;
        let why = "ball centre at the outer raceway and groove bottom";
        Allowed::Between(bottom - d.ball_radius_m, bottom, why)
            .check("outer_shoulder_radius_m", d.outer_shoulder_radius_m)?;
        let Some(shoulder) = d.inner_shoulder_radius_m else {
            return Ok(());
        };
        let bottom = d.inner_groove_bottom_radius_m;
        let why = "groove bottom and ball centre at the inner raceway";
        Allowed::Between(bottom, bottom + d.ball_radius_m, why)
            .check("inner_shoulder_radius_m", shoulder)?;
        let why = "the shoulder of the outer ring";
        Allowed::Below(d.outer_shoulder_radius_m, why).check("inner_shoulder_radius_m", shoulder)
    }

    /// Height of the shoulders of the inner ring, m.
    pub(crate) fn inner_shoulder_height_m(&self) -> f64 {
        match self.inner_shoulder_radius_m {
            Some(radius_m) => radius_m - self.inner_groove_bottom_radius_m,
            None => SHOULDER_HEIGHT * 2.0 * self.ball_radius_m,
        }
    }

    /// A nominal ball against the plain raceways: inner, outer.
    pub(super) fn raceway_contacts(&self, materials: &Materials) -> [PointContact; 2] {
        self.raceway_contacts_at(materials, [0.0; 2])
    }

    /// Hertz contacts of a nominal ball with both raceways at these contact angles: inner, outer.
    pub(super) fn raceway_contacts_at(
        &self,
        materials: &Materials,
        angles_rad: [f64; 2],
    ) -> [PointContact; 2] {
        let ball = [1.0 / self.ball_radius_m; 2];
        self.ring_curvatures(angles_rad)
            .map(|ring| PointContact::between(ball, ring, [&materials.ball, &materials.ring]))
    }

    /// Principal curvatures of the raceways at these contact angles, in the plane of rolling,
    /// ±cos α over the distance of the contact point from the axis, and across: inner, outer.
    pub(super) fn ring_curvatures(&self, angles_rad: [f64; 2]) -> [[f64; 2]; 2] {
        let [inner, outer] = angles_rad.map(f64::cos);
        let (ri, re) = (
            self.inner_groove_curvature_radius_m,
            self.outer_groove_curvature_radius_m,
        );
        [
            [
                inner / (self.inner_groove_bottom_radius_m + ri * (1.0 - inner)),
                -1.0 / ri,
            ],
            [
                -outer / (self.outer_groove_bottom_radius_m - re * (1.0 - outer)),
                -1.0 / re,
            ],
        ]
    }

    /// Ro − Ri − 2Rw as the dimensions give it.
    pub(super) fn play_m(&self) -> f64 {
        self.outer_groove_bottom_radius_m
            - self.inner_groove_bottom_radius_m
            - 2.0 * self.ball_radius_m
    }

    /// Rm, radius of the pitch circle: the mean of Ro and Ri.
    pub(super) fn pitch_radius_m(&self) -> f64 {
        (self.outer_groove_bottom_radius_m + self.inner_groove_bottom_radius_m) / 2.0
    }
}
