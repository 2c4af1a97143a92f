//! `cageless reproduce`: every table and figure of Zhao 2022 beside the paper's numbers.

use std::time::Instant;

use cageless_io::results::write_atomically;
use cageless_report::{ReproduceData, reproduce_page, to_json};

use super::files::{make_folder, open_page, print, tell};
use crate::args::Reproduce;
use crate::failure::Failure;
use crate::format::columns;
use crate::progress::{Bars, catch_interrupt};

/// Regenerates the paper.
pub fn reproduce(args: &Reproduce) -> Result<(), Failure> {
    // An output folder that cannot be made must not cost the user the computation.
    make_folder(&args.out)?;
    let started = Instant::now();
    let data = cageless_paper::reproduce(&Bars::new(&catch_interrupt()))?;
    let json = to_json(&data)?;
    let page = args.out.join("report.html");
    write_atomically(&page, reproduce_page(&data).as_bytes())?;
    write_atomically(&args.out.join("report.json"), json.as_bytes())?;
    if args.json {
        print(&(json + "\n"))?;
    } else {
        tell(&format!(
            "{}\n{}\nThe page is {}, its numbers report.json beside it ({:.1} s).\n",
            data.lead,
            table_2(&data),
            page.display(),
            started.elapsed().as_secs_f64()
        ))?;
    }
    if args.open {
        open_page(&page);
    }
    Ok(())
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
            .map(|v| format!("{}/{}", v.profile, v.friction_law)),
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
