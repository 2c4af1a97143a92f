//! Results of computations: one table ([`quantities`]) with the name, unit, label, better direction and
//! function of each. JSON, terminal, tables of pages, columns of sweeps, comparisons, CSV and the
//! Python package are views of it.

mod across;
mod cell;
mod computation;
mod csv;
mod declare;
mod design_result;
mod drop_judgement;
mod drop_result;
#[cfg(test)]
mod list;
mod meanings;
pub mod number_text;
mod quantity;
mod record;
mod results;
mod source;
mod static_result;
mod table;
#[cfg(test)]
mod tests;

pub use across::Across;
pub use cell::Cell;
pub use computation::Computation;
pub use csv::csv;
pub use design_result::{Recommended, design_record};
pub use drop_judgement::{DropJudgement, RESIDUAL_FRACTION};
pub use drop_result::{DropResult, RotorRun, WindowRow, end_state_text};
pub use quantity::{Aim, Kind, Quantity, bearing_in_column};
pub use record::{Part, Record};
pub use results::{Results, value_text};
pub use source::{Finished, FinishedDrop, FinishedRotor, Judged, JudgedRaceway, Solved, Subject};
pub use static_result::static_record;
pub use table::{
    DESIGN, DROP, PASSAGES, RACEWAY, ROTOR_DROP, RUN, STATIC, VERDICT, of_column, of_kind,
    quantities,
};
