//! Cageless itself, through `simulation::run_from` as every command of it goes.

use anyhow::{Result, bail};
use cageless::Case;
use cageless::dynamics::state::State;
use cageless::simulation::{Control, Ending, run_from};

use super::peer::{Peer, Reached, TOLERANCES};
use crate::problem;

/// Methods, the case-file key that sets their precision, what that is, and its values
/// from coarse to fine. A method that the case file does not know yet is left out with a
/// word of it.
const METHODS: &[(&str, &str, &str, &[f64])] = &[
    (
        "abm4",
        "solver.step_us",
        "step, µs",
        &[1.0, 0.8, 0.5, 0.4, 0.25, 0.2, 0.1],
    ),
    (
        "symplectic",
        "solver.step_us",
        "step, µs",
        &[4.0, 2.0, 1.0, 0.5, 0.25, 0.125],
    ),
    ("adaptive", "solver.tolerance", "tolerance", &TOLERANCES),
];

/// One method of Cageless.
pub struct Cageless {
    method: &'static str,
    setting_name: &'static str,
    /// Settings, each with its case: reading a case lays out the raceway, which is no
    /// part of integrating.
    cases: Vec<(f64, Case)>,
    start: State,
    angles: Vec<f64>,
}

impl Cageless {
    /// Every method that exists, and a line for each that does not.
    ///
    /// # Errors
    /// The case has no start.
    pub fn all() -> Result<(Vec<Self>, Vec<String>)> {
        let (start, angles) = problem::start(&problem::cb74(&[])?)?;
        let (mut found, mut missing) = (vec![], vec![]);
        for &(method, key, setting_name, settings) in METHODS {
            let cases: Result<Vec<_>> = settings
                .iter()
                .map(|&setting| {
                    // The step of the case would bound the adaptive one.
                    let case = problem::cb74(&[
                        format!("solver.method={method}"),
                        "solver.step_us=auto".to_owned(),
                        format!("{key}={setting:?}"),
                    ])?;
                    Ok((setting, case))
                })
                .collect();
            match cases {
                Ok(cases) => found.push(Self {
                    method,
                    setting_name,
                    cases,
                    start: start.clone(),
                    angles: angles.clone(),
                }),
                Err(error) => missing.push(format!("no method \"{method}\" here: {error}")),
            }
        }
        Ok((found, missing))
    }
}

impl Peer for Cageless {
    fn name(&self) -> String {
        format!("Cageless {}", self.method)
    }

    fn equations(&self) -> &'static str {
        "library"
    }

    fn setting_name(&self) -> &'static str {
        self.setting_name
    }

    fn settings(&self) -> Vec<f64> {
        self.cases.iter().map(|(setting, _)| *setting).collect()
    }

    fn integrate(&self, setting: f64, duration_s: f64) -> Result<Reached> {
        let mut case = match self.cases.iter().find(|(own, _)| *own == setting) {
            Some((_, case)) => case.clone(),
            None => bail!("no case was prepared for {setting}"),
        };
        case.solver.duration_s = duration_s;
        let outcome = run_from(&case, &self.start, &self.angles, &mut [], &mut |_| {
            Control::Continue(())
        })?;
        match outcome.ending {
            Ending::Complete => Ok(Reached {
                z: problem::scaled(&outcome.state),
                evaluations: outcome.rhs_evaluations,
            }),
            ending => bail!("the run ended early: {ending:?}"),
        }
    }
}
