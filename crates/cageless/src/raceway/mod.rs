//! The discrete raceway: contact path, effective contact radius and flank angle (Zhao 2022, Eq. (4) to (9)).
//!
//! In Eq. (4) to (8) the paper's Rm stands for Ro − Rw
//! (`Bearing::outer_orbit_radius_m`), so that the path ends on the plain raceway
//! at any clearance. Local coordinates have the middle of the raceway at −Y.
//!
//! ```
//! use cageless::reference;
//! use cageless::{Raceway, RacewayDimensions};
//!
//! # use cageless::Bearing;
//! let bearing = reference::bearing(); // Zhao 2022, Table 1
//!
//! let dimensions = RacewayDimensions {
//!     axial_span_m: 5.1e-3,
//!     half_angle_rad: 25.2_f64.to_radians(),
//!     centre_angle_rad: 0.0,
//! };
//! let raceway = Raceway::new(dimensions, &bearing)?;
//! // The effective contact radius is smallest in the middle: balls are slowest there.
//! assert!(raceway.effective_radius_m(0.0) < bearing.ball_radius_m());
//! # Ok::<(), cageless::InputError>(())
//! ```

mod blend;
mod contact_path;
mod flank_angle;
mod measured_flanks;
mod outline;
mod piece;
mod power_angle;
mod shape;
mod slot;
mod spline_flanks;

use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;

use crate::bearing::Bearing;
use crate::error::{Allowed, InputError};
use crate::limits::{from_to, not_negative, positive, require};
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::root;

pub use blend::Ends;
use blend::{Blend, CONTACT_SHARE};
pub(crate) use contact_path::ContactPath;
use flank_angle::Flanks;
pub use measured_flanks::MeasuredFlanks;
pub(crate) use measured_flanks::{Linearised, fit_flanks};
use outline::Outline;
pub(crate) use piece::Piece;
pub(crate) use power_angle::PowerAngle;
pub use shape::{RacewayForm, RacewayShape};
pub use slot::Slot;
use slot::SlotPlan;
pub(crate) use slot::SlotSection;
pub(crate) use spline_flanks::SplineFlanks;

/// How often a machined end is halved at most.
const HALVINGS: u32 = 4;
/// Longest run-out of an end at a right angle, over the half angle of the raceway.
const CONTACT_MAX: f64 = 0.25;

/// The three numbers that a discrete raceway of any shape has.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RacewayDimensions {
    /// lC, largest axial distance between the two contact points.
    pub axial_span_m: f64,
    /// θ, half the angle that the raceway takes up.
    pub half_angle_rad: f64,
    /// ψ of the raceway centre, rad.
    pub centre_angle_rad: f64,
}

/// A discrete raceway in the outer ring of a given bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct Raceway {
    dimensions: RacewayDimensions,
    /// Rw.
    ball_radius_m: f64,
    /// Ro.
    groove_bottom_radius_m: f64,
    /// Re.
    groove_curvature_radius_m: f64,
    form: RacewayForm,
    /// Length of the blends, m.
    blend_m: f64,
    /// The slot, if it is one.
    slot: Option<Slot>,
    /// Without blends, from the middle to the end.
    unblended: Vec<Piece>,
    /// From the middle to the end.
    pieces: Vec<Piece>,
    /// The last stretch before an end at a right angle, as a contact in space meets it.
    met_end: Option<Blend>,
    /// Depth error at the centre, m.
    depth_error_m: f64,
    /// αg by which the section is turned about the centre of the ball, rad.
    section_angle_rad: f64,
}

impl Raceway {
    /// Raceway of Zhao 2022: [`Self::formed`] with the quartic contact path, which ends in a kink.
    ///
    /// # Errors
    /// That of [`Self::formed`].
    pub fn new(dimensions: RacewayDimensions, bearing: &Bearing) -> Result<Self, InputError> {
        Self::formed(dimensions, RacewayForm::default(), bearing)
    }

