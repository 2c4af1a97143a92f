//! Snapshots at regular times.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::recorder::Recorder;
//! use cageless::simulation::{Control, run};
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let mut gaps = vec![];
//! let mut recorder = Recorder::new(1e-3, |snapshot| {
//!     gaps.push(snapshot.gap_rad[0]);
//!     Ok(())
//! });
//! run(&case, &mut [&mut recorder], &mut |_| Control::Continue(()))?;
//! assert_eq!(gaps.len(), 21); // t = 0, 1 … 20 ms
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};
use crate::snapshot::Snapshot;

/// A closure for a recorder or a detector that keeps those of its `rows` for which `keep` is true.
pub fn keeping<T>(
    rows: &mut Vec<T>,
    keep: impl Fn(&T) -> bool,
) -> impl FnMut(T) -> Result<(), ObserverError> {
    move |row| {
        if keep(&row) {
            rows.push(row);
        }
        Ok(())
    }
}

/// Passes a [`Snapshot`] at t = 0, after every interval and at the end of the run to a
/// closure.
pub struct Recorder<F> {
    interval_s: f64,
    end_s: f64,
    taken: u64,
    sink: F,
}

impl<F: FnMut(Snapshot) -> Result<(), ObserverError>> Recorder<F> {
    /// Every `interval_s` from 0.
    pub fn new(interval_s: f64, sink: F) -> Self {
        Self {
            interval_s,
            end_s: f64::INFINITY,
            taken: 0,
            sink,
        }
    }
}

impl<F: FnMut(Snapshot) -> Result<(), ObserverError>> Observer for Recorder<F> {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        let mut rhs = crate::dynamics::RightHandSide::new(context.model);
        self.taken = 1;
        self.end_s = context.case.solver.duration_s;
        (self.sink)(rhs.snapshot(0.0, context.start, context.start_angle_rad))
    }

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        // Half a millionth of a step decides nothing, but lets 0.3 s mean 3000 × 0.1 ms.
        let slack = 1e-6 * (view.step.t1_s - view.step.t0_s);
        loop {
            let time_s = self.taken as f64 * self.interval_s;
            if time_s > view.step.t1_s + slack {
                break;
            }
            (self.sink)(view.snapshot(time_s.min(view.step.t1_s)))?;
            self.taken += 1;
        }
        let last_s = (self.taken - 1) as f64 * self.interval_s;
        if view.step.t1_s >= self.end_s && self.end_s > last_s + slack {
            (self.sink)(view.snapshot(view.step.t1_s))?;
        }
        Ok(Control::Continue(()))
    }
}
