//! Vibration of the outer ring: the reaction of the balls through a housing.
//!
//! Each direction is one mass on a spring and a damper, M ẍ + c ẋ + k x = F(t), driven
//! by what the balls put on the outer ring. The ring stays fixed in the equations of
//! motion: the housing is stiff against what moves the balls.
//!
//! The acceleration is filtered, sampled and evaluated as it comes: memory does not grow
//! with the run.
//!
//! ```
//! use cageless::vibration::Measurement;
//!
//! // A sine of amplitude 2 sampled every 10 µs, kept at 10 kHz.
//! let mut measurement = Measurement::new(1e-5, 1e4, 0.0);
//! (0..100_000).for_each(|k| measurement.push(2.0 * (k as f64 * 0.01).sin()));
//! assert!((measurement.rms() - 2f64.sqrt()).abs() < 0.02);
//! ```

mod filter;
mod measurement;
mod oscillator;
mod passing;
mod response;
mod spectrum;
mod without_contacts;

pub use filter::{Decimator, FILTER_CORNER, FILTER_ORDER};
pub use measurement::{Measurement, STRETCH};
pub use passing::{LEAST_ORBITS, PassingSplit};
pub use response::HOUSING_INTERVAL_S;
pub use spectrum::{Spectrum, Welch, spectrum};
pub use without_contacts::{AFTER_CONTACT_S, WithoutContacts};

use crate::case::Housing;
use crate::simulation::{Control, Observer, ObserverError, RunContext, StepView};
use response::Response;

/// Measures the acceleration of the housing.
///
/// The force is averaged over the time between samples (a first defence against
/// aliasing of the 30 kHz bounce of the balls), then moves the housing exactly as a
/// force constant over that time would.
pub struct VibrationRecorder {
    response: Response,
}

impl VibrationRecorder {
    /// Recorder for a housing, sampled at `rate_hz`, without the transient before `after_s`.
    pub fn new(housing: &Housing, rate_hz: f64, after_s: f64) -> Self {
        Self {
            response: Response::new(housing, rate_hz, after_s),
        }
    }

    /// Acceleration of the outer ring along x and y, m/s².
    pub fn measurements(&self) -> &[Measurement; 2] {
        &self.response.measurements
    }
}

impl Observer for VibrationRecorder {
    fn begin(&mut self, context: &RunContext<'_>) -> Result<(), ObserverError> {
        self.response.begin(context);
        Ok(())
    }

    fn step(&mut self, view: &StepView<'_, '_>) -> Result<Control, ObserverError> {
        self.response.add(
            view.step.t0_s,
            view.step.t1_s,
            view.contacts.outer_ring_force_n(),
        );
        Ok(Control::Continue(()))
    }
}
