//! A slot milled through the bottom of the groove, on whose two rounded edges the balls roll.
//!
//! In the section at ψ an edge is an arc of radius re whose centre lies in the material, Re + re from
//! the centre of the groove's arc and ze from the middle plane. A ball of radius Rw on both edges has
//!
//!   ze = (Rw + re) sin αc,   s = √((Re + re)² − ze²) − (Rw + re) cos αc − (Re − Rw),
//!
//! s how far it sinks below its place on the plain raceway. An end mill leaves ends that are half
//! circles: from the middle of its last position on, ze² falls as t = 1 − (x/ρ)² with the distance x
//! along the bottom and ρ = ze in the middle. Over them the edges merge with the groove: with
//! σ = t² (3 − 2t) the difference of curvatures of ball and ring across the groove, Σ = 1/Rw − κ, goes
//! from that of the groove to that of the edge as Σ₀^(1−σ) Σ₁^σ, and two contacts that share a ball as
//! one become two of their own, with 1/s = (1 − σ)(−ln cos αc/ln 2) + ⅖ σ.
//!
//! √t rises from the end at a right angle. A contact has a length, over which it meets the end: over the
//! last [`CONTACT_SHARE`] Rw √t runs out as a [`Blend`].

use std::f64::consts::LN_2;

use super::RacewayForm;
use super::blend::{Blend, CONTACT_SHARE};
use super::flank_angle::FlankAngle;
use super::outline::Outline;
use crate::bearing::Bearing;
use crate::contact::hertz::PointContact;
use crate::error::{Allowed, InputError};
use crate::numerics::chebyshev::Polynomial;

/// Error of the logarithms of stiffness and semi-axis.
const HERTZ_TOLERANCE: f64 = 1e-13;
/// Longest run-out over the length of an end.
const RUN_OUT_MAX: f64 = 0.5;
/// Least t at which slopes over ψ are taken: that of αc has no limit at the ends.
const SHARE_MIN: f64 = 1e-12;

/// ze² over that of the middle, along a slot with the ends of an end mill.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SlotPlan {
    /// θ.
    half_angle_rad: f64,
    /// ρ/Ro.
    end_rad: f64,
    /// sin α0.
    middle_sine: f64,
}

impl SlotPlan {
    /// Plan of a slot with the edge radius of the outline.
    ///
    /// # Errors
    /// An [`InputError`] if the edges leave no slot between them, reach beyond the shoulders or
    /// the slot is shorter than wide.
    pub(super) fn new(outline: &Outline<'_>) -> Result<Self, InputError> {
        let edge = outline.edge_radius_m;
        let d = outline.bearing.dimensions();
        let (rw, re) = (d.ball_radius_m, d.outer_groove_curvature_radius_m);
        let middle_sine = outline.middle_rad().sin();
        let most = rw * middle_sine / (1.0 - middle_sine);
        let why = "with a larger edge nothing is left of the slot of this axial span lC";
        Allowed::Between(0.0, most, why).check("edge_radius_m", edge)?;
        let half_width = (rw + edge) * middle_sine;
        let [_, shoulder] = outline.bearing.shoulder_angles_rad();
        let widest = 2.0 * rw * (re + edge) * shoulder.sin() / (rw + edge);
        let why = "the edges of the slot must lie within the shoulders";
        Allowed::Below(widest, why).check("axial_span_m", outline.axial_span_m)?;
        let end_rad = half_width / d.outer_groove_bottom_radius_m;
        let why = "the two ends of the slot alone take up as much";
        Allowed::AtLeast(end_rad, why).check("half_angle_rad", outline.half_angle_rad)?;
        Ok(Self {
            half_angle_rad: outline.half_angle_rad,
            end_rad,
            middle_sine,
        })
    }

    /// t and dt/dψ at local ψ.
    fn share(&self, local_angle_rad: f64) -> [f64; 2] {
        let left = (self.half_angle_rad - local_angle_rad.abs()).max(0.0) / self.end_rad;
        if left >= 1.0 {
            return [1.0, 0.0];
        }
        let slope = -2.0 * (1.0 - left) / self.end_rad * local_angle_rad.signum();
        [left * (2.0 - left), slope]
    }

