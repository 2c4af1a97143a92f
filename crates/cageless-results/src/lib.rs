//! Results of computations: one table ([`quantities`]) with the name, unit, label, better direction and
//! function of each. JSON, terminal, tables of pages, columns of sweeps, comparisons, CSV and the
//! Python package are views of it.

mod across;
mod asperities;
mod bearing_number;
mod cell;
mod computation;
mod declare;
mod design_result;
mod drop_judgement;
mod drop_result;
mod drop_run;
mod dry_verdict;
mod limited;
#[cfg(test)]
mod list_tests;
#[rustfmt::skip]
mod meanings;
mod film_notes;
mod group;
mod judged;
mod kind;
mod measured_result;
pub mod number_text;
mod open_benefit;
mod overheating;
mod particulars;
mod place;
mod provenance;
mod quantity;
mod record;
mod results;
mod search_result;
mod source;
mod static_result;
mod stopped;
mod successive_drop;
mod table;
#[cfg(test)]
mod tests;
mod thin_inlet;
mod tolerance_result;
mod unit;
mod verification_result;
mod view;

pub use across::Across;
pub use asperities::slippery_asperities;
pub use bearing_number::{bearing_number, on_bearing};
pub use cell::Cell;
pub use computation::Computation;
pub use design_result::{Recommended, axial_record, design_record};
pub use drop_judgement::DropJudgement;
pub use drop_result::{DropResult, ShownBeside, WindowRow, end_state_text};
pub use drop_run::{DropRun, plane_records};
pub use dry_verdict::DryVerdict;
pub use judged::{JudgedResult, Named, VerifiedDrop};
pub use kind::Kind;
pub use limited::{LIMITED, LimitJudgement, judged_limit};
pub use measured_result::{MEASURED_SHAPE, measured_rows};
pub use open_benefit::open_benefit;
pub use overheating::overheating;
pub use particulars::Particulars;
pub use place::result_at;
pub use provenance::{Provenance, instruction_set, provenance, software};
pub use quantity::{Aim, Quantity, bearing_in_column};
pub use record::{Part, Record, Shape};
pub use results::{Results, Shown, value_text};
pub use search_result::SEARCH_SHAPE;
pub use source::{
    AtPoint, CountedVerdict, Deviation, Dimension, Finished, FinishedDrop, FittedRaceway,
    FittedRing, Judged, JudgedRaceway, Sampled, Searched, SearchedPlacement, Solved, Subject,
    SuccessiveDrop, Tolerated,
};
pub use static_result::{equilibrium_record, equilibrium_record_noted, static_record};
pub use stopped::Stopped;
pub use successive_drop::succession_record;
pub use table::unit::millipascal_seconds;
pub use table::{
    AXIAL, CLEARANCE_RANGE, COMPARED, CONTACT_ANGLE, DEFECTS, DESIGN, DIMENSION, DROP, FILM,
    FILM_VERDICT, FIT, FRAME, GROOVE, LUBRICATION, MAP, MEASURED, MOTION, PAPER, PASSAGES,
    PLACEMENT, POINT, PROFILE, RACEWAY, REJECTION, ROTOR_DROP, ROTOR_VERIFICATION, RUN, SEARCH,
    SLOT, SPACE, STATIC, STEADY, STRUCTURE, STRUCTURE_AT, SUCCESSION, VERDICT, of_column, of_kind,
    quantities,
};
pub use thin_inlet::thin_inlet;
pub use tolerance_result::{TOLERANCE_SHAPE, tolerance_record};
pub use unit::{unit_text, with_unit};
pub use verification_result::{step_warning, verification_record};
pub use view::{heading, table_of, table_of_judgements};
