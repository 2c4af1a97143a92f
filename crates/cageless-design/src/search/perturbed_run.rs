//! The run that separates structures: balls that start unevenly spaced.
//!
//! Equal balls that start evenly hardly ever meet. Here each gap is drawn evenly between 0
//! and twice the mean, and scaled to the room that there is; the raceway has to sort the
//! balls, at the price of collisions, and then to let them be.

use crate::raceway_tallies::RacewayTallies;
use crate::raceway_tallies::speed_drop_fraction;
use cageless::ContactTally;
use cageless::dynamics::EnergyTerm;
use cageless::equilibrium::EquilibriumError;
use cageless::passage::{Passage, PassageRecorder, PassageTally};
use cageless::recorder::keeping;
use cageless::simulation::{Control, Ending, Observer, RunOutcome, Stop, batches, run_batch};
use cageless::{Case, Gaps, Start, StartState};

/// Orbits of the balls in a perturbed run; spacing is looked at in the second half.
pub(crate) const TURNS: f64 = 32.0;
/// Orbits from a bunched start: a raceway takes some hundred to take a bunch apart.
pub const BUNCHED_TURNS: f64 = 256.0;

/// Declares [`Motion`] and its numbers in a row.
macro_rules! motion {
    ($($(#[$meta:meta])* $field:ident,)*) => {
        /// Result of a perturbed run.
        #[derive(Debug, Clone, Copy, PartialEq, Default)]
        pub struct Motion {
            $($(#[$meta])* pub $field: f64,)*
        }

        /// Numbers of a motion.
        pub const VALUES: usize = [$(stringify!($field)),*].len();

        impl Motion {
            /// The numbers in the order of the fields, for files.
            pub fn values(&self) -> [f64; VALUES] {
                [$(self.$field),*]
            }

            /// The inverse of [`Self::values`].
            pub fn from_values(values: [f64; VALUES]) -> Self {
                let [$($field),*] = values;
                Self { $($field),* }
            }
        }
    };
}

motion! {
    /// Contacts between balls, per ball and orbit; with one raceway, per passage.
    collisions,
    /// Collisions per ball and orbit in steady state (second half of the run).
    collisions_late,
    /// Impulse between balls, per ball and orbit, N·s.
    impulse_n_s,
    /// Fraction of the passages of the second half in which both neighbours hit.
    double_collision_fraction,
    /// Standard deviation of the gaps of pairs on arrival, second half.
    gap_deviation_rad,
    /// Smallest gap of a pair on arrival, second half.
    gap_min_rad,
    /// Mean gap of a pair on arrival, second half.
    gap_mean_rad,
    /// Largest slip at a loaded contact, mean over the passages of the second half.
    sliding_m_s,
    /// Fraction of the theoretical drop of orbital speed that the balls reach, mean over the
    /// passages of the second half, of the raceway with the least.
    speed_drop_fraction,
    /// Lag over that of rolling on rigid flanks without a contact angle, mean over the passages of the second
    /// half, of the row and raceway with the least.
    lag_fraction,
    /// Standard deviation of the force of the balls on the outer ring, both directions
    /// together, second half.
    force_deviation_n,
    /// Power lost to friction, W.
    friction_w,
    /// Power lost to the rolling resistance of a film, W; 0 without.
    rolling_resistance_w,
}

impl Motion {
    /// Mean of several; zero of none.
    pub(crate) fn mean(all: &[Self]) -> Self {
        let mut sum = [0.0; VALUES];
        for motion in all {
            for (s, v) in sum.iter_mut().zip(motion.values()) {
                *s += v / all.len() as f64;
            }
        }
        Self::from_values(sum)
    }
}

/// Error of a perturbed run.
#[derive(Debug, thiserror::Error)]
pub(crate) enum PerturbedRunError {
    /// The case is impossible or has no equilibrium.
    #[error(transparent)]
    Case(EquilibriumError),
    /// The run left the physical range.
    #[error("the run of all balls stopped at {:.6} s: {}", .0.time_s, .0.cause)]
    Stopped(Stop),
    /// Interrupted by the caller.
    #[error("interrupted")]
    Interrupted,
    /// The balls do not roll.
    #[error("the balls do not pass the raceway")]
    NoPassages,
}

impl From<EquilibriumError> for PerturbedRunError {
    fn from(error: EquilibriumError) -> Self {
        match error {
            EquilibriumError::Interrupted => Self::Interrupted,
            error => Self::Case(error),
        }
    }
}

/// Start of a perturbed run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum UnevenStart {
    /// Gaps drawn at random.
    Drawn {
        /// Seed of all draws.
        seed: u64,
        /// Number of this one.
        number: u64,
    },
    /// All balls in one group.
    Bunched,
}

impl UnevenStart {
    /// Orbits of a perturbed run from it.
    pub(crate) fn turns(self) -> f64 {
        match self {
            Self::Drawn { .. } => TURNS,
            Self::Bunched => BUNCHED_TURNS,
        }
    }
}

impl std::fmt::Display for UnevenStart {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Drawn { number, .. } => write!(f, "{number}"),
            Self::Bunched => f.write_str("bunched"),
        }
    }
}

/// Runs each case from its uneven start for [`UnevenStart::turns`] orbits, side by side where
/// they can be; who runs beside whom changes no bit.
///
/// # Errors
/// Errors per case: the case is impossible, the run stops or the balls do not pass.
pub(crate) fn perturbed_runs(
    cases: &[(&Case, UnevenStart)],
    control: &mut dyn FnMut(f64) -> Control,
) -> Vec<Result<Motion, PerturbedRunError>> {
    let cases: Vec<Case> = cases
        .iter()
        .map(|&(case, start)| from_uneven_start(case, start, start.turns()))
        .collect();
    let mut motions = vec![];
    for members in batches(&cases) {
        let together: Vec<&Case> = members.iter().map(|&k| &cases[k]).collect();
        let mut late: Vec<Vec<Passage>> = vec![vec![]; together.len()];
        let half_s = together[0].solver.duration_s / 2.0;
        let mut contacts: Vec<ContactTally> =
            together.iter().map(|_| ContactTally::new(half_s)).collect();
        let outcomes = {
            let mut passages: Vec<_> = late
                .iter_mut()
                .map(|late| {
                    PassageRecorder::new(keeping(late, move |p: &Passage| p.enter_s > half_s))
                })
                .collect();
            let mut observers: Vec<Vec<&mut dyn Observer>> = passages
                .iter_mut()
                .zip(&mut contacts)
                .map(|(passages, contacts)| vec![passages as &mut dyn Observer, contacts])
                .collect();
            run_batch(&together, &mut observers, control)
        };
        let seen = late.iter().zip(&contacts);
        let ended = outcomes.into_iter().zip(together).zip(seen);
        for (&k, ((outcome, case), (late, contacts))) in members.iter().zip(ended) {
            let motion = outcome
                .map_err(PerturbedRunError::from)
                .and_then(|outcome| motion(case, &outcome, late, contacts));
            motions.push((k, motion));
        }
    }
    motions.sort_by_key(|(k, _)| *k);
    motions.into_iter().map(|(_, motion)| motion).collect()
}

/// `case` with this uneven start, as long as so many orbits of the balls.
pub(crate) fn from_uneven_start(case: &Case, start: UnevenStart, orbits: f64) -> Case {
    let gaps = match start {
        UnevenStart::Drawn { seed, number } => {
            Gaps::List(Gaps::uneven_rad(&case.bearing, seed, number))
        }
        UnevenStart::Bunched => Gaps::bunched(&case.bearing),
    };
    let mut case = Case {
        start: Start::new(StartState::Settled, gaps, case.start.lead_ball_angle_rad),
        ..case.clone()
    };
    case.solver.duration_s = orbits * case.rolling_orbit_s();
    case
}

/// Observations of a run, from the passages of its second half and its contacts.
fn motion(
    case: &Case,
    outcome: &RunOutcome,
    late: &[Passage],
    contacts: &ContactTally,
) -> Result<Motion, PerturbedRunError> {
    match &outcome.ending {
        Ending::Stopped(stop) => return Err(PerturbedRunError::Stopped(stop.clone())),
        Ending::Complete => {}
        _ => return Err(PerturbedRunError::Interrupted),
    }
    // Spacing is read at one raceway; whatever comes by is the same.
    let arrivals: Vec<f64> = late
        .iter()
        .filter(|p| p.raceway == 0)
        .map(|p| p.gap_behind_rad)
        .collect();
    if arrivals.is_empty() {
        return Err(PerturbedRunError::NoPassages);
    }
    let count = arrivals.len() as f64;
    let gap_mean_rad = arrivals.iter().sum::<f64>() / count;
    let square = |gap: &f64| (gap - gap_mean_rad).powi(2);
    let variance = arrivals.iter().map(square).sum::<f64>() / count;
    let mut tally = PassageTally::new();
    late.iter().for_each(|passage| tally.add(passage));
    let mut tallies = RacewayTallies::new(case);
    late.iter().for_each(|passage| tallies.add(passage));
    let raceways = 0..case.raceways.len();
    let passed = raceways.filter(|&k| tallies.of_raceway(k).count > 0);
    let least = |of: &dyn Fn(usize) -> f64| passed.clone().map(of).fold(f64::INFINITY, f64::min);
    let ball_turns = case.balls() as f64 * case.solver.duration_s / case.rolling_orbit_s();
    Ok(Motion {
        collisions: contacts.begun / ball_turns,
        collisions_late: contacts.begun_late / (ball_turns / 2.0),
        impulse_n_s: contacts.impulse_n_s / ball_turns,
        double_collision_fraction: tally.means().double_collision_fraction,
        gap_deviation_rad: variance.sqrt(),
        gap_min_rad: arrivals.iter().copied().fold(f64::INFINITY, f64::min),
        gap_mean_rad,
        sliding_m_s: tally.means().sliding_m_s,
        speed_drop_fraction: least(&|k| {
            let slowest_rad_s = tallies.of_raceway(k).means().lowest_orbit_speed_rad_s;
            speed_drop_fraction(case, &case.raceways[k], slowest_rad_s)
        }),
        lag_fraction: least(&|k| tallies.lag_fraction(case, k)),
        force_deviation_n: contacts.force_deviation_n(),
        friction_w: outcome.state.friction_j() / case.solver.duration_s,
        rolling_resistance_w: outcome.state.energy_term_j(EnergyTerm::RollingResistance)
            / case.solver.duration_s,
    })
}
