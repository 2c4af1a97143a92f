//! Vibration that is left when the impacts between balls are taken out of the force.

use super::measurement::Measurement;
use super::response::Response;
use crate::case::Housing;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};

/// Time after a contact between balls in which the balls still bounce between the raceways.
pub const AFTER_CONTACT_S: f64 = 1e-4;

/// Measures the acceleration of the housing under a force from which the contacts between balls
/// are cut out: from the touch of any two balls until [`AFTER_CONTACT_S`] after they part it is
/// replaced by a straight line between its values before and after.
///
/// The response of the housing is linear: the difference from what
/// [`VibrationRecorder`](super::VibrationRecorder) measures is the response to what was cut
/// out. Slip that a contact leaves for longer, and the friction that ends it, stay in.
pub struct WithoutContacts {
    response: Response,
    /// Start of the straight line; `None` outside of contacts.
    cut_from_s: Option<f64>,
    touched_s: f64,
}

impl WithoutContacts {
    /// Recorder for a housing, sampled at `rate_hz`, without the transient before `after_s`.
    pub fn new(housing: &Housing, rate_hz: f64, after_s: f64) -> Self {
        Self {
            response: Response::new(housing, rate_hz, after_s),
            cut_from_s: None,
            touched_s: f64::NEG_INFINITY,
        }
    }

    /// Acceleration of the outer ring along x and y, m/s².
    pub fn measurements(&self) -> &[Measurement; 2] {
        &self.response.measurements
    }
}

impl Observer for WithoutContacts {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.response.begin(context);
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        let (from_s, to_s) = (view.step.t0_s, view.step.t1_s);
        if view.contacts.balls_touch() {
            self.touched_s = to_s;
        }
        if to_s - self.touched_s < AFTER_CONTACT_S {
            self.cut_from_s.get_or_insert(from_s);
        } else {
            let from_s = self.cut_from_s.take().unwrap_or(from_s);
            self.response
                .add(from_s, to_s, view.contacts.outer_ring_force_n());
        }
        Ok(Control::Continue(()))
    }
}
