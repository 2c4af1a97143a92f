//! The little numerical analysis that the physics rests on.
//!
//! ```
//! use cageless::numerics::Moments;
//!
//! let mut moments = Moments::default();
//! moments.add(1.0, 1.0);
//! moments.add(3.0, 1.0);
//! assert_eq!(moments.mean, 2.0);
//! ```

pub(crate) mod aligned;
pub(crate) mod angle;
pub(crate) mod bspline;
pub(crate) mod chebyshev;
pub(crate) mod cholesky;
pub(crate) mod elliptic;
pub(crate) mod exponential;
pub(crate) mod inverse_root;
pub(crate) mod lane_set;
pub(crate) mod lanes;
pub(crate) mod minimum;
pub(crate) mod moments;
pub(crate) mod normal_equations;
pub(crate) mod proportion;
pub(crate) mod quadrature;
pub(crate) mod quantile;
pub(crate) mod random;
pub(crate) mod root;
pub(crate) mod student;
pub(crate) mod taylor;
pub(crate) mod vector;

pub use angle::wrap_angle_rad;
pub use bspline::Vec3;
pub use lanes::BATCH_WIDTH;
pub use moments::Moments;
pub use proportion::wilson_interval;
pub use quantile::quantile;
pub use random::{RandomStream, split_mix};
pub use root::{brent, last_where, try_brent};
pub use student::two_sided_limit;
pub use vector::{cross, dot};
