//! Drops of a rotor into its bearings: one drop, the same with conventional outer rings, many whose
//! conditions scatter, and its verification.

mod benefit;
mod distribution;
mod ensemble;
mod filed_drop;
mod length;
mod quantiles;
mod record;
mod side_by_side;
mod standstill;
mod study;
mod succession;
mod summary;
mod verification;

pub use benefit::{DropBenefit, DropCriterion};
pub use distribution::{
    BearingRow, DROPS_MAX, Distribution, EndStateCount, PassProbability, WhirlProbability,
    check_drops,
};
pub use ensemble::{DropRow, Ensemble, ensemble};
pub use filed_drop::FiledDrop;
pub use quantiles::Quantiles;
pub(crate) use record::steps;
pub use record::{BearingRecord, DropRecord};
pub(crate) use side_by_side::{drop_task, run_drops, worth_together};
pub use study::{DropRequest, DropStudy, foreseen, study};
pub use succession::Succession;
