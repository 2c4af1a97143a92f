//! Creep of a steadily rolling contact, from Kalker's linear theory.
//!
//! Well below the limit of friction a rolling contact creeps at ΔV = F V/(G ab C11), V the rolling speed, G the shear
//! modulus, a and b the semi-axes of Hertz's ellipse. The smooth law has this slope with the regularisation speed
//!
//!   v_s = μ N V/(G ab C11) = μ N^(1/3) V/(G ca cb C11),   a = ca N^(1/3),   b = cb N^(1/3).
//!
//! Source of C11: J. J. Kalker, *On the rolling contact of two elastic bodies in the presence of dry friction*,
//! thesis, Delft 1967, as many tables of it have.

use std::f64::consts::PI;

use crate::material::Material;
use crate::numerics::inverse_root::inverse_cube_root;
use crate::numerics::lanes::lane_struct;

/// C11 at ν = 0, ¼ and ½ for a/b = 0.1 to 1, then b/a = 0.9 to 0.1; a along rolling.
const C11: [[f64; 3]; 19] = [
    [2.51, 3.31, 4.85],
    [2.59, 3.37, 4.81],
    [2.68, 3.44, 4.80],
    [2.78, 3.53, 4.82],
    [2.88, 3.62, 4.83],
    [2.98, 3.72, 4.91],
    [3.09, 3.81, 4.97],
    [3.19, 3.91, 5.05],
    [3.29, 4.01, 5.12],
    [3.40, 4.12, 5.20],
    [3.51, 4.22, 5.30],
    [3.65, 4.36, 5.42],
    [3.82, 4.54, 5.58],
    [4.06, 4.78, 5.80],
    [4.37, 5.10, 6.11],
    [4.84, 5.57, 6.57],
    [5.57, 6.34, 7.34],
    [6.96, 7.78, 8.82],
    [10.7, 11.7, 12.9],
];
/// Least a/b of the table, and its step.
const STEP: f64 = 0.1;
/// u₀², m²/s²: V = √(u² + u₀²) leaves a knee at standstill.
pub(crate) const LEAST_SPEED_SQUARE: f64 = 1e-6;

/// C11 of an ellipse whose semi-axis along rolling is `axis_ratio` times that across, of bodies with Poisson's ratio
/// ν: linear in the smaller ratio of the axes, quadratic in ν. From a/b = 0.1 down it goes to that of a line,
/// π²/(4(1 − ν)); from b/a = 0.1 down it grows with a/b.
pub(crate) fn creep_coefficient(axis_ratio: f64, poisson_ratio: f64) -> f64 {
    let row = |k: usize| {
        let [none, quarter, half] = C11[k];
        let t = 4.0 * poisson_ratio;
        none * (t - 1.0) * (t - 2.0) / 2.0 - quarter * t * (t - 2.0) + half * t * (t - 1.0) / 2.0
    };
    let last = C11.len() - 1;
    if axis_ratio < STEP {
        let line = PI * PI / (4.0 * (1.0 - poisson_ratio));
        return line + (row(0) - line) * axis_ratio / STEP;
    }
    if axis_ratio * STEP > 1.0 {
        return row(last) * axis_ratio * STEP;
    }
    let place = match axis_ratio <= 1.0 {
        true => axis_ratio / STEP - 1.0,
        false => last as f64 + 1.0 - 1.0 / (axis_ratio * STEP),
    };
    let k = (place as usize).min(last - 1);
    let (from, to) = (row(k), row(k + 1));
    from + (to - from) * (place - k as f64)
}

/// G ca cb C11 of a contact of two bodies with these semi-axes along rolling and across under 1 N, N^(1/3): the slope of
/// friction over ΔV is this N^(2/3)/V. Of unequal materials 1/G and ν/G are means.
pub(crate) fn creep_stiffness_n1_3([along, across]: [f64; 2], materials: [&Material; 2]) -> f64 {
    let compliances = materials.map(|m| 2.0 * (1.0 + m.poisson_ratio) / m.youngs_modulus_pa);
    let compliance = 0.5 * (compliances[0] + compliances[1]);
    let contraction = [0, 1]
        .map(|k| materials[k].poisson_ratio * compliances[k])
        .iter()
        .sum::<f64>()
        * 0.5;
    along * across * creep_coefficient(along / across, contraction / compliance) / compliance
}

lane_struct! {
    /// Creep of the contacts of a ball with the raceways, N^(1/3): G ca cb C11 over the coefficient of
    /// friction at rest.
    pub(crate) struct Creep per lane CreepLanes {
        /// At the outer raceway.
        outer,
        /// At the inner raceway.
        inner,
    }
}

/// 1/v_s, s/m, of a contact of this [`Creep`] under a load where `scale` times u is `scaled_m_s`; a finite number
/// without load.
///
/// With z = V², N^(−1/3)/V = (N² z³)^(−1/6) takes no division.
#[inline(always)]
pub(crate) fn inverse_speed_s_m(creep_n1_3: f64, load_n: f64, scaled_m_s: f64, scale: f64) -> f64 {
    let square = scaled_m_s * scaled_m_s + LEAST_SPEED_SQUARE * (scale * scale);
    let sixth = (load_n * load_n) * (square * square * square);
    (creep_n1_3 * scale) * inverse_cube_root(sixth).sqrt()
}

/// V = √(u² + u₀²), m/s, u₀ = 1 mm/s.
#[inline(always)]
pub(crate) fn rolling_speed_m_s(mean_m_s: f64) -> f64 {
    (mean_m_s * mean_m_s + LEAST_SPEED_SQUARE).sqrt()
}