    /// √t and its slope over ψ at local ψ.
    fn root(&self, local_angle_rad: f64) -> [f64; 2] {
        let [share, slope] = self.share(local_angle_rad);
        [share.sqrt(), slope / (2.0 * share.max(SHARE_MIN).sqrt())]
    }

    /// √t over the last stretch before the ends, as the contact of a nominal ball meets it.
    fn met_end(&self, bearing: &Bearing) -> Blend {
        let d = bearing.dimensions();
        let contact_rad = CONTACT_SHARE * d.ball_radius_m / d.outer_groove_bottom_radius_m;
        let length_rad = contact_rad.min(RUN_OUT_MAX * self.end_rad);
        Blend::over(|local| self.root(local), self.half_angle_rad, length_rad)
    }
}

impl FlankAngle for SlotPlan {
    fn at(&self, local_angle_rad: f64) -> [f64; 2] {
        let [root, slope] = self.root(local_angle_rad);
        let angle = (self.middle_sine * root).asin();
        [angle, self.middle_sine * slope / angle.cos()]
    }

    /// With sin² αc = sin² α0 t: sin² α0 t′/(2 cos αc).
    fn sine_slope(&self, local_angle_rad: f64) -> f64 {
        let [share, slope] = self.share(local_angle_rad);
        let angle = (self.middle_sine * share.sqrt()).asin();
        self.middle_sine.powi(2) * slope / (2.0 * angle.cos())
    }

    fn ends_at_right_angle(&self) -> bool {
        true
    }

    fn junctions_rad(&self) -> Vec<f64> {
        let straight = self.half_angle_rad - self.end_rad;
        if straight > 0.0 {
            vec![straight]
        } else {
            vec![]
        }
    }

    fn order(&self) -> f64 {
        0.5
    }

    fn regular(&self, square: f64, end: f64) -> f64 {
        self.at(square.sqrt().asin())[0] / (end - square).sqrt()
    }
}

/// A slot in the outer ring of a given bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct Slot {
    plan: SlotPlan,
    /// √t over the last stretch before the ends, as a contact meets it.
    met_end: Blend,
    /// Rw.
    ball_radius_m: f64,
    /// Ro.
    groove_bottom_radius_m: f64,
    /// Re.
    groove_curvature_radius_m: f64,
    /// re.
    pub edge_radius_m: f64,
    /// D, depth of the floor below the bottom of the plain groove, m.
    pub depth_m: f64,
    /// ln of K over t, with K over that of the plain groove.
    stiffness: Polynomial,
    /// ln of a/√δ over t, with a over that of the plain groove at the same δ.
    half_length: Polynomial,
    /// ln of the pressure under the same force over t, over that in the plain groove.
    pressure: Polynomial,
}

/// The edges of a slot at the ψ of a ball; of two numbers the second is the slope over ψ.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlotSection {
    /// αc.
    pub angle_rad: [f64; 2],
    /// How far a ball on both edges sinks below its place on the plain raceway, m.
    pub sink_m: [f64; 2],
    /// κg = κ/(1 − κ Rw), curvature of the line along which a ball's centre follows an edge, 1/m:
    /// 1/(Re − Rw) at the groove, −1/(Rw + re) at the edge.
    pub centre_curvature_per_m: [f64; 2],
    /// 1/s of the law of both contacts.
    pub inverse_exponent: [f64; 2],
    /// K of a contact over that of the plain groove.
    pub stiffness_ratio: [f64; 2],
    /// a/√δ of a contact, a its semi-axis across the groove, over that of the plain groove.
    pub half_length_ratio: f64,
    /// κ less that of the plain groove, 1/m.
    pub curvature_change_per_m: f64,
    /// σ, 0 in the groove, 1 at the edge.
    pub merged: f64,
}

