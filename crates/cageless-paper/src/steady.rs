//! The paper's bearing in steady operation: a conventional ring and structure (d) with the same draws of real balls,
//! the transient left out.

use cageless_io::case_file::{CaseError, CaseFile};
use cageless_study::comparison::{
    DRAWS, RingComparison, in_steady_operation, with_steady_operation,
};
use cageless_study::{StudyError, Task, Work};

use crate::cases::{READINGS, structure_file};
use crate::comparison::{CONVENTIONAL, STRUCTURE_D};

/// Conventional ring and structure (d) at 12 000 rpm with the housing of the experiment.
fn rings() -> Result<Vec<(String, CaseFile)>, CaseError> {
    let overrides = [
        "solver.method=\"verlet\"",
        "solver.step_us=\"auto\"",
        "housing.mass_kg=1.0",
        "housing.stiffness_n_m=1.0e8",
        "housing.damping_n_s_m=500.0",
    ];
    let discrete = structure_file(3, READINGS[1], &overrides.map(str::to_owned))?;
    let conventional = discrete.with_conventional_ring()?;
    let named = [(CONVENTIONAL, conventional), (STRUCTURE_D, discrete)];
    Ok(named
        .map(|(name, file)| (name.to_owned(), file))
        .into_iter()
        .collect())
}

/// Runs both rings.
pub fn compute(progress: &Work<'_>) -> Result<RingComparison, StudyError> {
    in_steady_operation(&rings()?, DRAWS, progress)
}

/// Adds both rings to a task.
pub fn add_to(task: Task) -> Result<Task, StudyError> {
    with_steady_operation(task, &rings()?, DRAWS)
}
