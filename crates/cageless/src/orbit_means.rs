//! Mean powers and speeds over whole orbits of the balls.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::{Control, run};
//! use cageless::summary::SummaryRecorder;
//!
//! let mut case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! case.solver.duration_s = 0.002;
//! let mut recorder = SummaryRecorder::new();
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! let summary = recorder.summary().unwrap();
//! assert!(summary.means.unwrap().orbit_speed_rad_s > 400.0);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use std::f64::consts::TAU;

use crate::case::{Case, InnerRingDrive};
use crate::dynamics::coordinates::BallCoordinate;
use crate::dynamics::energy::EnergyTerm;
use crate::numerics::vector::PlaneVector;
use crate::simulation::{BallAngle, StepView};

/// Means over the whole orbits of ball 1 after the transient; over all of that part of the run
/// if it is shorter than one orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OrbitMeans {
    /// Whole orbits of ball 1; 0 if the part is shorter.
    pub orbits: u32,
    /// Begin and end, s.
    pub interval_s: [f64; 2],
    /// ωi, rad/s; NaN if it varies, by a table or under a rotor.
    pub inner_speed_rad_s: f64,
    /// Mean orbital speed of the balls, rad/s.
    pub orbit_speed_rad_s: f64,
    /// Mean absolute rotational speed of the balls about their axes, clockwise, rad/s.
    pub rotation_rad_s: f64,
    /// Mean torque of the drive, N·m: its power over ωi; NaN if that varies.
    pub friction_torque_n_m: f64,
    /// Mean power loss, W: the power of the drive of the inner ring; if ωi varies, the heat.
    pub power_loss_w: f64,
    /// Part of the power loss that does not become heat in the interval, W: the rise of the
    /// stored energy less the work of loads and weights (in the `paper` formulation also of the
    /// forces that the published equations add). It vanishes in the mean of a steady motion.
    pub stored_w: f64,
    /// Mean heat of friction, damping and drag, W.
    pub heat_w: f64,
    /// Frequency at which the set of balls orbits (FTF of a bearing with a cage), Hz.
    pub ftf_hz: f64,
    /// Frequency at which balls pass a point of the outer ring, Hz.
    pub bpfo_hz: f64,
    /// Frequency at which balls pass a point of the inner ring, Hz.
    pub bpfi_hz: f64,
    /// Rotational frequency of the balls relative to their orbit, Hz.
    pub bsf_hz: f64,
    power_w: [f64; EnergyTerm::ALL.len()],
}

impl OrbitMeans {
    /// Mean power of a term of the energy ledger, W; NaN of a term that the bodies of the case
    /// do not have.
    pub fn power_w(&self, term: EnergyTerm) -> f64 {
        self.power_w[term as usize]
    }
}

/// Heat among the mean powers of the energy ledger, W.
fn heat_w(power_w: &[f64; EnergyTerm::ALL.len()]) -> f64 {
    EnergyTerm::ALL
        .into_iter()
        .filter(|term| term.is_loss())
        .map(|term| power_w[term as usize])
        .filter(|power| power.is_finite())
        .sum()
}

/// Sums up to one time, and the angles of the balls then.
#[derive(Debug, Clone, Default)]
struct Mark {
    time_s: f64,
    ledger_j: [f64; EnergyTerm::ALL.len()],
    angles: Vec<BallAngle>,
    rotation_sum: [f64; 2],
    rotation_samples: u64,
}

/// Follows a run for its [`OrbitMeans`].
#[derive(Debug, Clone, Default)]
pub(crate) struct OrbitMeansTracker {
    begin: Option<Mark>,
    end: Option<Mark>,
    orbits: u32,
    /// Direction of ball 1 at the begin.
    reference: [f64; 2],
    /// Sine of the angle of ball 1 from there, times its distance, at the last step.
    last_cross: f64,
    rotation_sum: [f64; 2],
    rotation_samples: u64,
}

impl OrbitMeansTracker {
    /// Takes a step after the transient; `sampled` steps add to the rotational speed.
    #[inline]
    pub(crate) fn step(&mut self, view: &StepView<'_>, sampled: bool) {
        let PlaneVector { x, y } = view.ball_m(0);
        if sampled {
            self.add_rotations(view);
        }
        if self.begin.is_none() {
            self.begin = Some(self.mark(Mark::default(), view));
            self.reference = [x, y];
            self.last_cross = 0.0;
            return;
        }
        let [x0, y0] = self.reference;
        let cross = x0 * y - y0 * x;
        let round = self.last_cross < 0.0 && cross >= 0.0 && x0 * x + y0 * y > 0.0;
        self.orbits += u32::from(round);
        if round || self.orbits == 0 && sampled {
            let before = self.end.take().unwrap_or_default();
            self.end = Some(self.mark(before, view));
        }
        self.last_cross = cross;
    }