impl Slot {
    /// Edges of a plan, above a floor of the form's depth, or of 2 re + s.
    ///
    /// # Errors
    /// An [`InputError`] if a ball that sinks by s is less than re above the floor.
    pub(super) fn new(
        plan: SlotPlan,
        form: &RacewayForm,
        bearing: &Bearing,
    ) -> Result<Self, InputError> {
        let d = bearing.dimensions();
        let edge_radius_m = form.edge_radius_m;
        let empty = Polynomial::fit(|_| 0.0, 0.0, 1.0, 1.0);
        let mut slot = Self {
            met_end: plan.met_end(bearing),
            plan,
            ball_radius_m: d.ball_radius_m,
            groove_bottom_radius_m: d.outer_groove_bottom_radius_m,
            groove_curvature_radius_m: d.outer_groove_curvature_radius_m,
            edge_radius_m,
            depth_m: 0.0,
            stiffness: empty.clone(),
            half_length: empty.clone(),
            pressure: empty,
        };
        let over_plain = |of: &dyn Fn(&PointContact) -> f64| {
            let plain = of(&slot.contact_of(0.0, bearing));
            let ratio = |share: f64| (of(&slot.contact_of(share, bearing)) / plain).ln();
            Polynomial::fit(ratio, 0.0, 1.0, HERTZ_TOLERANCE)
        };
        let stiffness = over_plain(&|contact| contact.stiffness_n_m1_5);
        let half_length = over_plain(&|c| c.semi_axes_m(1.0)[1] * c.stiffness_n_m1_5.cbrt());
        let pressure = over_plain(&|contact| contact.peak_pressure_pa(1.0));
        (slot.stiffness, slot.half_length, slot.pressure) = (stiffness, half_length, pressure);
        let least = edge_radius_m + slot.sink_m(1.0)[0];
        slot.depth_m = form.slot_depth_m.unwrap_or(least + edge_radius_m);
        let why = "a ball that rests on the edges stays their radius above the floor, more than a load \
                   presses it in";
        Allowed::AtLeast(least, why).check("slot_depth_m", slot.depth_m)?;
        Ok(slot)
    }

    /// √t over the last stretch before the ends.
    pub(super) fn met_end(&self) -> &Blend {
        &self.met_end
    }

    /// Width of the slot in its middle between the walls below the edges, m.
    pub fn width_m(&self) -> f64 {
        2.0 * (self.half_span_m() - self.edge_radius_m)
    }

    /// Ro.
    pub(crate) fn groove_bottom_radius_m(&self) -> f64 {
        self.groove_bottom_radius_m
    }

    /// ze in the middle, and ρ of the ends.
    pub(crate) fn half_span_m(&self) -> f64 {
        self.reach_m() * self.plan.middle_sine
    }

    /// Local ψ of the last place at full width.
    pub(crate) fn straight_rad(&self) -> f64 {
        (self.plan.half_angle_rad - self.plan.end_rad).max(0.0)
    }

    /// Rw + re.
    fn reach_m(&self) -> f64 {
        self.ball_radius_m + self.edge_radius_m
    }

    /// σ and dσ/dt.
    fn merged(share: f64) -> [f64; 2] {
        let slope = 6.0 * share * (1.0 - share);
        [share * share * (3.0 - 2.0 * share), slope]
    }

    /// Σ and ln(Σ₁/Σ₀).
    fn curvature_sum_per_m(&self, share: f64) -> [f64; 2] {
        let of_ball = 1.0 / self.ball_radius_m;
        let groove = of_ball - 1.0 / self.groove_curvature_radius_m;
        let growth = ((of_ball + 1.0 / self.edge_radius_m) / groove).ln();
        let [merged, _] = Self::merged(share);
        [groove * (merged * growth).exp(), growth]
    }

    /// s and ds/dt.
    fn sink_m(&self, share: f64) -> [f64; 2] {
        let (reach, other) = (
            self.reach_m(),
            self.groove_curvature_radius_m + self.edge_radius_m,
        );
        let square = self.plan.middle_sine.powi(2);
        let cos = (1.0 - square * share).sqrt();
        let edge_square = reach * reach * square * share;
        let behind = (other * other - edge_square).sqrt();
        [
            reach * square * share / (1.0 + cos) - edge_square / (other + behind),
            0.5 * reach * square * (1.0 / cos - reach / behind),
        ]
    }

    /// Curvatures of an edge along rolling and across where ze² has this share of the middle's, 1/m.
    fn edge_curvatures_per_m(&self, share: f64) -> [f64; 2] {
        let of_ball = 1.0 / self.ball_radius_m;
        let cos = (1.0 - self.plan.middle_sine.powi(2) * share).sqrt();
        let place =
            self.groove_bottom_radius_m - self.ball_radius_m * (1.0 - cos) + self.sink_m(share)[0];
        let across = self.curvature_sum_per_m(share)[0] - of_ball;
        [-cos / place, across]
    }

