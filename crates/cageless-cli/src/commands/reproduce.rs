//! `cageless reproduce`: every table and figure of Zhao 2022 next to the paper's numbers.

use cageless_report::{ReproduceData, reproduce_page, to_json};
use cageless_study::StudyError;

use crate::args::{Output, Reproduce};
use crate::driver::{Answer, PAGE, PAGE_DATA};
use crate::failure::Failure;
use crate::format::columns;

/// Regenerates the paper.
pub fn reproduce(args: &Reproduce) -> Result<(), Failure> {
    let output = Output::of_page(args.json, args.open, &args.out);
    output.drive(&[PAGE, PAGE_DATA], |bars| {
        let data = cageless_paper::reproduce(bars).map_err(|error| match error {
            StudyError::Interrupted => {
                Failure::Interrupted("interrupted: no report was written".to_owned())
            }
            error => error.into(),
        })?;
        Ok(Answer {
            files: output.files(|| Ok(vec![(PAGE, Some(reproduce_page(&data).into()))]))?,
            ..Answer::new(
                PAGE_DATA,
                to_json(&data)? + "\n",
                format!("{}\n{}\n", data.lead, table_2(&data)),
            )
        })
    })
}

/// Table 2 for the terminal.
fn table_2(data: &ReproduceData) -> String {
    let Some(table) = &data.table2 else {
        return String::new();
    };
    let mut head: Vec<String> = ["lC mm", "θ °", "β0 Eq.11", "paper", "simulated"]
        .map(str::to_owned)
        .to_vec();
    head.extend(
        table
            .variants
            .iter()
            .map(|v| format!("{}/{}", v.formulation, v.friction_law)),
    );
    let mut rows = vec![head];
    for row in &table.rows {
        let mut line = vec![
            format!("{:.2}", row.structure.axial_span_mm),
            format!("{:.3}", row.structure.half_angle_deg),
            format!("{:.4}", row.theory_deg),
            format!("{:.4}", row.paper_theory_deg),
            format!("{:.4}", row.paper_simulated_deg),
        ];
        line.extend(
            row.critical_gap_deg
                .iter()
                .map(|gap| gap.map_or("–".to_owned(), |g| format!("{g:.4}"))),
        );
        rows.push(line);
    }
    columns(&rows)
}
