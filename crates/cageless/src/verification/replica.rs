//! One of the runs that a verification compares.

use super::momentum::MomentumBalance;
use super::motion::MotionRecorder;
use super::quantity::Quantity;
use super::trajectory::{TrajectoryRecorder, sample_times_s};
use crate::case::Case;
use crate::equilibrium::EquilibriumError;
use crate::numerics::random::split_mix;
use crate::orbit_means::OrbitMeans;
use crate::passage::SettledPassages;
use crate::simulation::{
    Control, Ending, Observer, ObserverError, RotorDrop, RunContext, RunOutcome, StepView, Stop,
    run,
};
use crate::summary::{SummaryRecorder, transient_s};

/// Angle between the starts with small perturbations, rad: far above rounding, far below any tolerance.
pub(crate) const SMALL_PERTURBATION_RAD: f64 = 1.7e-11;
/// Number of starts with a small perturbation.
pub(crate) const SMALL_PERTURBATIONS: usize = 2;
/// Angle between the starts with large perturbations, rad. They must decorrelate as early as the
/// run and the run at half the step do, or earlier events would show no spread; 0.1 µm along the
/// circle is the distance [`DECORRELATED`](super::DECORRELATED), below the uncertainty of any
/// initial state.
pub(crate) const LARGE_PERTURBATION_RAD: f64 = 3e-6;

/// Perturbation of the initial state of a replica: all balls turned by one angle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Perturbation {
    /// Unperturbed initial state.
    None,
    /// Small multiples of `SMALL_PERTURBATION_RAD`: sensitivity to the initial state and rate of
    /// divergence.
    Small,
    /// Small multiples of `LARGE_PERTURBATION_RAD`: samples of the statistical ensemble of runs.
    Large,
}

/// Difference of a replica from the verified run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Role {
    /// Size of the perturbation of the initial state.
    pub perturbation: Perturbation,
    /// Angle by which all balls are turned.
    pub perturbation_rad: f64,
    /// Whether the step is halved.
    pub half_step: bool,
}

impl std::fmt::Display for Role {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match (self.perturbation == Perturbation::None, self.half_step) {
            (true, false) => f.write_str("the run itself"),
            (true, true) => f.write_str("the run at half the step"),
            (false, false) => write!(f, "the run turned by {:.2e} rad", self.perturbation_rad),
            (false, true) => write!(
                f,
                "the run turned by {:.2e} rad at half the step",
                self.perturbation_rad
            ),
        }
    }
}

/// One of the runs that a verification compares.
#[derive(Debug, Clone, PartialEq)]
pub struct Replica {
    /// Difference from the verified run.
    pub role: Role,
    /// Case of the replica.
    pub case: Case,
    times_s: Vec<f64>,
}

/// Failure of a replica.
#[derive(Debug, thiserror::Error)]
pub enum ReplicaError {
    /// The case is impossible or has no equilibrium.
    #[error(transparent)]
    Case(EquilibriumError),
    /// The run left the physical range.
    #[error("{0} stopped at t = {time:.6} s: {cause}", time = .1.time_s, cause = .1.cause)]
    Stopped(Role, Stop),
    /// Interrupted by the caller.
    #[error("interrupted")]
    Interrupted,
    /// The run ended within its transient.
    #[error("{0} ended within its transient")]
    Empty(Role),
}

impl From<EquilibriumError> for ReplicaError {
    fn from(error: EquilibriumError) -> Self {
        match error {
            EquilibriumError::Interrupted => Self::Interrupted,
            error => Self::Case(error),
        }
    }
}

/// The runs that a verification of `case` compares, in the order of [`Role::all`], which says what the seed does.
pub fn replicas(case: &Case, seed: u64, large: usize) -> Vec<Replica> {
    let times_s = sample_times_s(case);
    let roles = Role::all(seed, large).into_iter();
    roles
        .map(|role| Replica {
            role,
            case: role.case(case),
            // Large perturbations are not compared point by point.
            times_s: match role.perturbation {
                Perturbation::Large => vec![],
                Perturbation::None | Perturbation::Small => times_s.clone(),
            },
        })
        .collect()
}

impl Role {
    /// The roles of a verification: the run itself, `SMALL_PERTURBATIONS` starts with a small
    /// perturbation and `large` with a large one, about 1, 2, 3 … times the angle, jittered by the
    /// seed; then the given start and the large perturbations at half the step.
    pub fn all(seed: u64, large: usize) -> Vec<Self> {
        let starts = |perturbation: Perturbation, count: usize, angle: f64| {
            (1..=count as u64).map(move |k| {
                let off = 0.25 * signed_unit(seed, k);
                (perturbation, angle * (k as f64 + off))
            })
        };
        let given = std::iter::once((Perturbation::None, 0.0));
        let full = given
            .clone()
            .chain(starts(
                Perturbation::Small,
                SMALL_PERTURBATIONS,
                SMALL_PERTURBATION_RAD,
            ))
            .chain(starts(Perturbation::Large, large, LARGE_PERTURBATION_RAD));
        let half = given.chain(starts(Perturbation::Large, large, LARGE_PERTURBATION_RAD));
        let starts = full
            .map(|start| (start, false))
            .chain(half.map(|start| (start, true)));
        starts
            .map(|((perturbation, perturbation_rad), half_step)| Self {
                perturbation,
                perturbation_rad,
                half_step,
            })
            .collect()
    }

