//! The bearing: rings, balls and what follows from their dimensions.
//!
//! ```
//! use cageless::{Bearing, BearingDimensions, Material};
//!
//! let dimensions = BearingDimensions {
//!     balls: 14,
//!     ball_radius_m: 4.7625e-3,
//!     inner_groove_bottom_radius_m: 18.24e-3,
//!     outer_groove_bottom_radius_m: 27.765e-3,
//!     outer_shoulder_radius_m: 26e-3,
//!     inner_shoulder_radius_m: None,
//!     inner_groove_curvature_radius_m: 4.953e-3,
//!     outer_groove_curvature_radius_m: 4.953e-3,
//!     inner_ring_mass_kg: 0.2,
//!     inner_ring_damping_n_s_m: 2000.0,
//! };
//! let steel = Material {
//!     density_kg_m3: 7850.0,
//!     youngs_modulus_pa: 206e9,
//!     poisson_ratio: 0.3,
//! };
//! let bearing = Bearing::new(dimensions, steel)?;
//! assert!((bearing.pitch_radius_m() - 23.0025e-3).abs() < 1e-12);
//! assert!((bearing.nominal_gap_rad().to_degrees() - 1.8161).abs() < 1e-3);
//! # Ok::<(), cageless::InputError>(())
//! ```

mod contact_angle;
mod dimensions;
mod estimate;
mod outer_ring;
mod shoulder;

use std::f64::consts::{PI, TAU};

use crate::assembly::Assembly;
use crate::contact::hertz::PointContact;
use crate::error::{Allowed, InputError};
use crate::limits::{from_to, positive, require};
use crate::material::Materials;

use dimensions::ROUNDING_M;
pub use dimensions::{BALLS_MIN, BearingDimensions, SHOULDER_HEIGHT};
pub use estimate::{CONFORMITY, INNER_RING_DAMPING_N_S_M};
pub(crate) use shoulder::BeyondGroove;

/// A bearing with every constant that follows from its dimensions.
#[derive(Debug, Clone, PartialEq)]
pub struct Bearing {
    dimensions: BearingDimensions,
    materials: Materials,
    inner_contact: PointContact,
    outer_contact: PointContact,
    ball_contact: PointContact,
    /// Rw of every ball − Rw; empty if all are equal.
    deviations_m: Vec<f64>,
    /// d/2 and D/2, where given.
    boundary_radii_m: [Option<f64>; 2],
    bore: Option<InnerRingBore>,
    /// Way of assembly, where it is not that of the contact angle or the number of balls.
    assembly: Option<Assembly>,
    contact_angle_rad: f64,
    preload_change_m: f64,
}

/// Bore and polar inertia of the inner ring: what a bearing needs that catches a rotor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InnerRingBore {
    /// Ji, of the inner ring with what turns with it.
    pub polar_inertia_kg_m2: f64,
    /// Rb, radius of the bore.
    pub radius_m: f64,
}

/// One ball of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Radius of the ball, m.
    pub radius_m: f64,
    /// m.
    pub mass_kg: f64,
    /// Jr = 2/5 m Rw², about a diameter.
    pub inertia_kg_m2: f64,
}

/// Largest deviation of a ball's radius, as a fraction of the nominal one. The coarsest grade of
/// ISO 3290-1 (G200) lets the diameter deviate by less than a tenth of that.
const DEVIATION_MAX: f64 = 0.01;

impl Bearing {
    /// Checks that the parts fit together and derives the constants. `materials` may be one
    /// [`Material`](crate::Material) for balls and rings.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be: a dimension not
    /// above zero, balls pressed between the rings beyond
    /// [`BearingDimensions::interference_max_m`], more balls than fit on the pitch circle,
    /// grooves tighter than the ball, a shoulder outside (Ro − Rw, Ro).
    pub fn new(
        dimensions: BearingDimensions,
        materials: impl Into<Materials>,
    ) -> Result<Self, InputError> {
        let materials = materials.into();
        dimensions.check(&materials)?;
        let [inner_contact, outer_contact] = dimensions.raceway_contacts(&materials);
        let ball = [1.0 / dimensions.ball_radius_m; 2];
        let ball_contact = PointContact::new(ball, ball, &materials.ball);
        Ok(Self {
            dimensions,
            materials,
            inner_contact,
            outer_contact,
            ball_contact,
            deviations_m: vec![],
            bore: None,
            boundary_radii_m: [None; 2],
            assembly: None,
            contact_angle_rad: 0.0,
            preload_change_m: 0.0,
        })
    }

