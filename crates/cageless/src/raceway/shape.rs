//! Shapes of a discrete raceway: the angle of its flanks along it.
//!
//! Every shape is one function αc(ψ), the angle of the flanks from the radial direction at the
//! place ψ of a ball from the middle of the raceway. It is even, largest in the middle and 0 at the
//! ends ±θ; r = Rw cos αc. The span lC of a raceway says how large it is in the middle,
//! sin αc(0) = lC/(2 Rw).

use super::contact_path::ContactPath;
use super::flank_angle::FlankAngle;
use super::measured_flanks::MeasuredFlanks;
use super::power_angle::PowerAngle;
use super::steady_angle::SteadyAngle;
use crate::bearing::Bearing;
use crate::error::InputError;

/// Angle of the flanks along a discrete raceway.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RacewayShape {
    /// The contact path is quartic, y = a x⁴ + b x² + c, and runs into the plain raceway along its
    /// circumference (Zhao 2022, Eq. (4) to (7)).
    #[default]
    Quartic,
    /// αc = α0 √(1 − (ψ/θ)²): the contact points lie nearly on an ellipse, which meets the plain
    /// raceway at a right angle.
    Ellipse,
    /// αc = α0 (1 − (ψ/θ)²): a shuttle of two parabolas with pointed ends.
    Shuttle,
    /// ln Ω of a rolling ball falls and rises at a constant rate but for a rounded middle and the ends:
    /// friction is asked for evenly.
    Steady,
    /// Fitted to the points of a ring that has been measured, [`RacewayForm::measured`].
    Measured,
}

impl RacewayShape {
    /// Name of each.
    pub const NAMES: &'static [(&'static str, Self)] = &[
        ("quartic", Self::Quartic),
        ("ellipse", Self::Ellipse),
        ("shuttle", Self::Shuttle),
        ("steady", Self::Steady),
        ("measured", Self::Measured),
    ];

    /// Its name.
    pub fn name(self) -> &'static str {
        let named = Self::NAMES.iter().find(|(_, shape)| *shape == self);
        named.map_or("", |(name, _)| name)
    }
}

/// Shape of a discrete raceway and of its ends.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RacewayForm {
    /// Angle of the flanks along the raceway.
    pub shape: RacewayShape,
    /// The shape of a measured ring, stretched to the lC and θ of the raceway; of
    /// [`RacewayShape::Measured`] alone.
    pub measured: Option<MeasuredFlanks>,
    /// Length of the blend before each end along the bottom of the groove, m; 0 leaves the end as the
    /// shape has it.
    pub blend_m: f64,
}

impl RacewayForm {
    /// The flanks of a raceway of span lC and half angle θ.
    pub(super) fn flank_angle(
        &self,
        axial_span_m: f64,
        half_angle_rad: f64,
        bearing: &Bearing,
    ) -> Result<FlankAngle, InputError> {
        let middle = (axial_span_m / (2.0 * bearing.ball_radius_m())).asin();
        let power = |exponent| FlankAngle::Power(PowerAngle::new(middle, half_angle_rad, exponent));
        let refused = |rule: &str| Err(InputError::rule("measured", f64::NAN, rule));
        Ok(match (self.shape, &self.measured) {
            (RacewayShape::Measured, Some(measured)) => {
                FlankAngle::Power(measured.scaled(middle, half_angle_rad))
            }
            (RacewayShape::Measured, None) => {
                return refused("given with shape = \"measured\"");
            }
            (_, Some(_)) => return refused("left out, or shape = \"measured\""),
            (RacewayShape::Quartic, None) => {
                FlankAngle::Quartic(ContactPath::new(axial_span_m, half_angle_rad, bearing)?)
            }
            (RacewayShape::Ellipse, None) => power(0.5),
            (RacewayShape::Shuttle, None) => power(1.0),
            (RacewayShape::Steady, None) => {
                FlankAngle::Steady(SteadyAngle::new(middle, half_angle_rad))
            }
        })
    }
}
