//! A rotor that falls onto the inner ring, and the support of the outer ring.
//!
//! ```
//! use cageless::reference;
//! let case = reference::rotor_drop(); // 20 kg at 30 000 rpm, 0.2 mm above the inner ring
//! let rotor = case.rotor.as_ref().unwrap();
//! // Its fall through the air gap.
//! let speed_m_s = (2.0 * case.operation.gravity_m_s2 * rotor.radial_clearance_m).sqrt();
//! assert!((speed_m_s - 0.0626).abs() < 1e-4);
//! assert!(case.check().is_ok());
//! ```

use crate::contact::friction::ContactKind;
use crate::contact::{FrictionModel, FrictionParameters};
use crate::error::{Allowed, InputError};
use crate::limits::{finite, from_to, not_negative, positive, require};

crate::named_enum! {
    /// Position of a shaft in the field of gravity.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum Shaft {
        /// Weights act along −Y.
        #[default]
        Horizontal = "horizontal",
        /// Weights act along −Z.
        Vertical = "vertical",
    }
}

/// A rigid rotor in the plane of the bearing, which a magnetic bearing holds until t = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Rotor {
    /// m, the part of the rotor that this bearing catches.
    pub mass_kg: f64,
    /// Ip, about the axis of rotation.
    pub polar_inertia_kg_m2: f64,
    /// Ω at the start, counter-clockwise; may be negative or 0.
    pub speed_rad_s: f64,
    /// r0, radial air gap between journal and bore of the inner ring.
    pub radial_clearance_m: f64,
    /// ε, distance of the mass centre from the centre of the journal.
    pub eccentricity_m: f64,
    /// φ, direction of the mass centre from the centre of the journal at the start, from +X,
    /// counter-clockwise.
    pub eccentricity_phase_rad: f64,
    /// Law of friction between journal and bore.
    pub friction_law: FrictionModel,
    /// Parameters of the law of friction.
    pub friction: FrictionParameters,
    /// K of the contact between journal and bore, F = K δ^p (1 + 1.5 α dδ/dt), N/m^p.
    pub contact_stiffness_n_mp: f64,
    /// p, 1 (conformal) to 1.5 (Hertz).
    pub contact_exponent: f64,
    /// α, s/m.
    pub contact_damping_s_m: f64,
    /// Mass centre at the start.
    pub x_m: f64,
    /// Mass centre at the start.
    pub y_m: f64,
    /// Velocity of the mass centre at the start.
    pub vx_m_s: f64,
    /// Velocity of the mass centre at the start.
    pub vy_m_s: f64,
    /// Axis of the rotor.
    pub shaft: Shaft,
    /// Clearance along the axis between either shoulder of the rotor and the face of the inner ring, with
    /// the rotor in the middle; `None`: no shoulders, nothing holds the rotor along its axis.
    pub axial_clearance_m: Option<f64>,
    /// Mean radius of shoulder and face; halfway between bore and raceway unless given.
    pub shoulder_radius_m: Option<f64>,
    /// Force on the rotor along +Z.
    pub axial_load_n: f64,
    /// Z at the start, from the middle between the shoulders.
    pub z_m: f64,
    /// Velocity along Z at the start.
    pub vz_m_s: f64,
    /// Torque of the drive, counter-clockwise; negative: drag.
    pub drive_torque_n_m: f64,
    /// Radial clearance of the rotor to the stator in the plane of the bearing: the largest
    /// displacement of the journal from the centre of the stator that a drop may reach.
    pub clearance_limit_m: Option<f64>,
}

/// Support of the outer ring and what moves with it; it does not turn.
#[derive(Debug, Clone, PartialEq)]
pub struct Support {
    /// mo, outer ring and housing.
    pub mass_kg: f64,
    /// ks, in every direction.
    pub stiffness_n_m: f64,
    /// cs, in every direction.
    pub damping_n_s_m: f64,
    /// Hard stop.
    pub stop: Option<SupportStop>,
}

/// Hard stop of a support: beyond the gap the outer ring is pushed back radially, without loss.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SupportStop {
    /// Radial displacement at which the stop is reached.
    pub gap_m: f64,
    /// Stiffness of the stop.
    pub stiffness_n_m: f64,
}

/// Exponents of the contact between journal and bore: flat surfaces to a Hertz contact.
pub(crate) const CONTACT_EXPONENTS: [f64; 2] = [1.0, 1.5];

