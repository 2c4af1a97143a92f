//! Ranges of nominal sizes with their standard tolerances and fundamental deviations (ISO 286-1:2010).

/// The millimetre of the tables, m.
pub(super) const MILLIMETRE_M: f64 = 1e-3;
/// The micrometre of the tables, m.
pub(super) const MICROMETRE_M: f64 = 1e-6;
/// Steps in which sizes are compared, per mm.
const STEPS_PER_MM: f64 = 1e6;

/// Smallest and largest nominal size with a tolerance class, mm.
pub(super) const SIZES_MM: [f64; 2] = [1.0, 500.0];

/// Range of nominal sizes, µm if not said otherwise.
pub(super) struct SizeRange {
    /// Largest size, mm; the ranges below end before.
    pub to_mm: f64,
    /// Standard tolerances IT3 to IT9 (table 1).
    tolerances_um: [f64; 7],
    /// −es of d, e, f, g (table 4).
    pub clearances_um: [f64; 4],
    /// ei of j5 and j6, and of j7 (table 5).
    pub shaft_j_um: [f64; 2],
    /// ei of k4 to k7, m, n, p (table 5).
    pub interferences_um: [f64; 4],
    /// ES of J6, J7, J8 (table 6).
    pub hole_j_um: [f64; 3],
}

const fn range(
    to_mm: f64,
    tolerances_um: [f64; 7],
    clearances_um: [f64; 4],
    shaft_j_um: [f64; 2],
    interferences_um: [f64; 4],
    hole_j_um: [f64; 3],
) -> SizeRange {
    SizeRange {
        to_mm,
        tolerances_um,
        clearances_um,
        shaft_j_um,
        interferences_um,
        hole_j_um,
    }
}

#[rustfmt::skip]
const RANGES: [SizeRange; 13] = [
    range(  3.0, [ 2.0,  3.0,  4.0,  6.0, 10.0, 14.0,  25.0], [ 20.0,  14.0,  6.0,  2.0], [ -2.0,  -4.0], [0.0,  2.0,  4.0,  6.0], [ 2.0,  4.0,  6.0]),
    range(  6.0, [ 2.5,  4.0,  5.0,  8.0, 12.0, 18.0,  30.0], [ 30.0,  20.0, 10.0,  4.0], [ -2.0,  -4.0], [1.0,  4.0,  8.0, 12.0], [ 5.0,  6.0, 10.0]),
    range( 10.0, [ 2.5,  4.0,  6.0,  9.0, 15.0, 22.0,  36.0], [ 40.0,  25.0, 13.0,  5.0], [ -2.0,  -5.0], [1.0,  6.0, 10.0, 15.0], [ 5.0,  8.0, 12.0]),
    range( 18.0, [ 3.0,  5.0,  8.0, 11.0, 18.0, 27.0,  43.0], [ 50.0,  32.0, 16.0,  6.0], [ -3.0,  -6.0], [1.0,  7.0, 12.0, 18.0], [ 6.0, 10.0, 15.0]),
    range( 30.0, [ 4.0,  6.0,  9.0, 13.0, 21.0, 33.0,  52.0], [ 65.0,  40.0, 20.0,  7.0], [ -4.0,  -8.0], [2.0,  8.0, 15.0, 22.0], [ 8.0, 12.0, 20.0]),
    range( 50.0, [ 4.0,  7.0, 11.0, 16.0, 25.0, 39.0,  62.0], [ 80.0,  50.0, 25.0,  9.0], [ -5.0, -10.0], [2.0,  9.0, 17.0, 26.0], [10.0, 14.0, 24.0]),
    range( 80.0, [ 5.0,  8.0, 13.0, 19.0, 30.0, 46.0,  74.0], [100.0,  60.0, 30.0, 10.0], [ -7.0, -12.0], [2.0, 11.0, 20.0, 32.0], [13.0, 18.0, 28.0]),
    range(120.0, [ 6.0, 10.0, 15.0, 22.0, 35.0, 54.0,  87.0], [120.0,  72.0, 36.0, 12.0], [ -9.0, -15.0], [3.0, 13.0, 23.0, 37.0], [16.0, 22.0, 34.0]),
    range(180.0, [ 8.0, 12.0, 18.0, 25.0, 40.0, 63.0, 100.0], [145.0,  85.0, 43.0, 14.0], [-11.0, -18.0], [3.0, 15.0, 27.0, 43.0], [18.0, 26.0, 41.0]),
    range(250.0, [10.0, 14.0, 20.0, 29.0, 46.0, 72.0, 115.0], [170.0, 100.0, 50.0, 15.0], [-13.0, -21.0], [4.0, 17.0, 31.0, 50.0], [22.0, 30.0, 47.0]),
    range(315.0, [12.0, 16.0, 23.0, 32.0, 52.0, 81.0, 130.0], [190.0, 110.0, 56.0, 17.0], [-16.0, -26.0], [4.0, 20.0, 34.0, 56.0], [25.0, 36.0, 55.0]),
    range(400.0, [13.0, 18.0, 25.0, 36.0, 57.0, 89.0, 140.0], [210.0, 125.0, 62.0, 18.0], [-18.0, -28.0], [4.0, 21.0, 37.0, 62.0], [29.0, 39.0, 60.0]),
    range(500.0, [15.0, 20.0, 27.0, 40.0, 63.0, 97.0, 155.0], [230.0, 135.0, 68.0, 20.0], [-20.0, -32.0], [5.0, 23.0, 40.0, 68.0], [33.0, 43.0, 66.0]),
];

/// ei of r in µm up to a size in mm (table 5).
const R: [(f64, f64); 22] = [
    (3.0, 10.0),
    (6.0, 15.0),
    (10.0, 19.0),
    (18.0, 23.0),
    (30.0, 28.0),
    (50.0, 34.0),
    (65.0, 41.0),
    (80.0, 43.0),
    (100.0, 51.0),
    (120.0, 54.0),
    (140.0, 63.0),
    (160.0, 65.0),
    (180.0, 68.0),
    (200.0, 77.0),
    (225.0, 80.0),
    (250.0, 84.0),
    (280.0, 94.0),
    (315.0, 98.0),
    (355.0, 108.0),
    (400.0, 114.0),
    (450.0, 126.0),
    (500.0, 132.0),
];

/// A size in mm, without the rounding of its unit.
pub(super) fn size_mm(size_m: f64) -> f64 {
    (size_m / MILLIMETRE_M * STEPS_PER_MM).round() / STEPS_PER_MM
}

impl SizeRange {
    /// The range of a nominal size; `None` beyond 1 to 500 mm.
    pub(super) fn of(size_m: f64) -> Option<&'static Self> {
        let mm = size_mm(size_m);
        let [least, most] = SIZES_MM;
        let is_ranged = mm >= least && mm <= most;
        is_ranged.then(|| RANGES.iter().find(|range| mm <= range.to_mm))?
    }

    /// ITn, n from 3 to 9.
    pub(super) fn tolerance_um(&self, grade: usize) -> f64 {
        self.tolerances_um[grade - 3]
    }

    /// Δ = ITn − IT(n−1) of holes; 0 up to 3 mm.
    pub(super) fn step_um(&self, grade: usize) -> f64 {
        match self.to_mm > 3.0 {
            true => self.tolerance_um(grade) - self.tolerance_um(grade - 1),
            false => 0.0,
        }
    }

    /// ei of r.
    pub(super) fn r_um(size_m: f64) -> f64 {
        let mm = size_mm(size_m);
        let found = R.iter().find(|(to_mm, _)| mm <= *to_mm);
        found.map_or(f64::NAN, |(_, um)| *um)
    }
}
