//! Table 2: theory and critical gap of the ten structures, and how far the gaps move with
//! what the paper leaves open.

use std::f64::consts::FRAC_PI_2;

use cageless::closed_forms::{Eq11, theoretical_gap_rad};
use cageless::{Case, FlankModel, Formulation, FrictionModel};
use cageless_design::critical_gap::{CriticalGapError, PairTest, Touch, critical_gap_rad};
use cageless_report::{Provenance, Spread, Table2, Table2Row, Variant};
use rayon::prelude::*;

use crate::cases::{self, ODD_ROW, PUBLISHED, Reading, label};
use cageless_study::threads::each;
use cageless_study::{StudyError, Work};

/// A column: one reading of the paper on flanks of one kind.
#[derive(Clone, Copy)]
struct Column {
    reading: Reading,
    flanks: FlankModel,
}

impl Column {
    const fn rigid(formulation: Formulation, law: FrictionModel) -> Self {
        Self {
            reading: Reading::new(formulation, law),
            flanks: FlankModel::Rigid,
        }
    }

    /// Head of the column.
    fn variant(&self) -> Variant {
        Variant {
            formulation: match self.flanks {
                FlankModel::Rigid => self.reading.formulation.name().to_owned(),
                FlankModel::Elastic => Variant::ELASTIC.to_owned(),
            },
            friction_law: self.reading.law.name().to_owned(),
        }
    }
}

/// Columns: what the paper can be read as, and the flanks of metal.
const COLUMNS: [Column; 5] = [
    Column::rigid(Formulation::Paper, FrictionModel::Coulomb),
    Column::rigid(Formulation::Paper, FrictionModel::Smooth),
    Column::rigid(Formulation::Physical, FrictionModel::Coulomb),
    Column::rigid(Formulation::Physical, FrictionModel::Smooth),
    Column {
        reading: Reading::CONSISTENT,
        flanks: FlankModel::Elastic,
    },
];
/// Columns whose spread is shown.
const SPREAD_OF: [usize; 2] = [0, 3];
/// Step of the table, µs: the Coulomb columns are of order one in it.
const STEP_US: f64 = 0.25;
/// Step at which the spreads are measured, µs.
const SPREAD_STEP_US: f64 = 1.0;

/// Steps, about.
pub const WORK: f64 = 5.1e6;

/// Table 2 with what other parts of the report need of it.
#[derive(Debug, Clone)]
pub struct Computed {
    /// For the page.
    pub table: Table2,
}

/// One change of what the paper leaves open.
#[derive(Clone, Copy)]
struct Change {
    cause: &'static str,
    overrides: &'static [&'static str],
    step_us: f64,
    test: PairTest,
}

impl Change {
    /// Whether it computes the same.
    fn is(&self, other: &Self) -> bool {
        (self.overrides, self.step_us, self.test) == (other.overrides, other.step_us, other.test)
    }
}

/// Nothing changed, at the step of the spreads. The steps of the table are its own.
fn base() -> Change {
    Change {
        cause: "",
        overrides: &[],
        step_us: SPREAD_STEP_US,
        test: PairTest {
            coulomb_step_max_s: f64::INFINITY,
            ..PairTest::default()
        },
    }
}

fn changes() -> Vec<Change> {
    let with = |cause, overrides| Change {
        cause,
        overrides,
        ..base()
    };
    let tested = |cause, change: fn(&mut PairTest)| {
        let mut changed = with(cause, &[]);
        change(&mut changed.test);
        changed
    };
    let mut fine = with("step 1 to 0.25 µs", &[]);
    fine.step_us = STEP_US;
    vec![
        fine,
        tested("start of the trailing ball at ψ = −120°", |t| {
            t.trailing_start_rad = -4.0 / 3.0 * FRAC_PI_2;
        }),
        tested("ring starts at y = −22 µm", |t| {
            t.ring_y_m = Some(-22e-6)
        }),
        with(
            "groove radii 0.52 to 0.515 ball diameters",
            &[
                "bearing.inner_groove_curvature_radius_mm=4.905375",
                "bearing.outer_groove_curvature_radius_mm=4.905375",
            ],
        ),
        with(
            "groove radii 0.52 to 0.53 ball diameters",
            &[
                "bearing.inner_groove_curvature_radius_mm=5.04825",
                "bearing.outer_groove_curvature_radius_mm=5.04825",
            ],
        ),
        with(
            "raceway damping 2e5 to 1e5 N·s/m^1.5",
            &["contact.damping_n_s_m1_5=1e5"],
        ),
        with(
            "raceway damping 2e5 to 4e5 N·s/m^1.5",
            &["contact.damping_n_s_m1_5=4e5"],
        ),
        tested("neighbours of the pair 1.5 times as far", |t| {
            t.neighbours_wider = 1.5;
        }),
        tested("touch read as δb > 0", |t| t.touch = Touch::Surface),
    ]
}

