//! Ranges, limits and stages of a search.

use super::super::criterion::STEADY_GAP;
use super::job::{Interrupted, Job, Outcome};
use super::raceway_layout::OperatingPoint;
use cageless::Case;
use cageless::raceway::{Raceway, RacewayForm};

/// Ranges and limits of a search.
#[derive(Debug, Clone, PartialEq)]
pub struct Request {
    /// Operating points; a structure must be acceptable at all of them.
    pub points: Vec<OperatingPoint>,
    /// Further speeds to draw maps at, under the load of the first point.
    pub map_speeds_rad_s: Vec<f64>,
    /// Spans lC to look at, the limits included; `None` for all that Eq. (8) allows.
    pub axial_span_range_m: Option<[f64; 2]>,
    /// Angles θ to look at, the limits included; `None` for all that Eq. (9) allows.
    pub half_angle_range_rad: Option<[f64; 2]>,
    /// Places of the raceways, ψ of their middles; the map is drawn for the first.
    pub placements: Vec<Vec<f64>>,
    /// Forms of the raceways, one or more; the map is drawn for the first.
    pub forms: Vec<RacewayForm>,
    /// Angles by which the sections of the raceways are turned, one or more; the map is drawn for the first.
    pub section_angles_rad: Vec<f64>,
    /// Fraction of the steady gap that the critical gap must reach, above 0 and below 1.
    pub critical_gap_min_fraction: f64,
    /// Largest axial load of a search in the plane, under which a raceway must keep the share of its lag of `AXIAL_LAG`, N; 0
    /// asks for none.
    pub axial_load_max_n: f64,
    /// Uneven starts per structure, 1 or more.
    pub starts: u64,
    /// Seed of the uneven starts.
    pub seed: u64,
    /// Simulations of all balls at most, [`Request::budget_least`] or more; below the default, maps
    /// and candidates are coarser, too.
    pub budget: usize,
}

impl Request {
    /// The case's own operating point, one raceway where the case has its first (at the
    /// bottom if it has none) and turned as that (as the contact angle if it has none), all that the
    /// geometry allows.
    pub fn from_case(case: &Case) -> Self {
        let centre = case
            .raceways
            .first()
            .map_or(0.0, |r| r.dimensions().centre_angle_rad);
        let turned = case.raceways.first().map(Raceway::section_angle_rad);
        Self {
            section_angles_rad: vec![turned.unwrap_or(case.bearing.contact_angle_rad())],
            points: vec![OperatingPoint::from_case(case)],
            map_speeds_rad_s: vec![],
            axial_span_range_m: None,
            half_angle_range_rad: None,
            placements: vec![vec![centre]],
            forms: vec![case.raceway_form()],
            critical_gap_min_fraction: STEADY_GAP.limit(),
            axial_load_max_n: 0.0,
            starts: 2,
            seed: SEED,
            budget: BUDGET,
        }
    }
}

impl Request {
    /// Forms with each of the angles by which a section is turned.
    pub fn sections(&self) -> impl Iterator<Item = (RacewayForm, f64)> {
        let forms = self.forms.iter();
        forms.flat_map(|form| self.section_angles_rad.iter().map(|angle| (*form, *angle)))
    }
}
/// Starts of the confirmation with the default budget and one operating point.
pub const CONFIRMING_STARTS: u64 = 12;

cageless::named_enum! {
    /// Stage of a search.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Stage {
        /// Critical gaps of the map.
        Map = "map of critical gaps",
        /// Critical gaps of the band.
        Candidates = "critical gaps of the candidates",
        /// Runs of all balls.
        Motion = "motion of all balls",
        /// Steps of the optimiser.
        Polish = "optimiser",
        /// Motion in space under axial load.
        Axial = "motion under axial load",
        /// More starts.
        Confirm = "confirmation",
    }
}

/// Runs a batch of jobs and returns their outcomes in their order.
pub(crate) type Execute<'e> = dyn FnMut(Stage, &[Job]) -> Result<Vec<Outcome>, Interrupted> + 'e;

/// Default of [`Request::seed`], and of every other seed of a case file.
pub const SEED: u64 = 0;

/// Default of [`Request::budget`].
pub const BUDGET: usize = 400;
