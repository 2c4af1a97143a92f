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
//! use cageless::Housing;
//! use cageless::prelude::*;
//! use cageless::vibration::VibrationRecorder;
//!
//! let housing = Housing { mass_kg: 1.0, stiffness_n_m: 1e8, damping_n_s_m: 500.0 };
//! let mut recorder = VibrationRecorder::new(&housing, 1e5, 0.0);
//! Simulation::new(&reference::conventional())?.run(1e-3, &mut [&mut recorder]);
//! let [_across, along] = recorder.measurements();
//! assert!(along.rms() > 0.0);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod filter;
mod measurement;
mod oscillator;
mod passing;
mod response;
mod spectrum;

pub use filter::{FILTER_CORNER, FILTER_ORDER};
pub use spectrum::Spectrum;

pub use measurement::Measurement;
pub use passing::PassingSplit;

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
    /// Contacts between balls that are cut out.
    cut: Option<Cut>,
}

/// Time after a contact between balls in which the balls still bounce between the raceways.
pub const AFTER_CONTACT_S: f64 = 1e-4;

/// Straight line in place of the force of a contact.
struct Cut {
    /// Start of the line; `None` outside of contacts.
    from_s: Option<f64>,
    touched_s: f64,
}

impl VibrationRecorder {
    /// Recorder for a housing, sampled at `rate_hz`, without the transient before `after_s`.
    pub fn new(housing: &Housing, rate_hz: f64, after_s: f64) -> Self {
        Self {
            response: Response::new(housing, rate_hz, after_s),
            cut: None,
        }
    }

    /// Recorder under a force from which the contacts between balls are cut out: from the touch of any
    /// two balls until [`AFTER_CONTACT_S`] after they part it is replaced by a straight line between its
    /// values before and after.
    ///
    /// The response of the housing is linear: the difference from what [`Self::new`] measures is the
    /// response to what was cut out. Slip that a contact leaves for longer, and the friction that ends
    /// it, stay in.
    pub fn without_contacts(housing: &Housing, rate_hz: f64, after_s: f64) -> Self {
        Self {
            cut: Some(Cut {
                from_s: None,
                touched_s: f64::NEG_INFINITY,
            }),
            ..Self::new(housing, rate_hz, after_s)
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

    fn step(&mut self, view: &StepView<'_>) -> Result<Control, ObserverError> {
        let (mut from_s, to_s) = (view.step.t0_s, view.step.t1_s);
        if let Some(cut) = &mut self.cut {
            if view.contacts.balls_touch() {
                cut.touched_s = to_s;
            }
            if to_s - cut.touched_s < AFTER_CONTACT_S {
                cut.from_s.get_or_insert(from_s);
                return Ok(Control::Continue(()));
            }
            from_s = cut.from_s.take().unwrap_or(from_s);
        }
        let force_n = view.contacts.outer_ring_force_n();
        self.response.add(from_s, to_s, force_n);
        Ok(Control::Continue(()))
    }
}
