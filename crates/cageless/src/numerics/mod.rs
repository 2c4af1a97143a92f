//! The little numerical analysis that the physics rests on.
//!
//! ```
//! use cageless::numerics::moments::Moments;
//!
//! let mut moments = Moments::default();
//! moments.add(1.0, 1.0);
//! moments.add(3.0, 1.0);
//! assert_eq!(moments.mean(), 2.0);
//! ```

pub(crate) mod aligned;
pub mod angle;
pub mod bspline;
pub(crate) mod chebyshev;
pub(crate) mod cholesky;
pub(crate) mod elliptic;
pub(crate) mod exponential;
pub(crate) mod inverse_root;
pub(crate) mod lane_set;
pub mod lanes;
pub(crate) mod minimum;
pub mod moments;
pub(crate) mod normal_equations;
pub mod proportion;
pub(crate) mod quadrature;
pub mod quantile;
pub mod random;
pub(crate) mod root;
pub mod student;
pub(crate) mod taylor;
pub mod vector;
