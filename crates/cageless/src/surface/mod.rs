//! The outer ring as a solid: cylinder outside, plane faces, two shoulders and the groove
//! with its discrete raceways, exactly and as a B-spline or a mesh of triangles.
//!
//! In every meridian plane the groove is two arcs of radius Re that touch a ball on the circle of
//! radius T = Ro − Rw at the contact angles ±α(ψ); on the plain raceway α = 0. Where a discrete
//! raceway ends, α has a kink; a blend of a stated length replaces its last stretch by a polynomial
//! that meets both neighbours with their curvature. The ball's centre stays on its circle all the
//! while. A slot is cut through the plain groove, see [`Recess`]. Raceways of the contact angle αg have the section turned about that centre, which is
//! then where a ball of this contact angle rests in the plain groove:
//!
//!   B = (T − (Re − Rw)(1 − cos αg), zo + (Re − Rw) sin αg)
//!
//! in (ρ, z), with zo of the groove's centre. Both shoulders have the radius Ros.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::surface::{OuterRing, OuterRingDimensions};
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let dimensions = OuterRingDimensions {
//!     outer_ring_outer_radius_m: 31e-3,
//!     outer_ring_width_m: 16e-3,
//!     blend_m: 0.0,
//! };
//! let ring = OuterRing::of(&case, dimensions)?;
//! assert!(ring.measures().volume_m3 > 0.0);
//! # Ok::<(), cageless::InputError>(())
//! ```

mod arc;
mod conformity;
mod directions;
mod division;
mod drawn_groove;
mod flank;
mod grid;
mod made_raceway;
mod made_ring;
mod measured_groove;
mod measured_raceway;
mod measured_ring;
mod measured_value;
mod meridian;
mod mesh;
mod mesh_row;
mod patch;
mod plain_groove;
mod point_deviation;
mod points_error;
mod pose;
mod recess;
mod ring_fit;
mod section_frame;
mod sector;
mod sheet;
mod side;
mod stretch;

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use crate::bearing::Bearing;
use crate::case::Case;
use crate::error::{Allowed, InputError, degrees};
use crate::limits::{not_negative, positive, require};
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::quadrature::gauss;
use crate::raceway::{Ends, Raceway, apart};

pub use arc::{Arc, SurfacePoint};
pub use measured_raceway::{MeasuredFlank, MeasuredRaceway};

pub use conformity::Conformity;
pub use drawn_groove::DrawnGroove;
#[cfg(test)]
pub(crate) use grid::PointKind;
pub use grid::{Grid, GridPoint, GridRow};
#[cfg(test)]
pub(crate) use measured_groove::MeasuredGroove;
pub use measured_ring::{MeasuredRing, PointOff};
pub use measured_value::MeasuredValue;
pub use meridian::Meridian;
pub use mesh::Mesh;
pub use patch::{Patch, PatchError};
pub use point_deviation::PointDeviation;
pub use points_error::PointsError;
#[cfg(test)]
pub(crate) use pose::Pose;
pub use recess::{Edge, EdgePlace, MeasuredSlot, Recess};
use section_frame::SectionFrame;
pub use sector::RingSector;
pub use side::Side;

/// Dimensions of the outer ring other than its groove.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OuterRingDimensions {
    /// Radius of the cylinder outside.
    pub outer_ring_outer_radius_m: f64,
    /// Axial distance of the side faces.
    pub outer_ring_width_m: f64,
    /// Length of the blend at each end of each discrete raceway that has none of its own, along the
    /// bottom of the groove, inside ±θ; 0 leaves the kink.
    pub blend_m: f64,
}

/// Measures of an outer ring as a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RingMeasures {
    /// Volume, m³.
    pub volume_m3: f64,
    /// Largest angle between the normals on both sides of an end of a discrete raceway without its
    /// blends: 45° up the groove and at the shoulder. 0 without raceways.
    pub design_kink_rad: [f64; 2],
    /// Largest kink of the raceways without a blend, rad, at the same places.
    pub kink_rad: [f64; 2],
    /// Largest angle between the normals of the two flanks of a discrete raceway.
    pub ridge_rad: f64,
    /// Largest distance between the blended surface and the one designed.
    pub blend_deviation_m: f64,
    /// How far the discrete raceways stand out of the plain groove, and how far they or the floors of slots
    /// lie below it.
    pub relief_m: [f64; 2],
}