/// Critical gap in degrees; `None` where there is none, or the user ended the work.
fn gap_deg(case: &Case, test: &PairTest, progress: &Work<'_>) -> Result<Option<f64>, StudyError> {
    match critical_gap_rad(case, test, &mut |_| progress.control()) {
        Ok(gap) => Ok(Some(gap.to_degrees())),
        Err(
            CriticalGapError::NeverCloses
            | CriticalGapError::AlwaysCloses
            | CriticalGapError::Interrupted,
        ) => Ok(None),
        Err(error) => Err(error.into()),
    }
}

/// One gap that is computed.
struct Task<'a> {
    column: usize,
    row: usize,
    change: &'a Change,
}

impl Task<'_> {
    /// Gap in degrees; `None` where there is none, or the user ended the work.
    fn gap_deg(&self, progress: &Work<'_>) -> Result<Option<f64>, StudyError> {
        let Column { reading, flanks } = COLUMNS[self.column];
        let mut overrides = vec![format!("solver.step_us={}", self.change.step_us)];
        if flanks == FlankModel::Elastic {
            overrides.push("model.flanks=elastic".to_owned());
        }
        overrides.extend(self.change.overrides.iter().map(|&o| o.to_owned()));
        let case = cases::structure(self.row, reading, &overrides)?;
        gap_deg(&case, &self.change.test, progress)
    }
}

/// The gaps of the table and of the spreads, with what they were computed for.
struct Gaps<'a> {
    tasks: Vec<Task<'a>>,
    /// Gap of each task, degrees.
    deg: Vec<Option<f64>>,
}

impl<'a> Gaps<'a> {
    /// Computes them: those of the table itself, then for the columns whose spread is shown the
    /// base of the spreads and every change.
    fn compute(
        fine: &'a Change,
        base: &'a Change,
        changes: &'a [Change],
        progress: &Work<'_>,
    ) -> Result<Self, StudyError> {
        let of_rows = |column, change| {
            (0..PUBLISHED.len()).map(move |row| Task {
                column,
                row,
                change,
            })
        };
        // One task for every gap, the longest first.
        let mut tasks: Vec<_> = (0..COLUMNS.len()).flat_map(|c| of_rows(c, fine)).collect();
        for column in SPREAD_OF {
            // What differs from the table in nothing is computed once.
            let others = std::iter::once(base).chain(changes).filter(|c| !c.is(fine));
            tasks.extend(others.flat_map(|change| of_rows(column, change)));
        }
        let share = WORK / tasks.len() as f64;
        let gap = |task: &Task<'_>| {
            if progress.interrupted() {
                return Ok(None);
            }
            let gap_deg = task.gap_deg(progress);
            let _ = progress.add(share);
            gap_deg
        };
        let found: Result<_, StudyError> = each(&tasks).with_max_len(1).map(gap).collect();
        Ok(Self { deg: found?, tasks })
    }

    /// Gap of a column and a row under a change, degrees.
    fn deg(&self, column: usize, row: usize, change: &Change) -> Option<f64> {
        let is = |t: &Task<'_>| (t.column, t.row) == (column, row) && t.change.is(change);
        self.tasks.iter().position(is).and_then(|k| self.deg[k])
    }
}

/// Computes all gaps.
pub fn compute(progress: &Work<'_>) -> Result<Computed, StudyError> {
    let changes = changes();
    let base = base();
    let fine = Change {
        step_us: STEP_US,
        ..base
    };
    let gaps = Gaps::compute(&fine, &base, &changes, progress)?;
    let rows = (0..PUBLISHED.len()).map(|k| {
        let computed = (0..COLUMNS.len()).map(|column| gaps.deg(column, k, &fine));
        row(k, computed.collect())
    });
    let spread = |column: usize, change: &Change| Spread {
        cause: change.cause.to_owned(),
        variant: COLUMNS[column].reading.names(),
        change_deg: (0..PUBLISHED.len())
            .map(|row| {
                let before = gaps.deg(column, row, &base)?;
                gaps.deg(column, row, change).map(|gap| gap - before)
            })
            .collect(),
    };
    let spreads = SPREAD_OF.iter().flat_map(|&column| {
        let spread = &spread;
        changes.iter().map(move |change| spread(column, change))
    });
    Ok(Computed {
        table: Table2 {
            variants: COLUMNS.iter().map(Column::variant).collect(),
            rows: rows.collect::<Result<_, StudyError>>()?,
            spreads: spreads.collect(),
            provenance: provenance()?,
        },
    })
}