impl Rotor {
    /// A balanced horizontal rotor of a mass, kg, and a polar inertia, kg·m², at rest in the middle of its radial air
    /// gap, m, and turning at a speed, rad/s, without a drive.
    ///
    /// Its journal rubs on the bore with μ = 0.15 (smooth, 0.05 m/s), a stiffness of 1e9 N/m and 0.3 s/m of damping; it
    /// has no shoulders. `CaseBuilder::rotor` takes it.
    ///
    /// ```
    /// use cageless::prelude::*;
    ///
    /// let rotor = Rotor::estimated(20.0, 0.02, 3142.0, 2e-4); // kg, kg·m², rad/s, m
    /// let unbalanced = Rotor { eccentricity_m: 5e-6, ..rotor };
    /// assert_eq!(unbalanced.contact_stiffness_n_mp, 1e9);
    /// ```
    pub fn estimated(
        mass_kg: f64,
        polar_inertia_kg_m2: f64,
        speed_rad_s: f64,
        radial_clearance_m: f64,
    ) -> Self {
        Self {
            mass_kg,
            polar_inertia_kg_m2,
            speed_rad_s,
            radial_clearance_m,
            eccentricity_m: 0.0,
            eccentricity_phase_rad: 0.0,
            friction_law: FrictionModel::Smooth,
            friction: FrictionParameters::smooth(0.15, 0.05),
            contact_stiffness_n_mp: 1e9,
            contact_exponent: 1.0,
            contact_damping_s_m: 0.3,
            x_m: 0.0,
            y_m: 0.0,
            vx_m_s: 0.0,
            vy_m_s: 0.0,
            drive_torque_n_m: 0.0,
            clearance_limit_m: None,
            shaft: Shaft::Horizontal,
            axial_clearance_m: None,
            shoulder_radius_m: None,
            axial_load_n: 0.0,
            z_m: 0.0,
            vz_m_s: 0.0,
        }
    }

    /// Whether the rotor turns, or a drive turns it.
    pub(crate) fn turns(&self) -> bool {
        self.speed_rad_s != 0.0 || self.drive_torque_n_m != 0.0
    }

    /// Centre of the journal at the start: zg − ε·e^(iφ).
    pub(crate) fn journal_start_m(&self) -> [f64; 2] {
        self.journal_m([self.x_m, self.y_m], 0.0)
    }

    /// Centre of the journal, m, once the rotor has turned by `angle_rad` and its mass centre is
    /// at `centre_m`.
    pub fn journal_m(&self, centre_m: [f64; 2], angle_rad: f64) -> [f64; 2] {
        let (sin, cos) = (angle_rad + self.eccentricity_phase_rad).sin_cos();
        [
            centre_m[0] - self.eccentricity_m * cos,
            centre_m[1] - self.eccentricity_m * sin,
        ]
    }

    /// Turns the mass centre to an angle at the start: the magnets held the centre of the journal,
    /// wherever the mass centre is.
    pub(crate) fn turn_eccentricity(&mut self, phase_rad: f64) {
        let journal = self.journal_start_m();
        self.eccentricity_phase_rad = phase_rad;
        let now = self.journal_start_m();
        self.x_m += journal[0] - now[0];
        self.y_m += journal[1] - now[1];
    }

    /// Checks the values against each other and against bore and groove of the inner ring.
    pub(crate) fn check(&self, bore_radius_m: f64, groove_radius_m: f64) -> Result<(), InputError> {
        positive("rotor_mass_kg", self.mass_kg)?;
        positive("rotor_polar_inertia_kg_m2", self.polar_inertia_kg_m2)?;
        finite("rotor_speed_rad_s", self.speed_rad_s)?;
        positive("radial_clearance_m", self.radial_clearance_m)?;
        let in_bore = Allowed::Below(bore_radius_m, "the radius of the bore");
        in_bore
            .clone()
            .check("radial_clearance_m", self.radial_clearance_m)?;
        not_negative("eccentricity_m", self.eccentricity_m)?;
        in_bore.check("eccentricity_m", self.eccentricity_m)?;
        finite("eccentricity_phase_rad", self.eccentricity_phase_rad)?;
        self.friction_law
            .check(&self.friction, ContactKind::Rotor)?;
        positive("contact_stiffness_n_mp", self.contact_stiffness_n_mp)?;
        let [least, most] = CONTACT_EXPONENTS;
        let exponent = self.contact_exponent;
        let rule = format!("from {least} (conformal) to {most} (Hertz)");
        let kept = (least..=most).contains(&exponent);
        require("contact_exponent", exponent, kept, rule)?;
        not_negative("contact_damping_s_m", self.contact_damping_s_m)?;
        for (field, value) in [
            ("rotor_x_m", self.x_m),
            ("rotor_y_m", self.y_m),
            ("rotor_vx_m_s", self.vx_m_s),
            ("rotor_vy_m_s", self.vy_m_s),
            ("drive_torque_n_m", self.drive_torque_n_m),
            ("rotor_axial_load_n", self.axial_load_n),
            ("rotor_z_m", self.z_m),
            ("rotor_vz_m_s", self.vz_m_s),
        ] {
            finite(field, value)?;
        }
        self.check_shoulders(bore_radius_m, groove_radius_m)?;
        if let Some(limit_m) = self.clearance_limit_m {
            positive("rotor_clearance_limit_m", limit_m)?;
        }
        let [x, y] = self.journal_start_m();
        let off = x.hypot(y);
        if off > self.radial_clearance_m {
            let (field, value) = if self.x_m.abs() > self.y_m.abs() {
                ("rotor_x_m", self.x_m)
            } else if self.y_m != 0.0 {
                ("rotor_y_m", self.y_m)
            } else {
                ("eccentricity_m", self.eccentricity_m)
            };
            let what = "the distance of the journal from the centre of the inner ring, which the touch-down \
                        clearance limits,";
            let allowed = Allowed::Reaching(what, off, self.radial_clearance_m);
            return Err(InputError::new(field, value, allowed));
        }
        Ok(())
    }
}

