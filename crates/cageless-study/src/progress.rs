//! Progress reporting and cancellation.

use cageless::simulation::Control;

/// `Break(())` if `interrupted`, else `Continue(())`.
pub fn break_if(interrupted: bool) -> Control {
    if interrupted {
        Control::Break(())
    } else {
        Control::Continue(())
    }
}

/// Receiver of the progress of long work, task by task.
pub trait Progress: Sync {
    /// Announces the tasks of one whole in their order, each with an estimate of its work. A task
    /// may be begun more than once, or not at all. Tasks that are known already keep their
    /// estimate.
    fn whole(&self, tasks: &[(String, f64)]) {
        let _ = tasks;
    }

    /// Begins a task of `units`, a dimensionless estimate of its work.
    fn begin(&self, what: &str, units: f64) -> Box<dyn Work + '_>;

    /// Whether cancellation is requested.
    fn interrupted(&self) -> bool;
}

/// Task in progress until dropped; shared between threads.
pub trait Work: Sync {
    /// Reports `units` of further work done and returns whether to continue.
    fn add(&self, units: f64) -> Control;

    /// Whether cancellation is requested.
    fn interrupted(&self) -> bool;

    /// `Break(())` once cancellation is requested.
    fn control(&self) -> Control {
        break_if(self.interrupted())
    }

    /// Control of one run of `duration_s` that counts as `units`; a duration of 1 for work that
    /// reports its completed fraction.
    fn run_control<'s>(
        &'s self,
        duration_s: f64,
        units: f64,
    ) -> Box<dyn FnMut(f64) -> Control + 's> {
        let mut reported = 0.0;
        Box::new(move |time_s| {
            let fraction = (time_s / duration_s).min(1.0);
            let more = (fraction - reported) * units;
            if more < LEAST && !self.interrupted() {
                return Control::Continue(());
            }
            reported = fraction;
            self.add(more)
        })
    }
}

/// Smallest increment worth reporting.
const LEAST: f64 = 1e-4;

/// Reports nothing and never cancels.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Progress for Silent {
    fn begin(&self, _: &str, _: f64) -> Box<dyn Work + '_> {
        Box::new(Self)
    }

    fn interrupted(&self) -> bool {
        false
    }
}

impl Work for Silent {
    fn add(&self, _: f64) -> Control {
        Control::Continue(())
    }

    fn interrupted(&self) -> bool {
        false
    }
}
