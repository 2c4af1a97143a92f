//! `summary.json`.

use std::collections::BTreeMap;
use std::path::Path;

use cageless::equilibrium;
use cageless::simulation::{Ending, RunOutcome};
use cageless::step_limits::StepLimits;
use cageless::summary::Summary;
use cageless::{Case, Method};
use serde::Serialize;

use super::atomic_file::write_atomically;
use super::error::ResultError;
use super::verification::VerificationFile;
use super::{SCHEMA, VERSION};
use crate::case_file::{CaseDocument, CaseFile};

/// The summary of a run. A number that is not finite becomes `null`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SummaryFile {
    /// Version of the layout, [`super::SCHEMA`].
    pub schema: u64,
    /// Version of Cageless.
    pub version: String,
    /// Instruction set.
    pub isa: String,
    /// The case as run, every default filled in.
    pub case: CaseDocument,
    /// Dotted keys of the case that took their default.
    pub defaults: Vec<String>,
    /// Number of collisions between balls.
    pub collisions: u64,
    /// Smallest gap.
    pub gap_min_deg: f64,
    /// Largest gap.
    pub gap_max_deg: f64,
    /// Mean place of the inner ring.
    pub ring_x_um_mean: f64,
    /// Mean place of the inner ring.
    pub ring_y_um_mean: f64,
    /// Largest sliding speed at a raceway.
    pub slip_max_m_s: f64,
    /// Energy balance error, relative to the sum of all energy flows.
    pub energy_residual_relative: f64,
    /// Terms of the energy ledger, J.
    pub energy: BTreeMap<String, f64>,
    /// Steps taken.
    pub steps: u64,
    /// Evaluations of the right-hand side.
    pub rhs_evaluations: u64,
    /// Time that the computation took.
    pub wall_s: f64,
    /// The statistics cover the run from here on.
    pub settled_after_s: f64,
    /// Warnings of the run.
    pub warnings: Vec<String>,
    /// Numerical verification, if requested.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub verification: Option<VerificationFile>,
    /// Reason of an early stop: the run left the physical range, or was interrupted.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub stopped: Option<Stopped>,
}

/// Reason of an early stop of a run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stopped {
    /// Simulated time reached.
    pub time_s: f64,
    /// Cause of the stop; [`Stopped::INTERRUPTED`] if the user ended the run.
    pub cause: String,
    /// Advice on what to change.
    pub advice: String,
}

impl Stopped {
    /// Cause of a run that the user ended: nothing is wrong with what it has.
    pub const INTERRUPTED: &str = "interrupted";
}

fn stopped(case: &Case, outcome: &RunOutcome) -> Option<Stopped> {
    match &outcome.ending {
        Ending::Stopped(stop) => Some(Stopped {
            time_s: stop.time_s,
            cause: stop.cause.to_string(),
            advice: stop.advice(),
        }),
        Ending::Interrupted => Some(Stopped {
            time_s: outcome.end_s,
            cause: Stopped::INTERRUPTED.to_owned(),
            advice: format!(
                "let it run to its end at {} s, or set solver.duration_s to less",
                case.solver.duration_s
            ),
        }),
        Ending::Complete | Ending::ObserverFailed(_) => None,
    }
}