    /// Raceway of a form; checks that the ring can carry it.
    ///
    /// # Errors
    /// An [`InputError`] if the span violates Zhao 2022, Eq. (8), a quartic path leaves the plain
    /// raceway outwards (Eq. (9)), an angle is out of range or the blend does not fit.
    pub fn formed(
        dimensions: RacewayDimensions,
        form: RacewayForm,
        bearing: &Bearing,
    ) -> Result<Self, InputError> {
        let RacewayDimensions {
            axial_span_m: span,
            half_angle_rad: theta,
            centre_angle_rad,
        } = dimensions;
        positive("axial_span_m", span)?;
        positive("half_angle_rad", theta)?;
        Allowed::Below(FRAC_PI_2, "").check("half_angle_rad", theta)?;
        from_to("centre_angle_rad", centre_angle_rad, -TAU..=TAU, "")?;
        let why = "the contact points must stay on the groove, Zhao 2022, Eq. (8)";
        Allowed::Below(axial_span_limit_m(bearing), why).check("axial_span_m", span)?;
        let d = bearing.dimensions();
        let outline = Outline {
            axial_span_m: span,
            half_angle_rad: theta,
            measured: form.measured,
            edge_radius_m: form.edge_radius_m,
            spline: form.spline,
            bearing,
        };
        let flanks = form.flanks(&outline)?;
        let slot = match form.shape {
            RacewayShape::Slot => {
                let plan = SlotPlan::new(&outline)?;
                Some(Slot::new(plan, &form, bearing)?)
            }
            _ => None,
        };
        let raceway = Self {
            dimensions,
            ball_radius_m: d.ball_radius_m,
            groove_bottom_radius_m: d.outer_groove_bottom_radius_m,
            groove_curvature_radius_m: d.outer_groove_curvature_radius_m,
            form,
            blend_m: 0.0,
            slot,
            unblended: Piece::all(&flanks, theta, d.ball_radius_m),
            pieces: vec![],
            met_end: None,
            depth_error_m: 0.0,
            section_angle_rad: 0.0,
        };
        raceway.with_ends(form.ends)?.with_depth(form.depth_m)
    }

    /// Raceway in whose middle a ball sits `depth_m` deeper than on the plain raceway, see
    /// [`Self::depth_at_m`]; 0: as far out, as in Zhao 2022.
    ///
    /// # Errors
    /// An [`InputError`] below 0 or beyond Re − Rw.
    pub(crate) fn with_depth(mut self, depth_m: f64) -> Result<Self, InputError> {
        let room = self.groove_curvature_radius_m - self.ball_radius_m;
        let why = "what the groove's curvature radius exceeds the ball's";
        from_to("depth_m", depth_m, 0.0..=room, why)?;
        self.check_no_slot("depth_m", depth_m)?;
        self.form.depth_m = depth_m;
        Ok(self)
    }

    /// Refuses what a slot has by its edges.
    fn check_no_slot(&self, field: &'static str, value_m: f64) -> Result<(), InputError> {
        let kept = self.slot.is_none() || value_m == 0.0;
        let rule = "0 with shape = \"slot\": depth and ends of a slot follow from its edges";
        require(field, value_m, kept, rule)
    }

    /// Raceway with its ends blended into the plain one within ±θ, or left as the shape has them.
    ///
    /// # Errors
    /// An [`InputError`] if the blend is too short or too long, or the flank angle would not fall
    /// steadily over it.
    pub(crate) fn with_ends(mut self, ends: Ends) -> Result<Self, InputError> {
        let theta = self.half_angle_rad();
        let own = self.slot.is_some() || self.form.shape == RacewayShape::Measured;
        let mut blend_m = match ends {
            Ends::Machined if own => 0.0,
            _ => ends.blend_m(theta * self.groove_bottom_radius_m),
        };
        not_negative("blend_m", blend_m)?;
        self.check_no_slot("blend_m", blend_m)?;
        let flanks = |local: f64| self.unblended_contact_angle_rad(local);
        if blend_m > 0.0 {
            let of = |blend_m| Blend::new(flanks, theta, blend_m, self.groove_bottom_radius_m);
            let mut blend = of(blend_m);
            // Where the angle would rise over it a machined end is shorter.
            for _ in 0..HALVINGS {
                if blend.is_err() && ends == Ends::Machined {
                    blend_m *= 0.5;
                    blend = of(blend_m);
                }
            }
            let blend = blend?;
            let end: Flanks = Arc::new(blend.clone());
            let piece = Piece::new(end, [blend.start_rad(), theta], self.ball_radius_m);
            (self.pieces, self.met_end) = (self.ending_with(piece), None);
        } else {
            let contact_rad = CONTACT_SHARE * self.ball_radius_m / self.groove_bottom_radius_m;
            let length_rad = contact_rad.min(CONTACT_MAX * theta);
            let meets = self.slot.is_none() && self.is_designed_at_right_angle();
            let end = meets.then(|| Blend::over(flanks, theta, length_rad));
            (self.pieces, self.met_end) = (self.unblended.clone(), end);
        }
        (self.form.ends, self.blend_m) = (ends, blend_m);
        Ok(self)
    }

