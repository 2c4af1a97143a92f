//! Shape of a discrete raceway, sampled for drawing (Fig. 1b and 2).

use std::f64::consts::FRAC_PI_2;

use cageless::surface::{DrawnGroove, Recess, Side};
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
    /// Lines along the edges of a slot, where they leave the groove and where its walls begin, each closed; points
    /// `[x, y, z]`, mm. Empty of other raceways.
    #[serde(default)]
    pub edges_mm: Vec<Vec<[f64; 3]>>,
    /// Width between the walls of a slot in its middle, depth of its floor below the plain groove, radius of its
    /// edges, mm.
    #[serde(default)]
    pub slot_mm: Option<[f64; 3]>,
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
/// Rows at a tip of a slot over θ: of the groove and of the edges, and what is between them over the drawn half.
const TIP: [f64; 2] = [1.0, 1.0 - 1e-9];
const TIP_GAP: f64 = 1e-8;
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

    /// Adds a row of points with their deviations.
    fn push(&mut self, points_mm: Vec<[f64; 3]>, deviations_um: Vec<f64>) {
        let of = |k: usize| points_mm.iter().map(|point| point[k]).collect();
        self.x_mm.push(of(0));
        self.y_mm.push(of(1));
        self.z_mm.push(of(2));
        self.deviation_um.push(deviations_um);
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
        let groove = DrawnGroove::new(bearing, raceway, contact_sign);
        let turned = |[x, y, z]: [f64; 3]| {
            let (rho, local) = (x.hypot(y), x.atan2(-y) - centre);
            [rho * local.sin(), -rho * local.cos(), z].map(|v| v * 1e3)
        };
        let deviation_um =
            |[x, y, z]: &[f64; 3]| ((x.hypot(*y) - plain).hypot(z - plain_z) - re) * 1e6;
        let mut row = |points: Vec<[f64; 3]>| {
            let deviations_um = points.iter().map(deviation_um).collect();
            surface.push(points.into_iter().map(turned).collect(), deviations_um);
        };
        let mut places: Vec<f64> = (0..ALONG).map(|k| half * fraction(k, ALONG)).collect();
        if let Some(recess) = groove.recess() {
            let tips = [-1.0, 1.0].map(|end| end * recess.half_angle_rad);
            places.extend(tips.iter().flat_map(|tip| TIP.map(|share| share * tip)));
            places.sort_by(f64::total_cmp);
        }
        for (k, local) in places.iter().enumerate() {
            // Nothing joins the groove at a tip and the edges, there one line, of the slot.
            let gap = k > 0 && (local - places[k - 1]).abs() < TIP_GAP * half;
            if gap {
                row(vec![[f64::NAN; 3]; 2 * ACROSS]);
            }
            row(groove.points(centre + local, ACROSS));
        }
        if let (Some(recess), Some(slot)) = (groove.recess(), raceway.and_then(Raceway::slot)) {
            surface.edges_mm = [0.0, 1.0]
                .map(|share| edge_line(recess, share).map(turned).collect())
                .to_vec();
            let size_m = [slot.width_m(), slot.depth_m, slot.edge_radius_m];
            surface.slot_mm = Some(size_m.map(|length| length * 1e3));
        }
        for k in 0..TRACK_POINTS {
            let local = half * fraction(k, TRACK_POINTS);
            let section = groove.meridian(centre + local);
            let arc = section.arc(Side::Upper);
            let point = arc.point(centre + local, arc.contact_angle_rad);
            surface.track_mm.push(turned(point.position_m));
        }
        surface
    }
}

/// The line of a slot's edges at a share of their arcs, closed, from tip to tip and back.
fn edge_line(recess: &Recess, share: f64) -> impl Iterator<Item = [f64; 3]> {
    let half = TRACK_POINTS - 1;
    (0..=2 * half).map(move |k| {
        let side = usize::from(k <= half);
        // Closer together at the tips, around which the edges turn.
        let turn = FRAC_PI_2 * fraction(k.min(2 * half - k), TRACK_POINTS);
        let edges = recess.edges_at(recess.half_angle_rad * turn.sin());
        edges[side].arc_m(share)
    })
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
