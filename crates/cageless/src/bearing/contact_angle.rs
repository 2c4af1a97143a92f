//! Contact angles of a bearing without load, and the shoulders that limit them.

use super::{Bearing, BearingDimensions};
use crate::contact::hertz::PointContact;
use crate::error::{Allowed, InputError};
use crate::limits::require;

/// Difference of a given contact angle and that of the clearance below which they agree, rad.
const SAME_ANGLE_RAD: f64 = 1e-3;

impl BearingDimensions {
    /// A = Re + ri − 2Rw, distance of the groove centres of a ball that touches both grooves.
    pub(crate) fn groove_distance_m(&self) -> f64 {
        self.inner_groove_curvature_radius_m + self.outer_groove_curvature_radius_m
            - 2.0 * self.ball_radius_m
    }

    /// αf with cos αf = 1 − (Ro − Ri − 2Rw)/A, at which unloaded balls touch both grooves.
    fn angle_of_clearance_rad(&self) -> f64 {
        self.angle_of_play_rad(self.play_m())
    }

    /// αf with this Ro − Ri − 2Rw.
    fn angle_of_play_rad(&self, play_m: f64) -> f64 {
        (1.0 - play_m / self.groove_distance_m())
            .clamp(0.0, 1.0)
            .acos()
    }

    /// Opens grooves whose Gr is `enlargement_m` and no more about the pitch circle until unloaded balls
    /// touch them at this angle: Gr = 2A(1 − cos α0).
    pub fn open_to(&mut self, angle_rad: f64, enlargement_m: f64) {
        if (self.play_m() - 0.5 * enlargement_m).abs() < super::ROUNDING_M {
            let half = 0.5 * self.groove_distance_m() * (1.0 - angle_rad.cos());
            self.inner_groove_bottom_radius_m -= half;
            self.outer_groove_bottom_radius_m += half;
        }
    }
}

impl Bearing {
    /// Angular-contact bearing that has this free contact angle by itself. Grooves without clearance
    /// are opened to it ([`BearingDimensions::open_to`]); a clearance must agree with the angle.
    /// `enlargement_m` is what fits and temperatures have added to the clearance in the dimensions: with it the
    /// free contact angle is another.
    ///
    /// # Errors
    /// An [`InputError`] for an angle below 0 or beyond a shoulder, and for a clearance of
    /// another angle.
    pub fn with_contact_angle(
        mut self,
        angle_rad: f64,
        enlargement_m: f64,
    ) -> Result<Self, InputError> {
        const FIELD: &str = "contact_angle_rad";
        if angle_rad == 0.0 {
            return Ok(self);
        }
        self.dimensions.open_to(angle_rad, enlargement_m);
        let d = &self.dimensions;
        let by_itself = d.angle_of_play_rad(d.play_m() - 0.5 * enlargement_m);
        let free = d.angle_of_clearance_rad();
        let room = d.groove_distance_m();
        let [inner, outer] = self.shoulder_angles_rad();
        let most = inner.min(outer);
        let why = "at a larger angle the contact leaves the groove over its shoulder";
        Allowed::Between(0.0, most, why).check(FIELD, angle_rad)?;
        let same = (by_itself - angle_rad).abs() <= SAME_ANGLE_RAD;
        let rule = "left out, or the radial internal clearance 0: the clearance gives another free \
                    contact angle, from 1 - cos = Gr/(2A)";
        require(FIELD, angle_rad, same, rule)?;
        if free > most {
            let rule = "smaller: fits and temperatures open the bearing until its free contact angle is beyond the shoulder";
            return Err(InputError::rule(FIELD, angle_rad, rule));
        }
        self.contact_angle_rad = free;
        self.preload_change_m = room * (by_itself.sin() - free.sin());
        [self.inner_contact, self.outer_contact] = self.contacts_at([free; 2]);
        Ok(self)
    }

    /// The bearing with equal balls and a radial internal clearance that differs by `deviation_m`, at the bottom of
    /// the inner groove; an angular-contact one has the free contact angle of that clearance, while the preload of
    /// its rows is ground to what it should be.
    ///
    /// # Errors
    /// An [`InputError`] if the bearing is impossible, or its contact angle beyond a shoulder.
    pub fn with_clearance_deviation(&self, deviation_m: f64) -> Result<Self, InputError> {
        if deviation_m == 0.0 {
            let deviations_m = vec![];
            return Ok(Self {
                deviations_m,
                ..self.clone()
            });
        }
        let mut dimensions = self.dimensions.clone();
        dimensions.inner_groove_bottom_radius_m -= 0.5 * deviation_m;
        let mut deviated = Self::new(dimensions, self.materials)?;
        if self.contact_angle_rad != 0.0 {
            let angle_rad = deviated.free_contact_angle_rad();
            deviated = deviated.with_contact_angle(angle_rad, 0.0)?;
            deviated.preload_change_m = self.preload_change_m;
        }
        Ok(Self {
            bore: self.bore,
            boundary_radii_m: self.boundary_radii_m,
            assembly: self.assembly,
            ..deviated
        })
    }

    /// A(sin α0 − sin αf): displacement along the axis by which fits and temperatures press each of two
    /// rows of opposite contact sign, whose grooves stay where they are along the axis, m.
    pub fn preload_change_m(&self) -> f64 {
        self.preload_change_m
    }

    /// α0, free contact angle, in operation; 0 of a radial bearing.
    pub fn contact_angle_rad(&self) -> f64 {
        self.contact_angle_rad
    }

    /// Contact angle at which unloaded balls touch both grooves: α0, or that of the clearance of a radial
    /// bearing.
    pub(crate) fn free_contact_angle_rad(&self) -> f64 {
        self.dimensions.angle_of_clearance_rad()
    }

    /// ½A sin α0 by which the centres of the grooves are off the middle, towards −Z at the outer and
    /// +Z at the inner ring: unloaded balls then touch both.
    pub fn groove_offset_m(&self) -> f64 {
        0.5 * self.dimensions.groove_distance_m() * self.contact_angle_rad.sin()
    }

    /// Contacts of a nominal ball with plain raceways at these contact angles: inner, outer.
    pub(crate) fn contacts_at(&self, angles_rad: [f64; 2]) -> [PointContact; 2] {
        self.dimensions
            .raceway_contacts_at(&self.materials, angles_rad)
    }

    /// Largest displacement of the outer ring by which a row against one like it may be preloaded:
    /// its balls then bear 4200 MPa between unloaded rings.
    pub fn axial_preload_max_m(&self) -> f64 {
        let (room, angle) = (self.dimensions.groove_distance_m(), self.contact_angle_rad);
        let stretched = room + self.dimensions.interference_max_m(&self.materials);
        // The grooves are A cos α0 apart along the radius.
        (stretched.powi(2) - (room * angle.cos()).powi(2)).sqrt() - room * angle.sin()
    }

    /// Approach of the rings along the contact of a ball, where a displacement along the axis stretches
    /// the distance of the grooves from that of the free contact angle, m.
    pub(crate) fn axial_approach_m(&self, displacement_m: f64) -> f64 {
        let (room, (sin, cos)) = (
            self.dimensions.groove_distance_m(),
            self.contact_angle_rad.sin_cos(),
        );
        let stretched = (room * cos).hypot(room * sin + displacement_m);
        displacement_m * (2.0 * room * sin + displacement_m) / (stretched + room)
    }
}
