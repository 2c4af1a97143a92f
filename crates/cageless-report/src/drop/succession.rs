//! Table and figure of drops one after the other.

use cageless_results::{Record, table_of};
use cageless_study::drop::DropStudy;
use cageless_study::provenance;
use serde_json::json;

use super::label::label;
use crate::figure::Figure;
use crate::page::{Note, Page};
use crate::plot::{PALETTE, Plot, line, line_of};
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
            let first = format!("Drop {drop} is the first beyond a limit: {reasons}.");
            page.note(Note::Warning, &first);
        }
        None => page.note(Note::Remark, "No drop is beyond a limit."),
    }
    page.figures((0..study.drop.cases().len()).filter_map(|k| temperatures(study, k)));
}

/// Temperatures of bearing `k` after each drop; `None` of a single drop.
fn temperatures(study: &DropStudy, k: usize) -> Option<Figure> {
    let case = &study.drop.cases()[k];
    let bearings = study.drop.cases().len();
    let rows = || study.succession.records.iter().skip(k).step_by(bearings);
    let mut plot = Plot::new(380)
        .legend()
        .x("Drops", json!({ "dtick": 1 }))
        .y("Temperature (°C)", json!({}));
    for ((name, part), colour) in PARTS.into_iter().zip(PALETTE) {
        // Before each drop and at the standstill after it.
        let points = rows().flat_map(|row: &Record| {
            let drop = row.number("drop");
            let of = |when: &str| row.value(&format!("{part}_{when}_c"));
            [(drop - 1.0, of("start")), (drop, of("standstill"))]
        });
        let points = points.filter_map(|(drop, at)| Some((drop, at?)));
        let measured = line_of(name, points.unzip(), colour);
        plot = plot.trace(measured.with(json!({ "mode": "lines+markers" })));
        let limits = case.limits.iter();
        for limit in limits.filter(|limit| limit.result == format!("{part}_standstill_c")) {
            let (x, y) = ([0.0, rows().count() as f64], [limit.value; 2]);
            let name = format!("limit, {name}: {}", limit.source);
            plot = plot.trace(line(&name, &x, &y, colour).dash("dot"));
        }
    }
    let source = provenance(case, String::new());
    (rows().count() > 1).then(|| {
        let caption = "Temperatures before each drop and at the standstill after it; a step at a drop is what the \
             bearing loses in the pause.";
        let label = label(study, "Temperatures", k);
        Figure::new(&label, caption, &source, plot)
    })
}
