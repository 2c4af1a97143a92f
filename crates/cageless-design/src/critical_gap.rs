//! The critical gap of a discrete raceway.
//!
//! The **critical gap**: let one pair roll into the raceway with gap g. It is the
//! largest g, read when the leading ball reaches the raceway, at which the pair's gap
//! falls to 0 between then and the trailing ball leaving. It is what β0 of Zhao 2022,
//! Eq. (11), means once balls may slip.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::Control;
//! use cageless_design::critical_gap::{PairTest, critical_gap_rad};
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let test = PairTest { tolerance_rad: 1e-4, ..PairTest::default() };
//! let gap = critical_gap_rad(&case, &test, &mut |_| Control::Continue(())).unwrap();
//! assert!((1.0..2.0).contains(&gap.to_degrees()));
//! ```

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::rise::{Rise, try_rise};
use cageless::Bearing;
use cageless::equilibrium::{self, EquilibriumError};
use cageless::simulation::{
    Control, Ending, Observer, ObserverError, RunContext, StepView, Stop, run,
};
use cageless::{Case, Formulation, Gaps, Start, StartState};

/// Criterion of contact of a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Touch {
    /// The angle ψ(i+1) − ψ(i) − ε falls to 0.
    Angle,
    /// The balls' surfaces meet, δb > 0. Loaded balls sit outside Rm, so this comes a
    /// little later.
    Surface,
}

/// Settings of the measurement of a critical gap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairTest {
    /// ψ of the trailing ball at the start, from the middle of the raceway (negative). A
    /// pair that would start inside a wide raceway starts 5° before it.
    pub trailing_start_rad: f64,
    /// Row of the pair, from 0.
    pub row: usize,
    /// Criterion of contact.
    pub touch: Touch,
    /// Gap to the neighbours of the pair over the gap that the other N − 1 spacings
    /// would have if all were equal; 1 keeps them equal (as do three balls, which have no
    /// others).
    pub neighbours_wider: f64,
    /// Where the ring starts, balls on Rm; at its static equilibrium if `None`, with clearance and
    /// in space together with the balls.
    pub ring_y_m: Option<f64>,
    /// Error of the starting gap.
    pub tolerance_rad: f64,
    /// Gap at the entrance above which nothing is tried: one that closes counts as
    /// [`CriticalGapError::AlwaysCloses`]. `None` for all that the bearing has room for.
    pub gap_max_rad: Option<f64>,
    /// Largest step under Coulomb friction, whose results are of order one in the step; a
    /// larger one of the case gives way to it.
    pub coulomb_step_max_s: f64,
}

/// Balls beside the pair stand off by this much in verdict and search, or a deep raceway would be measured by how
/// they push the pair together.
pub const NEIGHBOURS_WIDER: f64 = 1.4;
/// Upper end of the critical gaps that verdict and search resolve, as a multiple of the steady gap: balls collide
/// above.
pub(crate) const CROWDED_MAX: f64 = 1.5;
/// Error of these critical gaps: a tenth of what choices of the experiment move them by.
const GAP_TOLERANCE_RAD: f64 = 2e-5;

impl PairTest {
    /// The critical gap of verdict and search, of a row and raceways whose steady gap of rolling is `steady_gap_rad`;
    /// in the `paper` formulation the neighbours stand as evenly as in the paper.
    pub(crate) fn of_raceways(case: &Case, row: usize, steady_gap_rad: f64) -> Self {
        Self {
            row,
            neighbours_wider: match case.formulation {
                Formulation::Paper => 1.0,
                Formulation::Physical => NEIGHBOURS_WIDER,
            },
            tolerance_rad: GAP_TOLERANCE_RAD,
            gap_max_rad: Some(CROWDED_MAX * steady_gap_rad),
            ..Self::default()
        }
    }
}

impl Default for PairTest {
    /// Pair from ψ = −90°, contact by angle, the other spacings equal, ring in equilibrium.
    fn default() -> Self {
        Self {
            trailing_start_rad: -FRAC_PI_2,
            row: 0,
            touch: Touch::Angle,
            neighbours_wider: 1.0,
            ring_y_m: None,
            tolerance_rad: 2e-7,
            gap_max_rad: None,
            coulomb_step_max_s: 0.25e-6,
        }
    }
}

/// Error of the computation of a critical gap.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CriticalGapError {
    /// The case is impossible or has no equilibrium.
    #[error(transparent)]
    Case(EquilibriumError),
    /// The run left the physical range.
    #[error("at t = {:.6} s {}: {}", .0.time_s, .0.cause, .0.advice())]
    Stopped(Stop),
    /// Interrupted by the caller.
    #[error("interrupted")]
    Interrupted,
    /// The pair did not reach the raceway.
    #[error("the pair did not pass the raceway within {:.2} ms: the balls do not roll", 1e3 * .0)]
    NotPassed(f64),
    /// No raceway, or it never closes the gap.
    #[error("the gap of a pair never closes on this raceway")]
    NeverCloses,
    /// The gap closes from every starting gap.
    #[error("balls touch in the raceway whatever their spacing on entry")]
    AlwaysCloses,
}