impl SummaryFile {
    /// The summary of a run of `file`; `summary` is what the run's recorder has.
    pub fn new(
        file: &CaseFile,
        outcome: &RunOutcome,
        summary: Option<Summary>,
        wall_s: f64,
    ) -> Self {
        let mut energy: BTreeMap<String, f64> = outcome
            .state
            .layout()
            .energy_terms()
            .iter()
            .map(|&work| (work.name().to_owned(), outcome.state.energy_term_j(work)))
            .collect();
        energy.insert(
            "change".to_owned(),
            outcome.end_energy_j - outcome.start_energy_j,
        );
        let mut warnings = warnings(file.case());
        // A run that stopped says so itself.
        let residual = outcome.energy_residual_relative;
        if residual.abs() > RESIDUAL_FRACTION && !matches!(outcome.ending, Ending::Stopped(_)) {
            warnings.push(format!(
                "{:.1} % of all energy flows are unaccounted for: do not trust these numbers, set \
                 solver.step_us to less than the {} µs of this run",
                100.0 * residual,
                file.case().solver.step_s * 1e6
            ));
        }
        if summary.is_none() {
            warnings.push("the run ended within its transient: no statistics".to_owned());
        }
        let number = |f: fn(&Summary) -> f64| summary.as_ref().map_or(f64::NAN, f);
        Self {
            schema: SCHEMA,
            version: VERSION.to_owned(),
            isa: outcome.instruction_set.name().to_owned(),
            case: file.document_as_run(),
            defaults: file.defaults().to_vec(),
            collisions: summary.map_or(0, |s| s.collisions),
            gap_min_deg: number(|s| s.gap_min_rad).to_degrees(),
            gap_max_deg: number(|s| s.gap_max_rad).to_degrees(),
            ring_x_um_mean: number(|s| s.ring_x_mean_m * 1e6),
            ring_y_um_mean: number(|s| s.ring_y_mean_m * 1e6),
            slip_max_m_s: number(|s| s.slip_max_m_s),
            energy_residual_relative: outcome.energy_residual_relative,
            energy,
            steps: outcome.steps,
            rhs_evaluations: outcome.rhs_evaluations,
            wall_s,
            settled_after_s: number(|s| s.settled_after_s),
            warnings,
            verification: None,
            stopped: stopped(file.case(), outcome),
        }
    }

    /// The summary as indented JSON with a final line end.
    ///
    /// # Errors
    /// None that its fields can cause; those of the JSON writer are passed on.
    pub fn to_json(&self) -> Result<String, serde_json::Error> {
        serde_json::to_string_pretty(self).map(|json| json + "\n")
    }

    /// Writes `summary.json` in `dir`.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, dir: &Path) -> Result<(), ResultError> {
        let path = dir.join("summary.json");
        let json = self
            .to_json()
            .map_err(|e| ResultError::out(&path, std::io::Error::other(e)))?;
        write_atomically(&path, json.as_bytes())
    }
}

/// Largest step at which ABM4 stays unbiased without contact damping.
const UNDAMPED_STEP_S: f64 = 0.5e-6;

/// Share of all energy flows that may be unaccounted for without a warning.
const RESIDUAL_FRACTION: f64 = 0.01;

fn warnings(case: &Case) -> Vec<String> {
    let mut warnings: Vec<String> = equilibrium::overload(case).into_iter().collect();
    let method = case.solver.method;
    let limits = StepLimits::new(case);
    let resolved = limits.friction_resolved_to_s(method);
    if case.solver.step_s > resolved {
        warnings.push(format!(
            "friction of the smooth law decays faster than the step follows: slip near zero is \
             wrong above {:.2} µs (solver.step_us, contact.slip_scale_m_s)",
            resolved * 1e6
        ));
    }
    let (creep, knee) = (
        limits.creep_m_s2(method) * case.solver.step_s,
        case.contact.slip_scale_m_s,
    );
    if creep > knee {
        // One digit, down: what is said to be enough is enough.
        let enough_us = 1e6 * knee / limits.creep_m_s2(method);
        let power = enough_us.log10().floor();
        let digit = (enough_us / 10f64.powf(power)).floor();
        let enough_us = format!("{digit}e{power}").parse().unwrap_or(enough_us);
        warnings.push(format!(
            "Coulomb friction is far from its limit at this step: contacts that should roll creep \
             by up to {creep:.2} m/s, in proportion to the step, where the smooth law would by \
             {knee} m/s; slip and friction losses are too large. Set solver.step_us to {enough_us} or less, \
             or contact.friction_law = \"smooth\""
        ));
    }
    let undamped = case.contact.damping_n_s_m1_5 == 0.0;
    if method == Method::Abm4 && undamped && case.solver.step_s > UNDAMPED_STEP_S {
        warnings.push(
            "without contact damping ABM4 gains energy at steps above 0.5 µs: statistics are \
             biased (solver.step_us, or solver.method = \"symplectic\")"
                .to_owned(),
        );
    }
    warnings
}