    /// Bearing whose inner ring has this bore.
    ///
    /// # Errors
    /// An [`InputError`] if the inertia is not above zero, or the bore not between 0 and the
    /// bottom of the groove.
    pub fn with_inner_ring_bore(mut self, bore: InnerRingBore) -> Result<Self, InputError> {
        positive("inner_ring_polar_inertia_kg_m2", bore.polar_inertia_kg_m2)?;
        positive("inner_ring_bore_radius_m", bore.radius_m)?;
        let groove = self.dimensions.inner_groove_bottom_radius_m;
        Allowed::Below(groove, "the bottom of the groove of the inner ring")
            .check("inner_ring_bore_radius_m", bore.radius_m)?;
        self.bore = Some(bore);
        Ok(self)
    }

    /// Bore of the inner ring, where given.
    pub fn inner_ring_bore(&self) -> Option<InnerRingBore> {
        self.bore
    }

    /// Bearing with these radii of the bore of its inner and the outside of its outer ring, where known: what
    /// rules of catalogues take.
    ///
    /// # Errors
    /// An [`InputError`] if the bore is not between 0 and the bottom of the inner groove, or the outside not
    /// beyond that of the outer one.
    pub fn with_boundary_radii(
        mut self,
        bore_m: Option<f64>,
        outside_m: Option<f64>,
    ) -> Result<Self, InputError> {
        let d = &self.dimensions;
        if let Some(radius_m) = bore_m {
            let field = "inner_ring_bore_radius_m";
            positive(field, radius_m)?;
            let groove_m = d.inner_groove_bottom_radius_m;
            Allowed::Below(groove_m, "the bottom of the groove of the inner ring")
                .check(field, radius_m)?;
        }
        if let Some(radius_m) = outside_m {
            Allowed::Above(d.outer_groove_bottom_radius_m, "the bottom of the groove")
                .check("outer_ring_outer_radius_m", radius_m)?;
        }
        self.boundary_radii_m = [bore_m, outside_m];
        Ok(self)
    }

    /// d/2, where given, also as that of a bore that is to catch a rotor.
    pub fn bore_radius_m(&self) -> Option<f64> {
        let [bore_m, _] = self.boundary_radii_m;
        bore_m.or(self.bore.map(|bore| bore.radius_m))
    }

    /// d/2, or [the estimate](BearingDimensions::bore_radius_estimate_m), m.
    pub(crate) fn bore_radius_or_estimate_m(&self) -> f64 {
        self.bore_radius_m()
            .unwrap_or_else(|| self.dimensions.bore_radius_estimate_m())
    }

    /// D/2, where given.
    pub fn outside_radius_m(&self) -> Option<f64> {
        self.boundary_radii_m[1]
    }

    /// Bearing with balls whose radii differ from the nominal one by
    /// `deviations_m`, one entry per ball; none makes them equal again.
    ///
    /// # Errors
    /// An [`InputError`] if there are not N entries, or one is beyond 1 % of Rw.
    pub fn with_ball_radius_deviations(
        mut self,
        deviations_m: Vec<f64>,
    ) -> Result<Self, InputError> {
        const FIELD: &str = "ball_radius_deviation_m";
        let balls = self.balls();
        let listed = deviations_m.len();
        let rule = format!("a list of {balls}, one entry per ball");
        require(FIELD, listed as f64, [0, balls].contains(&listed), rule)?;
        let most = DEVIATION_MAX * self.ball_radius_m();
        for deviation_m in &deviations_m {
            from_to(FIELD, *deviation_m, -most..=most, "1 % of the ball radius")?;
        }
        let d = &self.dimensions;
        let groove = d
            .inner_groove_curvature_radius_m
            .min(d.outer_groove_curvature_radius_m);
        for &deviation_m in &deviations_m {
            let why = "the ball must be smaller than the curvature radius of the grooves";
            Allowed::Below(groove - d.ball_radius_m, why).check(FIELD, deviation_m)?;
        }
        let equal = deviations_m.iter().all(|d| *d == 0.0);
        self.deviations_m = if equal { vec![] } else { deviations_m };
        Ok(self)
    }

    /// Deviation of every ball's radius from the nominal one; empty if all are equal.
    pub fn ball_radius_deviations_m(&self) -> &[f64] {
        &self.deviations_m
    }

    /// Ball `k`, counted from 0.
    pub fn ball(&self, k: usize) -> Ball {
        self.ball_of(self.ball_radius_m() + self.deviations_m.get(k).copied().unwrap_or(0.0))
    }

    fn ball_of(&self, radius_m: f64) -> Ball {
        let mass_kg = 4.0 / 3.0 * PI * radius_m.powi(3) * self.materials.ball.density_kg_m3;
        Ball {
            radius_m,
            mass_kg,
            inertia_kg_m2: 0.4 * mass_kg * radius_m.powi(2),
        }
    }

    /// Angle between ball `k` and the ball ahead when they touch on the pitch circle: ε for
    /// two nominal balls.
    pub fn pair_angle_rad(&self, k: usize) -> f64 {
        let sum = self.ball(k).radius_m + self.ball((k + 1) % self.balls()).radius_m;
        2.0 * (sum / 2.0 / self.pitch_radius_m()).asin()
    }