/// An outer ring.
#[derive(Debug, Clone, PartialEq)]
pub struct OuterRing {
    /// Dimensions as given.
    pub dimensions: OuterRingDimensions,
    frame: SectionFrame,
    /// Ros.
    pub shoulder_radius_m: f64,
    /// Ro.
    pub groove_bottom_radius_m: f64,
    /// Re.
    pub curvature_radius_m: f64,
    /// αg by which the raceways are turned; without raceways the contact angle of the bearing.
    pub section_angle_rad: f64,
    /// zo, of the centre of the plain groove.
    pub groove_height_m: f64,
    raceways: Vec<Raceway>,
    /// The slots among the raceways, in the order of these.
    pub recesses: Vec<Recess>,
}

/// Gauss panels of ten points in a sector of a discrete raceway.
const VOLUME_PANELS: usize = 24;

impl OuterRing {
    /// Lays out the solid and checks that it is one.
    ///
    /// # Errors
    /// An [`InputError`] if raceways overlap, belong to another bearing or have different contact
    /// angles, the groove would cut through the ring or its side faces, or a blend does not fit.
    pub(crate) fn new(
        bearing: &Bearing,
        raceways: &[Raceway],
        dimensions: OuterRingDimensions,
    ) -> Result<Self, InputError> {
        positive(
            "outer_ring_outer_radius_m",
            dimensions.outer_ring_outer_radius_m,
        )?;
        positive("outer_ring_width_m", dimensions.outer_ring_width_m)?;
        not_negative("blend_m", dimensions.blend_m)?;
        for raceway in raceways {
            raceway.fits(bearing)?;
        }
        apart(raceways)?;
        let d = bearing.dimensions();
        let bottom_m = d.outer_groove_bottom_radius_m;
        let raceways = (raceways.iter()).map(|raceway| match raceway.blend_start_rad() {
            None if raceway.slot().is_none() => {
                raceway.clone().with_ends(Ends::Blended(dimensions.blend_m))
            }
            _ => Ok(raceway.clone()),
        });
        let raceways: Vec<Raceway> = raceways.collect::<Result<_, _>>()?;
        let axis_rad = section_angle_rad(bearing, &raceways)?;
        let frame = SectionFrame::new(bearing, axis_rad);
        let ring = Self {
            dimensions,
            frame,
            shoulder_radius_m: frame.shoulder_radius_m,
            groove_bottom_radius_m: bottom_m,
            curvature_radius_m: frame.curvature_radius_m,
            section_angle_rad: frame.axis_rad,
            groove_height_m: -bearing.groove_offset_m(),
            recesses: recesses(&frame, &raceways)?,
            raceways,
        };
        ring.check_walls()?;
        ring.check_slots()?;
        Ok(ring)
    }

    /// The ring of a case: that of its bearing, or of its row, which may press its balls to −Z.
    ///
    /// # Errors
    /// That of `new`, and for several rows.
    pub fn of(case: &Case, dimensions: OuterRingDimensions) -> Result<Self, InputError> {
        let ring = Self::new(&case.bearing, &case.raceways, dimensions)?;
        match case.rows.as_slice() {
            [row] if row.contact_sign < 0.0 => ring.mirrored(),
            [] | [_] => Ok(ring),
            [_, second, ..] => {
                let place_m = second.axial_position_m;
                let rule = "left out with its [[row]]: each row has an outer ring of its own, of which one at \
                            a time is made";
                Err(InputError::rule("axial_position_m", place_m, rule))
            }
        }
    }

