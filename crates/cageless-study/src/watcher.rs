//! Who hears of long work.

use cageless::simulation::Control;

/// Hears of long work as it begins, part by part.
pub trait Watcher: Sync {
    /// Work of so many `units` begins; they are an estimate of the work and have no dimension.
    fn begin(&self, what: &str, units: f64) -> Box<dyn Work + '_>;

    /// Whether the work is to end.
    fn interrupted(&self) -> bool;
}

/// Work in progress, until it is dropped. Threads share it.
pub trait Work: Sync {
    /// So many units more are done; says whether to go on.
    fn add(&self, units: f64) -> Control;

    /// Whether the work is to end.
    fn interrupted(&self) -> bool;

    /// [`Control::Interrupt`] once the work is to end.
    fn control(&self) -> Control {
        if self.interrupted() {
            Control::Interrupt
        } else {
            Control::Continue
        }
    }

    /// A control for one run of `duration_s`, or with 1 for work that reports the fraction that is
    /// done, that counts as `units`.
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
                return Control::Continue;
            }
            reported = fraction;
            self.add(more)
        })
    }
}

/// Work need not be told of less.
const LEAST: f64 = 1e-4;

/// Watches nothing and never ends the work.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Watcher for Silent {
    fn begin(&self, _: &str, _: f64) -> Box<dyn Work + '_> {
        Box::new(Self)
    }

    fn interrupted(&self) -> bool {
        false
    }
}

impl Work for Silent {
    fn add(&self, _: f64) -> Control {
        Control::Continue
    }

    fn interrupted(&self) -> bool {
        false
    }
}