/// A row with its computed gaps, degrees.
fn row(k: usize, critical_gap_deg: Vec<Option<f64>>) -> Result<Table2Row, StudyError> {
    let case = cases::structure(k, COLUMNS[0].reading, &[])?;
    let theory =
        |meaning| theoretical_gap_rad(&case.bearing, &case.raceways[0], meaning).to_degrees();
    Ok(Table2Row {
        structure: label(k, &case),
        theory_deg: theory(Eq11::Published),
        theory_polar_deg: Some(theory(Eq11::Polar)),
        paper_theory_deg: PUBLISHED[k].theory_deg,
        paper_simulated_deg: PUBLISHED[k].simulated_deg,
        critical_gap_deg,
        remark: if k == ODD_ROW {
            "repeats the value of 5.40 mm".to_owned()
        } else {
            String::new()
        },
    })
}

fn provenance() -> Result<Provenance, StudyError> {
    let case = cases::structure(0, COLUMNS[0].reading, &[])?;
    Ok(Provenance {
        case: format!(
            "Zhao 2022, Table 1, {:.0} N, structures (a) to (j), one pair rolling into the raceway",
            case.operation.radial_load_n
        ),
        formulation: Some("as in the column heads".to_owned()),
        friction_law: Some("as in the column heads".to_owned()),
        film: None,
        method: Some("ABM4".to_owned()),
        step_us: Some(STEP_US),
        discarded: "nothing; the pair starts rolling at ψ = −90°, the ring in static equilibrium"
            .to_owned(),
    })
}

impl Computed {
    /// Largest |critical gap − paper's simulated value| of a column over the rows other
    /// than the odd one, degrees; NaN if one has no critical gap.
    pub fn largest_difference_deg(&self, column: usize) -> f64 {
        let rows = self.table.rows.iter().enumerate();
        let rows = rows.filter(|(k, _)| *k != ODD_ROW);
        largest(rows.map(|(_, row)| Some(row.critical_gap_deg[column]? - row.paper_simulated_deg)))
    }

    /// |critical gap − paper's simulated value| of a column in the odd row, degrees.
    pub fn odd_difference_deg(&self, column: usize) -> f64 {
        (self.gap_deg(column, ODD_ROW) - self.table.rows[ODD_ROW].paper_simulated_deg).abs()
    }

    /// Critical gap of a row, degrees.
    pub fn gap_deg(&self, column: usize, row: usize) -> f64 {
        self.table.rows[row].critical_gap_deg[column].unwrap_or(f64::NAN)
    }

    /// Largest |change| of a spread over the rows, degrees; NaN if one has no critical gap.
    pub fn spread_deg(&self, cause: &str, column: usize) -> f64 {
        let variant = COLUMNS[column].reading.names();
        self.table
            .spreads
            .iter()
            .filter(|s| s.cause.starts_with(cause) && s.variant == variant)
            .map(|s| largest(s.change_deg.iter().copied()))
            .fold(
                0.0,
                |worst, d| if d > worst || d.is_nan() { d } else { worst },
            )
    }
}

/// Largest absolute value; NaN if one is missing.
fn largest(values: impl Iterator<Item = Option<f64>>) -> f64 {
    let values: Option<Vec<f64>> = values.collect();
    let values = values.unwrap_or_else(|| vec![f64::NAN]);
    let larger = |worst: f64, d: &f64| if d.abs() <= worst { worst } else { d.abs() };
    values.iter().fold(0.0, larger)
}

#[cfg(test)]
mod tests {
    use super::largest;

    #[test]
    fn nothing_is_the_largest_of_the_rest() {
        assert_eq!(largest([Some(-0.3), Some(0.2)].into_iter()), 0.3);
        assert!(largest([Some(-0.3), None, Some(0.2)].into_iter()).is_nan());
    }
}
