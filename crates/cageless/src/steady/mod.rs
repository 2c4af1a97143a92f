//! Steady operation of a bearing with real balls: what a discrete raceway or one ball fewer is judged by.
//!
//! Balls of one size keep whatever spacing they start with. Real ones differ by fractions of a micrometre, and a
//! larger one orbits faster: dω/ω = dR/(Ro − R), some 0.1 °/s for 0.1 µm at 12 000 rpm. On a conventional ring the
//! faster catch up with the slower; touching balls move on together, at the mean of their speeds. By the cycle lemma
//! exactly one ball can lead all the others: no group at the head of the queue is faster than the rest
//! (`leading_ball`). That queue is where every conventional ring ends, after minutes from an even start. A run of
//! steady operation begins there, and leaves out the orbits in which a raceway spreads the balls or the queue closes.
//!
//! ```
//! use cageless::reference;
//! use cageless::steady::HeldPair;
//! use cageless::ball_grade;
//!
//! let pair = HeldPair {
//!     critical_gap_rad: 1.417f64.to_radians(),
//!     steady_gap_rad: 1.944f64.to_radians(),
//! };
//! let contacts = pair.contacts_per_orbit(&reference::bearing(), ball_grade(10).unwrap());
//! assert!((0.9..=1.0).contains(&contacts));
//! ```

mod held_pair;
mod operation;
mod queue;
mod recorder;
mod stationarity;
mod summary;

pub use held_pair::HeldPair;
pub(crate) use operation::GRADE;
pub use operation::{BenefitWeights, SteadyDraw, SteadyOperation, SteadyStart};
pub(crate) use queue::leading_ball;
pub use recorder::{SteadyBlock, SteadyRecorder};
pub use stationarity::{Settling, Stationarity};
pub use summary::SteadySummary;
