//! Shapes of a discrete raceway: the angle of its flanks along it.
//!
//! Every shape is one function αc(ψ), the angle of the flanks from the radial direction at the
//! place ψ of a ball from the middle of the raceway. It is even, largest in the middle and 0 at the
//! ends ±θ; r = Rw cos αc. The span lC of a raceway says how large it is in the middle,
//! sin αc(0) = lC/(2 Rw).

mod ellipse;
mod measured;
mod quartic;
mod shuttle;
mod slot;
mod spline;
mod steady_angle;

use super::flank_angle::Flanks;
use super::outline::Outline;
use super::{Ends, MeasuredFlanks, SplineFlanks};
use crate::bearing::Bearing;
use crate::error::InputError;

/// Declares the list of shapes and what follows from it: the name of each in files, its module with
/// the function `flanks`, what it is in the description of the key.
macro_rules! raceway_shapes {
    ($($(#[$meta:meta])* $shape:ident = $name:literal, $module:ident, $description:literal;)*) => {
        /// Angle of the flanks along a discrete raceway.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
        pub enum RacewayShape {
            $($(#[$meta])* $shape,)*
        }

        impl RacewayShape {
            /// Name of each.
            pub const NAMES: &'static [(&'static str, Self)] = &[$(($name, Self::$shape)),*];

            /// Description of all, for the key of the case file.
            pub const DESCRIPTION: &'static str = concat!(
                "angle of the flanks along the raceway; ",
                $("\"", $name, "\": ", $description, ", ",)*
                "all but the first only in \"physical\""
            );

            fn flanks(self, outline: &Outline<'_>) -> Result<Flanks, InputError> {
                match self { $(Self::$shape => $module::flanks(outline),)* }
            }
        }
    };
}

raceway_shapes! {
    /// The contact path is quartic, y = a x⁴ + b x² + c, and runs into the plain raceway along its
    /// circumference (Zhao 2022, Eq. (4) to (7)).
    #[default]
    Quartic = "quartic", quartic, "contact path of Zhao 2022";
    /// αc = α0 √(1 − (ψ/θ)²): the contact points lie nearly on an ellipse, which meets the plain
    /// raceway at a right angle.
    Ellipse = "ellipse", ellipse, "α0 √(1 − (ψ/θ)²)";
    /// αc = α0 (1 − (ψ/θ)²): a shuttle of two parabolas with pointed ends.
    Shuttle = "shuttle", shuttle, "α0 (1 − (ψ/θ)²)";
    /// ln Ω of a rolling ball falls and rises at a constant rate but for a rounded middle and the ends:
    /// friction is asked for evenly.
    Steady = "steady", steady_angle, "orbital speed that changes at a constant rate";
    /// Fitted to the points of a ring that has been measured, [`RacewayForm::measured`].
    Measured = "measured", measured, "fitted to the profile";
    /// A spline through given angles.
    Spline = "spline", spline, "a spline through the rows of the profile";
    /// Balls roll on the two rounded edges of a slot, [`RacewayForm::edge_radius_m`], see [`super::Slot`].
    Slot = "slot", slot, "of a ball on the edges of a slot";
}

impl RacewayShape {
    /// Shapes defined by lC and θ alone.
    pub fn by_dimensions() -> impl Iterator<Item = Self> {
        let all = Self::NAMES.iter().map(|&(_, shape)| shape);
        all.filter(|shape| !matches!(shape, Self::Measured | Self::Spline | Self::Slot))
    }

    /// Name of the shape.
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
    /// The spline, stretched to the lC and θ of the raceway; of [`RacewayShape::Spline`] alone.
    pub(crate) spline: Option<SplineFlanks>,
    /// Ends of the raceway; a slot and a measured raceway have their own.
    pub ends: Ends,
    /// How much deeper a ball in the middle sits than on the plain raceway, along the axis of the
    /// section, m; the depth runs out to nothing at the ends, as `Raceway::depth_at_m`.
    pub depth_m: f64,
    /// re, radius of the rounded edges of a slot, m; of [`RacewayShape::Slot`] alone, else 0.
    pub edge_radius_m: f64,
    /// Depth of the floor of a slot below the bottom of the plain groove, m; `None` for
    /// 2 re and the sink of a ball in the middle.
    pub slot_depth_m: Option<f64>,
}

impl RacewayForm {
    /// The form with the rows of ψ and αc, in rad, that its shape needs.
    ///
    /// # Errors
    /// An [`InputError`] of `profile` if the shape needs none, or as [`MeasuredFlanks::fit`] and
    /// `SplineFlanks::through`.
    pub fn with_profile(self, rows: &[[f64; 2]]) -> Result<Self, InputError> {
        match self.shape {
            RacewayShape::Measured => Ok(Self {
                measured: Some(MeasuredFlanks::fit(rows)?),
                ..self
            }),
            RacewayShape::Spline => Ok(Self {
                spline: Some(SplineFlanks::through(rows)?),
                ..self
            }),
            _ => Err(no_profile()),
        }
    }

    /// Another shape that needs no profile, with these ends and depth, or a slot with edges of this radius, which has
    /// its own.
    #[must_use]
    pub fn reshaped(self, shape: RacewayShape, edge_radius_m: f64) -> Self {
        let plain = Self {
            shape,
            ..Self::default()
        };
        match shape {
            RacewayShape::Slot => Self {
                edge_radius_m,
                ..plain
            },
            _ => Self {
                ends: self.ends,
                depth_m: self.depth_m,
                ..plain
            },
        }
    }

    /// θ of a raceway of this span that is nothing but its two ends: blends, or half circles of a slot.
    pub(crate) fn half_angle_min_rad(&self, bearing: &Bearing, axial_span_m: f64) -> f64 {
        let d = bearing.dimensions();
        let sin = axial_span_m / (2.0 * d.ball_radius_m);
        let ends_m = match self.shape {
            RacewayShape::Slot => (d.ball_radius_m + self.edge_radius_m) * sin,
            // A machined end takes a part of the raceway, however short that is.
            _ => 2.0 * self.ends.blend_m(0.0),
        };
        ends_m / d.outer_groove_bottom_radius_m
    }

    /// α0 and θ of its profile.
    pub fn profile_rad(&self) -> Option<[f64; 2]> {
        let measured = self.measured.map(|m| [m.middle_rad(), m.half_angle_rad()]);
        let spline = self.spline.map(|s| [s.middle_rad(), s.half_angle_rad()]);
        measured.or(spline)
    }

    /// The flanks of the form in an outline, which has its profile.
    ///
    /// # Errors
    /// An [`InputError`] if the bearing cannot carry them or the form has what is not its shape's.
    pub(super) fn flanks(&self, outline: &Outline<'_>) -> Result<Flanks, InputError> {
        let other = (self.measured.is_some() && self.shape != RacewayShape::Measured)
            || (self.spline.is_some() && self.shape != RacewayShape::Spline);
        if other {
            return Err(no_profile());
        }
        if (self.edge_radius_m != 0.0) != (self.shape == RacewayShape::Slot) {
            let rule = "above 0 with shape = \"slot\", and left out with any other";
            let given = Some(self.edge_radius_m).filter(|radius| *radius != 0.0);
            let given = given.unwrap_or(f64::NAN);
            return Err(InputError::rule("edge_radius_m", given, rule));
        }
        if let Some(depth_m) = self.slot_depth_m.filter(|_| self.edge_radius_m == 0.0) {
            let rule = "left out with any shape but \"slot\"";
            return Err(InputError::rule("slot_depth_m", depth_m, rule));
        }
        self.shape.flanks(outline)
    }
}

/// A profile with a shape that has none.
fn no_profile() -> InputError {
    let rule = "left out, or shape = \"measured\" or \"spline\"";
    InputError::rule("profile", f64::NAN, rule)
}
