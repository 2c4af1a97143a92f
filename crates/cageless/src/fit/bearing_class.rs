//! Tolerance classes of bearings (ISO 492), for the mean diameters of bore and outside.

use super::size_range::{MICROMETRE_M, MILLIMETRE_M, size_mm};

crate::named_enum! {
    /// Tolerance class of a radial bearing (ISO 492).
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
    pub enum BearingClass {
        /// Class Normal, formerly 0.
        #[default]
        Normal = "normal",
        /// Class 6.
        Six = "6",
        /// Class 5.
        Five = "5",
    }
}

/// Size in mm up to which a row holds, and deviations in µm by class; NaN where there is none.
type Row = (f64, [f64; 3]);

/// −Δdmp at most, the bore being never too large (ISO 492 as in NTN 2203/E, table 6.4).
const BORE: [Row; 11] = [
    (10.0, [8.0, 7.0, 5.0]),
    (18.0, [8.0, 7.0, 5.0]),
    (30.0, [10.0, 8.0, 6.0]),
    (50.0, [12.0, 10.0, 8.0]),
    (80.0, [15.0, 12.0, 9.0]),
    (120.0, [20.0, 15.0, 10.0]),
    (180.0, [25.0, 18.0, 13.0]),
    (250.0, [30.0, 22.0, 15.0]),
    (315.0, [35.0, 25.0, 18.0]),
    (400.0, [40.0, 30.0, 23.0]),
    (500.0, [45.0, 35.0, f64::NAN]),
];

/// −ΔDmp at most.
const OUTSIDE: [Row; 11] = [
    (18.0, [8.0, 7.0, 5.0]),
    (30.0, [9.0, 8.0, 6.0]),
    (50.0, [11.0, 9.0, 7.0]),
    (80.0, [13.0, 11.0, 9.0]),
    (120.0, [15.0, 13.0, 10.0]),
    (150.0, [18.0, 15.0, 11.0]),
    (180.0, [25.0, 18.0, 13.0]),
    (250.0, [30.0, 20.0, 15.0]),
    (315.0, [35.0, 25.0, 18.0]),
    (400.0, [40.0, 28.0, 20.0]),
    (500.0, [45.0, 33.0, 23.0]),
];

impl BearingClass {
    /// Lower and upper deviation of the mean bore diameter, m; `None` beyond the tables.
    pub(crate) fn bore_limits_m(self, bore_diameter_m: f64) -> Option<[f64; 2]> {
        self.limits_m(&BORE, bore_diameter_m)
    }

    /// Lower and upper deviation of the mean outside diameter, m; `None` beyond the tables.
    pub(crate) fn outside_limits_m(self, outside_diameter_m: f64) -> Option<[f64; 2]> {
        self.limits_m(&OUTSIDE, outside_diameter_m)
    }

    /// Largest bore diameter with limits, m.
    pub(super) fn largest_bore_m(self) -> f64 {
        let mut rows = BORE.iter().rev();
        let last = rows.find(|(_, deviations_um)| deviations_um[self as usize].is_finite());
        last.map_or(0.0, |(to_mm, _)| to_mm * MILLIMETRE_M)
    }

    fn limits_m(self, rows: &[Row], diameter_m: f64) -> Option<[f64; 2]> {
        let mm = size_mm(diameter_m);
        let (_, deviations_um) = rows.iter().find(|(to_mm, _)| mm <= *to_mm)?;
        let deviation_um = deviations_um[self as usize];
        deviation_um
            .is_finite()
            .then_some([-deviation_um * MICROMETRE_M, 0.0])
    }
}
