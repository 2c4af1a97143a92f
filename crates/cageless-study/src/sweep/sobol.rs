//! Sobol's sequence by index. The crates that have it (`sobol`, `sobol-qmc`,
//! `sobol_burley`) step through it from the start, or end at 2^16 points in single
//! precision; a variant must be had from its index alone.

use super::random::Purpose;

/// Degree s, coefficients a and initial numbers m of dimensions 2 to 24: Joe and Kuo,
/// "Constructing Sobol sequences with better two-dimensional projections", SIAM J. Sci.
/// Comput. 30 (2008) 2635, table new-joe-kuo-6.
#[rustfmt::skip]
const DIRECTIONS: [(u32, u32, &[u32]); 23] = [
    (1, 0, &[1]),
    (2, 1, &[1, 3]),
    (3, 1, &[1, 3, 1]),
    (3, 2, &[1, 1, 1]),
    (4, 1, &[1, 1, 3, 3]),
    (4, 4, &[1, 3, 5, 13]),
    (5, 2, &[1, 1, 5, 5, 17]),
    (5, 4, &[1, 1, 5, 5, 5]),
    (5, 7, &[1, 1, 7, 11, 19]),
    (5, 11, &[1, 1, 5, 1, 1]),
    (5, 13, &[1, 1, 1, 3, 11]),
    (5, 14, &[1, 3, 5, 5, 31]),
    (6, 1, &[1, 3, 3, 9, 7, 49]),
    (6, 13, &[1, 1, 1, 15, 21, 21]),
    (6, 16, &[1, 3, 1, 13, 27, 49]),
    (6, 19, &[1, 1, 1, 15, 7, 5]),
    (6, 22, &[1, 3, 1, 15, 13, 25]),
    (6, 25, &[1, 1, 5, 5, 19, 61]),
    (7, 1, &[1, 3, 7, 11, 23, 15, 103]),
    (7, 4, &[1, 3, 7, 13, 13, 15, 69]),
    (7, 7, &[1, 1, 3, 13, 7, 35, 63]),
    (7, 8, &[1, 3, 5, 9, 1, 25, 53]),
    (7, 14, &[1, 3, 1, 13, 9, 35, 107]),
];

/// Dimensions that there are numbers for.
pub(crate) const DIMENSIONS: usize = DIRECTIONS.len() + 1;
/// Points that the sequence has.
pub(crate) const POINTS: u64 = 1 << BITS;

const BITS: usize = 32;

/// Sobol's sequence, every dimension shifted by random bits: its properties as a net
/// stay, no point lies on an end of an axis.
#[derive(Debug, Clone)]
pub(crate) struct Sobol {
    directions: Vec<[u32; BITS]>,
    shifts: Vec<u32>,
}

impl Sobol {
    /// At most [`DIMENSIONS`].
    pub(crate) fn new(dimensions: usize, seed: u64) -> Self {
        let shift = |k| (Purpose::Shift.stream(seed, k, 0).bits() >> 32) as u32;
        Self {
            directions: (0..dimensions).map(directions).collect(),
            shifts: (0..dimensions).map(shift).collect(),
        }
    }

    /// Place of point `index` on an axis, in (0, 1).
    pub(crate) fn at(&self, index: u64, dimension: usize) -> f64 {
        let shifted = self.bits(index, dimension) ^ self.shifts[dimension];
        // The middle of its cell.
        (f64::from(shifted) + 0.5) * 2f64.powi(-(BITS as i32))
    }

    /// In the order of the Gray code, as all implementations have it.
    fn bits(&self, index: u64, dimension: usize) -> u32 {
        let gray = index ^ (index >> 1);
        let directions = &self.directions[dimension];
        let used = (0..BITS).filter(|k| gray >> k & 1 == 1);
        used.fold(0, |bits, k| bits ^ directions[k])
    }
}

/// Direction numbers v_k = m_k/2^k as fractions of 2^32, by Bratley and Fox's recurrence.
fn directions(dimension: usize) -> [u32; BITS] {
    let mut v = [0; BITS];
    let Some(&(degree, a, m)) = dimension.checked_sub(1).and_then(|k| DIRECTIONS.get(k)) else {
        // The first dimension is van der Corput's sequence.
        (0..BITS).for_each(|k| v[k] = 1 << (BITS - 1 - k));
        return v;
    };
    let s = degree as usize;
    for k in 0..BITS {
        v[k] = if k < s {
            m[k] << (BITS - 1 - k)
        } else {
            let first = v[k - s] ^ (v[k - s] >> s);
            let terms = (1..s).filter(|i| a >> (s - 1 - i) & 1 == 1);
            terms.fold(first, |sum, i| sum ^ v[k - i])
        };
    }
    v
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(index: u64, dimension: usize) -> f64 {
        f64::from(Sobol::new(DIMENSIONS, 0).bits(index, dimension)) / 2f64.powi(32)
    }

    /// From `scipy.stats.qmc.Sobol(21, scramble=False)`.
    #[test]
    fn points_are_those_of_scipy() {
        let expected: [(u64, [f64; 21]); 2] = [
            (
                17,
                [
                    0.59375, 0.96875, 0.96875, 0.15625, 0.78125, 0.46875, 0.03125, 0.34375,
                    0.96875, 0.65625, 0.59375, 0.90625, 0.15625, 0.15625, 0.84375, 0.53125,
                    0.28125, 0.09375, 0.28125, 0.53125, 0.21875,
                ],
            ),
            (
                63,
                [
                    0.015625, 0.796875, 0.359375, 0.453125, 0.859375, 0.140625, 0.578125, 0.140625,
                    0.828125, 0.578125, 0.421875, 0.671875, 0.546875, 0.765625, 0.328125, 0.765625,
                    0.078125, 0.390625, 0.953125, 0.234375, 0.234375,
                ],
            ),
        ];
        for (index, point) in expected {
            for (dimension, value) in point.into_iter().enumerate() {
                assert_eq!(plain(index, dimension), value, "{index} {dimension}");
            }
        }
    }

    /// 2^k points: one in each of 2^k slices of every axis, and of the first two axes one
    /// in each box of any 2^i × 2^(k−i) boxes; shifted ones as well.
    #[test]
    fn a_power_of_two_of_points_fills_every_slice_once() {
        let sobol = Sobol::new(DIMENSIONS, 11);
        let k = 8;
        let count = 1 << k;
        for dimension in 0..DIMENSIONS {
            let mut seen = vec![false; count];
            for index in 0..count as u64 {
                let slice = (sobol.at(index, dimension) * count as f64) as usize;
                assert!(!std::mem::replace(&mut seen[slice], true));
            }
        }
        for i in 0..=k {
            let (across, up) = (1 << i, 1 << (k - i));
            let mut seen = vec![false; count];
            for index in 0..count as u64 {
                let x = (sobol.at(index, 0) * f64::from(across)) as usize;
                let y = (sobol.at(index, 1) * f64::from(up)) as usize;
                assert!(!std::mem::replace(&mut seen[x * up as usize + y], true));
            }
        }
    }
}
