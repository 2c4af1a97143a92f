//! Drops of a rotor into its bearings: one drop, the same with conventional outer rings, many whose
//! conditions scatter, and its verification.

mod bearings;
mod distribution;
mod ensemble;
mod record;
mod side_by_side;
mod study;
mod succession;
mod summary;
mod verification;

pub use bearings::Bearings;
pub use distribution::{
    BearingRow, DROPS_MAX, Distribution, EndStateCount, Quantiles, WhirlProbability, check_drops,
};
pub use ensemble::{DropRow, Ensemble, RotorRow, ensemble};
pub use record::{BearingRecord, DropRecord};
pub(crate) use side_by_side::run_drops;
pub use study::{DropRequest, DropStudy, study, unloaded};
pub use succession::Succession;
