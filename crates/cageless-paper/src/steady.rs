//! The paper's bearing in steady operation: a conventional ring and structure (d) with the same draws of real balls,
//! the transient left out.

use cageless_io::case_file::{CaseError, CaseFile};
use cageless_study::comparison::{
    DRAWS, RingComparison, in_steady_operation, with_steady_operation,
};
use cageless_study::{StudyError, Task, Work};

use crate::cases::{HOUSING, READINGS, structure_file};
use crate::comparison::{CONVENTIONAL, STRUCTURE_D};

/// Conventional ring and structure (d) at 12 000 rpm with the housing of the experiment.
fn rings() -> Result<Vec<(String, CaseFile)>, CaseError> {
    let method = ["solver.method=\"verlet\"", "solver.step_us=\"auto\""];
    let overrides: Vec<String> = method
        .into_iter()
        .chain(HOUSING)
        .map(str::to_owned)
        .collect();
    let discrete = structure_file(3, READINGS[1], &overrides)?;
    let conventional = discrete.with_conventional_ring()?;
    Ok(vec![
        (CONVENTIONAL.to_owned(), conventional),
        (STRUCTURE_D.to_owned(), discrete),
    ])
}

/// Runs both rings.
pub fn compute(progress: &Work<'_>) -> Result<RingComparison, StudyError> {
    in_steady_operation(&rings()?, DRAWS, progress)
}

/// Adds both rings to a task.
pub fn add_to(task: Task) -> Result<Task, StudyError> {
    with_steady_operation(task, &rings()?, DRAWS)
}
