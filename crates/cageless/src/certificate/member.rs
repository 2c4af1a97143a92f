//! One of the runs that a certificate compares.

use super::momentum::MomentumBalance;
use super::motion::MotionRecorder;
use super::quantity::Quantity;
use super::trajectory::{TrajectoryRecorder, sample_times_s};
use crate::case::{Case, Start};
use crate::equilibrium::EquilibriumError;
use crate::simulation::{
    Control, Ending, Observer, ObserverError, RunContext, RunOutcome, StepView, Stop, run,
};
use crate::summary::SummaryRecorder;

/// Angle by which near starts are turned: far above rounding, far below any tolerance.
pub const NEAR_RAD: f64 = 1.7e-11;
/// Number of near starts.
pub const NEAR: usize = 2;
/// Angle by which far starts are turned. They must have parted as early as the run and
/// the run at half the step do, or events before would show no spread; 0.1 µm along the
/// circle is what the distance counts as lost, and less than anyone knows of a start.
pub const FAR_RAD: f64 = 3e-6;

/// How far the start of a member is from that of the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Turn {
    /// The given start.
    None,
    /// By some [`NEAR_RAD`]: to see whether the number depends on the start at all, and how
    /// fast runs part.
    Near,
    /// By some [`FAR_RAD`]: to draw from all that the run could as well have been.
    Far,
}

/// How a member differs from the run that is judged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Role {
    /// Start.
    pub turn: Turn,
    /// Start turned by this angle.
    pub turn_rad: f64,
    /// At half the step.
    pub half_step: bool,
}

impl std::fmt::Display for Role {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match (self.turn == Turn::None, self.half_step) {
            (true, false) => f.write_str("the run itself"),
            (true, true) => f.write_str("the run at half the step"),
            (false, false) => write!(f, "the run turned by {:.2e} rad", self.turn_rad),
            (false, true) => write!(
                f,
                "the run turned by {:.2e} rad at half the step",
                self.turn_rad
            ),
        }
    }
}

/// One of the runs that a certificate compares.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// How it differs.
    pub role: Role,
    /// What is to be run.
    pub case: Case,
    times_s: Vec<f64>,
}

