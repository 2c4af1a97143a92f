//! Requests of pages that compute, answered from a case.
//!
//! [`answer`] takes one JSON document with the operation in `op` and the case as TOML in `case`,
//! and returns one with the result in `ok` or the message in `error`. It keeps nothing between
//! two requests: a motion goes on from the state that the page sends back. The page needs
//! nothing else, whether the engine runs in the page (`cageless-wasm`) or behind
//! `cageless studio`.
//!
//! ```
//! use cageless_live::{Control, answer};
//!
//! let wrong = answer(r#"{"op": "static", "case": "balls = 3"}"#, &mut |_| Control::Continue(()));
//! assert!(wrong.contains("\"error\""));
//! ```

mod compare;
mod geometry;
mod keys;
mod map;
mod motion;
mod plain_film;
mod ranges;
mod refusal;
mod request;
mod verdict;

pub use cageless::simulation::Control;
pub use refusal::{Refusal, answered, parsed};
pub use request::{REQUEST_BYTES_MAX, answer};