    /// The pieces without blends, the last of which is this one.
    fn ending_with(&self, last: Piece) -> Vec<Piece> {
        let start = last.range_rad().start;
        let mut pieces = self.unblended.clone();
        pieces.retain(|piece| piece.range_rad().start < start);
        pieces.iter_mut().for_each(|piece| piece.end_at(start));
        pieces.push(last);
        pieces
    }

    /// Raceway with the depth error `depth_error_m` at its centre (positive: too deep; negative: not deep
    /// enough), measured along the normal of its flanks. The error runs out to nothing at the
    /// ends, as E (1 − sin²ψ/sin²θ)².
    ///
    /// # Errors
    /// An [`InputError`] beyond a tenth of Re − Rw: the ball would touch elsewhere.
    pub fn with_depth_error(mut self, depth_error_m: f64) -> Result<Self, InputError> {
        let most = self.depth_error_max_m();
        let why = "a tenth of what the groove's curvature radius exceeds the ball's";
        from_to("depth_error_m", depth_error_m, -most..=most, why)?;
        self.depth_error_m = depth_error_m;
        Ok(self)
    }

    /// Largest depth error that [`Self::with_depth_error`] takes, either way.
    pub fn depth_error_max_m(&self) -> f64 {
        0.1 * (self.groove_curvature_radius_m - self.ball_radius_m)
    }

    /// Depth error at the centre, m.
    pub fn depth_error_m(&self) -> f64 {
        self.depth_error_m
    }

    /// Share of the middle's depth at ψ, (1 − sin²ψ/sin²θ)², and its slope over ψ.
    pub(crate) fn depth_share(&self, angle_rad: f64) -> [f64; 2] {
        let (local, end) = (self.local_angle_rad(angle_rad), self.half_angle_rad());
        if local.abs() >= end {
            return [0.0; 2];
        }
        let left = 1.0 - (local.sin() / end.sin()).powi(2);
        let fall = -2.0 * local.sin() * local.cos() / end.sin().powi(2);
        [left.powi(2), 2.0 * left * fall]
    }

    /// Depth error at ψ, m.
    pub(crate) fn depth_error_at_m(&self, angle_rad: f64) -> f64 {
        self.depth_error_m * self.depth_share(angle_rad)[0]
    }

    /// How much deeper a ball sits at ψ than on the plain raceway, m, and the slope over ψ, m/rad; in a
    /// slot by how much it sinks.
    pub(crate) fn depth_at_m(&self, angle_rad: f64) -> [f64; 2] {
        if let Some(slot) = &self.slot {
            return slot.at(self.local_angle_rad(angle_rad)).sink_m;
        }
        self.depth_share(angle_rad)
            .map(|share| self.form.depth_m * share)
    }

    /// Whether balls of the nominal radius sit as far out as on the plain raceway.
    pub(crate) fn is_flush(&self) -> bool {
        self.depth_error_m == 0.0 && self.form.depth_m == 0.0 && self.slot.is_none()
    }

    /// Raceway whose section is turned about the centre of the ball by αg towards +Z, as a bearing
    /// of that contact angle needs it.
    ///
    /// # Errors
    /// An [`InputError`] if a flank reaches beyond the shoulder of the outer ring.
    pub fn with_section_angle(
        mut self,
        angle_rad: f64,
        bearing: &Bearing,
    ) -> Result<Self, InputError> {
        let [_, shoulder] = bearing.shoulder_angles_rad();
        let most = shoulder - self.contact_angle_rad(0.0)[0];
        if angle_rad != 0.0 {
            let why = "with a larger one a flank of the raceway reaches beyond the shoulder";
            Allowed::Between(-most, most, why).check("raceway_contact_angle_rad", angle_rad)?;
        }
        self.section_angle_rad = angle_rad;
        Ok(self)
    }

    /// αg by which the section is turned about the centre of the ball, rad.
    pub fn section_angle_rad(&self) -> f64 {
        self.section_angle_rad
    }

    /// lC, θ and position.
    pub fn dimensions(&self) -> &RacewayDimensions {
        &self.dimensions
    }

    /// θ.
    pub fn half_angle_rad(&self) -> f64 {
        self.dimensions.half_angle_rad
    }

    fn outer_orbit_radius_m(&self) -> f64 {
        self.groove_bottom_radius_m - self.ball_radius_m
    }

