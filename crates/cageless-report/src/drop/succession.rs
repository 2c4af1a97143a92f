//! Table and figure of drops one after the other.

use cageless_results::{Record, table_of};
use cageless_study::drop::DropStudy;
use cageless_study::provenance;
use serde_json::json;

use super::label::label;
use crate::figure::Figure;
use crate::page::{Note, Page};
use crate::plot::{PALETTE, Plot, line, with};
use crate::table::Table;

/// Parts of a bearing with the ends of the names of their temperatures.
const PARTS: [(&str, &str); 3] = [
    ("inner ring", "inner_ring"),
    ("balls", "ball"),
    ("outer ring", "outer_ring"),
];

/// Spin-down to standstill and the drops after it.
pub(super) fn succession(page: &mut Page, study: &DropStudy) {
    let source = provenance(&study.drop.cases()[0], String::new());
    let caption = "After each drop the rotor spins down to standstill at the torques of the end of the \
                   simulated time, and the bearing keeps the heat; the next drop has the clearances of \
                   its temperatures. No heat flows from one part to another or away, except for the cooling \
                   that the case gives ([thermal]). Balls that roll have no rolling friction in the plane, \
                   and windage is not known: next to a drag of the drive (rotor.drive_torque_n_m) a \
                   real bearing brakes and warms more.";
    let rows = table_of(&study.succession.records);
    page.table(&Table::of(
        "Drops in succession",
        caption,
        rows,
        Some(source),
    ));
    match study.succession.first_failure() {
        Some((drop, reasons)) => {
            page.note(
                Note::Warning,
                &format!("Drop {drop} is the first beyond a limit: {reasons}."),
            );
        }
        None => page.note(Note::Remark, "No drop is beyond a limit."),
    }
    for k in 0..study.drop.cases().len() {
        if let Some(figure) = temperatures(study, k) {
            page.figure(&figure);
        }
    }
}

/// Temperatures of bearing `k` after each drop; `None` of a single drop.
fn temperatures(study: &DropStudy, k: usize) -> Option<Figure> {
    let case = &study.drop.cases()[k];
    let bearings = study.drop.cases().len();
    let rows = || study.succession.records.iter().skip(k).step_by(bearings);
    let mut plot = Plot::new(380)
        .legend()
        .axis("xaxis", "Drops", json!({ "dtick": 1 }))
        .axis("yaxis", "Temperature (°C)", json!({}));
    for ((name, part), colour) in PARTS.into_iter().zip(PALETTE) {
        // Before each drop and at the standstill after it.
        let points = rows().flat_map(|row: &Record| {
            let drop = row.number("drop");
            let of = |when: &str| row.value(&format!("{part}_{when}_c"));
            [(drop - 1.0, of("start")), (drop, of("standstill"))]
        });
        let points = points.filter_map(|(drop, at)| Some((drop, at?)));
        let (x, y): (Vec<f64>, Vec<f64>) = points.unzip();
        plot = plot.trace(with(
            line(name, &x, &y, colour),
            json!({ "mode": "lines+markers" }),
        ));
        let limits = case.limits.iter();
        for limit in limits.filter(|limit| limit.result == format!("{part}_standstill_c")) {
            let (x, y) = ([0.0, rows().count() as f64], [limit.value; 2]);
            plot = plot.trace(with(
                line(&format!("limit, {name}: {}", limit.source), &x, &y, colour),
                json!({ "line": { "dash": "dot" } }),
            ));
        }
    }
    let source = provenance(case, String::new());
    (rows().count() > 1).then(|| {
        Figure::new(
            &label(study, "Temperatures", k),
            "Temperatures before each drop and at the standstill after it; a step at a drop is what the \
             bearing loses in the pause.",
            &source,
            plot,
        )
    })
}
