//! An outer ring that slides in its housing along the axis: constants and work.

use crate::case::Case;

/// Constants of an outer ring that slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlidingRing {
    /// Its row, from 0.
    pub row: usize,
    /// m, kg.
    pub mass: f64,
    /// c, N·s/m.
    pub damping: f64,
    /// Force of the spring along +Z, −σP, N.
    pub spring_n: f64,
}

/// What an outer ring that slides had at the last evaluation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct SlidingWork {
    /// Speed against the housing, m/s.
    pub speed: f64,
    /// Force of its balls along +Z, N.
    pub force_n: f64,
}

impl SlidingRing {
    /// Those of a case, row by row.
    pub(crate) fn of_case(case: &Case) -> Vec<Self> {
        let sprung = case.sprung_rows().into_iter();
        sprung
            .map(|row| (row, &case.rows[row]))
            .map(|(k, row)| {
                let [mass, damping] = row.sliding(&case.bearing);
                Self {
                    row: k,
                    mass,
                    damping,
                    spring_n: -row.contact_sign * row.preload_n,
                }
            })
            .collect()
    }
}