    /// ψ from the middle of the raceway, wrapped to [−π, π].
    pub(crate) fn local_angle_rad(&self, angle_rad: f64) -> f64 {
        wrap_angle_rad(angle_rad - self.dimensions.centre_angle_rad)
    }

    /// Whether a ball at ψ is inside the raceway.
    pub fn contains(&self, angle_rad: f64) -> bool {
        self.local_angle_rad(angle_rad).abs() < self.dimensions.half_angle_rad
    }

    /// r of a ball at ψ (Zhao 2022, Eq. (6)); Rw outside the raceway.
    pub fn effective_radius_m(&self, angle_rad: f64) -> f64 {
        let local = self.local_angle_rad(angle_rad);
        self.piece_at(local).map_or(self.ball_radius_m, |piece| {
            piece.radius().value(local.sin().powi(2))
        })
    }

    /// r at the contact point with abscissa x from the middle of the raceway (Zhao 2022, Eq. (6)).
    pub(crate) fn effective_radius_at_x_m(&self, x_m: f64) -> f64 {
        if let Some(path) = self.contact_path() {
            return path.effective_radius_at_x_m(x_m);
        }
        let centre = self.dimensions.centre_angle_rad;
        let radius = |local: f64| self.effective_radius_m(centre + local);
        let beyond = |local: f64| {
            let [depth, _] = self.depth_at_m(centre + local);
            (self.outer_orbit_radius_m() + depth + radius(local)) * local.sin()
        };
        let found = root::brent(|l| beyond(l) - x_m.abs(), 0.0, self.half_angle_rad(), 0.0);
        found.map_or(self.ball_radius_m, radius)
    }

    fn piece_at(&self, local_angle_rad: f64) -> Option<&Piece> {
        let local = local_angle_rad.abs();
        self.pieces.iter().find(|p| local < p.range_rad().end)
    }

    /// Stretches over which the flanks are smooth, from the middle to the end.
    pub(crate) fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// [`Self::pieces`] as contacts in space meet them: an end at a right angle runs out over
    /// [`CONTACT_SHARE`] Rw, half the length of a contact.
    pub(crate) fn met_pieces(&self) -> Vec<Piece> {
        let Some(end) = self.met_end() else {
            return self.pieces.clone();
        };
        let range_rad = [end.start_rad(), self.half_angle_rad()];
        let flanks: Flanks = match &self.slot {
            // The slot itself has them.
            Some(_) => self.unblended[self.unblended.len() - 1].shared_flanks(),
            None => Arc::new(end.clone()),
        };
        self.ending_with(Piece::new(flanks, range_rad, self.ball_radius_m))
    }

    /// The last stretch before an end at a right angle, as contacts in space meet it.
    fn met_end(&self) -> Option<&Blend> {
        let of_slot = self.slot.as_ref().map(Slot::met_end);
        of_slot.or(self.met_end.as_ref())
    }

    /// αc at local ψ within ±θ as contacts in space meet it, see [`Self::met_pieces`].
    pub(crate) fn met_angle_rad(&self, local_angle_rad: f64) -> f64 {
        let met = self.met_end.as_ref();
        match met.filter(|end| local_angle_rad.abs() >= end.start_rad()) {
            Some(end) => end.value_and_slope(local_angle_rad)[0],
            None => self.contact_angle_rad(local_angle_rad)[0],
        }
    }

    /// Length along the bottom of the groove over which the flanks run out before an end, as contacts in
    /// space meet it, m; `None` of an end with a kink, whose slope is finite.
    pub(crate) fn run_out_m(&self) -> Option<f64> {
        let of =
            |end: &Blend| (self.half_angle_rad() - end.start_rad()) * self.groove_bottom_radius_m;
        let met = self
            .slot
            .as_ref()
            .map(Slot::met_end)
            .or(self.met_end.as_ref());
        met.map(of)
            .or(Some(self.blend_m).filter(|blend_m| *blend_m > 0.0))
    }

    /// The quartic contact path of Zhao 2022 if this is the raceway's own, up to its ends.
    pub(crate) fn contact_path(&self) -> Option<&ContactPath> {
        match self.pieces.as_slice() {
            [piece] => piece.flanks().contact_path(),
            _ => None,
        }
    }

    /// αc, the angle of the flanks at local ψ within ±θ (cos αc = r/Rw, from the radial direction,
    /// branch z > 0), and dαc/dψ: what defines the raceway. At the ends the slope is the limit from
    /// within; without blends it is not 0 there, which is the kink.
    pub fn contact_angle_rad(&self, local_angle_rad: f64) -> [f64; 2] {
        self.piece_up_to(local_angle_rad)
            .flanks()
            .at(local_angle_rad)
    }

