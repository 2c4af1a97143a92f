//! Rows of a bearing that move differently.

use cageless::{Case, Row, Tilt};

/// Indices of rows of which no two move alike; every other row is like one of them. Rows with the same contact
/// sign and preload are alike on a ring that stays straight, and mirror images too where nothing pushes the
/// ring along its axis.
pub(crate) fn distinct_rows(case: &Case) -> Vec<usize> {
    let rows = case.all_rows();
    let load = &case.operation.space;
    let straight = load.tilt == Tilt::default();
    let balanced = load.axial_load_n == 0.0
        && rows
            .iter()
            .all(|row| row.preload_m == rows[0].preload_m && row.preload_n == 0.0)
        && rows.iter().map(|row| row.contact_sign).sum::<f64>() == 0.0;
    let alike = |a: &Row, b: &Row| {
        let held_alike = [a, b].map(|row| Row {
            axial_position_m: 0.0,
            contact_sign: 1.0,
            ..*row
        });
        straight && held_alike[0] == held_alike[1] && (balanced || a.contact_sign == b.contact_sign)
    };
    let new = |&k: &usize| !rows[..k].iter().any(|before| alike(before, &rows[k]));
    (0..rows.len()).filter(new).collect()
}
