//! Tables of a search.

use cageless_design::search::NEIGHBOURS_WIDER;
use cageless_io::estimate::Estimate;
use cageless_results::{
    MOTION, PLACEMENT, Quantity, Record, Results, STRUCTURE, STRUCTURE_AT, heading, table_of,
    value_text,
};
use cageless_study::search::{point_label, structure_label};

use crate::table::{Column, Row, Table};

/// Rows of the front that are printed.
const FRONT_ROWS: usize = 24;

/// Text of a result without a value.
const NOTHING: &str = "–";

/// Results of a structure at an operating point that tables have.
fn quantities() -> impl Iterator<Item = &'static Quantity> {
    let all = STRUCTURE.iter().chain(STRUCTURE_AT).chain(MOTION);
    all.filter(|q| q.in_tables)
}

/// A result of a structure at an operating point, with its error if there is one.
fn shown(structure: &Record, point: &Record, q: &Quantity) -> String {
    let mean = point.part("motion").and_then(|m| m.value(q.name));
    let error = point.part("errors").and_then(|e| e.value(q.name));
    if let (true, Some(mean), Some(standard_error)) = (in_motion(q), mean, error) {
        let starts = 2;
        return Estimate {
            mean,
            standard_error,
            starts,
        }
        .text();
    }
    let own: Option<&Results> = match in_motion(q) {
        true => point.part("motion").map(|m| &m.results),
        false if point.get(q.name).is_some() => Some(&point.results),
        false => Some(&structure.results),
    };
    let text = own.and_then(|results| value_text(q, results.get(q.name)?));
    text.unwrap_or(NOTHING.to_owned())
}

fn in_motion(quantity: &Quantity) -> bool {
    MOTION.contains(quantity)
}

/// The recommendation beside the case's own structure.
pub fn comparison(search: &Record) -> Table {
    let points = search.parts("points");
    let structures: Vec<(&str, &Record)> =
        [("recommended", "recommended"), ("initial design", "own")]
            .into_iter()
            .filter_map(|(role, part)| Some((role, search.part(part)?)))
            .collect();
    let mut columns = vec![(String::new(), Column::Text)];
    let mut groups = vec![(String::new(), 1)];
    for (role, structure) in &structures {
        columns.extend(points.iter().map(|p| (point_label(p), Column::Number)));
        let name = format!("{role}: {}", structure_label(structure));
        groups.push((name, points.len()));
    }
    let size = [
        "axial_span_mm",
        "half_angle_deg",
        "shape",
        "centre_angles_deg",
    ];
    let rows = quantities().filter(|q| !size.contains(&q.name));
    let rows = rows.filter_map(|q| {
        let mut cells = vec![heading(q)];
        for (_, structure) in &structures {
            let at = structure.parts("points").iter();
            cells.extend(at.map(|point| shown(structure, point, q)));
        }
        let has_value = cells[1..].iter().any(|cell| cell != NOTHING);
        has_value.then(|| Row::from(cells))
    });
    Table {
        label: "Comparison".to_owned(),
        caption: format!(
            "From unevenly spaced starts, ± standard error of the mean. Critical \
             gaps are measured with the neighbours of the pair {:.0} % further off than at even \
             spacing. Steady state: second half of the run. Reduction of the orbital speed: at the \
             lowest orbital speed in the raceway.",
            100.0 * (NEIGHBOURS_WIDER - 1.0)
        ),
        groups,
        columns,
        rows: rows.collect(),
        provenance: search.provenance.clone(),
    }
}

/// Number of designs excluded by each reason.
pub fn rejections(search: &Record) -> Table {
    let caption = "Structures of the maps at the operating points and of the band between them \
                   that each requirement excludes; a design is counted under the first that fails.";
    let mut rows = table_of(search.parts("rejections"));
    if rows.is_empty() {
        let head = ["requirement", "meaning", "structures"];
        rows.push(head.map(str::to_owned).to_vec());
    }
    Table::of("Rejections", caption, rows, None)
}

/// Structures with their results at the first operating point behind values of their `own`; the first
/// row is the head.
fn structures<'r>(
    all: impl Iterator<Item = (Vec<String>, &'r Record)>,
    own: &'static [Quantity],
) -> Vec<Vec<String>> {
    let quantities = || quantities().filter(|q| own.iter().all(|o| o.name != q.name));
    let head = own.iter().chain(quantities()).map(heading);
    let mut rows = vec![head.collect()];
    for (mut row, structure) in all {
        if let Some(point) = structure.parts("points").first() {
            row.extend(quantities().map(|q| shown(structure, point, q)));
        }
        rows.push(row);
    }
    without_empty_columns(rows)
}

/// Rows below a head without the columns in which none of them has a value.
fn without_empty_columns(rows: Vec<Vec<String>>) -> Vec<Vec<String>> {
    let has_value = |row: &Vec<String>, k: usize| row.get(k).is_some_and(|cell| cell != NOTHING);
    let kept: Vec<bool> = (0..rows[0].len())
        .map(|k| rows.len() == 1 || rows[1..].iter().any(|row| has_value(row, k)))
        .collect();
    let kept_of = |row: Vec<String>| {
        let cells = row.into_iter().zip(&kept);
        let cells = cells.filter_map(|(cell, kept)| kept.then_some(cell));
        cells.collect()
    };
    rows.into_iter().map(kept_of).collect()
}

/// Places and shapes of the raceways.
pub fn placements(search: &Record) -> Table {
    let caption = "Where, how many and of which shape: places and shapes of the raceways, with the best \
                   acceptable structure of each (numbers at the first operating point).";
    let none = Record::default();
    let all = search.parts("placements").iter().map(|placement| {
        let own = placement.iter().map(|(q, cell)| value_text(q, cell));
        let own = own.map(|text| text.unwrap_or("–".to_owned())).collect();
        (own, placement.part("best").unwrap_or(&none))
    });
    Table::of("Places", caption, structures(all, PLACEMENT), None)
}

/// The Pareto front.
pub fn front(search: &Record) -> Table {
    let front = search.parts("front");
    let accepted = search
        .parts("band")
        .iter()
        .filter(|s| s.text("status") == "accepted");
    let feasible = accepted.count();
    let caption = format!(
        "Pareto-optimal designs, sorted by distance from the ideal point{} ({} of {} shown; \
             numbers at the first operating point, from {} uneven starts).",
        if front.len() == feasible {
            ". All feasible designs are among them: each is the best compromise for some weights \
                 of the objectives, so that the order alone tells them apart"
        } else {
            ""
        },
        front.len().min(FRONT_ROWS),
        front.len(),
        search.number("starts")
    );
    let all = front.iter().take(FRONT_ROWS).map(|s| (vec![], s));
    Table::of("Pareto front", &caption, structures(all, &[]), None)
}