/// Why a member has no record.
#[derive(Debug, thiserror::Error)]
pub enum MemberError {
    /// The case is impossible or has no equilibrium.
    #[error(transparent)]
    Case(#[from] EquilibriumError),
    /// The run left the physical range.
    #[error("{0} stopped at t = {time:.6} s: {cause}", time = .1.time_s, cause = .1.cause)]
    Stopped(Role, Stop),
    /// Ended by the caller.
    #[error("interrupted")]
    Interrupted,
    /// There is nothing after the transient.
    #[error("{0} ended within its transient")]
    Empty(Role),
}

/// The runs that a certificate of `case` compares: the run itself, [`NEAR`] near starts and
/// `far` far ones, turned by about 1, 2, 3 … times their angle, a little off by the seed;
/// then the given start and the far ones at half the step.
pub fn members(case: &Case, far: usize) -> Vec<Member> {
    let times_s = sample_times_s(case);
    let starts = |turn: Turn, count: usize, angle: f64| {
        (1..=count as u64).map(move |k| {
            let off = 0.25 * signed_unit(case.seed, k);
            (turn, angle * (k as f64 + off))
        })
    };
    let given = std::iter::once((Turn::None, 0.0));
    let full = given
        .clone()
        .chain(starts(Turn::Near, NEAR, NEAR_RAD))
        .chain(starts(Turn::Far, far, FAR_RAD));
    let half = given.chain(starts(Turn::Far, far, FAR_RAD));
    let roles = full
        .map(|start| (start, false))
        .chain(half.map(|start| (start, true)));
    roles
        .map(|((turn, turn_rad), half_step)| {
            let mut member = case.clone();
            match &mut member.start {
                Start::Settled {
                    lead_ball_angle_rad,
                    ..
                }
                | Start::Rolling {
                    lead_ball_angle_rad,
                    ..
                } => *lead_ball_angle_rad += turn_rad,
            }
            if half_step {
                member.solver.step_s *= 0.5;
            }
            Member {
                role: Role {
                    turn,
                    turn_rad,
                    half_step,
                },
                case: member,
                // Far starts are not compared point by point.
                times_s: if turn == Turn::Far {
                    vec![]
                } else {
                    times_s.clone()
                },
            }
        })
        .collect()
}

/// A number in [−1, 1) for each pair of numbers: SplitMix64 (Steele, Lea, Flood 2014).
fn signed_unit(seed: u64, k: u64) -> f64 {
    let mut z = seed.wrapping_add(k.wrapping_mul(0x9e37_79b9_7f4a_7c15));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^= z >> 31;
    (z >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

impl Member {
    /// An observer that keeps what the certificate needs of this member.
    pub fn watch(&self) -> Watch {
        Watch {
            role: self.role,
            summary: SummaryRecorder::new(),
            motion: MotionRecorder::default(),
            momentum: MomentumBalance::default(),
            trajectory: TrajectoryRecorder::new(self.times_s.clone()),
            lead_angle_rad: f64::NAN,
        }
    }

    /// Runs the member. `control` is called as in [`crate::simulation::run`].
    ///
    /// # Errors
    /// The run could not start or did not come to its end.
    pub fn run(&self, control: &mut dyn FnMut(f64) -> Control) -> Result<Record, MemberError> {
        let mut watch = self.watch();
        let outcome = run(&self.case, &mut [&mut watch], control)?;
        watch.record(&outcome)
    }
}

/// Keeps what a certificate needs of one run.
pub struct Watch {
    role: Role,
    summary: SummaryRecorder,
    motion: MotionRecorder,
    momentum: MomentumBalance,
    trajectory: TrajectoryRecorder,
    lead_angle_rad: f64,
}

impl Watch {
    /// What the run came to.
    ///
    /// # Errors
    /// The run did not come to its end.
    pub fn record(self, outcome: &RunOutcome) -> Result<Record, MemberError> {
        match &outcome.ending {
            Ending::Complete => {}
            Ending::Stopped(stop) => return Err(MemberError::Stopped(self.role, stop.clone())),
            Ending::Interrupted | Ending::ObserverFailed(_) => {
                return Err(MemberError::Interrupted);
            }
        }
        let s = self
            .summary
            .summary()
            .ok_or(MemberError::Empty(self.role))?;
        let ring = outcome.state.ring_motion();
        let [deviation_x, deviation_y] = self.motion.ring_deviation_m();
        let values = Quantity::ALL.map(|quantity| match quantity {
            Quantity::Collisions => s.collisions as f64,
            Quantity::GapMin => s.gap_min_rad,
            Quantity::GapMax => s.gap_max_rad,
            Quantity::RingXMean => s.ring_x_mean_m,
            Quantity::RingYMean => s.ring_y_mean_m,
            Quantity::SlipMax => s.slip_max_m_s,
            Quantity::RingXDeviation => deviation_x,
            Quantity::RingYDeviation => deviation_y,
            Quantity::OrbitSpeedMean => self.motion.orbit_speed_rad_s(),
            Quantity::SpinMean => self.motion.spin_rad_s(),
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

impl Observer for Watch {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.summary.begin(context)?;
        self.motion.begin(context)?;
        self.momentum.begin(context)
    }

    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        self.lead_angle_rad = view.angle_after_rad(0);
        self.summary.step(view)?;
        self.motion.step(view)?;
        self.momentum.step(view)?;
        self.trajectory.step(view)
    }
}

/// What a certificate needs of one run.
#[derive(Debug, Clone)]
pub struct Record {
    pub(super) role: Role,
    values: [f64; Quantity::ALL.len()],
    pub(super) trajectory: TrajectoryRecorder,
    pub(super) energy_residual_relative: f64,
    pub(super) momentum_residual_relative: f64,
}

impl Record {
    /// One of its numbers.
    pub fn value(&self, quantity: Quantity) -> f64 {
        self.values[quantity as usize]
    }
}
