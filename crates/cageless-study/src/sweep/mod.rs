//! Sweeps: many variants of a case or of a rotor in several bearings, computed on all cores, in
//! shards or by a scheduler of your own, and lost by no interruption.
//!
//! A plan ([`cageless_io::plan_file`]) and the index of a variant say everything about it:
//! [`Sweep::evaluate`] gives the same rows whenever and wherever it is called, on one
//! instruction set. [`run`] computes all of them into one file, [`merge`] joins shards,
//! [`analysis`] reads the result for a report.
//!
//! ```
//! use cageless::simulation::Control;
//! use cageless_io::case_file::template;
//! use cageless_io::plan_file::PlanFile;
//! use cageless_study::sweep::Sweep;
//!
//! let plan = r#"
//!     compute = ["static"]
//!     case = "case.toml"
//!     [grid]
//!     operation.radial_load_n = [500.0, 1500.0]
//! "#;
//! let folder = std::env::temp_dir().join("cageless-study-doc-sweep");
//! std::fs::create_dir_all(&folder)?;
//! std::fs::write(folder.join("case.toml"), template(false))?;
//! let sweep = Sweep::new(PlanFile::parse(plan, "plan", &folder)?)?;
//! assert_eq!(sweep.variants(), 2);
//! let rows = sweep.evaluate(0..2, &|| Control::Continue(())).expect("not interrupted");
//! let depth = sweep.column("static_ring_y_um").expect("a column");
//! assert!(rows[1][depth].number() < rows[0][depth].number());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod analysis;
mod checkpoint;
mod collection;
mod evaluate;
mod expected;
mod failures;
mod feasibility;
mod footer;
mod latin_hypercube;
mod merge;
mod outputs;
mod random;
mod run;
mod shard;
mod sobol;
mod variants;

pub use collection::{Collection, write_part};
pub use evaluate::{Cancellation, Sweep};
pub use failures::{Failures, failures};
pub use footer::Identity;
pub use merge::merge;
pub use run::{Done, Job, Progress, run, run_announced};
pub use shard::Shard;