    /// The case with all balls turned by the perturbation, and with half the step if this role has
    /// it.
    pub(crate) fn case(&self, case: &Case) -> Case {
        let mut replica = case.clone();
        replica.start.lead_ball_angle_rad += self.perturbation_rad;
        if self.half_step {
            replica.solver.step_s *= 0.5;
        }
        replica
    }

    /// The drop whose cases are so changed.
    pub fn drop(&self, drop: &RotorDrop) -> RotorDrop {
        drop.map_cases(|case| self.case(case))
    }
}

/// Pseudorandom number in [−1, 1) of `seed` and `k`.
fn signed_unit(seed: u64, k: u64) -> f64 {
    let z = split_mix(seed, k);
    (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

impl Replica {
    /// Observer that records the quantities of this replica.
    pub fn observer(&self) -> ReplicaObserver {
        ReplicaObserver {
            role: self.role,
            summary: SummaryRecorder::new(),
            motion: MotionRecorder::default(),
            passages: SettledPassages::after(transient_s(&self.case)),
            momentum: MomentumBalance::default(),
            trajectory: TrajectoryRecorder::new(self.times_s.clone()),
            lead_angle_rad: f64::NAN,
        }
    }

    /// Runs the replica. `control` is called as in [`crate::simulation::run`].
    ///
    /// # Errors
    /// The run could not start or did not complete.
    pub fn run(&self, control: &mut dyn FnMut(f64) -> Control) -> Result<Record, ReplicaError> {
        let mut observer = self.observer();
        let outcome = run(&self.case, &mut [&mut observer], control)?;
        observer.record(&outcome)
    }
}

/// Observer that records the quantities of one replica.
pub struct ReplicaObserver {
    role: Role,
    summary: SummaryRecorder,
    motion: MotionRecorder,
    passages: SettledPassages,
    momentum: MomentumBalance,
    trajectory: TrajectoryRecorder,
    lead_angle_rad: f64,
}

impl ReplicaObserver {
    /// Record of the completed run.
    ///
    /// # Errors
    /// The run did not complete.
    pub fn record(self, outcome: &RunOutcome) -> Result<Record, ReplicaError> {
        match &outcome.ending {
            Ending::Complete => {}
            Ending::Stopped(stop) => return Err(ReplicaError::Stopped(self.role, stop.clone())),
            Ending::Interrupted | Ending::ObserverFailed(_) => {
                return Err(ReplicaError::Interrupted);
            }
        }
        let s = self
            .summary
            .summary()
            .ok_or(ReplicaError::Empty(self.role))?;
        let ring = outcome.state.ring_motion();
        let [deviation_x, deviation_y] = self.motion.ring_deviation_m();
        let mean = |of: fn(&OrbitMeans) -> f64| s.means.as_ref().map_or(f64::NAN, of);
        let values = Quantity::ALL.map(|quantity| match quantity {
            Quantity::Collisions => s.collisions.all as f64,
            Quantity::GapMin => s.gap_min_rad,
            Quantity::GapMax => s.gap_max_rad,
            Quantity::RingXMean => s.ring_x_mean_m,
            Quantity::RingYMean => s.ring_y_mean_m,
            Quantity::SlipMax => s.sliding_max_m_s,
            Quantity::RingXDeviation => deviation_x,
            Quantity::RingYDeviation => deviation_y,
            Quantity::OrbitSpeedMean => self.motion.orbit_speed_rad_s(),
            Quantity::SpinMean => self.motion.rotation_rad_s(),
            Quantity::InnerForceMax => s.peaks.inner.force_n,
            Quantity::OuterForceMax => s.peaks.outer.force_n,
            Quantity::PowerLoss => mean(|means| means.power_loss_w),
            Quantity::FrictionTorque => mean(|means| means.friction_torque_n_m),
            Quantity::LagPerPass => self.passages.tally.means().lag_rad,
            Quantity::RingXEnd => ring.x,
            Quantity::RingYEnd => ring.y,
            Quantity::LeadBallAngleEnd => self.lead_angle_rad,
        });
        Ok(Record {
            role: self.role,
            values,
            trajectory: self.trajectory,
            energy_residual_relative: outcome.energy_residual_relative,
            momentum_residual_relative: self.momentum.residual_relative(),
        })
    }
}

impl Observer for ReplicaObserver {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.summary.begin(context)?;
        self.motion.begin(context)?;
        self.passages.begin(context)?;
        self.momentum.begin(context)
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        self.lead_angle_rad = view.angle_after_rad(0);
        let observers: [&mut dyn Observer; 5] = [
            &mut self.summary,
            &mut self.motion,
            &mut self.passages,
            &mut self.momentum,
            &mut self.trajectory,
        ];
        for observer in observers {
            if observer.step(view)?.is_break() {
                return Ok(Control::Break(()));
            }
        }
        Ok(Control::Continue(()))
    }
}

/// Quantities and trajectory of one replica.
#[derive(Debug, Clone)]
pub struct Record {
    pub(super) role: Role,
    values: [f64; Quantity::ALL.len()],
    pub(super) trajectory: TrajectoryRecorder,
    pub(super) energy_residual_relative: f64,
    pub(super) momentum_residual_relative: f64,
}

impl Record {
    /// Value of one quantity, in SI units; NaN of a lag without passages, of a torque at a speed that
    /// varies.
    pub(crate) fn value(&self, quantity: Quantity) -> f64 {
        self.values[quantity as usize]
    }
}
