//! Equivalent loads of combined radial and axial load: P of ISO 281, P0 of ISO 76.

use crate::bearing::Bearing;
use crate::case::{Case, Tilt};

/// Relative axial loads Fa/(Z Dw²) of the table, N/mm²; f0 Fa/C0r of a row without contact angle.
const RELATIVE_LOADS: [f64; 9] = [0.172, 0.345, 0.689, 1.03, 1.38, 2.07, 3.45, 5.17, 6.89];
/// Contact angle up to which ISO 281 has factors, degrees.
const CONTACT_ANGLE_MAX_DEG: f64 = 45.0;

/// Factors of ISO 281:2007, Table 3, at a contact angle over the relative axial loads.
struct Dynamic {
    angle_deg: f64,
    e: [f64; 9],
    /// Y where Fa/Fr ≤ e, with X = 1.
    y_below: [f64; 9],
    /// X where Fa/Fr > e.
    x: f64,
    /// Y where Fa/Fr > e.
    y: [f64; 9],
}

/// Factors that do not depend on the relative axial load.
const fn steep(angle_deg: f64, e: f64, y_below: f64, x: f64, y: f64) -> Dynamic {
    Dynamic {
        angle_deg,
        e: [e; 9],
        y_below: [y_below; 9],
        x,
        y: [y; 9],
    }
}

const fn of_deep_groove(angle_deg: f64) -> Dynamic {
    Dynamic {
        angle_deg,
        e: [0.19, 0.22, 0.26, 0.28, 0.30, 0.34, 0.38, 0.42, 0.44],
        y_below: [0.0; 9],
        x: 0.56,
        y: [2.30, 1.99, 1.71, 1.55, 1.45, 1.31, 1.15, 1.04, 1.00],
    }
}

const E_10: [f64; 9] = [0.29, 0.32, 0.36, 0.38, 0.40, 0.44, 0.49, 0.54, 0.54];
const E_15: [f64; 9] = [0.38, 0.40, 0.43, 0.46, 0.47, 0.50, 0.55, 0.56, 0.56];

/// A row, or rows in tandem.
const ALIKE: [Dynamic; 10] = [
    of_deep_groove(0.0),
    of_deep_groove(5.0),
    Dynamic {
        angle_deg: 10.0,
        e: E_10,
        y_below: [0.0; 9],
        x: 0.46,
        y: [1.88, 1.71, 1.52, 1.41, 1.34, 1.23, 1.10, 1.01, 1.00],
    },
    Dynamic {
        angle_deg: 15.0,
        e: E_15,
        y_below: [0.0; 9],
        x: 0.44,
        y: [1.47, 1.40, 1.30, 1.23, 1.19, 1.12, 1.02, 1.00, 1.00],
    },
    steep(20.0, 0.57, 0.0, 0.43, 1.00),
    steep(25.0, 0.68, 0.0, 0.41, 0.87),
    steep(30.0, 0.80, 0.0, 0.39, 0.76),
    steep(35.0, 0.95, 0.0, 0.37, 0.66),
    steep(40.0, 1.14, 0.0, 0.35, 0.57),
    steep(45.0, 1.34, 0.0, 0.33, 0.50),
];

/// Rows back to back or face to face.
const OPPOSED: [Dynamic; 10] = [
    of_deep_groove(0.0),
    Dynamic {
        angle_deg: 5.0,
        e: [0.23, 0.26, 0.30, 0.34, 0.36, 0.40, 0.45, 0.50, 0.52],
        y_below: [2.78, 2.40, 2.07, 1.87, 1.75, 1.58, 1.39, 1.26, 1.21],
        x: 0.78,
        y: [3.74, 3.23, 2.78, 2.52, 2.36, 2.13, 1.87, 1.69, 1.63],
    },
    Dynamic {
        angle_deg: 10.0,
        e: E_10,
        y_below: [2.18, 1.98, 1.76, 1.63, 1.55, 1.42, 1.27, 1.17, 1.16],
        x: 0.75,
        y: [3.06, 2.78, 2.47, 2.29, 2.18, 2.00, 1.79, 1.64, 1.63],
    },
    Dynamic {
        angle_deg: 15.0,
        e: E_15,
        y_below: [1.65, 1.57, 1.46, 1.38, 1.34, 1.26, 1.14, 1.12, 1.12],
        x: 0.72,
        y: [2.39, 2.28, 2.11, 2.00, 1.93, 1.82, 1.66, 1.63, 1.63],
    },
    steep(20.0, 0.57, 1.09, 0.70, 1.63),
    steep(25.0, 0.68, 0.92, 0.67, 1.41),
    steep(30.0, 0.80, 0.78, 0.63, 1.24),
    steep(35.0, 0.95, 0.66, 0.60, 1.07),
    steep(40.0, 1.14, 0.55, 0.57, 0.93),
    steep(45.0, 1.34, 0.47, 0.54, 0.81),
];

/// Contact angles in degrees with Y0 of a row (ISO 76:2006, Table 3).
const STATIC: [(f64, f64); 10] = [
    (0.0, 0.50),
    (5.0, 0.52),
    (10.0, 0.50),
    (15.0, 0.46),
    (20.0, 0.42),
    (25.0, 0.38),
    (30.0, 0.33),
    (35.0, 0.29),
    (40.0, 0.26),
    (45.0, 0.22),
];
/// X0 of a row without contact angle, and with one.
const STATIC_X: [f64; 2] = [0.6, 0.5];

/// How rows share an axial load.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum RowArrangement {
    /// A row, or rows in tandem.
    Alike,
    /// Rows back to back or face to face.
    Opposed,
}