    /// Adds the rotational speeds at the end of a step.
    #[inline(never)]
    fn add_rotations(&mut self, view: &StepView<'_>) {
        let balls = view.contacts.balls();
        let sums = (0..balls).fold([0.0; 2], |[absolute, beyond], k| {
            let [of_ball, more] = rotations_rad_s(view, k);
            [absolute + of_ball, beyond + more]
        });
        for (total, sum) in self.rotation_sum.iter_mut().zip(sums) {
            *total += sum / balls as f64;
        }
        self.rotation_samples += 1;
    }

    /// Mark of the end of a step; `before` lends its memory.
    #[cold]
    fn mark(&self, before: Mark, view: &StepView<'_>) -> Mark {
        let layout = view.layout();
        let mut angles = before.angles;
        angles.clear();
        angles.extend((0..layout.balls).map(|k| view.ball_angle(k)));
        Mark {
            time_s: view.step.t1_s,
            ledger_j: EnergyTerm::ALL.map(|term| {
                if layout.energy_terms().contains(&term) {
                    view.step.y1[layout.energy_term(term)]
                } else {
                    f64::NAN
                }
            }),
            angles,
            rotation_sum: self.rotation_sum,
            rotation_samples: self.rotation_samples,
        }
    }

    /// The means so far; `None` before two samples.
    pub(crate) fn means(&self, case: &Case) -> Option<OrbitMeans> {
        let (begin, end) = (self.begin.as_ref()?, self.end.as_ref()?);
        let angle = |mark: &Mark| mark.angles.iter().map(BallAngle::rad).sum::<f64>();
        let time_s = end.time_s - begin.time_s;
        if time_s <= 0.0 {
            return None;
        }
        let inner_speed_rad_s = match case.inner_ring_drive() {
            InnerRingDrive::Constant(speed_rad_s) => Some(speed_rad_s),
            InnerRingDrive::OverTime(_) | InnerRingDrive::Rotor(_) => None,
        };
        let power_w = std::array::from_fn(|k| (end.ledger_j[k] - begin.ledger_j[k]) / time_s);
        let (heat_w, drive_w) = (heat_w(&power_w), power_w[EnergyTerm::Drive as usize]);
        let power_loss_w = inner_speed_rad_s.map_or(heat_w, |_| drive_w);
        let inner_speed_rad_s = inner_speed_rad_s.unwrap_or(f64::NAN);
        let balls = case.bearing.balls() as f64;
        let orbit_speed_rad_s = (angle(end) - angle(begin)) / (end.angles.len() as f64 * time_s);
        let ftf_hz = orbit_speed_rad_s / TAU;
        let samples = (end.rotation_samples - begin.rotation_samples) as f64;
        let [rotation_rad_s, beyond_orbit_rad_s] =
            [0, 1].map(|k| (end.rotation_sum[k] - begin.rotation_sum[k]) / samples);
        Some(OrbitMeans {
            orbits: self.orbits,
            interval_s: [begin.time_s, end.time_s],
            inner_speed_rad_s,
            orbit_speed_rad_s,
            rotation_rad_s,
            friction_torque_n_m: drive_w / inner_speed_rad_s,
            power_loss_w,
            stored_w: power_loss_w - heat_w,
            heat_w,
            ftf_hz,
            bpfo_hz: balls * ftf_hz,
            bpfi_hz: balls * (inner_speed_rad_s - orbit_speed_rad_s) / TAU,
            bsf_hz: (beyond_orbit_rad_s + orbit_speed_rad_s) / TAU,
            power_w,
        })
    }
}

/// Absolute rotational speed of ball `k` in space, and that in the frame of its orbit less the orbital speed,
/// rad/s; in the plane both are its spin.
fn rotations_rad_s(view: &StepView<'_>, k: usize) -> [f64; 2] {
    let spin = view.contacts.rotation_rad_s(k);
    if !view.layout().ball_moves(BallCoordinate::OmegaX) {
        return [spin; 2];
    }
    let across = [BallCoordinate::OmegaX, BallCoordinate::OmegaY].map(|c| view.after(c)[k]);
    let across = across[0].hypot(across[1]);
    let orbit = view.contacts.orbit_speed_rad_s(k);
    [
        spin.hypot(across).copysign(spin),
        (spin + orbit).hypot(across) - orbit,
    ]
}
