//! Table of the verification of a drop.

use cageless_study::Provenance;
use cageless_study::drop::DropVerification;

use crate::table::{Cell, Row, Table};
use crate::text::short;

pub(super) fn verified(
    verification: &DropVerification,
    label: String,
    source: &Provenance,
) -> Table {
    let rows = verification.judgements.iter().map(|j| {
        let numbers = [j.value, j.mean, j.half_step_mean, j.spread];
        let mut cells = vec![Cell::text(j.quantity.label)];
        cells.extend(numbers.map(|value| Cell::number(short(value))));
        cells.push(Cell::text(j.quantity.unit_text()));
        cells.push(Cell::text(j.verdict.name()));
        Row {
            cells,
            ..Row::default()
        }
    });
    Table {
        label,
        caption: format!(
            "{} drops at the step of {} µs and as many at half of it, from starts turned by a few \
             microradians. Converged: none of this changes the result by more than a thousandth. \
             Statistical: it depends on the start but not on the step; the spread is that among \
             the drops. Step-biased: it changes with the step by more than the spread explains.",
            verification.replicas,
            short(1e6 * verification.step_s)
        ),
        columns: [
            ("Result", false),
            ("This drop", true),
            ("Mean", true),
            ("At half the step", true),
            ("Spread", true),
            ("Unit", false),
            ("Verdict", false),
        ]
        .map(|(text, numeric)| (text.to_owned(), numeric))
        .to_vec(),
        rows: rows.collect(),
        provenance: Some(source.clone()),
        ..Table::default()
    }
}