    /// The groove neither breaks through the cylinder outside nor through a side face.
    fn check_walls(&self) -> Result<(), InputError> {
        let d = &self.dimensions;
        let meridians = || std::iter::once(self.plain_meridian(0.0)).chain(self.middles());
        let deepest = meridians()
            .map(|m| m.deepest_radius_m())
            .fold(0.0, f64::max);
        Allowed::Above(deepest, "the bottom of the groove at its deepest")
            .check("outer_ring_outer_radius_m", d.outer_ring_outer_radius_m)?;
        let widest = meridians()
            .flat_map(|m| m.arcs.map(|arc| 2.0 * arc.height_m(arc.shoulder_rad())))
            .fold(0.0, f64::max);
        Allowed::Above(widest, "the groove between its shoulders")
            .check("outer_ring_width_m", d.outer_ring_width_m)
    }

    /// The floors of slots neither break through the cylinder outside nor through a side face, and around
    /// each slot there is plain groove.
    fn check_slots(&self) -> Result<(), InputError> {
        let d = &self.dimensions;
        let bottom_m = self.groove_bottom_radius_m;
        for recess in &self.recesses {
            let room_m = (d.outer_ring_outer_radius_m - recess.deepest_radius_m())
                .min(d.outer_ring_width_m / 2.0 - recess.widest_m());
            let why = "the floor of the slot must lie within the ring";
            let depth_m = recess.depth_m;
            Allowed::Below(depth_m + room_m, why).check("slot_depth_m", depth_m)?;
            let radius_m = recess.edge_radius_m;
            for other in self.others(recess) {
                let d = other.dimensions();
                let apart = wrap_angle_rad(d.centre_angle_rad - recess.middle_rad).abs();
                let least = recess.half_angle_rad + d.half_angle_rad + radius_m / bottom_m;
                let rule = format!(
                    "at least {:.4}° away from the middle of a slot, so that plain groove as long as \
                     the radius of its edges is left",
                    degrees(least)
                );
                require("centre_angle_rad", d.centre_angle_rad, apart >= least, rule)?;
            }
        }
        Ok(())
    }

    /// Mirror image of the ring in z = 0.
    fn mirrored(self) -> Result<Self, InputError> {
        let frame = self.frame.mirrored();
        Ok(Self {
            frame,
            section_angle_rad: frame.axis_rad,
            groove_height_m: -self.groove_height_m,
            recesses: recesses(&frame, &self.raceways)?,
            ..self
        })
    }

    /// Section of the groove at ψ, that of the plain groove across a slot.
    pub fn meridian(&self, angle_rad: f64) -> Meridian {
        let found = self.flanked().find(|r| r.contains(angle_rad));
        found.map_or_else(
            || self.plain_meridian(angle_rad),
            |r| self.raceway_meridian(r, angle_rad, r.local_angle_rad(angle_rad)),
        )
    }

    /// Section of a sector at ψ; at its ends the limit from within.
    pub fn meridian_in(&self, sector: &RingSector, angle_rad: f64) -> Meridian {
        match sector.raceway {
            Some(k) => {
                let raceway = &self.raceways[k];
                self.raceway_meridian(raceway, angle_rad, raceway.local_angle_rad(angle_rad))
            }
            None => self.plain_meridian(angle_rad),
        }
    }

    fn plain_meridian(&self, angle_rad: f64) -> Meridian {
        Meridian::new(&self.frame, angle_rad, [0.0, 0.0])
    }

    fn raceway_meridian(&self, raceway: &Raceway, angle_rad: f64, local_rad: f64) -> Meridian {
        let centre = raceway.dimensions().centre_angle_rad;
        let frame = self.frame.deeper(raceway.depth_at_m(centre + local_rad));
        Meridian::new(&frame, angle_rad, raceway.contact_angle_rad(local_rad))
    }

    /// The raceways that are no slots.
    fn flanked(&self) -> impl Iterator<Item = &Raceway> {
        self.raceways.iter().filter(|r| r.slot().is_none())
    }

