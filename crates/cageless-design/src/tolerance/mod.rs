//! Sensitivity of the verdict to manufacturing and operating tolerances: within
//! tolerances.
//!
//! ```
//! use cageless::ball_grade;
//!
//! assert!(ball_grade(10).is_some()); // ISO 3290-1, G10
//! assert!(ball_grade(11).is_none());
//! ```

mod assessment;
mod deviation;
mod sample_count;

pub use assessment::{Assessment, InfluenceResult, Interval, Outcome, Samples, assess};
pub use deviation::{Deviation, Influence, Tolerances, Trial, ball_lot_m, trials};

pub use sample_count::SampleCount;
