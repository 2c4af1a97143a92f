//! Sensitivity of the verdict to manufacturing and operating tolerances: within
//! tolerances.
//!
//! ```
//! use cageless::tolerance::ball_grade;
//!
//! assert!(ball_grade(10).is_some()); // ISO 3290-1, G10
//! assert!(ball_grade(11).is_none());
//! ```

mod assessment;
mod deviation;
mod grade;
mod sample_count;

pub use assessment::{Assessment, InfluenceResult, Interval, Outcome, Samples, assess};
pub use deviation::{Deviation, Influence, Tolerances, Trial, ball_lot_m, trials};
pub use grade::{BallGrade, ball_grade, ball_grades_text};
pub use sample_count::SampleCount;