    /// The raceways but that of a slot.
    fn others(&self, recess: &Recess) -> impl Iterator<Item = &Raceway> {
        let raceways = self.raceways.iter().enumerate();
        raceways.filter_map(|(k, raceway)| (k != recess.raceway()).then_some(raceway))
    }

    /// Sections in the middle of each that is no slot, all at ψ = 0.
    fn middles(&self) -> impl Iterator<Item = Meridian> {
        let raceways = self.flanked();
        raceways.map(|r| self.raceway_meridian(r, 0.0, 0.0))
    }

    /// Point of the groove at ψ and η, as `Meridian::point` counts it.
    pub fn point(&self, angle_rad: f64, meridian_rad: f64) -> SurfacePoint {
        self.meridian(angle_rad).point(meridian_rad)
    }

    /// Distance of a point near the groove from its surface, that of the plain groove across a slot,
    /// positive inside the ring's material; off by the square of the distance over the radii of curvature.
    pub fn distance_m(&self, position_m: [f64; 3]) -> f64 {
        let [x, y, z] = position_m;
        let meridian = self.meridian(x.atan2(-y));
        meridian.distance_m(x.hypot(y), z)
    }

    /// Volume, kinks, ridge, blend and relief of the solid.
    pub fn measures(&self) -> RingMeasures {
        RingMeasures {
            volume_m3: self.volume_m3(),
            design_kink_rad: self.design_kink_rad(),
            kink_rad: self.kink_rad(),
            ridge_rad: self.ridge_rad(),
            blend_deviation_m: self.blend_deviation_m(),
            relief_m: self.relief_m(),
        }
    }

    /// Volume of the solid by Gauss quadrature over ψ of the exact area moment of each
    /// section; relative error below 1e-12.
    pub(crate) fn volume_m3(&self) -> f64 {
        let d = &self.dimensions;
        let rim = d.outer_ring_outer_radius_m.powi(2) * d.outer_ring_width_m;
        let side = |arc: &Arc| {
            let groove = arc.height_m(arc.shoulder_rad());
            let wall = d.outer_ring_width_m / 2.0 - groove;
            rim / 2.0 - arc.hollow_moment_m3() - self.shoulder_radius_m.powi(2) * wall
        };
        let moment = |m: Meridian| (side(&m.arcs[0]) + side(&m.arcs[1])) / 2.0;
        let slots: f64 = self.recesses.iter().map(Recess::volume_m3).sum();
        let whole: f64 = (self.sectors().iter())
            .map(|sector| match sector.raceway {
                None => (sector.end_rad - sector.start_rad) * moment(self.plain_meridian(0.0)),
                Some(_) => {
                    let f = |angle| moment(self.meridian_in(sector, angle));
                    gauss(f, sector.start_rad, sector.end_rad, VOLUME_PANELS)
                }
            })
            .sum();
        whole - slots
    }

    /// Largest angle between the normals on both sides of an end of a discrete raceway without its
    /// blends: 45° up the groove and at the shoulder. 0 without raceways.
    pub(crate) fn design_kink_rad(&self) -> [f64; 2] {
        self.largest_kink_rad(|_| true)
    }

    /// [`Self::design_kink_rad`] of the raceways that have no blend.
    pub(crate) fn kink_rad(&self) -> [f64; 2] {
        self.largest_kink_rad(|raceway| raceway.blend_start_rad().is_none())
    }

    fn largest_kink_rad(&self, counts: impl Fn(&Raceway) -> bool) -> [f64; 2] {
        let raceways = self.flanked().filter(|raceway| counts(raceway));
        let kinks = raceways.flat_map(|raceway| {
            let flank = raceway.unblended_contact_angle_rad(raceway.half_angle_rad());
            let arcs = Meridian::new(&self.frame, 0.0, flank).arcs;
            let tilt = |arc: &Arc, eta| match raceway.is_designed_at_right_angle() {
                true => FRAC_PI_2,
                false => arc.tilt_rad(eta),
            };
            arcs.map(|arc| [FRAC_PI_4, arc.shoulder_rad()].map(|eta| tilt(&arc, eta)))
        });
        kinks.fold([0.0; 2], |a, b| [a[0].max(b[0]), a[1].max(b[1])])
    }

