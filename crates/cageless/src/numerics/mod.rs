//! The little numerical analysis that the physics rests on.

pub mod bspline;
pub mod chebyshev;
pub mod elliptic;
pub mod moments;
pub mod quadrature;
pub mod root;
pub mod student;
