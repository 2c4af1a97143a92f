//! Results of a measured ring.

use crate::number_text::{fixed, significant};
use crate::table::{DIMENSION, FRAME, GROOVE, MEASURED};
use crate::{Record, Shape};

/// Shape of the results of a measured ring; `raceways` have the results of slots and profiles as well.
pub const MEASURED_SHAPE: Shape = Shape {
    sentences: &["warnings"],
    parts: &[
        ("frame", &Shape::of(FRAME)),
        (
            "raceways",
            &Shape {
                parts: &[("dimensions", &Shape::of(DIMENSION))],
                ..Shape::of(GROOVE)
            },
        ),
    ],
    ..Shape::of(MEASURED)
};

/// A row for each dimension or part of a frame, to the digits of its uncertainty; the first row is the head.
pub fn measured_rows<'r>(parts: impl IntoIterator<Item = &'r Record>) -> Vec<Vec<String>> {
    let mut rows: Vec<Vec<String>> = vec![];
    for part in parts {
        let uncertainty = part.number("expanded_uncertainty");
        let decimals = decimals(uncertainty);
        let value = |name: &str| fixed(part.value(name), decimals);
        let has = |name: &str| part.get(name).is_some();
        let mut columns = vec![("", part.text("name").to_owned())];
        if has("drawn") {
            columns.push((
                "drawn",
                part.value("drawn")
                    .map_or("–".to_owned(), |v| significant(v, 6)),
            ));
        }
        columns.push(("measured", value("measured")));
        columns.push(("U (k = 2)", value("expanded_uncertainty")));
        if has("tolerance") {
            let tolerance = part.value("tolerance");
            columns.push((
                "tolerance ±",
                tolerance.map_or("–".to_owned(), |v| significant(v, 6)),
            ));
        }
        columns.push(("unit", part.text("unit").to_owned()));
        if has("verdict") {
            let verdict = Some(part.text("verdict")).filter(|verdict| !verdict.is_empty());
            columns.push(("verdict", verdict.unwrap_or("–").to_owned()));
        }
        if rows.is_empty() {
            rows.push(columns.iter().map(|(head, _)| (*head).to_owned()).collect());
        }
        rows.push(columns.into_iter().map(|(_, cell)| cell).collect());
    }
    rows
}

/// Decimals of a value with this uncertainty, which has two digits.
fn decimals(uncertainty: f64) -> usize {
    match uncertainty > 0.0 {
        true => (1.0 - uncertainty.log10().floor()).clamp(0.0, 4.0) as usize,
        false => 4,
    }
}

#[cfg(test)]
mod tests {
    use super::decimals;

    #[test]
    fn an_uncertainty_has_two_digits() {
        for (uncertainty, expected) in [
            (12.0, 0),
            (1.2, 1),
            (0.034, 3),
            (1e-9, 4),
            (0.0, 4),
            (240.0, 0),
        ] {
            assert_eq!(decimals(uncertainty), expected, "{uncertainty}");
        }
    }
}