/// Factors of equivalent loads.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LoadFactors {
    /// e, ratio Fa/Fr above which the axial load counts fully.
    pub e: f64,
    /// Y up to e, where X is 1.
    pub y_below: f64,
    /// X above e.
    pub x: f64,
    /// Y above e.
    pub y: f64,
    /// X0.
    pub static_x: f64,
    /// Y0.
    pub static_y: f64,
}

impl LoadFactors {
    /// Factors at a contact angle, rad, and a relative axial load Fa/(i Z Dw²), N/mm², linear between the values of
    /// the standards and constant beyond its loads; i = 1 for opposed rows. `None` above 45°.
    pub(crate) fn new(
        contact_angle_rad: f64,
        arrangement: RowArrangement,
        relative_load_n_mm2: f64,
    ) -> Option<Self> {
        let angle_deg = contact_angle_rad.to_degrees();
        if !(angle_deg <= CONTACT_ANGLE_MAX_DEG + 1e-9) {
            return None;
        }
        let table = match arrangement {
            RowArrangement::Alike => &ALIKE,
            RowArrangement::Opposed => &OPPOSED,
        };
        let angles = table.each_ref().map(|row| row.angle_deg);
        let at_angle = |value: &dyn Fn(usize) -> f64| {
            let values: [f64; 10] = std::array::from_fn(value);
            between(&angles, &values, angle_deg)
        };
        let at = |column: fn(&Dynamic) -> &[f64; 9]| {
            at_angle(&|k| between(&RELATIVE_LOADS, column(&table[k]), relative_load_n_mm2))
        };
        // Opposed rows share the axial load by its direction: twice Y0, X0 = 1 (ISO 76). Without contact angle they
        // are alike.
        let opposed = arrangement == RowArrangement::Opposed;
        let static_at = |k: usize| match (opposed, k) {
            (true, 1..) => [1.0, 2.0 * STATIC[k].1],
            _ => [STATIC_X[usize::from(k > 0)], STATIC[k].1],
        };
        Some(Self {
            e: at(|row| &row.e),
            y_below: at(|row| &row.y_below),
            x: at_angle(&|k| table[k].x),
            y: at(|row| &row.y),
            static_x: at_angle(&|k| static_at(k)[0]),
            static_y: at_angle(&|k| static_at(k)[1]),
        })
    }

    /// P = Fr + Y Fa up to Fa/Fr = e, X Fr + Y Fa above it, at least the former's limit Fr, N (ISO 281).
    pub(crate) fn dynamic_n(&self, radial_n: f64, axial_n: f64) -> f64 {
        let [radial_n, axial_n] = [radial_n, axial_n].map(f64::abs);
        let below = radial_n + self.y_below * axial_n;
        if axial_n <= self.e * radial_n {
            return below;
        }
        // At e the rounded factors leave a step of 1 %.
        (self.x * radial_n + self.y * axial_n).max(radial_n + self.y_below * self.e * radial_n)
    }

    /// P0 = X0 Fr + Y0 Fa, at least Fr, N (ISO 76).
    pub(crate) fn static_n(&self, radial_n: f64, axial_n: f64) -> f64 {
        let [radial_n, axial_n] = [radial_n, axial_n].map(f64::abs);
        (self.static_x * radial_n + self.static_y * axial_n).max(radial_n)
    }
}

/// Loads that stand for a radial and an axial one in ratings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EquivalentLoad {
    /// P, equivalent dynamic radial load (ISO 281), N.
    pub dynamic_n: f64,
    /// P0, equivalent static radial load (ISO 76), N.
    pub static_n: f64,
}

impl EquivalentLoad {
    /// Equivalent loads of the external loads of a case; preload of rows is no part of them. `None` without load,
    /// with a moment or a tilt, and with a contact angle above 45°, of which the standards have none.
    pub(crate) fn new(case: &Case) -> Option<Self> {
        let operation = &case.operation;
        let straight = match operation.space.tilt {
            Tilt::Held { x_rad, y_rad } => x_rad == 0.0 && y_rad == 0.0,
            Tilt::Free {
                moment_x_n_m,
                moment_y_n_m,
            } => moment_x_n_m == 0.0 && moment_y_n_m == 0.0,
        };
        let [radial_n, axial_n] = [operation.radial_load_n, operation.space.axial_load_n];
        if !straight || (radial_n == 0.0 && axial_n == 0.0) {
            return None;
        }
        let arrangement = match case.rows.windows(2).any(|pair| {
            pair[0].contact_sign != pair[1].contact_sign && case.bearing.contact_angle_rad() > 0.0
        }) {
            true => RowArrangement::Opposed,
            false => RowArrangement::Alike,
        };
        let rows = match arrangement {
            RowArrangement::Alike => case.rows.len().max(1),
            RowArrangement::Opposed => 1,
        };
        let relative = axial_n.abs() / (rows as f64 * capacity_mm2(&case.bearing));
        let angle_rad = case.bearing.contact_angle_rad();
        let factors = LoadFactors::new(angle_rad, arrangement, relative)?;
        Some(Self {
            dynamic_n: factors.dynamic_n(radial_n, axial_n),
            static_n: factors.static_n(radial_n, axial_n),
        })
    }
}

/// Z Dw², mm².
fn capacity_mm2(bearing: &Bearing) -> f64 {
    bearing.balls() as f64 * (2e3 * bearing.ball_radius_m()).powi(2)
}

/// Linear interpolation over ascending places, constant beyond them.
fn between(places: &[f64], values: &[f64], at: f64) -> f64 {
    let k = places.partition_point(|place| *place <= at);
    if k == 0 || k == places.len() {
        return values[k.saturating_sub(1)];
    }
    let share = (at - places[k - 1]) / (places[k] - places[k - 1]);
    values[k - 1] + share * (values[k] - values[k - 1])
}
