//! Files of Cageless: case files and plans in TOML, results in Parquet and JSON, the outer
//! ring in STEP, STL and as points.
//!
//! Human units (`_mm`, `_deg`, `_rpm`, `_us`) exist only here and in figures;
//! [`cageless`] itself is plain SI.
//!
//! The feature `files`, on by default, adds everything but case files: plans, results, CAD and
//! journals. Without it the crate compiles for `wasm32-unknown-unknown` with few dependencies.
//!
//! ```
//! use cageless_io::case_file::{CaseFile, template};
//!
//! let file = CaseFile::parse(&template(false), "template", &[])?;
//! assert_eq!(file.case().bearing.balls(), 14);
//! assert_eq!(file.document().number("operation.radial_load_n"), Some(1500.0));
//! # Ok::<(), cageless_io::case_file::CaseError>(())
//! ```

#![cfg_attr(not(feature = "files"), allow(dead_code))]

#[cfg(feature = "files")]
pub mod arrangement;
#[cfg(feature = "files")]
pub mod cad;
pub mod case_file;
#[cfg(feature = "files")]
pub mod declared;
pub mod designation;
pub mod estimate;
#[cfg(feature = "files")]
mod files;
#[cfg(feature = "files")]
pub mod journal;
mod option_error;
pub mod own_bearing;
#[cfg(feature = "files")]
pub mod plan_file;
#[cfg(feature = "files")]
pub mod point_file;
#[cfg(feature = "files")]
pub mod results;
#[cfg(feature = "files")]
pub mod rotor_file;
mod system;
mod terminal;
mod text_file;
pub mod touchdown_template;

#[cfg(feature = "files")]
pub use files::open_locked;
pub use option_error::OptionError;
pub use system::io_error_message;
pub use terminal::{bounded, on_terminal};