    /// Largest angle between the normals of the two flanks of a discrete raceway, which meet between
    /// the two contact points.
    pub(crate) fn ridge_rad(&self) -> f64 {
        self.middles().map(|m| m.ridge_rad()).fold(0.0, f64::max)
    }

    /// Largest distance between the blended surface and the one designed.
    pub(crate) fn blend_deviation_m(&self) -> f64 {
        const SAMPLES: usize = 400;
        let blended = (self.raceways.iter()).filter_map(|r| Some((r, r.blend_start_rad()?)));
        blended
            .flat_map(|(raceway, start)| {
                let end = raceway.half_angle_rad();
                (0..=SAMPLES).map(move |k| {
                    let local = start + (end - start) * k as f64 / SAMPLES as f64;
                    let section = |flank| Meridian::new(&self.frame, 0.0, flank).arcs;
                    let designed = section(raceway.unblended_contact_angle_rad(local));
                    let blended = section(raceway.contact_angle_rad(local));
                    let off = |(arc, designed): (&Arc, &Arc)| {
                        let at = |eta| designed.distance_m(arc.radius_at_m(eta), arc.height_m(eta));
                        at(arc.valley_rad()).abs().max(at(arc.shoulder_rad()).abs())
                    };
                    blended.iter().zip(&designed).map(off).fold(0.0, f64::max)
                })
            })
            .fold(0.0, f64::max)
    }

    /// How far the discrete raceways stand out of the plain groove, and how far they or the floors of slots
    /// lie below it. The walls that meet the ball at ±α are closer to it than those of the plain
    /// groove: a raceway cannot be cut into a finished plain one.
    pub(crate) fn relief_m(&self) -> [f64; 2] {
        const SAMPLES: usize = 1000;
        let plain = self.plain_meridian(0.0);
        let arcs = self.middles().flat_map(|m| m.arcs);
        let floors = self.recesses.iter().map(|recess| recess.depth_m);
        let floor = floors.fold(0.0, f64::max);
        arcs.fold([0.0, floor], |relief, arc| {
            let (valley, range) = (arc.valley_rad(), arc.shoulder_rad() - arc.valley_rad());
            (0..=SAMPLES).fold(relief, |[above, below], k| {
                let eta = valley + range * k as f64 / SAMPLES as f64;
                let groove = plain.arc(arc.side);
                let inside = groove.distance_m(arc.radius_at_m(eta), arc.height_m(eta));
                [above.max(-inside), below.max(inside)]
            })
        })
    }

    /// The raceways as they are made, in the order given.
    pub fn raceways(&self) -> impl Iterator<Item = &Raceway> {
        self.raceways.iter()
    }

    /// Largest length of a blend, m; 0 if there is none.
    pub fn blend_m(&self) -> f64 {
        let blends = self.raceways.iter().map(Raceway::blend_m);
        blends.fold(0.0, f64::max)
    }
}

/// The slots of a ring with such sections.
fn recesses(frame: &SectionFrame, raceways: &[Raceway]) -> Result<Vec<Recess>, InputError> {
    let slots = (0..raceways.len()).filter_map(|k| Some((k, raceways[k].slot()?)));
    slots
        .map(|(k, slot)| Recess::new(frame, k, &raceways[k], slot))
        .collect()
}

/// αg of the raceways, which is the same of all; without raceways that of the bearing.
fn section_angle_rad(bearing: &Bearing, raceways: &[Raceway]) -> Result<f64, InputError> {
    let Some(first) = raceways.first().map(Raceway::section_angle_rad) else {
        return Ok(bearing.contact_angle_rad());
    };
    let mut angles = raceways.iter().map(Raceway::section_angle_rad);
    angles
        .find(|angle| *angle != first)
        .map_or(Ok(first), |angle| {
            let rule = "the same in all raceways: a ring has sections of one contact angle";
            Err(InputError::rule("raceway_contact_angle_rad", angle, rule))
        })
}