impl Rotor {
    /// The first field that takes the rotor out of the plane of the bearing, with its value.
    pub(crate) fn spatial_field(&self) -> Option<(&'static str, f64)> {
        let vertical = self.shaft == Shaft::Vertical;
        let mut fields = [
            ("shaft", f64::NAN, vertical),
            (
                "axial_clearance_m",
                self.axial_clearance_m.unwrap_or(0.0),
                self.axial_clearance_m.is_some(),
            ),
            (
                "rotor_axial_load_n",
                self.axial_load_n,
                self.axial_load_n != 0.0,
            ),
            ("rotor_z_m", self.z_m, self.z_m != 0.0),
            ("rotor_vz_m_s", self.vz_m_s, self.vz_m_s != 0.0),
        ]
        .into_iter();
        let found = fields.find(|(_, _, given)| *given);
        found.map(|(field, value, _)| (field, value))
    }

    /// Checks what holds the rotor along its axis.
    fn check_shoulders(&self, bore_radius_m: f64, groove_radius_m: f64) -> Result<(), InputError> {
        if let Some(radius_m) = self.shoulder_radius_m {
            let why = "the face of the inner ring lies between its bore and its raceway";
            let bounds = bore_radius_m..=groove_radius_m;
            from_to("shoulder_radius_m", radius_m, bounds, why)?;
        }
        let Some(clearance_m) = self.axial_clearance_m else {
            let falls = [
                (
                    "axial_clearance_m",
                    f64::NAN,
                    self.shaft == Shaft::Vertical,
                    "given: the shoulder of a vertical rotor is what the bearing catches",
                ),
                (
                    "rotor_axial_load_n",
                    self.axial_load_n,
                    self.axial_load_n != 0.0,
                    "0, or with an axial_clearance_um: nothing else holds the rotor along its axis",
                ),
                (
                    "rotor_z_m",
                    self.z_m,
                    self.z_m != 0.0,
                    "0, or with an axial_clearance_um: nothing else holds the rotor along its axis",
                ),
                (
                    "rotor_vz_m_s",
                    self.vz_m_s,
                    self.vz_m_s != 0.0,
                    "0, or with an axial_clearance_um: nothing else holds the rotor along its axis",
                ),
                (
                    "shoulder_radius_m",
                    self.shoulder_radius_m.unwrap_or(0.0),
                    self.shoulder_radius_m.is_some(),
                    "left out, or given with an axial_clearance_um",
                ),
            ];
            let wrong = falls.into_iter().find(|(_, _, wrong, _)| *wrong);
            return wrong.map_or(Ok(()), |(field, value, _, rule)| {
                Err(InputError::rule(field, value, rule))
            });
        };
        positive("axial_clearance_m", clearance_m)?;
        let why = "the magnets held the rotor within its axial clearance";
        from_to("rotor_z_m", self.z_m, -clearance_m..=clearance_m, why)
    }
}

impl Support {
    pub(crate) fn check(&self) -> Result<(), InputError> {
        positive("support_mass_kg", self.mass_kg)?;
        positive("support_stiffness_n_m", self.stiffness_n_m)?;
        not_negative("support_damping_n_s_m", self.damping_n_s_m)?;
        if let Some(stop) = self.stop {
            positive("stop_gap_m", stop.gap_m)?;
            positive("stop_stiffness_n_m", stop.stiffness_n_m)?;
        }
        Ok(())
    }
}
