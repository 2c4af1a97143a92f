//! The solvers that Cageless is compared with.

use super::cvode;
#[cfg(feature = "peers")]
use super::{diffsol, ode_solvers};

use super::peer::{Follow, Problem};
use crate::equations::Implementation;

/// What a build without the feature `peers` has to say.
pub const LEFT_OUT: Option<&str> = if cfg!(feature = "peers") {
    None
} else {
    Some("ode_solvers and diffsol left out: build with --features peers.")
};

/// Every solver on the problem.
pub fn others<'p>(
    problem: &'p Problem,
    driver: Option<&'p cvode::Driver>,
    equations: Implementation,
) -> Vec<Box<dyn Follow + 'p>> {
    let mut solvers: Vec<Box<dyn Follow + 'p>> = vec![];
    #[cfg(feature = "peers")]
    for method in [ode_solvers::Method::Dopri5, ode_solvers::Method::Dop853] {
        solvers.push(Box::new(ode_solvers::OdeSolvers {
            problem,
            method,
            equations,
        }));
    }
    #[cfg(feature = "peers")]
    for method in [diffsol::Method::Tsit45, diffsol::Method::Bdf] {
        solvers.push(Box::new(diffsol::Diffsol {
            problem,
            method,
            equations,
        }));
    }
    if let Some(driver) = driver {
        for method in [cvode::Method::Adams, cvode::Method::Bdf] {
            solvers.push(Box::new(cvode::Cvode {
                problem,
                method,
                driver,
                equations,
            }));
        }
    }
    solvers
}