impl From<EquilibriumError> for CriticalGapError {
    fn from(error: EquilibriumError) -> Self {
        match error {
            EquilibriumError::Interrupted => Self::Interrupted,
            error => Self::Case(error),
        }
    }
}

/// Gap read at the entrance and the smallest after it, for one starting gap.
#[derive(Debug, Clone, Copy, PartialEq)]
struct PairResult {
    entrance: f64,
    smallest: f64,
}

/// Watches the pair ball 1 (trailing), ball 2 (leading) of a row.
struct PairWatch {
    /// Index of ball 1 of the row.
    first: usize,
    centre: f64,
    half_angle: f64,
    ball_angle: f64,
    pitch_diameter: f64,
    touch: Touch,
    last_gap: f64,
    last_lead: f64,
    entrance: Option<f64>,
    smallest: f64,
    passed: bool,
}

impl Observer for PairWatch {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        let [trail, lead] = [0, 1].map(|k| context.start_angle_rad[self.first + k]);
        self.last_gap = lead - trail - self.ball_angle;
        self.last_lead = lead - self.centre;
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let pair = [self.first, self.first + 1];
        let [trail, lead] = pair.map(|k| view.angle_after_rad(k) - self.centre);
        let gap = lead - trail - self.ball_angle;
        if self.entrance.is_none() && lead >= -self.half_angle {
            let s = (-self.half_angle - self.last_lead) / (lead - self.last_lead);
            self.entrance = Some(self.last_gap + s * (gap - self.last_gap));
        }
        if self.entrance.is_some() {
            let closeness = match self.touch {
                Touch::Angle => gap,
                Touch::Surface => {
                    let [trail, lead] = pair.map(|k| view.ball(k));
                    let chord = (lead.x_m() - trail.x_m()).hypot(lead.y_m() - trail.y_m());
                    // The gap of balls so far apart on the pitch circle.
                    2.0 * (chord / self.pitch_diameter).asin() - self.ball_angle
                }
            };
            self.smallest = self.smallest.min(closeness);
        }
        (self.last_gap, self.last_lead) = (gap, lead);
        if trail >= self.half_angle {
            self.passed = true;
            return Ok(Control::Break(()));
        }
        Ok(Control::Continue(()))
    }
}

/// ψ of the trailing ball at the start, from the middle of the raceway.
fn trailing_rad(case: &Case, test: &PairTest, start_gap: f64) -> f64 {
    let half_angle = case.raceways[0].half_angle_rad();
    let before = half_angle + case.bearing.ball_angle_rad() + start_gap;
    test.trailing_start_rad.min(-before - 5f64.to_radians())
}

/// Step of the passages of a pair.
fn step_s(case: &Case, test: &PairTest) -> f64 {
    match case.contact.friction_law.sticks() {
        true => case.solver.step_s.min(test.coulomb_step_max_s),
        false => case.solver.step_s,
    }
}

/// Steps that the critical gap of the case's first raceway takes as a rule; 0 without one.
pub(crate) fn pair_steps(case: &Case, test: &PairTest) -> f64 {
    let Some(raceway) = case.raceways.first() else {
        return 0.0;
    };
    let gap = case.bearing.nominal_gap_rad();
    let way_rad = raceway.half_angle_rad() - trailing_rad(case, test, gap);
    PASSAGES * way_rad / case.rolling_orbit_speed_rad_s() / step_s(case, test)
}

/// Gaps of a row at the start, rad: that of the pair, those to its neighbours, and the others alike.
fn gaps_rad(bearing: &Bearing, test: &PairTest, start_gap: f64) -> Vec<f64> {
    let n = bearing.balls();
    let room = n as f64 * bearing.nominal_gap_rad() - start_gap;
    let even = room / (n - 1) as f64;
    let beside = even * test.neighbours_wider;
    let rest = if n > 3 {
        (room - 2.0 * beside) / (n - 3) as f64
    } else {
        even
    };
    let mut gaps = vec![rest; n];
    gaps[0] = start_gap;
    if n > 3 {
        gaps[1] = beside;
        gaps[n - 1] = beside;
    }
    gaps
}

