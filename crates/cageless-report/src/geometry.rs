//! Shape of a discrete raceway, sampled for drawing (Fig. 1b and 2).

use cageless::surface::{Meridian, Side};
use cageless::{Bearing, Raceway};
use serde::{Deserialize, Serialize};

use crate::data::{Provenance, RacewayLabel};

/// The contact track on a discrete raceway and on the ball (Fig. 1b).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct ContactTrack {
    /// The raceway.
    pub structure: RacewayLabel,
    /// ψ from the middle of the raceway, degrees.
    pub angle_deg: Vec<f64>,
    /// r, mm.
    pub effective_radius_mm: Vec<f64>,
    /// z of the branch z > 0, mm; the other is its mirror image.
    pub axial_mm: Vec<f64>,
    /// Rw, mm.
    pub ball_radius_mm: f64,
    /// Provenance.
    pub provenance: Provenance,
}

/// The surface of a discrete raceway and a little of the plain one (Fig. 2).
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct RacewaySurface {
    /// The raceway.
    pub structure: RacewayLabel,
    /// x of the points, mm: `x_mm[along][across]`.
    pub x_mm: Vec<Vec<f64>>,
    /// y of the points, mm.
    pub y_mm: Vec<Vec<f64>>,
    /// z of the points, mm.
    pub z_mm: Vec<Vec<f64>>,
    /// Distance from the plain groove, µm; positive where material is taken away.
    pub deviation_um: Vec<Vec<f64>>,
    /// Angle about the axis from its middle up to which it is drawn, rad.
    #[serde(default)]
    pub half_angle_rad: f64,
    /// Contact track, branch z > 0, points `[x, y, z]`, mm.
    pub track_mm: Vec<[f64; 3]>,
    /// Provenance.
    pub provenance: Provenance,
}

/// Points of a contact track.
const TRACK_POINTS: usize = 241;
/// Points of a surface along the raceway.
const ALONG: usize = 121;
/// Points of a surface across one side of the groove.
const ACROSS: usize = 25;
/// Extent of drawings beyond the ends of the raceway, over θ.
const MARGIN: f64 = 1.2;
/// Half of the plain groove that is drawn without a raceway.
const PLAIN_RAD: f64 = 0.5;

impl ContactTrack {
    /// Samples the track of `raceway`.
    pub fn sample(raceway: &Raceway, bearing: &Bearing, structure: RacewayLabel) -> Self {
        let centre = raceway.dimensions().centre_angle_rad;
        let rw = bearing.ball_radius_m();
        let mut track = Self {
            provenance: geometric(&structure),
            structure,
            ball_radius_mm: rw * 1e3,
            ..Self::default()
        };
        for k in 0..TRACK_POINTS {
            let local = raceway.half_angle_rad() * MARGIN * fraction(k, TRACK_POINTS);
            let r = raceway.effective_radius_m(centre + local);
            track.angle_deg.push(local.to_degrees());
            track.effective_radius_mm.push(r * 1e3);
            track.axial_mm.push((rw * rw - r * r).max(0.0).sqrt() * 1e3);
        }
        track
    }
}

impl RacewaySurface {
    /// Largest depth below the plain groove and largest height above it, µm.
    pub fn depth_and_height_um(&self) -> [f64; 2] {
        let all = self.deviation_um.iter().flatten();
        let (low, high) = all.fold((0.0f64, 0.0f64), |(low, high), d| {
            (low.min(*d), high.max(*d))
        });
        [high, -low]
    }

    /// Samples the surface of `raceway`, turned so that its middle is at the bottom.
    pub fn sample(raceway: &Raceway, bearing: &Bearing, structure: RacewayLabel) -> Self {
        Self::in_row(Some(raceway), bearing, 1.0, structure)
    }

    /// [`Self::sample`] of a row of this contact sign, without a raceway of the plain groove.
    pub fn in_row(
        raceway: Option<&Raceway>,
        bearing: &Bearing,
        contact_sign: f64,
        structure: RacewayLabel,
    ) -> Self {
        let centre = raceway.map_or(0.0, |r| r.dimensions().centre_angle_rad);
        let half = raceway.map_or(PLAIN_RAD, |r| r.half_angle_rad() * MARGIN);
        let d = bearing.dimensions();
        let re = d.outer_groove_curvature_radius_m;
        let plain = d.outer_groove_bottom_radius_m - re;
        let plain_z = -contact_sign * bearing.groove_offset_m();
        let mut surface = Self {
            provenance: geometric(&structure),
            structure,
            half_angle_rad: half,
            ..Self::default()
        };
        let section = |local: f64| Meridian::of(bearing, raceway, contact_sign, centre + local);
        for k in 0..ALONG {
            let local = half * fraction(k, ALONG);
            let section = section(local);
            let (mut xs, mut ys, mut zs, mut deviations) = (vec![], vec![], vec![], vec![]);
            for [x, y, z] in section.points(centre + local, ACROSS) {
                let rho = x.hypot(y);
                xs.push(rho * local.sin() * 1e3);
                ys.push(-rho * local.cos() * 1e3);
                zs.push(z * 1e3);
                deviations.push(((rho - plain).hypot(z - plain_z) - re) * 1e6);
            }
            surface.x_mm.push(xs);
            surface.y_mm.push(ys);
            surface.z_mm.push(zs);
            surface.deviation_um.push(deviations);
        }
        for k in 0..TRACK_POINTS {
            let local = half * fraction(k, TRACK_POINTS);
            let section = section(local);
            let arc = section.arc(Side::Upper);
            let [x, y, z] = arc.point(centre + local, arc.contact_angle_rad).position_m;
            let rho = x.hypot(y);
            surface
                .track_mm
                .push([rho * local.sin(), -rho * local.cos(), z].map(|v| v * 1e3));
        }
        surface
    }
}

/// −1 to 1.
fn fraction(k: usize, points: usize) -> f64 {
    2.0 * k as f64 / (points - 1) as f64 - 1.0
}

fn geometric(structure: &RacewayLabel) -> Provenance {
    Provenance {
        case: structure.label(),
        ..Provenance::default()
    }
}
