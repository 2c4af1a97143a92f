//! Table and figure of drops one after the other.

use cageless_results::Record;
use cageless_study::drop::Succession;
use serde_json::json;

use super::bearing::Bearing;
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
pub(super) fn succession(page: &mut Page, bearings: &[Bearing<'_>], succession: &Succession) {
    let source = bearings[0].source.clone();
    let caption = "After each drop the rotor spins down to standstill. Each bearing brakes it as at the end \
                   of the simulated time, but by ½ μ P d of SKF at least, and keeps the heat; the next drop \
                   has the clearances of its temperatures. No heat flows from one part to another or away, \
                   except for the cooling of the case ([thermal]). Windage is not known.";
    let rows = succession.table();
    page.table(&Table::of(
        "Drops in succession",
        caption,
        rows,
        Some(source),
    ));
    let (failed, unjudged) = (succession.first("fail"), succession.first("not-judged"));
    if failed.is_none() && unjudged.is_none() {
        page.note(Note::Remark, "No drop is beyond a limit.");
    }
    for (first, what) in [(failed, "beyond a limit"), (unjudged, "that is not judged")] {
        if let Some((drop, reasons)) = first {
            let first = format!("Drop {drop} is the first {what}: {reasons}.");
            page.note(Note::Warning, &first);
        }
    }
    page.figures(bearings.iter().enumerate().filter_map(|(k, bearing)| {
        let rows = succession.records.iter().skip(k).step_by(bearings.len());
        temperatures(bearing, &rows.collect::<Vec<_>>())
    }));
}

/// Temperatures of a bearing after each drop, a row each; `None` of a single drop.
fn temperatures(bearing: &Bearing<'_>, rows: &[&Record]) -> Option<Figure> {
    let mut plot = Plot::new(380)
        .legend()
        .x("Drops", json!({ "dtick": 1 }))
        .y("Temperature (°C)", json!({}));
    for ((name, part), colour) in PARTS.into_iter().zip(PALETTE) {
        // Before each drop and at the standstill after it.
        let points = rows.iter().flat_map(|row| {
            let drop = row.number("drop");
            let of = |when: &str| row.value(&format!("{part}_{when}_c"));
            [(drop - 1.0, of("start")), (drop, of("standstill"))]
        });
        let points = points.filter_map(|(drop, at)| Some((drop, at?)));
        let measured = line_of(name, points.collect(), colour);
        plot = plot.trace(measured.with(json!({ "mode": "lines+markers" })));
        let limits = bearing.particulars.limits.iter();
        for limit in limits.filter(|limit| limit.result == format!("{part}_standstill_c")) {
            let (x, y) = ([0.0, rows.len() as f64], [limit.value; 2]);
            let name = format!("limit, {name}: {}", limit.source);
            plot = plot.trace(line(&name, &x, &y, colour).dash("dot"));
        }
    }
    (rows.len() > 1).then(|| {
        let caption = "Temperatures before each drop and at the standstill after it; a step at a drop is what the \
             bearing loses in the pause.";
        bearing.figure("Temperatures", caption, plot)
    })
}
