//! Constants of the equations in space.

use super::inner_groove::InnerGroove;
use super::outer_groove::{FlankModel, FlanksHere, OuterGroove};
use super::strips::{Strip, strips};
use crate::case::{Case, Tilt};
use crate::film::GrooveCurves;
use crate::numerics::vector::PlaneVector;
use crate::world::body::sliding_ring::SlidingRing;

/// Grooves and contact ellipses of one ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct BallInGrooves {
    pub outer: OuterGroove,
    pub inner: InnerGroove,
    /// σ of its row, 1 or −1: the sections of its raceways are turned by σ αg.
    pub contact_sign: f64,
    /// a of a contact under 1 N, m: outer, inner.
    pub half_length_m_n1_3: [f64; 2],
    /// κ of a contact, 1/m: outer, inner.
    pub curvature: [f64; 2],
}

/// Inertia of the inner ring with what turns with it, where moments turn it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FreeTilt {
    /// It, kg·m².
    pub transverse: f64,
    /// Ip, kg·m².
    pub polar: f64,
    /// Mx, My, N·m.
    pub moment: [f64; 2],
}

/// Constants of the equations in space beyond those of the plane.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SpaceModel {
    pub balls: Vec<BallInGrooves>,
    pub flanks: Vec<FlankModel>,
    pub strips: Vec<Strip>,
    /// Fa, N.
    pub axial_load: f64,
    /// None where the shaft holds the tilt.
    pub free_tilt: Option<FreeTilt>,
    /// The axis against which weights act: 1 for Y, 2 for Z.
    pub upward: usize,
    /// Outer rings that slide in the housing.
    pub sliding: Vec<SlidingRing>,
    /// Films of the contacts with the raceways.
    pub film: Option<GrooveCurves>,
}

impl SpaceModel {
    /// The constants of a case that moves in space.
    pub(crate) fn new(case: &Case) -> Option<Self> {
        if !case.moves_in_space() {
            return None;
        }
        let bearing = &case.bearing;
        let d = bearing.dimensions();
        let (re, ri) = (
            d.outer_groove_curvature_radius_m,
            d.inner_groove_curvature_radius_m,
        );
        let angle = bearing.contact_angle_rad();
        let ellipses = bearing.contacts_at([angle; 2]);
        let rows = case.all_rows();
        let balls = (0..case.balls()).map(|k| {
            let row = &rows[k / bearing.balls()];
            let radius = bearing.ball(k % bearing.balls()).radius_m;
            let offset = row.contact_sign * bearing.groove_offset_m();
            BallInGrooves {
                outer: OuterGroove {
                    gap: re - radius,
                    nominal_gap: re - d.ball_radius_m,
                    axial: -offset - (row.contact_sign * row.preload_m - row.axial_position_m),
                },
                inner: InnerGroove {
                    gap: ri - radius,
                    curvature: ri,
                    centre: d.inner_groove_bottom_radius_m + ri,
                    axial: row.axial_position_m + offset,
                },
                contact_sign: row.contact_sign,
                half_length_m_n1_3: [1, 0].map(|ring: usize| ellipses[ring].semi_axes_m(1.0)[1]),
                curvature: [re, ri].map(|groove| 0.25 * (1.0 / radius + 1.0 / groove)),
            }
        });
        let load = &case.operation.space;
        let free_tilt = match (load.tilt, load.inertias_kg_m2) {
            (
                Tilt::Free {
                    moment_x_n_m,
                    moment_y_n_m,
                },
                Some([transverse, polar]),
            ) => Some(FreeTilt {
                transverse,
                polar,
                moment: [moment_x_n_m, moment_y_n_m],
            }),
            _ => None,
        };
        let flanks = case
            .raceways
            .iter()
            .enumerate()
            .flat_map(|(number, raceway)| {
                let pieces = raceway.met_pieces().into_iter();
                pieces.map(move |piece| FlankModel::new(raceway, number, &piece))
            });
        Some(Self {
            upward: case.upward(),
            balls: balls.collect(),
            flanks: flanks.collect(),
            strips: strips(case.contact.friction_strips),
            axial_load: load.axial_load_n,
            free_tilt,
            sliding: SlidingRing::of_case(case),
            film: (case.film.as_ref()).map(|film| GrooveCurves::new(bearing, film, &case.raceways)),
        })
    }

    /// Mass of all outer rings that slide, kg.
    pub(crate) fn sliding_kg(&self) -> f64 {
        self.sliding.iter().map(|ring| ring.mass).sum()
    }

    /// The flanks under ball `k` in the direction **e**; `None` outside the discrete raceways.
    #[inline(always)]
    pub(crate) fn flanks_at(&self, k: usize, direction: PlaneVector) -> Option<FlanksHere> {
        let mut flanks = self.flanks.iter();
        let (flanks, angle) = flanks.find_map(|f| Some((f, f.within(direction)?)))?;
        flanks.at(angle, self.balls[k].contact_sign)
    }
}