/// One passage of the pair with gap `start_gap` at the start; `control` is called with the fraction
/// of the passage that is done.
fn pass(
    case: &Case,
    test: &PairTest,
    ring_y: Option<f64>,
    start_gap: f64,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<PairResult, CriticalGapError> {
    let raceway = &case.raceways[0];
    let bearing = &case.bearing;
    let gaps = gaps_rad(bearing, test, start_gap);
    let centre = raceway.dimensions().centre_angle_rad;
    let half_angle = raceway.half_angle_rad();
    let trailing = trailing_rad(case, test, start_gap);
    // Without clearance the balls start on Rm and the ring where it settles: nothing is pressed in
    // further than by the deflection. With clearance balls on Rm would be pressed into a settled ring
    // by half of it, and with interference they are pressed into both rings, so they start settled,
    // too, as in space.
    let state = match ring_y {
        None => StartState::Settled,
        Some(ring_y_m) => StartState::Rolling {
            ring_x_m: 0.0,
            ring_y_m,
        },
    };
    let mut case = Case {
        start: Start::new(state, Gaps::List(gaps), centre + trailing),
        ..case.clone()
    };
    case.solver.step_s = step_s(&case, test);
    // A sliding ball may need more than the time of pure rolling; thrice is enough.
    let rolling_s = (half_angle - trailing) / case.rolling_orbit_speed_rad_s();
    case.solver.duration_s = 3.0 * rolling_s;
    let mut watch = PairWatch {
        first: test.row * bearing.balls(),
        centre,
        half_angle,
        ball_angle: bearing.ball_angle_rad(),
        pitch_diameter: 2.0 * bearing.pitch_radius_m(),
        touch: test.touch,
        last_gap: 0.0,
        last_lead: 0.0,
        entrance: None,
        smallest: f64::INFINITY,
        passed: false,
    };
    let outcome = run(&case, &mut [&mut watch], &mut |time_s| {
        control((time_s / rolling_s).min(1.0))
    })?;
    match (outcome.ending, watch.entrance) {
        (Ending::Stopped(stop), _) => Err(CriticalGapError::Stopped(stop)),
        // The watch ends the run as well, once the pair has passed.
        (Ending::Interrupted, _) if !watch.passed => Err(CriticalGapError::Interrupted),
        (_, Some(entrance)) if watch.passed => Ok(PairResult {
            entrance,
            smallest: watch.smallest,
        }),
        _ => Err(CriticalGapError::NotPassed(case.solver.duration_s)),
    }
}

/// Largest starting gap over the last one where a pair reaches the raceway with less than is to be tried.
const FURTHER: f64 = 1.5;

/// Passages that a critical gap takes as a rule.
const PASSAGES: f64 = 4.0;

/// Critical gap of the case's first raceway, rad, to about [`PairTest::tolerance_rad`].
/// `control` is called every thousand steps or so with the estimated fraction of the work that is
/// done, 0 to 1, which never falls.
///
/// # Errors
/// [`CriticalGapError`].
pub fn critical_gap_rad(
    case: &Case,
    test: &PairTest,
    control: &mut dyn FnMut(f64) -> Control,
) -> Result<f64, CriticalGapError> {
    case.check_constant_operation("a critical gap")
        .map_err(EquilibriumError::from)?;
    if case.raceways.is_empty() {
        return Err(CriticalGapError::NeverCloses);
    }
    let bearing = &case.bearing;
    let settles = case.moves_in_space() || bearing.radial_internal_clearance_m() != 0.0;
    let ring_y = match test.ring_y_m {
        None if settles => None,
        None => Some(equilibrium::solve(case)?.ring_y_m),
        given => given,
    };
    let n = bearing.balls() as f64;
    // Everything that the other balls leave free, but for a little.
    let room = 0.9 * (TAU - n * bearing.ball_angle_rad());
    let most = test.gap_max_rad.map_or(room, |gap| gap.min(room));
    let mut entrance = f64::NAN;
    let mut passages = 0.0;
    // A little above, where pairs pass freely and the smallest gap is a smooth function.
    let mut guess = 1.03 * bearing.nominal_gap_rad();
    let (mut low, mut high) = (0.0, most);
    loop {
        let found = try_rise(
            |gap| {
                let mut fraction = |part: f64| control(((passages + part) / PASSAGES).min(1.0));
                let passed = pass(case, test, ring_y, gap, &mut fraction)?;
                passages += 1.0;
                entrance = passed.entrance;
                Ok::<_, CriticalGapError>(passed.smallest)
            },
            guess,
            low..=high,
            test.tolerance_rad,
        )?;
        let is_reached = test.gap_max_rad.is_none_or(|gap| entrance >= gap);
        match found {
            Rise::At(_) => return Ok(entrance),
            Rise::Below => return Err(CriticalGapError::NeverCloses),
            Rise::Above if is_reached || high >= room => {
                return Err(CriticalGapError::AlwaysCloses);
            }
            // A pair that draws together on its way reaches the raceway with less than it starts with.
            Rise::Above => {
                guess = (FURTHER * high).min(room);
                (low, high) = (high, guess);
            }
        }
    }
}