    /// Gap of evenly spaced balls: what the balls leave free of a turn, over N.
    pub fn mean_gap_rad(&self) -> f64 {
        let n = self.balls();
        (TAU - (0..n).map(|k| self.pair_angle_rad(k)).sum::<f64>()) / n as f64
    }

    /// K at the inner raceway, at the plain outer raceway of ball `k`, and between it and the
    /// ball ahead, N·m^(−3/2).
    pub(crate) fn ball_stiffness_n_m1_5(&self, k: usize) -> [f64; 3] {
        if self.deviations_m.is_empty() {
            return [
                self.inner_contact.stiffness_n_m1_5,
                self.outer_contact.stiffness_n_m1_5,
                self.ball_contact.stiffness_n_m1_5,
            ];
        }
        let one = [1.0 / self.ball(k).radius_m; 2];
        let next = [1.0 / self.ball((k + 1) % self.balls()).radius_m; 2];
        let [inner, outer] = self.dimensions.ring_curvatures([self.contact_angle_rad; 2]);
        let Materials { ball, ring } = &self.materials;
        [(inner, ring), (outer, ring), (next, ball)].map(|(other, material)| {
            PointContact::between(one, other, [ball, material]).stiffness_n_m1_5
        })
    }

    /// Bearing, with its contact angle, that is assembled in this way.
    #[must_use]
    pub fn with_assembly(mut self, assembly: Assembly) -> Self {
        self.assembly = None;
        self.assembly = (self.assembly() != assembly).then_some(assembly);
        self
    }

    /// Way of assembly: unless given, rings with a contact angle go together over a counterbored shoulder,
    /// others as their number of balls requires.
    pub fn assembly(&self) -> Assembly {
        let d = &self.dimensions;
        match self.assembly {
            Some(assembly) => assembly,
            None if self.contact_angle_rad > 0.0 => Assembly::WithoutSlot,
            None => Assembly::of(d.balls, d.ball_radius_m, d.pitch_radius_m()),
        }
    }

    /// The dimensions as given.
    pub fn dimensions(&self) -> &BearingDimensions {
        &self.dimensions
    }

    /// The materials as given.
    pub fn materials(&self) -> &Materials {
        &self.materials
    }

    /// N.
    pub fn balls(&self) -> usize {
        self.dimensions.balls
    }

    /// Rw.
    pub fn ball_radius_m(&self) -> f64 {
        self.dimensions.ball_radius_m
    }

    /// Rm = (Ro + Ri)/2.
    pub fn pitch_radius_m(&self) -> f64 {
        self.dimensions.pitch_radius_m()
    }

    /// Ro − Rw: distance of a ball's centre that just touches the plain outer
    /// raceway. It stands for Rm in Zhao 2022, Eq. (4) to (8), so that the
    /// contact path ends on the plain raceway at any clearance.
    pub(crate) fn outer_orbit_radius_m(&self) -> f64 {
        self.dimensions.outer_groove_bottom_radius_m - self.dimensions.ball_radius_m
    }

    /// Gr = 2 (Ro − Ri − 2Rw), the radial internal clearance of ISO 5753-1: twice the play of one
    /// ball between the rings. Negative: twice the interference with which they press it.
    pub fn radial_internal_clearance_m(&self) -> f64 {
        let play = self.dimensions.play_m();
        if play.abs() < ROUNDING_M {
            0.0
        } else {
            2.0 * play
        }
    }

    /// m, mass of a nominal ball.
    pub fn ball_mass_kg(&self) -> f64 {
        self.ball_of(self.ball_radius_m()).mass_kg
    }

    /// Jr = 2/5 m Rw², inertia of a nominal ball about a diameter.
    pub(crate) fn ball_inertia_kg_m2(&self) -> f64 {
        self.ball_of(self.ball_radius_m()).inertia_kg_m2
    }

    /// ε = 2 asin(Rw/Rm), the angle that one ball takes up on the pitch circle
    /// (Zhao 2022, Eq. (10)).
    pub fn ball_angle_rad(&self) -> f64 {
        2.0 * (self.ball_radius_m() / self.pitch_radius_m()).asin()
    }

    /// 2π/N − ε, the gap of evenly spaced balls (Zhao 2022, Eq. (10)).
    pub fn nominal_gap_rad(&self) -> f64 {
        TAU / self.balls() as f64 - self.ball_angle_rad()
    }

    /// Ball against inner raceway.
    pub(crate) fn inner_contact(&self) -> &PointContact {
        &self.inner_contact
    }

    /// Ball against plain outer raceway.
    pub(crate) fn outer_contact(&self) -> &PointContact {
        &self.outer_contact
    }

    /// Ball against ball.
    pub(crate) fn ball_contact(&self) -> &PointContact {
        &self.ball_contact
    }
}
