//! Sensitivity of the verdict on a raceway to the tolerances of machining and operation.
//!
//! Every deviation is a [`Trial`]; the caller judges each, on as many threads as there are, and [`assess`] puts the
//! outcomes together.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::simulation::Control;
//! use cageless_design::judge;
//! use cageless_design::tolerance::{Outcome, Tolerances, assess, trials};
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2
//! let tolerances = Tolerances { groove_depth_m: 2e-6, ..Tolerances::default() };
//! // The raceway as drawn, and each deviation alone at both its ends; no bearings in which everything deviates.
//! let trials = trials(&case, &tolerances, 0, 1);
//! let mut outcomes = vec![];
//! for trial in &trials {
//!     let varied = trial.deviation.apply(&case)?;
//!     let judgement = judge(&varied, &mut |_done| Control::Continue(()))?;
//!     outcomes.push(Some(Outcome::judged(&judgement)));
//! }
//! println!("{}", assess(&trials, &outcomes).headline());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assessment;
mod deviation;
mod sample_count;

pub use assessment::{Assessment, InfluenceResult, Interval, Outcome, Samples, assess};
pub use deviation::{Deviation, Influence, Tolerances, Trial, ball_lot_m, trials};

pub use sample_count::SampleCount;
