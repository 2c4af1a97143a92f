//! Measured points of μ over the sliding speed.

use crate::error::InputError;
use crate::numerics::lanes::lane_struct;

/// Largest number of points of a table.
pub(crate) const POINTS_MAX: usize = 30;
/// A constant piece before the first point and behind the last one.
pub(super) const PIECES_MAX: usize = POINTS_MAX + 1;
/// Largest μ, as of the other laws.
const COEFFICIENT_MAX: f64 = 2.0;

/// μ over |ΔV|: a cubic between neighbouring points that rises or falls as they do
/// (Fritsch & Butland 1984, SIAM J. Sci. Stat. Comput. 5, 300–304), constant before the first
/// point and behind the last one. The slope has no jumps.
#[derive(Debug, Clone, PartialEq)]
pub struct FrictionTable {
    /// |ΔV|, m/s, and μ.
    points: Vec<[f64; 2]>,
}

lane_struct! {
    /// μ = c0 + c1·t + c2·t² + c3·t³ with t = |ΔV| − start.
    pub(crate) struct Piece per lane PieceLanes {
        start, c0, c1, c2, c3,
    }
}

impl Piece {
    /// A piece that is never reached.
    pub(super) const BEYOND: Self = Self {
        start: f64::INFINITY,
        c0: 0.0,
        c1: 0.0,
        c2: 0.0,
        c3: 0.0,
    };

    fn constant(start: f64, c0: f64) -> Self {
        Self {
            start,
            c0,
            ..Self::default()
        }
    }

    /// μ and dμ/d|ΔV|.
    #[inline(always)]
    pub(super) fn coefficient(&self, speed: f64) -> [f64; 2] {
        let t = speed - self.start;
        [
            self.c0 + t * (self.c1 + t * (self.c2 + t * self.c3)),
            self.c1 + t * (2.0 * self.c2 + t * 3.0 * self.c3),
        ]
    }
}

impl FrictionTable {
    /// Table of rows |ΔV| in m/s and μ.
    ///
    /// # Errors
    /// An [`InputError`] of `friction_table` if there are less than 2 points or more than
    /// `POINTS_MAX`, speeds are negative or do not increase, or a μ is not between 0 and 2.
    pub fn new(points: Vec<[f64; 2]>) -> Result<Self, InputError> {
        let refuse = |value: f64, rule: &str| Err(InputError::rule("friction_table", value, rule));
        if !(2..=POINTS_MAX).contains(&points.len()) {
            let rule = format!("2 to {POINTS_MAX} rows of sliding speed and μ");
            return refuse(points.len() as f64, &rule);
        }
        let mut last = f64::NEG_INFINITY;
        for [speed, coefficient] in &points {
            if !(speed.is_finite() && *speed >= 0.0 && *speed > last) {
                return refuse(*speed, "sliding speeds that increase from 0 m/s or later");
            }
            if !(0.0..=COEFFICIENT_MAX).contains(coefficient) {
                return refuse(
                    *coefficient,
                    "μ from 0 to 2 in each row; it is no percentage",
                );
            }
            last = *speed;
        }
        Ok(Self { points })
    }

    /// Rows of |ΔV| in m/s and μ.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Largest μ.
    pub(crate) fn coefficient_max(&self) -> f64 {
        self.points.iter().fold(0.0, |most, [_, mu]| mu.max(most))
    }

    /// Largest fall of μ over the sliding speed, s/m; 0 if it rises everywhere.
    pub(crate) fn steepest_fall(&self) -> f64 {
        let pieces = self.pieces();
        let slope = |speed: f64| {
            let piece = pieces.iter().rfind(|p| speed >= p.start);
            piece.map_or(0.0, |p| p.coefficient(speed)[1])
        };
        // The slope is a parabola between two points.
        let speeds = self.points.windows(2).flat_map(|pair| {
            let [from, to] = [pair[0][0], pair[1][0]];
            (0..=8).map(move |k| from + (to - from) * f64::from(k) / 8.0)
        });
        speeds.fold(0.0, |most, speed| most.max(-slope(speed)))
    }

    /// μ of fast sliding: that of the last row.
    pub(crate) fn coefficient_fast(&self) -> f64 {
        self.points[self.points.len() - 1][1]
    }

    /// The table with every μ times `factor`.
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let points = self.points.iter().map(|[v, mu]| [*v, mu * factor]);
        Self {
            points: points.collect(),
        }
    }

    /// μ at a sliding speed, m/s, and its slope, s/m.
    pub(crate) fn coefficient(&self, speed_m_s: f64) -> [f64; 2] {
        let pieces = self.pieces();
        let piece = pieces.iter().rfind(|p| speed_m_s >= p.start);
        piece.unwrap_or(&pieces[0]).coefficient(speed_m_s)
    }

    /// The cubics between the points. The slope at a point is the harmonic mean of those of the
    /// chords beside it, weighted with their lengths, or 0 at a peak and at both ends.
    pub(super) fn pieces(&self) -> [Piece; PIECES_MAX] {
        let chord = |k: usize| {
            let [[v0, mu0], [v1, mu1]] = [self.points[k], self.points[k + 1]];
            [v1 - v0, (mu1 - mu0) / (v1 - v0)]
        };
        let chords = self.points.len() - 1;
        let slope = |k: usize| {
            if k == 0 || k == chords {
                return 0.0;
            }
            let ([h0, s0], [h1, s1]) = (chord(k - 1), chord(k));
            if s0 * s1 <= 0.0 {
                return 0.0;
            }
            let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
            (w0 + w1) / (w0 / s0 + w1 / s1)
        };
        let mut pieces = [Piece::BEYOND; PIECES_MAX];
        let [first, last] = [self.points[0], self.points[chords]];
        pieces[0] = Piece::constant(0.0, first[1]);
        for k in 0..chords {
            let ([h, s], c1, end) = (chord(k), slope(k), slope(k + 1));
            pieces[k + 1] = Piece {
                start: self.points[k][0],
                c0: self.points[k][1],
                c1,
                c2: (3.0 * s - 2.0 * c1 - end) / h,
                c3: (c1 + end - 2.0 * s) / (h * h),
            };
        }
        pieces[chords + 1] = Piece::constant(last[0], last[1]);
        pieces
    }
}
