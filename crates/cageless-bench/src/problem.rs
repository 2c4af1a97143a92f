//! The two problems: a case for the error and one for the time, and the true end of the former.

use anyhow::{Context, Result, bail, ensure};
use cageless::dynamics::{Layout, State};
use cageless::initial_state;
use cageless::reference::Textbook;
use cageless::simulation::{self, Control, Ending, RunOutcome};
use cageless::{Case, Formulation, FrictionModel, IntegrationMethod};
use cageless_io::case_file::CaseFile;

const CB74: &str = include_str!("../../../cases/cb74.toml");
const TOUCHDOWN: &str = include_str!("../../../cases/touchdown-d.toml");
const REFERENCE: &str = include_str!("../../cageless-io/tests/reference/cb74_2ms.csv");

/// Time at which errors are taken, s.
const ERROR_S: f64 = 0.002;
/// Simulated time of each timing of a run and of a drop, s.
const TIMED_S: [f64; 2] = [0.01, 0.1];

/// A case to integrate for its error, one for the time, and the true end of the former.
pub struct Problem {
    /// Run of 2 ms, whose end the reference trajectory gives.
    pub short: Case,
    /// Case for the timing: 0.01 s of a run, 0.1 s of a drop.
    pub timed: Case,
    /// Scaled state at the end of `short`.
    pub reference: Vec<f64>,
}

impl Problem {
    /// CB74 with its quadruple-precision trajectory; with changes that of the adaptive method.
    ///
    /// # Errors
    /// A change that the case file does not admit.
    pub fn run(changes: &[String]) -> Result<Self> {
        let case = read(CB74, changes)?;
        let short = lasting(&case, ERROR_S);
        Ok(Self {
            reference: if changes.is_empty() {
                quadruple_precision(Layout::of_case(&short))?
            } else {
                tight(&short)?
            },
            short,
            timed: lasting(&case, TIMED_S[0]),
        })
    }

    /// A drop. The rotor of the short one is just above contact, at the speed of its fall.
    ///
    /// # Errors
    /// A change that the case file does not admit.
    pub fn drop(changes: &[String]) -> Result<Self> {
        // The textbook has the flanks and ends of the paper.
        let flanks = ["model.flanks=rigid", "raceway.blend_mm=0"].map(str::to_owned);
        let case = read(TOUCHDOWN, &[&flanks[..], changes].concat())?;
        let mut short = lasting(&case, ERROR_S);
        let rotor = short.rotor.as_mut().context("a rotor")?;
        rotor.y_m = -0.995 * rotor.radial_clearance_m;
        rotor.vy_m_s = -(2.0 * case.operation.gravity_m_s2 * rotor.radial_clearance_m).sqrt();
        Ok(Self {
            reference: tight(&short)?,
            short,
            timed: lasting(&case, TIMED_S[1]),
        })
    }
}

fn read(text: &str, changes: &[String]) -> Result<Case> {
    let case = CaseFile::parse(text, "the case", changes)?.case().clone();
    ensure!(
        case.formulation == Formulation::Physical
            && case.contact.friction_law == FrictionModel::Smooth,
        "the textbook has the physical formulation with smooth friction only"
    );
    Ok(case)
}

fn lasting(case: &Case, duration_s: f64) -> Case {
    let mut case = case.clone();
    case.solver.duration_s = duration_s;
    case
}

/// Runs a case to its end, without observers.
///
/// # Errors
/// It ends early.
pub fn complete(case: &Case) -> Result<RunOutcome> {
    let outcome = simulation::run(case, &mut [], &mut |_| Control::Continue(()))?;
    match outcome.ending {
        Ending::Complete => Ok(outcome),
        ending => bail!("the run ended early: {ending:?}"),
    }
}

/// Scaled state at the end by the adaptive method at a tolerance of 1e-11.
fn tight(case: &Case) -> Result<Vec<f64>> {
    let mut case = case.clone();
    case.set_method(IntegrationMethod::Adaptive);
    case.solver.tolerance = 1e-11;
    Ok(scaled(&complete(&case)?.state))
}

/// Scaled state of a case at its start.
///
/// # Errors
/// The start has no equilibrium.
pub fn start(case: &Case) -> Result<Vec<f64>> {
    Ok(scaled(&initial_state(case)?.0))
}

/// Motion of a state in the scales of its entries.
pub fn scaled(state: &State) -> Vec<f64> {
    let layout = state.layout();
    over_scales(&Textbook::motion(layout, state.values()), layout)
}

fn over_scales(motion: &[f64], layout: Layout) -> Vec<f64> {
    let scales = Textbook::scales(layout);
    motion
        .iter()
        .zip(scales)
        .map(|(v, scale)| v / scale)
        .collect()
}

/// The reference of CB74 at 2 ms, scaled.
fn quadruple_precision(layout: Layout) -> Result<Vec<f64>> {
    let rows: Vec<Vec<f64>> = REFERENCE
        .lines()
        .filter(|line| !line.starts_with('#') && !line.starts_with("body"))
        .map(|line| line.split(',').skip(1).flat_map(str::parse).collect())
        .collect();
    let (ring, balls) = rows.split_last().context("rows of the reference")?;
    let motion: Vec<f64> = (0..balls[0].len())
        .flat_map(|group| balls.iter().map(move |row| row[group]))
        .chain(ring.iter().copied())
        .collect();
    Ok(over_scales(&motion, layout))
}

/// RMS over the states of the difference of two scaled states.
pub fn rms_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let sum: f64 = a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum();
    (sum / a.len() as f64).sqrt()
}