    /// The piece that reaches to local ψ, its end included.
    fn piece_up_to(&self, local_angle_rad: f64) -> &Piece {
        let local = local_angle_rad.abs();
        let found = self.pieces.iter().find(|p| local <= p.range_rad().end);
        found.unwrap_or(&self.pieces[self.pieces.len() - 1])
    }

    /// sin αc dαc/dψ at local ψ within ±θ; at the ends the limit from within, which is finite there also where
    /// the flanks meet the plain raceway at a right angle.
    pub(crate) fn contact_angle_sine_slope(&self, local_angle_rad: f64) -> f64 {
        self.piece_up_to(local_angle_rad)
            .flanks()
            .sine_slope(local_angle_rad)
    }

    /// Whether the flanks without their blends meet the plain raceway at a right angle.
    pub fn is_designed_at_right_angle(&self) -> bool {
        self.unblended[0].flanks().ends_at_right_angle()
    }

    /// [`Self::contact_angle_rad`] without the blends.
    pub(crate) fn unblended_contact_angle_rad(&self, local_angle_rad: f64) -> [f64; 2] {
        self.unblended[0].flanks().at(local_angle_rad)
    }

    /// Angle between the normals of the discrete and the plain raceway where they meet, at η, the angle at
    /// Oe from the outward radius: there Oe moves along z alone.
    pub fn kink_angle_rad(&self, meridian_rad: f64) -> f64 {
        if self.is_designed_at_right_angle() && self.blend_start_rad().is_none() {
            return FRAC_PI_2;
        }
        let re = self.groove_curvature_radius_m;
        let [_, slope] = self.contact_angle_rad(self.half_angle_rad());
        let climb = (re - self.ball_radius_m) * slope * meridian_rad.sin();
        let radius = self.groove_bottom_radius_m - re + re * meridian_rad.cos();
        climb.abs().atan2(radius)
    }

    /// Length of the blend before each end along the bottom of the groove, m; 0 for none.
    pub fn blend_m(&self) -> f64 {
        self.blend_m
    }

    /// Shape, ends and depth.
    pub fn form(&self) -> RacewayForm {
        self.form
    }

    /// The slot, if the raceway is one.
    pub fn slot(&self) -> Option<&Slot> {
        self.slot.as_ref()
    }

    /// Local ψ at which the blend before +θ starts.
    pub fn blend_start_rad(&self) -> Option<f64> {
        let blend = self.pieces.last().filter(|_| self.blend_m > 0.0);
        blend.map(|piece| piece.range_rad().start)
    }

    /// Checks that the raceway was laid out for this bearing.
    pub(crate) fn fits(&self, bearing: &Bearing) -> Result<(), InputError> {
        let d = bearing.dimensions();
        let same = self.ball_radius_m == d.ball_radius_m
            && self.groove_bottom_radius_m == d.outer_groove_bottom_radius_m
            && self.groove_curvature_radius_m == d.outer_groove_curvature_radius_m;
        let span = self.dimensions.axial_span_m;
        let kept = same && span < axial_span_limit_m(bearing);
        let rule = "the span of a raceway laid out for this very bearing (Raceway::new)";
        require("axial_span_m", span, kept, rule)
    }
}

/// Checks that no two raceways overlap.
pub fn apart(raceways: &[Raceway]) -> Result<(), InputError> {
    for (k, one) in raceways.iter().enumerate() {
        for other in &raceways[k + 1..] {
            let distance = one.local_angle_rad(other.dimensions.centre_angle_rad).abs();
            let least = one.half_angle_rad() + other.half_angle_rad();
            let rule = format!(
                "at least {least} away from the middle of every other raceway, or they overlap"
            );
            let middle = other.dimensions.centre_angle_rad;
            require("centre_angle_rad", middle, distance >= least, rule)?;
        }
    }
    Ok(())
}

/// 2·√(Rw² − (Ros − Rm)²), which lC must stay below (Zhao 2022, Eq. (8)).
pub fn axial_span_limit_m(bearing: &Bearing) -> f64 {
    let rise = bearing.dimensions().outer_shoulder_radius_m - bearing.outer_orbit_radius_m();
    2.0 * (bearing.ball_radius_m().powi(2) - rise.max(0.0).powi(2))
        .max(0.0)
        .sqrt()
}
