//! Units of every name that is declared: results, keys of case files and rotor files, columns of tables.

use cageless_results::quantities;

use crate::case_file::keys;
use crate::results::{COLLISIONS, ColumnKind, run_columns};
use crate::rotor_file::keys::ROTOR_FILE;

/// Names with their units in ASCII, empty where there is none.
pub fn units() -> impl Iterator<Item = (&'static str, &'static str)> {
    let results = quantities().map(|q| (q.name, q.unit));
    let keys = keys::all().chain(ROTOR_FILE.all());
    let keys = keys.map(|(_, key)| (key.name, key.unit.symbol()));
    let columns = run_columns(true).into_iter().flatten().chain(COLLISIONS);
    // Balls have numbers and no unit.
    let columns = columns.filter(|column| column.kind != ColumnKind::Ordinal);
    results
        .chain(keys)
        .chain(columns.map(|column| (&*column.name, &*column.unit)))
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::units;

    #[test]
    fn a_name_has_one_unit_wherever_it_is_declared() {
        let mut known = BTreeMap::new();
        for (name, unit) in units() {
            assert_eq!(*known.entry(name).or_insert(unit), unit, "{name}");
            assert!(unit.is_ascii(), "{name}: {unit}");
        }
        assert_eq!(known["impulse_mn_s"], "mN s");
        assert_eq!(known["damping_n_s_m1_5"], "N s/m^1.5");
        assert_eq!(known["amount_g_mm"], "g mm");
    }
}