    /// Hertz's contact of a nominal ball at an edge where ze² has this share of the middle's.
    fn contact_of(&self, share: f64, bearing: &Bearing) -> PointContact {
        let of_ball = 1.0 / self.ball_radius_m;
        let materials = bearing.materials();
        PointContact::between(
            [of_ball; 2],
            self.edge_curvatures_per_m(share),
            [&materials.ball, &materials.ring],
        )
    }

    /// Curvatures of an edge along rolling and across at local ψ, 1/m.
    pub(crate) fn curvatures_at_per_m(&self, local_angle_rad: f64) -> [f64; 2] {
        let [root, _] = self.met_root(local_angle_rad);
        self.edge_curvatures_per_m(root * root)
    }

    /// Curvatures of an edge along rolling and across where σ has a value, 1/m.
    pub(crate) fn merged_curvatures_per_m(&self, merged: f64) -> [f64; 2] {
        // The root of t² (3 − 2t) = σ between 0 and 1.
        let share = 0.5 - ((1.0 - 2.0 * merged).clamp(-1.0, 1.0).asin() / 3.0).sin();
        self.edge_curvatures_per_m(share)
    }

    /// √t and its slope over ψ as a contact at local ψ meets it.
    fn met_root(&self, local_angle_rad: f64) -> [f64; 2] {
        match local_angle_rad.abs() < self.met_end.start_rad() {
            true => self.plan.root(local_angle_rad),
            false => self.met_end.value_and_slope(local_angle_rad),
        }
    }

    /// Hertz's contact of a nominal ball at one edge at local ψ.
    pub(crate) fn contact(&self, local_angle_rad: f64, bearing: &Bearing) -> PointContact {
        let [root, _] = self.met_root(local_angle_rad);
        self.contact_of(root * root, bearing)
    }

    /// Hertz's pressure at an edge at local ψ over that in the plain groove under the same force.
    pub(crate) fn pressure_ratio(&self, local_angle_rad: f64) -> f64 {
        let [root, _] = self.met_root(local_angle_rad);
        self.pressure.value(root * root).exp()
    }

    /// Angle from the axis of the section at which the plain groove runs into an edge at local ψ, about the centre of
    /// its arc.
    pub fn rim_rad(&self, local_angle_rad: f64) -> f64 {
        let across = self.half_span_m() * self.plan.share(local_angle_rad)[0].sqrt();
        (across / (self.groove_curvature_radius_m + self.edge_radius_m)).asin()
    }

    /// The edges at local ψ.
    pub(crate) fn at(&self, local_angle_rad: f64) -> SlotSection {
        let [root, root_slope] = self.met_root(local_angle_rad);
        let (share, rate) = (root * root, 2.0 * root * root_slope);
        let over_angle = |[value, slope]: [f64; 2]| [value, slope * rate];
        let angle = (self.plan.middle_sine * root).asin();
        let angle_rad = [angle, self.plan.middle_sine * root_slope / angle.cos()];
        let [merged, merging] = Self::merged(share);
        let [sum, growth] = self.curvature_sum_per_m(share);
        let of_ball = 1.0 / self.ball_radius_m;
        let centre = of_ball * of_ball / sum;
        let square = self.plan.middle_sine.powi(2);
        let cos_square = 1.0 - square * share;
        let joined = -0.5 * cos_square.ln() / LN_2;
        let joining = 0.5 * square / cos_square / LN_2;
        let [stiffness, stiffening] = self.stiffness.value_and_slope(share);
        let stiffness = stiffness.exp();
        SlotSection {
            angle_rad,
            sink_m: over_angle(self.sink_m(share)),
            centre_curvature_per_m: over_angle([centre - of_ball, -centre * growth * merging]),
            inverse_exponent: over_angle([
                (1.0 - merged) * joined + 0.4 * merged,
                (1.0 - merged) * joining + (0.4 - joined) * merging,
            ]),
            stiffness_ratio: over_angle([stiffness, stiffness * stiffening]),
            half_length_ratio: self.half_length.value(share).exp(),
            curvature_change_per_m: of_ball - 1.0 / self.groove_curvature_radius_m - sum,
            merged,
        }
    }
}
